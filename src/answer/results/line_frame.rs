//! Along a line of contact, across it and up: the directions that its places are measured in.

use super::load::{direction, upright};
use crate::ground::geometry::{AXES, Vec3, add, cross, dot, norm, scale, sub, unit};
use crate::model::mesh::Surface;
use crate::model::scene::Scene;

/// Three unit vectors, square to each other. Those that are axes are so exactly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineFrame {
    /// Along the line.
    pub along: Vec3,
    /// Across it, along the surfaces.
    pub across: Vec3,
    /// Square to both: where the surfaces face.
    pub up: Vec3,
}

impl LineFrame {
    /// That of lines along an axis (0, 1, 2); `None` where the load acts along it, too.
    pub fn of_axis(scene: &Scene, axis: usize) -> Option<Self> {
        Self::new(unit_along(axis), unit_along(upright(scene)))
    }

    /// That of lines along `along` between surfaces that face `up`; `None` where these are parallel.
    pub fn new(along: Vec3, up: Vec3) -> Option<Self> {
        /// Sine of the angle between directions that rounding alone keeps apart.
        const PARALLEL: f64 = 1e-6;
        let along = forwards(unit(along)?);
        let square = square_to(along, up);
        let is_square = norm(square) > PARALLEL * norm(up);
        let up = forwards(unit(square).filter(|_| is_square)?);
        Some(Self {
            along,
            across: forwards(cross(up, along)),
            up,
        })
    }

    /// Coordinate of a place along the line.
    pub fn along(&self, at: &Vec3) -> f64 {
        dot(self.along, *at)
    }

    /// Coordinate of a place across the line.
    pub fn across(&self, at: &Vec3) -> f64 {
        dot(self.across, *at)
    }

    /// What of a vector is square to the line.
    pub fn square(&self, v: Vec3) -> Vec3 {
        square_to(self.along, v)
    }

    /// A place moved along the line to the coordinate `to`.
    pub fn moved(&self, at: Vec3, to: f64) -> Vec3 {
        let square = self.square(at);
        [0, 1, 2].map(|k| square[k] + self.along[k] * to)
    }

    /// Do both run along the same direction?
    pub fn is_parallel(&self, other: &Self) -> bool {
        const SAME: f64 = 1.0 - 1e-9;
        dot(self.along, other.along).abs() > SAME
    }
}

/// The axis that a unit vector is, if it is one.
pub fn axis_of(direction: &Vec3) -> Option<usize> {
    const ROUNDING: f64 = 1e-12;
    (0..3).find(|i| direction[*i].abs() > 1.0 - ROUNDING)
}

/// Is a direction the normal of one of some mirror planes?
pub fn is_mirrored(direction: &Vec3, mirrors: &[usize]) -> bool {
    axis_of(direction).is_some_and(|axis| mirrors.contains(&axis))
}

/// What a direction is called: x, y or z, or its components.
pub fn name_of(direction: &Vec3) -> String {
    match axis_of(direction) {
        Some(axis) => AXES[axis].to_owned(),
        None => {
            // Without the sign of a zero.
            let [x, y, z] = direction.map(|c| format!("{c:.4}").replace("-0.0000", "0.0000"));
            format!("({x}, {y}, {z})")
        }
    }
}

/// The unit vector of an axis.
pub(super) const fn unit_along(axis: usize) -> Vec3 {
    let mut unit = [0.0; 3];
    unit[axis] = 1.0;
    unit
}

/// Where the surfaces of a pair face: the axis next to the load where that is so, as surfaces or the load itself say, or else the normal
/// of the one that is plane, or along the load.
pub(super) fn facing(scene: &Scene, sides: &[&Surface]) -> Vec3 {
    /// Cosine up to which that is the axis: 8 degrees.
    const NEXT: f64 = 0.99;
    /// Of all of its area, what a half cylinder faces, and a plane.
    const HALF: f64 = 0.5;
    const PLANE: f64 = 0.9;
    let (axis, load) = (unit_along(upright(scene)), direction(scene));
    let normal = |side: &&Surface| {
        let areas = side.faces.iter().map(|face| face.area_vector(&scene.mesh));
        let (sum, all) = areas.fold(([0.0; 3], 0.0), |(sum, all), a| {
            (add(sum, a), all + norm(a))
        });
        // Its images go on behind the mirrors.
        let whole = [0, 1, 2].map(|k| {
            if scene.mirrors.contains(&k) {
                0.0
            } else {
                sum[k]
            }
        });
        unit(whole).map(|normal| (norm(whole) / all, normal))
    };
    let normals: Vec<(f64, Vec3)> = sides.iter().filter_map(normal).collect();
    let is_next = |direction: &Vec3| dot(*direction, axis).abs() > NEXT;
    if is_next(&load)
        || normals
            .iter()
            .any(|(share, normal)| *share > HALF && is_next(normal))
    {
        return axis;
    }
    let plane = normals.into_iter().filter(|(share, _)| *share > PLANE);
    let planest = plane.max_by(|a, b| a.0.total_cmp(&b.0));
    planest.map_or(load, |(_, normal)| normal)
}

fn square_to(along: Vec3, v: Vec3) -> Vec3 {
    sub(v, scale(along, dot(along, v)))
}

/// The direction or its opposite: that whose largest component is positive.
fn forwards(direction: Vec3) -> Vec3 {
    let largest = direction.into_iter().fold(
        0.0,
        |most: f64, c| if c.abs() > most.abs() { c } else { most },
    );
    scale(direction, if largest < 0.0 { -1.0 } else { 1.0 })
}
