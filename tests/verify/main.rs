//! Problems with known answers.

mod contacts;
