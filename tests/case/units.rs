//! The same case in other units is the same scene up to scale; quantities survive a round trip.

use crate::kit::{BEARING, SCENE, blocks, centred, good, with};
use brinell::case::parse;
use brinell::ground::units::{Dimension, Quantity, UnitSystem};
use brinell::model::scene::{PlaneMotion, Scene, TractionValue};
use proptest::prelude::*;

const DIMENSIONS: [Dimension; 9] = [
    Dimension::RATIO,
    Dimension::LENGTH,
    Dimension::AREA,
    Dimension::FORCE,
    Dimension::MOMENT,
    Dimension::STRESS,
    Dimension::LINE_LOAD,
    Dimension::CONTACT_STIFFNESS,
    Dimension::ANGLE,
];

#[track_caller]
fn same(a: f64, b: f64) {
    assert!(a == b || (a / b - 1.0).abs() < 5e-15, "{a} is not {b}");
}

/// Every number of a scene with its dimension.
fn numbers(scene: &Scene) -> Vec<(f64, Dimension)> {
    let mut all = Vec::new();
    for steel in &scene.materials {
        let stresses = [
            steel.youngs_modulus,
            steel.yield_stress,
            steel.hardening_modulus,
        ];
        all.extend(stresses.map(|stress| (stress, Dimension::STRESS)));
        all.push((steel.poissons_ratio, Dimension::RATIO));
    }
    for pair in &scene.contacts {
        all.extend([pair.friction, pair.penalty_factor].map(|n| (n, Dimension::RATIO)));
    }
    for support in &scene.supports {
        all.extend(
            support
                .components
                .iter()
                .flatten()
                .map(|d| (*d, Dimension::LENGTH)),
        );
    }
    for motion in scene.rigid_planes.iter().flat_map(|plane| plane.motion) {
        match motion {
            PlaneMotion::Held(d) => all.push((d, Dimension::LENGTH)),
            PlaneMotion::Driven(f) => all.push((f, Dimension::FORCE)),
            PlaneMotion::Free => {}
        }
    }
    for traction in &scene.tractions {
        match traction.value {
            TractionValue::Pressure(p) => all.push((p, Dimension::STRESS)),
            TractionValue::Vector(v) => all.extend(v.map(|c| (c, Dimension::STRESS))),
        }
    }
    all.extend(
        scene
            .steps
            .iter()
            .map(|step| (step.factor, Dimension::RATIO)),
    );
    all.extend(
        scene
            .mesh
            .points
            .iter()
            .flatten()
            .map(|c| (*c, Dimension::LENGTH)),
    );
    all
}

#[track_caller]
fn scaled(from: &Scene, to: &Scene, units: UnitSystem, other: UnitSystem) {
    let (from, to) = (numbers(from), numbers(to));
    assert_eq!(from.len(), to.len());
    for ((a, dimension), (b, _)) in from.into_iter().zip(to) {
        same(a * units.factor_to(other, dimension), b);
    }
}

#[test]
fn a_bearing_in_other_units_is_the_same_scene_to_scale() {
    let inches = good(BEARING).scene(centred()).unwrap();
    for system in UnitSystem::ALL {
        let text = with(
            BEARING,
            "units = \"in-kip-ksi\"",
            &format!("units = \"{system}\""),
        );
        let scene = good(&text).scene(centred()).unwrap();
        scaled(&inches, &scene, UnitSystem::InKipKsi, system);
    }
}

/// Bare numbers are in the units that the file declares.
#[test]
fn a_bearing_in_bare_numbers_is_the_same_scene_to_scale() {
    let texts = [
        ("\"65 kip\"", 65.0, Dimension::FORCE),
        ("\"3 in\"", 3.0, Dimension::LENGTH),
        ("\"0.75 in\"", 0.75, Dimension::LENGTH),
        ("\"8 in\"", 8.0, Dimension::LENGTH),
        ("\"0 in\"", 0.0, Dimension::LENGTH),
        ("\"4 deg\"", 4.0, Dimension::ANGLE),
        ("\"1 in\"", 1.0, Dimension::LENGTH),
        ("\"29500 ksi\"", 29500.0, Dimension::STRESS),
        ("\"100 ksi\"", 100.0, Dimension::STRESS),
        ("\"138 ksi\"", 138.0, Dimension::STRESS),
    ];
    let inches = good(BEARING).scene(centred()).unwrap();
    for system in UnitSystem::ALL {
        let mut text = with(BEARING, "\"in-kip-ksi\"", &format!("\"{system}\""));
        for (old, value, dimension) in texts {
            let value = value * UnitSystem::InKipKsi.factor_to(system, dimension);
            text = with(&text, old, &value.to_string());
        }
        let scene = good(&text).scene(centred()).unwrap();
        scaled(&inches, &scene, UnitSystem::InKipKsi, system);
    }
}

#[test]
fn a_general_scene_in_other_units_is_the_same_to_scale() {
    let text = format!(
        "{SCENE}[[rigid_plane]]\nname = \"lid\"\nsurface = \"top\"\nfixed = \"x\"\n\
         displacement = {{ y = \"1 mil\" }}\nforce = {{ z = \"-2 kip\" }}\n\
         [[traction]]\nname = \"shear\"\nsurface = \"side\"\nvalue = [\"3 psi\", \"2 kPa\", \"0 Pa\"]\n"
    );
    let text = with(&text, "file =", "unit = \"mm\"\nfile =");
    let here = good(&text).scene(blocks()).unwrap();
    for system in UnitSystem::ALL {
        let other = with(
            &text,
            "units = \"mm-N-MPa\"",
            &format!("units = \"{system}\""),
        );
        let scene = good(&other).scene(blocks()).unwrap();
        scaled(&here, &scene, UnitSystem::MmNMPa, system);
    }
}

fn any_system() -> impl Strategy<Value = UnitSystem> {
    proptest::sample::select(UnitSystem::ALL.to_vec())
}

fn any_value() -> impl Strategy<Value = f64> {
    (-12..12i32, -1.0..1.0f64).prop_map(|(power, digits)| digits * 10f64.powi(power))
}

proptest! {
    #[test]
    fn what_is_written_reads_back(
        value in any_value(),
        system in any_system(),
        dimension in proptest::sample::select(DIMENSIONS.to_vec()),
    ) {
        let text = system.write(value, dimension);
        let back = Quantity::parse(&text).unwrap().value_in(system, dimension).unwrap();
        match dimension {
            Dimension::ANGLE => same(back, value),
            _ => prop_assert_eq!(back, value, "{}", text),
        }
    }

    #[test]
    fn there_and_back_again(
        value in any_value(),
        one in any_system(),
        other in any_system(),
        dimension in proptest::sample::select(DIMENSIONS.to_vec()),
    ) {
        let text = one.write(value, dimension);
        let there = Quantity::parse(&text).unwrap().value_in(other, dimension).unwrap();
        same(there, value * one.factor_to(other, dimension));
        same(there * other.factor_to(one, dimension), value);
    }

    #[test]
    fn six_digits_are_shown(value in any_value(), system in any_system()) {
        let text = system.show(value, Dimension::STRESS);
        let back = Quantity::parse(&text).unwrap().value_in(system, Dimension::STRESS).unwrap();
        prop_assert!((back - value).abs() <= 5.1e-6 * value.abs(), "{}", text);
    }

    #[test]
    fn no_quantity_makes_it_panic(text in "\\PC*") {
        let _ = Quantity::parse(&text);
    }

    #[test]
    fn no_unit_expression_makes_it_panic(text in "[0-9.eE+−-]{0,4} ?[a-zµ%°/*^·²³0-9-]{0,8}") {
        if let Ok(quantity) = Quantity::parse(&text) {
            let _ = quantity.value_in(UnitSystem::InKipKsi, Dimension::LENGTH);
        }
    }

    #[test]
    fn no_file_makes_it_panic(text in "\\PC*", at in 0..BEARING.len()) {
        let garbled = format!("{}{text}{}", &BEARING[..at], &BEARING[at..]);
        let _ = parse("garbled.toml", &garbled);
    }
}
