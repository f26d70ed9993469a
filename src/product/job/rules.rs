//! Design rules beside the loads that a run found: each asked of every line of contact, under the load spread evenly
//! and under the largest load per length, and told for the line that uses it most.

use super::error::JobError;
use super::rollers::{TIE, is_merged, roller};
use crate::analytic::DomainError;
use crate::analytic::rules::{LoadError, Rule, rules as all_rules};
use crate::answer::certify::{Figure, Quantity};
use crate::answer::{Answer, LineFigures};
use crate::case::{Case, CaseError, Kind};
use crate::ground::order::ascending;
use crate::model::scene::{Partner, Scene};
use crate::render::summary::{JudgedRule, RuleSheet, SteelAfter};

/// What the rules say of every line of contact whose bodies are known; nothing where there is none.
pub fn rules(case: &Case, scene: &Scene, answer: &Answer) -> Result<Option<RuleSheet>, JobError> {
    let no_form = |error: DomainError| JobError::ClosedForm {
        what: "the design rules".to_owned(),
        why: error.to_string(),
    };
    let mut sheet = RuleSheet {
        rules: Vec::new(),
        steel: Vec::new(),
        notes: Vec::new(),
    };
    for (pair, (interface, figures)) in scene.contacts.iter().zip(&answer.interfaces.0) {
        let error = load_error(answer, interface);
        let lines = figures.lines.iter().filter(|_| figures.patch.is_none());
        for line in lines {
            let Some(roller) = roller(case, scene, (pair, line))? else {
                continue;
            };
            if is_merged(case, (interface, figures), line) {
                let note =
                    format!("{interface}: two lines that the mesh does not tell apart, left out");
                if !sheet.notes.contains(&note) {
                    sheet.notes.push(note);
                }
                continue;
            }
            let loads = [force(line) / roller.effective, line.peak];
            for (k, rule) in all_rules(&roller.input)
                .map_err(no_form)?
                .iter()
                .enumerate()
            {
                let judged = judge(rule, interface, loads, error);
                match sheet.rules.get_mut(k) {
                    Some(worst) => keep_worse(worst, judged),
                    None => sheet.rules.push(judged),
                }
            }
        }
    }
    if sheet.rules.is_empty() && sheet.notes.is_empty() {
        return Ok(None);
    }
    if case.controls.plasticity {
        sheet.steel = steel(case, scene, answer)?;
    }
    sheet.notes.extend(where_worst(&sheet.rules));
    sheet
        .notes
        .extend(taken_for_granted(&case.kind).map(str::to_owned));
    Ok(Some(sheet))
}

/// What the rules do not know of the bodies.
fn taken_for_granted(kind: &Kind) -> Option<&'static str> {
    match kind {
        Kind::Bearing(bearing) => (bearing.geometry.wall().is_some())
            .then_some("the rules are of solid rollers, these are hollow"),
        Kind::General(_) => Some(
            "each line is taken as a solid roller on a flat, with the relative radius of its surfaces and square ends",
        ),
    }
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
        let names = ascending(rules.iter().filter_map(line).map(String::as_str));
        (!names.is_empty()).then(|| format!("{load}: of {}", names.join(", ")))
    });
    told.into_iter().flatten().collect()
}

/// What the steel of every body that can yield does.
fn steel(case: &Case, scene: &Scene, answer: &Answer) -> Result<Vec<SteelAfter>, CaseError> {
    let mut steel = Vec::new();
    for (body, figures) in &answer.bodies.0 {
        if case.steels().of(body)?.is_elastic() {
            continue;
        }
        let dents = answer
            .unloaded
            .iter()
            .flat_map(|unloaded| &unloaded.dents.0);
        let of_body = dents.filter(|(_, dent)| &dent.body == body);
        let deepest = of_body.max_by(|a, b| a.1.depth.total_cmp(&b.1.depth));
        let dent = deepest.map(|(_, dent)| dent.depth);
        let diameter = deepest.and_then(|(surface, _)| diameter(case, scene, answer, surface));
        steel.push(SteelAfter {
            body: body.clone(),
            peeq_max: figures.peeq_max,
            peeq_away: figures.flow.away,
            yielded_volume: figures.yielded_volume,
            yielded_share: figures.yielded_volume / figures.volume,
            dent,
            dent_in: deepest.map(|(surface, _)| surface.clone()),
            dent_over_diameter: dent.zip(diameter).map(|(dent, diameter)| dent / diameter),
        });
    }
    Ok(steel)
}

/// Diameter of the roller that presses on a surface, or of one on a flat with the same relative radius.
fn diameter(case: &Case, scene: &Scene, answer: &Answer, surface: &str) -> Option<f64> {
    if let Some(bearing) = case.bearing() {
        return Some(bearing.geometry.diameter());
    }
    let is_side = |side: &Partner| matches!(side, Partner::Surface(name) if name == surface);
    let mut pairs = scene.contacts.iter();
    let pair = pairs.find(|pair| is_side(&pair.upper) || is_side(&pair.lower))?;
    let lines = &answer.interfaces.get(&pair.name)?.lines;
    lines
        .iter()
        .find_map(|line| line.relative_radius)
        .map(|radius| 2.0 * radius)
}
