//! The lines along which a roller presses: the load of each, where it carries and where it lifts off.

use super::load::{cutting_pair, upright};
use super::strip_row::StripRow;
use crate::ground::geometry::{norm, sub};
use crate::model::scene::Scene;
use crate::model::state::State;
use std::ops::Range;

/// One line of contact along a carrier surface whose nodes stand in rows across it.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactLine {
    /// Where it runs: the mean of the coordinate across, weighted by force.
    pub across: f64,
    /// Coordinates of the rows along the surface, ascending.
    pub at: Vec<f64>,
    /// Force normal to the surface per length at each row, of the whole line where a mirror plane
    /// cuts it; zero where it has lifted off.
    pub load: Vec<f64>,
    /// Length over which it carries and length over which it does not, in the whole.
    pub length: f64,
    /// Length over which it has lifted off, in the whole.
    pub lifted_off: f64,
    /// How many such lines there are in the whole of its two bodies: mirror planes that cut these, but not it, double it.
    pub images: usize,
    /// The row that carries most per length.
    pub heaviest: StripRow,
}

impl ContactLine {
    /// The largest load per length and where it is; `None` where nothing is carried.
    pub fn peak(&self) -> Option<(f64, f64)> {
        let rows = self.load.iter().copied().zip(self.at.iter().copied());
        rows.filter(|(load, _)| *load > 0.0)
            .reduce(|most, row| if row.0 > most.0 { row } else { most })
    }

    /// The load per length of its heaviest row.
    pub fn heaviest_load(&self) -> f64 {
        self.load[self.heaviest.row]
    }

    /// The same as a mean over the lengths to the rows beside it, weighted by the hat function of the row and less what a
    /// slope makes of lengths that differ: what is left where loads alternate from row to row, as beside a fillet.
    pub fn heaviest_mean_load(&self) -> f64 {
        let row = self.heaviest.row;
        let beside = |row: usize| Some((*self.at.get(row)?, *self.load.get(row)?));
        let (at, load) = (self.at[row], self.load[row]);
        let (Some((a, p)), Some((b, q))) = (row.checked_sub(1).and_then(beside), beside(row + 1))
        else {
            return load;
        };
        let (before, after) = (at - a, b - at);
        let mean =
            (before * (p + 2.0 * load) + after * (q + 2.0 * load)) / (3.0 * (before + after));
        mean - (after - before) / 3.0 * (q - p) / (before + after)
    }

    /// Is it a line? Where it lifts off it has to be three times as long as it is wide: a patch that is
    /// no longer is one of spheres.
    pub fn is_long(&self) -> bool {
        self.lifted_off <= 0.0 || self.length > 6.0 * self.heaviest.half_width
    }

    /// How many rows in the whole one row of the modelled part stands for.
    pub fn length_share(&self) -> f64 {
        match self.extent() {
            Some(extent) => (self.length + self.lifted_off) / extent,
            None => 1.0,
        }
    }

    /// The middle of the carrier, along it.
    pub fn middle(&self) -> Option<f64> {
        Some(0.5 * (self.at.first()? + self.at.last()?))
    }

    /// How far from its resultant its loads act in the mean, ∫ q |x − x̄| / ∫ q, of the modelled part; `None` where
    /// nothing is carried.
    pub fn spread(&self) -> Option<f64> {
        let force = self.force();
        let mean = |distance: &dyn Fn(f64) -> f64| {
            let moments = self.row_forces().map(|(at, f)| f * distance(at));
            moments.sum::<f64>() / force
        };
        let centre = mean(&|x| x);
        (force > 0.0).then(|| mean(&|x| (x - centre).abs()))
    }

    /// Load per length, spread evenly over the whole length of the carrier.
    pub fn mean(&self) -> f64 {
        self.extent().map_or(0.0, |extent| self.force() / extent)
    }

    /// From its first row to its last one; `None` where it has not two.
    fn extent(&self) -> Option<f64> {
        let extent = self.at.last()? - self.at.first()?;
        (extent > 0.0).then_some(extent)
    }

    fn force(&self) -> f64 {
        self.row_forces().map(|(_, force)| force).sum()
    }

    /// Place and force of every row.
    fn row_forces(&self) -> impl Iterator<Item = (f64, f64)> {
        let rows = self.at.iter().zip(&self.load).zip(lengths(&self.at));
        rows.map(|((at, load), length)| (*at, load * length))
    }
}

/// The length that each row stands for, to the middles between it and its neighbours.
fn lengths(at: &[f64]) -> Vec<f64> {
    let last = at.len().saturating_sub(1);
    let length = |i: usize| 0.5 * (at[(i + 1).min(last)] - at[i.saturating_sub(1)]);
    (0..at.len()).map(length).collect()
}

/// Adjacent nodes of a row that press.
struct PressingRun {
    row: usize,
    /// Its nodes, among the members of the row.
    nodes: Range<usize>,
    /// Mean coordinate across, and the width that the run stands for.
    across: f64,
    width: f64,
    force: f64,
    /// Does it reach a mirror plane?
    mirrored: bool,
}

/// The lines of contact pair `pair` along `axis`, by their place across; empty where the carrier's
/// nodes do not stand in rows (a row has three nodes or more) or nothing presses.
pub fn contact_lines(scene: &Scene, state: &State, pair: usize, axis: usize) -> Vec<ContactLine> {
    contact_lines_by(scene, state, pair, axis, &|_| true)
}

/// The same, the heaviest row of each among those that count; empty where none does.
pub(super) fn contact_lines_by(
    scene: &Scene,
    state: &State,
    pair: usize,
    axis: usize,
    counts: &dyn Fn(&StripRow) -> bool,
) -> Vec<ContactLine> {
    let Some(rows) = Rows::new(scene, state, pair, axis) else {
        return Vec::new();
    };
    let mut runs = rows.runs(scene, state, pair);
    runs.sort_by(|a, b| a.across.total_cmp(&b.across));
    let mut lines: Vec<Vec<PressingRun>> = Vec::new();
    for run in runs {
        let last = lines.last().and_then(|line| line.last());
        let joins = last.is_some_and(|l| 2.0 * (run.across - l.across) <= run.width + l.width);
        match lines.last_mut().filter(|_| joins) {
            Some(line) => line.push(run),
            None => lines.push(vec![run]),
        }
    }
    (lines.iter())
        .filter_map(|runs| rows.line(scene, state, pair, runs, counts))
        .collect()
}

/// The axis across lines along `axis` of surfaces that face the load; `None` where they run along
/// the load.
pub fn across(scene: &Scene, axis: usize) -> Option<usize> {
    let facing = upright(scene);
    (0..3).find(|i| *i != axis && *i != facing && axis != facing)
}

/// The nodes of a carrier surface in rows.
struct Rows {
    axis: usize,
    across: usize,
    /// Coordinate along the axis of each row, and the length that it stands for.
    at: Vec<f64>,
    length: Vec<f64>,
    /// Places in the contact field of the nodes of each row that face the other side, by their
    /// coordinate across.
    members: Vec<Vec<usize>>,
    /// Coordinates that differ by no more are the same.
    same: f64,
    /// The mirrors that cut both bodies.
    mirrors: Vec<usize>,
}

impl Rows {
    fn new(scene: &Scene, state: &State, pair: usize, axis: usize) -> Option<Self> {
        const FEWEST: usize = 3;
        /// Nodes that press all around, as those of a bush, have no order across; a row that is steeper than 70 degrees counts as such.
        const STEEPEST: f64 = 3.0;
        scene.carrier(pair)?;
        let across = across(scene, axis)?;
        let field = state.contacts.get(pair)?;
        let nodes = &field.nodes;
        let point = |i: usize| scene.mesh.points[nodes[i] as usize];
        let mut order: Vec<usize> = (0..nodes.len()).collect();
        order.sort_by(|a, b| point(*a)[axis].total_cmp(&point(*b)[axis]));
        let (first, last) = (point(*order.first()?)[axis], point(*order.last()?)[axis]);
        let same = 1e-6 * (last - first);
        let (mut at, mut members): (Vec<f64>, Vec<Vec<usize>>) = (Vec::new(), Vec::new());
        for i in order {
            let here = point(i)[axis];
            match members.last_mut() {
                Some(row) if at.last().is_some_and(|a| here - a <= same) => row.push(i),
                _ => {
                    at.push(here);
                    members.push(vec![i]);
                }
            }
        }
        if at.len() < 2 || members.iter().any(|row| row.len() < FEWEST) {
            return None;
        }
        for row in &mut members {
            // A roller's surface goes all the way round.
            row.retain(|i| field.gap[*i].is_finite());
            row.sort_by(|a, b| point(*a)[across].total_cmp(&point(*b)[across]));
        }
        let goes_back = |row: &Vec<usize>| {
            let mut pressing = row
                .iter()
                .filter(|i| field.is_active(**i))
                .map(|i| point(*i));
            let Some(mut last) = pressing.next() else {
                return false;
            };
            let (mut way, mut forward) = (0.0, 0.0);
            for next in pressing {
                let step = sub(next, last);
                (way, forward, last) = (way + norm(step), forward + step[across], next);
            }
            way > STEEPEST * forward
        };
        if members.iter().any(goes_back) {
            return None;
        }
        Some(Self {
            axis,
            across,
            length: lengths(&at),
            at,
            members,
            same,
            mirrors: cutting_pair(scene, pair),
        })
    }

    fn runs(&self, scene: &Scene, state: &State, pair: usize) -> Vec<PressingRun> {
        let field = &state.contacts[pair];
        let across = |i: usize| scene.mesh.points[field.nodes[i] as usize][self.across];
        let mirrored = scene.mirrors.contains(&self.across);
        let mut runs = Vec::new();
        for (row, members) in self.members.iter().enumerate() {
            let presses = |k: &usize| field.is_active(members[*k]);
            let mut next = 0;
            while let Some(first) = (next..members.len()).find(presses) {
                let after = (first..members.len()).find(|k| !presses(k));
                let after = after.unwrap_or(members.len());
                let run = &members[first..after];
                let force = |i: &usize| field.multiplier[*i] * field.area[*i];
                let total: f64 = run.iter().map(force).sum();
                let area: f64 = run.iter().map(|i| field.area[*i]).sum();
                let moment: f64 = run.iter().map(|i| force(i) * across(*i)).sum();
                let cut = mirrored && across(run[0]).abs() <= self.same;
                runs.push(PressingRun {
                    row,
                    nodes: first..after,
                    across: if cut { 0.0 } else { moment / total },
                    width: area / self.length[row],
                    force: if cut { 2.0 * total } else { total },
                    mirrored: cut,
                });
                next = after;
            }
        }
        runs
    }

    /// The nodes of a run, and the open ones on either side, at which the pressure falls to zero.
    fn strip(&self, scene: &Scene, state: &State, pair: usize, run: &PressingRun) -> StripRow {
        let field = &state.contacts[pair];
        let members = &self.members[run.row];
        let from = run.nodes.start.saturating_sub(1);
        let to = (run.nodes.end + 1).min(members.len());
        let mut arc = 0.0;
        let mut before: Option<[f64; 3]> = None;
        let mut places = Vec::new();
        let mut nodes = Vec::new();
        for i in &members[from..to] {
            let at = scene.mesh.points[field.nodes[*i] as usize];
            arc += before.map_or(0.0, |before| norm(sub(at, before)));
            before = Some(at);
            places.push(at);
            nodes.push((arc, field.multiplier[*i].max(0.0)));
        }
        let mut moments = [0.0; 3];
        for pair in nodes.windows(2) {
            let ((a, p), (b, q)) = (pair[0], pair[1]);
            let (middle, mean) = (0.5 * (a + b), 0.5 * (p + q));
            // Simpson's rule is exact up to the third power.
            for (power, moment) in (0..).zip(&mut moments) {
                let of = |p: f64, x: f64| p * f64::powi(x, power);
                *moment += (b - a) / 6.0 * (of(p, a) + 4.0 * of(mean, middle) + of(q, b));
            }
        }
        let [force, first, second] = moments;
        let centre = match run.mirrored || force <= 0.0 {
            true => 0.0,
            false => first / force,
        };
        let next = nodes
            .partition_point(|(s, _)| *s < centre)
            .max(1)
            .min(nodes.len() - 1);
        let share = match nodes.get(next) {
            Some(end) if nodes.len() > 1 => {
                (centre - nodes[next - 1].0) / (end.0 - nodes[next - 1].0)
            }
            _ => 0.0,
        };
        let (low, high) = (places[next.saturating_sub(1)], places[next]);
        StripRow {
            row: run.row,
            at: self.at[run.row],
            half_width: 2.0 * (second / force - centre * centre).max(0.0).sqrt(),
            centre: [0, 1, 2].map(|k| low[k] + share * (high[k] - low[k])),
            nodes: nodes.iter().map(|(s, c)| (s - centre, *c)).collect(),
            mirrored: run.mirrored,
        }
    }

    fn line(
        &self,
        scene: &Scene,
        state: &State,
        pair: usize,
        runs: &[PressingRun],
        counts: &dyn Fn(&StripRow) -> bool,
    ) -> Option<ContactLine> {
        // Where a mirror cuts a line in some rows only, those beside it in the others have an image that belongs to it.
        let cut = runs.iter().any(|r| r.mirrored);
        let force = |run: &PressingRun| match cut && !run.mirrored {
            true => 2.0 * run.force,
            false => run.force,
        };
        let per_length = |run: &PressingRun| force(run) / self.length[run.row];
        let mut load = vec![0.0; self.at.len()];
        for run in runs {
            load[run.row] += per_length(run);
        }
        let mut heaviest_first: Vec<&PressingRun> = runs.iter().collect();
        heaviest_first.sort_by(|a, b| per_length(b).total_cmp(&per_length(a)));
        let heaviest = (heaviest_first.iter())
            .map(|run| self.strip(scene, state, pair, run))
            .find(counts)?;
        let total: f64 = runs.iter().map(force).sum();
        let carries = (load.iter().zip(&self.length)).filter(|(load, _)| **load > 0.0);
        let length: f64 = carries.map(|(_, length)| length).sum();
        let doubled = |axis: usize| if self.mirrors.contains(&axis) { 2 } else { 1 };
        Some(ContactLine {
            across: runs.iter().map(|r| force(r) * r.across).sum::<f64>() / total,
            at: self.at.clone(),
            load,
            length: length * doubled(self.axis) as f64,
            lifted_off: (self.length.iter().sum::<f64>() - length) * doubled(self.axis) as f64,
            images: if cut { 1 } else { doubled(self.across) },
            heaviest,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(at: [f64; 3], load: [f64; 3]) -> ContactLine {
        ContactLine {
            across: 0.0,
            at: at.to_vec(),
            load: load.to_vec(),
            length: at[2] - at[0],
            lifted_off: 0.0,
            images: 1,
            heaviest: StripRow {
                row: 1,
                ..StripRow::default()
            },
        }
    }

    #[test]
    fn a_mean_load_is_that_of_the_row_where_loads_rise_evenly() {
        let even = line([0.0, 1.0, 4.0], [10.0, 12.0, 18.0]);
        assert!((even.heaviest_mean_load() - 12.0).abs() < 1e-12);
        // Loads of 30 that alternate by 3 on both sides: two thirds of that are gone.
        let alternating = line([0.0, 1.0, 2.0], [27.0, 33.0, 27.0]);
        assert!((alternating.heaviest_mean_load() - 31.0).abs() < 1e-12);
    }
}
