//! Random stacks of blocks: drawn, judged by statics, solved, and looked at from all sides.

mod block;
mod check;
mod draw;
mod guise;
mod solve;
mod split;
mod statics;

pub use solve::solve;
