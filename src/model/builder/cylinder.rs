//! A roller on or under a plane, its elements small where it touches.

use super::error::BuildError;
use super::shape::Shape;
use crate::model::mesh::Mesh;
use crate::model::mesh::block::{Block, uniform};
use crate::model::mesh::family::disc::{ARC, QuarterDisc, TO_CORE};
use crate::model::mesh::family::grading::Grading;
use std::f64::consts::{FRAC_PI_2, PI};

/// Which part of the section is meshed. The load comes from the cut at half height, or on a whole section from above.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum CylinderPart {
    /// x ≥ 0, the lower half.
    Quarter,
    /// The lower half.
    Half,
    /// All of it.
    Whole,
}

/// A solid or hollow cylinder along z that touches the plane y = 0 at x = 0 from above: its axis is at y = R, its
/// ends at z = 0 and z = `length`.
///
/// Elements at the contact have the size given with [`fine`](Self::fine), and grow with the distance from it. The body
/// is called `name`, its surfaces
///
/// | surface | where |
/// |---|---|
/// | `<name>_contact` | the lower rim, up to 45 degrees from the contact |
/// | `<name>_top` | the cut at y = R, or the upper rim of a whole cylinder, as far as `contact` below |
/// | `<name>_bore` | the inner wall, where hollow |
/// | `<name>_back`, `<name>_front` | the ends at z = 0 and z = `length` |
///
/// ```
/// use brinell::prelude::*;
/// let roller = Cylinder::half("roller", 38.1, 1.0).bore(19.05).fine(0.1, 1.0).mesh()?;
/// assert!(roller.surface("roller_bore").is_some());
/// # Ok::<(), BuildError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Cylinder {
    name: String,
    part: CylinderPart,
    radius: f64,
    bore: Option<f64>,
    length: f64,
    layers: usize,
    size: f64,
    reach: f64,
    growth: f64,
    below: bool,
}

impl Cylinder {
    fn new(name: &str, part: CylinderPart, radius: f64, length: f64) -> Self {
        Self {
            name: name.into(),
            part,
            radius,
            bore: None,
            length,
            layers: 1,
            size: radius / 50.0,
            reach: radius / 10.0,
            growth: 1.3,
            below: false,
        }
    }

    /// x ≥ 0, y ≤ `radius`: for models that are mirrored along x.
    pub fn quarter(name: &str, radius: f64, length: f64) -> Self {
        Self::new(name, CylinderPart::Quarter, radius, length)
    }

    /// y ≤ `radius`.
    pub fn half(name: &str, radius: f64, length: f64) -> Self {
        Self::new(name, CylinderPart::Half, radius, length)
    }

    /// All of it, its elements small at the highest and at the lowest line.
    pub fn whole(name: &str, radius: f64, length: f64) -> Self {
        Self::new(name, CylinderPart::Whole, radius, length)
    }

    /// Hollow, with this inner radius.
    pub fn bore(mut self, radius: f64) -> Self {
        self.bore = Some(radius);
        self
    }

    /// Elements of length `size` across and below the contact, up to the distance `reach` from it. By default a
    /// fiftieth of the radius up to a tenth of it.
    pub fn fine(mut self, size: f64, reach: f64) -> Self {
        (self.size, self.reach) = (size, reach);
        self
    }

    /// Beyond, every element is about so many times as long as the one before: 1.3 by default.
    pub fn growth(mut self, growth: f64) -> Self {
        self.growth = growth;
        self
    }

    /// Elements along the axis: one by default, for plane strain.
    pub fn layers(mut self, layers: usize) -> Self {
        self.layers = layers;
        self
    }

    /// Touches y = 0 from below: the mirror image along y, with the same names.
    pub fn below(mut self) -> Self {
        self.below = true;
        self
    }

    fn check(&self) -> Result<(), BuildError> {
        let wrong = |what, value, allowed| BuildError::Number {
            what,
            of: self.name.clone(),
            value,
            allowed,
        };
        let (r, bore) = (self.radius, self.bore);
        let positive = [
            ("the radius", r),
            ("the length", self.length),
            ("the element size", self.size),
            ("the reach of small elements", self.reach),
        ];
        for (what, value) in positive {
            if !(value > 0.0 && value.is_finite()) {
                return Err(wrong(what, value, "positive"));
            }
        }
        if let Some(bore) = bore.filter(|bore| !(*bore > 0.0 && *bore < r)) {
            return Err(wrong("the bore", bore, "positive and less than the radius"));
        }
        if !(self.growth > 1.0 && self.growth <= 3.0) {
            return Err(wrong(
                "the growth",
                self.growth,
                "more than 1 and at most 3",
            ));
        }
        let depth = bore.map_or(TO_CORE * r, |bore| r - bore);
        if !(self.reach < depth.min(ARC * r)) {
            return Err(wrong(
                "the reach of small elements",
                self.reach,
                "less than the wall and half the radius",
            ));
        }
        let cells = self.reach / self.size;
        match (1.0..=Grading::MOST_CELLS as f64).contains(&cells) && self.layers > 0 {
            true => Ok(()),
            false => Err(wrong(
                "the element size",
                self.size,
                "at most the reach of small elements and at least a 10000th of it, with a layer or more",
            )),
        }
    }

    fn graded(&self, total: f64) -> Vec<f64> {
        Grading::new(self.size, self.reach, total, self.growth).nodes(1)
    }

    /// The quarter x ≥ 0, y ≤ R, without surfaces.
    fn section(&self) -> Result<Mesh, BuildError> {
        let (r, layers) = (self.radius, uniform(0.0, self.length, self.layers));
        let Some(bore) = self.bore else {
            let arcs = self.graded(ARC * r);
            let rest = (arcs.len() / 2).max(5);
            let disc = QuarterDisc {
                radius: r,
                arcs,
                depths: self.graded(TO_CORE * r),
                rest,
                layers,
            };
            return Ok(disc.build(&self.name)?);
        };
        let lower = self.graded(ARC * r);
        // Beside the graded arc as many elements as fit of the length of its last.
        let last = lower.windows(2).last().map_or(r, |w| w[1] - w[0]);
        let rest = ((FRAC_PI_2 - ARC) * r / last).ceil().max(1.0) as usize;
        let upper = uniform(ARC * r, FRAC_PI_2 * r, rest);
        let arcs: Vec<f64> = lower.into_iter().chain(upper.into_iter().skip(1)).collect();
        let wall = Block::new(&self.name, arcs, self.graded(r - bore), layers);
        let mut mesh = wall
            .mapped(|[arc, depth, z]| {
                let (sin, cos) = (arc / r).sin_cos();
                let x = (r - depth) * sin;
                let exact = |c: f64| if c.abs() < 1e-12 * r { 0.0 } else { c };
                [exact(x), r - exact((r - depth) * cos), z]
            })
            .build()?;
        mesh.surfaces.clear();
        Ok(mesh)
    }

    fn mark(&self, mesh: &mut Mesh) {
        let (r, near, name) = (self.radius, 1e-9 * self.radius, self.name.as_str());
        let called = |surface: &str| format!("{name}_{surface}");
        let radius = |p: [f64; 3]| p[0].hypot(p[1] - r);
        let on_rim = |p: [f64; 3]| (radius(p) - r).abs() < near;
        // The angle from the lowest line.
        let angle = |p: [f64; 3]| p[0].abs().atan2(r - p[1]);
        let arc = ARC * (1.0 + 1e-9);
        mesh.mark(&called("contact"), name, |p| on_rim(p) && angle(p) < arc);
        match self.part {
            CylinderPart::Whole => {
                mesh.mark(&called("top"), name, |p| on_rim(p) && PI - angle(p) < arc)
            }
            _ => mesh.mark(&called("top"), name, |p| (p[1] - r).abs() < near),
        }
        if let Some(bore) = self.bore {
            mesh.mark(&called("bore"), name, |p| (radius(p) - bore).abs() < near);
        }
        mesh.mark(&called("back"), name, |p| p[2].abs() < near);
        mesh.mark(&called("front"), name, |p| {
            (p[2] - self.length).abs() < near
        });
    }
}

impl Shape for Cylinder {
    fn mesh(self) -> Result<Mesh, BuildError> {
        self.check()?;
        let near = 1e-9 * self.radius;
        let mut mesh = self.section()?;
        if self.part != CylinderPart::Quarter {
            let image = mesh.clone().mirrored(0);
            mesh = Mesh::weld(&self.name, [image, mesh], near)?;
        }
        if self.part == CylinderPart::Whole {
            let mut image = mesh.clone().mirrored(1);
            for point in &mut image.points {
                point[1] += 2.0 * self.radius;
            }
            mesh = Mesh::weld(&self.name, [mesh, image], near)?;
        }
        self.mark(&mut mesh);
        Ok(if self.below { mesh.mirrored(1) } else { mesh })
    }
}
