//! The page `docs/convergence.md` and its picture.

use super::ConvergeError;
use super::peers::{PeerErrors, Peers};
use super::plot::figure_with_peers;
use super::study::{Curve, Study};
use super::table::{memory, order, reference, signed_percent};
use crate::ground::file::write_text;
use crate::render::plot::write;
use crate::render::table::Table;
use crate::render::table::markdown::markdown;
use crate::render::text::significant;
use std::path::Path;

/// The page and its picture, from the folder where the command is run.
pub const PAGE: &str = "docs/convergence.md";
pub const PICTURE: &str = "docs/images/problem-h.svg";

/// How the part about bearings begins, which `cargo bench --bench against-calculix` writes.
const BEARINGS: &str = "\n# Bearings\n";

/// Writes page and picture; the part about bearings stays.
///
/// # Errors
/// Where the picture cannot be drawn or a file cannot be written.
pub fn write_page(study: &Study, peers: &Peers) -> Result<(), ConvergeError> {
    write(&figure_with_peers(study, peers), Path::new(PICTURE))?;
    let old = std::fs::read_to_string(PAGE).unwrap_or_default();
    // Another command keeps what it measured of bearings there.
    let bearings = old.find(BEARINGS).map_or("", |at| &old[at..]);
    let text = page(study, peers) + bearings;
    Ok(write_text(Path::new(PAGE), &text)?)
}

/// The text of the page.
pub fn page(study: &Study, peers: &Peers) -> String {
    let mut text = format!(
        "# Convergence\n\n\
         Written by `brinell converge problem-h --threads {} --levels {} --write`; do not edit.\n\n\
         Problem H: half a cylinder of 1.5 in radius pressed on a block, plane strain, 8.125 kip/in\n\
         ([`cases/problem-h.toml`](../cases/problem-h.toml)), on nested meshes: from level to level every\n\
         element is split into four, beginning with two elements across the half-width of the contact.\n\n\
         ![Error against CPU seconds, both elements and other programs](images/problem-h.svg)\n\n\
         *Sharp dips are where an error changes its sign. The other programs ran on meshes that stay coarse\n\
         away from the contact, Brinell on nested ones that are refined everywhere: more unknowns at the\n\
         same a/h, and errors that keep falling.*\n\n\
         ## Cost\n\n\
         Building the scene, solving it and reading its quantities, with {} thread{}; the mesh is made\n\
         before. Memory is the largest that the process had resident during the level{}. Unknowns are\n\
         those that are free: two components a node.\n\n",
        study.threads,
        study.levels.iter().map(|l| l.level + 1).max().unwrap_or(0),
        study.threads,
        if study.threads == 1 { "" } else { "s" },
        if study.levels.iter().all(|l| l.cost.peak_is_own) {
            ""
        } else {
            " (*: since it began)"
        },
    );
    text.push_str(&markdown(&cost(study)));
    text.push_str(
        "\n## Errors and orders\n\n\
         Errors are relative to the reference. p0 and half-width are measured from Hertz's line contact,\n\
         the peaks of Mises stress from an independent solver of the finite bodies, both with the\n\
         uncertainty that is given: errors below it mean nothing, and what the levels themselves tend to\n\
         stands beside. Orders p, in error ~ size^p, are observed: from the errors where the reference is\n\
         exact, else from the differences of three levels. p0, the largest of a few nodal values, has no\n\
         clean order.\n",
    );
    let curves = study.curves();
    for quantity in &study.quantities {
        let of: Vec<&Curve> = curves
            .iter()
            .filter(|c| c.quantity == quantity.name)
            .collect();
        text.push_str(&section(&of));
    }
    text.push_str(&others(peers));
    text
}

fn cost(study: &Study) -> Table {
    let mut table = Table::new("")
        .figures(["level", "a/h", "element", "elements", "unknowns"])
        .figures(["iterations", "wall s", "CPU s", "memory MB"]);
    for l in &study.levels {
        table.row([
            l.level.into(),
            format!("{:.0}", 2.0 / l.size).into(),
            l.element.into(),
            l.elements.into(),
            l.dofs.into(),
            l.iterations.into(),
            format!("{:.2}", l.cost.wall_s).into(),
            format!("{:.2}", l.cost.cpu_s).into(),
            memory(l).into(),
        ]);
    }
    table
}

/// A quantity: what its errors are measured from, and a row a size with all elements side by side.
fn section(curves: &[&Curve]) -> String {
    let Some(first) = curves.first() else {
        return String::new();
    };
    let unit = match first.unit.as_str() {
        "" => String::new(),
        unit => format!(", {unit}"),
    };
    let mut text = format!("\n### {}{unit}\n\n", first.quantity);
    for curve in curves {
        text.push_str(&format!("- {}: {}\n", curve.element, reference(curve)));
    }
    let mut table = Table::new("").figures(["a/h"]);
    for curve in curves {
        table = table.figures([curve.element, "error", "order"]);
    }
    for (i, size) in first.sizes.iter().enumerate() {
        let mut row = vec![format!("{:.0}", 2.0 / size).into()];
        for curve in curves {
            let at = |list: &[Option<f64>]| list.get(i).copied().flatten();
            let value = curve.values.get(i).map(|v| significant(*v, 6));
            row.extend([
                value.unwrap_or_default().into(),
                signed_percent(at(&curve.errors)).into(),
                order(at(&curve.orders)).into(),
            ]);
        }
        table.row(row);
    }
    text + "\n" + &markdown(&table)
}

fn others(peers: &Peers) -> String {
    let mut text = String::from("\n## Other programs\n\n");
    for line in &peers.origin {
        text.push_str(&format!("- {line}\n"));
    }
    text.push_str("\nMises errors: block / cylinder.\n\n");
    let mut table = Table::new("")
        .figures(["program", "a/h", "unknowns", "CPU s", "memory MB"])
        .figures(["p0", "half-width"])
        .figures(["Mises, integration point", "Mises, nodal"]);
    for curve in &peers.curves {
        for row in &curve.rows {
            let e = &row.error_percent;
            let one = |quantity: &str| signed_percent(PeerErrors::of(e, quantity));
            let two = |place: &str| {
                let of = |body: &str| one(&format!("Mises {body}, {place}"));
                format!("{} / {}", of("block"), of("cylinder"))
            };
            table.row([
                curve.name().into(),
                row.a_over_h.to_string().into(),
                row.unknowns.to_string().into(),
                row.cpu_s.to_string().into(),
                row.memory_mb.to_string().into(),
                one("p0").into(),
                one("half-width").into(),
                two("integration point").into(),
                two("nodal").into(),
            ]);
        }
    }
    text + &markdown(&table)
}

#[cfg(test)]
mod tests {
    use super::super::peers::peers;
    use super::super::sample::study;
    use super::*;

    #[test]
    fn the_page_has_every_level_curve_and_peer() {
        let text = page(&study(), &peers().unwrap());
        for words in [
            "| 2 | 8 | bbar | 64 | 1536 |",
            "### energy, ksi",
            "Kratos 10.4.4 hex8",
        ] {
            assert!(text.contains(words), "{words} in\n{text}");
        }
    }
}
