//! All steps side by side.

use super::inputs::AnswerInputs;
use super::named::{Named, Three};
use super::plane::{PlaneFigures, planes};
use crate::answer::certify::{Contacts, Earlier, Outside, Travel};
use crate::answer::results::edges::SingularEdges;
use crate::answer::results::hertz::HeaviestLine;
use crate::answer::results::interface::{StatusCounts, interfaces};
use crate::answer::results::load;
use crate::answer::results::peaks::{BodyPeaks, Peak, peaks};
use crate::answer::results::recovery::recover;
use crate::model::state::State;
use serde::Serialize;
use std::borrow::Cow;

/// The end of a step that is done.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct StepFigures {
    /// Its name.
    pub name: String,
    /// What every support, rigid plane, traction and temperature is multiplied with, by name.
    pub factors: Named<f64>,
    /// The load that acts on the whole, as a vector, and its size.
    pub force: [f64; 3],
    /// Size of that load.
    pub load: f64,
    /// Travel of what is loaded, along the load, with what the mesh is likely to miss of it.
    pub descent: Option<f64>,
    /// The largest of all bodies.
    pub mises_max: Three<Option<f64>>,
    /// Largest equivalent plastic strain of all bodies.
    pub peeq_max: f64,
    /// Every contact pair, in the order of the scene.
    pub interfaces: Named<StepInterface>,
    /// Every rigid plane, in the order of the scene.
    pub planes: Named<PlaneFigures>,
    /// Are the figures of the answer of this moment?
    pub reported: bool,
}

/// An interface at the end of a step.
#[derive(Debug, Clone, Default, PartialEq, Serialize, schemars::JsonSchema)]
pub struct StepInterface {
    /// On the lower body, of the whole.
    pub force: [f64; 3],
    /// Largest consistent nodal pressure; compression is positive.
    pub max_pressure: f64,
    /// How many nodes are open, stick and slip.
    pub status_counts: StatusCounts,
}

impl StepFigures {
    /// Largest pressure of all interfaces.
    pub fn max_pressure(&self) -> Option<f64> {
        let all = self.interfaces.0.iter().map(|(_, i)| i.max_pressure);
        all.reduce(f64::max)
    }

    /// Nodes of all interfaces that stick, and that slip.
    pub fn stick_and_slip(&self) -> [usize; 2] {
        let counts = self.interfaces.0.iter().map(|(_, i)| i.status_counts);
        counts.fold([0, 0], |[stick, slip], c| [stick + c.stick, slip + c.slip])
    }
}

/// The end of a step, and what the bars of later ones need of it.
pub struct StepEnd {
    pub figures: StepFigures,
    pub travel: Option<Travel>,
    pub peaks: Vec<BodyPeaks>,
}

impl StepEnd {
    /// For what comes after it.
    pub fn as_earlier(&self) -> Earlier<'_> {
        let interfaces = self.figures.interfaces.0.iter();
        Earlier {
            forces: interfaces.map(|(_, i)| i.force).collect(),
            travel: self.travel,
            peaks: &self.peaks,
        }
    }
}

/// Peaks of the bodies, and the travel.
type Known<'a> = (&'a [BodyPeaks], Option<Travel>);

/// One entry for the end of each step that is done, in their order.
pub fn steps(solved: &AnswerInputs, outside: &Outside, (peaks, travel): Known) -> Vec<StepEnd> {
    let one = |state: &State| {
        let reported = state.step == solved.state.step && state.time == solved.state.time;
        step(
            solved,
            outside,
            (state, reported.then_some((peaks, travel))),
        )
    };
    solved.steps.iter().map(one).collect()
}

/// The figures of a step; `reported` are the peaks of the bodies and the travel where they are known.
fn step(
    solved: &AnswerInputs,
    outside: &Outside,
    (state, reported): (&State, Option<Known>),
) -> StepEnd {
    let scene = solved.scene;
    let measured = interfaces(scene, state);
    let (bodies, travel) = match reported {
        Some((peaks, travel)) => (Cow::from(peaks), travel),
        None => {
            let recovered = recover(scene, state);
            let edges = SingularEdges::find(scene, state);
            let lines = HeaviestLine::of_pairs(scene, state, &edges.loaded);
            let peaks = peaks((scene, state), &recovered, &edges, &lines);
            let contacts = Contacts {
                interfaces: &measured,
                lines: &lines,
            };
            let travel = Travel::of(scene, state, &recovered, (contacts, outside, &edges));
            (Cow::from(peaks), travel)
        }
    };
    let largest = |peak: &dyn Fn(usize) -> Option<Peak>| {
        let values = (0..bodies.len()).filter_map(peak).map(|p| p.value);
        values.reduce(f64::max)
    };
    let names = (scene.supports.iter().map(|s| &s.name))
        .chain(scene.rigid_planes.iter().map(|p| &p.name))
        .chain(scene.tractions.iter().map(|t| &t.name))
        .chain(scene.temperatures.iter().map(|t| &t.name));
    let factor = |name: &String| {
        let factor = scene.factor(name, state.step, state.time);
        (name.clone(), factor)
    };
    let interfaces = measured.into_iter().map(|i| {
        let summary = StepInterface {
            force: i.force,
            max_pressure: i.max_pressure,
            status_counts: i.status_counts,
        };
        (i.name, summary)
    });
    let name = scene.steps.get(state.step).map(|step| step.name.clone());
    let figures = StepFigures {
        name: name.unwrap_or_default(),
        factors: Named(names.map(factor).collect()),
        force: load::resultant(scene, state),
        load: load::applied(scene, state),
        descent: travel.map(|travel| travel.value()),
        mises_max: Three {
            centroid: largest(&|i| bodies[i].centroid),
            integration_point: largest(&|i| bodies[i].integration_point),
            nodal: largest(&|i| bodies[i].nodal),
        },
        peeq_max: bodies.iter().map(|b| b.peeq_max).fold(0.0, f64::max),
        interfaces: Named(interfaces.collect()),
        planes: planes(scene, state),
        reported: reported.is_some(),
    };
    StepEnd {
        figures,
        travel,
        peaks: bodies.into_owned(),
    }
}
