//! `brinell hertz`: the handbook at the command line.

mod table;
mod units;

use clap::Args;
use serde::Serialize;

pub use units::HandbookUnits;

use crate::analytic::DomainError;
use crate::analytic::handbook::{Handbook, HandbookAnswer, Metal, handbook};

/// Hertz contact of a roller on a plate, ring bending, sizing: closed forms only.
#[derive(Debug, Clone, PartialEq, Args)]
#[command(
    after_help = "Example, the rollers of the published study in inch, kip, ksi:
  brinell hertz --diameter 3 --wall 0.75 --length 8 --load 65 --yield 100"
)]
pub struct HertzArgs {
    /// Units of every number below and of the answer.
    #[arg(long, value_enum, default_value = "in-kip-ksi")]
    pub units: HandbookUnits,
    /// Outer diameter D of the roller, in the length of the units.
    #[arg(long, value_name = "LENGTH")]
    pub diameter: f64,
    /// Wall thickness of a hollow roller [default: solid].
    #[arg(long, value_name = "LENGTH")]
    pub wall: Option<f64>,
    /// Length L of the roller.
    #[arg(long, value_name = "LENGTH")]
    pub length: f64,
    /// Load P on the roller, in the force of the units.
    #[arg(long, value_name = "FORCE")]
    pub load: f64,
    /// Yield stress of the roller, in the stress of the units.
    #[arg(long = "yield", value_name = "STRESS")]
    pub yield_stress: f64,
    /// Young's modulus of the roller [default: 29500 ksi].
    #[arg(long, value_name = "STRESS")]
    pub youngs_modulus: Option<f64>,
    /// Poisson's ratio of the roller.
    #[arg(long, value_name = "RATIO", default_value_t = 0.3)]
    pub poissons_ratio: f64,
    /// Yield stress of the plate [default: as the roller].
    #[arg(long, value_name = "STRESS")]
    pub plate_yield: Option<f64>,
    /// Young's modulus of the plate [default: as the roller].
    #[arg(long, value_name = "STRESS")]
    pub plate_youngs_modulus: Option<f64>,
    /// Poisson's ratio of the plate [default: as the roller].
    #[arg(long, value_name = "RATIO")]
    pub plate_poissons_ratio: Option<f64>,
    /// Thickness of the plate, to check that it is thick enough.
    #[arg(long, value_name = "LENGTH")]
    pub plate_thickness: Option<f64>,
    /// Distance of the load's resultant from the roller's mid-length.
    #[arg(long, value_name = "LENGTH")]
    pub offset: Option<f64>,
    /// Slope of each side of a V groove, in degrees.
    #[arg(long, value_name = "DEGREES")]
    pub groove_angle: Option<f64>,
    /// Coefficient of friction.
    #[arg(long, value_name = "RATIO", default_value_t = 0.0)]
    pub friction: f64,
    /// Print JSON instead of a table.
    #[arg(long)]
    pub json: bool,
}

/// Question and answer, as JSON.
#[derive(Serialize)]
struct Sheet<'a> {
    units: HandbookUnits,
    input: &'a Handbook,
    answer: &'a HandbookAnswer,
}

impl HertzArgs {
    /// The question these arguments put.
    pub fn input(&self) -> Handbook {
        let modulus = self.youngs_modulus.unwrap_or(self.units.steel_modulus());
        Handbook {
            diameter: self.diameter,
            wall: self.wall,
            length: self.length,
            load: self.load,
            roller: Metal {
                youngs_modulus: modulus,
                poissons_ratio: self.poissons_ratio,
                yield_stress: self.yield_stress,
            },
            plate: Metal {
                youngs_modulus: self.plate_youngs_modulus.unwrap_or(modulus),
                poissons_ratio: self.plate_poissons_ratio.unwrap_or(self.poissons_ratio),
                yield_stress: self.plate_yield.unwrap_or(self.yield_stress),
            },
            plate_thickness: self.plate_thickness,
            offset: self.offset,
            groove_angle: self.groove_angle,
            friction: self.friction,
        }
    }
}

/// The answer to the arguments as the text to print: a table, or JSON.
///
/// # Errors
/// [`DomainError`] for an argument outside its range.
pub fn answer(args: &HertzArgs) -> Result<String, DomainError> {
    let input = args.input();
    let answer = handbook(&input)?;
    let sheet = Sheet {
        units: args.units,
        input: &input,
        answer: &answer,
    };
    if args.json {
        // Numbers, words and lists: nothing in the sheet can fail to serialize.
        return Ok(serde_json::to_string_pretty(&sheet).unwrap_or_default());
    }
    Ok(table::table(args.units, &answer))
}

/// Prints the answer to standard output.
///
/// # Errors
/// [`DomainError`] for an argument outside its range.
pub fn run(args: &HertzArgs) -> Result<(), DomainError> {
    crate::cli::output::say(answer(args)?.trim_end());
    Ok(())
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;

    #[derive(Parser)]
    struct Command {
        #[command(flatten)]
        hertz: HertzArgs,
    }

    fn ask(words: &str) -> Result<String, DomainError> {
        let words = std::iter::once("hertz").chain(words.split_whitespace());
        answer(&Command::try_parse_from(words).unwrap().hertz)
    }

    const STUDY: &str = "--diameter 3 --wall 0.75 --length 8 --load 65 --yield 100 --friction 0.15 \
                         --groove-angle 4 --offset 1.25 --plate-thickness 1";

    #[test]
    fn table_of_the_study() {
        let text = ask(STUDY).unwrap();
        let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
        for row in [
            "peak pressure p0 167.17 ksi",
            "roller 93.202 ksi",
            "7.7832 24.636 in²",
        ] {
            assert!(words.contains(row), "{row} in\n{text}");
        }
        assert!(text.lines().all(|line| line.chars().count() < 80), "{text}");
    }

    #[test]
    fn json_of_the_study() {
        let text = ask(&format!("{STUDY} --json")).unwrap();
        let value: serde_json::Value = serde_json::from_str(&text).unwrap();
        assert_eq!(value["units"], "in-kip-ksi");
        assert_eq!(value["input"]["diameter"], 3.0);
        assert_eq!(value["answer"]["within_limit"], false);
        assert_eq!(value["answer"]["line_load"], 8.125);
    }

    #[test]
    fn a_bad_argument_is_named() {
        let words = "--diameter 3 --length 8 --load=-65 --yield 100";
        assert_eq!(
            ask(words).unwrap_err().to_string(),
            "load is -65, but it must be positive and finite"
        );
    }
}
