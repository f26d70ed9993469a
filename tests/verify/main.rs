//! Problems with known answers.

mod contacts;
mod extreme;
mod ladder;
mod rates;
