//! Whole solutions: blocks, the reference study's centre case, and what must not change them.

mod balance;
mod bearing;
mod blocks;
mod centre;
mod clamped;
mod coarse_point;
mod dents;
mod divided;
mod half_turn;
mod invariance;
mod kit;
mod left_out;
mod local;
mod misaligned;
mod orientation;
mod reaction;
mod receding;
mod refined;
mod resume;
mod slides;
mod stacked;
mod statics;
mod symmetry;
mod thermal;
mod ties;
mod turning;
