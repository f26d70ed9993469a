//! Problems with known answers.

mod contacts;
mod ladder;
mod rates;
