//! What the size of the increments does to figures: plastic flow and friction are integrated along the path.

use super::figure::{Figure, Quantity, figure};
use crate::answer::results::peaks::BodyPeaks;
use crate::model::scene::Scene;

/// The error of the increments, over the difference that doubling them makes. It would be one where the error
/// of an increment grows with the square of its size and flow is smooth; corners begin to flow one by one.
pub const DOUBLING: f64 = 1.5;

/// Said of a figure whose bar does not know of it.
pub(super) const UNKNOWN: &str =
    "the bar is without what the increments did: there is no second solution to tell";

/// Does the answer depend on the path, as far as is known? Plastic flow does. Friction does where loads are not
/// proportional; where they are, no figure of five scenes moved by 1e-5 when increments became twelve times smaller.
pub(super) fn remembers(scene: &Scene, peaks: &[BodyPeaks]) -> bool {
    let flows = peaks.iter().any(|body| body.peeq_max > 0.0);
    let rubs = scene.contacts.iter().any(|c| c.friction > 0.0);
    flows || (rubs && !is_proportional(scene))
}

/// Do all loads only grow together, up to what is reported?
fn is_proportional(scene: &Scene) -> bool {
    let steps = scene.steps.iter().take(scene.reported_step() + 1);
    let together = steps.clone().all(|step| step.factors.is_empty());
    let factors: Vec<f64> = [0.0].into_iter().chain(steps.map(|s| s.factor)).collect();
    together && factors.is_sorted()
}

/// What the size of the increments does to a figure, from the same figure in increments twice as large; `None` where that
/// is not known.
pub(super) fn error(claim: &Figure, doubled: Option<&[Figure]>) -> Option<f64> {
    match claim.what {
        // Of another solution, which only friction ties to its path.
        Quantity::ElasticPeakMises | Quantity::ElasticMisesAway => Some(0.0),
        what => {
            let other = figure(doubled?, what, &claim.place)?;
            Some(DOUBLING * (claim.value - other.value).abs())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::builder::SceneBuilder;
    use crate::model::mesh::block::{Block, uniform};
    use crate::model::scene::Step;

    #[test]
    fn loads_that_grow_together_are_proportional() {
        let line = || uniform(0.0, 1.0, 1);
        let mesh = Block::new("b", line(), line(), line()).build().unwrap();
        let steel = crate::model::material::Steel::elastic(1.0, 0.3);
        let mut scene = SceneBuilder::new("s").body(mesh, steel).build().unwrap();
        let step = |factor: f64, own: Vec<(String, f64)>| Step {
            name: "s".into(),
            factor,
            factors: own,
        };
        let mut with = |steps: Vec<Step>| {
            scene.steps = steps;
            is_proportional(&scene)
        };
        assert!(with(vec![step(0.5, vec![]), step(1.0, vec![])]));
        assert!(!with(vec![step(1.0, vec![]), step(0.5, vec![])]));
        assert!(!with(vec![step(1.0, vec![("a".into(), 0.0)])]));
    }
}
