//! Motion and force of the rigid planes.

use crate::model::scene::PlaneMotion;
use crate::model::state::PlaneField;
use crate::solver::solve::checkpoint::plastic::Plastic;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::model::system::Model;

pub fn plane_fields(
    model: &Model,
    plastic: &Plastic,
    point: &Point,
    u: &[[f64; 3]],
) -> Vec<PlaneField> {
    let planes = model.scene.rigid_planes.iter().zip(&model.all.planes);
    planes
        .map(|(plane, equations)| {
            let node = model
                .scene
                .mesh
                .surface(&plane.surface)
                .and_then(|s| s.faces.first());
            let travel = node.map_or([0.0; 3], |f| u[f.nodes[0] as usize]);
            let factor = model.scene.factor(&plane.name, point.step, point.time);
            let held = plane.motion.map(|m| matches!(m, PlaneMotion::Held(_)));
            let reaction = model.reaction(plastic, u, &plane.surface, held);
            let force = std::array::from_fn(|axis| match (plane.motion[axis], equations[axis]) {
                (PlaneMotion::Driven(load), Some(_)) => factor * load,
                _ => reaction[axis],
            });
            PlaneField { travel, force }
        })
        .collect()
}
