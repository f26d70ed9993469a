//! Why surfaces cannot be tied.

/// Why surfaces cannot be tied.
#[derive(Debug, Clone, PartialEq, thiserror::Error, miette::Diagnostic)]
pub enum TieError {
    /// A surface of the tie is not in the mesh.
    #[error("tie `{tie}`: the mesh has no surface called `{surface}`")]
    #[diagnostic(
        code(brinell::tie::no_surface),
        help("name two surfaces of the mesh: its physical surfaces")
    )]
    NoSurface {
        /// Name of the tie.
        tie: String,
        /// Name of the surface.
        surface: String,
    },
    /// The surfaces share a node.
    #[error(
        "tie `{tie}`: the surfaces `{first}` and `{second}` share node {node}: there they are joined already"
    )]
    #[diagnostic(
        code(brinell::tie::shared_nodes),
        help("leave the tie out, or mesh the two parts without common nodes")
    )]
    SharedNodes {
        /// Name of the tie.
        tie: String,
        /// Its first surface.
        first: String,
        /// Its second surface.
        second: String,
        /// A node of both.
        node: u32,
    },
    /// The surfaces are too far from each other.
    #[error(
        "tie `{tie}`: the surfaces `{first}` and `{second}` are up to {distance:.3e} apart (in the length unit of \
         the case), and {tolerance:.3e} is bridged"
    )]
    #[diagnostic(
        code(brinell::tie::apart),
        help(
            "bring the parts together, or give the tie a larger `tolerance` if the distance is meant"
        )
    )]
    Apart {
        /// Name of the tie.
        tie: String,
        /// Its first surface.
        first: String,
        /// Its second surface.
        second: String,
        /// Their largest distance.
        distance: f64,
        /// The largest that is bridged.
        tolerance: f64,
    },
    /// The surfaces do not face each other anywhere.
    #[error(
        "tie `{tie}`: the surfaces `{first}` and `{second}` do not lie upon each other anywhere"
    )]
    #[diagnostic(
        code(brinell::tie::no_overlap),
        help("look for a wrong name, or for a part that is not where it should be")
    )]
    NoOverlap {
        /// Name of the tie.
        tie: String,
        /// Its first surface.
        first: String,
        /// Its second surface.
        second: String,
    },
    /// Both surfaces are held, on facets of their own.
    #[error(
        "tie `{tie}`: `{by}` holds all corners of a facet of `{surface}` along {axis}, and facets of the other surface are \
         held, too: there nothing is left to tie"
    )]
    #[diagnostic(
        code(brinell::tie::held),
        help(
            "hold one of the two bodies only, or tie a surface that ends where the support begins"
        )
    )]
    Held {
        /// Name of the tie.
        tie: String,
        /// The surface whose nodes would follow.
        surface: String,
        /// The surface of the support or rigid plane.
        by: String,
        /// The axis.
        axis: char,
    },
    /// A contact pair wants what a tie joins.
    #[error(
        "tie `{tie}`: contact pair `{pair}` is between the surfaces that it joins, or on one of which every node follows"
    )]
    #[diagnostic(
        code(brinell::tie::contact),
        help(
            "leave one of the two out: what is tied neither opens nor slides. Contact beside a tie needs a surface of its own"
        )
    )]
    Contact {
        /// Name of the tie.
        tie: String,
        /// Name of the contact pair.
        pair: String,
    },
}
