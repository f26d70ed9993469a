//! Orders of convergence: problem H on nested meshes, and a smooth solid problem.

use brinell::answer::results::hex::GaussRule;
use brinell::model::mesh::block::{Block, cylindrical, uniform};
use brinell::model::mesh::hexahedron::gauss_volumes;
use brinell::model::scene::{ElementKind, Scene};
use brinell::product::converge::rates::fitted;
use brinell::proof::verify::kit;
use brinell::proof::verify::problem_h::{PRESSURE, ProblemHReading, Sizes, read, scene};

use brinell::model::material::Steel;
use std::f64::consts::FRAC_PI_2;

/// Levels of the nested meshes: 2 to 32 elements across the half-width; with incompatible modes one
/// less, for the time it takes.
const LEVELS: u32 = 5;
/// Orders are fitted from here on; two elements across the half-width do not resolve the contact.
const ASYMPTOTIC: usize = 1;

/// Potential energy of the half model per thickness, kip: levels 3, 4 and 5 (16, 32 and 64 elements
/// across the half-width, 1.4 million unknowns) extrapolated with their own order of 1.97. B-bar
/// gives −3.3086627e-3 and incompatible modes −3.3086625e-3.
const ENERGY: f64 = -3.308_662_7e-3;
/// Half-width, in: levels 3, 4 and 5 extrapolated, both elements; 0.01 % below Hertz's 0.030942,
/// as the independent solver of the finite bodies says too.
const HALF_WIDTH: f64 = 0.030_939;
/// Largest Mises stress, ksi, block and cylinder: those of an independent solver with the gap taken along the
/// normal of the block, which is flat, as here.
const MISES: [f64; 2] = [94.980, 92.690];

fn series(element: ElementKind, levels: u32) -> Vec<(f64, ProblemHReading)> {
    let solved = |level: u32| {
        let sizes = Sizes::nested(level);
        let mut scene = scene(&sizes).expect("meshes");
        scene.controls.element = element;
        let run = kit::run(scene).expect("converges");
        (
            sizes.size(),
            read(&run.scene, run.state()).expect("has contact"),
        )
    };
    (0..levels).map(solved).collect()
}

/// Prints the errors and gives their order over the asymptotic levels.
fn order(
    what: &str,
    series: &[(f64, ProblemHReading)],
    error: impl Fn(&ProblemHReading) -> f64,
) -> f64 {
    let points: Vec<(f64, f64)> = series.iter().map(|(h, r)| (*h, error(r))).collect();
    let order = fitted(&points[ASYMPTOTIC..]).expect("errors");
    let list: Vec<String> = points.iter().map(|p| format!("{:+.3e}", p.1)).collect();
    println!("{what}: {} order {order:.2}", list.join(" "));
    order
}

fn problem_h(element: ElementKind, levels: u32) {
    let series = series(element, levels);
    let at_least = |what: &str, least: f64, error: &dyn Fn(&ProblemHReading) -> f64| {
        let order = order(what, &series, error);
        assert!(order >= least, "{element:?} {what}: order {order}");
    };
    at_least("energy", 1.9, &|r| r.energy / ENERGY - 1.0);
    at_least("half-width", 1.5, &|r| r.half_width / HALF_WIDTH - 1.0);
    at_least("block, nodal", 1.5, &|r| r.block.nodal / MISES[0] - 1.0);
    at_least("cylinder, nodal", 1.5, &|r| {
        r.cylinder.nodal / MISES[1] - 1.0
    });
    let profile = order("pressure, L2", &series, |r| r.profile);
    assert!(
        (0.9..1.2).contains(&profile),
        "{element:?}: order {profile}"
    );
    // The largest of a few nodal values has no clean order; only its error is known.
    order("p0", &series, |r| r.pressure / PRESSURE - 1.0);
    for (size, reading) in &series[ASYMPTOTIC..] {
        let error = reading.pressure / PRESSURE - 1.0;
        assert!(error.abs() < 0.002, "{element:?} at {size}: p0 {error:e}");
    }
}

#[test]
fn problem_h_converges_with_bbar() {
    problem_h(ElementKind::Bbar, LEVELS);
}

#[test]
fn problem_h_converges_with_incompatible_modes() {
    problem_h(ElementKind::Enhanced, LEVELS - 1);
}

/// Lamé's tube, also beside its wall, where the middles of chords lie: a = 1, b = 2, p = 1 inside, E = 1000, ν = 0.3, plane strain (Timoshenko and Goodier,
/// *Theory of Elasticity*, section 28).
mod tube {
    pub const INNER: f64 = 1.0;
    pub const OUTER: f64 = 2.0;
    pub const YOUNG: f64 = 1000.0;
    pub const POISSON: f64 = 0.3;
    const A: f64 = INNER * INNER / (OUTER * OUTER - INNER * INNER);
    const B: f64 = A * OUTER * OUTER;

    pub fn displacement([x, y, _]: [f64; 3]) -> [f64; 3] {
        let r = x.hypot(y);
        let u = (1.0 + POISSON) / YOUNG * ((1.0 - 2.0 * POISSON) * A * r + B / r);
        [u * x / r, u * y / r, 0.0]
    }

    /// xx yy zz xy yz zx.
    pub fn stress([x, y, _]: [f64; 3]) -> [f64; 6] {
        let r = x.hypot(y);
        let (c, s) = (x / r, y / r);
        let [radial, hoop] = [A - B / (r * r), A + B / (r * r)];
        [
            radial * c * c + hoop * s * s,
            radial * s * s + hoop * c * c,
            2.0 * POISSON * A,
            (radial - hoop) * c * s,
            0.0,
            0.0,
        ]
    }
}

/// Relative L2 errors of the displacement, of the stress at integration points, and of the mean
/// stress at element centres, on `cells` elements along the radius.
fn tube_errors(element: ElementKind, cells: usize) -> [f64; 3] {
    let mesh = Block::new(
        "tube",
        uniform(tube::INNER, tube::OUTER, cells),
        uniform(0.0, FRAC_PI_2, 2 * cells),
        vec![0.0, 0.25],
    )
    .mapped(cylindrical)
    .build()
    .expect("meshes");
    let steel = Steel::elastic(tube::YOUNG, tube::POISSON);
    let mut scene = Scene::bare("tube", mesh, steel);
    scene.controls.element = element;
    scene.controls.residual = 1e-12;
    scene.supports = vec![
        kit::held("y_min", 1),
        kit::held("y_max", 0),
        kit::held("z_min", 2),
        kit::held("z_max", 2),
    ];
    scene.tractions = vec![kit::pressure("x_min", 1.0)];
    let run = kit::run(scene).expect("converges");
    let (mesh, state, rule) = (&run.scene.mesh, run.state(), GaussRule::new());
    let (mut miss, mut norm) = ([0.0; 3], [0.0; 3]);
    for (e, hex) in mesh.hexes.iter().enumerate() {
        let corners = mesh.corners(e);
        let nodal = hex.map(|n| state.displacement[n as usize]);
        let stress = &state.stress[e];
        let volumes = gauss_volumes(&corners);
        let mut add = |kind: usize, weight: f64, found: &[f64], exact: &[f64]| {
            for (f, x) in found.iter().zip(exact) {
                miss[kind] += weight * (f - x).powi(2);
                norm[kind] += weight * x * x;
            }
        };
        for (k, volume) in volumes.iter().enumerate() {
            let at = rule.position(k, &corners);
            let u = brinell::answer::results::hex::interpolate(&rule.shape[k], &nodal);
            add(0, *volume, &u, &tube::displacement(at));
            add(1, *volume, &stress[k], &tube::stress(at));
        }
        let whole: f64 = volumes.iter().sum();
        let mean = brinell::answer::results::tensor::mean(stress);
        let at = brinell::answer::results::hex::centre(&corners);
        add(2, whole, &mean, &tube::stress(at));
    }
    [0, 1, 2].map(|k| f64::sqrt(miss[k] / norm[k]))
}

#[test]
fn a_smooth_problem_converges_with_the_orders_of_theory() {
    for element in [ElementKind::Bbar, ElementKind::Enhanced] {
        let meshes = [4, 8, 16, 32];
        let errors = meshes.map(|cells| (1.0 / cells as f64, tube_errors(element, cells)));
        let order = |kind: usize| {
            let points = errors.map(|(h, e)| (h, e[kind]));
            println!("{element:?} {kind}: {points:?}");
            fitted(&points).expect("errors")
        };
        let [displacement, stress, centre] = [0, 1, 2].map(order);
        println!("{element:?}: {displacement:.3} {stress:.3} {centre:.3}");
        assert!(displacement > 1.9, "{element:?}: {displacement}");
        assert!(stress > 0.95, "{element:?}: {stress}");
        assert!(centre > 1.9, "{element:?}: {centre}");
    }
}
