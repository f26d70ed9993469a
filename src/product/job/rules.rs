//! Design rules beside the loads that a run found: each asked of every line of contact, under the load spread evenly
//! and under the largest load per length, and told for the line that uses it most.

use super::error::JobError;
use super::sizing::is_merged;
use crate::analytic::DomainError;
use crate::analytic::rules::{LoadError, Rule, RuleInput, RuleSteel, rules as all_rules};
use crate::analytic::sizing::effective_length;
use crate::answer::certify::{Figure, Quantity};
use crate::answer::{Answer, LineFigures};
use crate::case::bearing::Seat;
use crate::case::{BearingCase, Case, CaseError, Kind};
use crate::ground::units::UnitSystem;
use crate::render::summary::{JudgedRule, RuleSheet, SteelAfter};

/// What the rules say of a bearing; nothing of a general scene.
pub fn rules(case: &Case, answer: &Answer) -> Result<Option<RuleSheet>, JobError> {
    let Kind::Bearing(bearing) = &case.kind else {
        return Ok(None);
    };
    let plastic = case.controls.plasticity;
    let no_form = |error: DomainError| JobError::ClosedForm {
        what: "the design rules".to_owned(),
        why: error.to_string(),
    };
    let mut sheet = RuleSheet {
        rules: Vec::new(),
        steel: if plastic {
            steel(bearing, answer)?
        } else {
            Vec::new()
        },
        notes: Vec::new(),
    };
    let length = bearing.geometry.length();
    // Displaced by more than half of its length no part of a roller is left that (2-51) would count.
    let effective = effective_length(length, bearing.geometry.offset()).unwrap_or(length);
    for (interface, figures) in &answer.interfaces.0 {
        let Some(seat) = bearing.seat(interface) else {
            continue;
        };
        let input = input(bearing, case.units, &seat)?;
        let rules = all_rules(&input).map_err(no_form)?;
        let error = load_error(answer, interface);
        for line in &figures.lines {
            if is_merged(&seat, line) {
                let note =
                    format!("{interface}: two lines that the mesh does not tell apart, left out");
                if !sheet.notes.contains(&note) {
                    sheet.notes.push(note);
                }
                continue;
            }
            let loads = [force(line) / effective, line.peak];
            for (k, rule) in rules.iter().enumerate() {
                let judged = judge(rule, interface, loads, error);
                match sheet.rules.get_mut(k) {
                    Some(worst) => keep_worse(worst, judged),
                    None => sheet.rules.push(judged),
                }
            }
        }
    }
    sheet.notes.extend(where_worst(&sheet.rules));
    if bearing.geometry.wall().is_some() {
        sheet
            .notes
            .push("the rules are of solid rollers, these are hollow".to_owned());
    }
    Ok(Some(sheet))
}

/// A roller and the plate that it lies on.
fn input(bearing: &BearingCase, units: UnitSystem, seat: &Seat) -> Result<RuleInput, CaseError> {
    let g = &bearing.geometry;
    let sides = [
        rule_steel(bearing, &seat.roller)?,
        rule_steel(bearing, &seat.plate)?,
    ];
    let (end_radius, overhang) = match g.end().radius() {
        // The plate stands out beyond where the fillet begins.
        Some(radius) => (radius, Some(radius + seat.overhang)),
        None => (0.0, None),
    };
    Ok(RuleInput {
        end_radius,
        overhang,
        rollings: bearing.rollings,
        mating_diameter: (seat.curvature != 0.0).then(|| -2.0 / seat.curvature),
        ..RuleInput::new(units, g.diameter(), g.length(), sides)
    })
}

fn rule_steel(bearing: &BearingCase, body: &str) -> Result<RuleSteel, CaseError> {
    let steel = bearing.steels.of(body)?;
    let strength = bearing.steels.strength_of(body)?;
    Ok(RuleSteel {
        yield_stress: strength.yield_stress,
        ultimate_strength: strength.ultimate_strength,
        hardness: strength.hardness,
        surface_hardened: strength.surface_hardened,
        ..RuleSteel::elastic(steel.youngs_modulus, steel.poissons_ratio)
    })
}

/// How well the largest load per length of an interface is known.
fn load_error(answer: &Answer, interface: &str) -> LoadError {
    let bar = answer
        .figure(Quantity::LineLoad, interface)
        .and_then(Figure::bar);
    bar.map_or(LoadError::Unknown, LoadError::Within)
}

/// The force of a line, normal to the surface.
fn force(line: &LineFigures) -> f64 {
    line.mean * (line.length + line.lifted_off)
}

fn judge(rule: &Rule, interface: &str, [even, largest]: [f64; 2], error: LoadError) -> JudgedRule {
    let line = rule.bound().map(|_| interface.to_owned());
    JudgedRule {
        rule: rule.clone(),
        even: rule.judge(even, LoadError::None),
        even_line: line.clone(),
        largest: rule.judge(largest, error),
        largest_line: line,
    }
}

/// Of two lines the one that uses the rule more, for either load; the limit is that of the largest load's line.
fn keep_worse(worst: &mut JudgedRule, other: JudgedRule) {
    let used = |rule: &Option<crate::analytic::rules::Judged>| rule.map_or(0.0, |j| j.utilisation);
    // Of lines that are images of each other the first one stays.
    const TIE: f64 = 1.0 + 1e-6;
    if used(&other.even) > TIE * used(&worst.even) {
        (worst.even, worst.even_line) = (other.even, other.even_line);
    }
    if used(&other.largest) > TIE * used(&worst.largest) {
        (worst.largest, worst.largest_line) = (other.largest, other.largest_line);
        worst.rule = other.rule;
    }
}

/// The lines that the rules are used most by, in words.
fn where_worst(rules: &[JudgedRule]) -> Vec<String> {
    type Line = fn(&JudgedRule) -> Option<&String>;
    let lines: [(&str, Line); 2] = [
        ("even load", |rule| rule.even_line.as_ref()),
        ("largest load", |rule| rule.largest_line.as_ref()),
    ];
    let told = lines.map(|(load, line)| {
        let mut names: Vec<&str> = rules.iter().filter_map(line).map(String::as_str).collect();
        names.sort_unstable();
        names.dedup();
        (!names.is_empty()).then(|| format!("{load}: of {}", names.join(", ")))
    });
    told.into_iter().flatten().collect()
}

/// What the steel of every body that can yield does.
fn steel(bearing: &BearingCase, answer: &Answer) -> Result<Vec<SteelAfter>, CaseError> {
    let mut steel = Vec::new();
    for (body, figures) in &answer.bodies.0 {
        if bearing.steels.of(body)?.is_elastic() {
            continue;
        }
        let dents = answer
            .unloaded
            .iter()
            .flat_map(|unloaded| &unloaded.dents.0);
        let of_body = dents.filter(|(_, dent)| &dent.body == body);
        let deepest = of_body.max_by(|a, b| a.1.depth.total_cmp(&b.1.depth));
        let dent = deepest.map(|(_, dent)| dent.depth);
        steel.push(SteelAfter {
            body: body.clone(),
            peeq_max: figures.peeq_max,
            peeq_away: figures.flow.away,
            yielded_volume: figures.yielded_volume,
            yielded_share: figures.yielded_volume / figures.volume,
            dent,
            dent_in: deepest.map(|(surface, _)| surface.clone()),
            dent_over_diameter: dent.map(|dent| dent / bearing.geometry.diameter()),
        });
    }
    Ok(steel)
}
