//! What the templates of bearings have in common: rollers, the places where they lie on plates, a gmsh template with its
//! numbers, element sizes by preset. Cases, runs and what stands beside their results ask for no more.

use std::fmt;

use super::end_shape::RollerEnd;
use super::error::GeometryError;
use super::parameter::Parameter;
use super::preset::Preset;
use super::roller_shape::RollerShape;
use super::seat::Seat;
use super::sizes::Sizes;
use super::strips::Strips;
use super::template::Template;
use crate::analytic::DomainError;
use crate::model::mesh::Mesh;

/// A roller of a bearing.
#[derive(Debug, Clone, PartialEq)]
pub struct RollerPlace {
    /// Its body.
    pub body: String,
    /// The axis that it lies along: 0 (x) or 1 (y).
    pub axis: usize,
    /// The middle of its axis.
    pub centre: [f64; 3],
    /// By how much it is turned about the vertical, in radians; positive by the right hand about z.
    pub skew: f64,
}

/// The dimensions of a bearing of some template.
pub trait Layout: fmt::Debug {
    /// The table of the case file that has them.
    fn table(&self) -> &'static str;

    /// Is this a bearing that can be built and meshed?
    ///
    /// # Errors
    /// Names the first dimension that is out of its range, with the range.
    fn check(&self) -> Result<(), GeometryError>;

    /// Of all rollers.
    fn roller(&self) -> RollerShape;

    /// D, of all rollers.
    fn diameter(&self) -> f64 {
        self.roller().diameter
    }

    /// Wall of hollow rollers; `None` for solid ones.
    fn wall(&self) -> Option<f64> {
        self.roller().wall
    }

    /// L, of all rollers.
    fn length(&self) -> f64 {
        self.roller().length
    }

    /// Of all rollers.
    fn end(&self) -> RollerEnd {
        self.roller().end
    }

    /// By how much rollers are displaced along each other.
    fn offset(&self) -> f64;

    /// z of the lowest and the highest point of the stack.
    fn height_range(&self) -> [f64; 2];

    /// The point that a top that turns turns about, below or above the middle of its face: where no roller slides for it.
    fn pivot(&self) -> [f64; 3];

    /// Axes across which the model is mirrored; none where all of the bearing is to be modelled.
    fn mirrors(&self, full: bool) -> Vec<usize>;

    /// Every body from the top down, with its thickness or diameter as delivered.
    fn bodies(&self) -> Vec<(String, f64)>;

    /// The rollers that are modelled.
    fn rollers(&self, full: bool) -> Vec<RollerPlace>;

    /// Is a roller askew?
    fn is_askew(&self) -> bool {
        self.stray() > 0.0
    }

    /// How far rollers that are askew stray, at their ends, from the lines along which they would touch.
    fn stray(&self) -> f64 {
        let rollers = self.rollers(true).into_iter();
        let lean = rollers.map(|roller| roller.lean().abs());
        0.5 * self.length() * lean.fold(0.0, f64::max)
    }

    /// The interfaces that are modelled, from the top down.
    fn seats(&self, full: bool) -> Vec<Seat>;

    /// Presets that go with this template.
    fn presets(&self) -> &'static [Preset];

    /// The element sizes of a preset, for lines of contact as wide as `strips`.
    fn preset_sizes(&self, preset: Preset, strips: &Strips) -> Sizes;

    /// The widths of the lines of contact as statics predicts them under `load`; `compliance` is C_E of each interface
    /// by its place in [`seats`](Self::seats).
    ///
    /// # Errors
    /// [`DomainError`] where a closed form has no value.
    fn predicted(&self, load: f64, full: bool, compliance: &[f64]) -> Result<Strips, DomainError>;

    /// The numbers of the gmsh template, but for element sizes.
    fn parameters(&self, full: bool, uniform: bool) -> Vec<Parameter>;

    /// The element sizes of [`MESH_KEYS`](super::MESH_KEYS) that the template does without, by their keys.
    fn without(&self) -> &'static [&'static str];

    /// The gmsh template.
    fn template(&self) -> &'static Template;

    /// About how many elements a mesh has.
    fn elements(&self, sizes: &Sizes, full: bool) -> f64;

    /// Gives a mesh what gmsh does not make of it; it is in the unit of the bearing.
    fn shape(&self, mesh: &mut Mesh, full: bool);
}
