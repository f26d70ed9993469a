//! Ties: parts that are meshed apart and joined by mortar integrals.

mod beside;
mod bodies;
mod patch;

use brinell::prelude::*;

pub const E: f64 = 210e3;
pub const NU: f64 = 0.3;

pub fn steel() -> Steel {
    Steel::elastic(E, NU)
}

/// A rotation about an axis that is aligned with nothing.
pub fn tilted(p: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = p;
    let (s, c) = 0.7f64.sin_cos();
    let [x, y] = [c * x - s * y, s * x + c * y];
    let (s, c) = 0.4f64.sin_cos();
    [x, c * y - s * z, s * y + c * z]
}

/// A displacement gradient with all components, and the stress of it.
pub const GRADIENT: [[f64; 3]; 3] = [
    [1.0e-3, 4.0e-4, -3.0e-4],
    [2.0e-4, -8.0e-4, 5.0e-4],
    [7.0e-4, -1.0e-4, 6.0e-4],
];

pub fn stress(gradient: &[[f64; 3]; 3]) -> [f64; 6] {
    let (shear, lame) = (
        E / (2.0 + 2.0 * NU),
        E * NU / ((1.0 + NU) * (1.0 - 2.0 * NU)),
    );
    let trace: f64 = (0..3).map(|i| gradient[i][i]).sum();
    [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)].map(|(i, j)| {
        let normal = if i == j { lame * trace } else { 0.0 };
        normal + shear * (gradient[i][j] + gradient[j][i])
    })
}

pub fn linear(surface: &str) -> Support {
    Support {
        name: surface.into(),
        surface: surface.into(),
        components: [Some(0.0); 3],
        gradient: GRADIENT,
    }
}

/// Largest deviation of any stress from that of the gradient, over the largest component of it.
pub fn deviation(state: &State) -> f64 {
    let exact = stress(&GRADIENT);
    let size = exact.iter().fold(0.0f64, |size, s| size.max(s.abs()));
    let points = state.stress.iter().flatten();
    let off = points.flat_map(|s| (0..6).map(|i| (s[i] - exact[i]).abs()));
    off.fold(0.0, f64::max) / size
}

/// Radial displacement of the bore under a pressure of 100 in it, plane strain (Lamé).
fn bore() -> f64 {
    let (a, b, p): (f64, f64, f64) = (1.0, 2.0, 100.0);
    let k = p * a * a / (b * b - a * a);
    (1.0 + NU) / E * k * ((1.0 - 2.0 * NU) * a + b * b / a)
}

/// Largest deviation of the radial displacement of the bore from that, of itself.
pub fn off_lame(solved: &Solved, surface: &str) -> f64 {
    let mesh = &solved.scene.mesh;
    let nodes = mesh.surface(surface).unwrap().nodes();
    let radial = nodes.iter().map(|n| {
        let (x, u) = (
            mesh.points[*n as usize],
            solved.state().displacement[*n as usize],
        );
        (x[0] * u[0] + x[1] * u[1]) / x[0].hypot(x[1])
    });
    let off = radial.map(|u| (u / bore() - 1.0).abs());
    off.fold(0.0, f64::max)
}
