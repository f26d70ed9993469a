//! The tangent system, solved by a Krylov method with a factor that is carried from iteration to iteration.

pub mod correction;
pub mod linear_solver;
pub mod low_rank_update;
pub mod proximal_springs;
pub mod shifted_diagonal;
