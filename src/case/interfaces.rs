//! The names of bodies, surfaces and interfaces that the bearing template and a case agree on.

/// An interface: its name, its two surfaces, and whether the roller is the upper one.
pub struct BearingInterface {
    pub name: &'static str,
    pub upper: &'static str,
    pub lower: &'static str,
    pub roller_above: bool,
}

/// Interfaces, from the top down.
pub const INTERFACES: [BearingInterface; 4] = [
    BearingInterface {
        name: "upper_plate-upper_roller",
        upper: "upper_plate_bottom",
        lower: "upper_roller_surface",
        roller_above: false,
    },
    BearingInterface {
        name: "upper_roller-intermediate_plate",
        upper: "upper_roller_surface",
        lower: "intermediate_plate_top",
        roller_above: true,
    },
    BearingInterface {
        name: "intermediate_plate-lower_roller",
        upper: "intermediate_plate_bottom",
        lower: "lower_roller_surface",
        roller_above: false,
    },
    BearingInterface {
        name: "lower_roller-lower_plate",
        upper: "lower_roller_surface",
        lower: "lower_plate_top",
        roller_above: true,
    },
];

/// The loaded face.
pub const TOP: &str = "upper_plate_top";
/// The fixed face.
pub const BOTTOM: &str = "lower_plate_bottom";
/// The faces of a quarter model in x = 0 and in y = 0.
pub const SYMMETRIES: [&str; 2] = ["x_symmetry", "y_symmetry"];
