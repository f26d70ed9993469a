//! What a case says of symmetry and of turns, asked of its mesh.

use super::error::{CaseError, ErrorKind};
use super::load::Loads;
use crate::ground::geometry::{AXES, range};
use crate::model::mesh::{Face, Mesh};
use crate::model::scene::{OFF_PLANE, PlaneMotion, PlaneTurn, faces_in_plane, reaches_into_plane};

/// Of the length of a body, the distance of a flat end from a plane of symmetry up to which it is meant to lie in it.
const NEARLY: f64 = 1e-3;

/// A model that a plane of symmetry mirrors lies on the positive side of it and ends in it, and nothing moves the plane.
///
/// # Errors
/// [`CaseError`] where the mesh lies elsewhere, and where a support moves what lies in the plane along its normal.
pub(super) fn check_mirrors(
    (loads, mirrors): (&Loads, &[usize]),
    mesh: &Mesh,
) -> Result<(), CaseError> {
    for axis in mirrors.iter().copied() {
        let letter = AXES[axis];
        let source = &mesh.source;
        let [low, high] = mesh.range_along(axis);
        let near = OFF_PLANE * (high - low);
        let refuse = |message: String, help: String| {
            Err(CaseError::new(ErrorKind::Mesh, message).help(help))
        };
        if low < -near {
            let (where_it_is, help) = if high > near {
                let help = format!("drop \"{letter}\" from `symmetry`, or mesh one half");
                ("on both sides", help)
            } else {
                let help = format!("mesh the half of the model where {letter} is positive");
                ("on the negative side", help)
            };
            let message = format!(
                "the mesh {source} lies {where_it_is} of {letter} = 0 (from {low} to {high}), so it \
                 cannot be half of a symmetric model"
            );
            return refuse(message, help);
        }
        for (index, body) in mesh.bodies.iter().enumerate() {
            let nodes = mesh.nodes_of_body(index);
            let at = |node: &u32| mesh.points[*node as usize][axis];
            let [end, other] = range(nodes.iter().map(at));
            let is_flat = |face: &Face| face.nodes.iter().all(|node| at(node) <= end + near);
            let off = end > near && end <= NEARLY * (other - end);
            if off && mesh.outer_faces(index).iter().any(is_flat) {
                let message = format!(
                    "body `{}` of the mesh {source} ends at {letter} = {end}, next to the plane of symmetry \
                     {letter} = 0 and not in it",
                    body.name
                );
                let help = format!(
                    "mesh it up to {letter} = 0, or drop \"{letter}\" from `symmetry` and mesh the whole"
                );
                return refuse(message, help);
            }
        }
        if faces_in_plane(mesh, axis).is_empty() {
            let message = format!(
                "no face of the mesh {source} lies in the plane of symmetry {letter} = 0; it begins at {letter} = {low}"
            );
            let help = format!("mesh it up to {letter} = 0, or drop \"{letter}\" from `symmetry`");
            return refuse(message, help);
        }
        check_loads_in_plane(loads, mesh, axis)?;
    }
    Ok(())
}

/// Nothing moves or presses what lies in the plane of symmetry across `axis`: there the model goes on.
fn check_loads_in_plane(loads: &Loads, mesh: &Mesh, axis: usize) -> Result<(), CaseError> {
    let letter = AXES[axis];
    let near = OFF_PLANE * mesh.extent(axis);
    let is_in_plane = |node: &u32| mesh.points[*node as usize][axis].abs() <= near;
    for support in &loads.supports {
        let nodes = mesh.nodes_of_surface(&support.value.surface);
        let in_plane = nodes.iter().filter(|node| is_in_plane(node));
        let mut in_plane = in_plane.map(|node| &mesh.points[*node as usize]);
        let moves = |at| (support.value.displacement(axis, at)).is_some_and(|u| u != 0.0);
        if in_plane.any(moves) {
            let why = format!(
                "it moves nodes in the plane of symmetry {letter} = 0 along {letter}, which symmetry holds"
            );
            let help = format!("drop \"{letter}\" from `symmetry`, and mesh the other half too");
            return Err(support.place.error(ErrorKind::Conflict, why).help(help));
        }
    }
    for traction in &loads.tractions {
        if reaches_into_plane(mesh, &traction.value.surface, axis) {
            let why = format!(
                "it acts on faces in the plane of symmetry {letter} = 0, where the other half begins: these are inside the whole"
            );
            let help = format!(
                "name a surface without them, or drop \"{letter}\" from `symmetry` if the body ends there"
            );
            return Err(traction.place.error(ErrorKind::Conflict, why).help(help));
        }
    }
    Ok(())
}

/// A turn of a rigid plane moves some of its nodes along an axis that is held or driven: nothing else carries its moment.
///
/// # Errors
/// [`CaseError`] where it moves none.
pub(super) fn check_turns(
    (loads, mirrors): (&Loads, &[usize]),
    mesh: &Mesh,
) -> Result<(), CaseError> {
    for located in &loads.planes {
        let plane = &located.value;
        let about = plane.point(mesh, mirrors);
        let nodes = mesh.nodes_of_surface(&plane.surface);
        let turning = (0..3).filter(|axis| plane.turn[*axis] != PlaneTurn::Held(0.0));
        for axis in turning {
            // Along `across` a node moves by the turn times its distance from the axis along the third one.
            let moves = |across: usize| {
                let lever = 3 - axis - across;
                let at = nodes.iter().map(|node| mesh.points[*node as usize][lever]);
                let [low, high] = range(at);
                let near = OFF_PLANE * mesh.extent(lever);
                match plane.motion[across] {
                    PlaneMotion::Free => false,
                    // All of one lever move as one, and the force says how far.
                    PlaneMotion::Driven(_) => high - low > near,
                    PlaneMotion::Held(_) => {
                        (low - about[lever]).abs().max((high - about[lever]).abs()) > near
                    }
                }
            };
            if !(0..3).filter(|across| *across != axis).any(moves) {
                let why = format!(
                    "a turn about {} moves nothing: its nodes are free along the axis along which it would move them",
                    AXES[axis]
                );
                let help = "hold, displace or drive the plane along that axis too, for a flat face along its normal: a force of zero \
                            will do";
                return Err(located.place.error(ErrorKind::Conflict, why).help(help));
            }
        }
    }
    Ok(())
}
