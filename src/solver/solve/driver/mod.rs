//! Steps and increments: automatic size, cut-back, and what is kept at each accepted one.

mod adapt;
mod companion;
mod keep;
mod outlook;
mod plan;

use super::anchor;
use super::counters::Counters;
use super::diagnosis::{At, describe, diagnose, no_balance};
use super::effort::UNLOADING;
use super::error::SolveError;
use super::foresight::Expected;
use super::history::History;
use super::linear_solver::LinearSolver;
use super::model::{Model, can_yield};
use super::newton::{self, Failure, Point, Stopped};
use super::observer::Observer;
use super::restart::{Beside, Kept, Plan, Restart};
use super::rigid;
use super::rows::{contact_rows, sights};
use super::start::{self, Closing};
use super::timers::{Phase, Timers};
use crate::model::scene::{LITTLE, Scene};
use crate::model::state::State;
use crate::solver::contact::facing::Sight;
use crate::solver::contact::law::Node;
use companion::Companion;
pub use companion::KeptCompanion;

/// By how much increments that were not cut back grow, and how much larger than the first they may get in all: who
/// asks for a small first increment asks for a fine path.
const GROWTH: f64 = 1.5;
const LARGEST: f64 = 3.0;

/// Share of a step to which the plastic limit is sought: meshes know it no better. Where more increments than these
/// would be left it is not sought that far.
const LIMIT_KNOWN: f64 = 5e-3;
const MOST_LEFT: f64 = 20.0;

/// What a solved scene leaves behind.
#[derive(Debug, Clone)]
pub struct Solution {
    /// The state at the end of each finished step.
    pub states: Vec<State>,
    /// The last accepted state.
    pub last: State,
    /// The end of a step if no steel had yielded, where that was found on the way: displacements,
    /// stresses and contact, no accumulated slip.
    pub elastic: Option<State>,
    /// The ends of steps in increments twice as large, where something has yielded.
    pub doubled: Vec<State>,
    /// How often the expensive parts ran.
    pub counters: Counters,
    /// Bodies that were moved into touch before the load.
    pub closings: Vec<Closing>,
    /// Contact pairs that never came within reach of each other.
    pub untouched: Vec<String>,
    /// Were all steps finished, or all but the taking off of the load?
    pub complete: bool,
    /// Why the load was not taken off to the end, in words, where all steps before were finished.
    pub stuck: Option<String>,
    /// Why it took many iterations, in words, where it did.
    pub laborious: Option<String>,
}

/// Solves `scene`, telling `observer` of every iteration and increment.
///
/// The mesh of the scene may be moved: bodies that float are brought into touch first, and the
/// displacements count from there.
///
/// # Errors
/// [`SolveError`]; increments accepted before were handed to the observer.
pub fn solve(scene: &mut Scene, observer: &mut dyn Observer) -> Result<Solution, SolveError> {
    resume(scene, None, observer).map_err(|unfinished| unfinished.error)
}

/// What came of a solution that did not get to its end.
#[derive(Debug)]
pub struct Unfinished {
    /// Why it ended.
    pub error: SolveError,
    /// Up to the last accepted increment; `None` where there is none.
    pub solution: Option<Box<Solution>>,
}

impl<E: Into<SolveError>> From<E> for Unfinished {
    fn from(error: E) -> Self {
        Self {
            error: error.into(),
            solution: None,
        }
    }
}

/// Goes on with `scene` after the increment that `restart` was made at, or from the start.
///
/// The scene is the one that the first run began with: floating bodies are moved into touch again.
///
/// # Errors
/// As [`solve`], and where `restart` belongs to another scene.
pub fn resume(
    scene: &mut Scene,
    restart: Option<&Restart>,
    observer: &mut dyn Observer,
) -> Result<Solution, Unfinished> {
    restart.map_or(Ok(()), |restart| restart.check(scene))?;
    let closings = start::touch(scene);
    for c in &closings {
        let s = c.shift;
        observer.message(&format!(
            "{} moved by [{:.3e}, {:.3e}, {:.3e}] to close its gap",
            c.body, s[0], s[1], s[2]
        ));
    }
    observer.moved(scene);
    let mut timers = Timers::default();
    let expected = match restart {
        Some(restart) => restart.expected.clone(),
        None => Expected::at_start(scene),
    };
    let model = timers.time(Phase::Prepare, || {
        let rows = contact_rows(scene, expected.reach);
        Model::new(scene, &expected, rows)
    })?;
    let mut run = Run::new(model, expected, observer);
    run.sights = timers.time(Phase::Prepare, || {
        sights(run.model.scene, start::extent(run.model.scene))
    });
    run.counters.timers = timers;
    if let Some(restart) = restart {
        run.go_on_from(restart);
    }
    run.observer.message(&format!(
        "{} unknowns, about {:.2} GB of memory",
        run.counters.equations,
        1e-9 * run.model.memory
    ));
    let untouched = run.untouched();
    for name in &untouched {
        run.observer
            .message(&format!("contact pair {name}: nothing is within reach"));
    }
    let ended = run.all_steps();
    let stuck = ended.as_ref().err().and_then(|error| run.stuck(error));
    let ended = if stuck.is_some() { Ok(true) } else { ended };
    let solution = Solution {
        states: run.states,
        last: run.last,
        elastic: run.beside.elastic.map(|kept| kept.restore(&run.model)),
        doubled: (run
            .beside
            .doubled
            .iter()
            .map(|kept| kept.restore(&run.model)))
        .collect(),
        laborious: (run.counters.effort).reason(run.counters.iterations, run.counters.cut_backs),
        counters: run.counters,
        closings,
        untouched,
        complete: matches!(ended, Ok(true)),
        stuck,
    };
    match ended {
        Ok(_) => Ok(solution),
        Err(error) => Err(Unfinished {
            error,
            solution: (!solution.last.displacement.is_empty()).then(|| Box::new(solution)),
        }),
    }
}

struct Run<'a, 'o> {
    model: Model<'a>,
    /// Where the sides of each pair face each other.
    sights: Vec<Vec<Sight>>,
    expected: Expected,
    observer: &'o mut dyn Observer,
    solver: LinearSolver,
    history: History,
    /// In increments twice as large; none where it is not wanted or has not converged.
    companion: Option<Companion>,
    beside: Beside,
    point: Point,
    /// A better first guess than the last accepted state.
    guess: Option<Point>,
    /// The end of the step if no steel yielded, from which its last increment starts.
    end: Option<Point>,
    counters: Counters,
    /// Has statics been asked about this increment, and were bodies held back for a first guess?
    asked: bool,
    held_back: bool,
    /// Share of the step that the next increment tries.
    size: f64,
    /// Has it been cut back?
    cut: bool,
    states: Vec<State>,
    last: State,
    /// What the states of the finished steps and the last one can be restored from.
    finished: Vec<Kept>,
}

impl<'a, 'o> Run<'a, 'o> {
    fn new(model: Model<'a>, expected: Expected, observer: &'o mut dyn Observer) -> Self {
        let rows = model.rows.len();
        let mut counters = Counters::default();
        counters.measure(&model);
        let history = History::virgin(&model);
        let point = Point {
            step: 0,
            time: 0.0,
            x: vec![0.0; model.dofs.len()],
            nodes: vec![Node::default(); rows],
            cautious: false,
        };
        let wanted = model.scene.controls.increment_error;
        Self {
            expected: Expected {
                divided: model.is_divided(),
                ..expected
            },
            companion: wanted.then(|| Companion::at(&point, &history)),
            beside: Beside::default(),
            history,
            point,
            sights: Vec::new(),
            solver: LinearSolver::default(),
            guess: None,
            end: None,
            asked: false,
            held_back: false,
            size: 0.0,
            cut: false,
            states: Vec::new(),
            last: State::default(),
            finished: Vec::new(),
            counters,
            model,
            observer,
        }
    }

    fn untouched(&self) -> Vec<String> {
        let pairs = self.model.scene.contacts.iter().enumerate();
        pairs
            .filter(|(index, _)| {
                let mut rows = self.model.rows.iter().chain(&self.model.spare);
                !rows.any(|r| r.pair == *index)
            })
            .map(|(_, pair)| pair.name.clone())
            .collect()
    }

    /// Returns false where the observer cancelled.
    fn all_steps(&mut self) -> Result<bool, SolveError> {
        let done = usize::from(self.point.time >= 1.0);
        for step in self.point.step + done..self.model.scene.steps.len() {
            if !self.one_step(step)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// What went wrong, if only the taking off of the load did. What is left of the answer stands; where next to
    /// no load was left, it counts as taken off.
    fn stuck(&mut self, error: &SolveError) -> Option<String> {
        let scene = self.model.scene;
        let full = scene.before_unloading()?;
        let unloads = self.states.len() > full && self.last.step > full;
        if !unloads || !error.is_of_balance() {
            return None;
        }
        let (step, time) = (self.last.step, self.last.time);
        let names = (scene.tractions.iter().map(|t| &t.name))
            .chain(scene.rigid_planes.iter().map(|p| &p.name))
            .chain(scene.supports.iter().map(|s| &s.name));
        let mut shares = names.map(|name| {
            let at = |step, time| self.model.scene.factor(name, step, time).abs();
            (at(step, time), at(full, 1.0))
        });
        if step + 1 == scene.steps.len() && shares.all(|(now, then)| now <= LITTLE * then) {
            self.states.push(self.last.clone());
        }
        Some(format!(
            "the load was taken off to {:.3} % of step `{}` only; what is said at full load stands ({error})",
            100.0 * time,
            scene.steps[step].name,
        ))
    }

    /// Share of a step that its first increment tries.
    fn first_increment(&self) -> f64 {
        let scene = self.model.scene;
        let yields = (0..scene.mesh.hexes.len() as u32).any(|e| can_yield(scene, e));
        let path_matters = yields || self.model.rows.iter().any(|r| r.law.friction > 0.0);
        match path_matters {
            true => scene.controls.first_increment,
            false => 1.0,
        }
    }

    /// Do this step and all that follow take the loads off?
    fn unloads(&self, step: usize) -> bool {
        let full = self.model.scene.before_unloading();
        full.is_some_and(|full| step > full)
    }

    fn one_step(&mut self, step: usize) -> Result<bool, SolveError> {
        let mut time = match self.point.step == step && self.point.time < 1.0 {
            true => self.point.time,
            false => 0.0,
        };
        if time == 0.0 {
            self.size = self.first_increment();
            self.point.cautious = false;
            self.counters.effort.before_step = self.counters.iterations;
        }
        let unloads = self.unloads(step);
        if unloads && time == 0.0 && !self.history.is_virgin() {
            self.settle()?;
        }
        if (step, time) == (0, 0.0) {
            self.come_to_rest(self.size.min(self.relief(step, time)))?;
        }
        while time < 1.0 {
            let spent = self.counters.iterations - self.counters.effort.before_step;
            if unloads && spent > UNLOADING {
                return Err(SolveError::Crawls {
                    step: self.model.scene.steps[step].name.clone(),
                    percent: 100.0 * time,
                    iterations: spent,
                });
            }
            let most = self.size.min(self.relief(step, time));
            let end = self.planned_end(step, time);
            let target = if time + 1.001 * most >= end {
                end
            } else {
                time + most
            };
            let mut trial = self.predict(step, target);
            self.touch(&mut trial);
            let before = self.counters.iterations;
            let result = newton::balance(
                &self.model,
                &self.history,
                (&mut trial, None),
                &mut self.solver,
                self.observer,
                &mut self.counters,
            );
            let iterations = self.counters.iterations - before;
            match result {
                Ok(evaluation) => {
                    if !std::mem::take(&mut self.cut) {
                        self.size = (GROWTH * self.size).min(LARGEST * self.first_increment());
                    }
                    let mut unforeseen = self.look(&trial, self.size / target);
                    if !self.look_ahead(&mut unforeseen, &trial) {
                        return Ok(false);
                    }
                    if unforeseen.missed {
                        self.counters.effort.unforeseen += iterations;
                        self.prepare_for(unforeseen, Some(&trial))?;
                        self.size = target - time;
                        continue;
                    }
                    self.accept(trial, &evaluation, target >= 1.0)?;
                    (self.asked, self.held_back) = (false, false);
                    time = target;
                    self.accompany();
                    if !unforeseen.is_empty() {
                        self.prepare_for(unforeseen, None)?;
                    }
                    if time >= 1.0 && !self.bring_companion() {
                        return Ok(false);
                    }
                    self.checkpoint()?;
                }
                Err(Stopped {
                    why: Failure::Cancelled,
                    ..
                }) => return Ok(false),
                Err(stopped) => {
                    self.counters.effort.given_up += iterations;
                    if !self.model.spare.is_empty() {
                        // Perhaps a body is held by contact that was left out.
                        self.expected.contact = f64::INFINITY;
                        self.rebuild(false, None)?;
                    }
                    let at = At {
                        step,
                        time,
                        iterations,
                    };
                    if !self.try_otherwise(&stopped, &at, target)? {
                        return Ok(false);
                    }
                }
            }
        }
        Ok(true)
    }

    /// After an increment to `target` has failed: makes another way to it, or a smaller increment, ready. False where
    /// the observer cancelled.
    fn try_otherwise(
        &mut self,
        stopped: &Stopped,
        at: &At,
        target: f64,
    ) -> Result<bool, SolveError> {
        let (step, time) = (at.step, at.time);
        // Where little flows it is not the plastic limit that takes balance away: a body may be free.
        let floats = !newton::much_flows(&self.model, &stopped.flowing);
        let begins = (step, time) == (0, 0.0);
        if floats && !self.asked {
            self.asked = true;
            if let Some(error) = no_balance(&self.model, (step, target), time) {
                return Err(error);
            }
        }
        self.size = target - time;
        // What was in balance a little before is a better guess than springs find: they come in where nothing
        // was, or where increments cannot be smaller.
        let least = self.model.scene.controls.smallest_increment;
        let least = if floats {
            least
        } else {
            least.max(LIMIT_KNOWN).max((1.0 - time) / MOST_LEFT)
        };
        let smallest = 0.5 * self.size < least;
        if floats && !self.held_back && (begins || (smallest && self.point.cautious)) {
            self.held_back = true;
            return Ok(self.hold_back(step, target));
        }
        // Caution with friction does not help where steel gives way.
        if !self.point.cautious && (floats || smallest) {
            self.point.cautious = true;
            return Ok(true);
        }
        if smallest {
            return Err(diagnose(&self.model, stopped, at));
        }
        self.size *= 0.5;
        self.cut = true;
        if !floats {
            // What was too much for the steel once will not become less.
            self.beside.plan = Some(Plan::even(step, [time, 1.0], self.size));
        }
        self.counters.cut_backs += 1;
        self.solver.forget();
        self.observer.message(&format!(
            "cut back to {:.3} % of the step: {}",
            100.0 * (time + self.size),
            describe(&stopped.why)
        ));
        Ok(true)
    }

    /// Finds a first guess at `target` with rigid bodies, where they find rest, and prepares all rows that press
    /// there.
    fn come_to_rest(&mut self, target: f64) -> Result<(), SolveError> {
        loop {
            let model = &self.model;
            let rows: Vec<_> = model.rows.iter().chain(&model.spare).collect();
            let factor = |name: &str| model.scene.factor(name, 0, target);
            let Some(mut rest) = rigid::at_rest(model.scene, &rows, &factor) else {
                return Ok(());
            };
            let spare = rest.nodes.split_off(model.rows.len());
            if spare.iter().any(|node| node.closed) {
                self.expected.contact = f64::INFINITY;
                self.rebuild(false, None)?;
                continue;
            }
            self.guess = Some(Point {
                x: model.unknowns(&rest.displacement),
                nodes: rest.nodes,
                ..self.point.clone()
            });
            // Where they rest they are in balance.
            self.asked = true;
            return Ok(());
        }
    }

    /// Finds a first guess at `target` with bodies that springs hold back. False where the observer cancelled.
    fn hold_back(&mut self, step: usize, target: f64) -> bool {
        self.observer
            .message("bodies are held back by springs that become weaker, for a first guess");
        let before = self.counters.iterations;
        let mut guess = self.predict(step, target);
        self.touch(&mut guess);
        let held = anchor::approach(
            &self.model,
            &self.history,
            &mut guess,
            &mut self.solver,
            self.observer,
            &mut self.counters,
        );
        self.guess = Some(guess);
        self.counters.effort.held_back += self.counters.iterations - before;
        held.is_ok()
    }

    /// Where the next increment has to end at the latest.
    fn planned_end(&self, step: usize, time: f64) -> f64 {
        let plan = self.beside.plan.iter().filter(|plan| plan.step == step);
        let mut ends = plan.flat_map(|plan| plan.ends.iter().copied());
        ends.find(|end| *end > time + 1e-6).unwrap_or(1.0)
    }

    /// The share of the step in which all loads fall to a third. Contact shrinks with the load: what
    /// is solved in one increment from full load to next to none changes beyond recognition.
    fn relief(&self, step: usize, time: f64) -> f64 {
        const LEFT: f64 = 1.0 / 3.0;
        let scene = self.model.scene;
        let names = (scene.tractions.iter().map(|t| &t.name))
            .chain(scene.rigid_planes.iter().map(|p| &p.name))
            .chain(scene.supports.iter().map(|s| &s.name));
        let now_and_then = names.map(|name| {
            let at = |time| self.model.scene.factor(name, step, time).abs();
            (at(time), at(1.0))
        });
        now_and_then
            .filter(|(now, _)| *now > 0.0)
            .map(|(now, then)| match then < LEFT * now {
                true => (1.0 - time) * (1.0 - LEFT) * now / (now - then),
                false => f64::INFINITY,
            })
            .reduce(f64::max)
            .unwrap_or(f64::INFINITY)
    }

    /// Share of a step that is done.
    fn stands(&self, step: usize) -> f64 {
        match self.point.step == step {
            true => self.point.time,
            false => 0.0,
        }
    }

    /// First guess at `target`: where things stand, or the elastic end of the step where that is nearer.
    /// On along the last increment would be worse: as contact grows bodies turn towards each other, and
    /// nodes that were closing part again.
    fn predict(&mut self, step: usize, target: f64) -> Point {
        let stands = self.stands(step);
        let nearer = |end: &mut Point| end.step == step && 1.0 - target < target - stands;
        let guess = self.guess.take();
        let guess = guess.or_else(|| self.end.take_if(nearer));
        Point {
            step,
            time: target,
            ..guess.unwrap_or_else(|| self.point.clone())
        }
    }

    /// Where nothing presses yet, lets the rows carry that all but touch: bodies float until then.
    fn touch(&self, trial: &mut Point) {
        let mut pressed = vec![false; self.model.scene.contacts.len()];
        let mut least = vec![f64::INFINITY; pressed.len()];
        for (r, node) in self.model.rows.iter().zip(&trial.nodes) {
            pressed[r.pair] |= node.closed;
            least[r.pair] = least[r.pair].min(r.row.gap);
        }
        let near = 0.02 * self.model.reach;
        for (r, node) in self.model.rows.iter().zip(&mut trial.nodes) {
            if !pressed[r.pair] && r.row.gap <= least[r.pair] + near {
                (node.closed, node.sticks) = (true, true);
            }
        }
    }
}
