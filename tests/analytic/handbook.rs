//! The handbook's answer for the rollers of the reference study.

use brinell::analytic::handbook::{Handbook, Metal, handbook};
use proptest::prelude::*;

use crate::close;

const STEEL: Metal = Metal {
    youngs_modulus: 29500.0,
    poissons_ratio: 0.3,
    yield_stress: 100.0,
};

/// The initial design: D = 3, wall 0.75, L = 8 in, 65 kip.
const INITIAL: Handbook = Handbook {
    diameter: 3.0,
    wall: Some(0.75),
    length: 8.0,
    load: 65.0,
    roller: STEEL,
    plate: STEEL,
    plate_thickness: Some(1.0),
    offset: None,
    groove_angle: Some(4.0),
    friction: 0.15,
};

#[test]
fn initial_design() {
    let answer = handbook(&INITIAL).unwrap();
    let bore = answer.bore.unwrap();
    let groove = answer.groove.unwrap();
    for (value, expected) in [
        (answer.line_load, 8.125),
        (answer.peak_pressure, 167.17311424465188),
        (answer.peak_pressure_printed, 167.0911103759463),
        (answer.contact_width, 0.06188238669666436),
        (answer.contact_width_printed, 0.06205353890705856),
        (answer.roller.mises, 93.20172216524466),
        (answer.first_yield.line_load, 9.353528958553662),
        (answer.first_yield.load, 74.8282316684293),
        (answer.rules.required_printed, 23.96875),
        (answer.rules.required_exact, 24.636),
        (answer.rules.capacity_printed, 65.08474576271186),
        (bore.hoop_under_load, 34.9998463457705),
        (bore.mises_under_load, 31.10854388973808),
        (bore.hoop_at_side, -30.682390231076855),
        (bore.outer_diameter_change.unwrap(), -0.003217401648142397),
        (bore.inner_diameter_change, -0.0022042297624475546),
        (groove.normal_load, 4.072420210954762),
        (groove.peak_pressure, 118.35348217512136),
    ] {
        close("initial design", value, expected, 2e-5);
    }
    close(
        "with interaction",
        groove.peak_pressure_with_interaction.unwrap(),
        118.67215,
        3e-4,
    );
    close(
        "error of the curved beam",
        bore.curved_beam_error,
        0.097,
        // That table is for point loads.
        2e-2,
    );
    assert!(answer.roller.mises_in_sliding.unwrap() > answer.roller.mises);
    assert!(answer.half_space_valid && answer.elastic && !answer.within_limit);
    assert!(
        answer.displaced.is_none() && answer.remarks.is_empty(),
        "{:?}",
        answer.remarks
    );
}

#[test]
fn displaced_designs() {
    // L, e: block w, p0 and Mises; linear w, p0 and Mises.
    let table = [
        ([8.0, 2.5], [21.667, 272.99, 152.0, 28.889, 315.2, 176.0]),
        ([8.0, 1.25], [11.818, 201.62, 112.0, 15.742, 232.7, 130.0]),
        ([10.5, 1.25], [8.125, 167.17, 93.0, 10.612, 191.1, 107.0]),
        ([10.5, 2.5], [11.818, 201.62, 112.0, 15.758, 232.8, 130.0]),
    ];
    for ([length, offset], expected) in table {
        let input = Handbook {
            length,
            offset: Some(offset),
            ..INITIAL
        };
        let answer = handbook(&input).unwrap();
        let displaced = answer.displaced.unwrap();
        let found =
            [displaced.block, displaced.linear].map(|s| [s.line_load, s.peak_pressure, s.mises]);
        for (value, expected) in found.into_iter().flatten().zip(expected) {
            close("displaced", value, expected, 5e-3);
        }
        let provided = answer.rules.diameter_times_length;
        close("D L", provided, 3.0 * (length - 2.0 * offset), 1e-12);
        let [normal, push] = displaced.on_slope.unwrap();
        let slope = 4f64.to_radians();
        close(
            "across the slope",
            normal * slope.cos(),
            displaced.block.line_load,
            1e-12,
        );
        close("push", push, 65.0 * slope.tan(), 1e-12);
        // 65 kip go up by s tan 4° while the bearing moves by 2 s, but for θ².
        let rolling = displaced.rolling_push.unwrap();
        close("work", rolling, 0.5 * 65.0 * slope.tan(), 2e-3);
    }
}

#[test]
fn wide_contacts_are_flagged() {
    let soft = Metal {
        youngs_modulus: 500.0,
        ..STEEL
    };
    let answer = handbook(&Handbook {
        roller: soft,
        plate: soft,
        ..INITIAL
    })
    .unwrap();
    assert!(!answer.half_space_valid);
    assert!(
        answer.remarks.iter().any(|r| r.contains("plate")),
        "{:?}",
        answer.remarks
    );
    let thin = handbook(&Handbook {
        wall: Some(0.3),
        ..INITIAL
    })
    .unwrap();
    assert!(
        thin.remarks.iter().any(|r| r.contains("quarter")),
        "{:?}",
        thin.remarks
    );
}

#[test]
fn the_softer_steel_governs() {
    let weak = Metal {
        yield_stress: 50.0,
        ..STEEL
    };
    let answer = handbook(&Handbook {
        plate: weak,
        ..INITIAL
    })
    .unwrap();
    assert!(!answer.elastic && answer.roller.share_of_yield < 1.0);
    close("limit", answer.rules.pressure_limit, 82.5, 1e-12);
    close(
        "first yield",
        answer.first_yield.peak_pressure,
        50.0 * 1.7936697988075534,
        1e-10,
    );
}

fn magnitude() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => (-3.0..3.0f64).prop_map(|e| 10f64.powf(e)),
        1 => any::<f64>(),
        1 => Just(0.0),
        1 => Just(f64::NAN),
        1 => Just(-1.0),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn units_do_not_matter(load in 1.0..100.0f64, offset in 0.0..3.0f64) {
        let inch = Handbook { load, offset: Some(offset), ..INITIAL };
        let (length, force) = (25.4, 4448.2216152605);
        let stress = force / length / length;
        let metal = Metal {
            youngs_modulus: 29500.0 * stress,
            poissons_ratio: 0.3,
            yield_stress: 100.0 * stress,
        };
        let metric = Handbook {
            diameter: 3.0 * length,
            wall: Some(0.75 * length),
            length: 8.0 * length,
            load: load * force,
            roller: metal,
            plate: metal,
            plate_thickness: Some(length),
            offset: Some(offset * length),
            ..INITIAL
        };
        let (a, b) = (handbook(&inch).unwrap(), handbook(&metric).unwrap());
        prop_assert!((a.peak_pressure * stress / b.peak_pressure - 1.0).abs() < 1e-12);
        let (ab, bb) = (a.bore.unwrap(), b.bore.unwrap());
        prop_assert!((ab.hoop_under_load * stress / bb.hoop_under_load - 1.0).abs() < 1e-9);
        prop_assert!((ab.inner_diameter_change * length / bb.inner_diameter_change - 1.0).abs() < 1e-9);
        prop_assert_eq!(a.elastic, b.elastic);
        prop_assert_eq!(a.within_limit, b.within_limit);
    }

    #[test]
    fn no_input_makes_nan(
        diameter in magnitude(),
        wall in proptest::option::of(magnitude()),
        length in magnitude(),
        load in magnitude(),
        modulus in magnitude(),
        offset in proptest::option::of(magnitude()),
        groove_angle in proptest::option::of(magnitude()),
        friction in magnitude(),
    ) {
        let metal = Metal { youngs_modulus: 1e3 * modulus, ..STEEL };
        let input = Handbook {
            diameter, wall, length, load, roller: metal, offset, groove_angle, friction, ..INITIAL
        };
        if let Ok(answer) = handbook(&input) {
            let text = format!("{answer:?}");
            prop_assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
            prop_assert!(answer.peak_pressure > 0.0 && answer.roller.mises > 0.0, "{text}");
        }
    }
}
