//! A scene solved from code, and its answer read by name.

use super::Answer;
use super::body::BodyFigures;
use super::certify::{Figure, Quantity};
use super::inputs::AnswerInputs;
use super::interface::InterfaceFigures;
use super::results::ending::ending;
use super::results::peaks::peaks_in;
use super::results::recovery::{Recovered, recover};
use super::results::strip::{Strip, half_width};
use crate::model::scene::Scene;
use crate::model::state::{ContactField, State};
use crate::solver::solve::{Observer, Silent, Solution, SolveError, solve};

/// A solved scene and what is read from it, in the units of the scene.
///
/// The figures are those at the end of the last step or, where the last steps take the loads off, of the step before
/// them. Forces and areas are those of the whole, of which the model may be a half or a quarter.
///
/// The crate's first page has an example.
#[derive(Debug)]
pub struct Solved {
    /// The scene, its bodies in touch.
    pub scene: Scene,
    /// The states at the ends of all steps, and what they cost.
    pub solution: Solution,
    /// Stresses at nodes and in elements.
    pub recovered: Recovered,
    /// Every figure, with its error.
    pub answer: Answer,
}

impl Solved {
    /// Solves `scene`, telling nobody of it.
    ///
    /// # Errors
    /// [`SolveError`] says why the scene could not be solved.
    pub fn of(scene: Scene) -> Result<Self, SolveError> {
        Self::watched(scene, &mut Silent)
    }

    /// Solves `scene`, telling `observer` of every iteration and increment.
    ///
    /// # Errors
    /// As [`of`](Self::of).
    pub fn watched(mut scene: Scene, observer: &mut dyn Observer) -> Result<Self, SolveError> {
        let solution = solve(&mut scene, observer)?;
        let ending = ending(&scene, &solution.states, &solution.last);
        let recovered = recover(&scene, ending.reported);
        let peaks_of = |state: &Option<State>| {
            let state = state.as_ref()?;
            (state.step == ending.reported.step).then(|| peaks_in(&scene, state))
        };
        let elastic = peaks_of(&solution.elastic);
        let elastic_doubled = peaks_of(&solution.elastic_doubled);
        let answer = Answer::gather(&AnswerInputs {
            unloaded: ending.unloaded,
            steps: &solution.states,
            elastic: elastic.as_deref(),
            elastic_doubled: elastic_doubled.as_deref(),
            doubled: &solution.doubled,
            converged: solution.complete,
            interrupted: solution.interrupted,
            ..AnswerInputs::new(&scene, ending.reported, &recovered)
        });
        Ok(Self {
            answer,
            recovered,
            scene,
            solution,
        })
    }

    /// The state that the figures are of.
    pub fn state(&self) -> &State {
        ending(&self.scene, &self.solution.states, &self.solution.last).reported
    }

    /// The state at the end of step `step`, from 0; `None` where the solution did not get there.
    pub fn at_end_of(&self, step: usize) -> Option<&State> {
        self.solution.states.get(step)
    }

    /// The figures of the contact called `name`.
    pub fn interface(&self, name: &str) -> Option<&InterfaceFigures> {
        self.answer.interfaces.get(name)
    }

    /// Pressure, gap, traction and slip of the contact called `name`, node by node of its carrier.
    pub fn contact(&self, name: &str) -> Option<&ContactField> {
        let pair = self.scene.contacts.iter().position(|c| c.name == name)?;
        self.state().contacts.get(pair)
    }

    /// The figures of the body called `name`.
    pub fn body(&self, name: &str) -> Option<&BodyFigures> {
        self.answer.bodies.get(name)
    }

    /// A figure and its error, of a body or contact called `place`, or of the scene, which is called "overall".
    pub fn figure(&self, what: Quantity, place: &str) -> Option<&Figure> {
        self.answer.figure(what, place)
    }

    /// Travel of what loads the scene along the load; `None` where nothing does.
    pub fn descent(&self) -> Option<f64> {
        self.answer.descent
    }

    /// Mean displacement in `state` of the nodes of the surface called `name`; zero where there is none.
    pub fn travel_of(&self, name: &str, state: &State) -> [f64; 3] {
        let nodes = self.scene.mesh.nodes_of_surface(name);
        let moved = nodes.iter().map(|node| state.displacement[*node as usize]);
        let mut mean = [0.0; 3];
        for u in moved {
            for (sum, u) in mean.iter_mut().zip(u) {
                *sum += u / nodes.len() as f64;
            }
        }
        mean
    }

    /// 2 √(∫ p s² / ∫ p) of the contact called `name`, s being the distance along `axis` (0, 1, 2) from the coordinate
    /// `middle`: the half-width of a Hertzian strip, and 2/√5 of the half axis of a Hertzian ellipse. `None` without
    /// contact.
    pub fn spread(&self, name: &str, axis: usize, middle: f64) -> Option<f64> {
        let field = self.contact(name)?;
        let pair = self.scene.contacts.iter().find(|c| c.name == name)?;
        let surface = pair.carrier_first()[0].surface(&self.scene.mesh)?;
        let strip = Strip {
            middle: Some(middle),
            ..Strip::across(axis)
        };
        half_width(&self.scene.mesh, surface, field, &strip)
    }
}
