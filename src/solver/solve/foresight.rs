//! What a model is prepared for, and what happened beyond it.
//!
//! Contact is integrated up to a generous initial gap, but only rows that are likely to close are
//! kept when the bodies are condensed; likewise only elements that are likely to flow. Every
//! solution is looked at in full before it is accepted: if a row that was left out is penetrated,
//! if the surfaces overlap anywhere that no row acts, if contact has closed all that was kept of a
//! pair, or if an element that was taken for elastic yields, the model is prepared anew.

use super::history::{History, Settled, points};
use super::model::{Model, can_yield};
use super::newton::Point;
use super::rows::ContactRow;
use super::start::{extent, likely_gap, reach};
use crate::model::material::j2::PlasticPoint;
use crate::model::material::mises;
use crate::model::scene::Scene;
use crate::solver::contact::facing::Sight;
use crate::solver::solve::params::{
    EARLY_YIELD_SHARE, LEAST_FLOW_SHARE, STRESS_GROWTH_POWER, STRESS_TAKEN_OVER,
};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What a model is prepared for.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Expected {
    /// Contact is integrated up to this initial gap,
    pub reach: f64,
    /// and may close up to this much more than the least gap of its pair.
    pub contact: f64,
    /// Elements that may flow, ascending.
    pub flow: Vec<u32>,
    /// Was the model found too large for one factor?
    pub divided: bool,
}

/// What it was not prepared for.
#[derive(Debug, Default, PartialEq)]
pub struct Unforeseen {
    /// Surfaces overlap where contact was not integrated: this far apart at first, or farther.
    approach: Option<f64>,
    /// Contact closes at this initial gap over the least one, where it was left out.
    contact: Option<f64>,
    /// Elements that yield, or soon will, though the model takes them for elastic.
    pub flow: Vec<u32>,
    /// Is the solution wrong for it?
    pub missed: bool,
}

impl Expected {
    /// What is known before anything is solved, the bodies of `scene` in touch.
    pub fn at_start(scene: &Scene) -> Self {
        Self {
            reach: reach(scene),
            contact: likely_gap(scene),
            flow: Vec::new(),
            divided: false,
        }
    }

    /// Prepares for what was unforeseen, with some margin.
    pub fn learn(&mut self, unforeseen: Unforeseen) {
        if let Some(approach) = unforeseen.approach {
            self.reach = 2.0 * approach;
            self.contact = self.contact.max(1.5 * approach);
        }
        if let Some(gap) = unforeseen.contact {
            self.contact = (2.0 * self.contact).max(1.5 * gap);
        }
        self.flow.extend(unforeseen.flow);
        self.flow.sort_unstable();
    }

    /// Splits rows into those that may close and the others.
    pub fn split(&self, rows: Vec<ContactRow>) -> (Vec<ContactRow>, Vec<ContactRow>) {
        let least = least_gaps(rows.iter());
        rows.into_iter()
            .partition(|r| r.row.gap <= least[r.pair] + self.contact)
    }
}

impl Unforeseen {
    /// Looks at all of the solution `x` of `model`, and `ahead`.
    pub fn new(
        model: &Model,
        history: &History,
        sights: &[Vec<Sight>],
        x: &Point,
        ahead: Ahead,
    ) -> Self {
        let settled = &history.settled;
        let u = model.displacement(x, settled);
        let least = least_gaps(model.rows.iter());
        let beyond = |r: &&ContactRow| r.relative(&u)[0] > r.row.gap;
        let closing = model.spare.iter().filter(beyond);
        let closing = closing.map(|r| r.row.gap - least[r.pair]);
        let overlap = Overlap::find(model, sights, &u);
        let narrow = closed_throughout(model, x).map(|r| r.row.gap - least[r.pair]);
        let contact = closing
            .chain(overlap.left_out)
            .chain(narrow)
            .reduce(f64::max);
        let (flow, yields) = unexpected_flow(model, settled, (x, &u), ahead);
        Self {
            approach: overlap.not_integrated,
            contact,
            flow,
            missed: yields || contact.is_some() || overlap.not_integrated.is_some(),
        }
    }

    /// Nothing at all?
    pub fn is_empty(&self) -> bool {
        !self.missed && self.flow.is_empty()
    }

    /// Nothing but elements that flow?
    pub fn is_flow_only(&self) -> bool {
        self.approach.is_none() && self.contact.is_none()
    }

    /// The contact that another look missed, too.
    pub fn add_contact(&mut self, other: Self) {
        self.missed = true;
        let most = |a: Option<f64>, b| a.into_iter().chain(b).reduce(f64::max);
        self.approach = most(self.approach, other.approach);
        self.contact = most(self.contact, other.contact);
    }

    pub fn is_approach(&self) -> bool {
        self.approach.is_some()
    }
}

/// Where surfaces overlap and no row that was kept acts.
struct Overlap {
    /// The largest gap, over the least of its pair, of rows that were left out there.
    left_out: Option<f64>,
    /// Contact was not integrated there: up to which initial gap it has to be, at least.
    not_integrated: Option<f64>,
}

impl Overlap {
    /// Every node of a carrier facet that overlaps has to have its row, however small the overlap.
    fn find(model: &Model, sights: &[Vec<Sight>], u: &[[f64; 3]]) -> Self {
        let mut overlapped: BTreeMap<(usize, u32), f64> = BTreeMap::new();
        for (pair, sights) in sights.iter().enumerate() {
            let found = sights.par_iter().filter(|s| s.gap_at(u) < 0.0);
            let found: Vec<_> = found.map(|s| s.carrier.0).collect();
            if found.is_empty() {
                continue;
            }
            // All nodes of a facet have rows once all of it is integrated.
            let mut widest: BTreeMap<[u32; 4], f64> = BTreeMap::new();
            for sight in sights.iter().filter(|s| s.gap.is_finite()) {
                let gap = widest.entry(sight.carrier.0).or_default();
                *gap = gap.max(sight.gap);
            }
            for facet in found {
                for node in facet {
                    let gap = overlapped.entry((pair, node)).or_default();
                    *gap = gap.max(widest.get(&facet).copied().unwrap_or_default());
                }
            }
        }
        // Takes the nodes of a row away: was one of them overlapped?
        let mut take = |row: &ContactRow| {
            let nodes = row.row.nodes();
            let taken = nodes.filter(|node| overlapped.remove(&(row.pair, *node)).is_some());
            taken.count() > 0
        };
        model.rows.iter().for_each(|row| {
            take(row);
        });
        let least = least_gaps(model.rows.iter());
        let spare = model.spare.iter().filter(|row| take(row));
        let left_out = spare.map(|r| r.row.gap - least[r.pair]).reduce(f64::max);
        // Beyond the size of the model nothing more can be integrated.
        let could = model.reach < extent(model.scene);
        let gaps = overlapped.values().copied().filter(|_| could);
        Self {
            left_out,
            not_integrated: gaps.map(|gap| gap.max(model.reach)).reduce(f64::max),
        }
    }
}

/// The next row of a pair all of whose rows that were kept are closed: contact may go on beyond them.
fn closed_throughout<'m>(model: &'m Model, x: &Point) -> Option<&'m ContactRow> {
    let mut open = vec![false; model.scene.contacts.len()];
    for (row, node) in model.rows.iter().zip(&x.nodes) {
        open[row.pair] |= !node.closed;
    }
    let rows = model.spare.iter().filter(|r| !open[r.pair]);
    rows.min_by(|a, b| a.row.gap.total_cmp(&b.row.gap))
}

/// Least gap of each pair.
fn least_gaps<'r>(rows: impl Iterator<Item = &'r ContactRow>) -> Vec<f64> {
    let mut least: Vec<f64> = Vec::new();
    for r in rows {
        if least.len() <= r.pair {
            least.resize(r.pair + 1, f64::INFINITY);
        }
        least[r.pair] = r.row.gap.min(least[r.pair]);
    }
    least
}

/// What is known of the flow to come.
#[derive(Debug, Clone, Copy)]
pub enum Ahead {
    /// Nothing: the next increment takes loads larger by this factor.
    To(f64),
    /// The elements that will flow were foreseen. Where one was not, others like it are not far.
    Known,
    /// Loads are taken off: nothing but what flows now has to be learned.
    Less,
}

/// Elements to keep from now on, and whether one of them yields already.
fn unexpected_flow(
    model: &Model,
    settled: &Settled,
    (x, u): (&Point, &[[f64; 3]]),
    ahead: Ahead,
) -> (Vec<u32>, bool) {
    let shares = shares_of_yield(model, settled, u);
    let most = largest_share(&shares);
    let (next, share) = match ahead {
        Ahead::To(next) => {
            let to_come = load_to_come(model, x);
            (
                next.min(to_come),
                EARLY_YIELD_SHARE / to_come.powf(STRESS_GROWTH_POWER),
            )
        }
        Ahead::Known => (1.0, EARLY_YIELD_SHARE),
        Ahead::Less => (1.0, 1.0),
    };
    // As long as nothing will flow before the next look, all is well.
    if most * next.powf(STRESS_GROWTH_POWER) <= 1.0 {
        return (Vec::new(), false);
    }
    let elements = shares_above(&shares, share);
    (with_neighbours(model, &shares, &elements), most > 1.0)
}

/// Elements that will flow, from the `shares` of the elastic solution at full load. The more the stress exceeds
/// yield the more the neighbours take over, and the more contact widens.
pub fn flow_to_come(shares: &[(u32, f64)]) -> Vec<u32> {
    let share = 1.0 - STRESS_TAKEN_OVER * (largest_share(shares) - 1.0);
    shares_above(shares, share.clamp(LEAST_FLOW_SHARE, 1.0))
}

/// The largest Mises stress over the flow stress of every element that could yield and is not watched,
/// as long as it does not flow.
pub fn shares_of_yield(model: &Model, settled: &Settled, u: &[[f64; 3]]) -> Vec<(u32, f64)> {
    let scene = model.scene;
    (0..scene.mesh.hexes.len() as u32)
        .into_par_iter()
        .filter(|e| can_yield(scene, *e) && model.yielding.binary_search(e).is_err())
        .map(|e| {
            let body = scene.mesh.body_of(e as usize);
            let local = scene.mesh.hexes[e as usize].map(|n| u[n as usize]);
            let points = points(&settled.elements, e);
            let stress = model
                .element(e)
                .stress(&model.elastic[body], &local, &points);
            let steel = &scene.materials[body];
            let share = |(stress, point): (&_, &PlasticPoint)| {
                mises(stress) / steel.flow_stress(point.peeq)
            };
            (e, stress.iter().zip(&points).map(share).fold(0.0, f64::max))
        })
        .collect()
}

fn largest_share(shares: &[(u32, f64)]) -> f64 {
    shares.iter().map(|(_, share)| *share).fold(0.0, f64::max)
}

/// Elements of a larger share than that.
fn shares_above(shares: &[(u32, f64)], share: f64) -> Vec<u32> {
    let elements = shares.iter().filter(|(_, s)| *s > share);
    elements.map(|(element, _)| *element).collect()
}

/// Those of the elements with `shares` that have a node in common with `elements`.
fn with_neighbours(model: &Model, shares: &[(u32, f64)], elements: &[u32]) -> Vec<u32> {
    let hexes = &model.scene.mesh.hexes;
    let mut beside = vec![false; model.scene.mesh.points.len()];
    for node in elements.iter().flat_map(|e| hexes[*e as usize]) {
        beside[node as usize] = true;
    }
    let touches = |e: &u32| hexes[*e as usize].iter().any(|n| beside[*n as usize]);
    let all = shares.iter().map(|(element, _)| *element);
    all.filter(touches).collect()
}

/// How many times larger than now a load still gets.
fn load_to_come(model: &Model, x: &Point) -> f64 {
    let scene = model.scene;
    let names = (scene.tractions.iter().map(|t| &t.name))
        .chain(scene.rigid_planes.iter().map(|p| &p.name))
        .chain(scene.supports.iter().map(|s| &s.name));
    let ratios = names.map(|name| {
        let now = model.scene.factor(name, x.step, x.time).abs();
        let later = scene.steps[x.step..].iter();
        let most = later.map(|s| s.factor_of(name).abs()).fold(0.0, f64::max);
        if now > 0.0 { most / now } else { 1.0 }
    });
    ratios.fold(1.0, f64::max)
}
