//! One distorted element that flows: its tangent is the derivative of its force.

use crate::kit::{KINDS, report_steel};
use brinell::model::material::Steel;
use brinell::model::material::j2::PlasticPoint;
use brinell::model::scene::ElementKind;
use brinell::solver::fem::bbar::ElementVector;
use brinell::solver::fem::element::Element;
use brinell::solver::fem::hex8::{CORNERS, Geometry};

fn corners() -> [[f64; 3]; 8] {
    let mut c = CORNERS;
    for (a, x) in c.iter_mut().enumerate() {
        let t = a as f64;
        x[0] += 0.2 * (t * 1.3).sin();
        x[1] += 0.2 * (t * 2.1).cos();
        x[2] += 0.2 * (t * 0.7).sin();
    }
    c
}

fn displacements(scale: f64) -> ElementVector {
    std::array::from_fn(|a| std::array::from_fn(|i| scale * ((a * 3 + i) as f64 * 0.77).sin()))
}

/// Internal force as the solver composes it.
fn force(
    element: &Element,
    steel: &Steel,
    u: &ElementVector,
    old: &[PlasticPoint; 8],
) -> [f64; 24] {
    let elastic = steel.moduli();
    let answer = element.answer(steel, &elastic, u, old).expect("a balance");
    let elastic_force = element.elastic_force(&elastic, u);
    let relief = element.relief(&elastic, &answer.points);
    std::array::from_fn(|i| elastic_force[i / 3][i % 3] - relief[i / 3][i % 3])
}

/// Deviation of the tangent from the force's central difference, over the largest stiffness.
fn deviation(kind: ElementKind, steel: &Steel, scale: f64) -> f64 {
    let element = Element::new(kind, &corners());
    let elastic = steel.moduli();
    let before = displacements(0.7 * scale);
    let start = element.answer(steel, &elastic, &before, &[PlasticPoint::default(); 8]);
    let old = start.expect("a balance").points;
    let mut u = displacements(scale);
    u[3][1] += 0.3 * scale;
    let answer = element
        .answer(steel, &elastic, &u, &old)
        .expect("a balance");
    assert!(answer.flows.iter().any(Option::is_some), "nothing flows");
    let stiffness = element.stiffness(&elastic);
    let change = element.tangent_change(&elastic, &answer.flows);
    let largest = stiffness
        .iter()
        .flatten()
        .fold(0.0f64, |m, k| m.max(k.abs()));
    let mut worst = 0.0f64;
    let step = 1e-5 * scale;
    for j in 0..24 {
        let (mut up, mut down) = (u, u);
        up[j / 3][j % 3] += step;
        down[j / 3][j % 3] -= step;
        let (up, down) = (
            force(&element, steel, &up, &old),
            force(&element, steel, &down, &old),
        );
        for i in 0..24 {
            let numeric = (up[i] - down[i]) / (2.0 * step);
            worst = worst.max((numeric - stiffness[i][j] - change[i][j]).abs());
        }
    }
    worst / largest
}

#[test]
fn tangent_is_the_derivative_of_the_internal_force() {
    let perfect = Steel {
        hardening_modulus: 0.0,
        ..report_steel()
    };
    for kind in KINDS {
        for steel in [report_steel(), perfect] {
            for scale in [0.01, 0.03, 0.3] {
                let deviation = deviation(kind, &steel, scale);
                assert!(deviation < 1e-8, "{kind:?} {scale}: {deviation:.1e}");
            }
        }
    }
}

#[test]
fn elastic_force_is_that_of_the_stress_free_of_history() {
    let steel = Steel::elastic(29500.0, 0.3);
    let u = displacements(1e-3);
    for kind in KINDS {
        let element = Element::new(kind, &corners());
        let force = force(&element, &steel, &u, &[PlasticPoint::default(); 8]);
        // Twice the energy, by the forces and by the stresses.
        let work: f64 = force.iter().zip(u.as_flattened()).map(|(f, u)| f * u).sum();
        let elastic = steel.moduli();
        let stress = element.stress(&elastic, &u, &[PlasticPoint::default(); 8]);
        let volumes = Geometry::new(&corners()).volumes;
        let energy: f64 = stress
            .iter()
            .zip(volumes)
            .map(|(s, v)| v * density(s))
            .sum();
        assert!((work - energy).abs() < 1e-12 * energy, "{work} {energy}");
    }
}

/// σ : C⁻¹ σ with E = 29500, ν = 0.3.
fn density(s: &[f64; 6]) -> f64 {
    let sum = s[0] + s[1] + s[2];
    let square: f64 = s[..3].iter().map(|s| s * s).sum();
    let shear: f64 = s[3..].iter().map(|s| s * s).sum();
    ((1.3 * (square + 2.0 * shear)) - 0.3 * sum * sum) / 29500.0
}

#[test]
fn rigid_motion_costs_nothing() {
    let elastic = report_steel().moduli();
    let u = corners().map(|x| [1.0 - 0.2 * x[1], 0.2 * x[0] + 0.1 * x[2], -0.1 * x[1]]);
    for kind in KINDS {
        let force = Element::new(kind, &corners()).elastic_force(&elastic, &u);
        let bound = 1e-10 * elastic.shear;
        assert!(force.as_flattened().iter().all(|f| f.abs() < bound));
    }
}

/// However far the displacements, with and without hardening, inner unknowns find their balance.
#[test]
fn every_displacement_has_an_answer() {
    let mut seed = 1u32;
    let mut random = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(seed) / f64::from(u32::MAX) - 0.5
    };
    let element = Element::new(ElementKind::Enhanced, &corners());
    for hardening in [0.0, 1.0, 249.471] {
        let steel = Steel {
            hardening_modulus: hardening,
            ..report_steel()
        };
        let elastic = steel.moduli();
        for scale in [0.003, 0.03, 0.3, 3.0] {
            for _ in 0..200 {
                let u = std::array::from_fn(|_| std::array::from_fn(|_| scale * random()));
                let answer = element.answer(&steel, &elastic, &u, &[PlasticPoint::default(); 8]);
                assert!(answer.is_some(), "H = {hardening}, {scale}: no balance");
            }
        }
    }
}
