//! The rolling bearing of five bodies as geometry: where its parts lie, which gmsh template and
//! numbers mesh it, and how a mesh file is known to belong to it.
//!
//! All lengths are in one unit, whatever it is; angles in radians.

mod auto;
mod bearing_case;
mod count;
mod end_shape;
mod error;
mod fingerprint;
mod fit;
mod geometry;
mod limits;
mod model;
mod parameters;
mod preset;
mod reader;
mod request;
mod roller_end;
#[cfg(test)]
mod sample;
mod sizes;
mod strips;
mod template;

pub use bearing_case::BearingCase;
pub use count::elements;
pub use end_shape::RollerEnd;
pub use error::GeometryError;
pub use fingerprint::{fingerprint, write_with_fingerprint};
pub use geometry::{BearingGeometry, Roller};
pub use parameters::{gmsh_parameters, mesh_scale, rescale};
pub use preset::{Preset, UnknownPreset};
pub(super) use reader::UNLOAD_TO;
pub use request::MeshRequest;
pub use roller_end::shape_roller_ends;
pub use sizes::{MESH_KEYS, MeshKey, SizeKind, Sizes};
pub use strips::{FoundLine, Strips};
pub use template::{TEMPLATE_FILES, TEMPLATE_MAIN, TEMPLATE_VERSION, write_template};
