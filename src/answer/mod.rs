//! What a solved scene says: recovered fields, measures of contact, and the errors of both.

pub mod certify;
pub mod results;
pub mod solved;
