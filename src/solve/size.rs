//! What a model will cost, reckoned before it is made.

use crate::fem::dofs::DofMap;
use crate::linear::memory::available;
use crate::scene::{Scene, SolverKind};

/// How much of the memory that there is one factor may take before the model is divided.
const SPARE: f64 = 0.7;

/// What a model will take, and how it is to be solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Size {
    /// Divide it, and not condense its bodies?
    pub divided: bool,
    /// Bytes in all.
    pub memory: f64,
    /// Unknowns that contact or flow acts on.
    pub kept: f64,
}

impl Size {
    /// Of a model that acts on the `needed` vertices; `large` where it was found too large before.
    pub fn new(scene: &Scene, dofs: &DofMap, needed: &[bool], large: bool) -> Self {
        let divided = match scene.controls.solver {
            SolverKind::Auto => {
                let short = |available| memory(scene, dofs, needed, false) > SPARE * available;
                large || is_large(scene, dofs, needed) || available().is_some_and(short)
            }
            SolverKind::Direct => false,
            SolverKind::Divided => true,
        };
        Self {
            divided,
            memory: memory(scene, dofs, needed, divided),
            kept: kept(dofs, needed),
        }
    }
}

/// Is it better to divide the model than to condense its bodies?
pub fn is_large(scene: &Scene, dofs: &DofMap, needed: &[bool]) -> bool {
    // Seen from the needed unknowns a body is dense; factors take the cube of their number, and are
    // made about as often as Krylov directions number with a division.
    const DIVIDED: f64 = 1.5e7;
    // Entries of the factors of whole bodies: of a bearing of 255 thousand unknowns 350 million take 43 s,
    // once, where a division takes minutes an increment.
    const ENTRIES: f64 = 4e8;
    kept(dofs, needed).powi(3) / 3.0 > DIVIDED * dofs.len() as f64 || entries(scene) > ENTRIES
}

/// Bytes that a model takes, from runs of 50 to 200 thousand unknowns (within a quarter).
pub fn memory(scene: &Scene, dofs: &DofMap, needed: &[bool], divided: bool) -> f64 {
    let unknowns = dofs.len() as f64;
    match divided {
        true => 6e3 * unknowns,
        false => 2e3 * unknowns + 14.4 * entries(scene) + 1.6 * kept(dofs, needed).powi(2),
    }
}

/// Unknowns of the needed vertices.
fn kept(dofs: &DofMap, needed: &[bool]) -> f64 {
    let starts = dofs.vertex_start.windows(2).zip(needed);
    let kept: u32 = starts.filter(|(_, n)| **n).map(|(s, _)| s[1] - s[0]).sum();
    f64::from(kept)
}

/// Entries of the factors of all bodies.
fn entries(scene: &Scene) -> f64 {
    let bodies = scene.mesh.bodies.iter();
    bodies.map(|b| factor_entries(b.elements.len())).sum()
}

/// About how many entries the factor of a compact body has, ordered by METIS (73 million for a cube
/// of 30 elements a side, 241 million for one of 40).
fn factor_entries(elements: usize) -> f64 {
    73e6 * (elements as f64 / 27e3).powf(1.4)
}
