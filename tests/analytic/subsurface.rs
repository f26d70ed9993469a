//! Stresses below Hertz contacts: Johnson (3.45), (3.69), (4.49), (7.8).

use brinell::analytic::hertz::EllipticContact;
use brinell::analytic::subsurface::{EllipseField, SphereField};
use brinell::analytic::subsurface::{LineField, onset};
use brinell::proof::closed_forms::subsurface::onset as point_onset;
use proptest::prelude::*;

use crate::close;

fn line(nu: f64) -> LineField {
    LineField::new(1.0, 1.0, nu).unwrap()
}

/// z/a, σ_x, σ_z, σ_y, Mises, shear; for ν = 0.3 over p0, to five decimals.
const LINE_AXIS: [[f64; 6]; 21] = [
    [0.0, -1.0, -1.0, -0.6, 0.4, 0.0],
    [0.1, -0.81494, -0.99504, -0.54299, 0.39417, 0.09005],
    [0.2, -0.65903, -0.98058, -0.49188, 0.43021, 0.16078],
    [0.3, -0.53024, -0.95783, -0.44642, 0.47508, 0.2138],
    [0.4, -0.42559, -0.92848, -0.40622, 0.51285, 0.25144],
    [0.5, -0.34164, -0.89443, -0.37082, 0.53879, 0.27639],
    [0.6, -0.27489, -0.85749, -0.33971, 0.55305, 0.2913],
    [0.7, -0.22208, -0.81923, -0.31239, 0.55751, 0.29858],
    [0.7043, -0.22008, -0.81758, -0.3113, 0.55752, 0.29875],
    [0.7862, -0.18557, -0.78613, -0.29151, 0.55523, 0.30028],
    [0.8, -0.18038, -0.78087, -0.28837, 0.55444, 0.30024],
    [0.9, -0.14743, -0.74329, -0.26722, 0.54592, 0.29793],
    [1.0, -0.12132, -0.70711, -0.24853, 0.53368, 0.29289],
    [1.2, -0.08392, -0.64018, -0.21723, 0.50304, 0.27813],
    [1.5, -0.05085, -0.5547, -0.18167, 0.45284, 0.25192],
    [2.0, -0.02492, -0.44721, -0.14164, 0.37771, 0.21115],
    [2.5, -0.01377, -0.37139, -0.11555, 0.31914, 0.17881],
    [3.0, -0.00833, -0.31623, -0.09737, 0.27444, 0.15395],
    [4.0, -0.00368, -0.24254, -0.07386, 0.21264, 0.11943],
    [5.0, -0.00192, -0.19612, -0.05941, 0.17278, 0.0971],
    [10.0, -0.00025, -0.0995, -0.02993, 0.08824, 0.04963],
];

/// z/a and Mises/p0 with more digits.
const LINE_AXIS_MISES: [(f64, f64); 21] = [
    (0.0, 0.4),
    (0.1, 0.3941664680996),
    (0.2, 0.4302093239439),
    (0.3, 0.475077653958),
    (0.4, 0.5128465932315),
    (0.5, 0.5387895401268),
    (0.6, 0.5530487939194),
    (0.7, 0.557509354694),
    (0.7043, 0.5575162165404),
    (0.7862, 0.5552277184793),
    (0.8, 0.5544360640483),
    (0.9, 0.5459172055313),
    (1.0, 0.5336768431563),
    (1.2, 0.5030399247479),
    (1.5, 0.4528417421182),
    (2.0, 0.3777087639997),
    (2.5, 0.3191414614199),
    (3.0, 0.274436425262),
    (4.0, 0.2126390685947),
    (5.0, 0.1727774290761),
    (10.0, 0.08824316810212),
];

#[test]
fn line_contact_on_the_axis() {
    for [z, sx, sz, sy, mises, shear] in LINE_AXIS {
        let stress = line(0.3).stress(0.0, z).unwrap();
        let found = [
            stress.xx,
            stress.zz,
            stress.yy,
            stress.mises(),
            stress.shear_in_zx(),
        ];
        // The row "0.7862" is the depth of the largest shear, and "0.7043" that of Mises.
        for (value, expected) in found.into_iter().zip([sx, sz, sy, mises, shear]) {
            assert!((value - expected).abs() < 2e-5, "{z}: {value} {expected}");
        }
    }
    for (z, mises) in LINE_AXIS_MISES {
        // The two rounded depths lie at extremes, or were taken there before rounding.
        let tolerance = if z == 0.7043 || z == 0.7862 {
            1e-5
        } else {
            1e-12
        };
        close(
            "Mises on the axis",
            line(0.3).stress(0.0, z).unwrap().mises(),
            mises,
            tolerance,
        );
    }
}

#[test]
fn line_contact_peaks() {
    let mises = line(0.3).peak_mises();
    close("Mises", mises.value, 0.5575162165660638, 1e-12);
    close("depth of Mises", mises.depth, 0.7042916757961625, 1e-6);
    let shear = line(0.3).peak_shear_on_axis();
    close("shear", shear.value, 0.30028310600077773, 1e-12);
    close("depth of shear", shear.depth, 0.7861513779458003, 1e-6);
    let yields = onset::line_yield_pressure(1.0, 0.3, 0.0).unwrap();
    close("p0/Y", yields, 1.7936697988075534, 1e-12);
}

#[test]
fn line_contact_peaks_for_other_ratios() {
    // ν: Mises/p0, z/a, p0/Y.
    let table = [
        [0.20, 0.6083, 0.5875, 1.644],
        [0.25, 0.5797, 0.6548, 1.725],
        [0.30, 0.5575, 0.7043, 1.794],
        [0.35, 0.5409, 0.7408, 1.849],
        [0.40, 0.5292, 0.7662, 1.889],
        [0.50, 0.5201, 0.7862, 1.923],
    ];
    for [nu, mises, z, pressure] in table {
        let peak = line(nu).peak_mises();
        close("Mises", peak.value, mises, 1e-4);
        close("depth", peak.depth, z, 1e-4);
        close(
            "p0/Y",
            onset::line_yield_pressure(1.0, nu, 0.0).unwrap(),
            pressure,
            3e-4,
        );
    }
    for nu in [0.0, 0.1, 0.19] {
        let peak = line(nu).peak_mises();
        close("Mises at the surface", peak.value, 1.0 - 2.0 * nu, 1e-12);
        assert_eq!(peak.depth, 0.0);
    }
}

/// μ and the largest Mises stress over p0 in full sliding, ν = 0.3.
const SLIDING_PEAKS: [(f64, f64); 12] = [
    (0.0, 0.5575162165661),
    (0.05, 0.5594884298336),
    (0.1, 0.5654481948068),
    (0.15, 0.5755318097533),
    (0.2, 0.5899927545783),
    (0.25, 0.6092558680446),
    (0.26, 0.6137404708735),
    (0.27, 0.6247911649385),
    (0.28, 0.6385483535594),
    (0.3, 0.666633332173),
    (0.4, 0.8158431221634),
    (0.5, 0.9746794344572),
];

#[test]
fn full_sliding_peaks() {
    for (mu, mises) in SLIDING_PEAKS {
        let peak = line(0.3).sliding(mu).unwrap().peak_mises();
        close("Mises", peak.value, mises, 1e-8);
        assert_eq!(peak.depth == 0.0, mu >= 0.27, "μ = {mu}");
    }
    // μ: x/a, z/a, p0/Y.
    let places = [
        [0.05, 0.144, 0.6955, 1.7873],
        [0.10, 0.285, 0.6693, 1.7685],
        [0.15, 0.423, 0.6260, 1.7375],
        [0.20, 0.553, 0.5660, 1.6949],
        [0.25, 0.676, 0.4893, 1.6413],
        [0.27, 0.261, 0.0, 1.6005],
        [0.30, 0.287, 0.0, 1.5001],
        [0.40, 0.371, 0.0, 1.2257],
        [0.50, 0.447, 0.0, 1.0260],
    ];
    for [mu, x, z, pressure] in places {
        let peak = line(0.3).sliding(mu).unwrap().peak_mises();
        assert!(
            (peak.x - x).abs() < 1e-3 && (peak.depth - z).abs() < 1e-3,
            "{mu}: {peak:?}"
        );
        close(
            "p0/Y",
            onset::line_yield_pressure(1.0, 0.3, mu).unwrap(),
            pressure,
            1e-4,
        );
    }
}

/// μ, x/a, z/a and σ_x, σ_z, τ_zx, σ_y over p0; checked by quadrature of Flamant's solution.
const SLIDING_FIELD: [([f64; 3], [f64; 4]); 24] = [
    ([0.15, 0.0, 0.0], [-1.0, -1.0, -0.15, -0.6]),
    (
        [0.15, -0.99, 0.0],
        [
            0.1559326402033,
            -0.1410673597967,
            -0.0211601039695,
            0.004459584122005,
        ],
    ),
    (
        [0.15, 0.99, 0.0],
        [
            -0.4380673597967,
            -0.1410673597967,
            -0.0211601039695,
            -0.173740415878,
        ],
    ),
    ([0.15, -1.0, 0.0], [0.3, 0.0, 0.0, 0.09]),
    (
        [0.15, 0.0, 0.5],
        [
            -0.3416407864999,
            -0.8944271909999,
            -0.05124611797498,
            -0.3708203932499,
        ],
    ),
    (
        [0.15, 0.5, 0.5],
        [
            -0.3642691945561,
            -0.7710215919519,
            -0.2228164552479,
            -0.3405872359524,
        ],
    ),
    (
        [0.15, -0.5, 0.5],
        [
            -0.2627663137212,
            -0.7182849543138,
            0.1287611290063,
            -0.2943153804105,
        ],
    ),
    (
        [0.15, 0.0, 0.7043],
        [
            -0.2200761372461,
            -0.8175769077188,
            -0.03301142058692,
            -0.3112959134895,
        ],
    ),
    (
        [0.15, 1.0, 0.25],
        [
            -0.4594468341764,
            -0.2639408517142,
            -0.2554433143557,
            -0.2170163057672,
        ],
    ),
    (
        [0.15, -1.0, 0.25],
        [
            -0.2030432738035,
            -0.2022138848371,
            0.1560697981587,
            -0.1215771475922,
        ],
    ),
    (
        [0.15, 0.0, 1.0],
        [
            -0.1213203435596,
            -0.7071067811865,
            -0.01819805153395,
            -0.2485281374239,
        ],
    ),
    (
        [0.15, 1.5, 0.5],
        [
            -0.2938489586341,
            -0.06811385813084,
            -0.1314947840748,
            -0.1085888450295,
        ],
    ),
    ([0.3, 0.0, 0.0], [-1.0, -1.0, -0.3, -0.6]),
    (
        [0.3, -0.99, 0.0],
        [
            0.4529326402033,
            -0.1410673597967,
            -0.042320207939,
            0.093559584122,
        ],
    ),
    (
        [0.3, 0.99, 0.0],
        [
            -0.7350673597967,
            -0.1410673597967,
            -0.042320207939,
            -0.262840415878,
        ],
    ),
    ([0.3, -1.0, 0.0], [0.6, 0.0, 0.0, 0.18]),
    (
        [0.3, 0.0, 0.5],
        [
            -0.3416407864999,
            -0.8944271909999,
            -0.10249223595,
            -0.3708203932499,
        ],
    ),
    (
        [0.3, 0.5, 0.5],
        [
            -0.4150206349735,
            -0.797389910771,
            -0.2698441183687,
            -0.3637231637233,
        ],
    ),
    (
        [0.3, -0.5, 0.5],
        [
            -0.2120148733038,
            -0.6919166354947,
            0.08173346588548,
            -0.2711794526395,
        ],
    ),
    (
        [0.3, 0.0, 0.7043],
        [
            -0.2200761372461,
            -0.8175769077188,
            -0.06602284117384,
            -0.3112959134895,
        ],
    ),
    (
        [0.3, 1.0, 0.25],
        [
            -0.5876486143628,
            -0.2948043351528,
            -0.3051300724542,
            -0.2647358848547,
        ],
    ),
    (
        [0.3, -1.0, 0.25],
        [
            -0.07484149361712,
            -0.1713504013985,
            0.1063830400602,
            -0.07385756850468,
        ],
    ),
    (
        [0.3, 0.0, 1.0],
        [
            -0.1213203435596,
            -0.7071067811865,
            -0.03639610306789,
            -0.2485281374239,
        ],
    ),
    (
        [0.3, 1.5, 0.5],
        [
            -0.3737968338414,
            -0.08302530136495,
            -0.1635799465888,
            -0.1370466405619,
        ],
    ),
];

#[test]
fn full_sliding_field() {
    for ([mu, x, z], expected) in SLIDING_FIELD {
        let stress = line(0.3).sliding(mu).unwrap().stress(x, z).unwrap();
        let found = [stress.xx, stress.zz, stress.zx, stress.yy];
        for (value, expected) in found.into_iter().zip(expected) {
            assert!(
                (value - expected).abs() < 1e-12,
                "{mu} {x} {z}: {value} {expected}"
            );
        }
    }
}

#[test]
fn sphere_peak_and_axis() {
    let field = SphereField::new(1.0, 1.0, 0.3).unwrap();
    let peak = field.peak_mises_on_axis();
    close("Mises", peak.value, 0.6200410039090427, 1e-12);
    close("depth", peak.depth, 0.48086447110438946, 1e-6);
    let pressure = |nu| point_onset::sphere_yield_pressure(1.0, nu).unwrap();
    close("p0/Y", pressure(0.3), 1.6127965629619805, 1e-12);
    for (nu, expected) in [(0.25, 1.5543), (0.35, 1.6741), (0.4, 1.7385), (0.5, 1.8772)] {
        close("p0/Y", pressure(nu), expected, 1e-4);
    }
    // z/a: σ_r, σ_z, Mises.
    let axis = [
        [0.0, -0.8, -1.0, 0.2],
        [0.25, -0.39852, -0.94118, 0.54266],
        [0.75, -0.07589, -0.64, 0.56411],
        [1.0, -0.02898, -0.5, 0.47102],
        [2.0, 0.00548, -0.2, 0.20548],
    ];
    for [z, sr, sz, mises] in axis {
        let stress = field.on_axis(z).unwrap();
        for (value, expected) in [(stress.xx, sr), (stress.zz, sz), (stress.mises(), mises)] {
            assert!((value - expected).abs() < 1e-5, "{z}: {value} {expected}");
        }
    }
}

/// B/A: b/a, a*, b*, δ*, Mises/p0 on the axis, its depth over b; ν = 0.3, Johnson 4.24-4.32.
const ELLIPSES: [(f64, [f64; 6]); 10] = [
    (1.0, [1.0, 1.0, 1.0, 1.0, 0.620041003909, 0.4808644711044]),
    (
        1.5,
        [
            0.7632987856064,
            1.149794826809,
            0.8776369950001,
            0.9909592744986,
            0.6184966293701,
            0.5427548827853,
        ],
    ),
    (
        2.0,
        [
            0.6305957014281,
            1.275820798198,
            0.8045271111365,
            0.9740821514076,
            0.6156848709138,
            0.581583038436,
        ],
    ),
    (
        3.0,
        [
            0.4826277811233,
            1.48582396216,
            0.717099921997,
            0.9375924352282,
            0.6099124326977,
            0.6271281314498,
        ],
    ),
    (
        5.0,
        [
            0.3459990866374,
            1.812939207405,
            0.627275309891,
            0.8756866902898,
            0.6010194454883,
            0.6684848248372,
        ],
    ),
    (
        10.0,
        [
            0.2222495192462,
            2.390482928355,
            0.5312836815932,
            0.7760938303663,
            0.5888603441574,
            0.7004241963107,
        ],
    ),
    (
        20.0,
        [
            0.1443276151903,
            3.157038377555,
            0.4556478200968,
            0.6723423826922,
            0.578736609769,
            0.7137283003633,
        ],
    ),
    (
        50.0,
        [
            0.08284217051752,
            4.54426728488,
            0.3764569652912,
            0.5438501469068,
            0.5694755125266,
            0.7170108552059,
        ],
    ),
    (
        100.0,
        [
            0.05498401805712,
            5.960685342178,
            0.3277424304871,
            0.4581314833922,
            0.5651108024655,
            0.7153388233738,
        ],
    ),
    (
        1000.0,
        [
            0.01473351315495,
            14.3164720564,
            0.2109319293753,
            0.2492044465251,
            0.5592299284053,
            0.7083498746731,
        ],
    ),
];

#[test]
fn ellipses() {
    // P C_E = 4/3 and A + B = 1 make c0 = 1 and the unit of the approach (9/16)(16/9) = 1.
    for (ratio, [k, a, b, approach, mises, depth]) in ELLIPSES {
        let gap = [1.0 / (1.0 + ratio), ratio / (1.0 + ratio)];
        let contact = EllipticContact::new(4.0 / 3.0, gap, 1.0).unwrap();
        close("b/a", contact.axis_ratio(), k, 1e-9);
        close("a*", contact.semi_axes[0], a, 1e-9);
        close("b*", contact.semi_axes[1], b, 1e-9);
        close("δ*", contact.approach, approach, 1e-9);
        let peak = EllipseField::below(&contact, 0.3)
            .unwrap()
            .peak_mises_on_axis();
        close("Mises", peak.value / contact.peak_pressure, mises, 1e-9);
        close("depth", peak.depth / contact.semi_axes[1], depth, 1e-6);
    }
}

proptest! {
    #[test]
    fn line_field_is_in_equilibrium(x in -3.0..3.0f64, z in 0.05..3.0f64, mu in 0.0..0.6f64) {
        let field = line(0.3).sliding(mu).unwrap();
        let h = 1e-5;
        let at = |x, z| field.stress(x, z).unwrap();
        let (east, west, down, up) = (at(x + h, z), at(x - h, z), at(x, z + h), at(x, z - h));
        let along = (east.xx - west.xx + down.zx - up.zx) / (2.0 * h);
        let across = (east.zx - west.zx + down.zz - up.zz) / (2.0 * h);
        prop_assert!(along.abs() < 1e-6 && across.abs() < 1e-6, "{along} {across}");
    }

    #[test]
    fn line_field_is_symmetric(x in 0.0..5.0f64, z in 0.0..5.0f64) {
        let (right, left) = (line(0.3).stress(x, z).unwrap(), line(0.3).stress(-x, z).unwrap());
        prop_assert_eq!(right.xx, left.xx);
        prop_assert_eq!(right.zz, left.zz);
        prop_assert_eq!(right.zx, -left.zx);
    }

    #[test]
    fn surface_carries_the_pressure(x in -3.0..3.0f64, mu in 0.0..0.6f64) {
        let stress = line(0.3).sliding(mu).unwrap().stress(x, 0.0).unwrap();
        let pressure = (1.0 - x * x).max(0.0).sqrt();
        prop_assert!((stress.zz + pressure).abs() < 1e-14);
        prop_assert!((stress.zx + mu * pressure).abs() < 1e-14);
    }

    #[test]
    fn far_below_the_line_load_is_flamants(x in -1.0..1.0f64) {
        // w = π a p0 / 2 on a line: σ_z = -2 w z³ / π (x² + z²)².
        let z = 1e5;
        let x = x * z;
        let stress = line(0.3).stress(x, z).unwrap();
        let square = x * x + z * z;
        let flamant = |c: f64| -z * c / (square * square);
        prop_assert!((stress.zz / flamant(z * z) - 1.0).abs() < 1e-8);
        prop_assert!((stress.xx - flamant(x * x)).abs() < 1e-8 * flamant(z * z).abs());
        prop_assert!((stress.zx - flamant(x * z)).abs() < 1e-8 * flamant(z * z).abs());
    }

    #[test]
    fn ellipse_goes_to_the_sphere(z in 0.0..5.0f64, nu in -0.9..0.5f64) {
        let nearly = EllipseField::new([1.0, 1.0 - 1e-9], 1.0, nu).unwrap().on_axis(z).unwrap();
        let sphere = SphereField::new(1.0, 1.0, nu).unwrap().on_axis(z).unwrap();
        prop_assert!((nearly.xx - sphere.xx).abs() < 1e-8);
        prop_assert!((nearly.yy - sphere.yy).abs() < 1e-8);
        prop_assert!((nearly.zz - sphere.zz).abs() < 1e-8);
    }

    #[test]
    fn ellipse_goes_to_the_line(z in 0.0..5.0f64, nu in -0.9..0.5f64) {
        // The short axis lies across the strip: σ_y of the ellipse is σ_x of the line.
        let slender = EllipseField::new([1e8, 1.0], 1.0, nu).unwrap().on_axis(z).unwrap();
        let strip = line(nu).stress(0.0, z).unwrap();
        prop_assert!((slender.yy - strip.xx).abs() < 1e-6);
        prop_assert!((slender.xx - strip.yy).abs() < 1e-6);
        prop_assert!((slender.zz - strip.zz).abs() < 1e-6);
    }
}
