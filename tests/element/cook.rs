//! Cook's membrane: a tapered panel clamped on the left, sheared on the right.
//!
//! Corners (0, 0), (48, 44), (48, 60), (0, 44), thickness 1, an even upward shear. Converged
//! values were computed by a separate program with biquadratic elements, up to 64 × 64; those of
//! nearly incompressible plane strain extrapolated, good to 1 %.

use crate::kit::{self, close, held};
use ElementKind::{Bbar, Enhanced};
use brinell::model::material::Steel;
use brinell::model::mesh::block::{Block, uniform};
use brinell::model::scene::{ElementKind, Traction, TractionValue};

/// Upward displacement of the middle (48, 52) and the corner (48, 60) of the right edge.
fn displacement(
    kind: ElementKind,
    cells: usize,
    steel: Steel,
    force: f64,
    plane_strain: bool,
) -> [f64; 2] {
    let panel = |[s, t, z]: [f64; 3]| {
        let (low, high) = (44.0 * s, 44.0 + 16.0 * s);
        [48.0 * s, low + t * (high - low), z]
    };
    let unit = || uniform(0.0, 1.0, cells);
    let mesh = Block::new("panel", unit(), unit(), vec![0.0, 1.0])
        .mapped(panel)
        .build()
        .unwrap();
    let mut scene = kit::scene(mesh, steel, kind);
    scene.controls.residual = 1e-7;
    scene.supports = vec![held("x_min", 0), held("x_min", 1), held("z_min", 2)];
    if plane_strain {
        scene.supports.push(held("z_max", 2));
    }
    scene.tractions = vec![Traction {
        name: "shear".into(),
        surface: "x_max".into(),
        value: TractionValue::Vector([0.0, force / 16.0, 0.0]),
    }];
    let state = kit::last(&mut scene);
    [52.0, 60.0].map(|y| {
        let at = |p: &[f64; 3]| (p[0] - 48.0).hypot(p[1] - y) < 1e-9;
        let node = scene.mesh.points.iter().position(at).unwrap();
        state.displacement[node][1]
    })
}

#[test]
fn plane_stress_converges_to_the_biquadratic_answer() {
    let middle = |kind, cells| {
        let steel = Steel::elastic(1.0, 1.0 / 3.0);
        displacement(kind, cells, steel, 1.0, false)[0]
    };
    let exact = 23.967;
    close("B-bar, 32 × 32", middle(Bbar, 32), exact, 0.005);
    close("enhanced, 32 × 32", middle(Enhanced, 32), exact, 0.0015);
    // Four elements along an edge tell the two apart.
    close("B-bar, 4 × 4", middle(Bbar, 4), exact, 0.17);
    close("enhanced, 4 × 4", middle(Enhanced, 4), exact, 0.042);
}

/// E = 240.565, total load 100.
#[test]
fn plane_strain_converges_whatever_poissons_ratio() {
    for kind in [Bbar, Enhanced] {
        let [middle, corner] = displacement(kind, 32, Steel::elastic(240.565, 0.3), 100.0, true);
        close("middle", middle, 9.122, 0.005);
        close("corner", corner, 9.584, 0.01);
        let steel = Steel::elastic(240.565, 0.4999);
        let [middle, corner] = displacement(kind, 32, steel, 100.0, true);
        close("middle, nearly incompressible", middle, 7.69, 0.012);
        close("corner, nearly incompressible", corner, 8.08, 0.012);
    }
}
