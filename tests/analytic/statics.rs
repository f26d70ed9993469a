//! Rollers in V grooves and off the centre.

use brinell::analytic::contact_compliance;
use brinell::analytic::displaced::DisplacedRoller;
use brinell::analytic::hertz::LineContact;
use brinell::analytic::vgroove::VGroove;
use proptest::prelude::*;

use crate::{close, steel};

/// R, slope in degrees, w; then N, R sin θ, p0 of a line alone, and by boundary elements p0 of
/// the two lines together and their centre of pressure.
const GROOVES: [([f64; 3], [f64; 5]); 5] = [
    (
        [1.5, 4.0, 65.0 / 8.0],
        [
            4.072420210955,
            0.1046347106162,
            118.3534821751,
            118.6721514131,
            0.1060277066924,
        ],
    ),
    (
        [1.5, 4.0, 65.0 / 10.5],
        [
            3.102796351204,
            0.1046347106162,
            103.3073887294,
            103.519950127,
            0.1057579839977,
        ],
    ),
    (
        [2.25, 2.0, 60.0 / 9.0],
        [
            3.335365147663,
            0.07852386758063,
            87.45422827353,
            87.9624982209,
            0.08042542389595,
        ],
    ),
    (
        [2.46, 5.0, 210.0 / 5.19],
        [
            20.30849382313,
            0.2144031271592,
            206.381935806,
            207.4492949269,
            0.2197331235508,
        ],
    ),
    (
        [4.0, 6.0, 1485.0 / 12.0],
        [
            62.21582479799,
            0.4181138530706,
            283.2831959863,
            285.1825660148,
            0.431884371381,
        ],
    ),
];

#[test]
fn two_lines_in_a_groove() {
    let compliance = contact_compliance(steel(), steel()).unwrap();
    for ([radius, slope, w], [normal, offset, alone, together, centre]) in GROOVES {
        let slope = f64::to_radians(slope);
        let groove = VGroove::new(w, radius, slope, compliance).unwrap();
        close("N", groove.normal_load(), normal, 1e-12);
        close("offset", groove.offset(), offset, 1e-12);
        let contact = groove.contact().unwrap();
        close("p0 alone", contact.peak_pressure, alone, 1e-12);
        let single = LineContact::new(w, radius, compliance)
            .unwrap()
            .peak_pressure;
        close(
            "share",
            contact.peak_pressure / single,
            (2.0 * slope.cos()).sqrt().recip(),
            1e-12,
        );
        let both = groove.interaction().unwrap();
        close("p0 together", both.peak_pressure, together, 3e-4);
        // The boundary elements took the circle for a parabola, which touches at R tan θ.
        let parabola = radius * (slope.tan() - slope.sin());
        close("centre of pressure", both.offset + parabola, centre, 1e-3);
    }
}

#[test]
fn friction_bounds_of_the_study() {
    // θ = 4 degrees, μ = 0.15: 1.05 % either way.
    let groove = VGroove::new(8.125, 1.5, 4f64.to_radians(), 6e-5).unwrap();
    let [low, high] = groove.normal_load_bounds(0.15).unwrap();
    close("low", low / groove.normal_load() - 1.0, -0.0104, 1e-2);
    close("high", high / groove.normal_load() - 1.0, 0.0106, 1e-2);
    assert!(groove.normal_load_bounds(20.0).is_err());
    close("gap at the root", groove.gap_at_root(), 0.0037, 2e-2);
    let [normal, push] = groove.on_one_slope();
    close(
        "one slope",
        normal.powi(2) - push.powi(2),
        8.125 * 8.125,
        1e-12,
    );
    // Balance of a roller that friction holds, normal force w on the slope and the same shear on both faces.
    let push = groove.rolling_push();
    let (sine, cosine) = 4f64.to_radians().sin_cos();
    close("up", 8.125 * cosine + push * sine, 8.125, 1e-12);
    close("across", 8.125 * sine - push * cosine, push, 1e-12);
}

#[test]
fn lines_that_overlap_are_refused() {
    assert!(
        VGroove::new(8.125, 1.5, 0.01, 6e-5)
            .unwrap()
            .interaction()
            .is_err()
    );
    assert!(VGroove::new(8.125, 1.5, 1.6, 6e-5).is_err());
    assert!(VGroove::new(8.125, 1.5, f64::NAN, 6e-5).is_err());
}

#[test]
fn displaced_rollers_of_the_study() {
    // L, e, block w, largest w of the linear distribution; 65 kip.
    let table = [
        [8.0, 1.25, 11.818181818181818, 15.7421875],
        [8.0, 2.5, 21.666666666666668, 28.88888888888889],
        [10.5, 1.25, 8.125, 10.612244897959185],
        [10.5, 2.5, 11.818181818181818, 15.757575757575758],
    ];
    for [length, offset, block, linear] in table {
        let roller = DisplacedRoller::new(65.0, length, offset).unwrap();
        close("block", roller.block().largest, block, 1e-12);
        close("linear", roller.linear().largest, linear, 1e-12);
    }
    assert!(DisplacedRoller::new(65.0, 8.0, 4.0).is_err());
    assert!(DisplacedRoller::new(65.0, 8.0, -1.0).is_err());
}

proptest! {
    #[test]
    fn linear_distribution_balances_the_load(l in 0.1..100.0f64, share in 0.0..0.49f64) {
        let e = share * l;
        let roller = DisplacedRoller::new(3.0, l, e).unwrap();
        let n = 20_000;
        let h = l / f64::from(n);
        let [mut force, mut moment] = [0.0; 2];
        for i in 0..n {
            let y = -0.5 * l + h * (f64::from(i) + 0.5);
            force += h * roller.linear_at(y).unwrap();
            moment += h * y * roller.linear_at(y).unwrap();
        }
        prop_assert!((force / 3.0 - 1.0).abs() < 1e-4);
        prop_assert!((moment / 3.0 - e).abs() < 1e-4 * l);
        let block = roller.block();
        prop_assert!((block.largest * block.bearing_length / 3.0 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn groove_lines_balance_the_load(w in 0.1..100.0f64, slope in 0.01..1.5f64) {
        let groove = VGroove::new(w, 1.0, slope, 1e-6).unwrap();
        prop_assert!((2.0 * groove.normal_load() * slope.cos() / w - 1.0).abs() < 1e-12);
        let bounds = groove.normal_load_bounds(0.05).unwrap();
        prop_assert!(bounds[0] < groove.normal_load() && groove.normal_load() < bounds[1]);
    }
}
