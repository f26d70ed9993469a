//! The stress in a section across strips: half spaces, and the rest that changes evenly.

use super::reading::BelowStrips;
use super::strips::{RING, Strip, Strips};
use crate::analytic::subsurface::LineField;
use crate::answer::results::tensor::{mises, tensor_of, traction};
use crate::ground::geometry::{Vec3, cross, dot, scale, sub};
use nalgebra::{Matrix3, RowVector6, Vector3};

/// What tractions that turn round in the middle of a strip add to the stress across it there, over their mean size. Of μp on both
/// sides it is 4/π μ p0 (ln(4 a/h) − 1) at a node, h beside the middle (by Flamant's solution); of half-widths of 3 nodes, and
/// 1.2 for what the mean is less than those beside the middle.
const ACROSS: f64 = 4.0;

/// How far above the tangent of the surface nodes may be, in half-widths: it curves.
const ABOVE: f64 = 0.05;

/// Nodes in a section that it takes to know it.
const FEWEST: usize = 5;

/// A place of a section, across and down in half-widths of its strip, and the stress xx yy zz xy yz zx there.
type Sample = ([f64; 2], [f64; 6]);

impl Strips<'_> {
    /// In the section at `along`, by the stress at points of the body there, the force of the row on it, and where
    /// [friction turns](Self::turns).
    pub fn read(
        &self,
        along: f64,
        nu: f64,
        points: &[(Vec3, [f64; 6])],
        (force, turns): (Vec3, [f64; 2]),
    ) -> Option<BelowStrips> {
        let own = self.places.first()?;
        let at = self.line.frame.moved(own.centre, along);
        let depths = points.iter().map(|(p, _)| dot(own.normal, sub(*p, at)));
        let inwards = depths.sum::<f64>().signum();
        let down = scale(own.normal, inwards);
        let frame = SectionFrame {
            at,
            axes: [
                cross(self.line.frame.along, down),
                self.line.frame.along,
                down,
            ],
        };
        let pressed = |strip: &Strip| self.pressed(strip, along, nu, (&frame, inwards));
        let alone = pressed(own)?;
        let mut all: Vec<Pressed> = self.places.iter().filter_map(pressed).collect();
        all.first_mut()?
            .rub(frame.turned(force), own.loads.heaviest.mirrored)?;
        let by_strips = |x: f64, z: f64| {
            let stresses = all.iter().map(|strip| strip.stress(x, z));
            stresses.fold([0.0; 6], |sum, one| sum_of(&sum, &one))
        };
        let a = alone.half_width;
        let mut samples: Vec<Sample> = Vec::new();
        for (place, stress) in points {
            let [x, z] = frame.place(*place);
            let is_in_ring = (RING[0]..=RING[1]).contains(&(x.hypot(z) / a));
            if !is_in_ring || z < -ABOVE * a {
                continue;
            }
            let (seen, strips) = (frame.stress(stress), by_strips(x, z));
            let rest: [f64; 6] = std::array::from_fn(|k| seen[k] - strips[k]);
            samples.push(([x / a, z / a], rest));
            if own.loads.heaviest.mirrored {
                let [xx, yy, zz, xy, yz, zx] = rest;
                samples.push(([-x / a, z / a], [xx, yy, zz, -xy, yz, -zx]));
            }
        }
        let rest = Even::through(&samples)?;
        let sum = |x: f64, z: f64| sum_of(&by_strips(x * a, z * a), &rest.at(x, z));
        let most = largest(|x, z| mises(&sum(x, z)));
        let turned = turned(
            &sum(0.0, 0.0),
            turns.map(|turn| turn * self.peak_pressure),
            nu,
        );
        Some(BelowStrips {
            pair: self.pair,
            mises: most,
            uneven: rest.leaves(&samples),
            by_rest: most - largest(|x, z| mises(&alone.stress(x * a, z * a))),
            by_turn: (mises(&turned) - most).max(0.0),
            at,
            at_edge: self.at_edge,
        })
    }

    /// A strip under its load in the section at `along`; `None` where it carries none there.
    fn pressed(
        &self,
        strip: &Strip,
        along: f64,
        nu: f64,
        (frame, inwards): (&SectionFrame, f64),
    ) -> Option<Pressed> {
        let load = strip.loads.load_at(along).filter(|load| *load > 0.0)?;
        let root = (load / self.line.line_load).sqrt();
        let half_width = root * self.half_width;
        let [x, _, z] = frame.turned(scale(strip.normal, inwards));
        Some(Pressed {
            centre: frame.place(self.line.frame.moved(strip.centre, along)),
            down: [x, z],
            field: LineField::new(half_width, root * self.peak_pressure, nu).ok()?,
            half_width,
            across: 0.0,
        })
    }
}

/// The largest of `values` at places across and down within a half-width of the middle of a strip, in half-widths.
fn largest(values: impl Fn(f64, f64) -> f64) -> f64 {
    let across = || (-20..=20).map(|i| 0.05 * f64::from(i));
    let down = (0..=32).map(|k| 0.05 * f64::from(k));
    let all = down.flat_map(|z| across().map(move |x| [x, z]));
    all.map(|[x, z]| values(x, z)).fold(0.0, f64::max)
}

/// The stress at the surface in the middle of a strip with what tractions add that turn there, along and across.
fn turned(stress: &[f64; 6], [along, across]: [f64; 2], nu: f64) -> [f64; 6] {
    let across = ACROSS * across;
    sum_of(
        stress,
        &[across + nu * along, along + nu * across, 0.0, 0.0, 0.0, 0.0],
    )
}

/// A place on a strip, and the directions across it, along it and down.
struct SectionFrame {
    at: Vec3,
    axes: [Vec3; 3],
}

impl SectionFrame {
    /// How far across and down a place is.
    fn place(&self, place: Vec3) -> [f64; 2] {
        let [x, _, z] = self.turned(sub(place, self.at));
        [x, z]
    }

    fn turned(&self, v: Vec3) -> Vec3 {
        self.axes.map(|axis| dot(axis, v))
    }

    fn stress(&self, stress: &[f64; 6]) -> [f64; 6] {
        tensor_of(|i, j| dot(self.axes[i], traction(stress, self.axes[j])))
    }
}

/// A strip in a section: where it is, which way is down there, and the stress below it, with its traction across over its
/// pressure.
struct Pressed {
    centre: [f64; 2],
    down: [f64; 2],
    field: LineField,
    half_width: f64,
    across: f64,
}

impl Pressed {
    /// With the tractions of its row, whose force is `force` across, along and down; of a strip that is cut what both halves do across
    /// it cancels.
    fn rub(&mut self, [across, along, press]: Vec3, is_cut: bool) -> Option<()> {
        if press > 0.0 {
            self.field = self.field.sheared_along(along / press).ok()?;
            self.across = if is_cut { 0.0 } else { across / press };
        }
        Some(())
    }

    /// Stress xx yy zz xy yz zx at the place x, z of the section; none above its surface.
    fn stress(&self, x: f64, z: f64) -> [f64; 6] {
        let [nx, nz] = self.down;
        let (dx, dz) = (x - self.centre[0], z - self.centre[1]);
        let (x, z) = (dx * nz - dz * nx, (dx * nx + dz * nz).max(0.0));
        // What slides towards −x is the image of what slides towards +x.
        let sign = 1f64.copysign(self.across);
        let field = self.field.sliding(self.across.abs());
        let Ok(s) = field.and_then(|field| field.stress(sign * x, z)) else {
            return [0.0; 6];
        };
        let (zx, xy) = (sign * s.zx, sign * s.xy);
        // Its axes are (nz, −nx) and (nx, nz).
        [
            nz * nz * s.xx + nx * nx * s.zz + 2.0 * nx * nz * zx,
            s.yy,
            nx * nx * s.xx + nz * nz * s.zz - 2.0 * nx * nz * zx,
            nz * xy + nx * s.yz,
            nz * s.yz - nx * xy,
            nx * nz * (s.zz - s.xx) + (nz * nz - nx * nx) * zx,
        ]
    }
}

/// A stress that changes evenly over a section.
struct Even([[f64; 6]; 3]);

impl Even {
    /// The one with the least squares of what it leaves of those at some places; `None` where these are too few.
    fn through(samples: &[Sample]) -> Option<Self> {
        if samples.len() < FEWEST {
            return None;
        }
        let mut matrix = Matrix3::zeros();
        let mut sides = [RowVector6::zeros(); 3];
        for ([x, z], stress) in samples {
            let row = Vector3::new(1.0, *x, *z);
            matrix += row * row.transpose();
            for (side, weight) in sides.iter_mut().zip(row.iter()) {
                *side += *weight * RowVector6::from_column_slice(stress);
            }
        }
        let inverse = matrix.try_inverse()?;
        let coefficient = |i: usize| -> [f64; 6] {
            ((0..3).map(|j| inverse[(i, j)] * sides[j]))
                .sum::<RowVector6<f64>>()
                .into()
        };
        Some(Self([0, 1, 2].map(coefficient)))
    }

    /// The root mean square of the Mises stress that it leaves of them.
    fn leaves(&self, samples: &[Sample]) -> f64 {
        let left = samples.iter().map(|([x, z], seen)| {
            let even = self.at(*x, *z);
            mises(&std::array::from_fn(|k| seen[k] - even[k])).powi(2)
        });
        (left.sum::<f64>() / samples.len() as f64).sqrt()
    }

    fn at(&self, x: f64, z: f64) -> [f64; 6] {
        let Self([own, across, down]) = self;
        std::array::from_fn(|k| own[k] + x * across[k] + z * down[k])
    }
}

fn sum_of(a: &[f64; 6], b: &[f64; 6]) -> [f64; 6] {
    std::array::from_fn(|k| a[k] + b[k])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What changes evenly is found whole, whatever the places.
    #[test]
    fn an_even_stress_is_fitted_exactly() {
        let even = Even([[1.0, -2.0, 3.0, 0.5, 0.0, 4.0], [0.3; 6], [-0.7; 6]]);
        let places = [[2.0, 0.1], [-2.5, 1.0], [0.3, 3.0], [1.5, 2.0], [-1.0, 2.2]];
        let samples = places.map(|[x, z]| ([x, z], even.at(x, z)));
        let found = Even::through(&samples).unwrap();
        assert!(found.leaves(&samples) < 1e-12);
        let missed = sum_of(&found.at(0.0, 0.7), &even.at(0.0, 0.7).map(|s| -s));
        assert!(mises(&missed) < 1e-12);
        assert!(Even::through(&samples[..4]).is_none());
    }

    /// A strip on a slope is the level one, turned: Mises stresses are the same at the same places of each.
    #[test]
    fn a_strip_on_a_slope_is_a_level_one_turned() {
        let field = LineField::new(1.0, 100.0, 0.3).unwrap();
        let strip = |angle: f64, across: f64| Pressed {
            centre: [0.0; 2],
            down: [angle.sin(), angle.cos()],
            field: field.sheared_along(0.1).unwrap(),
            half_width: 1.0,
            across,
        };
        let (sin, cos) = 0.3f64.sin_cos();
        for across in [0.0, 0.2, -0.2] {
            let (level, slope) = (strip(0.0, across), strip(0.3, across));
            for [x, z] in [[0.4, 0.6], [-1.2, 0.3], [2.0, 1.0]] {
                let turned = slope.stress(x * cos + z * sin, z * cos - x * sin);
                let off = mises(&turned) - mises(&level.stress(x, z));
                assert!(off.abs() < 1e-10, "{across} {x} {z}: {off}");
            }
        }
        let image = strip(0.0, -0.2).stress(-0.4, 0.6);
        assert!((image[5] + strip(0.0, 0.2).stress(0.4, 0.6)[5]).abs() < 1e-12);
    }
}
