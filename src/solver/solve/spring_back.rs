//! What stays of a displacement when all loads and contact forces are taken off.

use crate::ground::geometry::sub;
use crate::model::half_turn::HalfTurn;
use crate::model::material::Moduli;
use crate::model::material::j2::PlasticPoint;
use crate::model::scene::Scene;
use crate::model::state::State;
use crate::solver::fem::loads::at_nodes;
use crate::solver::linear::krylov;
use crate::solver::linear::preconditioner::Precision;
use crate::solver::solve::checkpoint::expected::Expected;
use crate::solver::solve::error::SolveError;
use crate::solver::solve::linear_system::shifted_diagonal::shift_diagonal;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::params::{
    ELASTIC_FORCE_ROUNDING, FACTOR_DIRECTIONS, SPRING_BACK_LOOSEST, SPRING_BACK_RESIDUAL,
    SPRING_BACK_TOLERANCE,
};
use crate::solver::solve::ties::unknowns::tied;
use rayon::prelude::*;

/// Displacement of every node, in the length unit of the scene, that stays when the bodies spring
/// back elastically from `state`: that of elastic bodies under the plastic strains of `state` alone,
/// held as the scene holds them, without loads, and touching nothing.
///
/// Forces that are taken off elastically change stresses and displacements by what they do in an
/// elastic body, wherever they come from; so nothing is left of the pressing of a remaining load, nor
/// of shears that friction has locked in. The same is found from any state on the way down as long
/// as nothing yields there. Where nothing has yielded it is zero, and nothing is solved.
///
/// Bodies that only contact holds are free here: their rigid motion has no meaning.
///
/// # Errors
/// [`SolveError`] where memory runs out or the linear system resists.
pub fn spring_back(scene: &Scene, state: &State) -> Result<Vec<[f64; 3]>, SolveError> {
    let Ok(half_turn) = HalfTurn::of(scene) else {
        return spring_back_alone(scene, state);
    };
    let half = spring_back_alone(&half_turn.half, &half_turn.fold(state))?;
    Ok(half_turn.unfold_stays(&half))
}

fn spring_back_alone(scene: &Scene, state: &State) -> Result<Vec<[f64; 3]>, SolveError> {
    let flow = yielded(state);
    if flow.is_empty() {
        return Ok(vec![[0.0; 3]; scene.mesh.points.len()]);
    }
    let mut alone = scene.clone();
    alone.contacts.clear();
    alone.tractions.clear();
    alone.controls.plasticity = false;
    let expected = Expected {
        reach: 0.0,
        contact: 0.0,
        flow,
        divided: false,
    };
    let model = Model::new(&alone, &expected, (Vec::new(), tied(&alone)?))?;
    spring_back_of(&model, state)
}

/// Elements in which something has yielded.
fn yielded(state: &State) -> Vec<u32> {
    let yielded = |points: &[f64; 8]| points.iter().any(|p| *p > 0.0);
    (0..)
        .zip(&state.peeq)
        .filter_map(|(element, points)| yielded(points).then_some(element))
        .collect()
}

/// The same of a model that is at hand: its stiffness knows of no contact and of no flow.
pub(in crate::solver::solve) fn spring_back_of(
    model: &Model,
    state: &State,
) -> Result<Vec<[f64; 3]>, SolveError> {
    let mut stays = vec![[0.0; 3]; model.scene.mesh.points.len()];
    let yielded = yielded(state);
    if yielded.is_empty() {
        return Ok(stays);
    }
    let (forces, elastic) = plastic_forces(model, state, &yielded);
    let mut all = model.all.gather(&forces);
    model.bodies.reduce(&mut all);
    let forces = model.bodies.restrict(&all);
    let kept = solve(model, &forces, ELASTIC_FORCE_ROUNDING * elastic)?;
    model.bodies.recover(&kept, &mut all);
    model.all.scatter_add(&all, 1.0, &mut stays);
    model.all.tied.spread(&mut stays);
    Ok(stays)
}

/// Forces with which the plastic strain of `elements` acts on elastic bodies: the elastic answer to
/// the displacements, less the forces of the stresses that are there. Beside them the norm of the
/// elastic answer, which tells how much of them is rounding.
fn plastic_forces(model: &Model, state: &State, elements: &[u32]) -> (Vec<[f64; 3]>, f64) {
    let mesh = &model.scene.mesh;
    let of_element = |element: &u32| {
        let nodes = mesh.hexes[*element as usize];
        let elastic = &model.elastic[mesh.body_of(*element as usize)];
        let shape = model.element(*element);
        // From one corner: a translation does nothing but round.
        let from = state.displacement[nodes[0] as usize];
        let u = nodes.map(|n| sub(state.displacement[n as usize], from));
        let mut force = shape.elastic_force(elastic, &u);
        let size: f64 = force.as_flattened().iter().map(|f| f * f).sum();
        // The force of a plastic strain whose stress this would be: inner unknowns are in balance.
        let points = state.stress[*element as usize].map(|stress| PlasticPoint {
            strain: strain(elastic, &stress),
            ..PlasticPoint::default()
        });
        let points = model.free_strains(*element, points, (state.step, state.time));
        let inner = shape.relief(elastic, &points);
        let pairs = force.as_flattened_mut().iter_mut();
        pairs.zip(inner.as_flattened()).for_each(|(f, i)| *f -= i);
        ((nodes, force), size)
    };
    let (forces, sizes): (Vec<_>, Vec<f64>) = elements.par_iter().map(of_element).unzip();
    (
        at_nodes(mesh.points.len(), forces),
        sizes.iter().sum::<f64>().sqrt(),
    )
}

/// Hooke's law backwards: elastic strain (engineering shears) from stress.
fn strain(elastic: &Moduli, stress: &[f64; 6]) -> [f64; 6] {
    let mean = (stress[0] + stress[1] + stress[2]) / 3.0;
    std::array::from_fn(|i| match i {
        0..3 => (stress[i] - mean) / (2.0 * elastic.shear) + mean / (3.0 * elastic.bulk),
        _ => stress[i] / elastic.shear,
    })
}

/// Solves the stiffness for self-balanced forces that are known up to `rounding`; bodies may float.
fn solve(model: &Model, forces: &[f64], rounding: f64) -> Result<Vec<f64>, SolveError> {
    let (pattern, matrix) = (&model.pattern, &model.stiffness);
    let mut shifted = matrix.clone();
    shift_diagonal(pattern, &mut shifted);
    let factor =
        model
            .preconditioner
            .factorise(pattern, [&shifted, matrix], Precision::default(), None)?;
    let multiply = |x: &[f64], y: &mut [f64]| pattern.multiply(matrix, x, y);
    let precondition = |x: &mut [f64]| (model.preconditioner).apply(pattern, &factor, multiply, x);
    let known = rounding / krylov::norm(forces).max(f64::MIN_POSITIVE);
    let tolerance = known.clamp(SPRING_BACK_TOLERANCE, SPRING_BACK_LOOSEST);
    let (x, outcome) = krylov::solve(multiply, precondition, forces, tolerance, FACTOR_DIRECTIONS);
    if outcome.residual <= known.max(SPRING_BACK_RESIDUAL) {
        Ok(x)
    } else {
        Err(SolveError::SpringBack {
            residual: outcome.residual,
        })
    }
}
