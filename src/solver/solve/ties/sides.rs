//! The two sides of a tie, integrated, and which of them follows.

use crate::model::mesh::{Mesh, Surface};
use crate::model::scene::{Scene, TOLERANCE_SHARE, Tie};
use crate::solver::contact::mortar::{Opposite, Pair};
use crate::solver::contact::tie::{Seam, seam};
use crate::solver::fem::loads::area;
use crate::solver::fem::tied::Joint;
use crate::solver::solve::start::extent::extent;
use crate::solver::solve::ties::error::TieError;
use std::collections::BTreeSet;

/// Share of a surface that is covered in full, whatever its facets make of a round rim.
const COVERED: f64 = 0.99;

/// Share of both surfaces of which less lies upon the other: then they do not belong together.
const NOT_COVERED: f64 = 1e-3;

/// Ratio of the mean areas of facets up to which these count as equal.
const EQUAL_FACETS: f64 = 1.1;

/// Both sides of a tie.
pub struct Sides<'s> {
    /// Its surfaces,
    pub surfaces: [&'s Surface; 2],
    /// what their nodes would follow,
    pub seams: [Seam; 2],
    /// the side that follows, unless supports hold it,
    pub first: usize,
    /// and the largest distance that is bridged.
    tolerance: f64,
}

impl<'s> Sides<'s> {
    /// The sides of `tie`.
    ///
    /// # Errors
    /// [`TieError`] where the surfaces do not belong together.
    pub fn of(scene: &'s Scene, tie: &Tie) -> Result<Self, TieError> {
        let mesh = &scene.mesh;
        let of = |index: usize| {
            let surface = mesh.surface(&tie.surfaces[index]);
            surface.ok_or_else(|| TieError::NoSurface {
                tie: tie.name.clone(),
                surface: tie.surfaces[index].clone(),
            })
        };
        let surfaces = [of(0)?, of(1)?];
        let second: BTreeSet<u32> = surfaces[1].nodes().into_iter().collect();
        if let Some(node) = surfaces[0].nodes().into_iter().find(|n| second.contains(n)) {
            return Err(TieError::SharedNodes {
                tie: tie.name.clone(),
                first: tie.surfaces[0].clone(),
                second: tie.surfaces[1].clone(),
                node,
            });
        }
        let facets = surfaces.map(|surface| mean_facet(mesh, surface));
        let tolerance = tie
            .tolerance
            .unwrap_or_else(|| TOLERANCE_SHARE * facets[0].max(facets[1]).sqrt());
        let seen = |reach: f64| [0, 1].map(|own| one_side(scene, surfaces, own, reach));
        let seams = seen(tolerance);
        let shares = [covered(&seams[0]), covered(&seams[1])];
        if shares[0].max(shares[1]) < NOT_COVERED {
            // Do they face each other at all?
            let distance = farthest(&seen(extent(scene))[0]);
            let [first, second] = tie.surfaces.clone();
            let name = tie.name.clone();
            return Err(match distance {
                d if d > tolerance => apart(tie, d, tolerance),
                _ => TieError::NoOverlap {
                    tie: name,
                    first,
                    second,
                },
            });
        }
        let first = match shares.map(|s| s >= COVERED) {
            [true, false] => 0,
            [false, true] => 1,
            [true, true] => usize::from(facets[0] > EQUAL_FACETS * facets[1]),
            [false, false] => usize::from(shares[1] > EQUAL_FACETS * shares[0]),
        };
        Ok(Self {
            surfaces,
            seams,
            first,
            tolerance,
        })
    }

    /// How the sides are joined where this one follows.
    ///
    /// # Errors
    /// [`TieError::Apart`].
    pub fn joint(&self, tie: &Tie, follows: usize) -> Result<Joint, TieError> {
        let seam = &self.seams[follows];
        let distance = farthest(seam);
        if distance > self.tolerance {
            return Err(apart(tie, distance, self.tolerance));
        }
        Ok(Joint {
            follows,
            distance,
            tolerance: self.tolerance,
            covered: covered(seam),
        })
    }
}

fn apart(tie: &Tie, distance: f64, tolerance: f64) -> TieError {
    let [first, second] = tie.surfaces.clone();
    TieError::Apart {
        tie: tie.name.clone(),
        first,
        second,
        distance,
        tolerance,
    }
}

/// Share of a side that the other one covers.
fn covered(seam: &Seam) -> f64 {
    seam.areas[0] / seam.areas[1]
}

fn one_side(scene: &Scene, surfaces: [&Surface; 2], own: usize, reach: f64) -> Seam {
    let moduli = vec![1.0; scene.materials.len()];
    seam(&Pair {
        mesh: &scene.mesh,
        carrier: surfaces[own],
        opposite: Opposite::Surface(surfaces[1 - own]),
        true_geometry: true,
        friction: false,
        closely: true,
        follow: &[],
        reach,
        moduli: &moduli,
        mirrors: &scene.mirrors,
        held: &[],
    })
}

/// The largest distance of the two sides around a node.
fn farthest(seam: &Seam) -> f64 {
    let distances = seam.nodes.iter().map(|node| node.distance);
    distances.fold(0.0, f64::max)
}

/// Mean area of the facets of a surface.
fn mean_facet(mesh: &Mesh, surface: &Surface) -> f64 {
    area(mesh, surface) / surface.faces.len().max(1) as f64
}
