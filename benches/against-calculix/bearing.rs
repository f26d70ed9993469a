//! The centre bearing on one mesh: elastic-plastic, with friction, a quarter model.

use crate::page::{Table, number, times};
use crate::process::Cost;
use crate::{Options, ccx, subject};
use brinell::case::{self, Case, Kind};
use brinell::model::mesh::{Mesh, msh};
use brinell::product::job::make_mesh;
use std::path::{Path, PathBuf};

const CASE: &str = "cases/section-2.6.2/initial-centre.toml";
/// Share of the descent that the closing step of ccx makes by motion: the rest is one increment.
const CLOSING: f64 = 0.9;

/// The figures of one run.
struct Row {
    name: String,
    dofs: f64,
    iterations: f64,
    cost: Cost,
    /// Descent, p0, largest nodal Mises stress, nodal Mises stress on the bore.
    values: [f64; 4],
}

/// Both programs on the preset `h0125`, its element sizes times `scale`.
pub fn run(options: &Options, folder: &Path, scale: f64) -> Result<String, String> {
    let [plain, full, quarter] =
        ["bbar", "full", "quarter"].map(|name| folder.join(format!("{name}.toml")));
    let case = cases(scale, [&plain, &full, &quarter])?;
    let mesh = mesh(&case, folder)?;
    println!("{} nodes, {} elements", mesh.points.len(), mesh.hexes.len());
    let mut rows = Vec::new();
    let once: &[&str] = &["--no-elastic-peaks"];
    let settings = [
        ("same element, solved once", &full, once),
        ("the same without its half turn", &quarter, once),
        ("same element", &full, &[]),
        ("B-bar, its default", &plain, &[]),
    ];
    for (name, path, more) in settings {
        // All runs take the mesh from the folder.
        let run = subject::run(path, folder, more, 2, options.repeat)?;
        rows.push(Row {
            name: format!("Brinell, {name}"),
            dofs: run.number("/dofs"),
            iterations: run.number("/iterations"),
            cost: run.cost,
            values: [
                run.number("/descent_of_mesh"),
                run.largest("interfaces", "/max_pressure"),
                run.largest("bodies", "/mises_max/nodal"),
                run.largest("rollers", "/bore_mises_nodal"),
            ],
        });
        println!("{}", line(&rows[rows.len() - 1]));
    }
    let closing = (CLOSING * rows[0].values[0]).to_string();
    for (name, solver) in options.solvers() {
        let deck = folder.join(solver);
        std::fs::create_dir_all(&deck).map_err(|e| format!("{}: {e}", deck.display()))?;
        let kept = std::fs::copy(folder.join(MESH), deck.join(MESH));
        kept.map_err(|e| format!("{}: {e}", deck.display()))?;
        let more = [
            "--closing",
            &closing,
            "--increment",
            "1",
            "--solver",
            solver,
        ];
        subject::export(&full, &deck, &more)?;
        match ccx::run(&deck, "full", mesh.points.len(), 2, 1) {
            Ok(run) => {
                rows.push(Row {
                    name: format!("CalculiX, {name}"),
                    dofs: run.equations as f64,
                    iterations: run.iterations as f64,
                    cost: run.cost,
                    values: values(&mesh, &run)?,
                });
                println!("{}", line(&rows[rows.len() - 1]));
            }
            Err(error) => println!("CalculiX, {name}: {error}"),
        }
    }
    Ok(render(&rows))
}

fn values(mesh: &Mesh, run: &ccx::Run) -> Result<[f64; 4], String> {
    let nodes = |name: &str| match mesh.surface(name) {
        Some(surface) => Ok(surface.nodes()),
        None => Err(format!("the mesh has no surface {name}")),
    };
    let top = nodes("upper_plate_top")?;
    let bores = [nodes("upper_roller_bore")?, nodes("lower_roller_bore")?].concat();
    let descent = top
        .first()
        .map_or(f64::NAN, |n| -run.fields.displacement[*n as usize][2]);
    Ok([
        descent,
        run.fields.peak_pressure(),
        run.fields.peak_mises(|_| true),
        run.fields.peak_mises(|n| bores.contains(&(n as u32))),
    ])
}

const MESH: &str = "mesh.msh.gz";

/// The mesh in `folder`, made where there is none of this bearing.
fn mesh(case: &Case, folder: &Path) -> Result<Mesh, String> {
    let Kind::Bearing(bearing) = &case.kind else {
        return Err("the case is no bearing".into());
    };
    let path: PathBuf = folder.join(MESH);
    match msh::read(&path) {
        Ok(mesh) if mesh.fingerprint == Some(bearing.fingerprint()) => Ok(mesh),
        _ => make_mesh(case, &path).map_err(|e| e.to_string()),
    }
}

/// Writes the shipped case with the preset `h0125`, its sizes times `scale`, to `plain`, with plain hexahedra to `full`,
/// and that without the symmetry of a half turn, which CalculiX does not use, to `quarter`.
fn cases(scale: f64, [plain, full, quarter]: [&Path; 3]) -> Result<Case, String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(CASE);
    let mut case = case::read(&path).map_err(|e| e.to_string())?;
    case.set_preset("h0125").map_err(|e| e.to_string())?;
    let mut table = "preset = \"h0125\"".to_string();
    if scale != 1.0 {
        case.scale_mesh(scale, 1.0).map_err(|e| e.to_string())?;
        table += &format!("\nscale = {scale}");
    }
    let text = case.source.text().replace("preset = \"auto\"", &table);
    let write = |path: &Path, text: &str| {
        std::fs::write(path, text).map_err(|e| format!("{}: {e}", path.display()))
    };
    write(plain, &text)?;
    let full_text = format!("{text}\n[controls]\nelement = \"full\"\n");
    write(full, &full_text)?;
    write(quarter, &format!("{full_text}half_turn = false\n"))?;
    case::read(plain).map_err(|e| e.to_string())
}

fn cells(row: &Row) -> Vec<String> {
    let [descent, p0, mises, bore] = row.values;
    vec![
        row.name.clone(),
        format!("{}", row.dofs),
        format!("{}", row.iterations),
        number(row.cost.wall_s, 3),
        number(row.cost.cpu_s, 3),
        number(row.cost.peak_mb, 3),
        number(1e3 * descent, 4),
        number(bore, 4),
        number(mises, 4),
        number(p0, 4),
    ]
}

fn line(row: &Row) -> String {
    cells(row).join("  ")
}

fn render(rows: &[Row]) -> String {
    let mut table = Table::new(&[
        "program",
        "unknowns",
        "iterations",
        "wall, s",
        "CPU, s",
        "memory, MB",
        "descent, 1e-3 in",
        "bore Mises, nodal, ksi",
        "largest Mises, nodal, ksi",
        "p0, ksi",
    ]);
    for row in rows {
        table.row(&cells(row));
    }
    let mut text = table.render().to_string();
    text.push_str("\nOver Brinell with the same element:\n\n");
    let head = [
        "program",
        "over",
        "wall",
        "CPU",
        "memory",
        "descent",
        "bore Mises",
    ];
    let mut ratios = Table::new(&head);
    let peers = rows.iter().filter(|row| !row.name.starts_with("Brinell"));
    for (row, ours) in peers.flat_map(|row| rows[..2].iter().map(move |ours| (row, ours))) {
        ratios.row(&[
            row.name.clone(),
            ours.name.clone(),
            times(row.cost.wall_s, ours.cost.wall_s),
            times(row.cost.cpu_s, ours.cost.cpu_s),
            times(row.cost.peak_mb, ours.cost.peak_mb),
            crate::page::error(row.values[0], ours.values[0]),
            crate::page::error(row.values[3], ours.values[3]),
        ]);
    }
    text + ratios.render()
}
