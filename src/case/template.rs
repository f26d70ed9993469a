//! What the bearing template of the mesh generator and a case have to agree on: the names of
//! bodies and surfaces, the mesh presets, and the sizes that override a preset.

use crate::units::Dimension;

/// Bodies, from the top down.
pub const BODIES: [&str; 5] = [
    "upper_plate",
    "upper_roller",
    "intermediate_plate",
    "lower_roller",
    "lower_plate",
];

/// An interface: its name, its two surfaces, and whether the roller is the upper one.
pub struct Interface {
    pub name: &'static str,
    pub upper: &'static str,
    pub lower: &'static str,
    pub roller_above: bool,
}

/// Interfaces, from the top down.
pub const INTERFACES: [Interface; 4] = [
    Interface {
        name: "upper_plate-upper_roller",
        upper: "upper_plate_bottom",
        lower: "upper_roller_surface",
        roller_above: false,
    },
    Interface {
        name: "upper_roller-intermediate_plate",
        upper: "upper_roller_surface",
        lower: "intermediate_plate_top",
        roller_above: true,
    },
    Interface {
        name: "intermediate_plate-lower_roller",
        upper: "intermediate_plate_bottom",
        lower: "lower_roller_surface",
        roller_above: false,
    },
    Interface {
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

/// Mesh presets; the first is the default.
pub const PRESETS: [&str; 4] = ["h025", "h0125", "resolved", "report-like"];

/// Keys of `[mesh]` that override the preset, and what they measure: sizes across the contact
/// lines, counts of fine elements, ratios of neighbours, sizes along the rollers, largest sizes.
pub const MESH_KEYS: [(&str, Dimension); 14] = [
    ("roller_size", Dimension::LENGTH),
    ("plate_size", Dimension::LENGTH),
    ("fine_elements", Dimension::RATIO),
    ("fine_layers", Dimension::RATIO),
    ("growth", Dimension::RATIO),
    ("depth_growth", Dimension::RATIO),
    ("along_growth", Dimension::RATIO),
    ("crossing_size", Dimension::LENGTH),
    ("end_size", Dimension::LENGTH),
    ("around_cap", Dimension::LENGTH),
    ("along_cap", Dimension::LENGTH),
    ("plan_cap", Dimension::LENGTH),
    ("wall_cap", Dimension::LENGTH),
    ("depth_cap", Dimension::LENGTH),
];
