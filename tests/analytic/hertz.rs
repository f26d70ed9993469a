//! Hertz contacts: Johnson (4.22) to (4.24), (4.24) to (4.32), (4.43) to (4.46).

use brinell::analytic::hertz::{EllipticContact, PointContact};
use brinell::analytic::hertz::{LineContact, effective_radius};
use brinell::analytic::{Elastic, contact_compliance};
use proptest::prelude::*;

use crate::{close, steel};

#[test]
fn line_contact_pressure_profile() {
    let compliance = contact_compliance(steel(), steel()).unwrap();
    let contact = LineContact::new(8.125, 1.5, compliance).unwrap();
    let profile = [
        (0.0, 1.0),
        (0.1, 0.99499),
        (0.2, 0.97980),
        (0.3, 0.95394),
        (0.4, 0.91652),
        (0.5, 0.86603),
        (0.6, 0.80000),
        (0.7, 0.71414),
        (0.8, 0.60000),
        (0.9, 0.43589),
        (0.95, 0.31225),
        (1.1, 0.0),
    ];
    for (x, share) in profile {
        let pressure = contact.pressure(x * contact.half_width).unwrap() / contact.peak_pressure;
        assert!((pressure - share).abs() < 1e-5, "{x}: {pressure}");
    }
}

#[test]
fn sphere_on_a_rigid_flat() {
    // mm, N, MPa: R = 50, E = 210000, ν = 0.3, P = 1000.
    let body = Elastic::new(210_000.0, 0.3).unwrap();
    let compliance = contact_compliance(body, Elastic::RIGID).unwrap();
    let contact = PointContact::new(1000.0, 50.0, compliance).unwrap();
    close("a", contact.contact_radius, 0.545696441530553, 1e-12);
    close("p0", contact.peak_pressure, 1603.3898971799065, 1e-12);
    close("δ", contact.approach, 0.005955692125982164, 1e-12);
}

#[test]
fn crossed_cylinders() {
    // mm, N, MPa: steel on steel, 10 kN.
    let body = Elastic::new(210_000.0, 0.3).unwrap();
    let compliance = contact_compliance(body, body).unwrap();
    let contact = EllipticContact::crossed_cylinders(10_000.0, [20.0, 50.0], compliance).unwrap();
    close("a", contact.semi_axes[0], 1.7041271571346548, 1e-12);
    close("b", contact.semi_axes[1], 0.9272679748204173, 1e-12);
    close("p0", contact.peak_pressure, 3021.580215223395, 1e-12);
    close("δ", contact.approach, 0.050536141105027355, 1e-12);
    let equal = EllipticContact::crossed_cylinders(10_000.0, [40.0, 40.0], compliance).unwrap();
    close("a", equal.semi_axes[0], 1.37507, 1e-5);
    close("p0", equal.peak_pressure, 2525.18, 1e-5);
    close("δ", equal.approach, 0.0472704, 1e-5);
}

#[test]
fn bad_arguments_are_named() {
    let text = LineContact::new(1.0, -1.0, 1.0).unwrap_err().to_string();
    assert_eq!(
        text,
        "effective radius is -1, but it must be positive and finite"
    );
    assert!(PointContact::new(f64::NAN, 1.0, 1.0).is_err());
    assert!(LineContact::new(f64::MAX, f64::MAX, 1.0).is_err());
    assert!(EllipticContact::new(1.0, [1e-30, 1.0], 1.0).is_err());
    // A shaft in a bore of its own size.
    assert!(effective_radius(1.0, -1.0).is_err());
    assert!(effective_radius(0.0, 1.0).is_err());
    assert_eq!(effective_radius(1.5, f64::INFINITY).unwrap(), 1.5);
    assert_eq!(effective_radius(2.0, -4.0).unwrap(), 4.0);
}

/// ∫ f over [-1, 1] of a function with square-root ends, by the rule of Gauss and Chebyshev.
fn integral(f: impl Fn(f64) -> f64) -> f64 {
    let n = 200;
    let angle = |i: i32| std::f64::consts::PI * f64::from(i) / f64::from(n + 1);
    let weight = |t: f64| std::f64::consts::PI / f64::from(n + 1) * t.sin();
    (1..=n).map(|i| weight(angle(i)) * f(angle(i).cos())).sum()
}

proptest! {
    #[test]
    fn pressure_adds_up_to_the_load(w in 1e-3..1e3f64, r in 0.1..100.0f64, c in 1e-7..1e-3f64) {
        let line = LineContact::new(w, r, c).unwrap();
        let a = line.half_width;
        prop_assert!((integral(|t| a * line.pressure(a * t).unwrap()) / w - 1.0).abs() < 1e-12);
        prop_assert!((line.mean_pressure() * line.width() / w - 1.0).abs() < 1e-12);
        let point = PointContact::new(w, r, c).unwrap();
        let a = point.contact_radius;
        let ring = |t: f64| std::f64::consts::PI * a * a * t.abs() * point.pressure(a * t).unwrap();
        prop_assert!((integral(ring) / w - 1.0).abs() < 1e-4);
        let area = std::f64::consts::PI * a * a;
        prop_assert!((point.mean_pressure() * area / w - 1.0).abs() < 1e-12);
    }

    #[test]
    fn units_do_not_matter(
        w in 1e-3..1e3f64, r in 0.1..100.0f64, ratio in 1.0..1e4f64, c in 1e-7..1e-3f64,
    ) {
        // in to mm and kip to N.
        let (length, force) = (25.4, 4448.2216152605);
        let stress = force / length / length;
        let inch = LineContact::new(w, r, c).unwrap();
        let metric = LineContact::new(w * force / length, r * length, c / stress).unwrap();
        prop_assert!((metric.half_width / inch.half_width / length - 1.0).abs() < 1e-13);
        prop_assert!((metric.peak_pressure / inch.peak_pressure / stress - 1.0).abs() < 1e-13);
        let inch = EllipticContact::new(w, [0.5 / r, 0.5 * ratio / r], c).unwrap();
        let gap = inch.gap.map(|g| g / length);
        let metric = EllipticContact::new(w * force, gap, c / stress).unwrap();
        prop_assert!((metric.semi_axes[0] / inch.semi_axes[0] / length - 1.0).abs() < 1e-11);
        prop_assert!((metric.peak_pressure / inch.peak_pressure / stress - 1.0).abs() < 1e-11);
        prop_assert!((metric.approach / inch.approach / length - 1.0).abs() < 1e-11);
    }

    #[test]
    fn a_round_ellipse_is_a_sphere(p in 1e-3..1e3f64, r in 0.1..100.0f64, c in 1e-7..1e-3f64) {
        let sphere = PointContact::new(p, r, c).unwrap();
        let ellipse = EllipticContact::crossed_cylinders(p, [r, r], c).unwrap();
        prop_assert!((ellipse.semi_axes[0] / sphere.contact_radius - 1.0).abs() < 1e-14);
        prop_assert!((ellipse.peak_pressure / sphere.peak_pressure - 1.0).abs() < 1e-14);
        prop_assert!((ellipse.approach / sphere.approach - 1.0).abs() < 1e-14);
        prop_assert_eq!(ellipse.axis_ratio(), 1.0);
    }

    #[test]
    fn a_slender_ellipse_is_a_strip(r in 0.1..100.0f64) {
        // In the middle of a very long ellipse the line load is w = (3/4) P / a.
        let c = 1e-5;
        let ellipse = EllipticContact::new(1.0, [0.5e-10 / r, 0.5 / r], c).unwrap();
        let w = 0.75 / ellipse.semi_axes[0];
        let strip = LineContact::new(w, r, c).unwrap();
        prop_assert!((ellipse.semi_axes[1] / strip.half_width - 1.0).abs() < 1e-8);
        prop_assert!((ellipse.peak_pressure / strip.peak_pressure - 1.0).abs() < 1e-8);
    }

    #[test]
    fn no_input_makes_nan(w in any::<f64>(), r in any::<f64>(), s in any::<f64>(), c in any::<f64>()) {
        if let Ok(line) = LineContact::new(w, r, c) {
            prop_assert!(line.half_width.is_finite() && line.peak_pressure.is_finite());
        }
        if let Ok(point) = PointContact::new(w, r, c) {
            prop_assert!(point.approach.is_finite() && point.peak_pressure.is_finite());
        }
        if let Ok(ellipse) = EllipticContact::new(w, [r, s], c) {
            prop_assert!(ellipse.approach.is_finite() && ellipse.peak_pressure.is_finite());
        }
    }
}
