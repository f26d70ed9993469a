//! One block of a stack.

use crate::ground::geometry::Vec3;
use crate::model::mesh::Mesh;
use crate::model::mesh::block::{Block, uniform};
use crate::proof::verify::VerifyError;
use libm::sin;
use std::f64::consts::PI;

/// One block of a stack: its footprint about (0, 0) shifted to its place, and the heights of its faces.
pub struct StackBlock {
    pub low: [f64; 2],
    pub high: [f64; 2],
    /// Lower and upper face: z = height + slopes · (x, y).
    pub faces: [SlopedFace; 2],
    pub cells: [usize; 3],
    /// How far inner nodes are moved, over the size of a cell, and the phases of that.
    pub distortion: (f64, [f64; 3]),
}

#[derive(Clone, Copy)]
pub struct SlopedFace {
    pub height: f64,
    pub slopes: [f64; 2],
}

impl SlopedFace {
    pub fn at(&self, [x, y]: [f64; 2]) -> f64 {
        self.height + self.slopes[0] * x + self.slopes[1] * y
    }

    /// Unit normal, upwards.
    pub fn normal(&self) -> Vec3 {
        let [a, b] = self.slopes;
        let size = (1.0 + a * a + b * b).sqrt();
        [-a / size, -b / size, 1.0 / size]
    }
}

impl StackBlock {
    /// Its mesh, surfaces and body called after `name`.
    pub fn mesh(&self, name: &str) -> Result<Mesh, VerifyError> {
        let [x, y, z] = self.cells;
        let line = |cells| uniform(0.0, 1.0, cells);
        let block = Block::new("block", line(x), line(y), line(z)).mapped(|at| self.place(at));
        let faces = ["x_min", "x_max", "y_min", "y_max", "z_min", "z_max"];
        let block = (faces.into_iter()).fold(block, |block, face| block.face(face, face));
        Ok(block.build()?.prefixed(&format!("{name}_")))
    }

    /// From the unit cube into the part. Inner nodes are moved to and fro, and so are those of a face within it.
    fn place(&self, at: Vec3) -> Vec3 {
        let (size, phases) = self.distortion;
        let moved = |i: usize| {
            let across = (i + 1) % 3;
            let wave = sin(PI * at[i]) * sin(3.0 * at[across] + 2.0 * at[i] + phases[i]);
            at[i] + size * wave / self.cells[i] as f64
        };
        let [x, y, share] = [0, 1, 2].map(moved);
        let plan = [
            self.low[0] + x * (self.high[0] - self.low[0]),
            self.low[1] + y * (self.high[1] - self.low[1]),
        ];
        let [low, high] = self.faces.map(|face| face.at(plan));
        [plan[0], plan[1], low + share * (high - low)]
    }
}
