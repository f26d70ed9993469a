//! The contact law of one carrier node: unilateral contact with Coulomb friction.
//!
//! # Symbols
//!
//! Vectors have three components: normal, and along two tangents ([`mortar::Row`]). The carrier is
//! the non-mortar (slave) side.
//!
//! | symbol | meaning | unit | sign |
//! |---|---|---|---|
//! | d | relative displacement at the node, a mean weighted with its hat function: the closure beyond the initial gap (normal), the slip since the last increment (tangential) | length | normal: overlap positive; tangential: the carrier moves along the tangent, seen from the other side |
//! | z | contact traction, what the carrier does to the other side | stress | normal: compression positive; tangential: along the tangent |
//! | p | contact pressure, the normal part of z | stress | compression positive |
//! | λ | multiplier: what is known of z from the iterations before | stress | as z |
//! | ε | penalty: traction per closure, and per slip of a sticking node | stress / length | positive |
//! | ε_t | the softer penalty of a cautious node, tangential | stress / length | positive |
//! | c | stiffness of the bodies at the node | stress / length | positive |
//! | μ | Coulomb's coefficient | 1 | not negative |
//! | μ p | bound on the shear, p being that of the iteration before | stress | not negative |
//!
//! # What must hold
//!
//! ```text
//! p ≥ 0,  −d_n ≥ 0,  p d_n = 0                        unilateral contact (Signorini)
//! |z_t| ≤ μ p;  z_t = μ p d_t / |d_t| where d_t ≠ 0    Coulomb friction
//! ```
//!
//! # How it is reached
//!
//! *Normal*: a primal-dual active set (Hüeber and Wohlmuth, CMAME 194 (2005) 3147). Within an iteration
//! a closed node carries λ + ε d, in compression *or* tension, and an open one nothing (`traction`).
//! Between iterations λ takes the pressure, and which nodes are closed is decided anew (`decide`). When
//! the set and λ rest, the conditions hold exactly, whatever the penalty ε.
//!
//! *Tangential*: the same with the sets of sticking and of slipping nodes (Hüeber, Stadler and Wohlmuth,
//! SIAM J. Sci. Comput. 30 (2008) 572). Within an iteration a sticking node carries λ + ε d, whatever
//! Coulomb says. A slipping one carries Newton's linearisation (`slip`) of
//!
//! ```text
//! |λ + c d| λ = μ p (λ + c d)
//! ```
//!
//! about where it stood. As its shear turns with λ, not with d alone, a node that moves back within an
//! iteration does not throw its shear about. Between iterations a node sticks where |λ + c d| is within
//! the bound μ p, and slips otherwise.
//!
//! *Caution*: at a node between stick and slip, or under a body that only friction holds, these sets may
//! never settle. There both stick and slip are found within one iteration, by radial return of
//! λ + ε_t d onto the disc of radius μ p (Simo and Laursen, Computers & Structures 42 (1992) 97). The
//! softer ε_t leaves the line search a way to balance. λ takes the shear only when all is in balance.
//!
//! # The tangent is symmetric
//!
//! Newton's full linearisation of friction is unsymmetric: the bound μ p grows with the pressure. Here p
//! in the bound is that of the iteration before, and what else is unsymmetric or indefinite is left out
//! of the slope of a slipping node. In equal steels pressure hardly feels shear at all, and the bound
//! settles in few iterations. So all matrices of the solver are symmetric and can be factored by
//! Cholesky. The solution is not touched by this, only the number of iterations is.
//!
//! [`mortar::Row`]: super::mortar::Row

mod decide;
mod node;
mod parameters;
mod slip;
#[cfg(test)]
mod tests;
mod traction;

pub use node::{Node, NodeResponse, Status};
pub use parameters::{Law, MOST_RAISED};
