//! Problems with known answers.

mod problem_h;
mod rates;
