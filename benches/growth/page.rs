//! What is printed, and what is written into `docs/`.

use crate::fit::{self, Quantity};
use crate::kit::{Failure, machine};
use crate::record::Record;
use crate::sizes::Model;
use brinell::render::plot::{Line, Panel, PlotFigure, Scale, write};
use brinell::render::text::significant;
use std::path::Path;

/// Phases that are drawn, the longest ones.
const DRAWN: usize = 4;

type Series = [(Model, Vec<Record>)];

/// A size in one line, as it is done.
pub fn line(row: &Record) -> String {
    match &row.run {
        Err(why) => format!("  {:>5}: {why}", row.size),
        Ok(run) => format!(
            "  {:>5}: {} unknowns, {} iterations, {:.1} s, {:.1} CPU s, {:.0} MB",
            row.size,
            run.unknowns,
            run.iterations,
            run.wall_s,
            run.cpu_s,
            1e-6 * run.peak_memory_bytes
        ),
    }
}

/// The section of the page.
pub fn text(series: &Series, threads: usize) -> String {
    let mut text = format!(
        "## Growth\n\n\
         The initial bearing of Section 2.6.2, elastic-plastic, friction 0.15, from no load to 65 kip, on\n\
         the mesh `h025` with every element size scaled by one factor in every direction. Each size is\n\
         a process of its own, from case file to written results; memory is the largest that it had\n\
         resident. Meshing by gmsh is apart, and the case is solved once, without the second, elastic\n\
         solution for the table's elastic peaks. {threads} thread{}; {}.\n\n    {}\n\n\
         ![Time and memory against unknowns](images/growth.svg)\n",
        if threads == 1 { "" } else { "s" },
        machine(),
        command(series, threads)
    );
    for (model, rows) in series {
        text.push_str(&format!("\n### Bearing with {}\n\n", model.words()));
        text.push_str(&sizes(rows));
        text.push_str(&by_phase(rows));
        text.push_str(&exponents(rows));
    }
    text
}

fn command(series: &Series, threads: usize) -> String {
    let models: Vec<&str> = series.iter().map(|(m, _)| m.name()).collect();
    let rows = series.first().map_or(&[][..], |(_, rows)| rows);
    let sizes: Vec<&str> = rows.iter().map(|r| r.size.as_str()).collect();
    format!(
        "cargo bench --bench growth -- --threads {threads} --case {} --sizes {} --write",
        models.join(","),
        sizes.join(",")
    )
}

fn sizes(rows: &[Record]) -> String {
    let mut text = String::from(
        "| unknowns | elements | scale | Newton iterations | factorisations | Krylov directions | \
         wall s | CPU s | CPU s an iteration | memory MB | meshing s |\n\
         |---|---|---|---|---|---|---|---|---|---|---|\n",
    );
    for row in rows {
        match &row.run {
            Err(why) => text.push_str(&format!(
                "| {} | | {} | {why} | | | | | | | |\n",
                row.size, row.scale
            )),
            Ok(run) => text.push_str(&format!(
                "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {:.0} | {} |\n",
                run.unknowns,
                run.elements,
                row.scale,
                run.iterations,
                run.factorisations,
                run.krylov_directions,
                significant(run.wall_s, 3),
                significant(run.cpu_s, 3),
                significant(run.cpu_per_iteration(), 3),
                1e-6 * run.peak_memory_bytes,
                significant(row.meshing_s, 2)
            )),
        }
    }
    text
}

fn by_phase(rows: &[Record]) -> String {
    let phases = fit::phases(rows);
    let runs: Vec<&Record> = rows.iter().filter(|r| r.run.is_ok()).collect();
    let mut text = String::from("\nSeconds on the clock, by phase:\n\n| unknowns |");
    for run in runs.iter().filter_map(|r| r.run.as_ref().ok()) {
        text.push_str(&format!(" {} |", run.unknowns));
    }
    text.push_str(&format!("\n|---|{}\n", "---|".repeat(runs.len())));
    for phase in phases {
        let cells = runs.iter().map(|row| {
            let point = phase.points(std::slice::from_ref(*row));
            let value = point.first().map_or(0.0, |p| p.1);
            format!(" {} |", significant(value, 3))
        });
        text.push_str(&format!(
            "| {} |{}\n",
            phase.name,
            cells.collect::<String>()
        ));
    }
    text
}

fn exponents(rows: &[Record]) -> String {
    let mut text = format!(
        "\nExponents p in cost ~ unknowns^p, by least squares on the logarithms over the sizes from\n\
         {:.0}k unknowns up:\n\n\
         | | p | at most | at the largest size |\n|---|---|---|---|\n",
        1e-3 * fit::LEAST
    );
    for growth in fit::all(rows) {
        let two = |p: f64| format!("{p:.2}");
        text.push_str(&format!(
            "| {} | {} | {} | {} |\n",
            growth.name,
            growth.exponent.map_or("-".into(), two),
            growth.bound.map_or_else(String::new, |b| b.to_string()),
            significant(growth.largest, 3)
        ));
    }
    text
}

/// Draws time, memory and the longest phases against the unknowns.
pub fn picture(series: &Series, path: &Path) -> Result<(), Failure> {
    let mut legend: Vec<String> = series.iter().map(|(m, _)| m.words().into()).collect();
    legend.push("the exponent that is to be kept, 1.3 or 1.2".into());
    let [cpu, each, memory] = [fit::cpu(), fit::cpu_per_iteration(), fit::memory()];
    let mut panels: Vec<Panel> = [cpu, each, memory]
        .iter()
        .map(|q| panel(q, series))
        .collect();
    if let Some((model, rows)) = series.first() {
        let mut phases = fit::phases(rows);
        phases.sort_by(|a, b| {
            let largest = |q: &Quantity| q.growth(rows).largest;
            largest(b).total_cmp(&largest(a))
        });
        phases.truncate(DRAWN);
        let lines = phases.iter().enumerate().map(|(k, phase)| {
            let style = legend.len() + k;
            Line::dotted(style, phase.points(rows))
        });
        panels.push(Panel {
            title: format!("longest phases ({}), wall s", model.name()),
            axes: ["unknowns".to_string(), String::new()],
            scale: Scale::Decades,
            lines: lines.collect(),
            dashed: Vec::new(),
        });
        legend.extend(phases.into_iter().map(|phase| phase.name));
    }
    let figure = PlotFigure {
        panels,
        legend,
        dashed: String::new(),
    };
    Ok(write(&figure, path)?)
}

fn panel(quantity: &Quantity, series: &Series) -> Panel {
    let mut lines: Vec<Line> = Vec::new();
    for (style, (_, rows)) in series.iter().enumerate() {
        lines.push(Line::dotted(style, quantity.points(rows)));
    }
    // From the first fitted point of the first series on.
    let fitted = lines.first().map(|l| {
        let from = l.points.iter().filter(|p| p.0 >= 0.95 * fit::LEAST);
        from.copied().collect::<Vec<_>>()
    });
    if let (Some(bound), Some([first, .., last])) = (quantity.bound, fitted.as_deref()) {
        let end = first.1 * (last.0 / first.0).powf(bound);
        let bound = vec![*first, (last.0, end)];
        lines.push(Line::smooth(series.len(), bound));
    }
    Panel {
        title: quantity.name.clone(),
        axes: ["unknowns".to_string(), String::new()],
        scale: Scale::Decades,
        lines,
        dashed: Vec::new(),
    }
}
