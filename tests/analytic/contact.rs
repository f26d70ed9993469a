//! Approach, stick and slip, punches and sphere beyond yield.

use brinell::analytic::hertz::LineContact;
use brinell::analytic::hertz::PointContact;
use brinell::analytic::ring::{PlaneState, Ring, RingLoad};
use brinell::analytic::{Elastic, contact_compliance};
use brinell::proof::closed_forms::approach;
use brinell::proof::closed_forms::flattening::{exact_critical, jackson_green, kogut_etsion};
use brinell::proof::closed_forms::friction::CattaneoMindlin;
use brinell::proof::closed_forms::limit::punch_pressure;
use brinell::proof::closed_forms::rounded_punch::RoundedPunch;
use proptest::prelude::*;

use crate::{close, steel};

/// Compression of half a solid cylinder by the exact series.
fn series(contact: &LineContact, radius: f64, body: Elastic) -> f64 {
    let load = RingLoad::SemiElliptic {
        half_angle: (contact.half_width / radius).asin(),
    };
    let disc = Ring::solid(radius, contact.line_load, body, PlaneState::Strain, load).unwrap();
    -disc.displacement(radius, 0.0).unwrap()[0]
}

#[test]
fn half_cylinder_on_a_rigid_flat() {
    // E, R, w; a, p0, δ by the series, δ by Johnson (5.57).
    let table = [
        (
            [29500.0, 1.5, 8.125],
            [
                0.021878727634609782,
                236.41848542893356,
                0.0008164097563937704,
                0.0008159876509124794,
            ],
        ),
        (
            [210000.0, 50.0, 1000.0],
            [
                0.52523191832366,
                1212.0736576699849,
                0.015018792698241312,
                0.015013409504457854,
            ],
        ),
        (
            [210000.0, 50.0, 5000.0],
            [
                1.1744542733243213,
                2710.2790922868953,
                0.06402354821397493,
                0.06396721421654245,
            ],
        ),
    ];
    for ([e, radius, w], [a, p0, exact, johnson]) in table {
        let body = Elastic::new(e, 0.3).unwrap();
        let compliance = contact_compliance(body, Elastic::RIGID).unwrap();
        let contact = LineContact::new(w, radius, compliance).unwrap();
        close("a", contact.half_width, a, 1e-12);
        close("p0", contact.peak_pressure, p0, 1e-12);
        close(
            "Johnson (5.57)",
            approach::half_cylinder(&contact, radius, body).unwrap(),
            johnson,
            1e-12,
        );
        close("series", series(&contact, radius, body), exact, 2e-5);
    }
}

#[test]
fn half_cylinder_in_its_unit() {
    // a/R, δ over w(1 - ν²)/πE by the series and by Johnson (5.57).
    let table = [
        [0.2, 5.0251, 4.9915],
        [0.1, 6.4036, 6.3778],
        [0.05, 7.7797, 7.7641],
        [0.02, 9.6037, 9.5966],
        [0.01, 10.987, 10.983],
    ];
    for [share, exact, johnson] in table {
        let body = Elastic::new(1.0, 0.3).unwrap();
        let compliance = body.plane_strain_compliance();
        let w = share * share * std::f64::consts::PI / (4.0 * compliance);
        let contact = LineContact::new(w, 1.0, compliance).unwrap();
        let unit = w * compliance / std::f64::consts::PI;
        close("a/R", contact.half_width, share, 1e-12);
        let value = approach::half_cylinder(&contact, 1.0, body).unwrap() / unit;
        close("Johnson (5.57)", value, johnson, 2e-5);
        close("series", series(&contact, 1.0, body) / unit, exact, 5e-5);
    }
}

#[test]
fn study_roller_between_flats() {
    let compliance = contact_compliance(steel(), steel()).unwrap();
    let contact = LineContact::new(8.125, 1.5, compliance).unwrap();
    close("a", contact.half_width, 0.03094119334833218, 1e-12);
    close(
        "half of the roller",
        series(&contact, 1.5, steel()),
        0.0007612681352469153,
        2e-5,
    );
}

#[test]
fn stick_of_cylinders() {
    // Q/μP, c/a.
    let table = [
        [0.25, 0.8660254037844386],
        [0.5, 0.7071067811865476],
        [0.75, 0.5],
        [0.9, 0.3162277660168379],
    ];
    let line = LineContact::new(2.0, 1.0, 0.01).unwrap();
    for [share, cylinder] in table {
        let stick = CattaneoMindlin::new(line, share * 0.2 * 2.0, 0.2).unwrap();
        close(
            "cylinder",
            stick.stick_half_width / line.half_width,
            cylinder,
            1e-12,
        );
    }
    assert!(CattaneoMindlin::new(line, 0.5, 0.2).is_err());
    assert!(CattaneoMindlin::new(line, 0.1, 0.0).is_err());
}

#[test]
fn traction_of_cylinders() {
    // Q/μP, then q/μp0 at x/a = 0, .2, .4, .5, .6, .7, .8, .9.
    let table = [
        (
            0.25,
            [
                0.13397, 0.13718, 0.14840, 0.15892, 0.17550, 0.20424, 0.26834, 0.43589,
            ],
        ),
        (
            0.5,
            [
                0.29289, 0.30156, 0.33342, 0.36603, 0.42583, 0.61414, 0.60000, 0.43589,
            ],
        ),
        (
            0.75,
            [0.5, 0.52154, 0.61652, 0.86603, 0.8, 0.71414, 0.6, 0.43589],
        ),
        (
            0.9,
            [
                0.68377, 0.73485, 0.91652, 0.86603, 0.8, 0.71414, 0.6, 0.43589,
            ],
        ),
    ];
    let line = LineContact::new(2.0, 1.0, 0.01).unwrap();
    for (share, expected) in table {
        let stick = CattaneoMindlin::new(line, share * 0.2 * 2.0, 0.2).unwrap();
        for (x, expected) in [0.0, 0.2, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9]
            .into_iter()
            .zip(expected)
        {
            let q = stick.traction(x * line.half_width).unwrap() / (0.2 * line.peak_pressure);
            assert!((q - expected).abs() < 1e-5, "{share} {x}: {q} {expected}");
        }
    }
}

#[test]
fn prandtls_punch() {
    close(
        "Mises",
        punch_pressure(1.0).unwrap(),
        2.9684999026134693,
        1e-12,
    );
    assert!(punch_pressure(0.0).is_err());
}

/// ω/ω_c; P and A of Kogut and Etsion, of Jackson and Green (steel of the study on a rigid flat).
const FLATTENED: [(f64, [f64; 4]); 8] = [
    (1.0, [1.0; 4]),
    (
        2.0,
        [
            2.765699355727,
            2.043868844693,
            2.829126916203,
            2.015477703635,
        ],
    ),
    (
        5.0,
        [
            10.20632705466,
            5.787791444297,
            10.13438920309,
            5.782636521229,
        ],
    ),
    (
        6.0,
        [
            13.23435428291,
            7.119717617744,
            13.00243267554,
            7.131938434928,
        ],
    ),
    (
        10.0,
        [
            25.6524019132,
            13.15612083218,
            25.88493203282,
            12.83508683203,
        ],
    ),
    (
        20.0,
        [
            61.56429636994,
            29.11442575554,
            64.2131194086,
            28.48864067125,
        ],
    ),
    (
        50.0,
        [
            195.8516123153,
            83.20462710326,
            202.3797290863,
            81.73717510674,
        ],
    ),
    (
        100.0,
        [
            470.0326599401,
            184.1313993096,
            460.4977715235,
            181.4230820229,
        ],
    ),
];

#[test]
fn sphere_beyond_yield() {
    let compliance = contact_compliance(steel(), Elastic::RIGID).unwrap();
    for (omega, [load, area, jg_load, jg_area]) in FLATTENED {
        let fit = kogut_etsion(omega).unwrap();
        close("KE load", fit.load, load, 1e-12);
        close("KE area", fit.area, area, 1e-12);
        let fit = jackson_green(omega, 100.0 * compliance, 0.3).unwrap();
        close("JG load", fit.load, jg_load, 1e-12);
        close("JG area", fit.area, jg_area, 1e-12);
    }
    let critical = exact_critical(1.5, compliance, 100.0, 0.3).unwrap();
    close("ω_c", critical.approach, 9.161e-5, 1e-4);
    close("P_c", critical.load, 0.046415, 2e-5);
    let hertz = PointContact::new(critical.load, 1.5, compliance).unwrap();
    close("Hertz at P_c", hertz.approach, critical.approach, 1e-12);
    assert!(kogut_etsion(111.0).is_err());
    assert!(jackson_green(1e6, 0.01, 0.3).is_err());
}

proptest! {
    #[test]
    fn traction_adds_up_to_the_tangential_load(share in 0.0..1.0f64) {
        let line = LineContact::new(2.0, 1.0, 0.01).unwrap();
        let q = share * 0.2 * 2.0;
        let stick = CattaneoMindlin::new(line, q, 0.2).unwrap();
        let n = 40_000;
        let h = 2.0 * line.half_width / f64::from(n);
        let x = |i: i32| -line.half_width + h * (f64::from(i) + 0.5);
        let sum: f64 = (0..n).map(|i| h * stick.traction(x(i)).unwrap()).sum();
        prop_assert!((sum - q).abs() < 1e-5, "{sum} {q}");
        for i in 0..100 {
            let (q, slip) = (stick.traction(x(400 * i)).unwrap(), 0.2 * line.pressure(x(400 * i)).unwrap());
            prop_assert!(q <= slip * (1.0 + 1e-12) && q >= -1e-12, "{q} {slip}");
        }
    }
}

proptest! {
    /// The pressure carries the load; it goes to nothing at the ends of the contact.
    #[test]
    fn rounded_punches_carry_their_load(b in 0.1f64..10.0, share in 0.01f64..10.0, pressed in 1e-4f64..0.01) {
        let punch = RoundedPunch::new(2.0 * b * pressed, b, share * b, 1.0).unwrap();
        let a = punch.half_width;
        // Midpoints in the angle, at which the root at the end is smooth.
        const POINTS: usize = 20_000;
        let angles = (0..POINTS).map(|k| std::f64::consts::PI * ((k as f64 + 0.5) / POINTS as f64 - 0.5));
        let sum: f64 = angles.map(|angle| punch.pressure(a * angle.sin()) * angle.cos()).sum();
        close("load", sum * a * std::f64::consts::PI / POINTS as f64, punch.load, 1e-4);
        prop_assert!(punch.pressure(a) == 0.0 && punch.pressure(-1.1 * a) == 0.0);
        prop_assert!(punch.peak_pressure().1 > punch.pressure(0.0));
    }
}

/// Almost without a flat part it is Hertz's cylinder, almost without rounding a flat punch.
#[test]
fn rounded_punches_lie_between_cylinder_and_flat_punch() {
    let hertz = LineContact::new(1.0, 10.0, 1e-3).unwrap();
    let punch = RoundedPunch::new(1.0, 1e-5 * hertz.half_width, 10.0, 1e-3).unwrap();
    close("half-width", punch.half_width, hertz.half_width, 1e-4);
    close("p0", punch.pressure(0.0), hertz.peak_pressure, 1e-4);
    let flat = RoundedPunch::new(1.0, 1.0, 1e-6, 1e-3).unwrap();
    let sharp = |x: f64| 1.0 / (std::f64::consts::PI * (1.0 - x * x).sqrt());
    for x in [0.0, 0.5, 0.9] {
        close("pressure", flat.pressure(x), sharp(x), 1e-4);
    }
}
