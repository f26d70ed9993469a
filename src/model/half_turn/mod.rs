//! Half-turn symmetry: a scene that is its own image under a turn of 180 degrees about the line x = y of its mid-plane.
//!
//! The turn R takes (x, y, z) to (y, x, −z), z counted from the mid-plane. A bearing of two crossed rollers between alike
//! plates is such a scene, a displaced one too. Its top moves by −w while its bottom stands. Seen from half of that
//! motion, u′ = u + (0, 0, w/2), the displacements have the symmetry of the scene:
//! ```text
//! u′(R x) = R u′(x)
//! ```
//! So one half of the elements is solved: those above the cut, a layer of nodes that is its own image. On it
//! u′(R x) = R u′(x) ties each node to its image, and a node on the axis has u′_x = u′_y and u′_z = 0. The load is that
//! of the whole, the top moves by w/2, and every state of the half is [unfolded](HalfTurn::unfold) into one of the whole.

mod alike;
mod fold;
mod image;
mod reason;
mod unfold;

pub use reason::NoHalfTurn;

use crate::ground::geometry::Vec3;
use crate::model::scene::Scene;
use image::Images;

/// A scene that is its own image, folded.
#[derive(Debug, Clone)]
pub struct HalfTurn {
    /// The half that is solved. Its [`Scene::half_turn`] has the nodes of the cut.
    pub half: Scene,
    /// Number in the half of each node of the whole, or of its image, which comes with `true`.
    nodes: Vec<(u32, bool)>,
    /// The same of each element; of an image the corner of the half's element that each of its corners is.
    elements: Vec<(u32, Option<[u8; 8]>)>,
    /// Node of the whole of each node of the half.
    whole_nodes: Vec<u32>,
    /// Element of the whole of each element of the half.
    whole_elements: Vec<u32>,
    /// Contact pair of the half that each pair of the whole is or, with `true`, is the image of.
    pairs: Vec<(usize, bool)>,
    /// Carrier nodes of each pair of the whole, ascending.
    carriers: Vec<Vec<u32>>,
    /// Height of the mid-plane.
    middle: f64,
}

impl HalfTurn {
    /// Folds `scene`, where it is its own image.
    ///
    /// # Errors
    /// [`NoHalfTurn`] says what breaks the symmetry.
    pub fn of(scene: &Scene) -> Result<Self, NoHalfTurn> {
        alike::loads(scene)?;
        let images = Images::of(&scene.mesh, &scene.materials)?;
        let bottom = alike::supports(scene, &images)?;
        let pairs = alike::contacts(scene, &images)?;
        fold::fold(scene, images, bottom, pairs)
    }
}

/// A vector, turned.
fn turned([x, y, z]: Vec3) -> Vec3 {
    [y, x, -z]
}

/// A point, turned about the axis at the height `middle`.
fn turned_point([x, y, z]: Vec3, middle: f64) -> Vec3 {
    [y, x, 2.0 * middle - z]
}

/// A stress xx yy zz xy yz zx, turned.
fn turned_stress([xx, yy, zz, xy, yz, zx]: [f64; 6]) -> [f64; 6] {
    [yy, xx, zz, xy, -zx, -yz]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stress_turns_as_its_traction_and_its_normal_do() {
        let stress = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        let traction = |s: [f64; 6], n: Vec3| {
            let [xx, yy, zz, xy, yz, zx] = s;
            [
                xx * n[0] + xy * n[1] + zx * n[2],
                xy * n[0] + yy * n[1] + yz * n[2],
                zx * n[0] + yz * n[1] + zz * n[2],
            ]
        };
        let normal = [0.3, -0.5, 0.7];
        let turned_traction = traction(turned_stress(stress), turned(normal));
        assert_eq!(turned_traction, turned(traction(stress, normal)));
        assert_eq!(turned(turned(normal)), normal);
        assert_eq!(turned_stress(turned_stress(stress)), stress);
    }
}
