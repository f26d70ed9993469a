//! Problem H: which mesh reaches 1 % and 0.3 % in every figure, and at what cost.

use crate::page::{Table, error, number, times};
use crate::process::Cost;
use crate::reading::{LIMITS, READINGS, Values, of_fields, within};
use crate::{Options, ccx, subject};
use brinell::model::mesh::Mesh;
use brinell::model::mesh::family::problem_h as family;
use brinell::model::mesh::msh::write::msh41;
use brinell::model::scene::ElementKind;
use brinell::proof::verify::problem_h::{self, Sizes};
use brinell::solver::solve::{Silent, solve};
use std::path::{Path, PathBuf};

/// All within these.
const GOALS: [f64; 2] = [0.01, 0.003];
/// Pressure per overclosure of the mortar contact of CalculiX, ksi/in: 50000 E an inch.
const STIFFNESS: &str = "1.475e9";
/// Overlap that CalculiX starts from, in: a² / 8 R; it converges sooner than from a touch.
pub const OVERLAP: &str = "7.978e-5";
/// Elements of CalculiX across the half-width.
const PEER_SIZES: [usize; 8] = [4, 5, 6, 7, 8, 10, 12, 16];
/// Meshes of Brinell: elements across the half-width, and growth from one to the next beyond.
const OUR_SIZES: std::ops::RangeInclusive<usize> = 4..=18;
const OUR_GROWTHS: [f64; 5] = [1.2, 1.3, 1.5, 1.7, 2.0];

/// One solution.
struct Row {
    name: String,
    mesh: String,
    dofs: usize,
    iterations: usize,
    cost: Cost,
    values: Values,
}

/// Both programs, and the table.
pub fn run(options: &Options, folder: &Path) -> Result<String, String> {
    let mut rows = Vec::new();
    for candidate in candidates()? {
        rows.push(candidate.timed(&folder.join("brinell"), options.repeat)?);
        println!("{}", cells(&rows[rows.len() - 1]).join("  "));
    }
    let ours = rows.len();
    for across in PEER_SIZES {
        for element in ["C3D8", "C3D8R"] {
            match peer(across, element, &folder.join("ccx"), options.repeat) {
                Ok(row) => {
                    println!("{}", cells(&row).join("  "));
                    rows.push(row);
                }
                Err(error) => println!("CalculiX {element}, {across} across: {error}"),
            }
        }
    }
    Ok(render(&rows, ours))
}

/// A mesh and element of Brinell.
struct Candidate {
    sizes: Sizes,
    element: ElementKind,
    values: Values,
    dofs: usize,
    iterations: usize,
}

/// Of a grid of meshes and all elements, those with the fewest unknowns that reach each goal.
fn candidates() -> Result<Vec<Candidate>, String> {
    const KEPT: usize = 3;
    let mut all = Vec::new();
    for across in OUR_SIZES {
        for growth in OUR_GROWTHS {
            for element in [ElementKind::Bbar, ElementKind::Full, ElementKind::Enhanced] {
                let sizes = Sizes {
                    across,
                    growth,
                    parts: 1,
                };
                all.push(Candidate::solve(sizes, element)?);
            }
        }
    }
    all.sort_by_key(|c| c.dofs);
    let mut wanted = vec![false; all.len()];
    for goal in GOALS {
        for reading in 0..READINGS.len() {
            let good = |c: &Candidate| within(&c.values, reading, goal);
            let found = (0..all.len()).filter(|i| good(&all[*i])).take(KEPT);
            found.for_each(|i| wanted[i] = true);
        }
    }
    let kept = all.into_iter().zip(wanted);
    Ok(kept.filter(|(_, wanted)| *wanted).map(|(c, _)| c).collect())
}

impl Candidate {
    fn solve(sizes: Sizes, element: ElementKind) -> Result<Self, String> {
        let mut scene = problem_h::scene(&sizes).map_err(|e| e.to_string())?;
        scene.controls.element = element;
        let solution = solve(&mut scene, &mut Silent).map_err(|e| e.to_string())?;
        let r = problem_h::read(&scene, &solution.last).map_err(|e| e.to_string())?;
        Ok(Self {
            sizes,
            element,
            values: Values {
                contact: [r.pressure, r.half_width],
                mises: [
                    [r.block.nodal, r.cylinder.nodal],
                    [r.block.centroid, r.cylinder.centroid],
                ],
            },
            dofs: solution.counters.equations,
            iterations: solution.counters.iterations,
        })
    }

    /// The program as a process on the same mesh, from a file.
    fn timed(&self, folder: &Path, repeat: usize) -> Result<Row, String> {
        let element = brinell::product::converge::study::element_name(self.element);
        let mesh = family::half(&self.sizes).map_err(|e| e.to_string())?;
        let case = write(folder, &mesh, true, &format!("element = \"{element}\""))?;
        let run = subject::run(&case, folder, &[], 1, repeat)?;
        Ok(Row {
            name: format!("Brinell {element}"),
            mesh: format!("{}, growth {}", self.sizes.across, self.sizes.growth),
            dofs: self.dofs,
            iterations: self.iterations,
            cost: run.cost,
            values: self.values,
        })
    }
}

/// Writes problem H on `mesh` into `folder`: the shipped case on a mesh file. Returns its path.
///
/// # Errors
/// Where the folder cannot be written.
pub fn write(folder: &Path, mesh: &Mesh, half: bool, controls: &str) -> Result<PathBuf, String> {
    let case = include_str!("../../cases/problem-h.toml");
    let text = case
        .replace("family = \"problem-h\"", "file = \"problem-h.msh\"")
        .replace("level = 2", "");
    let text = match half {
        true => text,
        // The whole of it: no plane x = 0 to hold.
        false => text
            .replace("symmetry = [\"x\"]", "")
            .replace("[[support]]\nsurface = \"symmetry\"\nfixed = \"x\"", ""),
    };
    let failed = |e: std::io::Error| format!("{}: {e}", folder.display());
    std::fs::create_dir_all(folder).map_err(failed)?;
    std::fs::write(folder.join("problem-h.msh"), msh41(mesh)).map_err(failed)?;
    let path = folder.join("problem-h.toml");
    std::fs::write(&path, format!("{text}\n[controls]\n{controls}\n")).map_err(failed)?;
    Ok(path)
}

/// CalculiX with mortar contact on the whole model: its multipliers want a carrier that no
/// symmetry plane holds.
fn peer(across: usize, element: &str, folder: &Path, repeat: usize) -> Result<Row, String> {
    let folder = folder.join(format!("{element}-{across}"));
    let mesh = family::full(&Sizes::with(across)).map_err(|e| e.to_string())?;
    let case = write(&folder, &mesh, false, "")?;
    let mortar = ["--contact", "mortar", "--contact-stiffness", STIFFNESS];
    let more = [
        "--element",
        element,
        "--increment",
        "1",
        "--closing",
        OVERLAP,
    ];
    subject::export(&case, &folder, &[&mortar[..], &more[..]].concat())?;
    let run = ccx::run(&folder, "problem-h", mesh.points.len(), 1, repeat)?;
    Ok(Row {
        name: format!("CalculiX {element}, mortar"),
        mesh: format!("{across}, growth 1.2, whole"),
        dofs: run.equations,
        iterations: run.iterations,
        cost: run.cost,
        values: of_fields(&mesh, &run.fields)?,
    })
}

fn cells(row: &Row) -> Vec<String> {
    let mut cells = vec![
        row.name.clone(),
        row.mesh.clone(),
        row.dofs.to_string(),
        row.iterations.to_string(),
        number(row.cost.wall_s, 3),
        number(row.cost.cpu_s, 3),
        number(row.cost.peak_mb, 3),
    ];
    let values = &row.values;
    let errors = values.contact.iter().zip(LIMITS.contact);
    cells.extend(errors.map(|(value, limit)| error(*value, limit)));
    for [block, cylinder] in values.mises {
        let [b, c] = LIMITS.mises[0];
        cells.push(format!("{} / {}", error(block, b), error(cylinder, c)));
    }
    cells
}

fn render(rows: &[Row], ours: usize) -> String {
    let mut table = Table::new(&[
        "program",
        "elements across a",
        "unknowns",
        "iterations",
        "wall, s",
        "CPU, s",
        "memory, MB",
        "p0",
        "half-width",
        "Mises block / cylinder, nodal",
        "the same, centroid",
    ]);
    for row in rows {
        table.row(&cells(row));
    }
    let mut text = table.render().to_string();
    let (ours, theirs) = rows.split_at(ours);
    text.push_str("\nThe least time of the processor in which all figures are right:\n\n");
    let mut least = Table::new(&[
        "within", "Mises", "Brinell", "CPU, s", "CalculiX", "CPU, s", "ratio",
    ]);
    for goal in GOALS {
        for (reading, name) in READINGS.iter().enumerate() {
            let fastest = |rows: &[Row]| {
                let good = rows.iter().filter(|r| within(&r.values, reading, goal));
                good.map(|r| (r.cost.cpu_s, format!("{}, {}", r.name, r.mesh)))
                    .min_by(|a, b| a.0.total_cmp(&b.0))
            };
            let (a, b) = (fastest(ours), fastest(theirs));
            let ratio = a.as_ref().zip(b.as_ref()).map(|(a, b)| times(b.0, a.0));
            let show = |best: Option<(f64, String)>| match best {
                Some((cpu, name)) => [name, number(cpu, 3)],
                None => ["none".to_string(), "-".to_string()],
            };
            let ([our_name, our_cpu], [their_name, their_cpu]) = (show(a), show(b));
            least.row(&[
                format!("{} %", 100.0 * goal),
                (*name).to_string(),
                our_name,
                our_cpu,
                their_name,
                their_cpu,
                ratio.unwrap_or_else(|| "-".into()),
            ]);
        }
    }
    text + least.render()
}
