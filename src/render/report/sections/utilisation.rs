//! How much of what the steel can take is used: figure, limit, share and its error.

use crate::answer::certify::Quantity;
use crate::render::report::Inputs;
use crate::render::text::significant;

/// A figure over its limit.
#[derive(Debug, Clone, PartialEq)]
pub struct Utilisation {
    pub what: String,
    pub place: String,
    pub value: f64,
    pub limit: f64,
    /// Estimated error of the figure; none where nothing is known.
    pub error: Option<f64>,
    /// Does the certificate know the error, or say nothing of such a figure?
    pub resolved: bool,
    /// What the limit is.
    pub against: &'static str,
}

impl Utilisation {
    pub fn share(&self) -> f64 {
        self.value / self.limit
    }

    pub fn share_error(&self) -> Option<f64> {
        self.error.map(|error| error / self.limit)
    }
}

/// Every body against its yield stress, then every line of contact against (2-49).
pub fn utilisations(inputs: &Inputs) -> Vec<Utilisation> {
    let mut all = mises(inputs);
    all.extend(lines(inputs));
    all
}

/// The largest.
pub fn largest(all: &[Utilisation]) -> Option<&Utilisation> {
    let counted = all.iter().filter(|u| u.share().is_finite());
    counted.max_by(|a, b| a.share().total_cmp(&b.share()))
}

/// The elastic peak where the body has yielded, away from loaded edges where it lies at one.
fn mises(inputs: &Inputs) -> Vec<Utilisation> {
    let answer = &inputs.summary.answer;
    let mut all = Vec::new();
    for (body, steel) in inputs.scene.mesh.bodies.iter().zip(&inputs.scene.materials) {
        if !steel.yield_stress.is_finite() {
            continue;
        }
        let of = |what| answer.figure(what, &body.name);
        let (peak, away) = match of(Quantity::ElasticPeakMises) {
            Some(peak) => (Some(peak), of(Quantity::ElasticMisesAway)),
            None => (of(Quantity::PeakMises), of(Quantity::MisesAway)),
        };
        // A peak at a loaded edge is a figure of the mesh.
        let Some(found) = away.or(peak) else { continue };
        all.push(Utilisation {
            what: found.what.name().to_string(),
            place: body.name.clone(),
            value: found.value,
            limit: steel.yield_stress,
            error: found.bar(),
            resolved: found.is_resolved(),
            against: "yield",
        });
    }
    all
}

fn lines(inputs: &Inputs) -> Vec<Utilisation> {
    let summary = inputs.summary;
    let Some(sizing) = &summary.sizing else {
        return Vec::new();
    };
    let mut all = Vec::new();
    for line in &sizing.lines {
        let Some(limit) = line.limit else { continue };
        let (at, unit) = (significant(line.across, 3), &summary.units.length);
        all.push(Utilisation {
            what: "Hertz p0 under the largest line load".to_string(),
            place: format!("{}, line at {at} {unit}", line.interface),
            value: line.hertz_pressure,
            limit,
            error: None,
            resolved: true,
            against: "1.65 yield, (2-49)",
        });
    }
    all
}
