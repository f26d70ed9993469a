//! A mesh on the way to a target.

use super::goal::{Goal, Target};
use crate::answer::certify::{self, Quantity};
use crate::product::converge::cost::Cost;
use crate::render::Summary;
use crate::render::table::text::text;
use crate::render::table::{Cell, Table};
use crate::render::text::significant;

/// A figure that the target is about, on one mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct RefinedFigure {
    /// Which goal it answers.
    pub goal: Goal,
    pub what: Quantity,
    pub place: String,
    pub value: f64,
    /// The certificate's error; `None` where none can be given.
    pub estimate: Option<f64>,
    /// Of a peak next to a singular edge: what of that the edge does, which elements along the line of contact decide.
    pub beside_edge: Option<f64>,
    /// Difference from the mesh before.
    pub change: Option<f64>,
    /// Does it lie at a singular edge?
    pub at_edge: bool,
    /// The elastic twin that it is of, where steel flows.
    pub of: Option<TwinMesh>,
}

/// A mesh of the elastic twin.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TwinMesh {
    pub level: usize,
    pub unknowns: usize,
}

/// One mesh, solved.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    pub level: usize,
    /// Is it of the elastic twin, loaded only?
    pub twin: bool,
    pub unknowns: usize,
    pub figures: Vec<RefinedFigure>,
    /// Goals that there is no figure for, such as Hertz's pressure where steel flows.
    pub absent: Vec<Goal>,
    /// Larger figures beside singular edges, which are not judged.
    pub beside_edges: Vec<RefinedFigure>,
    /// Do its bars alone decide? Else the change from the mesh before must be small, too.
    pub bars_decide: bool,
    pub cost: Cost,
    pub summary: Summary,
}

/// Plastic strain may err by this many times the target of the stress: it is what the stress would
/// exceed the yield limit by, so that a percent of the one is several of the other.
const STRAIN_TO_STRESS: f64 = 5.0;

impl RefinedFigure {
    /// An error relative to the value, as a percentage.
    pub fn share(&self, error: Option<f64>) -> String {
        match error.filter(|_| self.value != 0.0) {
            Some(error) => format!("{} %", significant(100.0 * error / self.value, 2)),
            None => "-".to_owned(),
        }
    }

    /// The estimated error over the figure in words, or that there is none.
    pub fn estimate_in_words(&self) -> String {
        match self.estimate {
            None => "unresolved".to_owned(),
            error => self.share(error),
        }
    }

    /// What and where, with its error.
    fn in_words(&self) -> String {
        let (what, place) = (self.what.name(), &self.place);
        let value = significant(self.value, 4);
        match self.estimate {
            None => format!("{what} of {place}, {value}, unresolved"),
            error => format!("{what} of {place}, {value} ± {}", self.share(error)),
        }
    }

    /// The largest error that the target leaves it.
    pub(super) fn allowed(&self, target: &Target) -> f64 {
        let within = match (target.goal, self.goal) {
            (Goal::Mises, Goal::PlasticStrain) => STRAIN_TO_STRESS * target.within,
            _ => target.within,
        };
        within * self.value.abs()
    }

    /// Is the estimated error within the target, and unless bars decide alone the change from the mesh before?
    pub fn meets(&self, target: &Target, bars_decide: bool) -> bool {
        let allowed = self.allowed(target);
        let small = |error: Option<f64>| error.is_some_and(|e| e.abs() <= allowed);
        small(self.estimate) && (bars_decide || small(self.change))
    }
}

impl Level {
    pub(super) fn new(
        level: usize,
        (target, bars_decide): (&Target, bool),
        summary: &Summary,
        before: Option<&Self>,
        cost: Cost,
    ) -> Self {
        let mut figures = Vec::new();
        let mut absent = Vec::new();
        let mut beside_edges = Vec::new();
        for goal in single(target.goal, &summary.answer.certificate) {
            let Some(claim) = claim(goal, &summary.answer.certificate) else {
                absent.push(goal);
                continue;
            };
            let old = before.and_then(|level| level.value_of(goal));
            let figure = |claim: &certify::Figure, old: Option<f64>| RefinedFigure {
                goal,
                what: claim.what,
                place: claim.place.clone(),
                value: claim.value,
                estimate: claim.bar(),
                beside_edge: claim.error.beside_edge,
                change: old.map(|old| claim.value - old),
                at_edge: claim.at_edge,
                of: None,
            };
            figures.push(figure(claim, old));
            let is_same =
                |what: Quantity| what == claim.what || what.away_from_edges() == Some(claim.what);
            let same = (summary.answer.certificate.iter()).filter(|c| is_same(c.what));
            let larger = same.filter(|c| c.at_edge && !claim.at_edge && c.value > claim.value);
            let largest = larger.max_by(|a, b| a.value.total_cmp(&b.value));
            beside_edges.extend(largest.map(|claim| figure(claim, None)));
        }
        Self {
            level,
            twin: false,
            unknowns: summary.counters.dofs,
            figures,
            absent,
            beside_edges,
            bars_decide,
            cost,
            summary: summary.clone(),
        }
    }

    /// Takes over what is elastic from the twin, where steel flows.
    pub(super) fn take_elastic(&mut self, twin: &Self) {
        let of = Some(TwinMesh {
            level: twin.level,
            unknowns: twin.unknowns,
        });
        for figure in twin.figures.iter().filter(|f| f.goal.is_elastic()) {
            let taken = RefinedFigure {
                of,
                ..figure.clone()
            };
            match self.figures.iter_mut().find(|f| f.goal == figure.goal) {
                Some(own) => {
                    *own = RefinedFigure {
                        what: own.what,
                        ..taken
                    }
                }
                None => self.figures.push(taken),
            }
            self.absent.retain(|goal| *goal != figure.goal);
        }
    }

    /// The figure that answers `goal` on this mesh.
    pub(super) fn figure_of(&self, goal: Goal) -> Option<&RefinedFigure> {
        self.figures.iter().find(|f| f.goal == goal)
    }

    /// Its value.
    pub fn value_of(&self, goal: Goal) -> Option<f64> {
        self.figure_of(goal).map(|f| f.value)
    }

    /// Is all that was asked for, and that there is, as good as asked for?
    pub fn meets(&self, target: &Target) -> bool {
        let mut figures = self.figures.iter();
        !self.figures.is_empty() && figures.all(|f| f.meets(target, self.bars_decide))
    }
}

/// The single goals that a goal is made of.
fn single(goal: Goal, certificate: &[certify::Figure]) -> Vec<Goal> {
    let flows = (certificate.iter()).any(|c| c.what == Quantity::PeakPlasticStrain);
    match goal {
        Goal::Certified => Goal::CERTIFIED.to_vec(),
        Goal::Mises if flows => vec![Goal::ElasticMises, Goal::PlasticStrain],
        Goal::Mises => vec![Goal::ElasticMises],
        one => vec![one],
    }
}

/// The claim that a single goal is about: the largest away from singular edges, with a bar or without. One at a singular edge
/// where there is no other. Of Mises peaks the largest without a bar, where there is one: it may be larger than it reads.
fn claim(goal: Goal, certificate: &[certify::Figure]) -> Option<&certify::Figure> {
    let among = |names: &[Quantity]| -> Vec<&certify::Figure> {
        let claims = certificate.iter().filter(|c| names.contains(&c.what));
        claims
            .filter(|c| !certify::is_replaced(certificate, c))
            .collect()
    };
    match goal {
        Goal::Certified => None,
        Goal::Mises | Goal::ElasticMises => {
            let elastic = [Quantity::ElasticPeakMises, Quantity::ElasticMisesAway];
            let plastic = [Quantity::PeakMises, Quantity::MisesAway];
            let peak = |names: &[Quantity]| {
                let unsure = among(names)
                    .into_iter()
                    .filter(|c| !c.is_resolved() && !c.at_edge);
                largest(unsure.collect()).or_else(|| largest(among(names)))
            };
            peak(&elastic).or_else(|| peak(&plastic))
        }
        Goal::PlasticStrain => largest(among(&[Quantity::PeakPlasticStrain])),
        Goal::Pressure => largest(among(&[Quantity::PeakPressure, Quantity::PressureAway])),
        Goal::HertzPressure => largest(among(&[Quantity::HertzPressure])),
        Goal::LineLoad => largest(among(&[Quantity::LineLoad, Quantity::LineLoadAway])),
        Goal::Bore => largest(among(&[Quantity::BoreMises])),
        Goal::HalfWidth => largest(among(&[Quantity::HalfWidth])),
        Goal::Area => largest(among(&[Quantity::ContactArea])),
        Goal::Descent => largest(among(&[Quantity::Descent])),
    }
}

/// Error against run time, mesh by mesh.
pub fn table(levels: &[Level]) -> String {
    let mut table = Table::new("")
        .words("Mesh")
        .figures(["unknowns", "figure", "where", "value"])
        .figures(["± estimate", "change", "wall s", "CPU s"]);
    for level in levels {
        for figure in &level.figures {
            let (number, unknowns) = match figure.of {
                Some(twin) => (twin.level, twin.unknowns),
                None => (level.level, level.unknowns),
            };
            table.row([
                match level.twin || figure.of.is_some() {
                    true => format!("{number}, elastic").into(),
                    false => number.into(),
                },
                unknowns.into(),
                figure.what.name().into(),
                (&figure.place).into(),
                Cell::figure(figure.value),
                Cell::Text(figure.estimate_in_words()),
                figure.share(figure.change).into(),
                Cell::rough(level.cost.wall_s),
                Cell::rough(level.cost.cpu_s),
            ]);
        }
    }
    let mut out = text(&table);
    let absent = levels.last().map_or(&[][..], |level| &level.absent);
    if !absent.is_empty() {
        let names: Vec<&str> = absent.iter().map(|goal| goal.name()).collect();
        out += &format!(
            "Not asked for, as this answer has none: {}\n",
            names.join(", ")
        );
    }
    let edges = levels.last().map_or(&[][..], |level| &level.beside_edges);
    if !edges.is_empty() {
        let told: Vec<String> = edges.iter().map(RefinedFigure::in_words).collect();
        out += &format!(
            "Not judged, as beside a singular edge: {}\n",
            told.join("; ")
        );
    }
    out
}

/// The largest claim; of those beside a singular edge only where there is no other.
fn largest(claims: Vec<&certify::Figure>) -> Option<&certify::Figure> {
    let (edge, away): (Vec<_>, Vec<_>) = claims.into_iter().partition(|claim| claim.at_edge);
    let of = if away.is_empty() { edge } else { away };
    of.into_iter().max_by(|a, b| a.value.total_cmp(&b.value))
}
