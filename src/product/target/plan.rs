//! The next mesh of a bearing, from the bars of the last one: which figure misses, by how much, and what moves it.

use super::goal::{Goal, Target};
use super::level::{Level, RefinedFigure};
use crate::case::bearing::Scales;

/// Bars should come out this much below the target: they are foreseen, not known.
const MARGIN: f64 = 1.1;
/// What rounds of rollers and layers of walls make of the error of the descent on `auto`; elsewhere it is in all
/// elements alike. It was 0.56 of a displaced bearing.
const ROUND_SHARE: f64 = 0.55;
/// Up to this share of the error that is to go, rounds and walls alone are made finer for the descent.
const BY_ROUND: f64 = 0.45;
/// No size shrinks by more than this from one mesh to the next: so far orders are believed.
const LEAST: f64 = 0.3;
/// Where a figure has no bar, nothing says which sizes decide it: all shrink to this.
const WITHOUT_BAR: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// A bar that is more than this of what it was on the mesh before has not come down.
const STUCK: f64 = 0.9;
/// Sizes that are to change by less than this stay.
const SAME: f64 = 0.97;

/// The sizes of the mesh that should meet `target`, over those of `level`, as far as the figures that count go.
///
/// Measured on a displaced bearing, one group of sizes changed at a time: half the size at the contact takes the bar of
/// the pressure to 0.57 of it and that of the Mises stress to 0.28; 2/3 around and through the wall that of the bore to
/// 0.45 and that of the descent to 0.69; 2/3 along that of the line load to 0.74. All else moved none by a tenth.
///
/// Where a bar has not come down since the level `before`, what was made smaller for it does not decide it: all sizes are.
pub(super) fn next(
    level: &Level,
    before: Option<&Level>,
    target: &Target,
    counts: impl Fn(Goal) -> bool,
) -> Scales {
    let mut scales = Scales::default();
    for figure in level.figures.iter().filter(|f| counts(f.goal)) {
        let old = before.and_then(|level| level.figure_of(figure.goal));
        let own = needed(figure, old, target);
        scales.contact = scales.contact.min(own.contact);
        scales.transition = scales.transition.min(own.transition);
        scales.round = scales.round.min(own.round);
        scales.along = scales.along.min(own.along);
    }
    let bounded = |scale: f64| if scale > SAME { 1.0 } else { scale.max(LEAST) };
    Scales {
        contact: bounded(scales.contact),
        transition: bounded(scales.transition),
        round: bounded(scales.round),
        along: bounded(scales.along),
    }
}

/// The sizes that should bring one figure within the target; `old` is the figure on the mesh before.
fn needed(figure: &RefinedFigure, old: Option<&RefinedFigure>, target: &Target) -> Scales {
    if figure.meets(target, true) {
        return Scales::default();
    }
    let Some(bar) = figure.estimate else {
        return Scales::all(WITHOUT_BAR);
    };
    let over = |figure: &RefinedFigure, bar: f64| bar.abs() / figure.allowed(target);
    let excess = |bar: f64| (MARGIN * over(figure, bar)).max(1.0);
    let was = old.and_then(|old| Some(over(old, old.estimate?)));
    if was.is_some_and(|was| over(figure, bar) > STUCK * was) {
        return Scales::all(excess(bar).sqrt().recip());
    }
    let own = of_figure(figure.goal, excess(bar - figure.beside_edge.unwrap_or(0.0)));
    match figure.beside_edge {
        None => own,
        // Next to an edge the stress falls along the line as fast as below it.
        Some(_) => Scales {
            along: own.along.min(1.0 / excess(bar)),
            ..own
        },
    }
}

/// The sizes that decide a figure, where its bar is `excess` times too wide.
fn of_figure(goal: Goal, excess: f64) -> Scales {
    let (first, second) = (1.0 / excess, excess.sqrt().recip());
    let same = Scales::default();
    match goal {
        Goal::Pressure | Goal::HertzPressure => Scales {
            contact: first,
            ..same
        },
        Goal::LineLoad => Scales {
            contact: first,
            along: first,
            ..same
        },
        Goal::Bore => Scales {
            round: second,
            ..same
        },
        Goal::Descent if 1.0 - first <= BY_ROUND => Scales {
            round: (1.0 - (1.0 - first) / ROUND_SHARE).sqrt(),
            ..same
        },
        Goal::Descent => Scales::all(second),
        Goal::Mises | Goal::ElasticMises | Goal::PlasticStrain => Scales {
            contact: second,
            transition: second,
            ..same
        },
        Goal::HalfWidth | Goal::Area | Goal::Certified => Scales {
            contact: second,
            ..same
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::certify::Quantity;

    #[test]
    fn a_figure_moves_the_sizes_that_decide_it() {
        let same = Scales::default();
        let bore = of_figure(Goal::Bore, 4.0);
        assert_eq!((bore.round, bore.contact, bore.along), (0.5, 1.0, 1.0));
        let pressure = of_figure(Goal::Pressure, 2.0);
        assert_eq!((pressure.contact, pressure.round), (0.5, 1.0));
        assert_eq!(pressure.transition, 1.0);
        let mises = of_figure(Goal::ElasticMises, 4.0);
        assert_eq!((mises.contact, mises.transition), (0.5, 0.5));
        let little = of_figure(Goal::Descent, 1.2);
        assert!(little.round < 1.0 && little.contact == 1.0);
        let much = of_figure(Goal::Descent, 4.0);
        assert_eq!([much.round, much.contact, much.along], [0.5; 3]);
        assert_eq!(of_figure(Goal::Mises, 1.0), same);
    }

    #[test]
    fn a_peak_next_to_an_edge_moves_the_sizes_along() {
        let target = Target {
            goal: Goal::ElasticMises,
            within: 0.03,
        };
        let figure = |estimate: f64, beside_edge: Option<f64>| RefinedFigure {
            goal: Goal::ElasticMises,
            what: Quantity::MisesAway,
            place: "roller".into(),
            value: 100.0,
            estimate: Some(estimate),
            beside_edge,
            change: None,
            at_edge: false,
            of: None,
        };
        let of = |estimate, beside_edge| needed(&figure(estimate, beside_edge), None, &target);
        let inside = of(6.0, None);
        assert!(inside.contact < 1.0 && inside.along == 1.0);
        // The edge is all that misses.
        let edge = of(6.0, Some(4.0));
        assert!((edge.along - 3.0 / (MARGIN * 6.0)).abs() < 1e-12 && edge.contact == 1.0);
        let both = of(6.0, Some(0.0));
        assert_eq!((both.contact, both.along), (inside.contact, edge.along));
        assert_eq!(of(2.9, Some(1.0)), Scales::default());
        // What has not come down by finer elements at the contact is not theirs alone.
        let stuck = needed(&figure(6.0, None), Some(&figure(6.1, None)), &target);
        assert_eq!(
            [stuck.contact, stuck.round, stuck.along],
            [inside.contact; 3]
        );
        let halved = needed(&figure(6.0, None), Some(&figure(12.0, None)), &target);
        assert_eq!(halved, inside);
    }
}
