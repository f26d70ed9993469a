//! Roller bearings by their dimensions: where their parts lie, which gmsh template and numbers mesh them, and how a
//! mesh file is known to belong to one. What all templates have is a [`Layout`].
//!
//! All lengths are in one unit, whatever it is; angles in radians.

mod auto;
mod bearing_case;
mod count;
mod crossed;
mod dimensions;
mod end_shape;
mod end_zone;
mod error;
mod fingerprint;
mod fit;
mod geometry;
mod grading;
mod layout;
mod limits;
mod line;
mod model;
mod parameter;
mod parameters;
mod preset;
mod preset_sizes;
mod reader;
mod request;
mod roller_end;
mod roller_shape;
#[cfg(test)]
mod sample;
mod scales;
mod seat;
mod sizes;
mod skew;
mod strips;
mod template;

pub use bearing_case::BearingCase;
pub use count::elements;
pub use dimensions::Dimensions;
pub use end_shape::RollerEnd;
pub use error::GeometryError;
pub use fingerprint::{fingerprint, write_with_fingerprint};
pub use geometry::{BearingGeometry, Roller};
pub use layout::{Layout, RollerPlace};
pub use line::{LineGeometry, LinePlate, MOST_ROLLERS, PlateCurve};
pub use parameter::Parameter;
pub use parameters::{gmsh_parameters, mesh_scale, rescale};
pub use preset::{Preset, UnknownPreset};
pub(super) use reader::UNLOAD_TO;
pub use request::MeshRequest;
pub use roller_end::shape_roller_ends;
pub use roller_shape::RollerShape;
pub use scales::Scales;
pub use seat::Seat;
pub use sizes::{MESH_KEYS, MeshKey, SizeKind, Sizes};
pub use strips::{FoundLine, Strips};
pub use template::{CROSSED, LINE, Template};
