//! Refinement: every hexahedron into eight, or some of them.

mod nodes;
mod smooth;
mod some;

use super::Mesh;
use super::hexahedron::{Orientation, orientation};
use miette::Diagnostic;
use thiserror::Error;

pub use nodes::Directions;
pub use smooth::volume_beyond_facets;
pub use some::Refined;

/// Why a mesh cannot be split.
#[derive(Debug, Error, Diagnostic, PartialEq, Eq)]
pub enum SplitError {
    #[error("the mesh {mesh} is too large to be split: {elements} hexahedra would become {result}")]
    #[diagnostic(
        code(brinell::mesh::split_size),
        help("ask for less: fewer levels of a series, or a target that a coarser mesh meets")
    )]
    TooLarge {
        mesh: String,
        elements: usize,
        result: usize,
    },
    #[error(
        "splitting the mesh {mesh} turns an element of body `{body}` inside out: the surface \
         bends more within an element than the element is thick"
    )]
    #[diagnostic(
        code(brinell::mesh::split_inverted),
        help(
            "make the mesh finer along the round surface, or its first layer thicker; `brinell converge` also takes a series \
             of files by --mesh"
        )
    )]
    Inverted { mesh: String, body: String },
}

/// More hexahedra than this are no mesh that Brinell solves.
const MOST_HEXAHEDRA: usize = 100_000_000;

impl Mesh {
    /// Every hexahedron split into eight at the middles of its edges, faces and volume; names
    /// stay. On surfaces that fit a cylinder or sphere ([`fit`](crate::model::mesh::shape::fit)) the new nodes are put on it, on other
    /// smooth surfaces, named or not, on arcs over the edges, and the nodes inside follow, so that the pieces stay well shaped.
    ///
    /// # Errors
    /// [`SplitError`] for a mesh that becomes too large or folded.
    pub fn split(&self) -> Result<Mesh, SplitError> {
        let mesh = self.split_some(|_| [true; 3])?.mesh;
        Ok(Mesh {
            source: format!("{}, split", self.source),
            ..mesh
        })
    }

    /// The split mesh, unless an element of it is folded.
    fn sound(&self, mesh: Mesh) -> Result<Mesh, SplitError> {
        let folded = |e: &usize| orientation(&mesh.corners(*e)) != Orientation::Sound;
        match (0..mesh.hexes.len()).find(folded) {
            None => Ok(mesh),
            Some(element) => Err(SplitError::Inverted {
                body: mesh
                    .bodies
                    .get(mesh.body_of(element))
                    .map_or_else(String::new, |b| b.name.clone()),
                mesh: self.source.clone(),
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::mesh::block::{Block, cylindrical, uniform};
    use crate::model::mesh::hexahedron::volume;
    use std::f64::consts::FRAC_PI_2;

    fn tube(around: usize) -> Mesh {
        Block::new(
            "tube",
            uniform(1.0, 2.0, 2),
            uniform(0.0, FRAC_PI_2, around),
            uniform(0.0, 1.0, 1),
        )
        .mapped(cylindrical)
        .build()
        .unwrap()
    }

    fn total(mesh: &Mesh) -> f64 {
        (0..mesh.hexes.len())
            .map(|e| volume(&mesh.corners(e)))
            .sum()
    }

    #[test]
    fn a_split_tube_keeps_its_surfaces_and_nears_its_true_shape() {
        let coarse = tube(6);
        let fine = coarse.split().unwrap();
        assert_eq!(fine.hexes.len(), 8 * coarse.hexes.len());
        assert_eq!(fine.points.len(), 5 * 13 * 3);
        for surface in &coarse.surfaces {
            let split = fine.surface(&surface.name).unwrap();
            assert_eq!(
                split.faces.len(),
                4 * surface.faces.len(),
                "{}",
                surface.name
            );
            for face in &split.faces {
                let hex = &fine.hexes[face.element as usize];
                assert!(face.nodes.iter().all(|n| hex.contains(n)));
            }
        }
        for (name, radius) in [("x_min", 1.0), ("x_max", 2.0)] {
            for node in fine.surface(name).unwrap().nodes() {
                let [x, y, _] = fine.points[node as usize];
                assert!((x.hypot(y) - radius).abs() < 1e-9, "{name} {x} {y}");
            }
        }
        let exact = 3.0 * FRAC_PI_2 / 2.0;
        let (before, after) = (exact - total(&coarse), exact - total(&fine));
        assert!(after > 0.0 && after < 0.3 * before, "{before} {after}");
        let outer = fine.outer_faces(0).len();
        let named: usize = fine.surfaces.iter().map(|s| s.faces.len()).sum();
        assert_eq!(outer, named);
    }

    #[test]
    fn a_layer_that_a_facet_bends_through_is_refused_with_what_helps() {
        let around = uniform(0.0, FRAC_PI_2, 3);
        let thin = Block::new("tube", vec![8.0, 8.05, 10.0], around, uniform(0.0, 1.0, 1));
        let thin = thin.mapped(cylindrical).build().unwrap();
        let error = thin.split().unwrap_err();
        assert!(matches!(error, SplitError::Inverted { .. }));
        let help = error.help().unwrap().to_string();
        assert!(help.contains("first layer thicker"), "{help}");
    }

    #[test]
    fn a_split_box_is_the_box_with_halved_cells() {
        let list = |n| uniform(0.0, 1.0, n);
        let box_of = |n| {
            Block::new("box", list(n), list(n), list(n))
                .build()
                .unwrap()
        };
        let (split, direct) = (box_of(2).split().unwrap(), box_of(4));
        assert_eq!(split.points.len(), direct.points.len());
        assert_eq!(split.bodies, direct.bodies);
        for p in &direct.points {
            let near = |q: &&[f64; 3]| (0..3).all(|i| (p[i] - q[i]).abs() < 1e-15);
            assert!(split.points.iter().any(|q| near(&q)));
        }
        assert!((total(&split) - 1.0).abs() < 1e-14);
    }
}
