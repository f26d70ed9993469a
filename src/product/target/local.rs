//! Where a mesh is to be finer: elements near what misses its target, along the directions in which they are too long.
//!
//! What is asked of contact (pressure, load per length, width, area) is decided at the pressed faces and next to them; a peak
//! of the Mises stress there and where it is nearly as large; the descent by the energy of the error, wherever that is. There an
//! element is split along those of its directions in which the stress varies most. That variation is the gradient of the
//! nodal stresses, as a mean square over the elements around, times the length of the element: what a linear stress within
//! it cannot follow falls with the same length. Along a pressed face directions are compared among themselves, too: what
//! the pressure is read from is decided there, even where the stress varies faster with the depth. So a slice of plane strain stays one layer thick, however thick it is.

use super::goal::{Goal, Target};
use super::level::Level;
use crate::answer::results::recovery::{Recovered, recover};
use crate::ground::geometry::{norm, sub};
use crate::model::mesh::hexahedron::{CORNERS, side_of};
use crate::model::mesh::split::Directions;
use crate::model::mesh::{Face, Mesh};
use crate::model::scene::Scene;
use crate::model::state::State;
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};
use rstar::RTree;

/// What is decided at the pressed faces; so is most of the stress below them.
const CONTACT: [Goal; 5] = [
    Goal::Pressure,
    Goal::HertzPressure,
    Goal::LineLoad,
    Goal::HalfWidth,
    Goal::Area,
];
/// Rings of elements around the pressed faces that are split with them.
const RINGS: usize = 2;
/// A peak is decided where the Mises stress is more than this share of it.
const NEAR_PEAK: f64 = 0.8;
/// The elements with the largest errors are split that make up this share of all.
const BULK: f64 = 0.5;
/// A direction is split where the stress varies by this share of the most.
const VARIES: f64 = 0.5;
/// An element in which the stress varies by less than this share of the target, relative to the largest stress, is fine enough.
const FINE: f64 = 0.25;

/// Along which directions each element of the scene is to be split; `None` where nothing is.
pub(super) fn marks(
    (scene, state): (&Scene, &State),
    level: &Level,
    target: &Target,
) -> Option<Vec<Directions>> {
    let recovered = recover(scene, state);
    let mesh = &scene.mesh;
    let gradients = smooth(mesh, gradients(mesh, &recovered));
    let varies: Vec<[f64; 3]> = (0..mesh.hexes.len())
        .map(|e| variation(&mesh.corners(e), &gradients[e]))
        .collect();
    let missing = |goals: &[Goal]| {
        let mut figures = level.figures.iter().filter(|f| goals.contains(&f.goal));
        figures.any(|f| !f.meets(target, level.bars_decide))
    };
    let mut wanted = vec![false; mesh.hexes.len()];
    let mut pressed = vec![[false; 3]; mesh.hexes.len()];
    let below = [Goal::ElasticMises, Goal::Mises, Goal::PlasticStrain];
    if missing(&CONTACT) || missing(&below) {
        pressed = along_pressed_faces(scene, state);
        let mut near: Vec<bool> = pressed.iter().map(|along| along.contains(&true)).collect();
        (0..RINGS).for_each(|_| near = with_ring(mesh, &near));
        join(&mut wanted, &near);
    }
    if missing(&below) || missing(&[Goal::Bore]) {
        join(&mut wanted, &with_ring(mesh, &peaks(scene, &recovered)));
    }
    if missing(&[Goal::Descent]) {
        join(&mut wanted, &bulk(&recovered, &varies));
    }
    let largest = recovered
        .mises_nodal
        .iter()
        .fold(0.0, |most: f64, s| most.max(*s));
    let enough = FINE * target.within * largest;
    // Directions that are too long beside the others of the same element.
    let long = |among: Directions, varies: &[f64; 3]| {
        let of = [0, 1, 2].map(|k| if among[k] { varies[k] } else { 0.0 });
        let most = of.into_iter().fold(0.0, f64::max);
        of.map(|v| most > enough && v >= VARIES * most)
    };
    let of = |e: usize| {
        let [all, along] = [[true; 3], pressed[e]].map(|among| long(among, &varies[e]));
        [0, 1, 2].map(|k| wanted[e] && (all[k] || along[k]))
    };
    let marks: Vec<Directions> = (0..mesh.hexes.len()).map(of).collect();
    marks
        .iter()
        .any(|mark| mark.contains(&true))
        .then_some(marks)
}

fn join(all: &mut [bool], more: &[bool]) {
    all.iter_mut()
        .zip(more)
        .for_each(|(all, more)| *all |= more);
}

/// The directions of elements that lie in a face which is pressed, on either side.
fn along_pressed_faces(scene: &Scene, state: &State) -> Vec<Directions> {
    let mesh = &scene.mesh;
    let mut along = vec![[false; 3]; mesh.hexes.len()];
    for (pair, field) in scene.contacts.iter().zip(&state.contacts) {
        let active = (0..field.nodes.len()).filter(|at| field.is_active(*at));
        let active: Vec<[f64; 3]> = active
            .map(|at| mesh.points[field.nodes[at] as usize])
            .collect();
        let tree = RTree::bulk_load(active);
        for side in [&pair.upper, &pair.lower] {
            let faces = side.surface(mesh).map_or(&[][..], |s| &s.faces);
            let is_pressed = |face: &&Face| {
                let centre = face.centre(mesh);
                let corners = face.corners(mesh);
                let reach = corners.iter().map(|c| norm(sub(*c, centre)));
                let reach = reach.fold(0.0, f64::max);
                let next = tree.nearest_neighbor(centre);
                next.is_some_and(|at| norm(sub(*at, centre)) <= (1.0 + 1e-6) * reach)
            };
            for face in faces.iter().filter(is_pressed) {
                let element = face.element as usize;
                if let Some((_, across, _)) = side_of(&mesh.hexes[element], &face.nodes) {
                    (0..3).for_each(|k| along[element][k] |= k != across);
                }
            }
        }
    }
    along
}

/// The elements and all that share a node with one of them; what hangs belongs to the nodes that it hangs on, too.
fn with_ring(mesh: &Mesh, some: &[bool]) -> Vec<bool> {
    let mut touched = vec![false; mesh.points.len()];
    for (hex, some) in mesh.hexes.iter().zip(some) {
        if *some {
            hex.iter().for_each(|node| touched[*node as usize] = true);
        }
    }
    for hanging in &mesh.hanging {
        let of_corners = hanging.corners.iter().all(|c| touched[*c as usize]);
        touched[hanging.node as usize] |= of_corners;
    }
    for hanging in mesh.hanging.iter().rev() {
        if touched[hanging.node as usize] {
            hanging
                .corners
                .iter()
                .for_each(|c| touched[*c as usize] = true);
        }
    }
    let touches = |hex: &[u32; 8]| hex.iter().any(|node| touched[*node as usize]);
    mesh.hexes.iter().map(touches).collect()
}

/// Elements in which the Mises stress is nearly as large as anywhere in their body.
fn peaks(scene: &Scene, recovered: &Recovered) -> Vec<bool> {
    let mut near = vec![false; scene.mesh.hexes.len()];
    let cells = &recovered.points.cells;
    let highest = |e: usize| {
        let corners = cells[e].iter().map(|p| recovered.mises_nodal[*p as usize]);
        corners.fold(0.0, f64::max)
    };
    for body in &scene.mesh.bodies {
        let most = body.elements.clone().map(highest).fold(0.0, f64::max);
        for e in body.elements.clone() {
            near[e] = most > 0.0 && highest(e) >= NEAR_PEAK * most;
        }
    }
    near
}

/// The elements with the largest errors.
fn bulk(recovered: &Recovered, varies: &[[f64; 3]]) -> Vec<bool> {
    let error = |(varies, volumes): (&[f64; 3], &[f64; 8])| {
        let square: f64 = varies.iter().map(|v| v * v).sum();
        square * volumes.iter().sum::<f64>()
    };
    let errors: Vec<f64> = varies.iter().zip(&recovered.volumes).map(error).collect();
    let mut order: Vec<usize> = (0..errors.len()).collect();
    order.sort_by(|a, b| errors[*b].total_cmp(&errors[*a]).then(a.cmp(b)));
    let share = BULK * errors.iter().sum::<f64>();
    let (mut sum, mut large) = (0.0, vec![false; errors.len()]);
    for e in order {
        if sum >= share {
            break;
        }
        sum += errors[e];
        large[e] = true;
    }
    large
}

/// Σ g gᵀ over the components of the stress in the middle of each element, g being the gradient of a component.
fn gradients(mesh: &Mesh, recovered: &Recovered) -> Vec<Matrix3<f64>> {
    let of = |e: usize| {
        let corners = mesh.corners(e);
        let mut jacobian = Matrix3::zeros();
        let mut natural = SMatrix::<f64, 3, 6>::zeros();
        for (i, at) in CORNERS.iter().enumerate() {
            let derivative = Vector3::from(*at) / 8.0;
            jacobian += derivative * Vector3::from(corners[i]).transpose();
            let point = recovered.points.cells[e][i] as usize;
            natural +=
                derivative * SVector::<f64, 6>::from(recovered.nodal_stress[point]).transpose();
        }
        let inverse = jacobian.try_inverse().unwrap_or_default();
        let gradient = inverse * natural;
        gradient * gradient.transpose()
    };
    (0..mesh.hexes.len()).map(of).collect()
}

/// The mean over the elements around each node, and over the nodes of each element.
fn smooth(mesh: &Mesh, of_elements: Vec<Matrix3<f64>>) -> Vec<Matrix3<f64>> {
    let mut sum = vec![(Matrix3::zeros(), 0.0); mesh.points.len()];
    for (hex, own) in mesh.hexes.iter().zip(&of_elements) {
        for node in hex {
            let (all, count) = &mut sum[*node as usize];
            *all += own;
            *count += 1.0;
        }
    }
    let mean = |hex: &[u32; 8]| {
        let nodes = hex.iter().map(|node| sum[*node as usize]);
        nodes.map(|(all, count)| all / (8.0 * count)).sum()
    };
    mesh.hexes.iter().map(mean).collect()
}

/// By how much the stress varies along each direction of an element.
fn variation(corners: &[[f64; 3]; 8], gradient: &Matrix3<f64>) -> [f64; 3] {
    [0, 1, 2].map(|k| {
        let way = corners.iter().zip(&CORNERS);
        let way: Vector3<f64> = way.map(|(p, at)| Vector3::from(*p) * (at[k] / 4.0)).sum();
        (way.transpose() * gradient * way)[(0, 0)].max(0.0).sqrt()
    })
}
