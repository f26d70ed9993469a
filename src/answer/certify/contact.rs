//! The claims of a contact interface: those of its pressure and of its lines, and its area.

use super::figure::{Errors, Figure, Quantity, figure_of};
use super::notes::{COARSE, FILLET, SHAPE};
use super::rim;
use crate::answer::results::edges::LoadedEdges;
use crate::answer::results::hertz::{Departure, HeaviestLine};
use crate::answer::results::hex::distance;
use crate::answer::results::interface::{Interface, pressed_faces};
use crate::answer::results::load::{cutting_pair, times};
use crate::answer::results::recovery::Recovered;
use crate::ground::geometry::dot;
use crate::model::mesh::Face;
use crate::model::mesh::shape::Shape;
use crate::model::scene::Scene;
use crate::model::state::{ContactField, State};

/// Beyond this relative error a figure is not resolved.
const WORTHLESS: f64 = 0.3;

/// Of the area of the nodes at the rim, on both sides of it: the true rim lies anywhere between them. Hertz's pressure rises
/// steeply from the rim;
const RIM: f64 = 0.27;
/// around a point nodes that press stand for 15 % too little. (Of 479 areas of spheres and crowned faces on drawn
/// meshes 25 were outside with 0.27, of 60 on unstructured ones 9.)
const RIM_OF_POINT: f64 = 0.34;
/// where flat sides part, or a thin layer carries, it hardly does, and the last node that presses says less.
const FLAT_RIM: f64 = 0.45;

/// What is known of an interface.
pub(super) struct Contact<'a> {
    pub scene: &'a Scene,
    pub state: &'a State,
    pub recovered: &'a Recovered,
    pub pair: usize,
    pub interface: &'a Interface,
    pub line: Option<&'a HeaviestLine>,
    pub touch: Touch,
    pub edges: &'a LoadedEdges,
    /// By which share the mesh makes the load too large, where a prescribed motion makes it; infinite where that is not
    /// known.
    pub too_stiff: f64,
    /// By which share the pressure may be off as [`linings`](super::linings) of its bodies are too stiff.
    pub linings_off: f64,
    /// By which share the travel of the load may be off: bodies that bend more or less than they should spread it otherwise.
    pub travel_off: f64,
    /// By which share it may carry more or less of the load than it does on the mesh.
    pub shared_off: f64,
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
        let of_rim = match self.touch {
            Touch::Flat => FLAT_RIM,
            Touch::Line if self.conforms() => FLAT_RIM,
            Touch::Line => RIM,
            Touch::Point => RIM_OF_POINT,
        };
        let band = of_rim * copies * rim::area(self.scene, field, self.pair);
        let area = self.interface.area;
        claims.push(self.claim(
            Quantity::ContactArea,
            area,
            Some(
                (band / area).max(self.off_width())
                    + chords(self.scene, field, self.pair)
                    + self.too_stiff,
            ),
            COARSE,
        ));
        claims
    }

    /// How far a pressure may be off, of itself, as the interface carries another share of the load, or bodies that are moved
    /// resist otherwise. It goes with the load where faces are flat, and with its third root where contact spreads from a point;
    /// of lines that is part of [`Self::load_error`].
    pub(super) fn shared_otherwise(&self) -> f64 {
        let of_load = self.shared_off + self.too_stiff;
        match self.touch {
            Touch::Flat => of_load,
            Touch::Point => of_load / 3.0,
            Touch::Line => 0.0,
        }
    }

    /// Are its bodies no half spaces to its line, as of a pin in a hole? Of a pin that fills its hole no relative curvature is left.
    pub(super) fn conforms(&self) -> bool {
        self.line.is_some_and(|line| {
            line.contact.is_none() || line.departs == Some(Departure::Conformal)
        })
    }

    /// How far the width of the nodes in contact is from that of Hertz's strip under their load, of itself; zero where there is
    /// none.
    fn off_width(&self) -> f64 {
        let strip = self.line.filter(|line| line.is_long());
        strip.map_or(0.0, |line| match (line.contact, line.departs) {
            (Some(hertz), None | Some(Departure::LoadedEdge)) => {
                (2.0 * hertz.half_width / line.line.heaviest.pressed_width() - 1.0).abs()
            }
            _ => 0.0,
        })
    }

    /// Is its shape not there for the solution, nor known otherwise? Where nodes are too far apart for its area, too, bodies
    /// come down as far as the mesh has it.
    pub(super) fn has_no_shape(&self, claims: &[Figure]) -> bool {
        let is_strip = |line: &HeaviestLine| line.contact.is_some() && line.is_long();
        let of_area = |c: &Figure| c.what == Quantity::ContactArea && !c.is_resolved();
        !self.line.is_some_and(is_strip)
            && (claims.iter()).any(|claim| matches!(claim.note, Some(SHAPE | FILLET)))
            && claims.iter().any(of_area)
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

/// From where contact of a pair spreads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Touch {
    /// Neither side curves from the other.
    Flat,
    /// A line, or what is not known to be a point.
    Line,
    /// As of spheres and of cylinders that cross.
    Point,
}

impl Touch {
    /// Of a pair; `line` is the heaviest one.
    pub fn of(scene: &Scene, pair: usize, line: Option<&HeaviestLine>) -> Self {
        let pair = &scene.contacts[pair];
        let shapes = [&pair.upper, &pair.lower].map(|side| side.shape(&scene.mesh));
        let curves = |shape: &Shape| matches!(shape, Shape::Cylinder { .. } | Shape::Sphere { .. });
        if line.is_none_or(|line| line.contact.is_none()) && !shapes.iter().any(curves) {
            return Self::Flat;
        }
        if line.is_some_and(HeaviestLine::is_long) || is_along_cylinder(&shapes) {
            Self::Line
        } else {
            Self::Point
        }
    }
}

/// Do two sides touch along a cylinder, as far as shapes tell?
fn is_along_cylinder(sides: &[Shape; 2]) -> bool {
    const PARALLEL: f64 = 0.99;
    match sides {
        [
            Shape::Cylinder { axis, .. },
            Shape::Cylinder { axis: other, .. },
        ] => dot(*axis, *other).abs() > PARALLEL,
        [Shape::Sphere { .. }, _] | [_, Shape::Sphere { .. }] => false,
        [Shape::Cylinder { .. }, _] | [_, Shape::Cylinder { .. }] => true,
        _ => false,
    }
}

/// By which share the facets that press are smaller than the round surface that they stand for, the longest of them: a chord is
/// shorter than its arc by a third of its sagitta over the radius, and a rim of chords encloses twice as much too little.
fn chords(scene: &Scene, field: &ContactField, pair: usize) -> f64 {
    let [carrier, _] = scene.contacts[pair].carrier_first();
    let shape = carrier.shape(&scene.mesh);
    let Some(radius) = shape.radius() else {
        return 0.0;
    };
    let sagitta = |face: &Face| {
        let centre = face.centre(&scene.mesh);
        shape
            .project(centre)
            .map_or(0.0, |(foot, _)| distance(foot, centre))
    };
    let sagittas = pressed_faces(scene, pair, field).map(sagitta);
    sagittas.fold(0.0, f64::max) / radius
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cylinders_that_cross_and_spheres_touch_at_points() {
        let cylinder = |axis| Shape::Cylinder {
            point: [0.0; 3],
            axis,
            radius: 1.0,
            convex: true,
        };
        let plane = || Shape::Plane {
            point: [0.0; 3],
            normal: [0.0, 0.0, 1.0],
        };
        let sphere = || Shape::Sphere {
            centre: [0.0; 3],
            radius: 1.0,
            convex: true,
        };
        let [x, y] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        assert!(is_along_cylinder(&[cylinder(x), plane()]));
        assert!(is_along_cylinder(&[Shape::Facets, cylinder(x)]));
        assert!(is_along_cylinder(&[
            cylinder(x),
            cylinder([-1.0, 0.0, 0.0])
        ]));
        assert!(!is_along_cylinder(&[cylinder(x), cylinder(y)]));
        assert!(!is_along_cylinder(&[cylinder(x), sphere()]));
        assert!(!is_along_cylinder(&[sphere(), plane()]));
        assert!(!is_along_cylinder(&[Shape::Facets, plane()]));
    }
}
