//! Whatever the input: an answer that is finite, or an error; never a panic, never a NaN.

use brinell::analytic::Elastic;
use brinell::analytic::curved_beam::CurvedBeam;
use brinell::analytic::displaced::DisplacedRoller;
use brinell::analytic::hertz::LineContact;
use brinell::analytic::hertz::{EllipticContact, PointContact};
use brinell::analytic::ring::{PlaneState, Ring, RingLoad};
use brinell::analytic::subsurface::LineField;
use brinell::analytic::subsurface::{EllipseField, SphereField};
use brinell::analytic::vgroove::VGroove;
use brinell::proof::closed_forms::steel::{BilinearSteel, StrainMeasure};
use brinell::proof::closed_forms::tube::Tube;
use brinell::proof::closed_forms::{approach, flattening};
use proptest::prelude::*;

/// Anything, with a leaning to what people type, good or bad.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => (-4.0..4.0f64).prop_map(|e| 10f64.powf(e)),
        2 => (-120.0..120.0f64).prop_map(|e| 10f64.powf(e)),
        1 => any::<f64>(),
        1 => prop_oneof![Just(0.0), Just(-0.0), Just(-1.0), Just(f64::NAN), Just(f64::INFINITY)],
    ]
}

/// The debug text of an answer holds every number in it.
fn finite<T: std::fmt::Debug, E>(answer: Result<T, E>) -> Result<(), TestCaseError> {
    let Ok(answer) = answer else { return Ok(()) };
    let text = format!("{answer:?}");
    prop_assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn contacts(p in number(), r in number(), s in number(), c in number(), x in number()) {
        finite(LineContact::new(p, r, c))?;
        finite(PointContact::new(p, r, c))?;
        finite(EllipticContact::new(p, [r, s], c))?;
        if let Ok(line) = LineContact::new(p, r, c) {
            finite(line.pressure(x))?;
            let body = Elastic::new(s, 0.3);
            finite(body.and_then(|b| approach::half_cylinder(&line, r, b)))?;
        }
    }

    #[test]
    fn fields(a in number(), b in number(), p0 in number(), nu in -1.2..0.6f64, mu in number(),
              x in number(), z in number()) {
        if let Ok(field) = LineField::new(a, p0, nu).and_then(|f| f.sliding(mu)) {
            finite(field.stress(x, z))?;
            finite(field.stress(-x, z).map(|s| [s.mises(), s.shear_in_zx()]))?;
        }
        if let Ok(field) = SphereField::new(a, p0, nu) {
            finite(field.on_axis(z).map(|s| s.mises()))?;
        }
        if let Ok(field) = EllipseField::new([a, b], p0, nu) {
            finite(field.on_axis(z).map(|s| s.mises()))?;
        }
    }

    #[test]
    fn statics(p in number(), l in number(), e in number(), y in number(), slope in number()) {
        if let Ok(roller) = DisplacedRoller::new(p, l, e) {
            finite(Ok::<_, ()>([roller.block(), roller.linear()]))?;
            finite(roller.linear_at(y))?;
        }
        if let Ok(groove) = VGroove::new(p, l, slope, y) {
            finite(groove.contact())?;
            finite(groove.interaction())?;
            finite(groove.normal_load_bounds(e))?;
        }
    }

    #[test]
    fn steels_and_tubes(e in number(), y in number(), s in number(), strain in number(),
                        a in number(), b in number(), r in number()) {
        for measure in [StrainMeasure::Total, StrainMeasure::Plastic] {
            let steel = BilinearSteel::from_second_point(e, y, s, strain, measure);
            finite(steel.clone())?;
            let Ok(steel) = steel else { continue };
            finite(steel.stress(strain))?;
            finite(steel.residual_strain(strain))?;
            let Ok(tube) = Tube::new(a, b, steel) else { continue };
            finite(tube.elastic_stress(s, 0.3, r))?;
            finite(tube.elastic_displacement(s, 0.3, r))?;
            finite(tube.pressure_at_front(r))?;
            finite(tube.front(s))?;
            finite(tube.displacement_incompressible(r, a))?;
        }
    }

    #[test]
    fn spheres_beyond_yield(w in number(), strain in number(), nu in -1.2..0.6f64) {
        finite(flattening::kogut_etsion(w))?;
        finite(flattening::jackson_green(w, strain, nu))?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2_000))]

    #[test]
    fn rings(ri in number(), ro in number(), p in number(), e in number(), r in number(),
             theta in number(), angle in number()) {
        let Ok(body) = Elastic::new(e, 0.3) else { return Ok(()) };
        finite(CurvedBeam::new(ri, ro, p, body, PlaneState::Strain))?;
        for load in [RingLoad::Point, RingLoad::SemiElliptic { half_angle: angle }] {
            let Ok(ring) = Ring::new(ri, ro, p, body, PlaneState::Strain, load) else { continue };
            finite(ring.bore_stress(theta))?;
            for r in [r, ri, 0.5 * (ri + ro)] {
                finite(ring.stress(r, theta).map(|s| (s, s.mises())))?;
                finite(ring.displacement(r, theta))?;
            }
        }
    }
}
