//! The bearing template and the meshes that are shipped with the program.

mod line;
mod remesh;
mod shipped_meshes;
mod skew;
mod template;
