//! Whole solutions: blocks, the reference study's centre case, and what must not change them.

mod balance;
mod bearing;
mod blocks;
mod centre;
mod dents;
mod divided;
mod half_turn;
mod invariance;
mod kit;
mod left_out;
mod local;
mod misaligned;
mod reaction;
mod refined;
mod resume;
mod slides;
mod statics;
mod symmetry;
mod thermal;
mod ties;
mod turning;
