//! What the bearing template of the mesh generator and a case have to agree on: the names of
//! bodies and surfaces, the mesh presets, and the sizes that override a preset.

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

/// Mesh presets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Preset {
    #[default]
    H025,
    H0125,
    Resolved {
        level: u8,
    },
    ReportLike,
}

impl Preset {
    /// One of each, the default first.
    pub const ALL: [Self; 4] = [
        Self::H025,
        Self::H0125,
        Self::Resolved { level: 0 },
        Self::ReportLike,
    ];

    /// As in case files.
    pub fn name(self) -> &'static str {
        match self {
            Self::H025 => "h025",
            Self::H0125 => "h0125",
            Self::Resolved { .. } => "resolved",
            Self::ReportLike => "report-like",
        }
    }
}

/// How a bearing is to be meshed.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MeshRequest {
    pub preset: Preset,
    /// Numbers in place of those of the preset, by key of [`MESH_KEYS`]; lengths in the unit of
    /// the case.
    pub overrides: Vec<(String, f64)>,
    /// All four quarters of a centred bearing; a displaced one is always whole.
    pub full: bool,
}

/// What a number of the mesh measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    Length,
    Count,
    Ratio,
}

/// A key of `[mesh]` that overrides a number of the preset.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MeshKey {
    pub key: &'static str,
    pub kind: Kind,
}

const fn key(key: &'static str, kind: Kind) -> MeshKey {
    MeshKey { key, kind }
}

pub const MESH_KEYS: [MeshKey; 18] = [
    key("roller_size", Kind::Length),
    key("plate_size", Kind::Length),
    key("fine_elements", Kind::Count),
    key("fine_layers", Kind::Count),
    key("crossing_size", Kind::Length),
    key("end_size", Kind::Length),
    key("growth", Kind::Ratio),
    key("depth_growth", Kind::Ratio),
    key("along_growth", Kind::Ratio),
    key("around_cap", Kind::Length),
    key("along_cap", Kind::Length),
    key("wall_cap", Kind::Length),
    key("plan_cap", Kind::Length),
    key("middle_cap", Kind::Length),
    key("depth_cap", Kind::Length),
    key("wall_least", Kind::Count),
    key("depth_least", Kind::Count),
    key("along_least", Kind::Count),
];

/// The shape of the ends of a roller.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RollerEnd {
    /// A sharp edge.
    Square,
    /// The edge rounded with this radius.
    Radius(f64),
    /// A logarithmic crown that has dropped this much at the ends.
    Crown(f64),
}

/// Dimensions of a bearing, in the length unit of the case; angles in radians.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingGeometry {
    pub diameter: f64,
    /// `None` for solid rollers.
    pub wall: Option<f64>,
    /// Of the rollers.
    pub length: f64,
    /// Of the two faces on either side of each V line.
    pub slope: f64,
    /// s, of the roller axes from the centre of the intermediate plate.
    pub offset: f64,
    /// Where the two V lines cross.
    pub intermediate_thickness: f64,
    pub upper_thickness: f64,
    pub lower_thickness: f64,
    /// Plates along x and along y.
    pub plan: [f64; 2],
    pub end: RollerEnd,
}

impl BearingGeometry {
    /// Are the rollers in the middle? Then the bearing is symmetric about x = 0 and y = 0.
    pub fn is_centred(&self) -> bool {
        self.offset == 0.0
    }
}
