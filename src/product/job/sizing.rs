//! The sizing rules of the reference study, (2-49) to (2-51), beside the loads that a run found.
//!
//! The rules take the load as spread evenly along the roller, on one line. A run knows how much
//! each line carries and where: (2-49) is asked of each line under its largest load per length,
//! and under its even one. A line that misses is told, and decides nothing.

use super::error::JobError;
use super::rollers::{Span, TIE, bearing_length, is_merged};
use crate::analytic::DomainError;
use crate::analytic::hertz::LineContact;
use crate::analytic::rules::{RuleVerdict, Standing};
use crate::analytic::sizing::{
    Constants, PRESSURE_LIMIT, PRINTED, effective_length, equivalent_modulus, exact, final_length,
    within_limit,
};
use crate::answer::{Answer, LineFigures, PatchFigures};
use crate::case::bearing::Seat;
use crate::case::{BearingCase, Case, Kind};
use crate::model::material::Steel;
use crate::model::scene::Scene;
use crate::render::summary::{Demand, EvenLoad, SizedLine, SizedPatch, Sizing, SizingRule};
use std::f64::consts::FRAC_1_SQRT_2;

/// What the rules say of the lines of contact, and first yield of the patches; `None` where a general scene has neither.
pub fn sizing(case: &Case, scene: &Scene, answer: &Answer) -> Result<Option<Sizing>, JobError> {
    let sizing = sized(case, scene, answer).map_err(|error| JobError::ClosedForm {
        what: "the sizing of the rollers".to_owned(),
        why: error.to_string(),
    })?;
    let says_nothing = sizing.lines.is_empty() && sizing.patches.is_empty();
    let is_bearing = matches!(case.kind, Kind::Bearing(_));
    Ok(Some(sizing).filter(|_| is_bearing || !says_nothing))
}

fn sized(case: &Case, scene: &Scene, answer: &Answer) -> Result<Sizing, DomainError> {
    let mut sizing = Sizing::default();
    for (contact, (name, interface)) in scene.contacts.iter().zip(&answer.interfaces.0) {
        let steels = [&contact.upper, &contact.lower]
            .map(|side| scene.materials.get(side.body(&scene.mesh)?));
        if let Some(patch) = &interface.patch {
            sizing.patches.push(sized_patch(name, patch, steels));
            continue;
        }
        let pair = |radius| -> Result<SizedPair, DomainError> {
            Ok(SizedPair::new(radius, scene.compliance(contact)?, steels))
        };
        let bar = answer.hertz_pressure_bar(name);
        for line in &interface.lines {
            let span = Span::of(scene, contact, line);
            let (radius, [length, from_end]) = match (&case.kind, line.relative_radius) {
                (Kind::Bearing(bearing), _) => {
                    let Some(seat) = bearing.seat(name) else {
                        continue;
                    };
                    let from_end = (seat.ends_at - line.peak_at.abs()).max(0.0);
                    let bears = bearing_length(&seat, bearing.geometry.offset());
                    (seat.radius, [bears, from_end])
                }
                (Kind::General(_), Some(radius)) => {
                    (radius, [span.length(), span.distance_to_end(line.peak_at)])
                }
                (Kind::General(_), None) => continue,
            };
            let is_heaviest = interface.largest_line_load == Some(line.peak);
            let merged = is_merged(case, (name, interface), line);
            sizing.lines.push(SizedLine {
                not_hertz: interface.not_hertz.filter(|_| is_heaviest),
                ..pair(radius)?.line(name, line, [length, from_end], (bar, merged))?
            });
        }
        let Some(bearing) = case.bearing() else {
            continue;
        };
        let used =
            |rule: &SizingRule| rule.exact.required_diameter_times_length / rule.exact.provided;
        let Some(seat) = bearing.seat(name) else {
            continue;
        };
        let pair = pair(seat.radius)?;
        // Rollers side by side share the load as balance has it, not evenly.
        let load = match seat.sharing {
            1 => bearing.load,
            _ => interface.pressure_integral,
        };
        // A roller that has lifted off asks for nothing.
        if load <= 0.0 {
            continue;
        }
        if let Some(asked) = pair.rule(&seat, bearing, load)?
            && (sizing.rule.as_ref()).is_none_or(|r| TIE * used(r) < used(&asked))
        {
            sizing.rule = Some(asked);
        }
    }
    Ok(sizing)
}

/// A patch, its peak pressure beside that at which steel below it first yields.
fn sized_patch(name: &str, patch: &PatchFigures, steels: [Option<&Steel>; 2]) -> SizedPatch {
    let sides = steels.iter().zip(patch.mises_over_p0);
    let yields = sides.filter_map(|(steel, share)| Some(steel.as_ref()?.yield_stress / share?));
    let limit = Some(yields.fold(f64::INFINITY, f64::min)).filter(|limit| limit.is_finite());
    SizedPatch {
        interface: name.to_owned(),
        images: patch.images,
        force: patch.force,
        relative_radii: patch.relative_radii,
        semi_axes: patch.semi_axes,
        hertz_pressure: patch.hertz_p0,
        first_yield: limit,
        utilisation: limit.map(|limit| patch.hertz_p0 / limit),
        not_hertz: patch.departs,
    }
}

/// A roller and what it presses on.
struct SizedPair {
    radius: f64,
    /// C_E of (2-46).
    compliance: f64,
    /// The lower yield stress, where either side can yield.
    yield_stress: Option<f64>,
}

impl SizedPair {
    /// Of the steels of both sides; a side without one is rigid.
    fn new(radius: f64, compliance: f64, steels: [Option<&Steel>; 2]) -> Self {
        let lowest = steels.into_iter().flatten();
        let lowest = lowest.fold(f64::INFINITY, |lowest, steel| {
            lowest.min(steel.yield_stress)
        });
        Self {
            radius,
            compliance,
            yield_stress: lowest.is_finite().then_some(lowest),
        }
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
        line: &LineFigures,
        [bears, from_end]: [f64; 2],
        (bar, merged): (Option<f64>, bool),
    ) -> Result<SizedLine, DomainError> {
        let peak = self.pressed(line.peak)?;
        let bar = bar.filter(|_| !merged);
        let error = peak.utilisation.zip(bar).map(|(used, bar)| used * bar);
        let verdict = |used: f64| match error {
            // Of two lines in one, each carries half of the load at least when both are alike, and all of it at most.
            _ if merged => RuleVerdict::of(Standing::Rule, used * FRAC_1_SQRT_2, used),
            Some(error) => RuleVerdict::of(Standing::Rule, used - error, used + error),
            None => RuleVerdict::Unresolved,
        };
        let verdict = peak.utilisation.map(verdict);
        let met = match merged {
            true => verdict.and_then(RuleVerdict::is_within),
            false => peak.met,
        };
        let lines = if merged { 2.0 } else { 1.0 };
        let force = line.mean * (line.length + line.lifted_off) / lines;
        Ok(SizedLine {
            interface: interface.to_owned(),
            across: line.across,
            images: line.images,
            relative_radius: self.radius,
            merged,
            not_hertz: None,
            peak_line_load: line.peak,
            at: line.peak_at,
            from_end,
            hertz_pressure: peak.hertz_pressure,
            limit: self.limit(),
            utilisation: peak.utilisation,
            error,
            met,
            verdict,
            even: self.pressed(force / bears)?,
        })
    }

    /// (2-50) and (2-51) for one roller under its load.
    fn rule(
        &self,
        seat: &Seat,
        bearing: &BearingCase,
        load: f64,
    ) -> Result<Option<SizingRule>, DomainError> {
        let Some(yield_stress) = self.yield_stress else {
            return Ok(None);
        };
        let g = &bearing.geometry;
        let modulus = equivalent_modulus(self.compliance)?;
        // On a curved plate as on a flat one of the same effective radius.
        let (diameter, offset) = (2.0 * seat.radius, g.offset());
        // A roller that is displaced by more than half of what faces the plate stands on its edge.
        let effective = effective_length(seat.bears, offset).unwrap_or(0.0);
        let demand = |constants: Constants| -> Result<Demand, DomainError> {
            let required = constants.required_diameter_times_length(load, modulus, yield_stress)?;
            let provided = diameter * effective;
            Ok(Demand {
                constant: constants.sizing,
                required_diameter_times_length: required,
                provided,
                required_length: final_length(required / diameter, offset)? + g.end().rounded(),
                met: provided >= required,
            })
        };
        Ok(Some(SizingRule {
            interface: seat.interface.clone(),
            load,
            diameter,
            length: g.length(),
            displacement: offset,
            effective_length: effective,
            printed: demand(PRINTED)?,
            exact: demand(exact())?,
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analytic::{Elastic, contact_compliance};
    use crate::case::bearing::{Dimensions, RollerEnd};
    use std::f64::consts::PI;
    use std::path::Path;

    const STEEL: Steel = Steel {
        youngs_modulus: 29500.0,
        poissons_ratio: 0.3,
        yield_stress: 100.0,
        hardening_modulus: 249.471,
    };

    fn of_steels(steels: [Option<&Steel>; 2]) -> SizedPair {
        let elastic = |s: &Steel| Elastic::new(s.youngs_modulus, s.poissons_ratio).unwrap();
        let [upper, lower] = steels.map(|s| s.map_or(Elastic::RIGID, elastic));
        SizedPair::new(1.5, contact_compliance(upper, lower).unwrap(), steels)
    }

    fn shipped(name: &str) -> BearingCase {
        let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/section-2.6.2");
        let case = crate::case::read(&cases.join(name)).expect("the shipped case reads");
        let Kind::Bearing(bearing) = case.kind else {
            panic!("{name} is a bearing")
        };
        bearing
    }

    /// By hand for 65 kip on 8 in, D = 3 in: p0 = √(8.125 · 29500 / (2π · 0.91 · 1.5)).
    #[test]
    fn an_even_load_presses_as_the_report_has_it() {
        let pair = of_steels([Some(&STEEL); 2]);
        let even = pair.pressed(65.0 / 8.0).unwrap();
        let p0 = (8.125 * 29500.0 / (2.0 * PI * 0.91 * 1.5)).sqrt();
        assert!((even.hertz_pressure / p0 - 1.0).abs() < 1e-12);
        assert!((even.hertz_pressure - 167.17).abs() < 0.005);
        assert!((even.utilisation.unwrap() - 1.0132).abs() < 5e-5);
        assert_eq!(even.met, Some(false));
    }

    #[test]
    fn unlike_steels_share_the_compliance_and_the_softer_sets_the_limit() {
        let iron = Steel {
            youngs_modulus: 15000.0,
            poissons_ratio: 0.25,
            yield_stress: 40.0,
            ..STEEL
        };
        let pair = of_steels([Some(&STEEL), Some(&iron)]);
        let compliance = 0.91 / 29500.0 + 0.9375 / 15000.0;
        let p0 = (5.0 / (PI * 1.5 * compliance)).sqrt();
        let pressed = pair.pressed(5.0).unwrap();
        assert!((pressed.hertz_pressure / p0 - 1.0).abs() < 1e-12);
        assert!((pressed.utilisation.unwrap() / (p0 / 66.0) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn what_cannot_yield_has_no_limit() {
        let elastic = Steel::elastic(29500.0, 0.3);
        let pair = of_steels([Some(&elastic); 2]);
        let pressed = pair.pressed(8.0).unwrap();
        assert_eq!((pressed.utilisation, pressed.met), (None, None));
        let bearing = shipped("initial-centre.toml");
        assert_eq!(
            pair.rule(&bearing.seats()[0], &bearing, bearing.load),
            Ok(None)
        );
        // Beside steel that yields, that one sets the limit.
        let pair = of_steels([Some(&elastic), Some(&STEEL)]);
        assert_eq!(pair.limit(), Some(165.0));
    }

    /// Table 1.2 of the references: 23.969 in² with the printed constant, 24.636 with the exact one.
    #[test]
    fn the_initial_design_meets_the_rule_as_printed_only() {
        let pair = of_steels([Some(&STEEL); 2]);
        let bearing = shipped("initial-centre.toml");
        let rule = pair.rule(&bearing.seats()[0], &bearing, bearing.load);
        let rule = rule.unwrap().unwrap();
        let demands = [rule.printed, rule.exact];
        for (demand, required) in demands.iter().zip([23.969, 24.636]) {
            assert!((demand.required_diameter_times_length - required).abs() < 5e-4);
            assert_eq!(demand.provided, 24.0);
            assert!((demand.required_length - required / 3.0).abs() < 2e-4);
        }
        assert_eq!(demands.map(|d| d.met), [true, false]);
    }

    /// (2-51): 10.5 in are just enough at D_r = 1.25 in, and far too short at 2.5 in.
    #[test]
    fn a_displaced_roller_bears_on_less() {
        let pair = of_steels([Some(&STEEL); 2]);
        for (name, provided, met) in [
            ("revised-offset-1.25.toml", 24.0, true),
            ("revised-offset-2.5.toml", 16.5, false),
        ] {
            let bearing = shipped(name);
            let rule = pair.rule(&bearing.seats()[0], &bearing, bearing.load);
            let rule = rule.unwrap().unwrap();
            assert_eq!((rule.printed.provided, rule.printed.met), (provided, met));
            let asked = rule.printed.required_diameter_times_length / 3.0 + 2.0 * rule.displacement;
            assert!((rule.printed.required_length - asked).abs() < 1e-12);
        }
    }

    /// Rollers of 8 in: 6 in are straight between fillets of 1 in, and plates of 5 in have no more to press.
    #[test]
    fn only_the_straight_part_of_a_roller_on_its_plate_bears() {
        let pair = of_steels([Some(&STEEL); 2]);
        for (radius, plan, bears) in [(1.0, 8.0, 6.0), (1.0, 5.0, 5.0)] {
            let mut bearing = shipped("initial-centre.toml");
            let Dimensions::Crossed(geometry) = &mut bearing.geometry else {
                panic!("rollers that cross")
            };
            geometry.roller.end = RollerEnd::Radius(radius);
            geometry.plan = [plan; 2];
            let seat = &bearing.seats()[0];
            let rule = pair.rule(seat, &bearing, bearing.load).unwrap().unwrap();
            assert_eq!(rule.exact.provided, 3.0 * bears);
            assert_eq!(bearing_length(seat, 0.0), bears);
            assert_eq!(seat.ends_at, if plan < 6.0 { 2.5 } else { 4.0 });
        }
    }
}
