//! Motion, turn, force and moment of the rigid planes.

use crate::model::scene::{PlaneMotion, PlaneTurn, Pose, RigidPlane, Scene};
use crate::model::state::PlaneField;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::recovery::reaction::{SharedNodes, reaction};

/// The field of each plane, from what is `left` over at nodes once ties have handed it on.
pub fn plane_fields(
    model: &Model,
    left: &[[f64; 3]],
    point: &Point,
    u: &[[f64; 3]],
) -> Vec<PlaneField> {
    let scene = model.scene;
    let shared = SharedNodes::of(scene);
    let of = |(index, plane): (usize, &RigidPlane)| {
        let Pose { travel, turn } = pose(scene, plane, u);
        let factor = scene.factor(&plane.name, point.step, point.time);
        let moved = plane.motion.map(|m| m != PlaneMotion::Free);
        let about = plane.point(&scene.mesh, &scene.mirrors);
        let [force, moment] =
            reaction(&scene.mesh, (left, &shared), &plane.surface, (moved, about));
        let (driven, turned) = (&model.all.planes[index], &model.all.turns[index]);
        PlaneField {
            travel,
            turn,
            force: std::array::from_fn(|axis| match (plane.motion[axis], driven[axis]) {
                (PlaneMotion::Driven(load), Some(_)) => factor * load,
                _ => force[axis],
            }),
            moment: std::array::from_fn(|axis| match (plane.turn[axis], turned[axis]) {
                (PlaneTurn::Driven(load), Some(_)) => factor * load,
                _ => moment[axis],
            }),
        }
    };
    scene.rigid_planes.iter().enumerate().map(of).collect()
}

/// How a plane stands. Where it does not turn, all of its nodes move as the first one.
fn pose(scene: &Scene, plane: &RigidPlane, u: &[[f64; 3]]) -> Pose {
    if plane.turns() {
        return plane.pose(&scene.mesh, &scene.mirrors, u);
    }
    let surface = scene.mesh.surface(&plane.surface);
    let node = surface.and_then(|s| s.faces.first());
    Pose {
        travel: node.map_or([0.0; 3], |f| u[f.nodes[0] as usize]),
        ..Pose::default()
    }
}
