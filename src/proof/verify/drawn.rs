//! A bearing that was drawn at random, and the text of its case file.

use super::stream::Stream;
use crate::render::text::significant;

/// The units of a case: of length, force and stress, and how many of its forces are one unit of stress
/// times one of area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawnUnits {
    pub system: &'static str,
    pub length: &'static str,
    pub force: &'static str,
    pub stress: &'static str,
    pub forces: f64,
}

const INCH: DrawnUnits = DrawnUnits {
    system: "in-kip-ksi",
    length: "in",
    force: "kip",
    stress: "ksi",
    forces: 1.0,
};

const METRIC: DrawnUnits = DrawnUnits {
    system: "mm-N-MPa",
    length: "mm",
    force: "kN",
    stress: "MPa",
    forces: 1e-3,
};

impl DrawnUnits {
    /// Draws units, and a diameter of rollers in them.
    pub fn draw(stream: &mut Stream) -> (Self, f64) {
        match stream.of([true, false]) {
            true => (INCH, stream.between([1.0, 12.0])),
            false => (METRIC, stream.scale([20.0, 400.0])),
        }
    }

    /// Young's modulus and some yield stresses, of steels in these units.
    pub fn steels(&self) -> (f64, [f64; 4]) {
        match *self == INCH {
            true => (29_500.0, [50.0, 100.0, 175.0, 250.0]),
            false => (203_000.0, [350.0, 690.0, 1200.0, 1700.0]),
        }
    }
}

/// How the ends of the rollers are made, lengths in the unit of the case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    Square,
    Radius(f64),
    Crown(f64),
}

impl End {
    /// As the value of `roller_end`, lengths in `unit`.
    pub fn text(self, unit: &str) -> String {
        match self {
            Self::Square => "\"square\"".to_owned(),
            Self::Radius(radius) => format!("{{ radius = \"{} {unit}\" }}", digits(radius)),
            Self::Crown(drop) => format!("{{ crown = \"{} {unit}\" }}", digits(drop)),
        }
    }
}

/// The line of a case file that says how thick the wall is; a solid roller has none.
pub fn hollow(wall: Option<f64>, unit: &str) -> String {
    match wall {
        Some(wall) => format!("roller_wall = \"{} {unit}\"", digits(wall)),
        None => "solid = true".to_owned(),
    }
}

/// The head of the table `[steel]`: Young's modulus, Poisson's ratio and yield stress.
pub fn steel_table([modulus, poisson, strength]: [f64; 3], unit: &str) -> String {
    format!(
        "[steel]\nyoungs_modulus = \"{modulus} {unit}\"\npoissons_ratio = {poisson}\n\
         yield_stress = \"{strength} {unit}\"\n"
    )
}

/// A bearing of the template, lengths and stresses in its own units.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnBearing {
    pub name: String,
    pub units: DrawnUnits,
    /// In units of [`DrawnUnits::force`].
    pub load: f64,
    pub friction: f64,
    pub diameter: f64,
    /// `None`: solid.
    pub wall: Option<f64>,
    pub length: f64,
    pub end: End,
    pub offset: f64,
    /// Slope of the intermediate plate, in degrees.
    pub degrees: f64,
    /// Is it unloaded at the end, as the case says where that is not left to the program?
    pub unload: Option<bool>,
    /// Of the upper, the intermediate and the lower plate.
    pub thickness: [f64; 3],
    pub modulus: f64,
    pub poisson: f64,
    pub strength: f64,
    /// Lines of the table `[steel]`.
    pub hardening: String,
    /// What follows it.
    pub more: String,
}

impl DrawnBearing {
    /// The case file, numbers as a designer writes them.
    pub fn text(&self) -> String {
        let (length, stress) = (self.units.length, self.units.stress);
        let (hollow, end) = (hollow(self.wall, length), self.end.text(length));
        let unload = self.unload.map(|unload| format!("unload = {unload}\n"));
        let unload = unload.unwrap_or_default();
        let [upper, middle, lower] = self.thickness.map(digits);
        format!(
            "title = \"{}\"\n\
             units = \"{}\"\n\
             [bearing]\n\
             load = \"{} {}\"\n\
             friction = {}\n\
             roller_diameter = \"{} {length}\"\n\
             {hollow}\n\
             roller_length = \"{} {length}\"\n\
             roller_end = {end}\n\
             offset = \"{} {length}\"\n\
             slope = \"{} deg\"\n\
             {unload}\n\
             [bearing.plate_thickness]\n\
             upper = \"{upper} {length}\"\n\
             intermediate = \"{middle} {length}\"\n\
             lower = \"{lower} {length}\"\n\
             \n\
             {}{}{}",
            self.name,
            self.units.system,
            digits(self.load),
            self.units.force,
            digits(self.friction),
            digits(self.diameter),
            digits(self.length),
            digits(self.offset),
            digits(self.degrees),
            steel_table([self.modulus, self.poisson, self.strength], stress),
            self.hardening,
            self.more,
        )
    }
}

/// As case files have them.
pub fn digits(value: f64) -> String {
    significant(value, 4)
}
