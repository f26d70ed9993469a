//! A beam of two parts that are tied, node by node. Brinell joins them in the mean, CalculiX puts each node of one side on
//! the face opposite: both tend to the beam of one part, and differ by what the meshes at the tie leave out.

use crate::page::{Table, error, number};
use crate::{ccx, subject};
use brinell::case;
use brinell::ground::geometry::{norm, sub};
use brinell::product::job::{self, Outcome};
use brinell::solver::solve::Silent;
use std::path::Path;

const CASE: &str = "cases/tied/beam.toml";
const SURFACES: &str = "[\"root_end\", \"end_root\"]";
const SWAPPED: &str = "[\"end_root\", \"root_end\"]";

/// Difference of displacements at a node, of the largest. What a tie leaves out at nodes between those of the other
/// side is of second order in the size of facets over that of the section, here 1/16, of what the section itself does: the
/// tip turns by a few hundredths of that.
const LIMIT: f64 = 0.005;

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
    let solve = |name: &str, text: &str| -> Result<Outcome, String> {
        let path = folder.join(format!("{name}.toml"));
        std::fs::write(&path, text).map_err(|e| format!("{}: {e}", path.display()))?;
        let case = case::read(&path).map_err(|e| e.to_string())?;
        let settings = job::Options {
            out: Some(folder.join(name)),
            ..job::Options::default()
        };
        job::run(&case, &settings, &mut Silent).map_err(|e| e.to_string())
    };
    let ours = solve("case", &text)?;
    let other = solve("swapped", &text.replace(SURFACES, SWAPPED))?;
    subject::export(&folder.join("case.toml"), folder, &[])?;
    let points = &ours.scene.mesh.points;
    let theirs = ccx::run(folder, "case", points.len(), 2, 1)?
        .fields
        .displacement;
    let mine = &ours.state().displacement;
    let largest = mine.iter().map(|u| norm(*u)).fold(0.0, f64::max);
    let apart = |other: &[[f64; 3]]| {
        let pairs = mine.iter().zip(other);
        pairs.map(|(a, b)| norm(sub(*a, *b))).fold(0.0, f64::max) / largest
    };
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
    let off = apart(&theirs);
    let per_cent = |share: f64| format!("{:.3} %", 100.0 * share);
    let words = format!(
        "Largest difference of displacement at a node, of the largest: {}; {} is allowed. Between the two sides that may \
         follow it is {} in Brinell.\n",
        per_cent(off),
        per_cent(LIMIT),
        per_cent(apart(&other.state().displacement)),
    );
    let text = format!("{}\n{words}", table.render());
    match off <= LIMIT {
        true => Ok(text),
        false => Err(text),
    }
}
