//! Line load and width of a line of contact, and Hertz's pressure under that load.
//!
//! Where contact is a line, the load per length is known better than anything else, for it follows
//! from balance.

use super::contact::Contact;
use super::figure::{Figure, Quantity, figure};
use super::notes::{COARSE, FILLET};
use crate::answer::results::contact_line::ContactLine;
use crate::answer::results::hertz::{Departure, HALF_STRIP, HeaviestLine};
use crate::answer::results::strip_row::StripRow;

const MERGED: &str = "the strip is wider or narrower than its load makes it: lines that the mesh does not tell \
                      apart, or a shape that is no line";
const PARTED: &str = "one open node parts it from another line of the pair: whether they are one belongs to the mesh";

/// A load per length is this good at best: far field, and rows along the line. Half a per cent in the median
/// of bearings drawn by a seed, two in one of ten.
const LINE_LOAD: f64 = 0.014;
/// What a strip that the mesh is too coarse for moves of it along the line and to the line beside it, for each
/// power of e by which the spacing exceeds [`WELL`] of the half-width: bodies come too close below it by such a
/// logarithm (Johnson, Contact Mechanics, section 5.6). On single bearings 0.02 to 0.05; with this, line loads on `h025` err by
/// at most 0.75 to 0.94 of their bars in 95 of 100 cases of three seeds.
const UNSEEN: f64 = 0.025;
/// Spacing over half-width up to which that is nothing.
const WELL: f64 = 0.67;
/// Beside a loaded edge, and next to what belongs to it, in addition.
const BESIDE_EDGE: f64 = 0.02;
/// Share of the kink at the peak of a line load that is its error,
const KINK: f64 = 0.2;
/// and beside a loaded edge, where loads rise with a power of the distance and the last rows of the mesh cut that off.
const KINK_AT_EDGE: f64 = 0.5;
/// Share of what rows elsewhere on a line hide that the error of its largest load is at least. Where loads alternate from row
/// to row, the largest may be another one (docs/coverage.md).
const HIDDEN: f64 = 0.3;
/// Share of what a row alone differs from the mean with those beside it that is the error of that mean.
const ALTERNATES: f64 = 0.5;
/// Error of the largest load per length over the error of the travel, beyond [`TRAVEL`], and over the share of that load that statics
/// does not ask for there: bodies that bend make both. (Of 24 hollow rollers with walls of 0.06 to 0.3 D, drawn by a seed, 4 of 36 line
/// loads are outside on `auto`, two of them at a loaded edge, and none of 28 on `h0125`; beyond 3 % of the travel 8 of 34.)
const BEND: f64 = 3.5;
/// Relative error of a travel that strips and what is around them leave of it.
const TRAVEL: f64 = 0.02;
/// Error of a half-width, of itself, for a spacing of a at the edge; it falls with the square of the spacing.
const WIDTH: f64 = 0.03;

impl Contact<'_> {
    /// Of the line that carries most; where a fillet that the mesh hides decides that, away from it, too.
    pub(super) fn along(&self, line: &HeaviestLine) -> Vec<Figure> {
        // A patch has no load per length: that of its longest row depends on the mesh.
        if !line.is_long() {
            return Vec::new();
        }
        let mut claims = vec![self.line_load(Quantity::LineLoad, line)];
        claims.extend(self.half_width(line));
        claims.push(self.length(line));
        claims.extend(self.hertz_pressure(line));
        if let Some(away) = line.away().filter(|_| self.hides_load(line)) {
            claims.push(self.line_load(Quantity::LineLoadAway, away));
        }
        claims
    }

    /// Where the mesh hides what presses there it hides what that carries, too.
    fn hides_load(&self, line: &HeaviestLine) -> bool {
        line.departs == Some(Departure::LoadedEdge) && self.edges.unseen_pressure(self.pair) > 0.0
    }

    fn line_load(&self, what: Quantity, line: &HeaviestLine) -> Figure {
        let at_edge = line.departs == Some(Departure::LoadedEdge);
        // The row that carries most away from an edge is next to it.
        let beside = if what == Quantity::LineLoadAway {
            BESIDE_EDGE
        } else {
            0.0
        };
        let (error, why) = match line.departs {
            _ if line.is_half() => (None, HALF_STRIP),
            Some(Departure::Width) => (None, MERGED),
            _ if line.contact.is_none() && line.line.is_parted => (None, PARTED),
            _ if self.hides_load(line) => (None, FILLET),
            _ => (Some(self.load_error(line) + beside), COARSE),
        };
        Figure {
            at_edge,
            ..self.claim(what, line.line_load, error, why)
        }
    }

    /// `None` where the strip is not Hertz's.
    fn hertz_pressure(&self, line: &HeaviestLine) -> Option<Figure> {
        let value = line.pressure()?;
        Some(self.claim(
            Quantity::HertzPressure,
            value,
            Some(0.5 * self.load_error(line)),
            COARSE,
        ))
    }

    /// Relative error of the largest load per length; Hertz's pressure and half-width go with its root.
    pub(super) fn load_error(&self, line: &HeaviestLine) -> f64 {
        let edge = match line.departs {
            Some(Departure::LoadedEdge) => BESIDE_EDGE + KINK_AT_EDGE * line.kink,
            _ => KINK * line.kink,
        };
        let own = coarseness(&line.line.heaviest) * LINE_LOAD + unseen(line) + edge;
        own.max(HIDDEN * line.hidden)
            + ALTERNATES * line.alternates
            + self.too_stiff
            + spread_otherwise(line, self.travel_off)
    }

    /// `None` where no curvature is known: it is read as of a pressure that is half an ellipse, and a flat face that presses evenly is
    /// narrower by √3/2.
    fn half_width(&self, line: &HeaviestLine) -> Option<Figure> {
        let hertz = line.contact?;
        let row = &line.line.heaviest;
        let a = row.half_width;
        let edge = row.edge_spacing() / a;
        let (error, why) = match line.departs {
            None | Some(Departure::LoadedEdge) => {
                let spacing = WIDTH * edge * edge;
                let off = (hertz.half_width / a - 1.0).abs();
                (Some(off + spacing + 0.5 * self.load_error(line)), COARSE)
            }
            Some(Departure::Width) => (None, MERGED),
            Some(_) => (Some(0.5 * edge * edge + self.load_error(line)), COARSE),
        };
        Some(self.claim(Quantity::HalfWidth, a, error, why))
    }

    /// Where a line lifts off, the place lies between two rows, or beyond the next one: loads near it are small.
    fn length(&self, line: &HeaviestLine) -> Figure {
        let unseen = if line.line.lifted_off > 0.0 {
            unseen(line)
        } else {
            0.0
        };
        let line = &line.line;
        let rows = line.at.windows(2).zip(line.load.windows(2));
        let lifts = rows.filter(|(_, q)| (q[0] > 0.0) != (q[1] > 0.0));
        let off: f64 = lifts.map(|(at, _)| at[1] - at[0]).sum();
        let off = off + faint_ends(line);
        let images = if line.length > 0.0 {
            line.length_share()
        } else {
            1.0
        };
        self.claim(
            Quantity::ContactLength,
            line.length,
            Some(images * off / line.length + unseen + 1e-6),
            COARSE,
        )
    }
}

/// Distance to the next row of the rows at the ends of a line that carry next to nothing: a finer mesh may have them open.
fn faint_ends(line: &ContactLine) -> f64 {
    /// Of the largest load per length. (Of lines whose end carries 0.7 and 2.8 % a finer mesh was open there.)
    const FAINT: f64 = 0.05;
    let (at, load) = (&line.at, &line.load);
    let most = FAINT * line.heaviest_load();
    let is_faint = |row: usize| load[row] > 0.0 && load[row] < most;
    let last = at.len().saturating_sub(1);
    let ends = [(0, 1), (last, last.saturating_sub(1))];
    let faint = ends
        .into_iter()
        .filter(|(end, _)| last > 1 && is_faint(*end));
    faint.map(|(end, next)| (at[end] - at[next]).abs()).sum()
}

/// What a mesh this fine leaves of errors that do not fall with the square of its spacing: all of them down to
/// three nodes in a half-width.
pub(super) fn coarseness(row: &StripRow) -> f64 {
    const FINE: f64 = 3.0;
    (FINE * row.spacing() / row.half_width).min(1.0)
}

/// Of the distance of nodes, how far from the middle of a strip its force may act where one row of them carries all.
const ONE_ROW: f64 = 0.5;

/// Of that, what is left with two nodes and more to a half-width: shears of a small turn of a plate, 1e-4 of the load,
/// were found off by half of it.
const WELL_PLACED: f64 = 0.05;

/// Angle that a body may be turned by as few nodes do not say where in a strip its force acts: a surface of the radius R turns by
/// x/R where its force moves by x.
pub(super) fn turned_by_place(line: &HeaviestLine) -> f64 {
    line.contact.map_or(0.0, |hertz| {
        let spacing = line.line.heaviest.middle_spacing();
        let unplaced = (2.0 - hertz.half_width / spacing).clamp(WELL_PLACED, 1.0);
        ONE_ROW * unplaced * spacing / hertz.radius
    })
}

/// Relative error of the largest load per length where the travel of the load is `off` by that share of itself, see [`BEND`].
pub(super) fn spread_otherwise(line: &HeaviestLine, off: f64) -> f64 {
    let of_statics = line.line.of_statics().unwrap_or(line.line_load);
    let by_bending = (1.0 - of_statics / line.line_load).max(0.0);
    BEND * (off - TRAVEL).max(0.0) * by_bending
}

/// How far the stress below a strip may be from that of Hertz's under its load, of itself: by that load, of whose error it has half, and
/// by what the largest pressure says of the strip, or, where that is not known, its width. `None` where the load is not known.
///
/// A thin ring flattens above its strip, which is wider then than its radius says.
pub(super) fn strip_off(line: &HeaviestLine, claims: &[Figure], pair: &str) -> Option<f64> {
    let of = |what| figure(claims, what, pair);
    let (line, load, peak) = match (line.away(), of(Quantity::LineLoadAway)) {
        (Some(away), Some(load)) => (away, load, of(Quantity::PressureAway)),
        _ => (line, of(Quantity::LineLoad)?, of(Quantity::PeakPressure)),
    };
    let hertz = line.contact?;
    let peak = peak.and_then(|peak| Some((peak.value, peak.bar()?)));
    let departs = match peak {
        Some((value, bar)) => ((value - hertz.peak_pressure).abs() - bar) / hertz.peak_pressure,
        None => {
            let row = &line.line.heaviest;
            let edge = row.edge_spacing() / row.half_width;
            (hertz.half_width / row.half_width - 1.0).abs() - WIDTH * edge * edge
        }
    };
    Some((0.5 * load.bar()? / load.value).hypot(departs.max(0.0)))
}

/// See [`UNSEEN`].
fn unseen(line: &HeaviestLine) -> f64 {
    let row = &line.line.heaviest;
    let a = (line.contact).map_or(row.half_width, |hertz| hertz.half_width);
    UNSEEN * (row.middle_spacing() / (WELL * a)).ln().max(0.0)
}
