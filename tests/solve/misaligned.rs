//! A solid roller between plates that are not parallel, against slices that know nothing of each other.

use brinell::analytic::hertz::LineContact;
use brinell::analytic::{Elastic, contact_compliance};
use brinell::model::mesh::{Face, Surface};
use brinell::model::scene::{PlaneMotion, PlaneTurn, RigidPlane, Support};
use brinell::prelude::{Axis, Contact, Cylinder, Load, SceneBuilder, Steel};
use brinell::solver::solve::{Silent, solve};

/// D = 120 mm, L = 400 mm, 900 kN; N, mm.
const RADIUS: f64 = 60.0;
const LENGTH: f64 = 400.0;
const LOAD: f64 = 900e3;
const YOUNG: f64 = 210e3;
const SLICES: usize = 16;

/// How far the middle of a slice comes down under the load per length `w`: K. L. Johnson, Contact Mechanics, (5.57), the half
/// of a roller that Hertz's pressure squeezes on a rigid flat, δ = w (1 − ν²)/πE (2 ln(4R/a) − 1).
fn down(w: f64) -> f64 {
    let modulus = YOUNG / (1.0 - 0.3 * 0.3);
    let half_width = (4.0 * w * RADIUS / (std::f64::consts::PI * modulus)).sqrt();
    w / (std::f64::consts::PI * modulus) * (2.0 * (4.0 * RADIUS / half_width).ln() - 1.0)
}

/// Load per length of a slice whose middle comes down by `by`.
fn slice(by: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1e5);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        match down(middle) < by {
            true => low = middle,
            false => high = middle,
        }
    }
    if by > 0.0 { low } else { 0.0 }
}

/// The load of each slice, their middles at the distances `at` from the middle of the roller and as wide as `wide`, each
/// `softer` times as compliant as in plane strain.
fn slices(angle: f64, at: &[f64], wide: &[f64], softer: &[f64]) -> Vec<f64> {
    let loads = |middle: f64| -> Vec<f64> {
        let each = at.iter().zip(softer);
        each.map(|(z, f)| slice((middle + angle * z) / f)).collect()
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        let total: f64 = loads(middle).iter().zip(wide).map(|(q, w)| q * w).sum();
        match total < LOAD {
            true => low = middle,
            false => high = middle,
        }
    }
    loads(low)
}

/// Plates that are off parallel by `angle` are mirror images of each other, and the middle of the roller then stands
/// off each by half of it. So a quarter of the roller says all, its mid-plane a rigid plane that is turned.
fn solved(angle: f64) -> Vec<f64> {
    let elastic = Elastic::new(YOUNG, 0.3).unwrap();
    let compliance = contact_compliance(elastic, Elastic::RIGID).unwrap();
    let a = LineContact::new(LOAD / LENGTH, RADIUS, compliance)
        .unwrap()
        .half_width;
    let roller = Cylinder::quarter("roller", RADIUS, LENGTH)
        .layers(SLICES)
        .growth(1.5);
    let plane = RigidPlane {
        motion: [
            PlaneMotion::Free,
            PlaneMotion::Driven(-0.5 * LOAD),
            PlaneMotion::Free,
        ],
        turn: [
            PlaneTurn::Held(0.5 * angle),
            PlaneTurn::Held(0.0),
            PlaneTurn::Held(0.0),
        ],
        ..RigidPlane::default()
    };
    let mut scene = SceneBuilder::new("misaligned")
        .body(roller.fine(a / 3.0, 1.8 * a), Steel::elastic(YOUNG, 0.3))
        .contact(Contact::on_plane(
            "roller_contact",
            [0.0; 3],
            [0.0, 1.0, 0.0],
        ))
        .load(Load::rigid("roller_top", plane))
        .mirror(Axis::X)
        .build()
        .unwrap();
    // One node keeps it from sliding along its axis.
    let top = scene.mesh.surface("roller_top").unwrap().nodes();
    let off = |n: &u32| (scene.mesh.points[*n as usize][2] - 0.5 * LENGTH).abs();
    let node = top
        .into_iter()
        .min_by(|a, b| off(a).total_cmp(&off(b)))
        .unwrap();
    let element = scene.mesh.hexes.iter().position(|hex| hex.contains(&node));
    scene.mesh.surfaces.push(Surface {
        name: "pin".into(),
        faces: vec![Face {
            nodes: [node; 4],
            element: element.unwrap() as u32,
        }],
    });
    scene.supports.push(Support {
        name: "pin".into(),
        surface: "pin".into(),
        components: [None, None, Some(0.0)],
        ..Support::default()
    });
    let state = solve(&mut scene, &mut Silent).unwrap().last;
    let field = &state.contacts[0];
    // Both halves of the strip, by the rows of nodes along the roller; those at the ends stand for half a slice.
    let step = LENGTH / SLICES as f64;
    let mut rows = vec![0.0; SLICES + 1];
    for (node, force) in field.nodes.iter().zip(&field.force) {
        let z = scene.mesh.points[*node as usize][2];
        rows[(z / step).round() as usize] += 2.0 * force[1].abs();
    }
    let total: f64 = rows.iter().sum();
    assert!((total - LOAD).abs() < 1e-6 * LOAD, "{total}");
    assert!(rows.iter().all(|row| *row > 0.0), "full contact: {rows:?}");
    let [_, wide] = rows_of();
    rows.iter()
        .zip(wide)
        .map(|(row, wide)| row / wide)
        .collect()
}

/// Where the force of each row of nodes acts under a load that is linear along it, and how wide a strip it stands for:
/// those at the ends half of one, a third of the step inwards.
fn rows_of() -> [Vec<f64>; 2] {
    let step = LENGTH / SLICES as f64;
    let mut at: Vec<f64> = (0..=SLICES)
        .map(|k| k as f64 * step - 0.5 * LENGTH)
        .collect();
    let mut wide = vec![step; SLICES + 1];
    for (end, inwards) in [(0, step / 3.0), (SLICES, -step / 3.0)] {
        at[end] += inwards;
        wide[end] = 0.5 * step;
    }
    [at, wide]
}

/// At its ends a roller is free to bulge along its axis, which plane strain forbids: there it is up to 1/(1 − ν²) as compliant,
/// as in plane stress, at the depth of a few half-widths and further in by less. How much is read from parallel plates, where all
/// slices come down alike; that it lies between the two, and is nothing in the middle, is what theory says of it.
fn softer_at_the_ends() -> Vec<f64> {
    let parallel = solved(0.0);
    let middle = down(parallel[SLICES / 2]);
    let softer: Vec<f64> = parallel.iter().map(|w| middle / down(*w)).collect();
    let most = 1.0 / (1.0 - 0.3 * 0.3);
    for (k, factor) in softer.iter().enumerate() {
        let off = (k as f64 / SLICES as f64 - 0.5).abs();
        assert!((0.97..most).contains(factor), "{k}: {factor}");
        assert!(off > 0.4 || (factor - 1.0).abs() < 0.02, "{k}: {factor}");
    }
    assert!(softer[0] > 1.02, "{softer:?}");
    softer
}

/// The line load along all of the roller, its ends too, is that of slices: within 2 % of the mean, and within 5 % of the
/// slice's own, but where it is a tenth of the mean or less: at 0.3 mrad the outermost row, which all but lifts off. There
/// slices show that they do not know of each other: a roller is one piece, and what presses beside a slice lowers it too.
#[test]
fn the_line_load_of_a_tilted_roller_is_that_of_slices() {
    let [at, wide] = rows_of();
    let softer = softer_at_the_ends();
    let mean = LOAD / LENGTH;
    for angle in [0.1e-3, 0.2e-3, 0.3e-3] {
        let expected = slices(0.5 * angle, &at, &wide, &softer);
        for ((slice, load), z) in expected.iter().zip(solved(angle)).zip(&at) {
            let off = (load - slice).abs();
            let says = format!("{angle} rad, {z:.1} mm: {load:.1} of {slice:.1} N/mm");
            assert!(off < 0.02 * mean, "{says}");
            let light = *slice < 0.1 * mean;
            assert!(light || off < 0.05 * slice, "{says}");
            assert!(!light || angle > 0.2e-3 && *z < -0.47 * LENGTH, "{says}");
        }
    }
}
