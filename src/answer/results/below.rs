//! What the bodies below a contact are, and do.

use super::hex::{centre, diagonal, distance};
use crate::ground::geometry::Vec3;
use crate::model::scene::{ContactPair, Scene, joined, joined_to};
use crate::model::state::State;

/// Half-widths, or radii, within which flow makes a contact other than Hertz's.
const OF_FLOW: f64 = 3.0;

/// Half-widths, or radii, within which another material does: a layer of the thickness t changes the width by (a/2t)² of itself
/// and less.
const OF_LAYER: f64 = 5.0;

/// Has what lies below the contact of a pair, at a place, yielded? `a` is its half-width or radius there.
pub fn flows_below(scene: &Scene, state: &State, pair: &ContactPair, (at, a): (Vec3, f64)) -> bool {
    let mesh = &scene.mesh;
    let flows = |element: usize| {
        state.peeq_of(element).iter().any(|p| *p > 0.0) && {
            let corners = mesh.corners(element);
            distance(centre(&corners), at) <= OF_FLOW * a + 0.5 * diagonal(&corners)
        }
    };
    let bodies = joined_to(scene, pair).into_iter();
    bodies
        .flat_map(|body| mesh.bodies[body].elements.clone())
        .any(flows)
}

/// Is another material joined to a body of a pair just below its contact?
pub fn is_layered(scene: &Scene, pair: &ContactPair, (at, a): (Vec3, f64)) -> bool {
    let mesh = &scene.mesh;
    let elastic = |body: usize| {
        let steel = &scene.materials[body];
        (steel.youngs_modulus, steel.poissons_ratio)
    };
    let is_near = |node: &u32| distance(mesh.points[*node as usize], at) <= OF_LAYER * a;
    let comes_near = |body: usize| {
        let elements = mesh.bodies[body].elements.clone();
        mesh.hexes[elements].iter().flatten().any(is_near)
    };
    let group = joined(scene);
    let is_layer = |own: usize, body: usize| {
        group[own] == group[body] && elastic(own) != elastic(body) && comes_near(body)
    };
    let mut own = pair.bodies(mesh).into_iter().flatten();
    own.any(|own| (0..group.len()).any(|body| is_layer(own, body)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::material::Steel;
    use crate::model::mesh::block::{Block, uniform};
    use crate::model::mesh::{Body, Mesh};
    use crate::model::scene::{Partner, Side};

    /// Four elements of the size 1 upon each other: a base of three and its coat, pressed on a plane at z = 4.
    fn coated() -> Mesh {
        let side = || uniform(0.0, 1.0, 1);
        let block = Block::new("block", side(), side(), uniform(0.0, 4.0, 4));
        let mut mesh = block.build().unwrap();
        let body = |(name, elements): (&str, std::ops::Range<usize>)| Body {
            name: name.into(),
            elements,
        };
        mesh.bodies = [("base", 0..3), ("coat", 3..4)].map(body).into();
        mesh
    }

    #[test]
    fn a_coat_of_another_material_is_a_layer_where_contact_is_wide_beside_it() {
        let pair = ContactPair {
            name: "contact".into(),
            upper: Partner::Plane {
                point: [0.0, 0.0, 4.0],
                normal: [0.0, 0.0, -1.0],
            },
            lower: Partner::Surface("z_max".into()),
            carrier: Side::Lower,
            friction: 0.0,
            penalty_factor: 1.0,
            true_geometry: true,
        };
        let top = [0.5, 0.5, 4.0];
        let mut scene = Scene::bare("coated", coated(), Steel::elastic(200.0, 0.3));
        assert!(!is_layered(&scene, &pair, (top, 1.0)));
        // The corners of the base are √1.5 from there.
        scene.materials[1] = Steel::elastic(100.0, 0.3);
        assert!(is_layered(&scene, &pair, (top, 0.25)));
        assert!(!is_layered(&scene, &pair, (top, 0.24)));
    }
}
