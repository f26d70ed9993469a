//! The smooth stress of walls that are one or two elements thin.
//!
//! In bending the strain goes from one face of a wall to the other. Where one or two elements are between them the stress that
//! is assumed within an element has lost much of that: B-bar's has one pressure all through, and averages at nodes do
//! not bring back what no element has. The strain of the displacements along a face has it, as a strain gauge would, and
//! across the face the stress is that of the wall on the whole: nothing where both faces are free, the pressure
//! where it is squeezed.

use super::linings;
use crate::answer::results::hex::GaussRule;
use crate::answer::results::outer_faces::{Bound, OuterFaces};
use crate::answer::results::recovery::{Recovered, symmetric};
use crate::answer::results::strain::strain;
use crate::answer::results::tensor::{mean, tensor_of, traction};
use crate::ground::geometry::{Vec3, add, cross, dot, unit};
use crate::model::material::{Steel, matrix};
use crate::model::mesh::Face;
use crate::model::mesh::surface::sorted;
use crate::model::scene::Scene;
use crate::model::state::State;
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

/// Cosine of the angle between faces up to which they are one.
const ONE_FACE: f64 = 0.8;

/// A point on the faces of thin walls, and what meets there.
#[derive(Default)]
struct WallPoint {
    /// Areas of its faces, outwards; those that are about parallel as one.
    faces: Vec<Vec3>,
    /// Stress of the strain of the displacements, of each element.
    own: Vec<[f64; 6]>,
    /// Mean stress of each element through the wall.
    wall: Vec<[f64; 6]>,
}

/// The stress at [`points`](Recovered::points) that stands for the true one: the nodal average, and at the faces of thin walls
/// what their strains tell, and of linings [what balance does](linings::missing_shear). Where a body is warmed strains tell nothing.
pub(super) fn smooth_stress<'r>(
    scene: &Scene,
    state: &State,
    recovered: &'r Recovered,
    outer: &OuterFaces,
) -> Cow<'r, [[f64; 6]]> {
    let mut points = match scene.temperatures.is_empty() {
        true => wall_points(scene, state, recovered, outer),
        false => BTreeMap::new(),
    };
    let of_linings = linings::missing_shear(scene, recovered, outer);
    if points.is_empty() && of_linings.is_empty() {
        return Cow::Borrowed(&recovered.nodal_stress);
    }
    add_own(scene, state, recovered, &mut points);
    let mut smooth = recovered.nodal_stress.clone();
    for (index, point) in points {
        let Some(body) = recovered.points.body_of(index) else {
            continue;
        };
        let node = recovered.points.node[index];
        let [own, wall] = [point.own, point.wall].map(|all| symmetric(scene, node, mean(&all)));
        let normals: Vec<Vec3> = point.faces.into_iter().filter_map(unit).collect();
        smooth[index] = at_faces(&own, &wall, &normals, &scene.materials[body]);
    }
    for (index, shear) in of_linings {
        smooth[index]
            .iter_mut()
            .zip(shear)
            .for_each(|(s, more)| *s += more);
    }
    Cow::Owned(smooth)
}

/// The points on free faces that one or two elements are between, with these and the stress through the wall.
fn wall_points(
    scene: &Scene,
    state: &State,
    recovered: &Recovered,
    outer: &OuterFaces,
) -> BTreeMap<usize, WallPoint> {
    let mesh = &scene.mesh;
    let mut points: BTreeMap<usize, WallPoint> = BTreeMap::new();
    for faces in &outer.by_body {
        let free = || faces.iter().filter(|face| outer.bound(face) == Bound::Free);
        let all: BTreeSet<[u32; 4]> = free().map(|face| sorted(face.nodes)).collect();
        let behind = |face: &Face| {
            let mut nodes = mesh.hexes[face.element as usize].into_iter();
            let others = std::array::from_fn(|_| nodes.find(|node| !face.nodes.contains(node)));
            sorted(others.map(Option::unwrap_or_default))
        };
        let mut walls: BTreeMap<[u32; 4], Vec<u32>> = BTreeMap::new();
        for face in free() {
            walls.entry(behind(face)).or_default().push(face.element);
        }
        for face in free() {
            let behind = behind(face);
            let wall = &walls[&behind];
            if wall.len() < 2 && !all.contains(&behind) {
                continue;
            }
            let cells = &recovered.points.cells[face.element as usize];
            let nodes = mesh.hexes[face.element as usize].iter().zip(cells);
            for (_, point) in nodes.filter(|(node, _)| face.nodes.contains(node)) {
                let point = points.entry(*point as usize).or_default();
                point.add_face(face.area_vector(mesh));
                let stresses = wall.iter().map(|e| mean(&state.stress[*e as usize]));
                point.wall.extend(stresses);
            }
        }
    }
    points
}

/// Adds the stress of the strain of the displacements, extrapolated in each element; of steel that has flowed the stress
/// itself.
fn add_own(
    scene: &Scene,
    state: &State,
    recovered: &Recovered,
    points: &mut BTreeMap<usize, WallPoint>,
) {
    let (mesh, rule) = (&scene.mesh, GaussRule::new());
    for (body, steel) in mesh.bodies.iter().zip(&scene.materials) {
        for element in body.elements.clone() {
            let cells = &recovered.points.cells[element];
            if !cells
                .iter()
                .any(|point| points.contains_key(&(*point as usize)))
            {
                continue;
            }
            let corners = mesh.corners(element);
            let moved = mesh.hexes[element].map(|node| state.displacement[node as usize]);
            let peeq = state.peeq_of(element);
            let own = std::array::from_fn(|k| match peeq[k] > 0.0 {
                true => state.stress[element][k],
                false => steel
                    .moduli()
                    .stress(&strain(&rule.gradients[k], &corners, &moved)),
            });
            for (point, own) in cells.iter().zip(rule.extrapolate(&own)) {
                if let Some(point) = points.get_mut(&(*point as usize)) {
                    point.own.push(own);
                }
            }
        }
    }
}

/// The stress with the tractions of `wall` on all faces with these normals and, along them, the strains of `own`.
fn at_faces(own: &[f64; 6], wall: &[f64; 6], normals: &[Vec3], steel: &Steel) -> [f64; 6] {
    let nu = steel.poissons_ratio;
    let off: [f64; 6] = std::array::from_fn(|k| own[k] - wall[k]);
    let Some((n, others)) = normals.split_first() else {
        return *own;
    };
    let across = |m: &&Vec3| dot(*n, **m).abs() < ONE_FACE;
    let along = match others.iter().find(across) {
        // Along a face strains give stresses as in a plate: what is free across it takes its share away.
        None => {
            let pull = traction(&off, *n);
            let normal = dot(pull, *n);
            tensor_of(|i, j| {
                let flat = f64::from(u8::from(i == j)) - n[i] * n[j];
                let of_traction = pull[i] * n[j] + n[i] * pull[j] - normal * n[i] * n[j];
                matrix(off)[i][j] - of_traction - nu / (1.0 - nu) * normal * flat
            })
        }
        // Along an edge as in a bar.
        Some(_) if others.len() > 1 => [0.0; 6],
        Some(m) => {
            let edge = unit(cross(*n, *m)).unwrap_or_default();
            let pull = dot(traction(&off, edge), edge);
            let bar = pull - nu * (off[0] + off[1] + off[2] - pull);
            tensor_of(|i, j| bar * edge[i] * edge[j])
        }
    };
    std::array::from_fn(|k| wall[k] + along[k])
}

impl WallPoint {
    fn add_face(&mut self, area: Vec3) {
        let is_one = |other: &&mut Vec3| {
            let both = [**other, area].map(unit);
            matches!(both, [Some(a), Some(b)] if dot(a, b) > ONE_FACE)
        };
        match self.faces.iter_mut().find(is_one) {
            Some(face) => *face = add(*face, area),
            None => self.faces.push(area),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// With the strain ε along x, free faces across z: E ε/(1 - ν²) in a plate, E ε in a bar. A wall that is squeezed keeps
    /// its pressure.
    #[test]
    fn the_face_of_a_wall_has_the_stress_of_a_strain_gauge() {
        let (steel, strain) = (Steel::elastic(200.0, 0.25), 0.01);
        let own = steel.moduli().stress(&[strain, 0.0, 0.0, 0.0, 0.0, 0.02]);
        let (up, side) = ([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]);
        let close = |found: [f64; 6], wanted: [f64; 6]| {
            found.iter().zip(wanted).all(|(f, w)| (f - w).abs() < 1e-12)
        };
        let plate = 200.0 * strain / (1.0 - 0.0625);
        let free = at_faces(&own, &[0.0; 6], &[up], &steel);
        assert!(
            close(free, [plate, 0.25 * plate, 0.0, 0.0, 0.0, 0.0]),
            "{free:?}"
        );
        // The bar may shorten across: the same strain along it costs less.
        let bar = at_faces(&own, &[0.0; 6], &[up, side], &steel);
        assert!(
            close(bar, [200.0 * strain, 0.0, 0.0, 0.0, 0.0, 0.0]),
            "{bar:?}"
        );
        let squeezed = [0.0, 0.0, -3.0, 0.0, 0.0, 0.0];
        let pressed = at_faces(&own, &squeezed, &[up], &steel);
        assert!((pressed[2] + 3.0).abs() < 1e-12);
        assert!(
            (pressed[0] - plate + 3.0 * 0.25 / 0.75).abs() < 1e-12,
            "{pressed:?}"
        );
        let corner = [up, side, [1.0, 0.0, 0.0]];
        assert!(close(at_faces(&own, &squeezed, &corner, &steel), squeezed));
    }
}
