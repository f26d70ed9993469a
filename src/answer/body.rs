//! Figures of bodies and rollers.

use super::inputs::AnswerInputs;
use super::named::{Named, Three};
use crate::answer::results::bore::BoreStress;
use crate::answer::results::edges::SingularEdges;
use crate::answer::results::flow::{BodyFlow, flows};
use crate::answer::results::peaks::{BodyPeaks, Peak};
use serde::Serialize;

/// A body.
#[derive(Debug, Clone, Default, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BodyFigures {
    /// Largest Mises stress, read in three ways.
    pub mises_max: Three<Option<f64>>,
    /// Undeformed coordinates of the three peaks.
    pub at: Three<Option<[f64; 3]>>,
    /// Peaks beside a singular edge, which grow with every refinement.
    pub at_singular_edge: Three<bool>,
    /// Peaks of the elastic solution, where the body has yielded and that solution is known.
    pub elastic_mises_max: Option<Three<Option<f64>>>,
    /// Where its steel begins to yield; none of steel that stays elastic.
    pub yield_stress: Option<f64>,
    /// Largest equivalent plastic strain at an integration point.
    pub peeq_max: f64,
    /// Plastic strain beside singular edges and away from them.
    #[serde(skip)]
    pub flow: BodyFlow,
    /// In the whole body, not only its modelled part; so is `volume`.
    pub yielded_volume: f64,
    /// Of the whole body.
    pub volume: f64,
}

/// A hollow roller.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, schemars::JsonSchema)]
pub struct RollerFigures {
    /// Mises stress on the inner wall below the load, from the strain of its surface.
    pub bore_mises: Option<f64>,
    /// Where that is, undeformed.
    pub bore_mises_at: Option<[f64; 3]>,
    /// Largest nodal average on the whole inner wall.
    pub bore_mises_nodal: Option<f64>,
    /// Where that is, undeformed.
    pub bore_mises_nodal_at: Option<[f64; 3]>,
}

/// The figures of every body; `peaks` are in the order of the mesh.
pub fn bodies(
    solved: &AnswerInputs,
    peaks: &[BodyPeaks],
    edges: &SingularEdges,
) -> Named<BodyFigures> {
    let flows = flows(solved.scene, solved.state, edges);
    let summarise = |(body, peaks): (usize, &BodyPeaks)| {
        let elastic = solved
            .elastic
            .filter(|_| peaks.peeq_max > 0.0)
            .and_then(|e| e.get(body));
        let touches = |peak: Peak| edges.are_near(&peak.at);
        let summary = BodyFigures {
            mises_max: three(peaks, |peak| peak.value),
            at: three(peaks, |peak| peak.at),
            at_singular_edge: Three {
                centroid: peaks.centroid.is_some_and(touches),
                integration_point: peaks.integration_point.is_some_and(touches),
                nodal: peaks.nodal.is_some_and(touches),
            },
            elastic_mises_max: elastic.map(|e| three(e, |peak| peak.value)),
            yield_stress: (solved.scene.materials.get(body))
                .map(|steel| steel.yield_stress)
                .filter(|stress| stress.is_finite()),
            peeq_max: peaks.peeq_max,
            flow: flows[body],
            yielded_volume: peaks.yielded_volume,
            volume: peaks.volume,
        };
        (peaks.name.clone(), summary)
    };
    Named(peaks.iter().enumerate().map(summarise).collect())
}

fn three<T>(peaks: &BodyPeaks, read: impl Fn(Peak) -> T) -> Three<Option<T>> {
    Three {
        centroid: peaks.centroid.map(&read),
        integration_point: peaks.integration_point.map(&read),
        nodal: peaks.nodal.map(&read),
    }
}

impl From<&BoreStress> for RollerFigures {
    fn from(stress: &BoreStress) -> Self {
        Self {
            bore_mises: stress.mises,
            bore_mises_at: stress.mises_at,
            bore_mises_nodal: stress.nodal,
            bore_mises_nodal_at: stress.nodal_at,
        }
    }
}
