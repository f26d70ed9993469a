//! `line-load.csv` and `line-load.svg`, from states with known line loads.

use crate::block::{close, pressed, settle, stack};
use crate::summary::summarise;
use brinell::model::scene::Scene;
use brinell::model::state::State;
use brinell::render::line_load::{FILES, whole_lines, write};
use brinell::render::plot::{Line, Panel, PlotFigure, Scale, svg};
use std::path::Path;
use std::process::Command;

/// The stack with contact beside the mirror only: two lines, which have lifted off at their ends.
fn two_lines() -> (Scene, State) {
    let scene = stack();
    let mut state = pressed(&scene);
    let field = &mut state.contacts[0];
    for (node, pressure) in field.nodes.iter().zip(&mut field.pressure) {
        let [x, y, _] = scene.mesh.points[*node as usize];
        *pressure *= match x < 0.4 || y > 0.9 {
            true => 0.0,
            false => 1.0 + y / 3.0,
        };
    }
    settle(field);
    (scene, state)
}

/// (across, along, load) of each row of the file.
fn rows(path: &Path) -> Vec<[f64; 3]> {
    let text = std::fs::read_to_string(path).unwrap();
    let mut lines = text.lines();
    assert_eq!(
        lines.next(),
        Some("interface,axis,line across at [in],along [in],line load [kip/in]")
    );
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        assert_eq!(&cells[..2], ["block-plate", "y"]);
        [2, 3, 4].map(|i| cells[i].parse().unwrap())
    };
    lines.map(row).collect()
}

/// The integral of the rows by the trapezoidal rule, line by line.
fn force(rows: &[[f64; 3]]) -> f64 {
    let pairs = rows.windows(2).filter(|w| w[0][0] == w[1][0]);
    pairs
        .map(|w| 0.5 * (w[0][2] + w[1][2]) * (w[1][1] - w[0][1]))
        .sum()
}

#[test]
fn the_file_sums_to_the_force_of_the_interface() {
    let whole = stack();
    let full = pressed(&whole);
    for ((scene, state), lines) in [((whole, full), 1), (two_lines(), 2)] {
        let folder = tempfile::tempdir().unwrap();
        let summary = summarise(&scene, &state);
        write(&summary, folder.path()).unwrap();
        let rows = rows(&folder.path().join(FILES[0]));
        // Four rows of nodes and the images of three.
        assert_eq!(rows.len(), 7 * lines);
        assert_eq!([rows[0][1], rows[3][1], rows[6][1]], [-1.0, 0.0, 1.0]);
        close(
            force(&rows),
            summary.answer.interfaces.0[0].1.pressure_integral,
        );
        let total: f64 = whole_lines(&summary).iter().map(|l| 2.0 * l.mean).sum();
        close(total, force(&rows));
    }
}

/// Polylines with this many points in an SVG file, which an XML parser reads.
fn curves(path: &Path, points: usize) -> usize {
    let script = "import sys, xml.etree.ElementTree as e\n\
                  for line in e.parse(sys.argv[1]).iter('{http://www.w3.org/2000/svg}polyline'):\n\
                  \x20   print(len(line.get('points').split()))";
    let mut python = Command::new("python3");
    let output = python.args(["-c", script]).arg(path).output();
    let output = output.expect("python3 reads the plot back");
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{error}");
    let counts = String::from_utf8(output.stdout).unwrap();
    let counts = counts.lines().filter_map(|l| l.parse::<usize>().ok());
    counts.filter(|n| *n == points).count()
}

#[test]
fn the_plot_has_a_curve_for_each_line() {
    let (scene, state) = two_lines();
    let folder = tempfile::tempdir().unwrap();
    write(&summarise(&scene, &state), folder.path()).unwrap();
    let picture = folder.path().join(FILES[1]);
    assert_eq!(curves(&picture, 7), 2);
    let text = std::fs::read_to_string(picture).unwrap();
    for part in [
        "block-plate, at x = -0.500 and 0.500 in",
        "y, in",
        "line load, kip/in",
        "spread evenly",
    ] {
        assert!(text.contains(part), "{part}");
    }
}

#[test]
fn without_lines_nothing_is_written() {
    let scene = stack();
    let mut state = pressed(&scene);
    state.contacts[0].pressure.fill(0.0);
    settle(&mut state.contacts[0]);
    let folder = tempfile::tempdir().unwrap();
    write(&summarise(&scene, &state), folder.path()).unwrap();
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn an_unwritable_place_is_named() {
    let scene = stack();
    let folder = tempfile::tempdir().unwrap();
    let blocked = folder.path().join("file");
    std::fs::write(&blocked, "x").unwrap();
    let error = write(&summarise(&scene, &pressed(&scene)), &blocked).unwrap_err();
    assert!(error.to_string().contains(FILES[0]), "{error}");
}

#[test]
fn a_figure_of_nothing_or_of_no_numbers_is_drawn() {
    let panel = |points: Vec<(f64, f64)>| Panel {
        title: "<&>".into(),
        axes: ["y, in".into(), "q".into()],
        scale: Scale::Linear,
        lines: vec![Line::dotted(9, points)],
        dashed: vec![f64::NAN, -1.0],
    };
    let panels = [vec![], vec![(0.0, 0.0)], vec![(f64::NAN, f64::INFINITY)]];
    let figure = PlotFigure {
        panels: panels.map(panel).into(),
        legend: vec![],
        dashed: String::new(),
    };
    assert!(svg(&figure).unwrap().ends_with("</svg>\n"));
}
