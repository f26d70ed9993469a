//! What a user describes: the rolling bearing and how it is meshed.

pub mod bearing;
