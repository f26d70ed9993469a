//! How much of what the steel can take is used: figure, limit, share and its error.

use crate::certify::Quantity;
use crate::output::report::Inputs;
use crate::output::report::figures::claim;
use crate::output::text::significant;

/// A figure over its limit.
#[derive(Debug, Clone, PartialEq)]
pub struct Utilisation {
    pub what: String,
    pub place: String,
    pub value: f64,
    pub limit: f64,
    /// Estimated error of the figure; none where nothing is known.
    pub error: Option<f64>,
    /// What the limit is.
    pub against: &'static str,
    /// Does it count for the largest?
    pub counts: bool,
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

/// The largest that counts.
pub fn largest(all: &[Utilisation]) -> Option<&Utilisation> {
    let counted = all.iter().filter(|u| u.counts && u.share().is_finite());
    counted.max_by(|a, b| a.share().total_cmp(&b.share()))
}

/// The elastic peak where the body has yielded; the one away from loaded edges beside a peak that
/// belongs to the mesh.
fn mises(inputs: &Inputs) -> Vec<Utilisation> {
    let claims = &inputs.summary.certificate;
    let mut all = Vec::new();
    for (body, steel) in inputs.scene.mesh.bodies.iter().zip(&inputs.scene.materials) {
        if !steel.yield_stress.is_finite() {
            continue;
        }
        let of = |what| claim(claims, what, &body.name);
        let (peak, away) = match of(Quantity::ElasticPeakMises) {
            Some(peak) => (Some(peak), of(Quantity::ElasticMisesAway)),
            None => (of(Quantity::PeakMises), of(Quantity::MisesAway)),
        };
        for found in [peak, away].into_iter().flatten() {
            let at_edge = peak == Some(found) && away.is_some();
            all.push(Utilisation {
                what: found.what.name().to_string(),
                place: body.name.clone(),
                value: found.value,
                limit: steel.yield_stress,
                error: found.error.total(),
                against: match at_edge {
                    true => "yield; at a loaded edge, a figure of this mesh",
                    false => "yield",
                },
                counts: !at_edge,
            });
        }
    }
    all
}

fn lines(inputs: &Inputs) -> Vec<Utilisation> {
    let summary = inputs.summary;
    let Some(sizing) = &summary.sizing else {
        return Vec::new();
    };
    let mut all: Vec<Utilisation> = Vec::new();
    for line in &sizing.lines {
        let Some(limit) = line.limit else { continue };
        let (at, unit) = (significant(line.across, 3), &summary.units.length);
        all.push(Utilisation {
            what: "Hertz p0 under the largest line load".to_string(),
            place: format!("{}, line at {at} {unit}", line.interface),
            value: line.hertz_pressure,
            limit,
            error: None,
            against: "1.65 yield, (2-49)",
            counts: true,
        });
    }
    for line in &sizing.lines {
        let computed = claim(
            &summary.certificate,
            Quantity::PeakPressure,
            &line.interface,
        );
        let (Some(limit), Some(computed)) = (line.limit, computed) else {
            continue;
        };
        let known = |u: &Utilisation| u.place == line.interface;
        if !all.iter().any(known) {
            all.push(Utilisation {
                what: "peak pressure, computed".to_string(),
                place: line.interface.clone(),
                value: computed.value,
                limit,
                error: computed.error.total(),
                against: "1.65 yield, beside (2-49)",
                counts: false,
            });
        }
    }
    all
}
