//! Entries of a scene that contradict each other.

/// Two entries of a scene disagree about one displacement component.
#[derive(Debug, Clone, PartialEq, thiserror::Error, miette::Diagnostic)]
#[error(
    "surfaces `{first}` and `{second}` prescribe different motions along {axis} for shared nodes \
     (node {node})"
)]
#[diagnostic(
    code(brinell::scene::conflicting_supports),
    help("free the component in one of the two, or separate the surfaces")
)]
pub struct Conflict {
    /// The two surfaces
    pub first: String,
    /// that disagree,
    pub second: String,
    /// the axis,
    pub axis: char,
    /// and a node that both have.
    pub node: u32,
}
