//! The next mesh of a bearing, from the bars of the last one: which figure misses, by how much, and what moves it.

use super::goal::{Goal, Target};
use super::level::Level;
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
/// Sizes that are to change by less than this stay.
const SAME: f64 = 0.97;

/// The sizes of the mesh that should meet `target`, over those of `level`, as far as the figures that count go.
///
/// Measured on a displaced bearing, one group of sizes changed at a time: half the size at the contact takes the bar of
/// the pressure to 0.57 of it and that of the Mises stress to 0.28; 2/3 around and through the wall that of the bore to
/// 0.45 and that of the descent to 0.69; 2/3 along that of the line load to 0.74. All else moved none by a tenth.
pub(super) fn next(level: &Level, target: &Target, counts: impl Fn(Goal) -> bool) -> Scales {
    let mut scales = Scales::default();
    for figure in level.figures.iter().filter(|f| counts(f.goal)) {
        let excess = |bar: f64| (MARGIN * bar.abs() / figure.allowed(target)).max(1.0);
        let own = match figure.estimate {
            _ if figure.meets(target, true) => continue,
            Some(bar) => {
                let of_edge = figure.beside_edge;
                let own = of_figure(figure.goal, excess(bar - of_edge.unwrap_or(0.0)));
                Scales {
                    along: own.along.min(of_edge.map_or(1.0, |_| 1.0 / excess(bar))),
                    ..own
                }
            }
            None => Scales::all(WITHOUT_BAR),
        };
        scales.contact = scales.contact.min(own.contact);
        scales.round = scales.round.min(own.round);
        scales.along = scales.along.min(own.along);
    }
    let bounded = |scale: f64| if scale > SAME { 1.0 } else { scale.max(LEAST) };
    Scales {
        contact: bounded(scales.contact),
        round: bounded(scales.round),
        along: bounded(scales.along),
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
        Goal::Mises
        | Goal::ElasticMises
        | Goal::PlasticStrain
        | Goal::HalfWidth
        | Goal::Area
        | Goal::Certified => Scales {
            contact: second,
            ..same
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_figure_moves_the_sizes_that_decide_it() {
        let same = Scales::default();
        let bore = of_figure(Goal::Bore, 4.0);
        assert_eq!((bore.round, bore.contact, bore.along), (0.5, 1.0, 1.0));
        let pressure = of_figure(Goal::Pressure, 2.0);
        assert_eq!((pressure.contact, pressure.round), (0.5, 1.0));
        let little = of_figure(Goal::Descent, 1.2);
        assert!(little.round < 1.0 && little.contact == 1.0);
        let much = of_figure(Goal::Descent, 4.0);
        assert_eq!([much.round, much.contact, much.along], [0.5; 3]);
        assert_eq!(of_figure(Goal::Mises, 1.0), same);
    }
}
