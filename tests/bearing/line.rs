//! Parallel rollers: the template against its geometry, bad geometry, and solutions against Hertz and each other.

use brinell::answer::InterfaceFigures;
use brinell::answer::certify::Quantity;
use brinell::case::{Case, CaseError, Kind, parse};
use brinell::product::job::{self, Options, Outcome};
use brinell::solver::solve::Silent;
use miette::Diagnostic;
use std::f64::consts::PI;
use std::time::Instant;

pub(super) const BASE: &str = r#"title = "rollers"
units = "mm-N-MPa"

[line_bearing]
load = "100 kN"
friction = 0.1
solid = true
roller_diameter = "100 mm"
roller_length = "120 mm"
plate_thickness = "40 mm"

[steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
elastic = true
"#;

fn with(changes: &[(&str, &str)]) -> String {
    changes.iter().fold(BASE.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    })
}

pub(super) fn read(text: &str) -> Result<Case, CaseError> {
    parse("cases/test.toml", text)
}

pub(super) fn solved(case: &Case) -> Outcome {
    let options = Options {
        out: None,
        ..Options::default()
    };
    let outcome = job::run(case, &options, &mut Silent).expect("a solution");
    assert!(!outcome.interrupted);
    outcome
}

fn interface<'o>(outcome: &'o Outcome, name: &str) -> &'o InterfaceFigures {
    let figures = outcome.summary.answer.interfaces.get(name);
    figures.unwrap_or_else(|| panic!("no interface {name}"))
}

/// p0 of a load per length on an effective radius, E = 210 GPa, ν = 0.3 on both sides.
fn hertz(line_load: f64, radius: f64) -> f64 {
    let compliance = 2.0 * (1.0 - 0.09) / 210e3;
    (line_load / (PI * radius * compliance)).sqrt()
}

/// Square ends flush with the plates: the load is even, and by balance the lines of both interfaces carry it all. p0 is
/// Hertz's but for the ends, which bulge freely: measured by the middle of the roller.
#[test]
fn a_roller_presses_as_hertz_has_it() {
    for (curve, curvature) in [
        ("", 0.0),
        (
            "plate_curve = { plate = \"lower\", radius = \"300 mm\", sense = \"concave\" }",
            -1.0 / 300.0,
        ),
        (
            "plate_curve = { plate = \"lower\", radius = \"300 mm\", sense = \"convex\" }",
            1.0 / 300.0,
        ),
    ] {
        let text = with(&[(
            "plate_thickness = \"40 mm\"",
            &format!("plate_thickness = \"40 mm\"\n{curve}"),
        )]);
        let outcome = solved(&read(&text).unwrap());
        for (name, curvature) in [
            ("upper_plate-roller", 0.0),
            ("roller-lower_plate", curvature),
        ] {
            let figures = interface(&outcome, name);
            assert!(
                (figures.normal_force / 100e3 - 1.0).abs() < 1e-8,
                "{name}: {}",
                figures.normal_force
            );
            // On curved faces normals lean by up to a/R over the strip, about 0.01: the vertical share differs by half its square.
            let within = if curvature == 0.0 { 1e-6 } else { 1e-4 };
            let line = &figures.lines[0];
            assert!(
                (line.mean / (100e3 / 120.0) - 1.0).abs() < within,
                "{name}: {}",
                line.mean
            );
            let q = figures.q.as_ref().unwrap();
            let sum: f64 = q
                .edges
                .windows(2)
                .zip(&q.values)
                .map(|(e, q)| 2.0 * (e[1] - e[0]) * q)
                .sum();
            assert!((sum / 100e3 - 1.0).abs() < 1e-8, "{name}: {sum}");
            let expected = hertz(100e3 / 120.0, 1.0 / (1.0 / 50.0 + curvature));
            // The line load at the middle of the roller, as found, by Hertz.
            let p0 = figures.hertz_p0.expect("a Hertzian line");
            let own = hertz(line.peak, 1.0 / (1.0 / 50.0 + curvature));
            assert!((p0 / own - 1.0).abs() < 1e-3, "{name}: {p0} and {own}");
            assert!(
                (p0 / expected - 1.0).abs() < 0.05,
                "{name}: {p0}, {expected} of an even load"
            );
            assert!(
                (figures.max_pressure / p0 - 1.0).abs() < 0.05,
                "{name}: {} {p0}",
                figures.max_pressure
            );
        }
    }
}

/// Rollers side by side: by balance all of a level carry the load; by symmetry those of an image the same; and the
/// quarter says of each what the whole on the images of its mesh says.
#[test]
fn a_quarter_of_several_rollers_says_what_the_whole_says() {
    for (rollers, own) in [(2, "wall"), (3, "solid")] {
        let text = with(&[
            (
                "roller_diameter",
                &format!("rollers = {rollers}\nspacing = \"130 mm\"\nroller_diameter"),
            ),
            (
                "solid = true",
                if own == "wall" {
                    "roller_wall = \"25 mm\""
                } else {
                    "solid = true"
                },
            ),
        ]);
        let text = format!("{text}\n[mesh]\npreset = \"h025\"\n");
        let case = read(&text).unwrap();
        let quarter = solved(&case);
        assert_eq!(quarter.scene.mirrors, [0, 1]);
        let mut full = case.clone();
        full.set_full().unwrap();
        let whole = job::run(
            &full,
            &Options {
                out: None,
                ..Options::default()
            },
            &mut Silent,
        )
        .unwrap();
        assert!(whole.scene.mirrors.is_empty());
        let mut sum = [0.0; 2];
        for (name, figures) in &whole.summary.answer.interfaces.0 {
            sum[usize::from(name.starts_with("upper"))] += figures.normal_force;
        }
        for sum in sum {
            assert!((sum / 100e3 - 1.0).abs() < 1e-8, "{sum}");
        }
        // All rollers of a level together bear the load, and nothing says that one of them misses it.
        for outcome in [&quarter, &whole] {
            let balance = outcome.summary.answer.checks.force_balance.unwrap();
            assert!(balance < 1e-8, "{balance}");
        }
        for (name, a) in &quarter.summary.answer.interfaces.0 {
            let b = interface(&whole, name);
            for (what, a, b) in [
                ("force", a.normal_force, b.normal_force),
                ("integral", a.pressure_integral, b.pressure_integral),
                ("pressure", a.max_pressure, b.max_pressure),
                ("area", a.area, b.area),
                ("line load", a.lines[0].peak, b.lines[0].peak),
            ] {
                assert!(
                    (a / b - 1.0).abs() < 1e-8,
                    "{rollers} {name} {what}: {a} in the quarter, {b} in the whole"
                );
            }
        }
        let descents = [&quarter, &whole].map(|o| o.summary.answer.descent.unwrap());
        assert!(
            (descents[0] / descents[1] - 1.0).abs() < 1e-8,
            "{descents:?}"
        );
        for (name, a) in &quarter.summary.answer.bodies.0 {
            let b = whole.summary.answer.bodies.get(name).unwrap();
            assert!(
                (a.volume / b.volume - 1.0).abs() < 1e-9,
                "{name}: {} {}",
                a.volume,
                b.volume
            );
        }
    }
}

/// Volumes of the mesh against closed forms, on the shapes that are not those of gmsh.
#[test]
fn bodies_have_their_volumes() {
    let curve = "plate_curve = { plate = \"upper\", radius = \"200 mm\", sense = \"convex\" }\nplate_thickness";
    for (end, wall) in [
        ("\"square\"", None),
        ("{ radius = \"2 mm\", crown = \"20 µm\" }", Some(20.0)),
    ] {
        let inside = wall.map_or("solid = true".to_owned(), |w| {
            format!("roller_wall = \"{w} mm\"")
        });
        let text = with(&[
            ("solid = true", &format!("roller_end = {end}\n{inside}")),
            ("plate_thickness", curve),
        ]);
        let case = read(&text).unwrap();
        let mesh = job::find_mesh(&case, None, &mut |_| {}).unwrap();
        let scene = case.scene(mesh).unwrap();
        let quality = scene.mesh.quality();
        for (body, quality) in scene.mesh.bodies.iter().zip(quality) {
            assert!(
                quality.min_scaled_jacobian > 0.1,
                "{}: {}",
                body.name,
                quality.min_scaled_jacobian
            );
            let bore = wall.map_or(0.0, |w: f64| 50.0 - w);
            let wanted = match body.name.as_str() {
                "roller" => PI * (2500.0 - bore * bore) * 120.0,
                "lower_plate" => 40.0 * 150.0 * 120.0,
                // A circular segment of chord 150 mm less: r² asin(c/2r) - c/2 √(r² - c²/4), off the tangent.
                _ => {
                    let (r, half) = (200.0f64, 75.0f64);
                    let below = 2.0 * half * r
                        - (r * r * (half / r).asin() + half * (r * r - half * half).sqrt());
                    (40.0 * 150.0 - below) * 120.0
                }
            };
            let off = 4.0 * quality.volume / wanted - 1.0;
            // Polygons and fillets are a little smaller than circles.
            assert!(off.abs() < 0.015, "{} {end}: {off}", body.name);
        }
        let Kind::Bearing(bearing) = &case.kind else {
            panic!("a bearing")
        };
        let counted = bearing.elements() / scene.mesh.hexes.len() as f64;
        assert!(
            (0.6..1.7).contains(&counted),
            "{counted} of the elements were counted"
        );
    }
}

#[test]
fn bad_geometry_is_refused_where_it_stands() {
    let three = "rollers = 3\nspacing = \"130 mm\"\nroller_diameter";
    for (changes, key, why) in [
        (
            vec![(
                "roller_diameter",
                "rollers = 9223372036854775807\nspacing = \"130 mm\"\nroller_diameter",
            )],
            "line_bearing.rollers",
            "between 1 and 12",
        ),
        (
            vec![(
                "roller_diameter",
                "rollers = 2\nspacing = \"90 mm\"\nroller_diameter",
            )],
            "line_bearing.spacing",
            "1.01 diameters",
        ),
        (
            vec![("roller_diameter", "rollers = 2\nroller_diameter")],
            "line_bearing.spacing",
            "missing",
        ),
        (
            vec![("roller_diameter", "spacing = \"90 mm\"\nroller_diameter")],
            "line_bearing.spacing",
            "there is one",
        ),
        (
            vec![("solid = true", "roller_wall = \"50 mm\"")],
            "line_bearing.roller_wall",
            "0.49 diameters",
        ),
        (
            vec![(
                "solid = true",
                "solid = true\nroller_end = { crown = \"40 mm\" }",
            )],
            "line_bearing.roller_end.crown",
            "half the radius",
        ),
        (
            vec![(
                "solid = true",
                "solid = true\nroller_end = { radius = \"20 mm\", crown = \"10 mm\" }",
            )],
            "line_bearing.roller_end.crown",
            "half the radius",
        ),
        (
            vec![(
                "plate_thickness",
                "plate_size = [\"200 mm\", \"100 mm\"]\nplate_thickness",
            )],
            "line_bearing.plate_size",
            "along y",
        ),
        (
            vec![
                ("roller_diameter", three),
                (
                    "plate_thickness",
                    "plate_size = [\"260 mm\", \"120 mm\"]\nplate_thickness",
                ),
            ],
            "line_bearing.plate_size",
            "along x",
        ),
        (
            vec![
                ("roller_diameter", three),
                (
                    "plate_thickness",
                    "plate_curve = { plate = \"upper\", radius = \"1 m\", sense = \"convex\" }\nplate_thickness",
                ),
            ],
            "line_bearing.rollers",
            "curved plate",
        ),
        (
            vec![(
                "plate_thickness",
                "plate_curve = { plate = \"upper\", radius = \"60 mm\", sense = \"concave\" }\nplate_thickness",
            )],
            "line_bearing.plate_curve.radius",
            "more than",
        ),
        (
            vec![("plate_thickness", "offset = \"1 mm\"\nplate_thickness")],
            "line_bearing.offset",
            "not known",
        ),
        (
            vec![("[steel]", "[mesh]\npreset = \"report-like\"\n[steel]")],
            "mesh.preset",
            "one of",
        ),
        (
            vec![("[steel]", "[mesh]\ncrossing_size = \"1 mm\"\n[steel]")],
            "mesh.crossing_size",
            "not known",
        ),
        (
            vec![("[steel]", "[bearing]\nload = 1\n[steel]")],
            "line_bearing",
            "two bearings",
        ),
    ] {
        let error = read(&with(&changes)).expect_err(key);
        let mut text = error.to_string();
        if let Some(labels) = error.labels() {
            labels.for_each(|label| text.push_str(label.label().unwrap_or_default()));
        }
        text.push_str(&error.help().map(|h| h.to_string()).unwrap_or_default());
        let last = key.rsplit('.').next().unwrap();
        assert!(text.contains(last) && text.contains(why), "{key}: {text}");
    }
}

/// Rollers of unlike steels have no mirror plane between them.
#[test]
fn unlike_rollers_are_solved_as_a_half() {
    let two = with(&[(
        "roller_diameter",
        "rollers = 2\nspacing = \"130 mm\"\nroller_diameter",
    )]);
    let Kind::Bearing(alike) = read(&two).unwrap().kind else {
        panic!("a bearing")
    };
    assert_eq!(alike.mirrors(), [0, 1]);
    let softer = format!("{two}\n[steel.roller_1]\nyoungs_modulus = \"100 GPa\"\n");
    let Kind::Bearing(unlike) = read(&softer).unwrap().kind else {
        panic!("a bearing")
    };
    assert_eq!(unlike.mirrors(), [1]);
    assert_eq!(unlike.seats().len(), 4);
    // A steel by its name has the strength of the thickness of its part, which rollers alike share.
    let named = two[..two.find("[steel]").unwrap()].replace("title", "steel = \"S355\"\ntitle");
    let case = read(&named).unwrap();
    let Kind::Bearing(bearing) = &case.kind else {
        panic!("a bearing")
    };
    assert_eq!(bearing.mirrors(), [0, 1]);
    let strength = |body: &str| bearing.steels.strength_of(body).unwrap().yield_stress;
    assert_eq!(strength("roller_1"), Some(315.0));
    assert_eq!(strength("upper_plate"), Some(345.0));
    let said = case
        .assumptions
        .iter()
        .filter(|a| a.key == "steel.thickness");
    assert_eq!(said.count(), 1);
}

/// A tilted top turns about the axis of the roller, which stands off both plates by half of the angle: it is not dragged
/// along its axis, no shear of its ends turns it, and the moments of the two line loads balance each other.
#[test]
fn a_tilted_top_drags_no_roller_along() {
    let text = with(&[(
        "solid = true",
        "solid = true\ntop = { tilt = [\"0.1 mrad\", 0] }",
    )]);
    let outcome = solved(&read(&format!("{text}\n[mesh]\npreset = \"h025\"\n")).unwrap());
    let [upper, lower] =
        ["upper_plate-roller", "roller-lower_plate"].map(|name| interface(&outcome, name));
    for figures in [upper, lower] {
        assert!(figures.force[1].abs() < 1e-3 * 100e3, "{:?}", figures.force);
    }
    let moment = |figures: &InterfaceFigures| {
        let q = figures.q.as_ref().unwrap();
        let slices = q.edges.windows(2).zip(&q.values);
        slices
            .map(|(e, q)| (e[1] - e[0]) * q * 0.5 * (e[0] + e[1]))
            .sum::<f64>()
    };
    let [upper, lower] = [moment(upper), moment(lower)];
    assert!(upper < -1e5, "{upper}");
    assert!((upper / lower - 1.0).abs() < 1e-3, "{upper} {lower}");
}

/// The nodal forces and the line load say where the force of a tilted roller acts, the line load within 1 %: its rows at the
/// ends act a third of their step further in. A finer mesh lies within both bars, and without a given angle there is no such
/// figure.
#[test]
fn a_given_tilt_has_an_eccentricity() {
    let text = |top: &str, preset: &str| {
        let keys = format!("solid = true\n{top}");
        let text = with(&[("solid = true", keys.as_str())]);
        format!("{text}\n[mesh]\npreset = \"{preset}\"\n")
    };
    let on = |top: &str, preset: &str| {
        let outcome = solved(&read(&text(top, preset)).unwrap());
        let found = outcome
            .summary
            .answer
            .figure(Quantity::Eccentricity, "upper_plate-roller")
            .cloned();
        let figures = interface(&outcome, "upper_plate-roller");
        let line = &figures.lines[0];
        let rows = || line.at.windows(2).zip(line.load.windows(2));
        let integral = |of: &dyn Fn(f64) -> f64| -> f64 {
            rows()
                .map(|(at, q)| 0.5 * (q[0] * of(at[0]) + q[1] * of(at[1])) * (at[1] - at[0]))
                .sum()
        };
        let by_rows = integral(&|at| at) / integral(&|_| 1.0);
        (found, figures.centre_of_force.unwrap()[1], by_rows)
    };
    let tilt = "top = { tilt = [\"0.1 mrad\", 0] }";
    let [coarse, fine] = ["h025", "h0125"].map(|preset| {
        let (found, centre, by_rows) = on(tilt, preset);
        let found = found.expect("an eccentricity");
        assert!(
            (found.value / centre - 1.0).abs() < 1e-3,
            "{found:?} {centre}"
        );
        assert!(
            (found.value / by_rows - 1.0).abs() < 0.01,
            "{found:?} {by_rows}"
        );
        (found.value, found.bar().expect("a bar"))
    });
    assert!(
        (coarse.0 - fine.0).abs() < coarse.1 + fine.1,
        "{coarse:?} {fine:?}"
    );
    assert!(fine.1 < coarse.1 && fine.1 < 0.1 * fine.0.abs(), "{fine:?}");
    assert_eq!(on("", "h025").0, None);
    assert_eq!(on("top = \"free\"", "h025").0, None);
}

/// Both bridge rollers, on their own meshes: seconds, and p0 as Hertz has it.
/// Statics: two rollers 80 mm apart bear P (1/2 ± e/80), and (2-50) is asked of the one that bears more. Side by side they keep the
/// plate from rolling about either of them, so that its travel is known.
#[test]
fn the_heavier_of_two_rollers_is_the_one_that_is_sized() {
    let text = with(&[
        (
            "load = \"100 kN\"",
            "load = \"28 kN\"\nrollers = 2\nspacing = \"80 mm\"\ntop = \"free\"\neccentricity = [\"10 mm\", 0]",
        ),
        ("\"100 mm\"", "\"50 mm\""),
        ("\"120 mm\"", "\"40 mm\""),
        (
            "elastic = true",
            "yield_stress = \"460 MPa\"\ntangent_modulus = \"2 GPa\"",
        ),
    ]) + "[mesh]\npreset = \"h025\"\nscale = 2\n";
    let outcome = solved(&read(&text).unwrap());
    let heavier = 28e3 * (0.5 + 10.0 / 80.0);
    let force = interface(&outcome, "upper_plate-roller_2").pressure_integral;
    assert!((force / heavier - 1.0).abs() < 1e-3, "{force}");
    let sizing = outcome.summary.sizing.as_ref().unwrap();
    let rule = sizing.rule.as_ref().unwrap();
    assert!((rule.load / heavier - 1.0).abs() < 1e-3, "{}", rule.load);
    // D L in mm² for 17.5 kN, and 2000 of it.
    assert_eq!((rule.printed.met, rule.exact.met), (false, false));
    let descent = outcome.summary.answer.figure(Quantity::Descent, "overall");
    let descent = descent.unwrap();
    let bar = descent.bar().unwrap();
    // Rolling about one of them it might be off by a hundred times itself.
    assert!(bar < descent.value, "{} ± {bar}", descent.value);
}

/// A top that is held at a slope lifts off one of two rollers. The other one bears all and is sized; the one that bears nothing asks
/// for nothing.
#[test]
fn a_roller_that_lifts_off_is_not_sized() {
    let text = with(&[
        (
            "load = \"100 kN\"",
            "load = \"20 kN\"\nrollers = 2\nspacing = \"200 mm\"\ntop = { tilt = [\"0 mrad\", \"1 mrad\"] }",
        ),
        ("elastic = true", "yield_stress = \"460 MPa\""),
    ]) + "[mesh]\npreset = \"h025\"\nscale = 3\n";
    let outcome = solved(&read(&text).unwrap());
    let force = |roller: u32| {
        interface(&outcome, &format!("upper_plate-roller_{roller}")).pressure_integral
    };
    assert_eq!(force(1), 0.0);
    assert!((force(2) / 20e3 - 1.0).abs() < 1e-6, "{}", force(2));
    let rule = outcome
        .summary
        .sizing
        .as_ref()
        .and_then(|sizing| sizing.rule.as_ref());
    assert!((rule.unwrap().load / 20e3 - 1.0).abs() < 1e-6);
}

#[test]
fn bridge_rollers() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/line-bearing");
    for (name, load, length, diameter, fails) in [
        ("bridge-roller", 450.0, 500.0, 200.0, false),
        ("bridge-roller-fails", 900.0, 400.0, 120.0, true),
    ] {
        let case = brinell::case::read(&root.join(format!("{name}.toml"))).unwrap();
        let start = Instant::now();
        let outcome = solved(&case);
        println!("{name}: {} s", start.elapsed().as_secs_f64());
        let even = load / length;
        let p0 = (even * 210.0 / (2.0 * PI * 0.91 * diameter / 2.0)).sqrt();
        for name in ["upper_plate-roller", "roller-lower_plate"] {
            let figures = interface(&outcome, name);
            assert!((figures.normal_force / load - 1.0).abs() < 1e-8);
            let line = &figures.lines[0];
            assert!((line.mean / even - 1.0).abs() < 1e-6);
            // At the ends, which bulge freely, a little less is carried, and so a little more in the middle.
            let row = line.at.iter().position(|at| at.abs() < 1e-9).unwrap();
            assert!(
                (line.load[row] / even - 1.0).abs() < 0.05,
                "{} {even}",
                line.load[row]
            );
            if !fails {
                let found = figures.hertz_p0.unwrap();
                assert!((found / p0 - 1.0).abs() < 0.05, "{found} {p0}");
                assert!(
                    (figures.max_pressure / p0 - 1.0).abs() < 0.06,
                    "{} {p0}",
                    figures.max_pressure
                );
            }
        }
        for row in outcome
            .summary
            .comparison
            .iter()
            .filter(|row| row.what.starts_with("peak pressure"))
        {
            assert!((row.hertz.unwrap() / p0 - 1.0).abs() < 1e-6, "{row:?}");
        }
        let rules = outcome.summary.rules.as_ref().unwrap();
        let studied = rules
            .rules
            .iter()
            .find(|judged| judged.rule.source.contains("2-49"));
        let worst = rules.rules.iter().filter_map(|judged| judged.even.as_ref());
        let worst = worst.map(|even| even.utilisation).fold(0.0, f64::max);
        println!("{name}: {worst} {:?}", studied.is_some());
        let sizing = outcome.summary.sizing.as_ref().unwrap();
        assert_eq!(
            sizing.lines.iter().any(|line| line.met == Some(false)),
            fails
        );
    }
}
