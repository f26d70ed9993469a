//! Parallel rollers as a [`Layout`].

use super::LinePlate;
use super::curve::curve_plate;
use super::geometry::LineGeometry;
use super::sizes;
use crate::analytic::DomainError;
use crate::analytic::hertz::LineContact;
use crate::case::bearing::end_shape::RollerEnd;
use crate::case::bearing::end_zone::EndZone;
use crate::case::bearing::error::GeometryError;
use crate::case::bearing::grading::{GradedInterval, Stop};
use crate::case::bearing::layout::{Layout, RollerPlace};
use crate::case::bearing::parameter::Parameter;
use crate::case::bearing::preset::Preset;
use crate::case::bearing::roller_end::shape_roller_ends;
use crate::case::bearing::roller_shape::RollerShape;
use crate::case::bearing::seat::Seat;
use crate::case::bearing::sizes::Sizes;
use crate::case::bearing::skew::turn_rollers;
use crate::case::bearing::strips::Strips;
use crate::case::bearing::template::{LINE, Template};
use crate::model::mesh::Mesh;
use std::f64::consts::PI;

/// Square ends press harder on plates that stand out beyond them: by this factor over the even load, in which the
/// strip is wider there.
const AT_ENDS: f64 = 1.3;

impl LineGeometry {
    pub(super) fn end_zone(&self) -> EndZone {
        let part = |plate: &LinePlate| plate.plan[0] / self.rollers as f64;
        let faces = [&self.upper, &self.lower].map(|plate| plate.plan[1].max(part(plate)));
        EndZone::new(&self.roller, faces, (true, 0.5 * self.roller.length))
    }

    fn is_whole(&self, full: bool) -> bool {
        full || self.is_askew()
    }

    fn mirrors_x(&self, full: bool) -> bool {
        self.alike && !self.is_whole(full)
    }

    /// Numbers of the rollers that are modelled.
    fn modelled(&self, full: bool) -> impl Iterator<Item = usize> {
        let first = match self.mirrors_x(full) {
            true => self.rollers / 2 + 1,
            false => 1,
        };
        first..=self.rollers
    }

    fn seat(&self, number: usize, upper: bool) -> Seat {
        let (roller, suffix) = (self.body(number), self.suffix(number));
        let (plate, face) = match upper {
            true => ("upper_plate", format!("upper_plate_bottom{suffix}")),
            false => ("lower_plate", format!("lower_plate_top{suffix}")),
        };
        let surface = format!("{roller}_surface");
        let (own, curvature) = (
            if upper { self.upper } else { self.lower },
            self.curvature(upper),
        );
        let [above, below] = match upper {
            true => [face, surface],
            false => [surface, face],
        };
        Seat {
            interface: match upper {
                true => format!("{plate}-{roller}"),
                false => format!("{roller}-{plate}"),
            },
            upper: above,
            lower: below,
            roller,
            plate: plate.to_owned(),
            roller_above: !upper,
            axis: 1,
            radius: match curvature {
                0.0 => self.roller.radius(),
                curvature => 1.0 / (2.0 / self.roller.diameter + curvature),
            },
            curvature,
            slope: 0.0,
            lines: vec![self.place(number)],
            sharing: self.rollers,
            determinate: self.rollers == 1 || (self.rollers == 2 && self.alike),
            bears: self.roller.straight().min(own.plan[1]),
            ends_at: self.roller.ends_on(own.plan[1]),
            overhang: (0.5 * (own.plan[1] - self.roller.length)).max(0.0),
            plate_thickness: own.thickness,
        }
    }
}

impl Layout for LineGeometry {
    fn table(&self) -> &'static str {
        "line_bearing"
    }

    fn check(&self) -> Result<(), GeometryError> {
        LineGeometry::check(self)
    }

    fn roller(&self) -> RollerShape {
        self.roller
    }

    fn offset(&self) -> f64 {
        0.0
    }

    fn height_range(&self) -> [f64; 2] {
        let radius = self.roller.radius();
        [
            -radius - self.lower.thickness,
            radius + self.upper.thickness,
        ]
    }

    /// On the axis of the rollers, which then stand off both plates by half of the angle; about the line of contact the
    /// plate would drag them along their axes.
    fn pivot(&self) -> [f64; 3] {
        [0.0; 3]
    }

    fn mirrors(&self, full: bool) -> Vec<usize> {
        match (self.is_whole(full), self.alike) {
            (true, _) => Vec::new(),
            (false, true) => vec![0, 1],
            (false, false) => vec![1],
        }
    }

    /// Also a hollow roller is turned from a bar.
    fn bodies(&self) -> Vec<(String, f64)> {
        let rollers = (1..=self.rollers).map(|number| (self.body(number), self.roller.diameter));
        let upper = ("upper_plate".to_owned(), self.upper.thickness);
        let lower = ("lower_plate".to_owned(), self.lower.thickness);
        let all = std::iter::once(upper).chain(rollers);
        all.chain(std::iter::once(lower)).collect()
    }

    fn rollers(&self, full: bool) -> Vec<RollerPlace> {
        let place = |number| RollerPlace {
            body: self.body(number),
            axis: 1,
            centre: [self.place(number), 0.0, 0.0],
            skew: self.skew.get(number - 1).copied().unwrap_or_default(),
        };
        self.modelled(full).map(place).collect()
    }

    fn seats(&self, full: bool) -> Vec<Seat> {
        let upper = self.modelled(full).map(|number| self.seat(number, true));
        let lower = self.modelled(full).map(|number| self.seat(number, false));
        upper.chain(lower).collect()
    }

    fn presets(&self) -> &'static [Preset] {
        &[Preset::Auto, Preset::H025, Preset::H0125]
    }

    fn preset_sizes(&self, preset: Preset, strips: &Strips) -> Sizes {
        sizes::sizes(preset, self, strips)
    }

    /// Of an even load, and of what square ends press where plates stand out beyond them.
    fn predicted(&self, load: f64, full: bool, compliance: &[f64]) -> Result<Strips, DomainError> {
        let mut widths = Vec::new();
        for (seat, compliance) in self.seats(full).iter().zip(compliance) {
            let even = seat.even(load) / self.roller.length;
            let width = |line_load: f64| {
                LineContact::new(line_load, seat.radius, *compliance).map(|line| line.half_width)
            };
            widths.push(width(even)?);
            if seat.overhang > 0.0 && self.roller.end == RollerEnd::Square {
                widths.push(width(AT_ENDS * even)?);
            }
        }
        Ok(Strips::even(self.roller.diameter, &widths))
    }

    fn parameters(&self, full: bool, _uniform: bool) -> Vec<Parameter> {
        let flag = |set: bool| f64::from(u8::from(set));
        let mut parameters = vec![
            Parameter::number("Rollers", self.rollers as f64),
            Parameter::length("Spacing", self.spacing),
            Parameter::length("Diameter", self.roller.diameter),
            Parameter::length("Wall", self.roller.wall.unwrap_or(0.0)),
            Parameter::length("RollerLength", self.roller.length),
            Parameter::length("UpperThickness", self.upper.thickness),
            Parameter::length("LowerThickness", self.lower.thickness),
            Parameter::length("UpperX", self.upper.plan[0]),
            Parameter::length("UpperY", self.upper.plan[1]),
            Parameter::length("LowerX", self.lower.plan[0]),
            Parameter::length("LowerY", self.lower.plan[1]),
            Parameter::number("MirrorX", flag(self.mirrors_x(full))),
            Parameter::number("MirrorY", flag(!self.is_whole(full))),
        ];
        parameters.extend(self.end_zone().parameters());
        parameters
    }

    fn without(&self) -> &'static [&'static str] {
        &["crossing_size", "middle_cap"]
    }

    fn template(&self) -> &'static Template {
        &LINE
    }

    fn elements(&self, sizes: &Sizes, full: bool) -> f64 {
        let count = |growth, cap, least, stops: &[Stop]| {
            let grading = GradedInterval {
                growth,
                cap,
                least,
                uniform: false,
            };
            grading.elements(stops)
        };
        let radius = self.roller.radius();
        let fine = |at, size| (at, Some(size), sizes.fine_elements);
        let any = |at| (at, None, 1.0);
        // A quarter of the turn, from a line of contact to the side.
        let turn = [fine(0.0, sizes.roller_size), any(0.5 * PI * radius)];
        let quarter = count(sizes.growth, sizes.around_cap, 1.0, &turn);
        let inner = self.roller.wall.map_or(0.5 * radius, |wall| radius - wall);
        let surface = (radius, Some(sizes.roller_size), sizes.fine_layers);
        let depth = (sizes.depth_growth, sizes.wall_cap, sizes.wall_least);
        let through = count(depth.0, depth.1, depth.2, &[any(inner), surface]);
        let core = match self.roller.wall {
            Some(_) => 0.0,
            None => quarter * quarter,
        };
        let along =
            |least, stops: &[Stop]| count(sizes.along_growth, sizes.along_cap, least, stops);
        let ends = self
            .end_zone()
            .stops(sizes.end_size, 0.5 * self.roller.length);
        let half = along(sizes.along_least, &[any(0.0), ends[0]]) + along(1.0, &ends);
        let roller = (4.0 * quarter * through + core) * 2.0 * half;
        let plate = |plate: &LinePlate| {
            let pitch = match self.rollers {
                1 => plate.plan[0] / 2.0,
                _ => (self.spacing / 2.0).min(plate.plan[0] / 2.0),
            };
            let stops = [fine(0.0, sizes.plate_size), any(pitch)];
            let across = count(sizes.growth, sizes.plan_cap, 1.0, &stops);
            let face = (0.0, Some(sizes.plate_size), sizes.fine_layers);
            let stops = [face, any(plate.thickness)];
            let deep = count(
                sizes.depth_growth,
                sizes.depth_cap,
                sizes.depth_least,
                &stops,
            );
            let beyond = 0.5 * (plate.plan[1] - self.roller.length) / sizes.along_cap;
            2.0 * across * self.rollers as f64 * 2.0 * (half + beyond.max(0.0)) * deep
        };
        let all = self.rollers as f64 * roller + plate(&self.upper) + plate(&self.lower);
        all / f64::from(1 << self.mirrors(full).len())
    }

    fn shape(&self, mesh: &mut Mesh, full: bool) {
        shape_roller_ends(mesh, self, full);
        turn_rollers(mesh, self, full);
        curve_plate(mesh, self);
    }
}
