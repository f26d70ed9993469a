//! What the families share: short words for scenes, a solution with its cost, what is read from it.

mod element;
mod measure;
mod run;
mod scene;
mod split;

pub use element::{ELEMENTS, NamedElement};
pub use measure::{displacement_at, mean_displacement, stress_integral, surface};
pub use run::{SolvedScene, run};
pub use scene::{
    driven, held, on_rigid_flat, pair, plane, pressure, quarter, quarter_supports, stack_supports,
    support, traction,
};
pub use split::split_anywhere;
