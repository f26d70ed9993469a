//! Why a scene is not folded.

/// Why half-turn symmetry is not used.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum NoHalfTurn {
    /// The controls say so.
    #[error("it is not wanted")]
    NotWanted,
    /// Not a plate that a force moves towards a fixed one.
    #[error("the load is not that of a plate pressed straight towards a fixed one")]
    Load,
    /// Surfaces are tied.
    #[error("surfaces are tied")]
    Tie,
    /// Nodes hang.
    #[error("nodes hang on edges or faces of larger elements")]
    Hanging,
    /// A body has no image.
    #[error(
        "no body as large, as far from mid-height and of the same steel is the image of `{body}`"
    )]
    Body {
        /// The body.
        body: String,
    },
    /// The mesh is not its own image.
    #[error("the mesh of `{body}` is not the image of another")]
    Mesh {
        /// The body without an image.
        body: String,
    },
    /// A body that is its own image has an odd number of layers.
    #[error("elements of `{body}` lie across the mid-plane: it needs an even number of layers")]
    Layers {
        /// The body.
        body: String,
    },
    /// Supports are not each other's images.
    #[error("the support `{support}` has no image")]
    Support {
        /// The support.
        support: String,
    },
    /// Contact pairs are not each other's images.
    #[error("the contact pair `{pair}` has no image")]
    Contact {
        /// The pair.
        pair: String,
    },
}

impl NoHalfTurn {
    /// Might a user have expected it? Not of scenes that are loaded in another way.
    pub fn is_worth_telling(&self) -> bool {
        !matches!(self, Self::NotWanted | Self::Load | Self::Tie)
    }
}
