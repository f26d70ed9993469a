//! What `brinell hertz` takes.

use crate::cli::share::share;
use crate::ground::units::UnitSystem;
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::path::PathBuf;

/// Hertz contact of a roller on a plate, ring bending, sizing, design rules: closed forms only.
#[derive(Debug, Clone, PartialEq, Args)]
#[command(after_help = "\
Quantities carry their units and stand in quotes; bare numbers are taken in the units that --units names, and refused \
without it. The rollers of the published study, and one of a bridge by the name of its steel:
  brinell hertz --diameter \"3 in\" --wall \"0.75 in\" --length \"8 in\" --load \"65 kip\" --yield \"100 ksi\"
  brinell hertz --units in-kip-ksi --diameter 3 --wall 0.75 --length 8 --load 65 --yield 100
  brinell hertz --diameter \"160 mm\" --length \"400 mm\" --load \"300 kN\" --steel S355")]
pub struct HertzArgs {
    /// Units of the answer and of bare numbers [default: of the answer in-kip-ksi or mm-N-MPa, as the load].
    #[arg(long, value_parser = systems())]
    pub units: Option<UnitSystem>,
    /// Outer diameter D of the roller, such as "160 mm".
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub diameter: String,
    /// Wall thickness of a hollow roller [default: solid].
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub wall: Option<String>,
    /// Length L of the roller.
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub length: String,
    /// Load P on the roller, such as "300 kN".
    #[arg(long, value_name = "FORCE", allow_hyphen_values = true)]
    pub load: String,
    /// Steel of the roller by name, such as S355; its strength is that of a bar of the roller's diameter.
    #[arg(long, value_name = "GRADE")]
    pub steel: Option<String>,
    /// Yield stress of the roller, such as "355 MPa" [default: of the steel].
    #[arg(long = "yield", value_name = "STRESS", allow_hyphen_values = true)]
    pub yield_stress: Option<String>,
    /// Ultimate strength of the roller, for design rules [default: of the steel].
    #[arg(long, value_name = "STRESS", allow_hyphen_values = true)]
    pub ultimate: Option<String>,
    /// Brinell hardness of the roller, for design rules [default: of the steel].
    #[arg(long, value_name = "HB", allow_negative_numbers = true)]
    pub hardness: Option<f64>,
    /// Young's modulus of the roller [default: of the steel, else 29500 ksi].
    #[arg(long, value_name = "STRESS", allow_hyphen_values = true)]
    pub youngs_modulus: Option<String>,
    /// Poisson's ratio of the roller [default: of the steel, else 0.3].
    #[arg(long, value_name = "RATIO", allow_negative_numbers = true, value_parser = share)]
    pub poissons_ratio: Option<f64>,
    /// Steel of the plate by name [default: as the roller].
    #[arg(long, value_name = "GRADE")]
    pub plate_steel: Option<String>,
    /// Yield stress of the plate [default: as the roller].
    #[arg(long, value_name = "STRESS", allow_hyphen_values = true)]
    pub plate_yield: Option<String>,
    /// Ultimate strength of the plate [default: as the roller].
    #[arg(long, value_name = "STRESS", allow_hyphen_values = true)]
    pub plate_ultimate: Option<String>,
    /// Brinell hardness of the plate [default: as the roller].
    #[arg(long, value_name = "HB", allow_negative_numbers = true)]
    pub plate_hardness: Option<f64>,
    /// Young's modulus of the plate [default: as the roller].
    #[arg(long, value_name = "STRESS", allow_hyphen_values = true)]
    pub plate_youngs_modulus: Option<String>,
    /// Poisson's ratio of the plate [default: as the roller].
    #[arg(long, value_name = "RATIO", allow_negative_numbers = true, value_parser = share)]
    pub plate_poissons_ratio: Option<f64>,
    /// Thickness of the plate, to check that it is thick enough, and for the strength of its steel.
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub plate_thickness: Option<String>,
    /// File with steel grades of your own.
    #[arg(long, value_name = "FILE")]
    pub grades: Option<PathBuf>,
    /// Roller and plate are hardened at their surfaces, over softer cores that the yield stresses are of.
    #[arg(long)]
    pub surface_hardened: bool,
    /// Radius of the edge of the roller, for design rules [default: square].
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub end_radius: Option<String>,
    /// By how much the plate stands out beyond the contact at the roller's end, for design rules.
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub overhang: Option<String>,
    /// Rotation of the bearing about the axis of the roller, for design rules.
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub rotation: Option<String>,
    /// How often a point is rolled over under the full load, for design rules of fatigue.
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true)]
    pub rollings: Option<f64>,
    /// Distance of the load's resultant from the roller's mid-length.
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub offset: Option<String>,
    /// Slope of each side of a V groove, such as "4 deg".
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub groove_angle: Option<String>,
    /// Coefficient of friction, such as 0.15 or "15 %".
    #[arg(
        long,
        value_name = "RATIO",
        default_value_t = 0.0,
        allow_negative_numbers = true,
        value_parser = share
    )]
    pub friction: f64,
    /// Print JSON instead of a table.
    #[arg(long)]
    pub json: bool,
}

/// Takes the name of a system of units.
fn systems() -> impl TypedValueParser<Value = UnitSystem> {
    let names = UnitSystem::ALL.map(UnitSystem::name);
    // Only these names pass.
    PossibleValuesParser::new(names)
        .map(|name| UnitSystem::from_name(&name).unwrap_or(UnitSystem::MNPa))
}
