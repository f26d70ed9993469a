//! Thick tubes under internal pressure: Lamé, Hill 1950 ch. V, and Mises solved numerically.

use brinell::proof::closed_forms::steel::{BilinearSteel, StrainMeasure};
use brinell::proof::closed_forms::tube::Tube;
use brinell::proof::closed_forms::tube_mises::expand;
use proptest::prelude::*;

use crate::close;

/// a = 100, b = 200 mm, E = 210, Y = 0.24 GPa; de Souza Neto, Peric and Owen 2008, 7.5.1.
fn tube(tangent_modulus: f64) -> Tube {
    Tube::new(
        100.0,
        200.0,
        BilinearSteel::new(210.0, 0.24, tangent_modulus).unwrap(),
    )
    .unwrap()
}

#[test]
fn first_yield_and_limit() {
    close(
        "p_Y",
        tube(0.0).first_yield_pressure(),
        0.10392304845413264,
        1e-12,
    );
    close(
        "p_Y, ν = 0.5",
        tube(0.0).first_yield_pressure_mises(0.5).unwrap(),
        0.10392304845413264,
        1e-12,
    );
    close(
        "p_lim",
        tube(0.0).limit_pressure(),
        0.19209058141647098,
        1e-12,
    );
}

/// p in GPa: front c, u_o of Hill's compressible form, u_i of it, u_i and u_o of Mises with
/// ν = 0.3 (100 quadratic elements), u_i and u_o incompressible; mm.
const TUBES: [(f64, [f64; 7]); 6] = [
    (
        0.1,
        [
            100.0,
            0.05777777777778,
            0.09079365079365,
            0.09079365079377,
            0.05777777777787,
            0.0952380952381,
            0.04761904761905,
        ],
    ),
    (
        0.12,
        [
            108.2829722247,
            0.0704033051656,
            0.1110923246169,
            0.1111088118874,
            0.07042060772543,
            0.1160494041191,
            0.05802470205956,
        ],
    ),
    (
        0.14,
        [
            120.5388014279,
            0.08724216801054,
            0.1398176693544,
            0.1398182113166,
            0.08728730982307,
            0.1438057714459,
            0.07190288572297,
        ],
    ),
    (
        0.16,
        [
            136.2702936878,
            0.1115000586301,
            0.1833810696411,
            0.1834432354929,
            0.1116450716776,
            0.1837913054342,
            0.0918956527171,
        ],
    ),
    (
        0.18,
        [
            159.7852893603,
            0.1533014627963,
            0.2620314970213,
            0.2629076889288,
            0.1540231407343,
            0.2526947188951,
            0.1263473594475,
        ],
    ),
    (
        0.19,
        [
            182.8879372833,
            0.2008365883719,
            0.3546255576961,
            0.3625603826932,
            0.2054709694469,
            0.3310493214921,
            0.1655246607461,
        ],
    ),
];

#[test]
fn yielding_tube() {
    let tube = tube(0.0);
    for (
        p,
        [
            front,
            outer,
            inner,
            inner_mises,
            outer_mises,
            inner_half,
            outer_half,
        ],
    ) in TUBES
    {
        if p > tube.first_yield_pressure() {
            let c = tube.front(p).unwrap();
            close("front", c, front, 1e-10);
            let hill = |r| tube.displacement_compressible(c, 0.3, r).unwrap();
            close("Hill u_o", hill(200.0), outer, 1e-10);
            close("Hill u_i", hill(100.0), inner, 1e-10);
            let half = |r| tube.displacement_incompressible(c, r).unwrap();
            close("incompressible u_i", half(100.0), inner_half, 1e-10);
            close("incompressible u_o", half(200.0), outer_half, 1e-10);
        } else {
            let elastic = |nu, r| tube.elastic_displacement(p, nu, r).unwrap();
            close("elastic u_i", elastic(0.3, 100.0), inner, 1e-10);
            close("elastic u_o", elastic(0.3, 200.0), outer, 1e-10);
            close("incompressible u_i", elastic(0.5, 100.0), inner_half, 1e-10);
            close("incompressible u_o", elastic(0.5, 200.0), outer_half, 1e-10);
        }
        let mises = expand(&tube, 0.3, p, 400).unwrap();
        // The expected values carry the error of their own load steps, 8e-4 in the last row.
        close("Mises u_i", mises.inner, inner_mises, 1e-3);
        close("Mises u_o", mises.outer, outer_mises, 1e-3);
    }
    let mises = expand(&tube, 0.3, 0.95 * tube.limit_pressure(), 400).unwrap();
    close("u_i at 95 %", mises.inner, 0.2790, 5e-4);
    close("u_o at 95 %", mises.outer, 0.16244, 5e-4);
}

/// E_t = 5 GPa, ν = 0.5; front c: p, u_i, u_o.
const HARDENING: [(f64, [f64; 3]); 6] = [
    (100.0, [0.1039230484541, 0.09897433186108, 0.04948716593054]),
    (120.0, [0.1394560465461, 0.14252303788, 0.07126151893998]),
    (140.0, [0.1648606320474, 0.1939896904477, 0.09699484522386]),
    (160.0, [0.1821797353316, 0.2533742895644, 0.1266871447822]),
    (180.0, [0.1927310883778, 0.3206768352299, 0.1603384176149]),
    (200.0, [0.1974144293308, 0.3958973274443, 0.1979486637222]),
];

/// The steel of the reference study, a = 0.75, b = 1.5 in; front c: p, u_i, u_o in ksi and in.
const STUDY: [(f64, [f64; 3]); 4] = [
    (0.75, [43.30127018922, 0.002201759501147, 0.001100879750573]),
    (1.0, [65.3916781462, 0.00391423911315, 0.001957119556575]),
    (1.25, [76.99240004692, 0.006115998614297, 0.003057999307148]),
    (1.5, [80.81901972856, 0.008807038004588, 0.004403519002294]),
];

#[test]
fn hardening_tube() {
    let measure = StrainMeasure::Total;
    let steel = BilinearSteel::from_second_point(29500.0, 100.0, 138.0, 0.157, measure).unwrap();
    let study = Tube::new(0.75, 1.5, steel).unwrap();
    for (tube, table) in [(tube(5.0), HARDENING.as_slice()), (study, STUDY.as_slice())] {
        for (c, [p, inner, outer]) in table {
            close("p", tube.pressure_at_front(*c).unwrap(), *p, 1e-10);
            let u = |r| tube.displacement_incompressible(*c, r).unwrap();
            close("u_i", u(tube.inner_radius()), *inner, 1e-10);
            close("u_o", u(tube.outer_radius()), *outer, 1e-10);
            let mises = expand(&tube, 0.4999, *p, 20).unwrap();
            close("Mises u_i", mises.inner, *inner, 1e-4);
            // 1 - 2ν = 2e-4 is felt outside.
            close("Mises u_o", mises.outer, *outer, 2e-4);
            let thickness = tube.outer_radius() - tube.inner_radius();
            assert!(
                (mises.front - c).abs() < 0.01 * thickness,
                "{} {c}",
                mises.front
            );
        }
    }
}

#[test]
fn bad_arguments_are_refused() {
    let tube = tube(0.0);
    assert!(tube.front(0.05).is_err());
    assert!(tube.front(0.2).is_err());
    assert!(expand(&tube, 0.3, 0.2, 10).is_err());
    assert!(expand(&tube, 0.5, 0.1, 10).is_err());
    assert!(expand(&tube, 0.3, 0.1, 0).is_err());
    assert!(tube.elastic_stress(0.1, 0.3, 99.0).is_err());
    assert!(tube.pressure_at_front(f64::NAN).is_err());
    assert!(Tube::new(2.0, 1.0, *tube.steel()).is_err());
    assert!(
        self::tube(5.0)
            .displacement_compressible(120.0, 0.3, 150.0)
            .is_err()
    );
}

proptest! {
    #[test]
    fn elastic_stresses_meet_the_boundary(p in 0.0..10.0f64, nu in -0.9..0.5f64) {
        let tube = tube(0.0);
        let stress = |r| tube.elastic_stress(p, nu, r).unwrap();
        prop_assert!((stress(100.0).radial + p).abs() < 1e-12 * p.max(1.0));
        prop_assert!(stress(200.0).radial.abs() < 1e-12 * p.max(1.0));
    }

    #[test]
    fn front_inverts_its_pressure(c in 100.0..200.0f64, tangent in 0.0..20.0f64) {
        let tube = tube(tangent);
        let p = tube.pressure_at_front(c).unwrap();
        prop_assert!((tube.front(p).unwrap() / c - 1.0).abs() < 1e-7);
    }
}

/// A hole in a boundless body: -p and p at the bore, p (a/r)² off it. (b/r)² has no number here.
#[test]
fn a_bore_in_a_boundless_body() {
    let steel = BilinearSteel::new(210.0, 0.24, 0.0).unwrap();
    let tube = Tube::new(1e-82, 1e83, steel).unwrap();
    for (r, share) in [(1e-82, 1.0), (1e-80, 1e-4)] {
        let stress = tube.elastic_stress(2.0, 0.3, r).unwrap();
        close("hoop", stress.hoop, 2.0 * share, 1e-12);
        close("radial", stress.radial, -2.0 * share, 1e-12);
    }
}
