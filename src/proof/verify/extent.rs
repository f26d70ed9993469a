//! How much of the ladder is climbed.

/// How much of the ladder is climbed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// Claims of a few seconds each.
    Fast,
    All,
}
