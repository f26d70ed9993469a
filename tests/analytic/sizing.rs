//! Equations (2-45) to (2-51) of the reference study for the rollers it gives.

use brinell::analytic::hertz::LineContact;
use brinell::analytic::sizing::{self, PRINTED, exact};
use brinell::analytic::subsurface::{LineField, onset};
use brinell::analytic::{Elastic, contact_compliance};

use crate::{close, steel};

struct Roller {
    name: &'static str,
    /// D, P, L, E_s, σ_y.
    given: [f64; 5],
    /// p, σ_c (2-48), σ_c exact, σ_c/σ_y, b (2-47), b exact, D L required with 8, D L, load
    /// capacity with 8, largest Mises stress.
    expected: [f64; 10],
}

/// Sections 2.6, 4.1, 4.2, 5.2 of the study and its note on the NCREE rollers.
const ROLLERS: [Roller; 12] = [
    Roller {
        name: "initial design, L=8",
        given: [3.0, 65.0, 8.0, 29500.0, 100.0],
        expected: [
            8.125,
            167.0911103759,
            167.1731142447,
            1.671731142447,
            0.06205353890706,
            0.06188238669666,
            23.96875,
            24.0,
            65.08474576271,
            93.20172216524,
        ],
    },
    Roller {
        name: "revised, full L'=10.5",
        given: [3.0, 65.0, 10.5, 29500.0, 100.0],
        expected: [
            6.190476190476,
            145.8490783337,
            145.9206571786,
            1.459206571786,
            0.0541647693679,
            0.05401537547086,
            23.96875,
            31.5,
            85.42372881356,
            81.35313270904,
        ],
    },
    Roller {
        name: "prototype 1, L=17-8=9",
        given: [4.5, 60.0, 9.0, 29500.0, 75.0],
        expected: [
            6.666666666667,
            123.5806289507,
            123.6412790335,
            1.648550387113,
            0.06884222041643,
            0.06865234408705,
            39.33333333333,
            40.5,
            61.77966101695,
            68.93201809812,
        ],
    },
    Roller {
        name: "prototype 1, full L'=17",
        given: [4.5, 60.0, 17.0, 29500.0, 75.0],
        expected: [
            3.529411764706,
            89.91811525483,
            89.96224467201,
            1.199496595627,
            0.05009007287276,
            0.04995191755009,
            39.33333333333,
            76.5,
            116.6949152542,
            50.15541028333,
        ],
    },
    Roller {
        name: "prototype 2, L=8.19-3=5.19",
        given: [4.92, 210.0, 5.19, 29500.0, 175.0],
        expected: [
            40.46242774566,
            291.1693819827,
            291.3122801639,
            1.664641600937,
            0.1773383902574,
            0.1768492665424,
            25.28571428571,
            25.5348,
            212.0686779661,
            162.4113202762,
        ],
    },
    Roller {
        name: "prototype 2, full L'=8.19",
        given: [4.92, 210.0, 8.19, 29500.0, 175.0],
        expected: [
            25.64102564103,
            231.7861237675,
            231.8998782264,
            1.325142161294,
            0.1411706745847,
            0.1407813064129,
            25.28571428571,
            40.2948,
            334.6517288136,
            129.2879427309,
        ],
    },
    Roller {
        name: "prototype 2 test 315 kip, full L'",
        given: [4.92, 315.0, 8.19, 29500.0, 175.0],
        expected: [
            38.46153846154,
            283.8788663439,
            284.0181865342,
            1.62296106591,
            0.1728980596886,
            0.1724211830171,
            37.92857142857,
            40.2948,
            334.6517288136,
            158.3447447925,
        ],
    },
    Roller {
        name: "chapter 5, L=12",
        given: [8.0, 1485.0, 12.0, 29500.0, 240.0],
        expected: [
            123.75,
            399.3281240096,
            399.524103622,
            1.664683765092,
            0.395468447909,
            0.3943776914397,
            95.068359375,
            96.0,
            1499.552542373,
            222.7411666783,
        ],
    },
    Roller {
        name: "chapter 5, full L'=29",
        given: [8.0, 1485.0, 29.0, 29500.0, 240.0],
        expected: [
            51.20689655172,
            256.8748123584,
            257.0008796778,
            1.070836998657,
            0.2543920080816,
            0.2536903598718,
            95.068359375,
            232.0,
            3623.918644068,
            143.2821580921,
        ],
    },
    Roller {
        name: "NCREE carbon steel F=60, L=10 (sigma_u as sigma_y)",
        given: [3.0, 60.0, 10.0, 30000.0, 100.0],
        expected: [
            6.0,
            144.7994475128,
            144.8705112268,
            1.448705112268,
            0.05287871286255,
            0.05273286608655,
            22.5,
            30.0,
            80.0,
            80.76765931114,
        ],
    },
    Roller {
        name: "NCREE carbon steel F=56",
        given: [3.0, 56.0, 10.0, 30000.0, 100.0],
        expected: [
            5.6,
            139.8895564365,
            139.9582105067,
            1.399582105067,
            0.05108568999632,
            0.05094478862443,
            21.0,
            30.0,
            80.0,
            78.02897199904,
        ],
    },
    Roller {
        name: "NCREE cast iron both bodies F=176.4",
        given: [3.0, 176.4, 10.0, 20000.0, 140.0],
        expected: [
            17.64,
            202.7192265179,
            202.8187157175,
            1.448705112268,
            0.1110452970114,
            0.1107390187817,
            22.5,
            30.0,
            235.2,
            113.0747230356,
        ],
    },
];

#[test]
fn rollers_of_the_study() {
    for Roller {
        name,
        given: [d, load, length, e, y],
        expected,
    } in ROLLERS
    {
        let material = Elastic::new(e, 0.3).unwrap();
        let compliance = contact_compliance(material, material).unwrap();
        let p = load / length;
        let contact = LineContact::new(p, 0.5 * d, compliance).unwrap();
        let peak = LineField::below(&contact, 0.3).unwrap().peak_mises();
        let found = [
            p,
            PRINTED.steel_peak_pressure(p, 0.5 * d, e).unwrap(),
            contact.peak_pressure,
            contact.peak_pressure / y,
            PRINTED.contact_width(p, 0.5 * d, compliance).unwrap(),
            contact.width(),
            PRINTED.required_diameter_times_length(load, e, y).unwrap(),
            d * length,
            PRINTED.load_capacity(d, length, e, y).unwrap(),
            peak.value,
        ];
        for (value, expected) in found.into_iter().zip(expected) {
            close(name, value, expected, 1e-10);
        }
    }
}

#[test]
fn constants_exact_and_printed() {
    let constants = exact();
    close(
        "(2-45), 1/√π",
        constants.pressure,
        0.5641895835477563,
        1e-14,
    );
    close("(2-47), 4/√π", constants.width, 2.256758334191025, 1e-14);
    close(
        "(2-48), 1/√(2π(1-ν²))",
        constants.steel_pressure,
        0.41820514327208563,
        1e-14,
    );
    close(
        "(2-50) with 1.65",
        constants.sizing,
        7.78321725945237,
        1e-14,
    );
    let rounded = 0.5 * (sizing::PRESSURE_LIMIT / PRINTED.steel_pressure).powi(2);
    close(
        "(2-50) from 1.65 and 0.418",
        rounded,
        7.7908587257617725,
        1e-14,
    );
    let compliance = contact_compliance(steel(), steel()).unwrap();
    close("(2-46)", compliance, 6.169491525423729e-5, 1e-14);
    close("E*", compliance.recip(), 16208.791208791208, 1e-14);
}

#[test]
fn a_roller_sized_with_eight_passes_the_limit() {
    // D L = P E / 8 σ_y² exactly: D = 3, P = 65, L = 23.96875 / 3.
    let p = 65.0 / (23.96875 / 3.0);
    let reached = exact().steel_peak_pressure(p, 1.5, 29500.0).unwrap();
    close("σ_c/σ_y at 8", reached / 100.0, 1.6728205730883425, 1e-12);
    assert!(!sizing::within_limit(reached, 100.0).unwrap());
    let needed = exact()
        .required_diameter_times_length(65.0, 29500.0, 100.0)
        .unwrap();
    let reached = exact()
        .steel_peak_pressure(65.0 / (needed / 3.0), 1.5, 29500.0)
        .unwrap();
    close("σ_c/σ_y at 7.7832", reached / 100.0, 1.65, 1e-14);
}

#[test]
fn first_yield_of_the_study_roller() {
    let compliance = contact_compliance(steel(), steel()).unwrap();
    let contact = onset::line_yield_contact(100.0, 0.3, 1.5, compliance).unwrap();
    close("w_Y", contact.line_load, 9.353528958553662, 1e-10);
    close(
        "P_Y for L = 8",
        contact.line_load * 8.0,
        74.8282316684293,
        1e-10,
    );
}

#[test]
fn roller_lengths() {
    assert_eq!(sizing::final_length(8.0, 1.25).unwrap(), 10.5);
    assert_eq!(sizing::final_length(12.0, 8.5).unwrap(), 29.0);
    assert_eq!(sizing::effective_length(10.5, 1.25).unwrap(), 8.0);
    assert!(sizing::effective_length(8.0, 4.0).is_err());
}

#[test]
fn equivalent_modulus_of_one_steel_is_its_own() {
    let compliance = contact_compliance(steel(), steel()).unwrap();
    close(
        "E_s",
        sizing::equivalent_modulus(compliance).unwrap(),
        29500.0,
        1e-14,
    );
}
