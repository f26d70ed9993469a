//! Problems with known answers.

mod contacts;
mod coverage;
mod extreme;
mod ladder;
mod rates;
