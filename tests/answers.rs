//! What an answer is worth where contact grows beyond all that was prepared for it, where one side is
//! much the stiffer, where a strip ends anywhere between two nodes, and where a shape is not resolved.

use brinell::analytic::hertz::{LineContact, widening_in_flow};
use brinell::answer::certify::{Figure, Quantity};
use brinell::case;
use brinell::product::job::{self, Options};
use brinell::render::Summary;
use brinell::solver::solve::Silent;
use std::f64::consts::PI;

/// Solves the scene `text`, whose mesh files are fixtures, once.
#[track_caller]
fn solve(text: &str) -> Summary {
    let fixtures = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/");
    let text = text.replace("FIXTURES/", fixtures);
    let case = case::parse("scene.toml", &text).unwrap();
    let outcome = job::run(&case, &Options::default(), &mut Silent).unwrap();
    assert!(outcome.summary.answer.converged);
    assert_eq!(outcome.missed_limits(&case), Vec::<String>::new());
    outcome.summary
}

fn figure<'s>(summary: &'s Summary, what: Quantity, pair: &str) -> &'s Figure {
    summary.answer.figure(what, pair).unwrap()
}

/// The figure is `value` within `within`, relative, and inside its bar.
#[track_caller]
fn check(claim: &Figure, value: f64, within: f64) {
    let off = (claim.value - value).abs();
    assert!(
        off <= within * value,
        "{}: {} against {value}",
        claim.what.name(),
        claim.value
    );
    let bar = claim.bar().unwrap();
    assert!(
        off <= bar,
        "{}: {} ± {bar} against {value}",
        claim.what.name(),
        claim.value
    );
}

/// A slice of unit thickness whose faces are held along z.
const SLICE: &str = r#"
[[support]]
surface = "base"
fixed = "xyz"
[[support]]
surface = "symmetry"
fixed = "x"
[[support]]
surface = "back"
fixed = "z"
[[support]]
surface = "front"
fixed = "z"
"#;

/// A steel cylinder of 50 mm on an aluminium block under 35 kN/mm (NAFEMS, advanced contact benchmark 1):
/// contact grows to 6.2 mm, far beyond what touches at first.
fn cylinder(mesh: u32, friction: f64, first: f64) -> Summary {
    solve(&cylinder_case(mesh, friction, first))
}

fn cylinder_case(mesh: u32, friction: f64, first: f64) -> String {
    format!(
        r#"
title = "cylinder on a block"
units = "mm-N-MPa"
symmetry = ["x"]
[mesh]
file = "FIXTURES/cylinder-on-block-{mesh}.msh.gz"
[steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
elastic = true
[steel.block]
youngs_modulus = "70 GPa"
[[contact]]
name = "contact"
upper = "cylinder_contact"
lower = "block_contact"
friction = {friction}
[[pressure]]
surface = "top"
value = "350 MPa"
[controls]
first_increment = {first}
{SLICE}"#
    )
}

/// A plane of symmetry is one whether `symmetry` names it, supports hold it, or both. Where they only hold it, forces are those of
/// the half; the load per length is that of the whole strip, for its pressure and width are.
#[test]
fn a_plane_of_symmetry_is_named_or_held() {
    let both = cylinder_case(8, 0.0, 1.0);
    let named = both.replace("[[support]]\nsurface = \"symmetry\"\nfixed = \"x\"\n", "");
    let held = both.replace("symmetry = [\"x\"]", "");
    assert!(both != named && both != held);
    let [both, named, held] = [both, named, held].map(|text| solve(&text));
    let force = |summary: &Summary| summary.answer.interfaces.0[0].1.normal_force;
    for (other, share) in [(&named, 1.0), (&held, 0.5)] {
        for what in [
            Quantity::PeakPressure,
            Quantity::HertzPressure,
            Quantity::LineLoad,
            Quantity::HalfWidth,
        ] {
            let [a, b] = [&both, other].map(|summary| figure(summary, what, "contact"));
            assert!((a.value / b.value - 1.0).abs() < 1e-8, "{}", what.name());
            assert!((a.bar().unwrap() / b.bar().unwrap() - 1.0).abs() < 1e-6);
        }
        assert!((force(other) / force(&both) - share).abs() < 1e-8);
    }
    // 350 MPa on 100 mm.
    check(figure(&held, Quantity::LineLoad, "contact"), 35_000.0, 0.01);
}

/// Without friction Hertz has 3585 MPa and 6.21 mm; MARC and Code_Aster with friction of 0.1 between 3543
/// and 3728 MPa. Friction raises the pressure by up to 1.5 %: the same within that.
#[test]
fn contact_grows_beyond_what_was_prepared() {
    for mesh in [8, 16] {
        let summary = cylinder(mesh, 0.1, 0.25);
        let pressure = figure(&summary, Quantity::PeakPressure, "contact");
        assert!(
            (pressure.value / 3600.0 - 1.0).abs() < 0.04,
            "{}",
            pressure.value
        );
        let width = figure(&summary, Quantity::HalfWidth, "contact");
        assert!((width.value / 6.2 - 1.0).abs() < 0.02, "{}", width.value);
    }
    let pressure = |first| {
        let summary = cylinder(8, 0.1, first);
        figure(&summary, Quantity::PeakPressure, "contact").value
    };
    let fine = pressure(0.02);
    for first in [0.1, 0.5, 1.0] {
        assert!(
            (pressure(first) / fine - 1.0).abs() < 0.005,
            "first increment {first}"
        );
    }
    for friction in [0.02, 0.3] {
        let [coarse, fine] = [8, 16].map(|mesh| cylinder(mesh, friction, 0.25));
        for what in [Quantity::PeakPressure, Quantity::HalfWidth] {
            let [a, b] = [&coarse, &fine].map(|s| figure(s, what, "contact"));
            let apart = (a.value - b.value).abs();
            assert!(
                apart <= a.bar().unwrap() + b.bar().unwrap(),
                "{}",
                what.name()
            );
        }
    }
}

/// Two elastic spheres pressed together by a force from the touch of points: Hertz for R = 50 mm each,
/// E = 20 GPa and 660 kN. A hat function takes a sixth of (h/a)² off the peak of a round patch,
/// 0.8 % here.
#[test]
fn spheres_that_touch_in_a_point_are_pressed_by_a_force() {
    let reduced = 20_000.0 / (2.0 * 0.91);
    let pressure = (6.0 * 660_000.0 * reduced * reduced / (PI.powi(3) * 25.0 * 25.0)).cbrt();
    // A quarter of the whole that supports cut bears a quarter of its force, and has the same figures.
    for (side, named) in [("upper", true), ("lower", true), ("upper", false)] {
        let (symmetry, force) = match named {
            true => ("symmetry = [\"x\", \"y\"]", -660_000),
            false => ("", -165_000),
        };
        let summary = solve(&format!(
            r#"
title = "spheres"
units = "mm-N-MPa"
{symmetry}
[mesh]
file = "FIXTURES/sphere-on-sphere.msh.gz"
[steel]
youngs_modulus = 20000.0
poissons_ratio = 0.3
elastic = true
[[contact]]
name = "contact"
upper = "ball"
lower = "ball2"
carrier = "{side}"
friction = 0
[[support]]
surface = "symx"
fixed = "x"
[[support]]
surface = "symy"
fixed = "y"
[[support]]
surface = "bottom"
fixed = "z"
[[rigid_plane]]
surface = "top"
force = {{ z = {force} }}
"#
        ));
        check(
            figure(&summary, Quantity::PeakPressure, "contact"),
            pressure,
            0.015,
        );
        // The patch is recognised by the shapes of its surfaces, and Hertz's figures are of its whole force.
        let patch = &summary.sizing.as_ref().unwrap().patches[0];
        assert_eq!(
            (patch.images, patch.not_hertz, patch.first_yield),
            (1, None, None)
        );
        let radius = (0.75 * 660_000.0 * 25.0 / reduced).cbrt();
        let close = |value: f64, to: f64| assert!((value / to - 1.0).abs() < 1e-4, "{value}, {to}");
        close(patch.force, 660_000.0);
        close(patch.hertz_pressure, pressure);
        for (axis, relative) in patch.semi_axes.into_iter().zip(patch.relative_radii) {
            close(axis, radius);
            close(relative, 25.0);
        }
        assert!(summary.sizing.unwrap().lines.is_empty() && summary.rules.is_none());
        let by_hand = &summary.hand_checks[..];
        assert!(matches!(by_hand, [one] if (one.by_hand / pressure - 1.0).abs() < 1e-4));
    }
}

/// Problem H with `level` 1, 2 for 4, 8 nodes in the half-width under full load, and its block `softer` than the
/// cylinder.
fn problem_h(level: u32, load: f64, softer: f64, pair: &str) -> (Summary, f64) {
    let young = 29_500.0;
    // The same half-width for all.
    let compliance = 0.91 / young + 0.91 * softer / young;
    let line_load = 8.125 * load * (2.0 * 0.91 / young) / compliance;
    let p0 = (line_load / (PI * 1.5 * compliance)).sqrt();
    let summary = solve(&format!(
        r#"
title = "problem H"
units = "in-kip-ksi"
symmetry = ["x"]
[mesh]
family = "problem-h"
level = {level}
[steel]
youngs_modulus = {young}
poissons_ratio = 0.3
elastic = true
[steel.block]
youngs_modulus = {}
[[contact]]
name = "contact"
upper = "cylinder_contact"
lower = "block_contact"
{pair}
[[pressure]]
surface = "top"
value = {}
{SLICE}"#,
        young / softer,
        line_load / 3.0,
    ));
    (summary, p0)
}

/// Steel that flows makes a strip wider, by what the preset `auto` expects: within what other hardening does (3 %), and finite
/// bodies and the mesh (1 %). The strip of steel that does not flow is Hertz's.
#[test]
fn strips_in_flow_are_as_wide_as_is_expected() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/cases/problem-h.toml");
    let elastic = std::fs::read_to_string(path).unwrap();
    let hertz = LineContact::new(8.125, 1.5, 2.0 * 0.91 / 29_500.0).unwrap();
    for (overload, hardening) in [(1.7, 240.0), (2.5, 240.0), (4.0, 30.0), (6.0, 240.0)] {
        let yields = hertz.peak_pressure / overload;
        let steel = format!("yield_stress = {yields}\nhardening_modulus = {hardening}");
        let summary = solve(&elastic.replace("elastic = true", &steel));
        let (_, interface) = summary.answer.interfaces.0.first().unwrap();
        let width = interface.lines[0].half_width;
        let expected = hertz.half_width * widening_in_flow(hertz.peak_pressure, yields);
        let off = (width / expected - 1.0).abs();
        assert!(off <= 0.04, "{overload}: {width} against {expected}");
    }
}

/// Hertz without friction, within what finite bodies change (0.15 %) and the mesh: pressures neither
/// alternate from node to node nor take thousands of iterations, whatever the stiffer side.
#[test]
fn a_stiff_side_does_not_carry() {
    for softer in [1e-6, 1e-3, 0.1, 1.0, 10.0, 1e3, 1e6] {
        let (summary, p0) = problem_h(2, 1.0, softer, "friction = 0");
        let pressure = figure(&summary, Quantity::PeakPressure, "contact");
        let off = (pressure.value / p0 - 1.0).abs();
        assert!(off <= 0.01, "{softer}: {} against {p0}", pressure.value);
    }
}

/// Between equal bodies friction does nothing to the pressure; between unlike ones it presses harder in the
/// middle (Spence 1975), and alike whichever of the two is the softer one.
#[test]
fn friction_beside_a_stiff_side_settles() {
    let share = |softer: f64| {
        let (summary, p0) = problem_h(2, 1.0, softer, "friction = 0.2");
        assert!(
            summary.counters.iterations < 60,
            "{softer}: {}",
            summary.counters.iterations
        );
        figure(&summary, Quantity::PeakPressure, "contact").value / p0
    };
    assert!((share(1.0) - 1.0).abs() < 0.01);
    for softer in [10.0, 1e3, 1e6] {
        let (below, above) = (share(softer), share(1.0 / softer));
        assert!(
            below > 1.02 && (below / above - 1.0).abs() < 0.01,
            "{softer}: {below} {above}"
        );
    }
}

/// Eight loads that shift the edge of the strip from node to node, a node on the peak. The mean over a
/// hat function is (h/a)²/12 below the peak: 2.1, 0.5, 0.13 % for 2, 4, 8 nodes.
#[test]
fn the_edge_of_a_strip_may_lie_anywhere_between_nodes() {
    for (level, nodes, within) in [(1, 2.0, 0.022), (1, 4.0, 0.007), (2, 8.0, 0.0025)] {
        let full = f64::from(2u32 << level);
        for shift in 0..8 {
            let across: f64 = nodes + 0.125 * f64::from(shift);
            let load = (across / full).powi(2);
            for side in ["upper", "lower"] {
                let pair = format!("carrier = \"{side}\"\nfriction = 0");
                let (summary, p0) = problem_h(level, load, 1.0, &pair);
                check(
                    figure(&summary, Quantity::PeakPressure, "contact"),
                    p0,
                    within,
                );
                check(
                    figure(&summary, Quantity::HertzPressure, "contact"),
                    p0,
                    0.005,
                );
            }
        }
    }
}

/// A roller of 80 mm between plates under 1 kN/mm, elements that grow by a fifth from one to the next:
/// 0.43 mm at the edge of a strip of 0.935 mm.
#[test]
fn a_graded_strip_reads_what_hertz_has() {
    let summary = solve(
        r#"
title = "one roller between two plates"
units = "mm-N-MPa"
symmetry = ["x"]
[mesh]
file = "FIXTURES/roller-between-plates.msh.gz"
[steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
yield_stress = "1000 MPa"
ultimate_strength = "1100 MPa"
[[contact]]
name = "above"
upper = "upper_face"
lower = "roller_top"
friction = 0.15
[[contact]]
name = "below"
upper = "roller_bottom"
lower = "lower_face"
friction = 0.15
[[support]]
surface = "lower_bottom"
fixed = "xyz"
[[support]]
surface = "symx"
fixed = "x"
[[support]]
surface = "symy"
fixed = "y"
[[support]]
surface = "endy"
fixed = "y"
[[rigid_plane]]
surface = "upper_top"
fixed = "xy"
force = { z = "-1 kN" }
"#,
    );
    let compliance = 2.0 * 0.91 / 210e3;
    let p0 = (1000.0 / (PI * 80.0 * compliance)).sqrt();
    for pair in ["above", "below"] {
        check(figure(&summary, Quantity::PeakPressure, pair), p0, 0.03);
        check(figure(&summary, Quantity::HertzPressure, pair), p0, 0.002);
    }
    // Both lines are a roller of 160 mm on a flat to the rules, and are used by what Hertz says of them.
    let sizing = summary.sizing.as_ref().unwrap();
    assert_eq!(sizing.lines.len(), 2);
    for line in &sizing.lines {
        assert!((line.relative_radius / 80.0 - 1.0).abs() < 1e-6 && line.not_hertz.is_none());
        let used = line.utilisation.unwrap();
        assert!(
            (used / (p0 / 1650.0) - 1.0).abs() < 0.002 && line.met == Some(true),
            "{used}"
        );
    }
    let rules = &summary.rules.as_ref().unwrap().rules;
    let named = |name: &str| rules.iter().find(|rule| rule.rule.name == name).unwrap();
    let yields = named("first yield").largest.unwrap();
    assert!(
        (yields.utilisation / (p0 / 1793.7) - 1.0).abs() < 0.002,
        "{yields:?}"
    );
    // A slice of 10 mm is no roller of EN 1337-4, which wants a length of two diameters.
    assert!(named("EN 1337-4").largest.is_none());
}

/// A flat punch with a rounded edge of which the meshes have one element and two (NAFEMS, advanced contact
/// benchmark 2): its largest pressure doubles from the first to the second.
#[test]
fn a_fillet_that_is_not_resolved_is_called_so() {
    for mesh in ["coarse", "fine"] {
        let text = format!(
            r#"
title = "punch"
units = "mm-N-MPa"
symmetry = ["x", "y"]
[mesh]
file = "FIXTURES/punch-{mesh}.msh.gz"
[steel]
youngs_modulus = 70000
poissons_ratio = 0.3
elastic = true
[steel.punch]
youngs_modulus = 210000
[[contact]]
name = "contact"
upper = "punch_face"
lower = "plate"
friction = 0
[[support]]
surface = "symx"
fixed = "x"
[[support]]
surface = "symy"
fixed = "y"
[[pressure]]
surface = "top"
value = 100
[[support]]
surface = "base"
fixed = "xyz"
"#
        );
        let fixtures = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/");
        let case = case::parse("punch.toml", &text.replace("FIXTURES/", fixtures)).unwrap();
        let outcome = job::run(&case, &Options::default(), &mut Silent).unwrap();
        let pressure = figure(&outcome.summary, Quantity::PeakPressure, "contact");
        assert!(
            !pressure.is_resolved(),
            "{mesh}: {} ± {:?}",
            pressure.value,
            pressure.bar()
        );
        let warned = outcome
            .summary
            .warnings
            .iter()
            .any(|w| w.0.contains("peak pressure"));
        assert!(warned, "{mesh}");
    }
}

/// Rows of contact are prepared for a tenth of the gap: what was missed is found.
#[test]
fn the_answer_does_not_depend_on_what_was_prepared() {
    use brinell::case::Kind;
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/section-2.6.2");
    for name in ["initial-centre.toml", "initial-offset-1.25.toml"] {
        let mut case = case::read(&folder.join(name)).unwrap();
        case.set_preset("report-like").unwrap();
        let mesh = job::find_mesh(&case, None, &mut |_| {}).unwrap();
        assert!(matches!(case.kind, Kind::Bearing(_)));
        let forces = |reach: f64| {
            let mut scene = case.scene(mesh.clone()).unwrap();
            scene.controls.contact_reach = reach;
            let solution = brinell::solver::solve::solve(&mut scene, &mut Silent).unwrap();
            let travel = solution.last.planes.iter().flat_map(|p| p.travel);
            let pressure = solution
                .last
                .contacts
                .iter()
                .flat_map(|c| c.pressure.clone());
            (travel.collect::<Vec<_>>(), pressure.collect::<Vec<_>>())
        };
        let (usual, short) = (forces(1.0), forces(0.1));
        for (usual, short) in [(usual.0, short.0), (usual.1, short.1)] {
            let size = usual.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            for (a, b) in usual.iter().zip(&short) {
                assert!((a - b).abs() <= 1e-8 * size, "{name}: {a} {b} of {size}");
            }
        }
    }
}

/// Displaced rollers rest on one face of a V, whose two faces are one surface: its curvature there is that of a plane.
#[test]
fn a_roller_on_one_face_of_a_v_presses_like_hertz() {
    use brinell::answer::results::edges::LoadedEdges;
    use brinell::answer::results::hertz::HeaviestLine;
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/section-2.6.2");
    let mut case = case::read(&folder.join("initial-offset-1.25.toml")).unwrap();
    case.set_preset("report-like").unwrap();
    case.controls.plasticity = false;
    let mesh = job::find_mesh(&case, None, &mut |_| {}).unwrap();
    let mut scene = case.scene(mesh).unwrap();
    let state = brinell::solver::solve::solve(&mut scene, &mut Silent)
        .unwrap()
        .last;
    let edges = LoadedEdges::find(&scene, &state);
    for (pair, contact) in scene.contacts.iter().enumerate() {
        let line = HeaviestLine::find(&scene, &state, pair, &edges).unwrap();
        let hertz = line.contact.expect(&contact.name);
        assert!(
            (hertz.radius - 1.5).abs() < 1e-6,
            "{}: {hertz:?}",
            contact.name
        );
    }
}

/// Stacks of tilted blocks whose meshes do not match: the other side covers slivers of some facets, next to nothing
/// of others. They are pressed by 40 MPa and more, pushed sideways, and flow.
#[test]
fn blocks_that_cover_slivers_of_each_other_converge() {
    const TOP: &str = r#"
[[body]]
name = "top"
[[contact]]
name = "c2"
upper = "top_z0"
lower = "upp_z1"
friction = FRICTION
carrier = "lower"
"#;
    for (mesh, top, friction, traction) in [
        (1, TOP, 0.6, [5.3829, -10.4379, -244.287]),
        (2, "", 0.4, [7.2494, 10.1148, -339.569]),
        (3, TOP, 0.4, [-4.1947, 13.4348, -352.458]),
    ] {
        let loaded = if top.is_empty() { "upp" } else { "top" };
        let top = top.replace("FRICTION", &friction.to_string());
        let summary = solve(&format!(
            r#"
title = "blocks"
units = "mm-N-MPa"
[mesh]
file = "FIXTURES/blocks-sliver-{mesh}.msh.gz"
[steel]
youngs_modulus = 200000
poissons_ratio = 0.3
yield_stress = 150
hardening_modulus = 4000
[[body]]
name = "upp"
steel = {{ youngs_modulus = 70000 }}
[[body]]
name = "low"
{top}
[[contact]]
name = "c1"
upper = "upp_z0"
lower = "low_z1"
friction = {friction}
carrier = "lower"
[[traction]]
name = "push"
surface = "{loaded}_z1"
value = {traction:?}
[[support]]
surface = "low_z0"
fixed = "xyz"
"#
        ));
        assert!(
            summary.counters.iterations < 300,
            "{mesh}: {}",
            summary.counters.iterations
        );
        assert!(summary.answer.checks.energy_imbalance.unwrap() < 1e-6);
    }
}

/// A cylinder ten thousand times as stiff pressed into a steel block until it flows, and taken off. Source: 1.98 of the yield
/// stress for the largest pressure, with the block's own nodes as carriers; those of the stiff side alternate about
/// that, up to 2.5.
#[test]
fn a_stiff_cylinder_dents_a_block_without_alternating() {
    let summary = solve(&format!(
        r#"
title = "dent"
units = "in-kip-ksi"
symmetry = ["x"]
[mesh]
file = "FIXTURES/cylinder-into-block.msh.gz"
[steel]
youngs_modulus = 29500.0
poissons_ratio = 0.3
yield_stress = 100.0
hardening_modulus = 249.47
[steel.cylinder]
youngs_modulus = 2.95e8
elastic = true
[[contact]]
upper = "cylinder_contact"
lower = "block_contact"
[[pressure]]
surface = "top"
value = 2.3384
{SLICE}
[[step]]
name = "load"
factor = 1
[[step]]
name = "unload"
factor = 0.001
"#
    ));
    let peak = figure(
        &summary,
        Quantity::PeakPressure,
        "cylinder_contact-block_contact",
    );
    assert!((peak.value / 198.0 - 1.0).abs() < 0.02, "{}", peak.value);
    assert!(
        summary.counters.iterations < 120,
        "{}",
        summary.counters.iterations
    );
}

/// The centred bearing with all that design rules want: each says of the loads what its formula does.
#[test]
fn design_rules_are_asked_about_the_loads_that_were_found() {
    let file = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/cases/section-2.6.2/initial-centre.toml"
    );
    let text = std::fs::read_to_string(file).unwrap();
    let text = text
        .replace(
            "[steel]",
            "[steel]\nultimate_strength = \"110 ksi\"\nhardness = 240",
        )
        .replace("[bearing]", "[bearing]\nrollings = 1e5");
    let mut case = case::parse(file, &text).unwrap();
    case.set_preset("h025").unwrap();
    let summary = job::run(&case, &Options::default(), &mut Silent)
        .unwrap()
        .summary;
    let sheet = summary.rules.as_ref().unwrap();
    let judged = |name: &str| {
        let rule = sheet
            .rules
            .iter()
            .find(|rule| rule.rule.name == name)
            .unwrap();
        (rule.even.unwrap(), rule.largest.unwrap())
    };
    let lines = summary.answer.interfaces.0.iter();
    let found = lines.flat_map(|(_, i)| &i.lines).map(|line| line.peak);
    let found = found.fold(0.0, f64::max);
    let claim = figure(&summary, Quantity::LineLoad, "upper_plate-upper_roller");
    // EN 1337-4: 23 · 1.5 · 110² / 29500 = 14.151 kip/in. EN 13001-3-3: 1680 N/mm² = 243.66 ksi,
    // 243.66² π 3 · 0.91 · 0.85 / (29500 · 1.1) = 13.338 kip/in; with 720, 2.4499 over (1/64)^0.3 = 0.28717: 8.531.
    for (name, limit) in [
        ("EN 1337-4", 14.151),
        ("EN 13001-3-3, static", 13.338),
        ("EN 13001-3-3, fatigue", 8.531),
    ] {
        let (even, largest) = judged(name);
        assert!(
            (even.utilisation * limit / 8.125 - 1.0).abs() < 2e-3,
            "{name}: {even:?}"
        );
        assert!(
            (largest.utilisation * limit / found - 1.0).abs() < 2e-4,
            "{name}: {largest:?}"
        );
        let error = largest.error.unwrap() * limit;
        assert!(
            (error / claim.bar().unwrap() - 1.0).abs() < 0.05,
            "{name}: {error}"
        );
    }
    // 9.2 ± 0.2 kip/in beside 9.354 at first yield: it takes the error to say that this is open.
    assert_eq!(
        judged("first yield").1.verdict.to_string(),
        "open: within the error"
    );
    assert_eq!(judged("first yield").0.verdict.to_string(), "below");
    assert_eq!(judged("(2-49)").1.verdict.to_string(), "NOT met");
    let iso = sheet
        .rules
        .iter()
        .find(|rule| rule.rule.name == "ISO 76")
        .unwrap();
    assert!(iso.rule.bound().is_none() && iso.largest.is_none());
    // The steel flows, and the sheet has what the answer has.
    assert_eq!(sheet.steel.len(), 5);
    for steel in &sheet.steel {
        let body = summary
            .answer
            .bodies
            .0
            .iter()
            .find(|(name, _)| *name == steel.body);
        let (_, body) = body.unwrap();
        assert_eq!(
            (steel.peeq_max, steel.yielded_volume),
            (body.peeq_max, body.yielded_volume)
        );
        assert!(steel.peeq_max > 0.0 && steel.dent.is_none());
    }
}

/// Hertz, R = 10 mm, E = 210 GPa, 1 kN. A mesh of gmsh's that is no grid (tetrahedra that were split), four to five faces in the radius
/// of contact: a node has an error of its own there, and the peak is 3.2 % below that of Hertz.
#[test]
fn a_pressure_on_an_unstructured_mesh_is_inside_its_bar() {
    let reduced = 210_000.0 / (2.0 * 0.91);
    let pressure = (6.0 * 1000.0 * reduced * reduced / (PI.powi(3) * 100.0)).cbrt();
    let summary = solve(
        r#"
title = "sphere on an unstructured mesh"
units = "mm-N-MPa"
symmetry = ["x", "y"]
[mesh]
file = "FIXTURES/sphere-on-block-unstructured.msh.gz"
[steel]
youngs_modulus = 210000.0
poissons_ratio = 0.3
elastic = true
[[contact]]
name = "contact"
upper = "sf"
lower = "bt"
[[rigid_plane]]
surface = "st"
force = { z = "-1000 N" }
fixed = "xy"
[[support]]
surface = "bb"
fixed = "xyz"
"#,
    );
    let claim = figure(&summary, Quantity::PeakPressure, "contact");
    check(claim, pressure, 0.05);
    let bar = claim.bar().unwrap();
    assert!(bar < 0.12 * pressure, "{bar}");
}

/// A column of 4 by 4 by 10 mm, E = 2 GPa, and a beam of 4 by 4 by 30 mm, E = 210 GPa, clamped at one end, whose other end one rigid
/// plane presses down with the column. By Timoshenko, with 5/6 of the section for shear, the beam is a spring of 1910 N/mm beside one
/// of 3200, and the foot of the column bears 39.14 MPa of 1 kN.
#[test]
fn an_even_pressure_has_the_error_of_what_carries_the_rest_of_the_load() {
    let inertia = 4f64.powi(4) / 12.0;
    let bends = 30f64.powi(3) / (12.0 * 210e3 * inertia);
    let shears = 30.0 / (5.0 / 6.0 * 105e3 * 16.0);
    let (beam, column) = (1.0 / (bends + shears), 2000.0 * 16.0 / 10.0);
    let pressure = 1000.0 / 16.0 * column / (beam + column);
    assert!((pressure - 39.14).abs() < 0.01, "{pressure}");
    for along in [6, 12] {
        let summary = solve(&format!(
            r#"
title = "column and beam"
units = "mm-N-MPa"
[mesh]
file = "FIXTURES/column-and-beam-{along}.msh.gz"
[steel]
youngs_modulus = 210e3
poissons_ratio = 0
elastic = true
[steel.col]
youngs_modulus = 2000
[[contact]]
name = "foot"
upper = "cb"
lower = {{ plane = {{ point = [0, 0, 0], normal = [0, 0, 1] }} }}
friction = 0
[[rigid_plane]]
surface = "top"
force = {{ z = "-1000 N" }}
fixed = "xy"
[[support]]
surface = "root"
fixed = "xyz"
"#
        ));
        // One element in the depth of the beam.
        check(
            figure(&summary, Quantity::PeakPressure, "foot"),
            pressure,
            0.15,
        );
    }
}

/// A slice whose two ends one support holds is as one whose ends two hold: they are no loaded edges.
#[test]
fn one_support_may_hold_both_ends_of_a_slice() {
    let summary = |support: &str| {
        solve(&format!(
            r#"
title = "slice"
units = "mm-N-MPa"
symmetry = ["x"]
[mesh]
file = "FIXTURES/slice-held-by-one-support.msh.gz"
[steel]
youngs_modulus = 210e3
poissons_ratio = 0.3
elastic = true
[[contact]]
name = "contact"
upper = "cf"
lower = "bf"
friction = 0.2
[[rigid_plane]]
surface = "ct"
force = {{ y = "-500 N" }}
fixed = "xz"
[[support]]
surface = "bb"
fixed = "y"
{support}
"#
        ))
    };
    let one = summary("[[support]]\nsurface = \"z\"\nfixed = \"z\"");
    let hertz = LineContact::new(1000.0, 10.0, 2.0 * 0.91 / 210e3).unwrap();
    let within = 0.005;
    check(
        figure(&one, Quantity::HertzPressure, "contact"),
        hertz.peak_pressure,
        within,
    );
    check(
        figure(&one, Quantity::PeakPressure, "contact"),
        hertz.peak_pressure,
        0.05,
    );
    check(
        figure(&one, Quantity::PeakMises, "blk"),
        0.5578 * hertz.peak_pressure,
        0.1,
    );
}

/// A pin that fills its hole but for 0.33 µm that it is larger by, and presses on the lower half of it with 256 N on 1 mm. Nodes of the
/// upper half stand above those that press, and belong to no row of theirs. Sources: the pressure over the arc, 349.5 N/mm, by own
/// meshes eight times as fine; the force by statics.
#[test]
fn a_pin_in_its_hole_presses_in_one_line() {
    let summary = solve(
        r#"
title = "pin"
units = "mm-N-MPa"
symmetry = ["x"]
[mesh]
file = "FIXTURES/pin-in-hole.msh.gz"
[steel]
youngs_modulus = 70000
poissons_ratio = 0.3
elastic = true
[[contact]]
name = "c"
upper = "pinf"
lower = "hole"
friction = 0
[[support]]
surface = "zs"
fixed = "z"
[[support]]
surface = "rim"
fixed = "xyz"
[[rigid_plane]]
surface = "bore"
fixed = "xz"
force = { y = -256.234 }
"#,
    );
    let lines = &summary.answer.interfaces.get("c").unwrap().lines;
    assert_eq!(lines.len(), 1);
    check(figure(&summary, Quantity::LineLoad, "c"), 349.5, 0.005);
}
