//! Rollers askew.

use super::line::{BASE, read, solved};
use brinell::model::scene::Scene;
use brinell::product::job::{self, Outcome};
use brinell::solver::solve::close_gaps;

const SKEW: f64 = 0.02;

fn parallel(more: &str) -> String {
    BASE.replace("\n[steel]", &format!("{more}\n\n[steel]"))
}

fn crossed(skew: &str) -> String {
    format!(
        r#"title = "askew in a valley"
units = "mm-N-MPa"

[bearing]
load = "100 kN"
friction = 0.15
roller_diameter = "80 mm"
roller_wall = "20 mm"
roller_length = "200 mm"
plate_thickness = "25 mm"
slope = "4 deg"
offset = 0
skew = {skew}

[steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
elastic = true
"#
    )
}

fn scene(text: &str) -> Scene {
    let case = read(text).unwrap();
    let mesh = job::find_mesh(&case, None, &mut |_| {}).unwrap();
    case.scene(mesh).unwrap()
}

/// Between flat plates a strip is the same in any direction of the plan: p0 stays, to the order of the angle squared, and
/// the pressure follows the axis that was turned by the right hand.
#[test]
fn a_roller_askew_presses_as_a_straight_one_along_its_own_axis() {
    let straight = solved(&read(&parallel("")).unwrap());
    let askew = solved(&read(&parallel("skew = \"20 mrad\"")).unwrap());
    assert_eq!(straight.scene.mirrors, [0, 1]);
    assert!(askew.scene.mirrors.is_empty());
    for name in ["upper_plate-roller", "roller-lower_plate"] {
        let p0 = |outcome: &Outcome| {
            let figures = outcome.summary.answer.interfaces.get(name);
            figures.unwrap().hertz_p0.expect("a strip of Hertz's")
        };
        let ratio = p0(&askew) / p0(&straight);
        assert!((ratio - 1.0).abs() < SKEW * SKEW + 1e-3, "{name}: {ratio}");
    }
    for field in &askew.state().contacts {
        // Σ F x y / Σ F y²: the slope of the line in the plan.
        let (mut mixed, mut square) = (0.0, 0.0);
        for (node, force) in field.nodes.iter().zip(&field.force) {
            let [x, y, _] = askew.scene.mesh.points[*node as usize];
            mixed += force[2] * x * y;
            square += force[2] * y * y;
        }
        let slope = mixed / square;
        assert!((slope / -SKEW.tan() - 1.0).abs() < 0.02, "{slope}");
    }
}

/// Every node of its surface lies as far from the axis that was turned as from the one before.
#[test]
fn the_surface_of_a_roller_askew_is_a_cylinder() {
    let scene = scene(&parallel(
        "skew = [\"-60 mrad\", \"60 mrad\"]\nrollers = 2\nspacing = \"140 mm\"",
    ));
    for (body, angle) in [("roller_1", -0.06_f64), ("roller_2", 0.06)] {
        let centre = if angle < 0.0 { -70.0 } else { 70.0 };
        let surface = scene.mesh.surface(&format!("{body}_surface")).unwrap();
        let nodes = surface.nodes();
        assert!(nodes.len() > 100);
        for node in nodes {
            let [x, y, z] = scene.mesh.points[node as usize];
            let across = (x - centre) * angle.cos() + y * angle.sin();
            let radius = across.hypot(z);
            assert!((radius - 50.0).abs() < 1e-9, "{body}: {radius}");
        }
    }
}

/// A roller askew in its valley rests on one end of each slope, tan s tan θ L/2 higher; what lies above rises with it.
#[test]
fn a_roller_askew_rises_in_its_valley() {
    let mut scene = scene(&crossed("[\"2 mrad\", \"0 mrad\"]"));
    let closings = close_gaps(&mut scene, 0.0);
    let rise = |body: &str| {
        let closing = closings.iter().find(|closing| closing.body == body);
        closing.expect(body).shift[2]
    };
    let wanted = 0.002_f64.tan() * 4_f64.to_radians().tan() * 100.0;
    let base = rise("intermediate_plate");
    for body in ["upper_roller", "upper_plate"] {
        let found = rise(body) - base;
        assert!(
            (found / wanted - 1.0).abs() < 0.05,
            "{body}: {found} {wanted}"
        );
    }
}

#[test]
fn what_is_no_skew_is_refused() {
    for (skew, said) in [
        ("\"0.2 rad\"", "0.1 rad at most"),
        ("[\"1 mrad\"]", "one angle for each of 2 rollers"),
        ("\"2 mm\"", "an angle"),
    ] {
        let error = read(&crossed(skew)).expect_err(skew);
        let text = format!("{error:?} {error}");
        assert!(text.contains(said), "{text}");
    }
}
