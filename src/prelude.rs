//! What a program that builds, solves and reads scenes needs, in one line: `use brinell::prelude::*;`.

pub use crate::analytic::hertz::LineContact;
pub use crate::analytic::hertz::PointContact;
pub use crate::analytic::{Elastic, contact_compliance};
pub use crate::answer::certify::{Figure, Quantity};
pub use crate::answer::{Answer, BodyFigures, InterfaceFigures, Solved};
pub use crate::model::builder::{
    Axis, BuildError, Contact, Cylinder, Load, MeshFile, SceneBuilder, Shape,
};
pub use crate::model::material::Steel;
pub use crate::model::mesh::Mesh;
pub use crate::model::mesh::block::{Block, cylindrical, graded, uniform};
pub use crate::model::mesh::family::grading::Grading;
pub use crate::model::scene::{
    Controls, ElementKind, PlaneMotion, Scene, Side, SolverKind, Step, Support, Temperature, Tie,
};
pub use crate::model::state::{ContactField, State};
pub use crate::solver::solve::{Observer, Silent, SolveError, solve};
