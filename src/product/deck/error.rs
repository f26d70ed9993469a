//! What a deck cannot express.

use crate::ground::geometry::AXES;
use crate::model::scene::RigidPlane;
use thiserror::Error;

/// Why a scene cannot be written as a deck.
#[derive(Debug, Error, miette::Diagnostic)]
pub enum InpError {
    #[error(
        "contact pair `{pair}` has a rigid plane, which a deck of solid elements cannot express"
    )]
    #[diagnostic(
        code(brinell::export::plane),
        help("give the rigid side a body of its own, ten times as stiff, and hold it")
    )]
    Plane { pair: String },
    #[error(
        "node {node} is of `{}` and of `{}`, which have other temperatures there, and a deck has one a node",
        bodies[0], bodies[1]
    )]
    #[diagnostic(
        code(brinell::export::temperature),
        help("give the bodies nodes of their own, and join them by a [[tie]]")
    )]
    SharedHeat { node: usize, bodies: [String; 2] },
    #[error("the mesh has no surface `{surface}`, which `{user}` names")]
    #[diagnostic(code(brinell::export::surface))]
    NoSurface { user: String, surface: String },
    #[error("the surfaces of contact pair `{pair}` are nowhere near each other")]
    #[diagnostic(
        code(brinell::export::apart),
        help("check the positions of the two bodies; `brinell run` says what touches")
    )]
    Apart { pair: String },
    #[error(
        "node {node} of the rigid plane `{plane}` is held along {axis} by `{other}` too, so the \
         plane cannot move as one"
    )]
    #[diagnostic(
        code(brinell::export::held_twice),
        help("let the support or the second plane leave out the nodes of this plane")
    )]
    HeldTwice {
        node: usize,
        plane: String,
        axis: &'static str,
        other: String,
    },
    /// Nodes hang.
    #[error("{nodes} nodes hang on edges or faces of larger elements, which decks do not have")]
    #[diagnostic(
        code(brinell::export::hanging),
        help("export the scene as it was before it was refined")
    )]
    Hanging { nodes: usize },
    /// Surfaces cannot be tied.
    #[error("{why}")]
    #[diagnostic(code(brinell::export::tie))]
    Tie { why: String },
    #[error("{what} must be more than 0, and is {value}")]
    #[diagnostic(code(brinell::export::not_positive))]
    NotPositive { what: &'static str, value: f64 },
}

impl InpError {
    pub(super) fn held_twice(node: u32, plane: &RigidPlane, axis: usize, other: &str) -> Self {
        Self::HeldTwice {
            node: node as usize + 1,
            plane: plane.name.clone(),
            axis: AXES[axis],
            other: other.to_string(),
        }
    }
}
