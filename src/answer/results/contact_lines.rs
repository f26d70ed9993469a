//! The lines along which a roller presses: the load of each, where it carries and where it lifts off.

use super::contact_line::{ContactLine, lengths};
use super::line_frame::{LineFrame, is_mirrored};
use super::load::cutting_pair;
use super::rows::NodeRows;
use super::strip_row::StripRow;
use super::symmetry_planes::{End, SymmetryPlanes};
use crate::ground::geometry::{dot, norm, range, sub};
use crate::model::scene::Scene;
use crate::model::state::State;
use std::ops::Range;

/// Adjacent nodes of a row that press.
struct PressingRun {
    row: usize,
    /// Its nodes, among the members of the row.
    nodes: Range<usize>,
    /// Mean coordinate across, and the width that the run stands for.
    across: f64,
    width: f64,
    force: f64,
    /// The end at which it reaches a plane of symmetry, if it does.
    cut: Option<End>,
}

/// The lines of contact pair `pair` along `frame`, by their place across; empty where the carrier's
/// nodes do not stand in rows (a row has three nodes or more) or nothing presses.
pub fn contact_lines(
    scene: &Scene,
    state: &State,
    pair: usize,
    frame: &LineFrame,
) -> Vec<ContactLine> {
    contact_lines_by(scene, state, pair, frame, &|_| true)
}

/// The same, the heaviest row of each among those that count; empty where none does.
pub(super) fn contact_lines_by(
    scene: &Scene,
    state: &State,
    pair: usize,
    frame: &LineFrame,
    counts: &dyn Fn(&StripRow) -> bool,
) -> Vec<ContactLine> {
    let Some(rows) = Rows::new(scene, state, pair, frame) else {
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
    // One open node between them may be the mesh's.
    let is_beside = |one: &PressingRun, other: &PressingRun| {
        one.row == other.row
            && (one.nodes.end + 1 == other.nodes.start || other.nodes.end + 1 == one.nodes.start)
    };
    let of_one = |index: usize| {
        let mut line = rows.line(scene, state, pair, &lines[index], counts)?;
        let others = (0..lines.len()).filter(|other| *other != index);
        let mut others = others.flat_map(|other| &lines[other]);
        line.is_parted = others.any(|run| lines[index].iter().any(|own| is_beside(own, run)));
        Some(line)
    };
    (0..lines.len()).filter_map(of_one).collect()
}

/// Of a row, the nodes on the side of its middle by `height` that those `pressing` are on; `None` where they are on both.
fn side_of(row: &[usize], pressing: &[usize], height: impl Fn(usize) -> f64) -> Option<Vec<usize>> {
    let [low, high] = range(row.iter().map(|i| height(*i)));
    let is_above = |i: &usize| height(*i) > 0.5 * (low + high);
    let side = pressing.first().is_some_and(&is_above);
    let is_one = pressing.iter().all(|i| is_above(i) == side);
    let own = row.iter().copied().filter(|i| is_above(i) == side);
    is_one.then(|| own.collect())
}

/// The nodes of a carrier surface in rows.
struct Rows {
    frame: LineFrame,
    /// Coordinate along the axis of each row, and the length that it stands for.
    at: Vec<f64>,
    length: Vec<f64>,
    /// Places in the contact field of the nodes of each row that face the other side, by their
    /// coordinate across.
    members: Vec<Vec<usize>>,
    /// The mirrors that cut both bodies.
    mirrors: Vec<usize>,
    /// The planes of symmetry across at which they end.
    planes: SymmetryPlanes,
}

impl Rows {
    fn new(scene: &Scene, state: &State, pair: usize, frame: &LineFrame) -> Option<Self> {
        /// Nodes that press all around, as those of a bush, have no order across; a row that is steeper than 70 degrees counts as such.
        const STEEPEST: f64 = 3.0;
        scene.carrier(pair)?;
        let field = state.contacts.get(pair)?;
        let nodes = &field.nodes;
        let point = |i: usize| scene.mesh.points[nodes[i] as usize];
        let across = |i: usize| frame.across(&point(i));
        let along: Vec<f64> = (0..nodes.len()).map(|i| frame.along(&point(i))).collect();
        let NodeRows { at, mut members } = NodeRows::of(&along)?;
        for row in &mut members {
            // A roller's surface goes all the way round.
            row.retain(|i| field.gap[*i].is_finite());
            row.sort_by(|a, b| across(*a).total_cmp(&across(*b)));
        }
        let goes_back = |row: &[usize]| {
            let steps = row
                .windows(2)
                .map(|ends| sub(point(ends[1]), point(ends[0])));
            let (way, forward) = steps.fold((0.0, 0.0), |(way, forward), step| {
                (way + norm(step), forward + frame.across(&step))
            });
            way > STEEPEST * forward
        };
        // A quarter, or a half, of what presses all around. A row may lie in a mirror, too.
        let between_mirrors = |row: &[usize]| {
            let mirrors = |i: usize| scene.mirrors_through(&point(i)).collect::<Vec<_>>();
            let [first, .., last] = row else { return false };
            let of_row = mirrors(row[row.len() / 2]);
            let ends_in_one = |end: &usize| mirrors(*end).iter().any(|m| !of_row.contains(m));
            ends_in_one(first) && ends_in_one(last)
        };
        for row in &mut members {
            let is_active = |i: &usize| field.is_active(*i);
            let pressing: Vec<usize> = row.iter().copied().filter(is_active).collect();
            if goes_back(&pressing) || between_mirrors(&pressing) {
                return None;
            }
            // So does a pin's, and faces its hole all the way: what lies across from where it presses belongs to no row there.
            if goes_back(row) {
                *row = side_of(row, &pressing, |i| dot(frame.up, point(i)))?;
            }
        }
        Some(Self {
            frame: *frame,
            length: lengths(&at),
            at,
            members,
            mirrors: cutting_pair(scene, pair),
            planes: SymmetryPlanes::square_to(scene, pair, &frame.across),
        })
    }

    fn runs(&self, scene: &Scene, state: &State, pair: usize) -> Vec<PressingRun> {
        let field = &state.contacts[pair];
        let across = |i: usize| {
            self.frame
                .across(&scene.mesh.points[field.nodes[i] as usize])
        };
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
                let cut = self.planes.cut(across(run[0]), across(run[run.len() - 1]));
                runs.push(PressingRun {
                    row,
                    nodes: first..after,
                    across: cut.map_or(moment / total, |(_, at)| at),
                    width: area / self.length[row],
                    force: if cut.is_some() { 2.0 * total } else { total },
                    cut: cut.map(|(end, _)| end),
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
        // From the plane that cuts it outwards.
        let mut outwards: Vec<usize> = members[from..to].to_vec();
        if run.cut == Some(End::High) {
            outwards.reverse();
        }
        for i in &outwards {
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
        let centre = match run.cut.is_some() || force <= 0.0 {
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
            mirrored: run.cut.is_some(),
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
        // Where a plane of symmetry cuts a line in some rows only, those beside it in the others have an image that belongs to it.
        let cut = runs.iter().any(|r| r.cut.is_some());
        let force = |run: &PressingRun| match cut && run.cut.is_none() {
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
        let doubled = |direction| {
            if is_mirrored(direction, &self.mirrors) {
                2
            } else {
                1
            }
        };
        Some(ContactLine {
            across: runs.iter().map(|r| force(r) * r.across).sum::<f64>() / total,
            at: self.at.clone(),
            load,
            length: length * doubled(&self.frame.along) as f64,
            lifted_off: (self.length.iter().sum::<f64>() - length)
                * doubled(&self.frame.along) as f64,
            images: if cut { 1 } else { doubled(&self.frame.across) },
            is_parted: false,
            heaviest,
        })
    }
}
