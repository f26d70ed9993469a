//! Bores, horizontal forces and dents.

use super::figure::{Errors, Figure, Quantity, figure, figure_of};
use crate::answer::results::bore::BoreStress;
use crate::answer::results::hertz::HeaviestLine;
use crate::answer::results::interface::Interface;
use crate::answer::results::load::direction;
use crate::ground::geometry::{dot, norm, scale, sub};
use crate::model::scene::Scene;

/// Share of the distance between the two readings of a bore, that from the strain of its surface and
/// the nodal average, that the first is off: both tend to the same value, the second from farther away.
const READINGS: f64 = 0.5;

/// What elements that are deep beside the radius of the bore add to that, over their depth in radii: the stress falls
/// from the wall as fast as the wall is curved. Both hold 160 of 168 readings of bearings (docs/coverage.md).
const DEPTH: f64 = 0.12;

const YIELDED: &str =
    "the wall has yielded below the load: the strain of its surface says no stress";

/// Mises stress on the inner walls of rollers.
pub(super) fn bores(bores: &[(String, BoreStress)]) -> Vec<Figure> {
    let claim = |(body, stress): &(String, BoreStress)| {
        let nodal = stress.nodal?;
        let value = stress.mises.unwrap_or(nodal);
        Some(Figure {
            error: Errors {
                discretisation: stress.mises.map(|mises| {
                    READINGS * (mises - nodal).abs() + DEPTH * stress.coarseness * mises
                }),
                ..Errors::default()
            },
            note: stress.mises.is_none().then_some(YIELDED),
            ..figure_of(Quantity::BoreMises, body, value)
        })
    };
    bores.iter().filter_map(claim).collect()
}

/// Share of a horizontal force that depends on the mesh, over the distance of the nodes in half-widths of the strip:
/// shears settle as contact grows, node by node. The largest of 108 readings of bearings is 0.026 (docs/coverage.md).
const SHEAR: f64 = 0.03;

/// The force of an interface across the load, where there is one. Where no strip is known to be resolved it is as good as
/// that of a strip of one node to either side.
pub(super) fn horizontal_force(
    scene: &Scene,
    interface: &Interface,
    line: Option<&HeaviestLine>,
) -> Option<Figure> {
    /// Of the force along the load, what counts as none.
    const NONE: f64 = 1e-6;
    let along = direction(scene);
    let across = norm(sub(
        interface.force,
        scale(along, dot(interface.force, along)),
    ));
    let coarseness = line.map_or(1.0, |line| {
        let strip = &line.line.heaviest;
        strip.spacing() / strip.half_width
    });
    (across > NONE * interface.normal_force.abs()).then(|| Figure {
        error: Errors {
            discretisation: Some(SHEAR * coarseness * across),
            ..Errors::default()
        },
        ..figure_of(Quantity::HorizontalForce, &interface.name, across)
    })
}

const UNKNOWN_FLOW: &str = "the plastic strain that makes it is not resolved";

/// Depths of dents: as good as the plastic strain of their body.
pub(super) fn dents(dents: &[(String, String, f64)], flow: &[Figure]) -> Vec<Figure> {
    let claim = |(surface, body, depth): &(String, String, f64)| {
        let strain = figure(flow, Quantity::PeakPlasticStrain, body)?;
        let error = strain
            .error
            .total()
            .map(|error| error / strain.value * depth);
        Some(Figure {
            error: Errors {
                discretisation: error,
                ..Errors::default()
            },
            note: error.is_none().then_some(UNKNOWN_FLOW),
            ..figure_of(Quantity::Dent, surface, *depth)
        })
    };
    dents.iter().filter_map(claim).collect()
}
