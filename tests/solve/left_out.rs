//! What a scene does not need is not done: counters of the solver, and what a run says of it.

use brinell::case;
use brinell::model::scene::Scene;
use brinell::product::job::{self, Options};
use brinell::render::Summary;
use brinell::solver::solve::{Counters, Silent, Solution, solve};
use std::path::Path;

const CENTRE: &str = "cases/section-2.6.2/initial-centre.toml";

fn centre() -> case::Case {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(CENTRE);
    let mut case = case::read(&path).expect("the shipped case reads");
    case.set_preset("report-like").expect("a preset");
    case
}

fn solved(change: impl Fn(&mut Scene)) -> (Scene, Solution) {
    let case = centre();
    let mesh = job::find_mesh(&case, None, &mut |_| ()).expect("the shipped mesh");
    let mut scene = case.scene(mesh).expect("a scene");
    for steel in &mut scene.materials {
        steel.yield_stress = 30.0;
    }
    change(&mut scene);
    let solution = solve(&mut scene, &mut Silent).expect("converges");
    (scene, solution)
}

#[test]
fn an_elastic_frictionless_scene_does_no_plastic_and_no_tangential_work() {
    let (_, solution) = solved(|scene| {
        scene
            .materials
            .iter_mut()
            .for_each(|m| m.yield_stress = f64::INFINITY);
        scene.contacts.iter_mut().for_each(|c| c.friction = 0.0);
    });
    let Counters {
        plastic_updates,
        element_tangents,
        watched_elements,
        friction_updates,
        contact_updates,
        ..
    } = solution.counters;
    assert_eq!(
        (plastic_updates, element_tangents, watched_elements),
        (0, 0, 0)
    );
    assert_eq!(friction_updates, 0);
    assert!(contact_updates > 0);
    assert!(solution.last.peeq.is_empty());
    let contacts = &solution.last.contacts;
    assert!(
        contacts
            .iter()
            .flat_map(|c| &c.slip)
            .all(|slip| *slip == 0.0)
    );
    let mut tractions = contacts.iter().flat_map(|c| c.traction.as_flattened());
    assert!(tractions.all(|t| *t == 0.0));
}

#[test]
fn a_scene_that_yields_and_rubs_does_both() {
    let (scene, solution) = solved(|_| ());
    let counters = solution.counters;
    assert!(counters.plastic_updates > 0 && counters.element_tangents > 0);
    assert_eq!(counters.friction_updates, counters.contact_updates);
    assert!(counters.friction_updates > 0);
    assert_eq!(solution.last.peeq.len(), scene.mesh.hexes.len());
    // One frictionless pair of four leaves its share out.
    let (_, partly) = solved(|scene| scene.contacts[0].friction = 0.0);
    let counters = partly.counters;
    assert!(0 < counters.friction_updates);
    assert!(counters.friction_updates < counters.contact_updates);
}

fn said(summary: &Summary, what: &str) -> Option<Vec<String>> {
    let item = summary
        .left_out
        .iter()
        .find(|item| item.what.contains(what))?;
    Some(
        item.saved
            .iter()
            .map(|saving| saving.of.to_owned())
            .collect(),
    )
}

#[test]
fn a_run_says_what_it_left_out_and_what_that_saved() {
    let options = Options {
        out: None,
        elastic_peaks: true,
        resume: false,
        report: false,
    };
    let mut case = centre();
    let rubbing = job::run(&case, &options, &mut Silent).expect("converges");
    case.set_elastic();
    let elastic = job::run(&case, &options, &mut Silent).expect("converges");
    for summary in [&rubbing.summary, &elastic.summary] {
        let saved = said(summary, "symmetric about x and y: quarter bearing");
        assert_eq!(
            saved.as_deref(),
            Some(&["elements", "nodes", "unknowns"].map(String::from)[..])
        );
        assert!(said(summary, "files: not asked for").is_some());
        assert!(said(summary, "friction 0").is_none());
    }
    let saved = said(
        &elastic.summary,
        "upper_plate: taken as elastic, yield never checked",
    );
    let points = "integration-point updates".to_owned();
    assert!(saved.is_some_and(|saved| saved.contains(&points)));
    assert!(said(&rubbing.summary, "yield never checked").is_none());
    assert!(said(&rubbing.summary, "that could yield").is_some());
}
