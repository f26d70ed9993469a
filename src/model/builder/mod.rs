//! Building a scene from code: bodies with steels, contacts, supports, loads and steps.
//!
//! ```text
//!  Block | Cylinder | MeshFile | Mesh --body--+
//!  Steel -------------------------------------+
//!  Contact --contact--------------------------+--> SceneBuilder --build--> Scene, checked
//!  surfaces --fix, hold, displace, mirror-----+
//!  Load --load, step--------------------------+
//! ```
//!
//! [`SceneBuilder`] has an example. A builder keeps the first thing that goes wrong and tells it in
//! [`build`](SceneBuilder::build), so that the pieces can be said in one chain.

mod axis;
mod check;
mod contact;
mod cylinder;
mod error;
mod load;
mod scene;
mod shape;
#[cfg(test)]
mod tests;

pub use axis::Axis;
pub use contact::Contact;
pub use cylinder::Cylinder;
pub use error::BuildError;
pub use load::Load;
pub use scene::SceneBuilder;
pub use shape::{MeshFile, Shape};
