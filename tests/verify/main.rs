//! Problems with known answers.

mod ladder;
mod problem_h;
