//! The sizing rules of the reference study, (2-49) to (2-51), beside the loads that a run found.
//!
//! The rules take the load as spread evenly along the roller, on one line. A run knows how much
//! each line carries and where: (2-49) is asked of each line under its largest load per length,
//! and under its even one. A line that misses is told, and decides nothing.

use super::JobError;
use crate::analytic::hertz::LineContact;
use crate::analytic::sizing::{
    Constants, PRESSURE_LIMIT, PRINTED, effective_length, equivalent_modulus, exact, final_length,
    within_limit,
};
use crate::analytic::{DomainError, Elastic, contact_compliance};
use crate::case::{BearingCase, Case, Kind};
use crate::material::Steel;
use crate::output::Summary;
use crate::output::summary::{Demand, EvenLoad, LineSummary, SizedLine, Sizing, SizingRule};
use crate::scene::Scene;

/// What the rules say of a bearing; nothing of a general scene.
pub fn sizing(case: &Case, scene: &Scene, summary: &Summary) -> Result<Option<Sizing>, JobError> {
    match &case.kind {
        Kind::Bearing(bearing) => sized(bearing, scene, summary).map(Some),
        Kind::General(_) => Ok(None),
    }
    .map_err(|error: DomainError| JobError::ClosedForm {
        what: "the sizing of the rollers".to_owned(),
        why: error.to_string(),
    })
}

fn sized(bearing: &BearingCase, scene: &Scene, summary: &Summary) -> Result<Sizing, DomainError> {
    let mut rule: Option<SizingRule> = None;
    let mut lines = Vec::new();
    for (name, interface) in &summary.interfaces.0 {
        let Some(steels) = steels(scene, name) else {
            continue;
        };
        let pair = Pair::new(bearing.geometry.radius(), steels)?;
        for line in &interface.lines {
            lines.push(pair.line(name, line, bearing.geometry.length)?);
        }
        let demanded = |rule: &SizingRule| rule.exact.required_diameter_times_length;
        if let Some(asked) = pair.rule(name, bearing)?
            && rule.as_ref().is_none_or(|r| demanded(r) < demanded(&asked))
        {
            rule = Some(asked);
        }
    }
    Ok(Sizing { rule, lines })
}

/// The steels of the two bodies of the interface `<upper>-<lower>`.
fn steels<'s>(scene: &'s Scene, interface: &str) -> Option<[&'s Steel; 2]> {
    let (upper, lower) = interface.split_once('-')?;
    let steel = |body: &str| scene.materials.get(scene.mesh.body(body)?);
    Some([steel(upper)?, steel(lower)?])
}

/// A roller and what it presses on.
struct Pair {
    radius: f64,
    /// C_E of (2-46).
    compliance: f64,
    /// The lower yield stress, where either side can yield.
    yield_stress: Option<f64>,
}

impl Pair {
    fn new(radius: f64, steels: [&Steel; 2]) -> Result<Self, DomainError> {
        let elastic = |steel: &Steel| Elastic::new(steel.youngs_modulus, steel.poissons_ratio);
        let [upper, lower] = steels;
        let lowest = upper.yield_stress.min(lower.yield_stress);
        Ok(Self {
            radius,
            compliance: contact_compliance(elastic(upper)?, elastic(lower)?)?,
            yield_stress: lowest.is_finite().then_some(lowest),
        })
    }

    /// p0 = √(q / π R C_E), its share of the limit, and whether (2-49) is met.
    fn pressed(&self, line_load: f64) -> Result<EvenLoad, DomainError> {
        let p0 = LineContact::new(line_load, self.radius, self.compliance)?.peak_pressure;
        let met = self.yield_stress.map(|y| within_limit(p0, y));
        Ok(EvenLoad {
            line_load,
            hertz_pressure: p0,
            utilisation: self.limit().map(|limit| p0 / limit),
            met: met.transpose()?,
        })
    }

    fn limit(&self) -> Option<f64> {
        self.yield_stress.map(|y| PRESSURE_LIMIT * y)
    }

    fn line(
        &self,
        interface: &str,
        line: &LineSummary,
        roller: f64,
    ) -> Result<SizedLine, DomainError> {
        let peak = self.pressed(line.peak)?;
        let force = line.mean * (line.length + line.lifted_off);
        Ok(SizedLine {
            interface: interface.to_owned(),
            across: line.across,
            images: line.images,
            peak_line_load: line.peak,
            at: line.peak_at,
            from_end: (0.5 * roller - line.peak_at.abs()).max(0.0),
            hertz_pressure: peak.hertz_pressure,
            limit: self.limit(),
            utilisation: peak.utilisation,
            met: peak.met,
            even: self.pressed(force / roller)?,
        })
    }

    /// (2-50) and (2-51) for one roller under the whole load.
    fn rule(
        &self,
        interface: &str,
        bearing: &BearingCase,
    ) -> Result<Option<SizingRule>, DomainError> {
        let Some(yield_stress) = self.yield_stress else {
            return Ok(None);
        };
        let g = &bearing.geometry;
        let modulus = equivalent_modulus(self.compliance)?;
        let effective = effective_length(g.length, g.offset)?;
        let demand = |constants: Constants| -> Result<Demand, DomainError> {
            let required =
                constants.required_diameter_times_length(bearing.load, modulus, yield_stress)?;
            let provided = g.diameter * effective;
            Ok(Demand {
                constant: constants.sizing,
                required_diameter_times_length: required,
                provided,
                required_length: final_length(required / g.diameter, g.offset)?,
                met: provided >= required,
            })
        };
        Ok(Some(SizingRule {
            interface: interface.to_owned(),
            load: bearing.load,
            diameter: g.diameter,
            length: g.length,
            displacement: g.offset,
            effective_length: effective,
            printed: demand(PRINTED)?,
            exact: demand(exact())?,
        }))
    }
}
