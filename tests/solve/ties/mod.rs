//! Ties: parts that are meshed apart and joined by mortar integrals.

mod beside;
mod bodies;
mod patch;

use brinell::prelude::*;

const E: f64 = 210e3;
const NU: f64 = 0.3;

fn steel() -> Steel {
    Steel::elastic(E, NU)
}

/// A rotation about an axis that is aligned with nothing.
fn tilted(p: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = p;
    let (s, c) = 0.7f64.sin_cos();
    let [x, y] = [c * x - s * y, s * x + c * y];
    let (s, c) = 0.4f64.sin_cos();
    [x, c * y - s * z, s * y + c * z]
}

/// A displacement gradient with all components, and the stress of it.
const GRADIENT: [[f64; 3]; 3] = [
    [1.0e-3, 4.0e-4, -3.0e-4],
    [2.0e-4, -8.0e-4, 5.0e-4],
    [7.0e-4, -1.0e-4, 6.0e-4],
];

fn stress(gradient: &[[f64; 3]; 3]) -> [f64; 6] {
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

fn linear(surface: &str) -> Support {
    Support {
        name: surface.into(),
        surface: surface.into(),
        components: [Some(0.0); 3],
        gradient: GRADIENT,
    }
}

/// Largest deviation of any stress from that of the gradient, over the largest component of it.
fn deviation(state: &State) -> f64 {
    let exact = stress(&GRADIENT);
    let size = exact.iter().fold(0.0f64, |size, s| size.max(s.abs()));
    let points = state.stress.iter().flatten();
    let off = points.flat_map(|s| (0..6).map(|i| (s[i] - exact[i]).abs()));
    off.fold(0.0, f64::max) / size
}
