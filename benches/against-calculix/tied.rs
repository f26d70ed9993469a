//! A beam of two parts that are tied, node by node. Brinell joins them in the mean, CalculiX puts each node of one side on
//! the face opposite: both tend to the beam of one part, and differ by what the meshes at the tie leave out.

use crate::page::{Table, error, number};
use crate::{ccx, subject};
use brinell::case;
use brinell::ground::geometry::{norm, sub};
use brinell::product::job;
use brinell::solver::solve::Silent;
use std::path::Path;

const CASE: &str = "cases/tied/beam.toml";
/// Largest difference of displacements at a node, of the largest one. What either way leaves out is local to the layers of
/// elements at the tie, two of 29, whose compliance under bending they see to a few per cent: a few thousandths of that
/// of the beam, and the two ways differ by a part of it.
const LIMIT: f64 = 0.001;

/// Solves the case by both programs and compares.
///
/// # Errors
/// Where a program fails, or the two differ by more than is allowed; the latter with the table.
pub fn run(folder: &Path) -> Result<String, String> {
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join(CASE);
    let text = std::fs::read_to_string(&shipped).map_err(|e| format!("{CASE}: {e}"))?;
    let mesh = shipped.with_extension("msh");
    std::fs::copy(&mesh, folder.join("beam.msh"))
        .map_err(|e| format!("{}: {e}", mesh.display()))?;
    let text = text.replace("\"enhanced\"", "\"full\"");
    let path = folder.join("case.toml");
    std::fs::write(&path, text).map_err(|e| format!("{}: {e}", path.display()))?;
    let case = case::read(&path).map_err(|e| e.to_string())?;
    let settings = job::Options {
        out: Some(folder.join("out")),
        ..job::Options::default()
    };
    let ours = job::run(&case, &settings, &mut Silent).map_err(|e| e.to_string())?;
    subject::export(&path, folder, &[])?;
    let points = &ours.scene.mesh.points;
    let theirs = ccx::run(folder, "case", points.len(), 2, 1)?
        .fields
        .displacement;
    let mine = &ours.state().displacement;
    let largest = mine.iter().map(|u| norm(*u)).fold(0.0, f64::max);
    let pairs = mine.iter().zip(&theirs);
    let off = pairs.map(|(a, b)| norm(sub(*a, *b))).fold(0.0, f64::max) / largest;
    let tip = ours
        .scene
        .mesh
        .surface("tip")
        .map(|s| s.nodes())
        .unwrap_or_default();
    let down = |u: &[[f64; 3]]| {
        let sum: f64 = tip.iter().map(|n| -u[*n as usize][2]).sum();
        sum / tip.len() as f64
    };
    let mut table = Table::new(&["figure", "Brinell", "CalculiX", "difference"]);
    let [a, b] = [down(mine), down(&theirs)];
    let words = "mean of the tip's nodes, down, mm".to_string();
    table.row(&[words, number(a, 5), number(b, 5), error(b, a)]);
    let per_cent = |share: f64| format!("{:.3} %", 100.0 * share);
    let words = format!(
        "Largest difference of displacement at a node, of the largest: {}; {} is allowed.\n",
        per_cent(off),
        per_cent(LIMIT),
    );
    let text = format!("{}\n{words}", table.render());
    match off <= LIMIT {
        true => Ok(text),
        false => Err(text),
    }
}
