//! Hertz's line contact under the largest load per length that a line of contact carries.
//!
//! A line load is known far better than the pressure that makes it: it follows from balance and from
//! how the bodies bend, not from the few nodes across a strip. Where the strip is Hertzian the closed
//! form turns it into the pressure.

use super::below::{flows_below, is_layered};
use super::contact_line::ContactLine;
use super::contact_lines::{contact_lines, contact_lines_by};
use super::edges::LoadedEdges;
use super::line_direction::line_frame;
use super::line_frame::{LineFrame, is_mirrored};
use super::strip_row::StripRow;
use super::strip_sides::StripSides;
use crate::analytic::hertz::LineContact;
use crate::model::scene::{ContactPair, Scene};
use crate::model::state::State;

/// The line of a pair that carries most per length, and what Hertz says of it.
#[derive(Debug, Clone, PartialEq)]
pub struct HeaviestLine {
    /// The line.
    pub line: ContactLine,
    /// The directions along and across it.
    pub frame: LineFrame,
    /// Its largest load per length.
    pub line_load: f64,
    /// Share by which that load stands out from the straight line between the rows beside it.
    pub kink: f64,
    /// Share by which another row away from loaded edges would carry more, if it stood out as far to the other side of
    /// the straight line between the rows beside it; 0 where none would.
    pub hidden: f64,
    /// Share by which the load of its row alone differs from that: away from an edge it is a mean over the rows beside it.
    pub alternates: f64,
    /// Hertz's contact under that load, of bodies with the curvature that they have there; `None`
    /// where a surface has no curvature that is known, or the two do not curve apart.
    pub contact: Option<LineContact>,
    /// Why the strip is not Hertz's, if it is not.
    pub departs: Option<Departure>,
    /// The lines of the pair beside it.
    pub others: Vec<ContactLine>,
    /// Does a plane of symmetry mirror them all across?
    pub is_mirrored: bool,
    /// See [`Self::away`].
    away: Option<Box<Self>>,
}

/// Why a strip is not Hertz's.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Departure {
    /// It carries up to an edge of a surface.
    LoadedEdge,
    /// Steel flows below it.
    Flow,
    /// It is wider or narrower than its load makes it: lines that merge, or shapes that are no lines.
    Width,
    /// It is wide beside the radii of its surfaces, as of a pin in a hole: these are no half spaces to it.
    Conformal,
    /// Another material is joined to a body just below it, as a coat to its base.
    Layered,
    /// The load changes from row to row: the shape does, too.
    Kink,
}

impl Departure {
    /// Are the bodies below the strip as half spaces to it all the same?
    pub fn keeps_half_spaces(self) -> bool {
        !matches!(self, Self::Conformal | Self::Layered)
    }

    /// The reason, of a strip.
    pub fn in_words(self) -> &'static str {
        match self {
            Self::LoadedEdge => "it carries up to an edge",
            Self::Flow => "steel flows below it",
            Self::Width => "it is wider or narrower than its load makes it",
            Self::Conformal => "it is wide beside the radii of its surfaces",
            Self::Layered => "another material lies just below it",
            Self::Kink => "its load changes from row to row",
        }
    }
}

/// Of a strip that is cut, see [`HeaviestLine::is_half`].
pub const HALF_STRIP: &str = "it presses most where the surface ends, as half of a strip does: if that is a plane of symmetry, name it in \
                              `symmetry` or hold all nodes there, of both bodies, square to it, or its load per length counts half and p0 is too small by a root of two";

/// Lines whose middles are nearer than this share of both half-widths press as one. Two that just touch are each
/// still Hertz's within the errors of a line load (`cases/coverage/solid-heavy.toml`).
const MERGED: f64 = 0.9;

impl HeaviestLine {
    /// That of every contact pair, in their order; `None` where a pair has no lines.
    pub fn of_pairs(scene: &Scene, state: &State, edges: &LoadedEdges) -> Vec<Option<Self>> {
        let find = |pair| Self::find(scene, state, pair, edges);
        (0..scene.contacts.len()).map(find).collect()
    }

    /// The line of contact pair `pair` that carries most; `None` where there are no lines.
    pub fn find(scene: &Scene, state: &State, pair: usize, edges: &LoadedEdges) -> Option<Self> {
        let frame = line_frame(scene, pair)?;
        let heaviest = |lines: &[ContactLine], load: fn(&ContactLine) -> f64| {
            Self::heaviest(scene, state, (pair, &frame), edges, lines, load)
        };
        let all = contact_lines(scene, state, pair, &frame);
        let mut line = heaviest(&all, ContactLine::heaviest_load)?;
        if line.departs == Some(Departure::LoadedEdge) {
            let is_away = |row: &StripRow| !edges.are_near(&row.centre);
            let away = contact_lines_by(scene, state, pair, &frame, &is_away);
            line.away = heaviest(&away, ContactLine::heaviest_mean_load).map(Box::new);
        }
        Some(line)
    }

    /// That of some lines along `frame`, by their load as it is to be read.
    fn heaviest(
        scene: &Scene,
        state: &State,
        (pair, frame): (usize, &LineFrame),
        edges: &LoadedEdges,
        lines: &[ContactLine],
        load: fn(&ContactLine) -> f64,
    ) -> Option<Self> {
        let loaded = lines.iter().map(|line| (load(line), line));
        let (line_load, line) = loaded.max_by(|a, b| a.0.total_cmp(&b.0))?;
        let mirrored = is_mirrored(&frame.across, &scene.mirrors);
        let apart = distance_to_the_next(line, lines, mirrored);
        let contact = scene.contacts.get(pair)?;
        let row = &line.heaviest;
        let sides = StripSides::of(scene, contact, (frame, row));
        let hertz = sides.under(scene, contact, line_load);
        let rows = RowsBeside { line, frame, edges };
        let kink = rows.kink(row.row);
        let departs = match hertz {
            Some(hertz) if apart < MERGED * 2.0 * hertz.half_width => Some(Departure::Width),
            Some(hertz) if sides.are_split(&hertz) => Some(Departure::Width),
            Some(hertz) if sides.are_conformal(&hertz) => Some(Departure::Conformal),
            Some(hertz) if is_layered(scene, contact, (row.centre, hertz.half_width)) => {
                Some(Departure::Layered)
            }
            Some(hertz) => departure(scene, state, (contact, edges), line, (&hertz, kink)),
            // Of a flat punch that is all that can be said.
            None => (edges.are_near(&row.centre)).then_some(Departure::LoadedEdge),
        };
        Some(Self {
            line_load,
            kink,
            hidden: rows.hidden(),
            contact: hertz,
            departs,
            frame: *frame,
            alternates: (line.heaviest_load() / line_load - 1.0).abs(),
            line: line.clone(),
            others: lines
                .iter()
                .filter(|other| other.across != line.across)
                .cloned()
                .collect(),
            is_mirrored: mirrored,
            away: None,
        })
    }

    /// Where its heaviest row is at a loaded edge: the line that carries most away from such edges.
    pub fn away(&self) -> Option<&Self> {
        self.away.as_deref()
    }

    /// See [`ContactLine::is_long`].
    pub fn is_long(&self) -> bool {
        self.line.is_long()
    }

    /// Hertz's contact of a long line between sides that are as half spaces to it, whatever else departs.
    pub fn strip(&self) -> Option<LineContact> {
        let is_half_space = self.departs.is_none_or(Departure::keeps_half_spaces);
        self.contact.filter(|_| self.is_long() && is_half_space)
    }

    /// Is it the half of a strip? It presses most where a surface ends, and yet no edge is loaded there: neither `symmetry` nor supports
    /// of all nodes there say that it is cut. The whole strip carries twice its load.
    pub fn is_half(&self) -> bool {
        let is_loaded_edge = self.departs == Some(Departure::LoadedEdge);
        self.contact.is_some() && !is_loaded_edge && self.line.heaviest.is_cut()
    }

    /// Why the strip is not Hertz's, in words; `None` where it is, and where it has no closed form at all.
    pub fn not_hertz(&self) -> Option<&'static str> {
        self.contact?;
        if self.is_half() {
            return Some(HALF_STRIP);
        }
        match self.departs {
            Some(departure) => Some(departure.in_words()),
            None => (!self.is_long()).then_some("it is no longer than three widths"),
        }
    }

    /// Hertz's pressure under the largest line load; `None` where the strip is not Hertz's.
    pub fn pressure(&self) -> Option<f64> {
        let contact = self
            .contact
            .filter(|_| self.departs.is_none() && self.is_long() && !self.is_half())?;
        Some(contact.peak_pressure)
    }
}

/// From the middle of a line to that of the nearest one beside it, its own mirror image included.
fn distance_to_the_next(line: &ContactLine, lines: &[ContactLine], mirrored: bool) -> f64 {
    let others = lines.iter().filter(|other| other.across != line.across);
    let images = lines.iter().filter(|_| mirrored).map(|other| -other.across);
    let images = images.filter(|_| line.images > 1);
    let beside = others.map(|other| other.across).chain(images);
    beside
        .map(|across| (across - line.across).abs())
        .fold(f64::INFINITY, f64::min)
}

/// The rows of a line, each with those beside it.
struct RowsBeside<'a> {
    line: &'a ContactLine,
    frame: &'a LineFrame,
    edges: &'a LoadedEdges,
}

impl RowsBeside<'_> {
    /// By how much the load per length of a row stands out, relative to itself, from the rows on either side. Where a
    /// loaded edge is beside it, that says nothing of a row that is away from it, unless it is all that there is.
    fn kink(&self, row: usize) -> f64 {
        let (at, load) = (&self.line.at, &self.line.load);
        let counts = |beside: &usize| self.is_at_edge(row) || !self.is_at_edge(*beside);
        let after = Some(row + 1).filter(|after| *after < at.len());
        let all = [row.checked_sub(1), after];
        let away = all.map(|beside| beside.filter(counts));
        let beside = if away == [None; 2] { all } else { away };
        let [before, after] = beside.map(|row| row.map(|row| (at[row], load[row])));
        let straight = match (before, after) {
            (Some((a, p)), Some((b, q))) => p + (q - p) * (at[row] - a) / (b - a),
            (Some((_, p)), None) | (None, Some((_, p))) => p,
            (None, None) => return 0.0,
        };
        ((load[row] - straight) / load[row]).abs()
    }

    /// See [`HeaviestLine::hidden`].
    fn hidden(&self) -> f64 {
        let load = &self.line.load;
        let heaviest = self.line.heaviest.row;
        let others = (0..load.len()).filter(|row| *row != heaviest && load[*row] > 0.0);
        let away = others.filter(|row| !self.is_at_edge(*row));
        away.map(|row| load[row] * (1.0 + self.kink(row)) / load[heaviest] - 1.0)
            .fold(0.0, f64::max)
    }

    fn is_at_edge(&self, row: usize) -> bool {
        let line = self.line;
        let centre = self.frame.moved(line.heaviest.centre, line.at[row]);
        self.edges.are_near(&centre)
    }
}

fn departure(
    scene: &Scene,
    state: &State,
    (pair, edges): (&ContactPair, &LoadedEdges),
    line: &ContactLine,
    (hertz, kink): (&LineContact, f64),
) -> Option<Departure> {
    /// The largest shares by which width and load may be off.
    const WIDTH: f64 = 0.15;
    const KINK: f64 = 0.1;
    let row = &line.heaviest;
    let a = hertz.half_width;
    if edges.are_near(&row.centre) {
        return Some(Departure::LoadedEdge);
    }
    let flow = || flows_below(scene, state, pair, (row.centre, a)).then_some(Departure::Flow);
    let spacing = row.edge_spacing() / a;
    if (row.half_width / a - 1.0).abs() > WIDTH + 0.5 * spacing * spacing {
        // Steel that flows makes a strip wider, until it presses as an indenter does.
        let wider =
            row.half_width > a && mean_pressure(line) > FLOW_BEGINS * scene.yield_stress(pair);
        return flow().filter(|_| wider).or(Some(Departure::Width));
    }
    if kink > KINK {
        return Some(Departure::Kink);
    }
    flow()
}

/// Mean pressure below a strip over the yield stress, where flow begins: π/4 of p0 = 1.79 Y (Johnson, Contact
/// Mechanics, section 6.1). It only grows from there; elastic lines that merge press less, and where they flow into one
/// strip its load is one, too.
const FLOW_BEGINS: f64 = 1.4;

/// Mean pressure of the heaviest row of a line.
fn mean_pressure(line: &ContactLine) -> f64 {
    line.heaviest_load() / (2.0 * line.heaviest.half_width)
}
