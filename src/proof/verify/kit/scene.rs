//! Short words for the scenes of the ladder.

use crate::model::mesh::block::cylindrical;
use crate::model::scene::{
    ContactPair, Partner, PlaneMotion, RigidPlane, Side, Support, Traction, TractionValue,
};

/// Displacement components on a surface, by whose name the support goes.
pub fn support(surface: &str, components: [Option<f64>; 3]) -> Support {
    Support {
        name: surface.into(),
        surface: surface.into(),
        components,
        ..Support::default()
    }
}

/// A surface that cannot move along `axis`.
pub fn held(surface: &str, axis: usize) -> Support {
    let mut components = [None; 3];
    components[axis] = Some(0.0);
    support(surface, components)
}

/// Pressure on a surface, by whose name the traction goes.
pub fn pressure(surface: &str, pressure: f64) -> Traction {
    Traction {
        name: surface.into(),
        surface: surface.into(),
        value: TractionValue::Pressure(pressure),
    }
}

/// Force per area on a surface.
pub fn traction(name: &str, surface: &str, value: [f64; 3]) -> Traction {
    Traction {
        name: name.into(),
        surface: surface.into(),
        value: TractionValue::Vector(value),
    }
}

/// A surface that moves as one.
pub fn plane(name: &str, surface: &str, motion: [PlaneMotion; 3]) -> RigidPlane {
    RigidPlane {
        name: name.into(),
        surface: surface.into(),
        motion,
        ..RigidPlane::default()
    }
}

/// A surface that moves as one along `axis` under the total force `force`; free along the others.
pub fn driven(name: &str, surface: &str, axis: usize, force: f64) -> RigidPlane {
    let mut motion = [PlaneMotion::Free; 3];
    motion[axis] = PlaneMotion::Driven(force);
    plane(name, surface, motion)
}

/// Frictionless contact of two surfaces, the upper one carrying the pressure.
pub fn pair(name: &str, upper: &str, lower: &str) -> ContactPair {
    ContactPair {
        name: name.into(),
        upper: Partner::Surface(upper.into()),
        lower: Partner::Surface(lower.into()),
        carrier: Side::Upper,
        friction: 0.0,
        penalty_factor: 1.0,
        true_geometry: true,
    }
}

/// Frictionless contact of a surface with the rigid half space below the coordinate plane
/// through the origin with outward normal along `axis`.
pub fn on_rigid_flat(surface: &str, axis: usize) -> ContactPair {
    let mut normal = [0.0; 3];
    normal[axis] = 1.0;
    ContactPair {
        lower: Partner::Plane {
            point: [0.0; 3],
            normal,
        },
        ..pair("body-flat", surface, "")
    }
}

/// Cylindrical coordinates (radius, angle from x to y, z) to Cartesian ones, with the edges of a
/// quarter exactly on the axes.
pub fn quarter([radius, angle, z]: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = cylindrical([radius, angle, z]);
    let exact = |c: f64| if c.abs() < 1e-12 * radius { 0.0 } else { c };
    [exact(x), exact(y), z]
}

/// Supports of a quarter of a ring in plane strain, meshed as (radius, angle, z) by [`quarter`].
pub fn quarter_supports() -> Vec<Support> {
    let faces = [("y_min", 1), ("y_max", 0), ("z_min", 2), ("z_max", 2)];
    faces.map(|(face, axis)| held(face, axis)).into()
}

/// Supports of the block `upper` on the block `lower`, both free to widen, `lower` held below.
pub fn stack_supports() -> Vec<Support> {
    let faces = [
        ("lower_x_min", 0),
        ("lower_y_min", 1),
        ("upper_x_min", 0),
        ("upper_y_min", 1),
        ("lower_z_min", 2),
    ];
    faces.map(|(face, axis)| held(face, axis)).into()
}
