//! Half-turn symmetry: a scene that is its own image under a turn of 180 degrees about the line x = y of its mid-plane.
//!
//! The turn R takes (x, y, z) to (y, x, −z), z counted from the mid-plane. A bearing of two crossed rollers between alike
//! plates is such a scene, a displaced one too. Its top moves by −w while its bottom stands. Seen from half of that
//! motion, u′ = u + (0, 0, w/2), the displacements have the symmetry of the scene:
//! ```text
//! u′(R x) = R u′(x)
//! ```
//! So one half of the elements is solved: those above the cut, a layer of nodes that is its own image. On it
//! u′(R x) = R u′(x) ties each node to its image, and a node on the axis has u′_x = u′_y and u′_z = 0. The load is that
//! of the whole, the top moves by w/2, and every state of the half is [unfolded](HalfTurn::unfold) into one of the whole.

mod alike;
mod fold;
mod folded;
mod image;
mod reason;
mod turn;
mod unfold;

pub use folded::HalfTurn;
pub use reason::NoHalfTurn;
