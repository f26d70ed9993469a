//! The claims of a contact interface: those of its pressure and of its lines, and its area.

use super::figure::{Errors, Figure, Quantity, figure_of};
use crate::answer::results::edges::LoadedEdges;
use crate::answer::results::hertz::HeaviestLine;
use crate::answer::results::interface::Interface;
use crate::answer::results::load::{cutting_pair, times};
use crate::answer::results::recovery::Recovered;
use crate::model::mesh::shape::Shape;
use crate::model::scene::{Partner, Scene};
use crate::model::state::{ContactField, State};
use std::collections::BTreeSet;

pub(super) const COARSE: &str = "the nodes are too far apart for the strip or patch of contact: the figure belongs to \
                      the mesh";
pub(super) const FILLET: &str = "the facets are too long for a fillet under load: where it begins the pressure may have a higher \
                      and narrow peak";

/// Beyond this relative error a figure is not resolved.
const WORTHLESS: f64 = 0.3;

/// Of the area of the nodes at the rim, on both sides of it: the true rim lies anywhere between them. Hertz's pressure rises
/// steeply from the rim;
const RIM: f64 = 0.27;
/// where flat sides part, or a thin layer carries, it hardly does, and the last node that presses says less.
const FLAT_RIM: f64 = 0.4;

/// What is known of an interface.
pub(super) struct Contact<'a> {
    pub scene: &'a Scene,
    pub state: &'a State,
    pub recovered: &'a Recovered,
    pub pair: usize,
    pub interface: &'a Interface,
    pub line: Option<&'a HeaviestLine>,
    /// Does one side curve from the other? See [`is_round`].
    pub is_round: bool,
    pub edges: &'a LoadedEdges,
    /// By which share the mesh makes the load too large, where a prescribed motion makes it; infinite where that is not
    /// known.
    pub too_stiff: f64,
}

impl Contact<'_> {
    /// Peak pressure, Hertz's pressure, largest line load, half-width, area and length.
    pub(super) fn claims(&self) -> Vec<Figure> {
        let Some(field) = self.state.contacts.get(self.pair) else {
            return Vec::new();
        };
        if self.interface.max_pressure <= 0.0 {
            return Vec::new();
        }
        let mut claims = self.pressures(field);
        claims.extend(self.line.into_iter().flat_map(|line| self.along(line)));
        let copies = times(&cutting_pair(self.scene, self.pair));
        let of_rim = if self.is_round { RIM } else { FLAT_RIM };
        let band = of_rim * copies * rim(self.scene, field, self.pair);
        let area = self.interface.area;
        claims.push(self.claim(
            Quantity::ContactArea,
            area,
            Some(band / area + self.too_stiff),
            COARSE,
        ));
        claims
    }

    /// With a relative error, where that says anything.
    pub(super) fn claim(
        &self,
        what: Quantity,
        value: f64,
        error: Option<f64>,
        why: &'static str,
    ) -> Figure {
        // The rim of an area is never known better than to an element.
        let most = if what == Quantity::ContactArea {
            0.5
        } else {
            WORTHLESS
        };
        let error = error.filter(|e| e.is_finite() && *e <= most);
        Figure {
            error: Errors::only_of_mesh(error.map(|e| e * value)),
            note: error.is_none().then_some(why),
            ..figure_of(what, &self.interface.name, value)
        }
    }
}

/// Does one side of a pair curve from the other, so that contact spreads from a line or a point? `line` is the heaviest one.
pub(super) fn is_round(scene: &Scene, pair: usize, line: Option<&HeaviestLine>) -> bool {
    let curves = |side: &Partner| {
        let shape = side.shape(&scene.mesh);
        matches!(shape, Shape::Cylinder { .. } | Shape::Sphere { .. })
    };
    let pair = &scene.contacts[pair];
    line.is_some_and(|line| line.contact.is_some()) || curves(&pair.upper) || curves(&pair.lower)
}

/// Area of the nodes in contact next to one that is not, and of those, modelled part.
fn rim(scene: &Scene, field: &ContactField, pair: usize) -> f64 {
    let Some(surface) = scene.carrier(pair) else {
        return 0.0;
    };
    let index = |node: u32| field.nodes.binary_search(&node).ok();
    let mut rim = BTreeSet::new();
    for face in &surface.faces {
        for side in 0..4 {
            let ends = [face.nodes[side], face.nodes[(side + 1) % 4]].map(index);
            let [Some(a), Some(b)] = ends else { continue };
            if field.is_active(a) != field.is_active(b) {
                rim.extend([a, b]);
            }
        }
    }
    rim.iter().map(|i| field.area[*i]).sum()
}
