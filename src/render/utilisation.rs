//! How much of what the steel can take is used: figure, limit, share and its error.

use crate::render::summary::{SizedPatch, Summary};
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

/// Every body against its yield stress, then every line of contact against (2-49), every patch against first yield.
pub fn utilisations(summary: &Summary) -> Vec<Utilisation> {
    let mut all = mises(summary);
    all.extend(lines(summary));
    all.extend(patches(summary));
    all
}

/// The largest; the first of those that only rounding tells apart.
pub fn largest(all: &[Utilisation]) -> Option<&Utilisation> {
    first_largest(
        all.iter().filter(|u| u.share().is_finite()),
        Utilisation::share,
    )
}

/// Of values that symmetry makes equal the first.
pub fn first_largest<'a, T>(
    all: impl Iterator<Item = &'a T> + Clone,
    value: impl Fn(&T) -> f64,
) -> Option<&'a T> {
    const TIE: f64 = 1e-6;
    let most = all.clone().map(&value).fold(f64::NEG_INFINITY, f64::max);
    let mut all = all;
    all.find(|one| value(one) >= most - TIE * most.abs())
}

/// Every body whose steel can yield.
fn mises(summary: &Summary) -> Vec<Utilisation> {
    let answer = &summary.answer;
    let mut all = Vec::new();
    for (name, body) in &answer.bodies.0 {
        let Some(limit) = body.yield_stress else {
            continue;
        };
        let Some(found) = answer.elastic_mises(name) else {
            continue;
        };
        all.push(Utilisation {
            what: found.what.name().to_string(),
            place: name.clone(),
            value: found.value,
            limit,
            error: found.bar(),
            resolved: found.is_resolved(),
            against: "yield",
        });
    }
    all
}

/// Of the radius, what a place is off the middle by rounding.
const ROUNDING: f64 = 1e-9;

fn lines(summary: &Summary) -> Vec<Utilisation> {
    let Some(sizing) = &summary.sizing else {
        return Vec::new();
    };
    let mut all = Vec::new();
    for line in &sizing.lines {
        let Some(limit) = line.limit else { continue };
        // In the middle but for rounding.
        let across = if line.across.abs() > ROUNDING * line.relative_radius {
            line.across
        } else {
            0.0
        };
        let (at, unit) = (significant(across, 3), &summary.units.length);
        all.push(Utilisation {
            what: "Hertz p0 under the largest line load".to_string(),
            place: format!("{}, line at {at} {unit}", line.interface),
            value: line.hertz_pressure,
            limit,
            error: line.error.map(|share| share * limit),
            resolved: line.error.is_some(),
            against: "1.65 yield, (2-49)",
        });
    }
    all
}

fn patches(summary: &Summary) -> Vec<Utilisation> {
    let patches = summary.sizing.iter().flat_map(|sizing| &sizing.patches);
    let of = |patch: &SizedPatch| {
        Some(Utilisation {
            what: "Hertz p0".to_string(),
            place: format!("{}, patch", patch.interface),
            value: patch.hertz_pressure,
            limit: patch.first_yield?,
            error: None,
            resolved: true,
            against: "first yield below a patch",
        })
    };
    patches.filter_map(of).collect()
}
