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

/// Load per length of a slice whose middle comes down by `down`: K. L. Johnson, Contact Mechanics, (5.57), the half of
/// a roller that Hertz's pressure squeezes on a rigid flat, δ = w (1 − ν²)/πE (2 ln(4R/a) − 1).
fn slice(down: f64) -> f64 {
    let modulus = YOUNG / (1.0 - 0.3 * 0.3);
    let of = |w: f64| {
        let half_width = (4.0 * w * RADIUS / (std::f64::consts::PI * modulus)).sqrt();
        w / (std::f64::consts::PI * modulus) * (2.0 * (4.0 * RADIUS / half_width).ln() - 1.0)
    };
    let (mut low, mut high) = (0.0, 1e5);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        match of(middle) < down {
            true => low = middle,
            false => high = middle,
        }
    }
    if down > 0.0 { low } else { 0.0 }
}

/// The load of each slice, their middles at the distances `at` from the middle of the roller.
fn slices(angle: f64, at: &[f64]) -> Vec<f64> {
    let loads =
        |middle: f64| -> Vec<f64> { at.iter().map(|z| slice(middle + angle * z)).collect() };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        let total = loads(middle).iter().sum::<f64>() * LENGTH / at.len() as f64;
        match total < LOAD {
            true => low = middle,
            false => high = middle,
        }
    }
    loads(low)
}

/// Plates that are off parallel by `angle` are mirror images of each other, and the middle of the roller then stands
/// off each by half of it. So a quarter of the roller says all, its mid-plane a rigid plane that is turned.
fn solved(angle: f64) -> Vec<[f64; 2]> {
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
    let share = |k: usize| {
        if k == 0 || k == SLICES {
            0.5 * step
        } else {
            step
        }
    };
    let row = |(k, load): (usize, f64)| [k as f64 * step - 0.5 * LENGTH, load / share(k)];
    rows.into_iter().enumerate().map(row).collect()
}

/// Within 5 % of the mean line load, and at 0.1 mrad of the slice's own, along all of the roller but its two ends. There
/// slices in plane strain do not know that the ends are free, where a roller gives way more easily: by up to 10 %.
#[test]
fn the_line_load_of_a_tilted_roller_is_that_of_slices() {
    let count = 200;
    let thick = LENGTH / count as f64;
    let middles: Vec<f64> = (0..count)
        .map(|k| (k as f64 + 0.5) * thick - 0.5 * LENGTH)
        .collect();
    for angle in [0.1e-3, 0.2e-3, 0.3e-3] {
        let expected = slices(0.5 * angle, &middles);
        for (row, [z, load]) in solved(angle).into_iter().enumerate() {
            let at = ((z + 0.5 * LENGTH) / thick - 0.5).clamp(0.0, (count - 2) as f64 + 0.999);
            let (low, share) = (at as usize, at.fract());
            let slice = expected[low] * (1.0 - share) + expected[low + 1] * share;
            let off = (load - slice).abs();
            let says = format!("{angle} rad, {z} mm: {load} of {slice} N/mm");
            if row == 0 || row == SLICES {
                assert!(off < 0.1 * slice.max(LOAD / LENGTH), "{says}");
                continue;
            }
            assert!(off < 0.05 * LOAD / LENGTH, "{says}");
            assert!(angle > 0.1e-3 || off < 0.05 * slice, "{says}");
        }
    }
}
