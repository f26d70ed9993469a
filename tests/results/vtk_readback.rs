//! The written VTK files, read back by VTK itself through pyvista.

use std::path::Path;
use std::process::Command;

use crate::block::{add_block, fill_stress, pressed, stack};
use brinell::answer::results::recovery::{Recovered, recover};
use brinell::ground::units::UnitLabels;
use brinell::model::mesh::Mesh;
use brinell::model::scene::Scene;
use brinell::model::state::State;
use brinell::render::VtkSeries;
use brinell::render::fields;
use serde_json::{Value, json};

/// Opens a file or a collection and prints what is in it as JSON.
const READ: &str = r#"
import json, sys
import numpy as np
import pyvista

def arrays(data):
    return {name: {
        "shape": list(data[name].shape),
        "dtype": str(data[name].dtype),
        "max": np.nanmax(np.asarray(data[name], dtype=float), axis=0).tolist(),
        "min": np.nanmin(np.asarray(data[name], dtype=float), axis=0).tolist(),
        "nan": int(np.isnan(np.asarray(data[name], dtype=float)).sum()),
        "components": [data.GetAbstractArray(name).GetComponentName(i)
                       for i in range(data.GetAbstractArray(name).GetNumberOfComponents())],
    } for name in data.keys()}

def grid(mesh):
    return {
        "points": mesh.n_points,
        "cells": mesh.n_cells,
        "types": sorted(set(int(t) for t in mesh.celltypes)),
        "bounds": list(mesh.bounds),
        "size": float(np.abs(mesh.compute_cell_sizes().cell_data["Volume"]).sum()
                      + np.abs(mesh.compute_cell_sizes().cell_data["Area"]).sum()),
        "point_data": arrays(mesh.point_data),
        "cell_data": arrays(mesh.cell_data),
        "field_data": {name: [str(s) for s in mesh.field_data[name]]
                       for name in mesh.field_data.keys()},
    }

path = sys.argv[1]
if path.endswith(".pvd"):
    reader = pyvista.get_reader(path)
    times = []
    for time in reader.time_values:
        reader.set_active_time_value(time)
        blocks = reader.read()
        times.append({"time": time, "parts": [d.part for d in reader.active_datasets],
                      "grids": [grid(block) for block in blocks]})
    print(json.dumps(times))
else:
    print(json.dumps(grid(pyvista.read(path))))
"#;

/// What VTK finds in `path`.
fn read_back(path: &Path) -> Value {
    let ask = |script: &str| {
        Command::new("python3")
            .args(["-c", script])
            .arg(path)
            .output()
    };
    let pyvista = ask("import pyvista");
    assert!(
        pyvista.is_ok_and(|output| output.status.success()),
        "this test reads the files back with pyvista: install it with `pip install pyvista`"
    );
    let output = ask(READ).unwrap();
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.success(),
        "pyvista cannot read {}:\n{error}",
        path.display()
    );
    assert!(
        !error.contains("ERR|"),
        "VTK complains about {}:\n{error}",
        path.display()
    );
    serde_json::from_slice(&output.stdout).unwrap()
}

fn loaded() -> (Scene, State) {
    let scene = stack();
    let mut state = pressed(&scene);
    fill_stress(&scene, &mut state, |[x, y, z]| {
        [10.0 * x, y * z, -40.0 + z, x * y, y, x * z]
    });
    for (i, u) in state.displacement.iter_mut().enumerate() {
        *u = [1e-3 * i as f64, -2e-4 * i as f64, (i as f64).sin() / 3.0];
    }
    state.peeq[3][2] = 0.1 + 0.2;
    state.contacts[0].gap[2] = f64::INFINITY;
    state.contacts[0].status[2] = 0;
    state.contacts[0].status[4] = 2;
    state.contacts[0].slip[4] = 1e-5;
    state.contacts[0].pressure[4] = 100.0 / 3.0;
    (scene, state)
}

fn maximum(values: &[f64]) -> f64 {
    values
        .iter()
        .copied()
        .filter(|v| !v.is_nan())
        .fold(f64::NEG_INFINITY, f64::max)
}

/// Checks an array's shape, type and, to the last bit, its largest values by component.
#[track_caller]
fn check(found: &Value, name: &str, dtype: &str, values: &[f64], components: usize) {
    let array = &found[name];
    let rows = values.len() / components;
    let shape = if components == 1 {
        json!([rows])
    } else {
        json!([rows, components])
    };
    assert_eq!(array["shape"], shape, "{name}");
    assert_eq!(array["dtype"], json!(dtype), "{name}");
    for c in 0..components {
        let column: Vec<f64> = values.iter().copied().skip(c).step_by(components).collect();
        let max = if components == 1 {
            &array["max"]
        } else {
            &array["max"][c]
        };
        assert_eq!(
            max.as_f64(),
            Some(maximum(&column)),
            "{name}, component {c}"
        );
    }
}

fn check_bodies(found: &Value, scene: &Scene, state: &State, recovered: &Recovered) {
    let (points, cells) = (&found["point_data"], &found["cell_data"]);
    assert_eq!(found["types"], json!([12]));
    assert_eq!(found["cells"], json!(scene.mesh.hexes.len()));
    assert!(
        (found["size"].as_f64().unwrap() - 2.0).abs() < 1e-12,
        "volume of the quarter"
    );
    check(
        points,
        "displacement",
        "float64",
        state.displacement.as_flattened(),
        3,
    );
    check(
        points,
        "stress",
        "float64",
        recovered.nodal_stress.as_flattened(),
        6,
    );
    assert_eq!(
        points["stress"]["components"],
        json!(["XX", "YY", "ZZ", "XY", "YZ", "ZX"])
    );
    check(points, "mises_nodal", "float64", &recovered.mises_nodal, 1);
    check(cells, "mises_mean", "float64", &recovered.mises_mean, 1);
    check(cells, "mises_max", "float64", &recovered.mises_max, 1);
    check(cells, "peeq", "float64", &recovered.peeq, 1);
    let body: Vec<f64> = (0..scene.mesh.hexes.len())
        .map(|e| scene.mesh.body_of(e) as f64)
        .collect();
    check(cells, "body", "int32", &body, 1);
    assert_eq!(found["field_data"]["body_names"], json!(["block", "plate"]));
    let units = [
        "Points: in",
        "displacement: in",
        "stress: ksi",
        "mises_nodal: ksi",
        "mises_mean: ksi",
        "mises_max: ksi",
    ];
    assert_eq!(found["field_data"]["units"], json!(units));
}

fn check_contacts(found: &Value, state: &State) {
    let (points, field) = (&found["point_data"], &state.contacts[0]);
    assert_eq!(found["types"], json!([9]));
    assert!(
        (found["size"].as_f64().unwrap() - 0.5).abs() < 1e-12,
        "area of the quarter"
    );
    check(points, "contact_pressure", "float64", &field.pressure, 1);
    let gap: Vec<f64> = field
        .gap
        .iter()
        .map(|g| if g.is_finite() { *g } else { f64::NAN })
        .collect();
    check(points, "gap", "float64", &gap, 1);
    assert_eq!(points["gap"]["nan"], json!(1));
    check(
        points,
        "traction",
        "float64",
        field.traction.as_flattened(),
        3,
    );
    check(points, "slip", "float64", &field.slip, 1);
    let status: Vec<f64> = field.status.iter().map(|s| f64::from(*s)).collect();
    check(points, "contact_status", "uint8", &status, 1);
    assert_eq!(
        found["field_data"]["interface_names"],
        json!(["block-plate"])
    );
}

#[test]
fn a_series_opens_with_every_array_part_and_time() {
    let (scene, mut state) = loaded();
    let recovered = recover(&scene, &state);
    let folder = tempfile::tempdir().unwrap();
    let series = VtkSeries::new(folder.path().join("out"), "a case/1");
    let mut series = series.in_units(UnitLabels::new("in", "kip", "ksi"));
    state.time = 0.1;
    let paths = series.write(&scene, &state, &recovered).unwrap();
    let names: Vec<_> = paths
        .iter()
        .map(|p| p.file_name().unwrap().to_str().unwrap())
        .collect();
    assert_eq!(
        names,
        [
            "a_case_1_0001.vtu",
            "a_case_1_contact_0001.vtu",
            "a_case_1.pvd"
        ]
    );
    // What stands after the first increment is whole.
    assert_eq!(read_back(&paths[2]).as_array().map(Vec::len), Some(1));
    state.time = 1.0;
    series.write(&scene, &state, &recovered).unwrap();
    let times = read_back(&paths[2]);
    assert_eq!(times.as_array().map(Vec::len), Some(2));
    assert_eq!(times[0]["time"], json!(0.1));
    assert_eq!(times[1]["time"], json!(1.0));
    for time in times.as_array().unwrap() {
        assert_eq!(time["parts"], json!([0, 1]));
        check_bodies(&time["grids"][0], &scene, &state, &recovered);
        check_contacts(&time["grids"][1], &state);
    }
    let left: Vec<_> = std::fs::read_dir(paths[0].parent().unwrap())
        .unwrap()
        .collect();
    assert_eq!(left.len(), 5, "no temporary file is left");
}

#[test]
fn a_resumed_series_goes_on_from_its_state() {
    let (scene, mut state) = loaded();
    let recovered = recover(&scene, &state);
    let folder = tempfile::tempdir().unwrap();
    let mut series = VtkSeries::new(folder.path(), "case");
    for time in [0.25, 0.5, 0.75] {
        state.time = time;
        series.write(&scene, &state, &recovered).unwrap();
    }
    state.time = 0.5;
    let mut series = VtkSeries::resume(folder.path(), "case", (state.step, state.time)).unwrap();
    state.time = 1.0;
    let paths = series.write(&scene, &state, &recovered).unwrap();
    assert!(paths[0].ends_with("case_0003.vtu"));
    let times = read_back(&paths[2]);
    let times: Vec<_> = times
        .as_array()
        .unwrap()
        .iter()
        .map(|t| t["time"].as_f64())
        .collect();
    assert_eq!(times, [Some(0.25), Some(0.5), Some(1.0)]);
}

#[test]
fn bodies_that_share_nodes_are_written_apart() {
    let (mut scene, _) = loaded();
    let mut mesh = Mesh::default();
    add_block(
        &mut mesh,
        "left",
        [&[0.0, 1.0], &[0.0, 1.0], &[0.0, 1.0]],
        |p| p,
    );
    add_block(
        &mut mesh,
        "right",
        [&[1.0, 2.0], &[0.0, 1.0], &[0.0, 1.0]],
        |p| p,
    );
    mesh.hexes[1] = [1, 9, 11, 3, 5, 13, 15, 7];
    scene = Scene {
        mesh,
        contacts: vec![],
        rigid_planes: vec![],
        ..scene
    };
    let state = State {
        displacement: (0..16).map(|i| [f64::from(i); 3]).collect(),
        stress: vec![
            [[7.0, 0.0, 0.0, 0.0, 0.0, 0.0]; 8],
            [[0.0, 3.0, 0.0, 0.0, 0.0, 0.0]; 8],
        ],
        ..State::default()
    };
    let recovered = recover(&scene, &state);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("shared.vtu");
    fields::bodies(&scene, &state, &recovered)
        .unwrap()
        .write(&path)
        .unwrap();
    let found = read_back(&path);
    assert_eq!(found["points"], json!(20));
    check(
        &found["point_data"],
        "stress",
        "float64",
        recovered.nodal_stress.as_flattened(),
        6,
    );
    check(
        &found["point_data"],
        "mises_nodal",
        "float64",
        &recovered.mises_nodal,
        1,
    );
    assert!((found["size"].as_f64().unwrap() - 2.0).abs() < 1e-12);
}

/// Block boundaries of the compressed arrays: whole blocks, one value more, none at all.
#[test]
fn arrays_of_awkward_lengths_survive() {
    use brinell::render::encode::Values;
    use brinell::render::grid::{Array, CellType, Grid};
    let folder = tempfile::tempdir().unwrap();
    for n in [0usize, 1, 16384, 16385, 32768, 50001] {
        let values: Vec<f64> = (0..n).map(|i| (i as f64).sqrt() - 7.0).collect();
        let points: Vec<f64> = (0..3 * n).map(|i| i as f64 / 7.0).collect();
        let grid = Grid {
            points: points.into(),
            cell_type: CellType::Quad,
            connectivity: vec![],
            point_data: vec![Array::scalar(
                "a <&> \"b\"",
                Values::F64(values.as_slice().into()),
            )],
            cell_data: vec![],
            names: vec![],
        };
        let path = folder.path().join(format!("{n}.vtu"));
        grid.write(&path).unwrap();
        if n == 0 {
            let text = std::fs::read_to_string(&path).unwrap();
            assert!(text.contains("NumberOfPoints=\"0\""));
            continue;
        }
        let found = read_back(&path);
        assert_eq!(found["points"], json!(n));
        check(&found["point_data"], "a <&> \"b\"", "float64", &values, 1);
    }
}

#[test]
fn a_place_that_cannot_be_written_is_named_and_left_as_it_was() {
    let (scene, state) = loaded();
    let recovered = recover(&scene, &state);
    let folder = tempfile::tempdir().unwrap();
    let blocked = folder.path().join("blocked");
    std::fs::write(&blocked, "not a folder").unwrap();
    let error = VtkSeries::new(&blocked, "case")
        .write(&scene, &state, &recovered)
        .unwrap_err();
    assert!(error.to_string().contains("case_0001.vtu"), "{error}");
    assert_eq!(std::fs::read_to_string(&blocked).unwrap(), "not a folder");
}
