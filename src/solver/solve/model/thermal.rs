//! Thermal strain: an initial strain of the elements, which the stress is free of.
//!
//! σ = C (ε − ε_p − ε_th), with ε_th = α ΔT along every axis. On elastic bodies it acts as a load,
//! f = ∫ Bᵀ C ε_th dV; the law of J2 is asked with the strain less ε_th. An element whose dilatation is one for all
//! points (B-bar) takes the mean of ε_th, for no other is free of stress in it.

use crate::model::material::j2::PlasticPoint;
use crate::model::mesh::hexahedron::{CORNERS, GAUSS, gauss_volumes, shape};
use crate::model::scene::{ElementKind, Scene, Temperature};
use crate::solver::fem::dofs::DofMap;
use crate::solver::fem::loads::at_nodes;
use crate::solver::solve::condensed::assembly::shaped;
use rayon::prelude::*;
use std::ops::Range;

/// A body with its thermal strain at factor one.
pub struct Heated {
    /// Of the temperature.
    pub name: String,
    pub elements: Range<usize>,
    /// At the integration points of each element, along every axis.
    pub strain: Vec<[f64; 8]>,
}

impl Heated {
    /// All of a scene.
    pub fn all(scene: &Scene) -> Vec<Self> {
        scene
            .temperatures
            .iter()
            .filter_map(|t| Self::of(scene, t))
            .collect()
    }

    fn of(scene: &Scene, temperature: &Temperature) -> Option<Self> {
        let mesh = &scene.mesh;
        let body = mesh.body(&temperature.body)?;
        let middle = mesh.middle_of_body(body, &scene.mirrors);
        let elements = mesh.bodies[body].elements.clone();
        let of_element = |element: usize| {
            let corners = mesh.corners(element);
            let at = |corner: [f64; 3]| {
                let shape = shape(corner.map(|c| c * GAUSS));
                let mut arm = middle.map(|m| -m);
                for (n, x) in shape.iter().zip(&corners) {
                    (0..3).for_each(|i| arm[i] += n * x[i]);
                }
                temperature.strain(arm)
            };
            let strain = CORNERS.map(at);
            match scene.controls.element {
                ElementKind::Bbar => {
                    let volumes = gauss_volumes(&corners);
                    let sum: f64 = strain.iter().zip(volumes).map(|(e, v)| e * v).sum();
                    [sum / volumes.iter().sum::<f64>(); 8]
                }
                ElementKind::Full | ElementKind::Enhanced => strain,
            }
        };
        Some(Self {
            name: temperature.name.clone(),
            strain: elements.clone().into_par_iter().map(of_element).collect(),
            elements,
        })
    }

    /// Forces on equations with which it acts on elastic bodies, at factor one.
    fn forces(&self, scene: &Scene, dofs: &DofMap) -> Vec<f64> {
        let mesh = &scene.mesh;
        let of_element = |(element, strain): (usize, &[f64; 8])| {
            let elastic = scene.materials[mesh.body_of(element)].moduli();
            let points = strain.map(|e| PlasticPoint {
                strain: [e, e, e, 0.0, 0.0, 0.0],
                peeq: 0.0,
            });
            let force = shaped(scene, element).relief(&elastic, &points);
            (mesh.hexes[element], force)
        };
        let elements = self.elements.clone().into_par_iter().zip(&self.strain);
        let forces: Vec<_> = elements.map(of_element).collect();
        dofs.gather(&at_nodes(mesh.points.len(), forces))
    }
}

/// Load vectors of all temperatures at factor one, by name.
pub fn thermal_forces(scene: &Scene, heated: &[Heated], dofs: &DofMap) -> Vec<(String, Vec<f64>)> {
    let of = |body: &Heated| (body.name.clone(), body.forces(scene, dofs));
    heated.iter().map(of).collect()
}
