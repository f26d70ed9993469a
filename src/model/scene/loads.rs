//! What holds, moves and loads surfaces.

use serde::Serialize;

/// Prescribed displacement components on a surface: constant, or linear in position.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Support {
    /// What steps and messages call it.
    pub name: String,
    /// The surface of the mesh.
    pub surface: String,
    /// Displacement of each component, `None` where free. Times the factor of the step.
    pub components: [Option<f64>; 3],
    /// ∂u_i/∂x_j of each prescribed component i, by undeformed position: a node at `x` is moved
    /// by `components[i]` + Σ `gradient[i][j]` x_j. Times the factor of the step.
    pub gradient: [[f64; 3]; 3],
}

impl Support {
    /// Does it move what it holds?
    pub fn moves(&self) -> bool {
        let parts = self.components.iter().flatten();
        (parts.chain(self.gradient.as_flattened())).any(|u| *u != 0.0)
    }

    /// Displacement along `axis` of a node at `x`, at factor one; `None` where free.
    pub fn displacement(&self, axis: usize, x: &[f64; 3]) -> Option<f64> {
        let row = &self.gradient[axis];
        self.components[axis].map(|c| c + row[0] * x[0] + row[1] * x[1] + row[2] * x[2])
    }
}

/// What a rigid plane does along one axis.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub enum PlaneMotion {
    /// Displaced by this much (times the factor of the step), all nodes alike.
    Held(f64),
    /// Free to move, all nodes alike, under this total force on the *modelled* part
    /// (times the factor of the step).
    Driven(f64),
    /// Every node free.
    #[default]
    Free,
}

/// A force per area on a surface.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Traction {
    /// What steps and messages call it.
    pub name: String,
    /// The surface of the mesh.
    pub surface: String,
    /// The traction at factor one, in the stress unit of the scene.
    pub value: TractionValue,
}

/// How a traction is given, in the stress unit of the scene.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub enum TractionValue {
    /// Compression positive, along the inward normal.
    Pressure(f64),
    /// In the directions of the axes.
    Vector([f64; 3]),
}
