//! Problem H extruded to 40 layers, 1 in long: elastic contact with 181 thousand unknowns.

use crate::page::{Table, error, number, times};
use crate::reading::{Basis, half_width, nodal};
use crate::{Options, ccx, problem_h as plane, subject};
use brinell::model::mesh::family::problem_h as family;
use brinell::model::mesh::{Face, Mesh, Surface};
use brinell::proof::verify::problem_h::{HALF_WIDTH, Sizes};
use std::path::Path;

const LAYERS: usize = 40;
const LENGTH: f64 = 1.0;
/// Four elements across the half-width.
const SIZES: Sizes = Sizes {
    across: 4,
    growth: 1.18,
    parts: 1,
};
/// Pressure per overclosure of CalculiX, ksi/in: 500 E an inch. Its p0 is 2 to 3 % low with it;
/// stiffer contact oscillates on this mesh.
const STIFFNESS: &str = "1.475e7";

/// Both programs, and the table.
pub fn run(options: &Options, folder: &Path) -> Result<String, String> {
    let layer = family::half(&SIZES).map_err(|e| e.to_string())?;
    let mesh = extruded(&layer);
    println!("{} nodes, {} elements", mesh.points.len(), mesh.hexes.len());
    let mut table = Table::new(&[
        "program",
        "unknowns",
        "iterations",
        "wall, s",
        "CPU, s",
        "memory, MB",
        "p0, ksi",
        "half-width",
        "Mises block, nodal, ksi",
        "Mises cylinder, nodal, ksi",
    ]);
    let mut costs = Vec::new();
    // CalculiX solves on one thread here; two of ours share what a core has, and take longer each.
    let settings = [
        ("full", "direct", 1),
        ("full", "direct", 2),
        ("full", "divided", 2),
        ("bbar", "divided", 2),
    ];
    for (element, solver, threads) in settings {
        let controls = format!("element = \"{element}\"\nsolver = \"{solver}\"");
        let case = plane::write(folder, &mesh, true, &controls)?;
        let out = folder.join(format!("{element}-{solver}"));
        let run = subject::run(&case, &out, &[], threads, options.repeat)?;
        let name = match threads {
            1 => format!("{solver}, one thread"),
            _ => solver.to_string(),
        };
        let row = [
            format!("Brinell {element}, {name}"),
            run.number("/dofs").to_string(),
            run.number("/iterations").to_string(),
            number(run.cost.wall_s, 3),
            number(run.cost.cpu_s, 3),
            number(run.cost.peak_mb, 3),
            number(run.number("/interfaces/cylinder-block/max_pressure"), 4),
            "-".to_string(),
            number(run.number("/bodies/block/mises_max/nodal"), 4),
            number(run.number("/bodies/cylinder/mises_max/nodal"), 4),
        ];
        println!("{}", row.join("  "));
        table.row(&row);
        if element == "full" {
            costs.push((name, run.cost));
        }
    }
    let mut ratios = Table::new(&["program", "Brinell full", "wall", "CPU", "memory"]);
    let settings = [
        ("ITERATIVE CHOLESKY", "iterative-cholesky"),
        ("SPOOLES", "spooles"),
    ];
    for (name, solver) in settings
        .into_iter()
        .take(if options.spooles { 2 } else { 1 })
    {
        let deck = folder.join(solver);
        let case = plane::write(&deck, &mesh, true, "")?;
        let law = ["--contact-stiffness", STIFFNESS];
        let start = ["--increment", "1", "--closing", plane::OVERLAP];
        subject::export(
            &case,
            &deck,
            &[&law[..], &start, &["--solver", solver]].concat(),
        )?;
        let run = match ccx::run(&deck, "problem-h", mesh.points.len(), 2, 1) {
            Ok(run) => run,
            Err(error) => {
                println!("CalculiX, {name}: {error}");
                continue;
            }
        };
        let width = half_width(&mesh, &run.fields.pressure, Basis::Hat)?;
        let row = [
            format!("CalculiX, {name}"),
            run.equations.to_string(),
            run.iterations.to_string(),
            number(run.cost.wall_s, 3),
            number(run.cost.cpu_s, 3),
            number(run.cost.peak_mb, 3),
            number(run.fields.peak_pressure(), 4),
            error(width, HALF_WIDTH),
            number(nodal(&mesh, &run.fields, "block"), 4),
            number(nodal(&mesh, &run.fields, "cylinder"), 4),
        ];
        println!("{}", row.join("  "));
        table.row(&row);
        for (ours, cost) in &costs {
            ratios.row(&[
                format!("CalculiX, {name}"),
                ours.clone(),
                times(run.cost.wall_s, cost.wall_s),
                times(run.cost.cpu_s, cost.cpu_s),
                times(run.cost.peak_mb, cost.peak_mb),
            ]);
        }
    }
    let over = "\nOver Brinell with the same element:\n\n";
    Ok(format!("{}{over}{}", table.render(), ratios.render()))
}

/// The one layer of `mesh`, again and again along z.
fn extruded(mesh: &Mesh) -> Mesh {
    let front = mesh.points.iter().map(|p| p[2]).fold(0.0, f64::max);
    let base: Vec<usize> = (0..mesh.points.len())
        .filter(|n| mesh.points[*n][2] < 0.5 * front)
        .collect();
    // Of every node, its place among those of the back face; a front node takes that of the node
    // behind it, found by the edges of the hexahedra that run along z.
    let mut place = vec![0; mesh.points.len()];
    for (k, node) in base.iter().enumerate() {
        place[*node] = k;
    }
    let is_front = |n: u32| mesh.points[n as usize][2] > 0.5 * front;
    for hex in &mesh.hexes {
        for node in hex.iter().filter(|n| is_front(**n)) {
            let [x, y, _] = mesh.points[*node as usize];
            let distance = |n: &u32| {
                let p = mesh.points[*n as usize];
                (p[0] - x).hypot(p[1] - y)
            };
            let behind = hex.iter().filter(|n| !is_front(**n));
            if let Some(behind) = behind.min_by(|a, b| distance(a).total_cmp(&distance(b))) {
                place[*node as usize] = place[*behind as usize];
            }
        }
    }
    let at = |node: u32, layer: usize| {
        let layer = layer + usize::from(is_front(node));
        (layer * base.len() + place[node as usize]) as u32
    };
    let mut points = Vec::new();
    for layer in 0..=LAYERS {
        let z = LENGTH * layer as f64 / LAYERS as f64;
        points.extend(
            base.iter()
                .map(|n| [mesh.points[*n][0], mesh.points[*n][1], z]),
        );
    }
    let mut hexes = Vec::new();
    let mut bodies = mesh.bodies.clone();
    for body in &mut bodies {
        let start = hexes.len();
        for layer in 0..LAYERS {
            let cells = mesh.hexes[body.elements.clone()].iter();
            hexes.extend(cells.map(|hex| hex.map(|n| at(n, layer))));
        }
        body.elements = start..hexes.len();
    }
    // The element of `layer` that `element` of the one layer became.
    let moved = |element: u32, layer: usize| {
        let body = mesh.body_of(element as usize);
        let old = &mesh.bodies[body].elements;
        (bodies[body].elements.start + layer * old.len() + element as usize - old.start) as u32
    };
    let surfaces = mesh.surfaces.iter().map(|surface| {
        let layers = match surface.name.as_str() {
            "back" => 0..1,
            "front" => LAYERS - 1..LAYERS,
            _ => 0..LAYERS,
        };
        let faces = layers.flat_map(|layer| surface.faces.iter().map(move |face| (face, layer)));
        let faces = faces.map(|(face, layer)| Face {
            nodes: face.nodes.map(|n| at(n, layer)),
            element: moved(face.element, layer),
        });
        Surface {
            name: surface.name.clone(),
            faces: faces.collect(),
        }
    });
    Mesh {
        source: "problem H, extruded".into(),
        surfaces: surfaces.collect(),
        points,
        hexes,
        bodies,
        ..Mesh::default()
    }
}
