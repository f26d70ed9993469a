//! Figures of contact interfaces.

use super::inputs::AnswerInputs;
use super::named::Named;
use super::patch::PatchFigures;
use crate::answer::results::contact_line::ContactLine;
use crate::answer::results::contact_lines::contact_lines;
use crate::answer::results::hertz::HeaviestLine;
use crate::answer::results::interface::{Interface, StatusCounts};
use crate::answer::results::line_direction::line_frame;
use crate::answer::results::line_frame::{LineFrame, is_mirrored, name_of};
use crate::answer::results::line_load::{LineLoad, Slices, line_load};
use crate::answer::results::load::cutting_pair;
use crate::answer::results::strip_sides::StripSides;
use crate::ground::geometry::Vec3;
use crate::model::scene::Scene;
use serde::Serialize;

/// Line load of an interface.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct LineLoadFigures {
    /// The direction along the carrier body: x, y, z or its components.
    pub axis: String,
    /// Ends of the slices.
    pub edges: Vec<f64>,
    /// Mean force per length of each slice.
    pub values: Vec<f64>,
    /// Each slice stands for two: twice the sum over slices is the load.
    pub mirrored: bool,
    /// Force outside the slices.
    pub outside: f64,
}

/// An interface; forces and areas are those of the whole bearing.
#[derive(Debug, Clone, Default, PartialEq, Serialize, schemars::JsonSchema)]
pub struct InterfaceFigures {
    /// Of the upper side on the lower one.
    pub force: [f64; 3],
    /// Force along the load; positive in compression.
    pub normal_force: f64,
    /// Integral of the pressure over the surface.
    pub pressure_integral: f64,
    /// Largest consistent nodal pressure; compression is positive.
    pub max_pressure: f64,
    /// Where that is, undeformed.
    pub max_pressure_at: Option<[f64; 3]>,
    /// Hertz's pressure under the largest load per length; null where the strip is not Hertz's.
    pub hertz_p0: Option<f64>,
    /// The largest load per length, normal to the surface.
    pub largest_line_load: Option<f64>,
    /// Deepest overlap of the two sides, zero or positive.
    pub max_penetration: f64,
    /// What of it the facets do not explain,
    pub unexplained_penetration: f64,
    /// and where that is, undeformed.
    pub unexplained_penetration_at: Option<[f64; 3]>,
    /// Penetration relative to the shortest side of a face that carries pressure.
    pub penetration_per_element: Option<f64>,
    /// Area in contact.
    pub area: f64,
    /// Half-width of the line that carries most, where its load per length is largest.
    pub half_width: Option<f64>,
    /// Not measured without friction.
    pub max_slip: Option<f64>,
    /// How many nodes are open, stick and slip.
    pub status_counts: StatusCounts,
    /// Force per length, in slices along the carrier.
    pub q: Option<LineLoadFigures>,
    /// Where the force along the load acts, on the undeformed surface of the whole.
    pub centre_of_force: Option<[f64; 3]>,
    /// The lines of contact along the carrier; empty where its nodes do not stand in rows.
    pub lines: Vec<LineFigures>,
    /// Why the strip of the line that carries most is not Hertz's, where it is not.
    pub not_hertz: Option<&'static str>,
    /// Hertz's figures of a contact at a point or over an ellipse; null of lines and of shapes that are not known.
    pub patch: Option<PatchFigures>,
}

/// A line of contact.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct LineFigures {
    /// The direction along which it runs: x, y, z or its components.
    pub axis: String,
    /// The direction across it, square to the load, too.
    pub across_axis: String,
    /// Unit vector along it.
    pub along: Vec3,
    /// Mean coordinate across.
    pub across: f64,
    /// Lines like this one in the whole bearing.
    pub images: usize,
    /// Do its rows stand for those at the opposite coordinates along, too?
    pub mirrored: bool,
    /// Coordinates of the rows of nodes along the line.
    pub at: Vec<f64>,
    /// Force normal to the surface per length, row by row; its integral by the trapezoidal rule is
    /// the force.
    pub load: Vec<f64>,
    /// Largest force per length.
    pub peak: f64,
    /// Coordinate along the line where that is.
    pub peak_at: f64,
    /// Of the strip of pressure where the load is largest.
    pub half_width: f64,
    /// The force of the line, spread evenly over the whole length of the carrier.
    pub mean: f64,
    /// Length in contact, in the whole, and of the carrier that has lifted off.
    pub length: f64,
    /// Length of the carrier that has lifted off.
    pub lifted_off: f64,
    /// Relative radius of curvature across, where the load is largest; null where it is not known, and where the contact
    /// is too short for a line.
    pub relative_radius: Option<f64>,
}

/// Equal parts of a line along which its load is told.
const SLICES: usize = 10;

/// The figures of every interface; `measured` and `lines` are in the order of the contact pairs.
pub fn all(
    solved: &AnswerInputs,
    measured: &[Interface],
    lines: &[Option<HeaviestLine>],
) -> Named<InterfaceFigures> {
    let both = measured.iter().zip(lines).enumerate();
    let of = |(pair, (measured, heaviest)): (usize, (&Interface, &Option<HeaviestLine>))| {
        let figures = interface(solved, pair, (measured, heaviest.as_ref()));
        (measured.name.clone(), figures)
    };
    Named(both.map(of).collect())
}

fn interface(
    solved: &AnswerInputs,
    pair: usize,
    (measured, heaviest): (&Interface, Option<&HeaviestLine>),
) -> InterfaceFigures {
    let (scene, state) = (solved.scene, solved.state);
    let frame = heaviest.map_or_else(|| line_frame(scene, pair), |line| Some(line.frame));
    let slices = (frame.as_ref()).and_then(|f| Slices::along(scene, pair, (f.along, SLICES)));
    let lines = frame.iter().flat_map(|frame| {
        let lines = contact_lines(scene, state, pair, frame).into_iter();
        lines.filter_map(move |line| line_figures(scene, line, (pair, frame)))
    });
    InterfaceFigures {
        force: measured.force,
        normal_force: measured.normal_force,
        pressure_integral: measured.pressure_integral,
        max_pressure: measured.max_pressure,
        max_pressure_at: measured.max_pressure_at,
        hertz_p0: heaviest.and_then(HeaviestLine::pressure),
        largest_line_load: heaviest.map(|h| h.line_load),
        max_penetration: measured.max_penetration,
        unexplained_penetration: measured.unexplained_penetration,
        unexplained_penetration_at: measured.unexplained_at,
        penetration_per_element: measured
            .face_side
            .map(|side| measured.max_penetration / side),
        area: measured.area,
        half_width: heaviest.map(|h| h.line.heaviest.half_width),
        max_slip: (scene.contacts[pair].friction > 0.0).then_some(measured.max_slip),
        status_counts: measured.status_counts,
        q: slices
            .and_then(|s| line_load(scene, state, pair, &s))
            .map(LineLoadFigures::from),
        centre_of_force: measured.centre_of_force,
        lines: lines.collect(),
        not_hertz: heaviest.and_then(HeaviestLine::not_hertz),
        patch: PatchFigures::find(scene, state, pair, measured),
    }
}

fn line_figures(
    scene: &Scene,
    line: ContactLine,
    (pair, frame): (usize, &LineFrame),
) -> Option<LineFigures> {
    let (peak, peak_at) = line.peak()?;
    let contact = scene.contacts.get(pair);
    let contact = contact.filter(|_| line.is_long());
    let hertz = contact.and_then(|contact| {
        StripSides::of(scene, contact, (frame, &line.heaviest)).under(scene, contact, peak)
    });
    Some(LineFigures {
        relative_radius: hertz.map(|hertz| hertz.radius),
        axis: name_of(&frame.along),
        along: frame.along,
        mean: line.mean(),
        across_axis: name_of(&frame.across),
        mirrored: is_mirrored(&frame.along, &cutting_pair(scene, pair)),
        across: line.across,
        images: line.images,
        at: line.at,
        load: line.load,
        peak,
        peak_at,
        half_width: line.heaviest.half_width,
        length: line.length,
        lifted_off: line.lifted_off,
    })
}

impl From<LineLoad> for LineLoadFigures {
    fn from(load: LineLoad) -> Self {
        Self {
            axis: name_of(&load.slices.along),
            edges: load.slices.edges,
            values: load.q,
            mirrored: load.mirrored,
            outside: load.outside,
        }
    }
}
