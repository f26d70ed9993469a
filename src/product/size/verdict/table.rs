//! The verdict as text.

use super::check::{LimitCheck, LimitKind};
use super::design::DesignVerdict;
use super::position::Placed;
use super::standing::SizeStanding;
use crate::ground::units::UnitLabels;
use crate::product::size::table::wrapped;
use crate::render::figures::MESH_DIGITS;
use crate::render::table::text::text as table_text;
use crate::render::table::{Cell, Number, Table};
use crate::render::text::{percent, significant};
use std::fmt::Write;

/// What was found of a design, whatever its template.
pub struct Checked<'v> {
    /// Of its figures.
    pub units: &'v UnitLabels,
    /// What was solved.
    pub positions: &'v [Placed],
    /// What would help, where a limit is missed.
    pub advice: Option<String>,
}

/// What a verdict is on.
pub struct Design<'v> {
    /// On the bearing.
    pub load: f64,
    /// Of its steel.
    pub yield_stress: f64,
    /// Its sizes in words.
    pub about: String,
    /// The preset.
    pub mesh: &'v str,
}

impl DesignVerdict {
    fn checked(&self) -> Checked<'_> {
        let advice = self.advice.as_ref();
        Checked {
            units: &self.units,
            positions: &self.positions,
            advice: advice.map(|advice| format!("{}, which {}", advice.options, advice.why)),
        }
    }

    /// As a Markdown file.
    pub fn page(&self) -> String {
        let (units, design) = (&self.units, &self.design);
        let n = |value: f64| significant(value, 4);
        let about = format!(
            "displacement {} {}; rollers {} x {} {}, wall {}, plates {}",
            n(self.capacity),
            units.length,
            n(design.diameter),
            n(design.length),
            units.length,
            n(design.wall),
            n(design.plate)
        );
        let design = Design {
            load: self.load,
            yield_stress: self.yield_stress,
            about,
            mesh: &self.mesh,
        };
        page(&self.checked(), &design)
    }
}

/// Everything, every line ended.
pub fn render(verdict: &DesignVerdict) -> String {
    render_checked(&verdict.checked())
}

/// The same of a design of any template.
pub fn render_checked(checked: &Checked) -> String {
    let mut text = String::new();
    for placed in checked.positions {
        text += &position(checked.units, placed);
        text.push('\n');
    }
    text + &conclusion(checked)
}

/// The same as a Markdown file.
pub fn page(checked: &Checked, design: &Design) -> String {
    let (units, positions) = (checked.units, checked.positions);
    let n = |value: f64| significant(value, 4);
    let checks = positions.iter().flat_map(|placed| &placed.checks);
    let open = checks.filter(|c| c.standing == SizeStanding::Open).count();
    let met = positions.iter().all(Placed::met);
    format!(
        "# Verdict: {}\n\n\
         Load {} {}, steel of {} {}, {}; mesh `{}`, Brinell {}.\n\n```text\n{}```\n",
        match (met, open) {
            (true, 0) => "met".to_string(),
            (true, open) => format!("no limit missed, {open} open"),
            (false, _) =>
                if positions.iter().any(Placed::misses) {
                    "MISSED".to_string()
                } else {
                    "none, not resolved".to_string()
                },
        },
        n(design.load),
        units.force,
        n(design.yield_stress),
        units.stress,
        design.about,
        design.mesh,
        env!("CARGO_PKG_VERSION"),
        render_checked(checked)
    )
}

fn said(standing: SizeStanding) -> &'static str {
    match standing {
        SizeStanding::Met => "yes",
        SizeStanding::MetWithinError => "yes, within ±",
        SizeStanding::MissedWithinError => "NO, within ±",
        SizeStanding::Missed => "NO",
        SizeStanding::Open => "open",
        SizeStanding::Unresolved => "NOT RESOLVED",
        SizeStanding::NotJudged => "not judged",
    }
}

fn what(check: &LimitCheck, units: &UnitLabels) -> String {
    match (check.kind, check.line_load) {
        (LimitKind::ContactPressure, Some(q)) => {
            format!(
                "p0 at {} {}, {}",
                significant(q, 4),
                units.line_load(),
                units.stress
            )
        }
        (LimitKind::ContactPressure | LimitKind::ElasticMises, _) => {
            format!("{}, {}", check.kind.name(), units.stress)
        }
        (kind, _) => kind.name().to_string(),
    }
}

fn position(units: &UnitLabels, placed: &Placed) -> String {
    let number = |value: Option<f64>| value.map_or("-".to_string(), |v| significant(v, 4));
    let mut table = Table::new(format!(
        "{}: rollers at s = {} {}, {} unknowns, {:.0} s, descent {} {}",
        placed.position,
        significant(placed.offset, 4),
        units.length,
        placed.unknowns,
        placed.seconds,
        number(placed.descent),
        units.length,
    ))
    .words("where")
    .figures(["what", "value", "± error", "limit", "of limit", "met"]);
    let mut remarks: Vec<(&str, Vec<&str>)> = Vec::new();
    for check in &placed.checks {
        // The star is for peaks beside singular edges alone; remarks go by numbers.
        let star = if check.at_edge { "*" } else { "" };
        let remark = check.remark.as_ref().map(|remark| {
            let known = remarks.iter().position(|(known, _)| known == remark);
            let index = known.unwrap_or_else(|| {
                remarks.push((remark, Vec::new()));
                remarks.len() - 1
            });
            remarks[index].1.push(&check.place);
            format!(" [{}]", index + 1)
        });
        let remark = remark.unwrap_or_default();
        table.row([
            (&check.place).into(),
            what(check, units).into(),
            format!("{}{star}{remark}", number(check.value)).into(),
            Cell::Figure(Number::new(check.error, MESH_DIGITS)),
            Cell::figure(check.limit),
            Cell::Share(check.utilisation),
            said(check.standing).into(),
        ]);
    }
    let mut text = table_text(&table);
    for ((remark, places), number) in remarks.into_iter().zip(1..) {
        text += &wrapped(&format!("[{number}] {}: {remark}", places.join(", ")), 2);
    }
    if placed.checks.iter().any(|check| check.at_edge) {
        text += "  * beside a singular edge: a value of this mesh\n";
    }
    text
}

fn conclusion(checked: &Checked) -> String {
    let checks = || {
        let positions = checked.positions.iter();
        positions.flat_map(|p| p.checks.iter().map(move |c| (p, c)))
    };
    let named = |(placed, check): (&Placed, &LimitCheck)| {
        let share = check
            .utilisation
            .map_or_else(String::new, |u| format!(" at {}", percent(u)));
        format!(
            "{} of {}, {}{share}",
            check.kind.name(),
            check.place,
            placed.position
        )
    };
    let by_share = |a: &(&Placed, &LimitCheck), b: &(&Placed, &LimitCheck)| {
        a.1.utilisation
            .unwrap_or(0.0)
            .total_cmp(&b.1.utilisation.unwrap_or(0.0))
    };
    let missed: Vec<String> = (checks().filter(|(_, c)| c.standing.is_missed()))
        .map(named)
        .collect();
    let count = |standing: SizeStanding| checks().filter(|(_, c)| c.standing == standing).count();
    let unresolved: Vec<String> = (checks()
        .filter(|(_, c)| c.standing == SizeStanding::Unresolved))
    .map(named)
    .collect();
    let mut text = match missed.as_slice() {
        [] if !unresolved.is_empty() => {
            let words = format!(
                "VERDICT: NONE, not resolved by this mesh: {}",
                unresolved.join("; ")
            );
            wrapped(&words, 0)
        }
        [] => {
            let nearest = checks().max_by(by_share).map_or_else(String::new, named);
            let is_apart = |(_, check): (&Placed, &LimitCheck)| {
                check.kind == LimitKind::ContactPressure && check.along.is_none()
            };
            let apart = match checks().any(is_apart) {
                true => " away from rounded ends, where p0 is not resolved",
                false => "",
            };
            format!("VERDICT: no limit is missed{apart}; the nearest is that on {nearest} of it\n")
        }
        missed => {
            let words = format!("VERDICT: FAILED, limits missed: {}", missed.join("; "));
            wrapped(&words, 0)
        }
    };
    // Writing to a string cannot fail.
    let remarks = [
        (
            SizeStanding::MetWithinError,
            "met by less than the estimated error",
        ),
        (
            SizeStanding::Open,
            "open: this mesh cannot tell; brinell run with --target 3% refines it",
        ),
        (
            SizeStanding::Unresolved,
            "not resolved: the error is not known; brinell run with --target 3% refines the mesh",
        ),
        (
            SizeStanding::NotJudged,
            "beside singular edges, not judged: what is found there belongs to the mesh",
        ),
    ];
    for (standing, words) in remarks {
        let n = count(standing);
        if n > 0 {
            let _ = writeln!(text, "  {n} {words}");
        }
    }
    if let Some(advice) = &checked.advice {
        text += &wrapped(&format!("what would help: {advice}"), 2);
    }
    text
}
