//! A mesh on the way to a target.

use super::{Goal, Target};
use crate::answer::certify::{self, Quantity};
use crate::product::converge::cost::Cost;
use crate::render::Summary;
use crate::render::table::text::text;
use crate::render::table::{Cell, Table};
use crate::render::text::significant;

/// A figure that the target is about, on one mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    pub what: Quantity,
    pub place: String,
    pub value: f64,
    /// The certificate's error; `None` where none can be given.
    pub estimate: Option<f64>,
    /// Difference from the mesh before.
    pub change: Option<f64>,
}

/// One mesh, solved.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    pub level: usize,
    pub unknowns: usize,
    pub figures: Vec<Figure>,
    pub cost: Cost,
    pub summary: Summary,
}

/// Plastic strain may err by this many times the target of the stress: it is what the stress would
/// exceed the yield limit by, so that a percent of the one is several of the other.
const STRAIN_TO_STRESS: f64 = 5.0;

impl Figure {
    /// An error relative to the value, as a percentage.
    pub fn share(&self, error: Option<f64>) -> String {
        match error.filter(|_| self.value != 0.0) {
            Some(error) => format!("{} %", significant(100.0 * error / self.value, 2)),
            None => "-".to_owned(),
        }
    }

    /// Are the estimated error and the change from the mesh before within the target?
    pub fn meets(&self, target: &Target) -> bool {
        let within = match (target.goal, self.what) {
            (Goal::Mises, Quantity::PeakPlasticStrain) => STRAIN_TO_STRESS * target.within,
            _ => target.within,
        };
        let small =
            |error: Option<f64>| error.is_some_and(|e| e.abs() <= within * self.value.abs());
        small(self.estimate) && small(self.change)
    }
}

impl Level {
    pub(super) fn new(
        level: usize,
        target: &Target,
        summary: &Summary,
        before: Option<&Self>,
        cost: Cost,
    ) -> Self {
        let figures = figures(target.goal, &summary.answer.certificate).into_iter();
        let figures = figures.map(|claim| {
            let mut figure = Figure {
                what: claim.what,
                place: claim.place.clone(),
                value: claim.value,
                estimate: claim.bar(),
                change: None,
            };
            let old = before.and_then(|level| level.value_of(&figure));
            figure.change = old.map(|old| figure.value - old);
            figure
        });
        Self {
            level,
            unknowns: summary.counters.dofs,
            figures: figures.collect(),
            cost,
            summary: summary.clone(),
        }
    }

    /// The same figure on this mesh; its place may be another one.
    pub fn value_of(&self, figure: &Figure) -> Option<f64> {
        let kind = |f: &Figure| f.what == Quantity::PeakPlasticStrain;
        let same = self.figures.iter().find(|f| kind(f) == kind(figure));
        same.map(|f| f.value)
    }
}

/// The claims that a goal is about.
fn figures(goal: Goal, certificate: &[certify::Figure]) -> Vec<&certify::Figure> {
    let largest = |what: Quantity| {
        let claims = certificate.iter().filter(|c| c.what == what);
        claims.max_by(|a, b| a.value.total_cmp(&b.value))
    };
    // The largest of those with an error bar; one at a loaded edge where there is no other.
    let regular = |names: [Quantity; 2]| {
        let claims = certificate.iter().filter(|c| names.contains(&c.what));
        let (sure, unsure): (Vec<_>, Vec<_>) = claims.partition(|claim| claim.is_resolved());
        let claims = if sure.is_empty() { unsure } else { sure };
        (claims.into_iter()).max_by(|a, b| a.value.total_cmp(&b.value))
    };
    let one = |what: Quantity| largest(what).into_iter().collect();
    match goal {
        Goal::Mises => match largest(Quantity::PeakPlasticStrain) {
            Some(strain) => regular([Quantity::ElasticPeakMises, Quantity::ElasticMisesAway])
                .into_iter()
                .chain([strain])
                .collect(),
            None => regular([Quantity::PeakMises, Quantity::MisesAway])
                .into_iter()
                .collect(),
        },
        Goal::PlasticStrain => one(Quantity::PeakPlasticStrain),
        Goal::Pressure => one(Quantity::PeakPressure),
        Goal::HalfWidth => one(Quantity::HalfWidth),
        Goal::Area => one(Quantity::ContactArea),
        Goal::Descent => one(Quantity::Descent),
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
            let estimate = figure.estimate.map(|_| figure.share(figure.estimate));
            table.row([
                level.level.into(),
                level.unknowns.into(),
                figure.what.name().into(),
                (&figure.place).into(),
                Cell::figure(figure.value),
                estimate.map_or("unresolved".into(), Cell::Text),
                figure.share(figure.change).into(),
                Cell::rough(level.cost.wall_s),
                Cell::rough(level.cost.cpu_s),
            ]);
        }
    }
    text(&table)
}
