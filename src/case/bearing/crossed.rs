//! Two crossed rollers as a [`Layout`].

use super::count;
use super::end_zone::EndZone;
use super::error::GeometryError;
use super::geometry::{BearingGeometry, Roller};
use super::layout::{Layout, RollerPlace};
use super::parameter::Parameter;
use super::preset::Preset;
use super::preset_sizes;
use super::roller_end::shape_roller_ends;
use super::roller_shape::RollerShape;
use super::seat::Seat;
use super::sizes::Sizes;
use super::skew::turn_rollers;
use super::strips::Strips;
use super::template::{CROSSED, Template};
use crate::analytic::DomainError;
use crate::case::interfaces::{BearingInterface, INTERFACES};
use crate::model::mesh::Mesh;

impl BearingGeometry {
    fn is_whole(&self, full: bool) -> bool {
        full || !self.is_centred() || self.is_askew()
    }

    fn seat(&self, interface: &BearingInterface) -> Seat {
        let (above, below) = interface.name.split_once('-').unwrap_or_default();
        let [roller, plate] = match interface.roller_above {
            true => [above, below],
            false => [below, above],
        };
        let axis = usize::from(roller == Roller::Upper.body());
        let valley = plate == "intermediate_plate";
        Seat {
            interface: interface.name.to_owned(),
            upper: interface.upper.to_owned(),
            lower: interface.lower.to_owned(),
            roller: roller.to_owned(),
            plate: plate.to_owned(),
            roller_above: interface.roller_above,
            axis,
            radius: self.radius(),
            curvature: 0.0,
            slope: if valley { self.slope } else { 0.0 },
            lines: match valley {
                true => self.v_lines(),
                false => vec![self.offset],
            },
            sharing: 1,
            determinate: self.is_centred(),
            bears: self.roller.straight().min(self.plan[axis]),
            ends_at: self.roller.ends_on(self.plan[axis]),
            overhang: (0.5 * (self.plan[axis] - self.roller.length)).max(0.0),
            plate_thickness: match plate {
                "upper_plate" => self.upper_thickness,
                "lower_plate" => self.lower_thickness,
                _ => self.intermediate_thickness,
            },
        }
    }

    /// Where plates end on the straight part of a roller, from its middle, ascending.
    pub(super) fn plate_edges(&self) -> Vec<f64> {
        let [near, far] = [f64::min, f64::max].map(|of| 0.5 * of(self.plan[0], self.plan[1]));
        let is_apart = far > near * (1.0 + 1e-9);
        let edges = [Some(near), Some(far).filter(|_| is_apart)]
            .into_iter()
            .flatten();
        let straight = 0.5 * self.roller.straight() * (1.0 - 1e-9);
        edges.filter(|edge| *edge < straight).collect()
    }

    /// The ends of displaced rollers carry, and the edges of plates that are shorter. `uniform` meshes have no planes there.
    pub(super) fn end_zone(&self, uniform: bool) -> EndZone {
        if uniform {
            return EndZone::default();
        }
        let faces = [self.plan[0].max(self.plan[1])];
        let zone =
            |end: f64, carry: bool| EndZone::new(&self.roller, faces, (carry, end - self.v_line()));
        match self.plate_edges().first() {
            Some(edge) => zone(*edge, true).sharp(),
            None => zone(0.5 * self.roller.length, !self.is_centred()),
        }
    }
}

impl Layout for BearingGeometry {
    fn table(&self) -> &'static str {
        "bearing"
    }

    fn check(&self) -> Result<(), GeometryError> {
        BearingGeometry::check(self)
    }

    fn roller(&self) -> RollerShape {
        self.roller
    }

    fn offset(&self) -> f64 {
        self.offset
    }

    fn height_range(&self) -> [f64; 2] {
        BearingGeometry::height_range(self)
    }

    /// On the lower face of the upper plate, which rocks on the roller below.
    fn pivot(&self) -> [f64; 3] {
        let [_, top] = BearingGeometry::height_range(self);
        [2.0 * self.offset, 0.0, top - self.upper_thickness]
    }

    fn mirrors(&self, full: bool) -> Vec<usize> {
        match self.is_whole(full) {
            true => Vec::new(),
            false => vec![0, 1],
        }
    }

    /// Also a hollow roller is turned from a bar.
    fn bodies(&self) -> Vec<(String, f64)> {
        let sizes = [
            ("upper_plate", self.upper_thickness),
            ("upper_roller", self.roller.diameter),
            ("intermediate_plate", self.intermediate_thickness),
            ("lower_roller", self.roller.diameter),
            ("lower_plate", self.lower_thickness),
        ];
        sizes.map(|(body, size)| (body.to_owned(), size)).into()
    }

    fn rollers(&self, _full: bool) -> Vec<RollerPlace> {
        let place = |roller: Roller| RollerPlace {
            body: roller.body().to_owned(),
            axis: roller.axis(),
            centre: self.roller_centre(roller),
            skew: self.skew[1 - roller.axis()],
        };
        Roller::BOTH.map(place).into()
    }

    fn seats(&self, _full: bool) -> Vec<Seat> {
        INTERFACES.iter().map(|i| self.seat(i)).collect()
    }

    fn presets(&self) -> &'static [Preset] {
        &Preset::ALL
    }

    fn preset_sizes(&self, preset: Preset, strips: &Strips) -> Sizes {
        preset_sizes::sizes(preset, self, strips)
    }

    fn predicted(&self, load: f64, _full: bool, compliance: &[f64]) -> Result<Strips, DomainError> {
        let [upper, upper_valley, lower_valley, lower] = *compliance else {
            return Ok(Strips::nominal(self.roller.diameter));
        };
        Strips::predicted(self, load, [upper, lower], [upper_valley, lower_valley])
    }

    fn parameters(&self, full: bool, uniform: bool) -> Vec<Parameter> {
        let flag = |set: bool| f64::from(u8::from(set));
        let mut parameters = vec![
            Parameter::length("Diameter", self.roller.diameter),
            Parameter::length("Wall", self.roller.wall.unwrap_or(0.0)),
            Parameter::length("RollerLength", self.roller.length),
            Parameter::number("Slope", self.slope),
            Parameter::length("Offset", self.offset),
            Parameter::length("UpperThickness", self.upper_thickness),
            Parameter::length("MiddleThickness", self.intermediate_thickness),
            Parameter::length("LowerThickness", self.lower_thickness),
            Parameter::length("PlanX", self.plan[0]),
            Parameter::length("PlanY", self.plan[1]),
            Parameter::number("Full", flag(self.is_whole(full))),
            Parameter::number("Uniform", flag(uniform)),
        ];
        parameters.extend(self.end_zone(uniform).parameters());
        let edges = ["PlateEdge", "PlateEdgeFar"]
            .into_iter()
            .zip(self.plate_edges());
        parameters.extend(edges.map(|(name, edge)| Parameter::length(name, edge)));
        parameters
    }

    fn without(&self) -> &'static [&'static str] {
        &[]
    }

    fn template(&self) -> &'static Template {
        &CROSSED
    }

    fn elements(&self, sizes: &Sizes, full: bool) -> f64 {
        count::elements(self, sizes, self.is_whole(full))
    }

    fn shape(&self, mesh: &mut Mesh, full: bool) {
        shape_roller_ends(mesh, self, full);
        turn_rollers(mesh, self, full);
    }
}
