//! Fields of a solved scene, and the fields and scalars recovered from them.
//!
//! Everything here reads a [`Scene`](crate::model::scene::Scene) and a converged
//! [`State`](crate::model::state::State); nothing here knows how the state was found or where the figures go.

pub mod around;
pub mod balance;
pub mod below;
pub mod below_strips;
pub mod bore;
mod circle;
pub mod contact_line;
pub mod contact_lines;
mod crease;
pub mod curvature;
pub mod dent;
pub mod depth;
pub mod edges;
pub mod ending;
pub mod fillet;
pub mod first_layer;
pub mod flow;
pub mod hertz;
pub mod hex;
pub mod interface;
pub mod levels;
pub mod line_direction;
pub mod line_frame;
pub mod line_load;
pub mod load;
pub mod means;
pub mod outer_faces;
mod own_directions;
pub mod peaks;
pub mod quad;
pub mod recovery;
mod rows;
pub mod seams;
pub mod strain;
pub mod strip;
pub mod strip_profile;
pub mod strip_row;
pub mod strip_sides;
pub mod symmetry_planes;
pub mod tensor;
