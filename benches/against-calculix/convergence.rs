//! Errors of a bearing against seconds and memory, with elastic steel: every preset, targets, and CalculiX.
//!
//! Errors are those from the true values of the coverage suite (cases/coverage), which two fine meshes tell.

use crate::frd::Fields;
use crate::page::{Table, number};
use crate::process::Cost;
use crate::{ccx, subject};
use brinell::answer::results::edges::SingularEdges;
use brinell::answer::results::peaks::peaks;
use brinell::answer::results::recovery::{Recovered, recover};
use brinell::answer::results::tensor::mises;
use brinell::case;
use brinell::model::mesh::Mesh;
use brinell::model::scene::{ContactPair, Scene};
use brinell::product::job::{self, Options, Outcome};
use brinell::proof::verify::coverage::{References, Set, Truth};
use brinell::render::plot::{Line, Panel, PlotFigure, Scale, write};
use brinell::solver::solve::Silent;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A bearing of the coverage suite, and what is tried on it.
pub struct Subject {
    /// Its name there, and of the picture.
    pub bearing: &'static str,
    targets: &'static [&'static str],
    /// Of CalculiX's meshes: the preset, and their sizes over those of it.
    preset: &'static str,
    scales: [f64; 4],
    /// First increment of the load there, and the share of the descent that its closing step makes by motion.
    increment: &'static str,
    closing: Option<f64>,
}

pub const CENTRE: Subject = Subject {
    bearing: "centre",
    targets: &["10%", "5%", "3%", "2%", "1%"],
    preset: "h0125",
    scales: [2.0, 1.5, 1.2, 1.0],
    increment: "1",
    closing: Some(0.9),
};

/// Rollers 2.5 in off the centre.
pub const DISPLACED: Subject = Subject {
    bearing: "displaced",
    targets: &["10%", "5%", "3%", "2%"],
    preset: "h025",
    scales: [2.4, 1.9, 1.5, 1.2],
    increment: "0.25",
    closing: None,
};

const PRESETS: [&str; 4] = ["report-like", "h025", "auto", "h0125"];

/// What errors are shown of, in words and in the certificate, and where: away from the ends of rollers.
const SHOWN: [(&str, &[&str], &str); 4] = [
    (
        "p max",
        &["peak_pressure"],
        "upper_roller-intermediate_plate",
    ),
    ("Mises", &["mises_away", "peak_mises"], "upper_plate"),
    ("bore", &["bore_mises"], "upper_roller"),
    ("descent", &["descent"], "overall"),
];

/// A run: what it cost, and its errors with their bars, as shares of the true values.
struct Row {
    name: String,
    unknowns: f64,
    cost: Cost,
    errors: [Option<f64>; 4],
    bars: [Option<f64>; 4],
}

/// Tables of the bearing; its picture is drawn where `picture` says.
///
/// # Errors
/// Where a program fails or there are no true values.
pub fn run(folder: &Path, subject: &Subject, picture: Option<&Path>) -> Result<String, String> {
    let truths = truths(subject)?;
    let path = case_file(subject, folder)?;
    let mut rows = Vec::new();
    let mut keep = |row: Row| {
        println!("{}", cells(&row).join("  "));
        rows.push(row);
    };
    for preset in PRESETS {
        let out = folder.join(preset);
        let words = ["--elastic", "--mesh", preset];
        let run = subject::run(&path, &out, &words, 2, 1)?;
        keep(own(
            format!("Brinell, `{preset}`"),
            run.cost,
            &run.summary,
            &truths,
        ));
    }
    for target in subject.targets {
        let out = folder.join(target);
        // Levels of an earlier run are not those of this one.
        let _ = std::fs::remove_dir_all(&out);
        let words = ["--elastic", "--target", target];
        match subject::run_levels(&path, &out, &words, 2) {
            Ok((cost, summary)) => {
                let name = format!("Brinell, `--target {target}`");
                keep(own(name, cost, &summary, &truths));
            }
            Err(error) => println!("{target}: {error}"),
        }
    }
    for scale in subject.scales {
        let own_folder = folder.join(scale.to_string());
        match peer(subject, &path, &own_folder, scale, &truths) {
            Ok(row) => keep(row),
            Err(error) => println!("CalculiX, {scale}: {error}"),
        }
    }
    if let Some(picture) = picture {
        write(&figure(&rows), picture).map_err(|e| e.to_string())?;
    }
    Ok(table(&rows))
}

/// The true values of [`SHOWN`].
fn truths(subject: &Subject) -> Result<[Truth; 4], String> {
    let references = References::read(Set::Named).map_err(|e| e.to_string())?;
    let scatter = references.scatter();
    let bearings = Set::Named.bearings();
    let bearing = bearings.iter().find(|b| b.name == subject.bearing);
    let stored = bearing.and_then(|b| references.of(b)?.elastic.as_ref());
    let stored = stored.ok_or_else(|| format!("no true values of {}", subject.bearing))?;
    let truth = |(name, kinds, place): (&str, &[&str], &str)| {
        let found = kinds.iter().find_map(|k| stored.truth(k, place, &scatter));
        found.ok_or_else(|| format!("no true value of {name}"))
    };
    let found: Result<Vec<_>, _> = SHOWN.into_iter().map(truth).collect();
    found?.try_into().map_err(|_| "four figures".to_owned())
}

/// The case without unloading.
fn case_file(subject: &Subject, folder: &Path) -> Result<PathBuf, String> {
    let shipped = format!("cases/coverage/{}.toml", subject.bearing);
    let text = std::fs::read_to_string(&shipped).map_err(|e| format!("{shipped}: {e}"))?;
    let path = folder.join("case.toml");
    let text = text.replace("unload = true", "");
    std::fs::write(&path, text).map_err(|e| format!("{}: {e}", path.display()))?;
    Ok(path)
}

/// What Brinell claims.
fn own(name: String, cost: Cost, summary: &Value, truths: &[Truth; 4]) -> Row {
    let claims = summary["certificate"].as_array();
    let claim = |(_, kinds, place): (&str, &[&str], &str)| {
        kinds.iter().find_map(|kind| {
            let is = |c: &&Value| c["what"] == *kind && c["where"] == place;
            claims?.iter().find(is)
        })
    };
    let claims = SHOWN.map(claim);
    let share = |key: &str, k: usize| Some(claims[k]?[key].as_f64()? / truths[k].value);
    Row {
        name,
        unknowns: summary["dofs"].as_f64().unwrap_or(f64::NAN),
        cost,
        errors: std::array::from_fn(|k| share("value", k).map(|ratio| ratio - 1.0)),
        bars: std::array::from_fn(|k| share("error", k)),
    }
}

/// CalculiX on a mesh of its own, with the deck that `brinell export` writes.
fn peer(
    subject: &Subject,
    case: &Path,
    folder: &Path,
    scale: f64,
    truths: &[Truth; 4],
) -> Result<Row, String> {
    std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let path = folder.join("case.toml");
    let text = std::fs::read_to_string(case).map_err(|e| format!("{}: {e}", case.display()))?;
    let more = format!(
        "\n[mesh]\npreset = \"{}\"\nscale = {scale}\n[controls]\nelement = \"full\"\nplasticity = false\n",
        subject.preset
    );
    std::fs::write(&path, text + &more).map_err(|e| format!("{}: {e}", path.display()))?;
    let ours = solved(&path, folder)?;
    let mut words = vec!["--increment", subject.increment, "--solver", "spooles"];
    let descent = ours.summary.answer.descent_of_mesh;
    let closing = subject.closing.zip(descent).map(|(share, d)| share * d);
    let closing = closing.map(|length| length.to_string());
    if let Some(closing) = &closing {
        words.extend(["--closing", closing]);
    }
    subject::export(&path, folder, &words)?;
    let run = ccx::run(folder, "case", ours.scene.mesh.points.len(), 2, 1)?;
    let values = theirs(&ours, &run.fields)?;
    Ok(Row {
        name: format!("CalculiX, `{}` times {scale}", subject.preset),
        unknowns: run.equations as f64,
        cost: run.cost,
        errors: std::array::from_fn(|k| Some(values[k] / truths[k].value - 1.0)),
        bars: [None; 4],
    })
}

/// Brinell's own solution on that mesh: where loaded edges are, and how far the bearing goes down.
fn solved(path: &Path, folder: &Path) -> Result<Outcome, String> {
    let case = case::read(path).map_err(|e| e.to_string())?;
    let options = Options {
        out: Some(folder.to_path_buf()),
        ..Options::default()
    };
    job::run(&case, &options, &mut Silent).map_err(|e| e.to_string())
}

/// The figures of [`SHOWN`] at CalculiX's nodes, with the edges that Brinell leaves out.
fn theirs(ours: &Outcome, fields: &Fields) -> Result<[f64; 4], String> {
    let (scene, state) = (&ours.scene, ours.state());
    let mesh = &scene.mesh;
    let mut recovered = recover(scene, state);
    read_stress(scene, fields, &mut recovered);
    let edges = SingularEdges::find(scene, state);
    let bodies = peaks((scene, state), &recovered, &edges, &[]);
    let body = |name: &str| bodies.iter().find(|b| b.name == name);
    let plate = body(SHOWN[1].2).and_then(|b| b.away.map(|(_, away)| away.nodal).or(b.nodal));
    let pair = scene.contacts.iter().find(|pair| pair.name == SHOWN[0].2);
    let pressed = pair.map_or(Vec::new(), |pair| carrier_nodes(mesh, pair));
    let pressures = pressed.iter().map(|n| fields.pressure[*n as usize]);
    let nodes = |name: &str| {
        let surface = mesh.surface(name);
        surface.map_or(Vec::new(), |surface| surface.nodes())
    };
    let bore = nodes("upper_roller_bore");
    let top = nodes("upper_plate_top");
    let top = top.first().ok_or("the upper plate has no top")?;
    Ok([
        pressures.fold(0.0, f64::max),
        plate.map_or(f64::NAN, |peak| peak.value),
        fields.peak_mises(|n| bore.contains(&(n as u32))),
        -fields.displacement[*top as usize][2],
    ])
}

/// Nodes of the side that carries the pressure of a pair, as far as they lie towards the other side: a roller has one
/// surface for two contacts.
fn carrier_nodes(mesh: &Mesh, pair: &ContactPair) -> Vec<u32> {
    let [own, other] = pair.carrier_first().map(|partner| {
        let surface = partner.surface(mesh);
        surface.map_or(Vec::new(), |surface| surface.nodes())
    });
    let height = |n: &u32| mesh.points[*n as usize][2];
    let middle = |nodes: &[u32]| nodes.iter().map(height).sum::<f64>() / nodes.len() as f64;
    let (at, towards) = (middle(&own), middle(&other));
    let faces = |n: &u32| (height(n) - at) * (towards - at) > 0.0;
    own.iter().copied().filter(faces).collect()
}

/// The stress of CalculiX at the nodes in place of Brinell's.
fn read_stress(scene: &Scene, fields: &Fields, recovered: &mut Recovered) {
    let nodes = recovered.points.node.clone();
    for (point, node) in nodes.into_iter().enumerate() {
        let place = &scene.mesh.points[node as usize];
        let stress = crate::fields::mirrored(scene, place, fields.stress[node as usize]);
        recovered.nodal_stress[point] = stress;
        recovered.mises_nodal[point] = mises(&stress);
    }
}

fn cells(row: &Row) -> Vec<String> {
    let percent = |share: f64| format!("{:+.2}", 100.0 * share);
    let figures = row.errors.iter().zip(row.bars).map(|(error, bar)| {
        let bar = bar.map(|bar| format!(" ± {:.2}", 100.0 * bar));
        match error {
            Some(error) => percent(*error) + &bar.unwrap_or_default(),
            None => "-".to_owned(),
        }
    });
    let cost = [row.cost.wall_s, row.cost.cpu_s, row.cost.peak_mb].map(|x| number(x, 3));
    let head = [row.name.clone(), format!("{}", row.unknowns)];
    head.into_iter().chain(cost).chain(figures).collect()
}

fn table(rows: &[Row]) -> String {
    let mut head = vec!["run", "unknowns", "wall, s", "CPU, s", "memory, MB"];
    let shown = SHOWN.map(|(name, ..)| format!("{name}, %"));
    head.extend(shown.iter().map(String::as_str));
    let mut table = Table::new(&head);
    for row in rows {
        table.row(&cells(row));
    }
    table.render().to_owned()
}

/// Errors against seconds on the left, against memory on the right: a line each for presets, targets and CalculiX.
fn figure(rows: &[Row]) -> PlotFigure {
    /// Smaller errors are drawn as this, in per cent: true values are not known better.
    const LEAST: f64 = 0.05;
    let legend = ["Brinell, presets", "Brinell, targets", "CalculiX"];
    let style = |row: &Row| match row.name.as_str() {
        name if name.contains("--target") => 1,
        name if name.starts_with("Brinell") => 0,
        _ => 2,
    };
    let mut panels = Vec::new();
    for (k, (name, ..)) in SHOWN.into_iter().enumerate() {
        for axis in ["seconds", "memory, MB"] {
            let at = |cost: &Cost| match axis {
                "seconds" => cost.wall_s,
                _ => cost.peak_mb,
            };
            let mut lines: BTreeMap<usize, Vec<(f64, f64)>> = BTreeMap::new();
            for row in rows {
                if let Some(error) = row.errors[k] {
                    let point = (at(&row.cost), (100.0 * error.abs()).max(LEAST));
                    lines.entry(style(row)).or_default().push(point);
                }
            }
            let lines = lines.into_iter().map(|(style, mut points)| {
                points.sort_by(|a, b| a.0.total_cmp(&b.0));
                Line::dotted(style, points)
            });
            panels.push(Panel {
                title: format!("{name}, error in %"),
                axes: [axis.to_owned(), String::new()],
                scale: Scale::Decades,
                lines: lines.collect(),
                dashed: Vec::new(),
            });
        }
    }
    PlotFigure {
        panels,
        legend: legend.map(str::to_owned).to_vec(),
        dashed: String::new(),
    }
}
