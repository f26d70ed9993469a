use crate::block::{close, fill_stress, pressed, stack};
use brinell::answer::results::bore::Bore;
use brinell::answer::results::edges::SingularEdges;
use brinell::answer::results::peaks::peaks;
use brinell::answer::results::recovery::recover;
use brinell::answer::{Answer, AnswerInputs, Named};
use brinell::ground::units::UnitLabels;
use brinell::model::scene::Scene;
use brinell::model::state::State;
use brinell::render::left_out::LeftOut;
use brinell::render::summary::{Comparison, Counters, Reported, Summary, Timing};
use brinell::render::terminal;
use brinell::render::warnings::warnings;
use serde_json::Value;

pub fn summarise(scene: &Scene, state: &State) -> Summary {
    let recovered = recover(scene, state);
    let elastic = peaks(
        (scene, state),
        &recovered,
        &SingularEdges::find(scene, state),
        &[],
    );
    let comparison = [Comparison {
        what: "Mises, centroid, ksi".to_string(),
        place: "overall".to_string(),
        report: Some(Reported::Value(70.0)),
        report_like: Some(33.2),
        value: Some(93.125),
        error: Some(1.25),
        hertz: Some(f64::NAN),
        ..Comparison::default()
    }];
    let mut steps = [state.clone(), state.clone()];
    steps[0].time = 0.4;
    for plane in &mut steps[0].planes {
        plane.travel = plane.travel.map(|travel| 0.5 * travel);
    }
    let answer = Answer::of(&AnswerInputs {
        unloaded: Some(state),
        steps: &steps,
        elastic: Some(&elastic),
        bores: &[Bore {
            body: "block".to_string(),
            surface: "none".to_string(),
            axis: 1,
            lean: 0.0,
        }],
        stabilisation_share: Some(0.02),
        ..AnswerInputs::new(scene, state, &recovered)
    })
    .unwrap();
    Summary {
        case: "initial-centre".to_string(),
        units: UnitLabels::new("in", "kip", "ksi"),
        brinell_version: "0".to_string(),
        warnings: warnings(&answer),
        answer,
        counters: Counters {
            dofs: 120,
            iterations: 7,
            factorisations: 2,
            krylov_directions: 9,
            kept_dofs: 40,
            factor_entries: 1000,
        },
        timing: Timing {
            mesh_s: 0.5,
            solve_s: 1.0,
            total_s: 2.0,
            phases: Named(vec![("assemble".into(), 0.25)]),
            ..Timing::default()
        },
        peak_memory_bytes: Some(123_000_000),
        elastic_twin: None,
        comparison: comparison.to_vec(),
        sizing: None,
        rules: None,
        hand_checks: Vec::new(),
        title_block: Default::default(),
        assumptions: vec!["plates L x L".to_string()],
        left_out: vec![
            LeftOut::new("friction 0: no tangential unknowns").saving(12, "friction updates"),
        ],
    }
}

pub fn loaded() -> (Scene, State) {
    let scene = stack();
    let mut state = pressed(&scene);
    fill_stress(&scene, &mut state, |[x, y, z]| {
        let value = 50.0 / (0.2 + (x - 0.5).powi(2) + (y - 1.0).powi(2) + z * z);
        [0.0, 0.0, -value, 0.0, 0.0, 0.0]
    });
    state.peeq[0][0] = 1e-3;
    for (u, p) in state.displacement.iter_mut().zip(&scene.mesh.points) {
        *u = [0.0, 0.0, -0.03 * p[2]];
    }
    (scene, state)
}

#[test]
fn the_summary_has_every_key_and_no_nan() {
    let (scene, state) = loaded();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("new/summary.json");
    summarise(&scene, &state).write(&path).unwrap();
    let text = std::fs::read_to_string(path).unwrap();
    let json: Value = serde_json::from_str(&text).unwrap();
    for key in [
        "case",
        "units",
        "brinell_version",
        "converged",
        "dofs",
        "elements",
        "iterations",
        "factorisations",
        "krylov_directions",
        "kept_dofs",
        "factor_entries",
        "timing",
        "peak_memory_bytes",
        "elastic_twin",
        "applied_load",
        "descent",
        "bodies",
        "interfaces",
        "rollers",
        "checks",
        "comparison",
        "assumptions",
        "left_out",
    ] {
        assert!(json.get(key).is_some(), "{key}");
    }
    let claims = json["certificate"].as_array().unwrap();
    assert!(!claims.is_empty());
    for claim in claims {
        assert_eq!(
            claim["resolved"].as_bool(),
            Some(!claim["error"].is_null()),
            "{claim}"
        );
        assert!(claim["causes"].get("discretisation").is_some(), "{claim}");
        let (value, error) = (claim["value"].as_f64().unwrap(), claim["error"].as_f64());
        if let Some(share) = claim["relative_error"].as_f64() {
            assert!(
                (share * value.abs() - error.unwrap()).abs() < 1e-12 * value.abs(),
                "{claim}"
            );
        }
    }
    assert_eq!(json["left_out"][0]["saved"][0]["count"], 12);
    for pointer in [
        "/units/length",
        "/timing/mesh_s",
        "/timing/solve_s",
        "/timing/total_s",
        "/timing/phases/assemble",
        "/bodies/block/mises_max/centroid",
        "/bodies/block/mises_max/integration_point",
        "/bodies/block/mises_max/nodal",
        "/bodies/block/at/nodal/2",
        "/bodies/block/elastic_mises_max/nodal",
        "/bodies/plate/peeq_max",
        "/bodies/plate/yielded_volume",
        "/interfaces/block-plate/force/2",
        "/interfaces/block-plate/normal_force",
        "/interfaces/block-plate/pressure_integral",
        "/interfaces/block-plate/max_pressure",
        "/interfaces/block-plate/max_penetration",
        "/interfaces/block-plate/area",
        "/interfaces/block-plate/status_counts/stick",
        "/interfaces/block-plate/q/values/1",
        "/interfaces/block-plate/centre_of_force/2",
        "/interfaces/block-plate/lines/0/load/3",
        "/interfaces/block-plate/lines/0/lifted_off",
        "/interfaces/block-plate/lines/0/mean",
        "/stiffness",
        "/load_line/0/step",
        "/load_line/0/load",
        "/load_line/1/descent",
        "/unloaded/applied_load",
        "/unloaded/dents/plate_w+/depth",
        "/unloaded/peeq_max/plate",
        "/checks/force_balance",
        "/checks/max_penetration_relative",
        "/checks/coulomb_violation",
        "/checks/stabilisation_share",
        "/comparison/0/report",
        "/comparison/0/where",
    ] {
        assert!(
            json.pointer(pointer).is_some_and(|v| !v.is_null()),
            "{pointer}"
        );
    }
    for pointer in [
        "/rollers/block/bore_mises",
        "/rollers/block/bore_mises_nodal",
        "/comparison/0/hertz",
        "/sizing",
        "/bodies/plate/elastic_mises_max",
    ] {
        assert_eq!(json.pointer(pointer), Some(&Value::Null), "{pointer}");
    }
    let bodies: Vec<&str> = text.lines().filter(|l| l.starts_with("    \"")).collect();
    let place = |name: &str| bodies.iter().position(|l| l.contains(name));
    assert!(
        place("\"block\"") < place("\"plate\""),
        "bodies stand in the order of the scene"
    );
}

#[test]
fn the_checks_are_computed_where_they_are_not_given() {
    let (scene, mut state) = loaded();
    state.contacts[0]
        .force
        .iter_mut()
        .for_each(|f| f[2] *= 0.99);
    state.contacts[0].unexplained = 2e-7;
    let checks = summarise(&scene, &state).answer.checks;
    assert!((checks.force_balance.unwrap() - 0.01).abs() < 1e-12);
    // What the facets do not explain.
    close(checks.max_penetration_relative.unwrap(), 2e-7 / 0.01);
    assert_eq!(checks.coulomb_violation, Some(0.0));
    assert_eq!(checks.stabilisation_share, Some(0.02));
}

#[test]
fn the_table_shows_the_figures_and_what_to_beware_of() {
    let (scene, state) = loaded();
    let text = terminal::tables(&summarise(&scene, &state), true);
    for part in [
        "initial-centre: converged",
        "65.00 kip",
        "0.01000 in",
        "3.00 %",
        "yielded in³",
        "block-plate",
        "93.12 ± 1.2",
        "33.20",
        "Line load from 0.00 on, kip/in",
        "plates L x L",
        "friction 0: no tangential unknowns\n    saved: 12 friction updates",
        "small-strain theory",
        "square roller end",
        "stabilisation carries 2.00 % of the load",
        "no Mises stress from the strain of the bore",
        "elastic",
    ] {
        assert!(text.contains(part), "{part} is missing in\n{text}");
    }
    // Warnings are sentences, as long as they are.
    let widest = text
        .lines()
        .filter(|line| !line.starts_with("  - "))
        .map(|l| l.chars().count())
        .filter(|n| *n < 150)
        .max();
    assert!(widest.is_some_and(|n| n <= 132), "{text}");
}

#[test]
fn the_slopes_of_a_load_in_stages() {
    let (scene, state) = loaded();
    let mut summary = summarise(&scene, &state);
    // 26 at 0.005, then 65 at 0.01.
    let points = summary.answer.load_line.iter_mut();
    for (point, descent) in points.zip([0.005, 0.01]) {
        point.descent = Some(descent);
    }
    let text = terminal::tables(&summary, false);
    for slope in ["5200", "7800"] {
        let row = |line: &str| line.trim_end().ends_with(slope);
        assert!(text.lines().any(row), "{slope} is missing in\n{text}");
    }
    let mut once = summary.clone();
    once.answer.load_line.remove(0);
    assert!(!terminal::tables(&once, false).contains("slope"));
    // Unloading alone is no load line.
    let mut unloaded = summary;
    unloaded.answer.load_line.swap(0, 1);
    assert!(!terminal::tables(&unloaded, false).contains("slope"));
}

#[test]
fn an_unconverged_run_says_so_first() {
    let (scene, state) = loaded();
    let mut summary = summarise(&scene, &state);
    summary.answer.converged = false;
    assert!(terminal::tables(&summary, false).starts_with("initial-centre: NOT CONVERGED\n"));
    let warnings = warnings(&summary.answer);
    assert!(warnings[0].0.contains("has not converged"));
}

#[test]
fn what_holds_for_two_bodies_is_said_once() {
    let (scene, state) = loaded();
    let mut summary = summarise(&scene, &state);
    for (index, (_, body)) in summary.answer.bodies.0.iter_mut().enumerate() {
        body.at_singular_edge.nodal = index < 2;
        body.at_singular_edge.centroid = false;
        body.at_singular_edge.integration_point = false;
    }
    let [first, second] = [0, 1].map(|b| summary.answer.bodies.0[b].0.clone());
    let warnings = warnings(&summary.answer);
    let edges = warnings.iter().filter(|w| w.0.contains("loaded edge"));
    let edges: Vec<_> = edges.collect();
    assert_eq!(edges.len(), 1, "{warnings:?}");
    let names = format!("{first}, {second}: the peak (nodal) sits");
    assert!(edges[0].0.starts_with(&names), "{:?}", edges[0]);
}

#[test]
fn an_unwritable_place_is_named() {
    let (scene, state) = loaded();
    let folder = tempfile::tempdir().unwrap();
    let blocked = folder.path().join("file");
    std::fs::write(&blocked, "x").unwrap();
    let error = summarise(&scene, &state)
        .write(&blocked.join("summary.json"))
        .unwrap_err();
    assert!(error.to_string().contains("summary.json"), "{error}");
}
