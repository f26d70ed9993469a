//! What is solved: a mesh, its steels, and the scene of bodies, contact pairs, supports, loads and steps.

pub mod builder;
pub mod half_turn;
pub mod material;
pub mod mesh;
pub mod scene;
pub mod state;
