//! Every part: elastic Mises stress below yield, no plastic strain.

use super::check::{LimitCheck, LimitKind};
use super::standing::{SizeStanding, UNRESOLVED};
use crate::answer::certify::{Figure, Quantity};
use crate::answer::results::flow::BodyFlow;
use crate::product::job::Outcome;
use crate::render::Summary;
use crate::render::text::{percent, significant};

pub fn checks(limit: f64, outcome: &Outcome) -> Vec<LimitCheck> {
    let summary = &outcome.summary;
    let bodies = summary.answer.bodies.0.iter();
    let bodies: Vec<(&str, BodyFlow)> = bodies.map(|(name, b)| (name.as_str(), b.flow)).collect();
    let stress = (bodies.iter()).map(|(body, flow)| mises(summary, body, *flow, limit));
    let strain = bodies
        .iter()
        .flat_map(|(body, flow)| strains(summary, body, *flow, limit));
    stress.chain(strain).collect()
}

/// The first of some kinds of claim that there is.
fn first<'s>(summary: &'s Summary, body: &str, kinds: &[Quantity]) -> Option<&'s Figure> {
    let of = |kind: &Quantity| summary.answer.figure(*kind, body);
    kinds.iter().find_map(of)
}

/// The peak of the elastic solution, away from singular edges where it lies at one.
fn mises(summary: &Summary, body: &str, flow: BodyFlow, limit: f64) -> LimitCheck {
    use Quantity::{ElasticMisesAway, ElasticPeakMises, MisesAway, PeakMises};
    let yielded = flow != BodyFlow::default();
    let (peak, away) = if yielded {
        (ElasticPeakMises, ElasticMisesAway)
    } else {
        (PeakMises, MisesAway)
    };
    let mut check = LimitCheck {
        limit: Some(limit),
        ..LimitCheck::bare(LimitKind::ElasticMises, body)
    };
    let Some(judged) = first(summary, body, &[away, peak]) else {
        check.standing = SizeStanding::Missed;
        check.remark = Some("no elastic solution: the part has yielded".to_string());
        return check;
    };
    let error = judged.bar();
    check.value = Some(judged.value);
    if error.is_none() {
        check.standing = SizeStanding::Unresolved;
        check.remark = Some(UNRESOLVED.to_string());
        return check;
    }
    if judged.what == away {
        let all = summary.answer.figure(peak, body).filter(|all| all.at_edge);
        check.remark = Some(match all {
            Some(all) => format!(
                "away from singular edges; on this mesh it is {} at all, which grows with every refinement",
                significant(all.value, 2)
            ),
            None => "away from singular edges, where a finer mesh may show more".to_string(),
        });
    }
    check.error = error;
    check.utilisation = Some(judged.value / limit);
    check.standing = SizeStanding::of(judged.value, error, limit);
    check
}

/// An element flows as such, and not only at single integration points, where its mean stress is so near
/// to yield: the elements of bearings that do yield have 0.97 and more, those that overshoot 0.7 to 0.8.
const FLOWING_MEAN_STRESS: f64 = 0.9;

/// Plastic strain away from singular edges, and what there is beside them.
fn strains(summary: &Summary, body: &str, flow: BodyFlow, limit: f64) -> Vec<LimitCheck> {
    let resolved = flow.mean_mises >= FLOWING_MEAN_STRESS * limit;
    let certified = summary.answer.figure(Quantity::PeakPlasticStrain, body);
    // The certificate is about the largest of all.
    let own = certified.filter(|_| flow.away >= flow.at_edges);
    let mut checks = vec![LimitCheck {
        value: Some(flow.away),
        error: own.and_then(Figure::bar),
        limit: Some(0.0),
        standing: match (flow.away > 0.0, resolved) {
            (false, _) => SizeStanding::Met,
            (true, false) => SizeStanding::Open,
            // The certificate says that it may be none.
            (true, true) if own.is_some_and(|figure| figure.bar().is_none()) => SizeStanding::Open,
            (true, true) => SizeStanding::Missed,
        },
        remark: (flow.away > 0.0 && !resolved).then(|| {
            format!(
                "integration points of elements whose mean stress is at most {} of yield: such points \
                 overshoot where a strip of contact ends, so this mesh cannot tell",
                percent(flow.mean_mises / limit)
            )
        }),
        ..LimitCheck::bare(LimitKind::PlasticStrain, body)
    }];
    if flow.at_edges > 0.0 {
        checks.push(LimitCheck {
            value: Some(flow.at_edges),
            at_edge: true,
            remark: Some(
                "beside a singular edge, such as a square end of a roller: elastic stress has no bound \
                 there, so a little flow and a dent are found on any mesh that is fine enough"
                    .to_string(),
            ),
            ..LimitCheck::bare(LimitKind::EdgePlasticStrain, body)
        });
    }
    checks
}
