//! The steel of the reference study in a tension test.

use brinell::proof::closed_forms::steel::{self, BilinearSteel, StrainMeasure};
use proptest::prelude::*;

use crate::close;

fn study(measure: StrainMeasure) -> BilinearSteel {
    BilinearSteel::from_second_point(29500.0, 100.0, 138.0, 0.157, measure).unwrap()
}

#[test]
fn moduli_from_the_second_point() {
    let total = study(StrainMeasure::Total);
    close("ε_y", total.yield_strain(), 0.003389830508474576, 1e-12);
    close("E_t", total.tangent_modulus(), 247.37945492662473, 1e-12);
    close("H", total.hardening_modulus(), 249.47145877378435, 1e-12);
    close(
        "ε_p at 138",
        total.residual_strain(0.157).unwrap(),
        0.1523220338983051,
        1e-12,
    );
    let plastic = study(StrainMeasure::Plastic);
    close("H", plastic.hardening_modulus(), 242.038, 1e-5);
    close("E_t", plastic.tangent_modulus(), 240.069, 1e-5);
}

/// Total strain and uniaxial stress; closed form.
const TENSION: [(f64, f64); 8] = [
    (0.001, 29.5),
    (0.00338983, 99.999985),
    (0.005, 100.3983228512),
    (0.01, 101.6352201258),
    (0.02, 104.1090146751),
    (0.05, 111.5303983229),
    (0.1, 123.8993710692),
    (0.157, 138.0),
];

#[test]
fn tension_test() {
    let steel = study(StrainMeasure::Total);
    for (strain, stress) in TENSION {
        close("stress", steel.stress(strain).unwrap(), stress, 1e-12);
        close(
            "compression",
            steel.stress(-strain).unwrap(),
            -stress,
            1e-12,
        );
    }
    close(
        "residual",
        steel.residual_strain(0.05).unwrap(),
        0.04621931,
        1e-7,
    );
    assert_eq!(steel.residual_strain(0.003).unwrap(), 0.0);
}

#[test]
fn true_values() {
    let [stress, strain] = steel::true_from_engineering(138.0, 0.157).unwrap();
    close("true stress", stress, 159.7, 1e-3);
    close("logarithmic strain", strain, 0.1458, 1e-3);
}

#[test]
fn impossible_points_are_refused() {
    let second = |stress, strain, measure| {
        BilinearSteel::from_second_point(29500.0, 100.0, stress, strain, measure)
    };
    assert!(second(90.0, 0.1, StrainMeasure::Total).is_err());
    assert!(second(138.0, 0.004, StrainMeasure::Total).is_err());
    assert!(second(138.0, 0.0, StrainMeasure::Plastic).is_err());
    assert!(BilinearSteel::new(29500.0, 100.0, 29500.0).is_err());
    assert!(study(StrainMeasure::Total).stress(f64::INFINITY).is_err());
}

proptest! {
    #[test]
    fn total_and_plastic_strain_agree(stress in 101.0..200.0f64, plastic in 0.01..0.5f64) {
        let second = |strain, measure| {
            BilinearSteel::from_second_point(29500.0, 100.0, stress, strain, measure).unwrap()
        };
        let (a, b) = (
            second(plastic, StrainMeasure::Plastic),
            second(plastic + stress / 29500.0, StrainMeasure::Total),
        );
        prop_assert!((a.hardening_modulus() / b.hardening_modulus() - 1.0).abs() < 1e-11);
        prop_assert!((b.stress(plastic + stress / 29500.0).unwrap() / stress - 1.0).abs() < 1e-12);
    }
}
