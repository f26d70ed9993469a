//! Case files: what is read from them, and how every mistake is refused.

mod errors;
mod grades;
mod kit;
mod loads;
mod scene;
mod shipped;
mod units;
