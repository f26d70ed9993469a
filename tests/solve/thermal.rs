//! Thermal strain: free, held, unlike in two bodies, and beyond yield.

use super::kit::{held, scene};
use brinell::model::material::Steel;
use brinell::model::mesh::block::{Block, uniform};
use brinell::model::mesh::{Body, Face, Mesh, Surface};
use brinell::model::scene::{
    Controls, ElementKind, PlaneMotion, RigidPlane, Scene, Step, Temperature,
};
use brinell::model::state::State;
use brinell::solver::solve::{Observer, Silent, solve};
use std::error::Error;

const YOUNG: f64 = 210e3;
const EXPANSION: f64 = 12e-6;

fn heated(mesh: Mesh, steel: Steel, element: ElementKind) -> Scene {
    Scene {
        controls: Controls {
            element,
            residual: 1e-12,
            ..Controls::default()
        },
        ..scene(mesh, steel)
    }
}

fn temperature(body: &str, value: f64, gradient: [f64; 3]) -> Temperature {
    Temperature {
        name: format!("{body} is warm"),
        body: body.into(),
        expansion: EXPANSION,
        value,
        gradient,
    }
}

/// Holds one node along z.
fn pin(scene: &mut Scene, at: [f64; 3]) {
    let near = |p: &[f64; 3]| (0..3).all(|i| (p[i] - at[i]).abs() < 1e-9);
    let node = scene.mesh.points.iter().position(near).unwrap() as u32;
    let element = scene.mesh.hexes.iter().position(|h| h.contains(&node));
    scene.mesh.surfaces.push(Surface {
        name: "pin".into(),
        faces: vec![Face {
            nodes: [node; 4],
            element: element.unwrap() as u32,
        }],
    });
    scene.supports.push(held("pin", 2));
}

fn last(scene: &mut Scene) -> State {
    solve(scene, &mut Silent).unwrap().last
}

/// A quarter of a plate that is warmer above than below, free: u = α g (x z, y z, (z² − x² − y²) / 2), no stress
/// (Boley and Weiner, Theory of Thermal Stresses: a linear temperature strains without stress). Elements that bend
/// exactly say so exactly.
#[test]
fn a_free_plate_under_a_linear_gradient_bends_without_stress() {
    let (slope, thick) = (5.0, 4.0);
    let mesh = Block::new(
        "plate",
        uniform(0.0, 30.0, 3),
        uniform(0.0, 20.0, 2),
        uniform(0.0, thick, 2),
    );
    let steel = Steel {
        yield_stress: 355.0,
        ..Steel::elastic(YOUNG, 0.3)
    };
    let mut plate = heated(mesh.build().unwrap(), steel, ElementKind::Enhanced);
    plate.mirrors = vec![0, 1];
    plate.supports = vec![held("x_min", 0), held("y_min", 1)];
    pin(&mut plate, [0.0, 0.0, 0.0]);
    plate.temperatures = vec![temperature("plate", 0.0, [0.0, 0.0, slope])];
    let state = last(&mut plate);
    let bend = EXPANSION * slope;
    let foot = 0.5 * bend * (0.5 * thick).powi(2);
    let largest = 0.5 * bend * (30.0f64.powi(2) + 20.0f64.powi(2));
    for (at, u) in plate.mesh.points.iter().zip(&state.displacement) {
        let [x, y, z] = [at[0], at[1], at[2] - 0.5 * thick];
        let up = 0.5 * bend * (z * z - x * x - y * y) - foot;
        let exact = [bend * x * z, bend * y * z, up];
        for axis in 0..3 {
            let off = (u[axis] - exact[axis]).abs();
            assert!(off < 1e-9 * largest, "{u:?} {exact:?}");
        }
    }
    // Beside what it would be if nothing could bend.
    let scale = YOUNG * bend * 0.5 * thick;
    for stress in state.stress.iter().flatten().flatten() {
        assert!(stress.abs() < 1e-9 * scale, "{stress} of {scale}");
    }
    assert!(state.energy.unwrap().imbalance().unwrap() < 1e-9);
}

fn bar(steel: Steel, element: ElementKind, warmer: f64) -> Scene {
    let list = |end: f64, n| uniform(0.0, end, n);
    let mesh = Block::new("bar", list(2.0, 2), list(3.0, 2), list(10.0, 3));
    let mut bar = heated(mesh.build().unwrap(), steel, element);
    bar.supports = vec![held("x_min", 0), held("y_min", 1), held("z_min", 2)];
    bar.rigid_planes = vec![RigidPlane {
        name: "stop".into(),
        surface: "z_max".into(),
        motion: [PlaneMotion::Free, PlaneMotion::Free, PlaneMotion::Held(0.0)],
        ..RigidPlane::default()
    }];
    bar.temperatures = vec![temperature("bar", warmer, [0.0; 3])];
    bar
}

/// σ = −E α ΔT between two stops, and the stops bear it.
#[test]
fn a_bar_between_stops_is_pressed_by_its_own_warmth() {
    let stress = -YOUNG * EXPANSION * 50.0;
    let near = |found: f64, exact: f64| {
        assert!(
            (found - exact).abs() < 1e-9 * stress.abs() * 6.0,
            "{found} {exact}"
        );
    };
    for element in [ElementKind::Bbar, ElementKind::Full, ElementKind::Enhanced] {
        let state = last(&mut bar(Steel::elastic(YOUNG, 0.3), element, 50.0));
        for s in state.stress.iter().flatten() {
            near(s[2], stress);
            near(s[0], 0.0);
        }
        near(state.planes[0].force[2], 6.0 * stress);
        assert!(state.energy.unwrap().imbalance().unwrap() < 1e-9);
    }
}

/// Heated to twice the yield strain and cooled again: the bar has become shorter by what flowed, and is pulled.
#[test]
fn a_bar_that_yields_when_warm_is_pulled_when_cold() {
    let (yields, hardening) = (200.0, 2000.0);
    let warmer = 2.0 * yields / (YOUNG * EXPANSION);
    let steel = Steel {
        yield_stress: yields,
        hardening_modulus: hardening,
        ..Steel::elastic(YOUNG, 0.3)
    };
    let tangent = YOUNG * hardening / (YOUNG + hardening);
    let hot = yields + tangent * yields / YOUNG;
    for element in [ElementKind::Bbar, ElementKind::Enhanced] {
        let mut bar = bar(steel, element, warmer);
        bar.controls.residual = 1e-10;
        bar.steps.push(Step::to("cool", 0.0));
        let solution = solve(&mut bar, &mut Silent).unwrap();
        let [warm, cold] = [0, 1].map(|i| &solution.states[i]);
        for s in warm.stress.iter().flatten() {
            assert!((s[2] + hot).abs() < 1e-7 * hot, "{} {hot}", s[2]);
        }
        for s in cold.stress.iter().flatten() {
            let exact = 2.0 * yields - hot;
            assert!((s[2] - exact).abs() < 1e-7 * hot, "{} {exact}", s[2]);
        }
        assert!(cold.energy.unwrap().imbalance().unwrap() < 1e-6);
    }
}

/// Counts increments.
struct Count(usize);

impl Observer for Count {
    fn increment(&mut self, _: &State) -> Result<(), Box<dyn Error + Send + Sync>> {
        self.0 += 1;
        Ok(())
    }
}

/// By thirds to a thousandth, and then to the end; supports that stay as they are do not count.
#[test]
fn a_load_that_goes_to_nothing_is_taken_off_in_few_increments() {
    let increments = |left: f64| {
        let mut bar = bar(Steel::elastic(YOUNG, 0.3), ElementKind::Bbar, 50.0);
        let mut cool = Step::to("cool", 1.0);
        cool.factors = [("bar is warm".into(), left)].into();
        bar.steps.push(cool);
        let mut count = Count(0);
        solve(&mut bar, &mut count).unwrap();
        count.0
    };
    // One more is that of the step before.
    assert_eq!(increments(0.0), 1 + 8);
    assert_eq!(increments(0.5), 1 + 1);
    assert!(increments(1e-3) > 1 + 4);
}

/// A strip of two layers of which one is warmer (S. Timoshenko, Analysis of bi-metal thermostats, J. Opt. Soc. Am. 11
/// (1925) 233): κ = 6 ε (1 + m)² / (h (3 (1 + m)² + (1 + m n)(m² + 1/(m n)))), m the ratio of thicknesses, n that of
/// moduli. Beam theory without lateral strain; the layers share their nodes.
#[test]
fn a_strip_of_two_layers_curls_as_timoshenko_says() {
    let solved = |layers: usize| {
        let (thin, thick, long) = (1.0, 2.0, 60.0);
        let mut heights = uniform(0.0, thick, 2 * layers);
        heights.extend(&uniform(thick, thick + thin, layers)[1..]);
        let along = uniform(0.0, long, 30);
        let mesh = Block::new("strip", along, uniform(0.0, 1.0, 1), heights);
        let mut mesh = mesh.build().unwrap();
        // Layer upon layer: the lower elements come first.
        let count = mesh.hexes.len();
        let below = count * 2 / 3;
        let above = |e: usize| mesh.corners(e).iter().all(|p| p[2] > thick - 1e-9);
        assert!((0..count).all(|e| above(e) == (e >= below)));
        mesh.bodies = [("lower", 0..below), ("upper", below..count)]
            .map(|(name, elements)| Body {
                name: name.into(),
                elements,
            })
            .into();
        let mut strip = heated(mesh, Steel::elastic(YOUNG, 0.0), ElementKind::Enhanced);
        strip.materials[1] = Steel::elastic(0.5 * YOUNG, 0.0);
        strip.supports = vec![held("x_min", 0), held("y_min", 1)];
        strip.mirrors = vec![0];
        pin(&mut strip, [0.0, 0.0, 0.0]);
        strip.temperatures = vec![temperature("upper", 40.0, [0.0; 3])];
        let state = last(&mut strip);
        // Half-way along, far from the free end: u_z = −κ x²/2 on a line.
        let down = |x: f64| {
            let near = |p: &[f64; 3]| (p[0] - x).abs() < 1e-9 && p[1] == 0.0 && p[2] == 0.0;
            let node = strip.mesh.points.iter().position(near).unwrap();
            state.displacement[node][2]
        };
        let curve = (2.0 * down(20.0) - down(10.0) - down(30.0)) / 100.0;
        let (m, n, strain) = (thin / thick, 0.5, EXPANSION * 40.0);
        let below = 3.0 * (1.0 + m).powi(2) + (1.0 + m * n) * (m * m + 1.0 / (m * n));
        curve / (6.0 * strain * (1.0 + m).powi(2) / ((thin + thick) * below)) - 1.0
    };
    // Layers that bend exactly are right with one element each; the free end is far away.
    for layers in [1, 2] {
        let off = solved(layers);
        assert!(off.abs() < 1e-5, "{off} with {layers} elements");
    }
}
