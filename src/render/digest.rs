//! A run in some fifteen lines: the verdict, what governs it, the figures that engineers ask for first.

use super::figures::{DIGITS, MESH_DIGITS, off, share, with_error};
use super::summary::Summary;
use super::terminal::headline;
use super::text::{list, percent, significant};
use super::utilisation::{Utilisation, first_largest, largest, utilisations};
use super::verdict::verdict;
use crate::answer::InterfaceFigures;
use crate::answer::certify::{Figure, Quantity};
use crate::answer::checks::NOTABLE_SHARE;
use crate::ground::geometry::norm;
use std::fmt::Write;

/// Two pressures of one line load differ by less.
const ROUNDING: f64 = 1e-9;

/// The digest of a run whose checks miss the limits `missed`, every line ended, in the units of the case.
pub fn digest(summary: &Summary, missed: &[String]) -> String {
    let verdict = verdict(summary, missed);
    let used = utilisations(summary);
    let lines = [
        ("VERDICT", Some(verdict.head.clone())),
        ("", verdict.rest.first().cloned()),
        ("governs", largest(&used).map(|most| governs(summary, most))),
        ("load", Some(load(summary))),
        ("p max", pressure(summary)),
        ("p0", hertz(summary)),
        ("Mises", mises(summary, &used)),
        ("", elastic_twin(summary)),
        ("plastic strain", plastic_strain(summary)),
        ("line load", line_load(summary)),
        ("forces", forces(summary)),
        ("checks", checks(summary)),
        ("widest bar", widest_bar(summary)),
        ("work", Some(work(summary))),
    ];
    let mut text = headline(summary);
    for (name, line) in lines {
        if let Some(line) = line {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "  {name:<16}{line}");
        }
    }
    text + &list("Warnings", summary.warnings.iter().map(|w| &w.0))
}

fn governs(summary: &Summary, most: &Utilisation) -> String {
    let (what, place, against) = (&most.what, &most.place, most.against);
    let limit = significant(most.limit, DIGITS);
    let unit = &summary.units.stress;
    format!(
        "{what} of {place}: {} of {limit} {unit}, {against}",
        used(most)
    )
}

/// The share of a limit that is used, with its error.
fn used(most: &Utilisation) -> String {
    let error = most.share_error().map_or_else(String::new, |error| {
        format!(" ± {}", significant(100.0 * error, MESH_DIGITS))
    });
    let share = significant(100.0 * most.share(), 3);
    match most.resolved {
        true => format!("{share}{error} %"),
        false => format!("{share} %, NOT RESOLVED,"),
    }
}

fn load(summary: &Summary) -> String {
    let answer = &summary.answer;
    let (force, length) = (&summary.units.force, &summary.units.length);
    let mut text = format!("{} {force}", significant(answer.applied_load, DIGITS));
    if !answer.step.is_empty() {
        let _ = write!(
            text,
            ", step {}, {} done",
            answer.step,
            percent(answer.step_done)
        );
    }
    if let Some(descent) = answer.descent {
        let figure = answer.figure(Quantity::Descent, "overall");
        let error = figure.and_then(Figure::bar);
        let open = match figure.is_some_and(|figure| !figure.is_resolved()) {
            true => ", NOT RESOLVED",
            false => "",
        };
        let descent = with_error(descent, error);
        let _ = write!(text, "; descent {descent} {length}{open}");
    }
    text
}

/// The largest figure of a kind, or away from edges where that stands in its place; one that is resolved, where there is any.
fn largest_of(summary: &Summary, what: Quantity) -> Option<&Figure> {
    let (standing, _) = summary.answer.standing();
    let of_kind = |resolved: bool| {
        let same = |f: &Figure| f.what == what || Some(f.what) == what.away_from_edges();
        let all = standing.iter().copied();
        first_largest(
            all.filter(|f| same(f) && f.is_resolved() == resolved),
            |f| f.value,
        )
    };
    of_kind(true).or_else(|| of_kind(false))
}

/// What edges and fillets make of that figure, where others stand in its place.
fn at_edges(summary: &Summary, what: Quantity) -> String {
    let (_, replaced) = summary.answer.standing();
    let same = replaced.into_iter().filter(|f| f.what == what);
    first_largest(same, |f| f.value).map_or_else(String::new, |figure| {
        let value = sized(summary, figure);
        format!("; {value} at an edge, NOT RESOLVED")
    })
}

/// What of that kind may be larger than the figure `told`: at edges, and elsewhere where the mesh does not resolve it.
fn beyond(summary: &Summary, told: &Figure, what: Quantity) -> String {
    let (standing, _) = summary.answer.standing();
    let unsure = standing.into_iter().filter(|f| {
        f.what == what && f.place != told.place && !f.is_resolved() && f.value > told.value
    });
    let elsewhere = first_largest(unsure, |f| f.value).map_or_else(String::new, |figure| {
        let value = sized(summary, figure);
        format!("; {value}, NOT RESOLVED, on {}", figure.place)
    });
    at_edges(summary, what) + &elsewhere
}

/// A figure with its bar and its unit.
fn sized(summary: &Summary, figure: &Figure) -> String {
    let unit = summary.units.of_measure(figure.what.measure());
    let value = with_error(figure.value, figure.bar());
    format!("{value} {unit}").trim_end().to_string()
}

/// A figure with its bar, its unit and its place.
fn told(summary: &Summary, figure: &Figure) -> String {
    let value = sized(summary, figure);
    let doubt = match figure.is_resolved() {
        true => "",
        false => ", NOT RESOLVED",
    };
    let away = match figure.what {
        Quantity::PressureAway | Quantity::LineLoadAway => " away from edges",
        _ => "",
    };
    format!("{value}{away}{doubt}, {}", figure.place)
}

/// The limit of the pressure on an interface, and what it is: (2-49) of a line, first yield of a patch.
fn limit(summary: &Summary, interface: &str) -> Option<(f64, &'static str)> {
    let sizing = summary.sizing.as_ref()?;
    let line = sizing.lines.iter().find(|line| line.interface == interface);
    let patch = (sizing.patches.iter()).find(|patch| patch.interface == interface);
    let of_line = line.and_then(|line| Some((line.limit?, "1.65 yield")));
    of_line.or_else(|| Some((patch?.first_yield?, "first yield below it")))
}

/// What a pressure uses of the limit on its interface.
fn of_limit(summary: &Summary, pressure: f64, interface: &str) -> String {
    limit(summary, interface).map_or_else(String::new, |(limit, what)| {
        let (used, limit) = (share(Some(pressure / limit)), significant(limit, DIGITS));
        format!("; {used} of {limit}, {what}")
    })
}

fn pressure(summary: &Summary) -> Option<String> {
    let peak = largest_of(summary, Quantity::PeakPressure)?;
    let limit = of_limit(summary, peak.value, &peak.place);
    Some(told(summary, peak) + &limit + &beyond(summary, peak, Quantity::PeakPressure))
}

/// Hertz's pressure under the largest line load, as certified; where steel flows below a line that carries more, also as the
/// sizing rules take it.
fn hertz(summary: &Summary) -> Option<String> {
    let certified = largest_of(summary, Quantity::HertzPressure);
    let lines = summary.sizing.iter().flat_map(|sizing| &sizing.lines);
    let patches = summary.sizing.iter().flat_map(|sizing| &sizing.patches);
    let lines = lines.filter(|line| !line.merged || certified.is_none());
    let of_lines = lines.map(|line| (line.hertz_pressure, &line.interface));
    let all = of_lines.chain(patches.map(|patch| (patch.hertz_pressure, &patch.interface)));
    let all: Vec<(f64, &String)> = all.collect();
    let of_rules = first_largest(all.iter(), |one| one.0).filter(|(pressure, _)| {
        certified.is_none_or(|figure| *pressure > (1.0 + ROUNDING) * figure.value)
    });
    let certified = certified
        .map(|figure| told(summary, figure) + &of_limit(summary, figure.value, &figure.place));
    let of_rules = of_rules.map(|(pressure, interface)| {
        let value = significant(*pressure, DIGITS);
        let limit = of_limit(summary, *pressure, interface);
        let unit = &summary.units.stress;
        format!("{value} {unit}, {interface}, as if steel stayed elastic{limit}")
    });
    match (of_rules, certified) {
        (Some(larger), Some(certified)) => Some(format!("{larger}; certified {certified}")),
        (larger, certified) => larger.or(certified),
    }
}

/// The Mises peak that uses most of its yield stress; without one the largest.
fn mises(summary: &Summary, used: &[Utilisation]) -> Option<String> {
    let of_yield = used.iter().filter(|u| u.against == "yield");
    let unit = &summary.units.stress;
    if let Some(most) = first_largest(of_yield, Utilisation::share) {
        let value = with_error(most.value, most.error);
        let limit = significant(most.limit, DIGITS);
        let share = share(Some(most.share()));
        let doubt = if most.resolved { "" } else { ", NOT RESOLVED" };
        return Some(format!(
            "{value} {unit}{doubt}, {} of {}; {share} of yield, {limit}",
            most.what, most.place
        ));
    }
    let peak = largest_of(summary, Quantity::PeakMises)?;
    Some(format!("{}, {}", told(summary, peak), peak.what.name()))
}

/// What elastic figures are of, where that is not the solution that the rest is of.
fn elastic_twin(summary: &Summary) -> Option<String> {
    let twin = summary.elastic_twin.as_ref()?;
    let (dofs, folder) = (twin.dofs, &twin.folder);
    Some(format!(
        "elastic figures are of the elastic solution on a mesh of its own, {dofs} unknowns, in {folder}"
    ))
}

fn plastic_strain(summary: &Summary) -> Option<String> {
    Some(told(
        summary,
        largest_of(summary, Quantity::PeakPlasticStrain)?,
    ))
}

fn line_load(summary: &Summary) -> Option<String> {
    let largest = largest_of(summary, Quantity::LineLoad)?;
    Some(told(summary, largest) + &beyond(summary, largest, Quantity::LineLoad))
}

/// What the interfaces carry along the load.
fn forces(summary: &Summary) -> Option<String> {
    let all = || {
        summary
            .answer
            .interfaces
            .0
            .iter()
            .map(|(_, i)| i.normal_force)
    };
    let (least, most) = all().fold((f64::INFINITY, 0.0f64), |(least, most), force| {
        (least.min(force), most.max(force))
    });
    let [least, most] = [least, most].map(|force| significant(force, DIGITS));
    // Of what stands across the load, or carries friction, that is not all.
    let interfaces = &summary.answer.interfaces.0;
    let is_part = |i: &InterfaceFigures| norm(i.force) > (1.0 + NOTABLE_SHARE) * i.normal_force;
    let along = match interfaces.iter().any(|(_, i)| is_part(i)) {
        true => " along the load",
        false => "",
    };
    let unit = format!("{}{along}", summary.units.force);
    match all().count() {
        0 => None,
        1 => Some(format!("{most} {unit} through the one interface")),
        count if least == most => Some(format!("{most} {unit} through each of {count} interfaces")),
        count => Some(format!(
            "{least} to {most} {unit} through {count} interfaces"
        )),
    }
}

fn checks(summary: &Summary) -> Option<String> {
    let checks = &summary.answer.checks;
    let told = [
        ("force balance", checks.force_balance, "of the load"),
        (
            "penetration",
            checks.max_penetration_relative,
            "of the descent",
        ),
        ("energy", checks.energy_imbalance, "of the work"),
    ];
    let told = told.into_iter().filter_map(|(name, value, of)| {
        let value = value?;
        Some(format!("{name} {value:.0e} {of}"))
    });
    let told: Vec<String> = told.collect();
    (!told.is_empty()).then(|| told.join(", "))
}

/// The widest of the bars that are known, relative to its figure, and how many are not.
fn widest_bar(summary: &Summary) -> Option<String> {
    let (standing, _) = summary.answer.standing();
    let bars = standing
        .iter()
        .filter_map(|f| Some((f.relative_bar()?, *f)));
    let (bar, widest) = bars.max_by(|a, b| a.0.total_cmp(&b.0))?;
    let known = standing.iter().filter(|f| f.is_resolved()).count();
    let (what, place) = (widest.what.name(), &widest.place);
    // Of a figure that may be nothing a share says nothing.
    let size = if bar > 1.0 {
        sized(summary, widest)
    } else {
        format!("± {}", off(bar))
    };
    Some(format!(
        "{size}, {what} of {place}; {known} of {} figures have one",
        standing.len()
    ))
}

fn work(summary: &Summary) -> String {
    let (dofs, iterations) = (summary.counters.dofs, summary.counters.iterations);
    let memory = (summary.peak_memory_bytes).map_or_else(String::new, |bytes| {
        format!(", {:.0} MB", bytes as f64 / 1e6)
    });
    format!(
        "{dofs} unknowns, {iterations} iterations, {:.1} s{memory}",
        summary.timing.total_s
    )
}
