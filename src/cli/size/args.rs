//! The arguments of `brinell size`, of all templates.

use crate::case::bearing::{Preset, RollerEnd};
use crate::cli::share::share;
use crate::ground::units::{Dimension, UnitSystem};
use crate::product::size::{SizeError, quantity, units_of_load};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// What kind of bearing is sized.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum TemplateName {
    /// Two crossed rollers in V valleys.
    #[default]
    Crossed,
    /// Parallel rollers between two flat plates.
    Line,
}

/// What determines the length of the rollers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum RuleName {
    /// (2-50) with the constant as printed, 8, and (2-51).
    Printed,
    /// (2-50) with the exact constant, 7.783, and (2-51).
    Exact,
    /// That, and what statics ask of a displaced roller, which leans on one end.
    Eccentric,
}

#[derive(Debug, Args)]
#[command(after_help = "\
Quantities carry their units and stand in quotes. Sizes come in inches or millimetres, by the unit of \
the load, unless --units says otherwise.

    brinell size --load \"210 kip\" --yield \"175 ksi\" --capacity \"3 in\" --verify --out bearing

writes bearing/centre.toml and bearing/displaced.toml, solves both into bearing/centre and \
bearing/displaced, and writes bearing/verdict.json and verdict.md. Stopped, it goes on where it was \
when it is given again.

    brinell size --template line --load \"450 kN\" --yield \"460 MPa\" --verify --out roller

sizes parallel rollers and writes roller/line.toml. Exit status: 0 all limits met, 1 one missed, 2 bad input, 3 not converged, \
130 interrupted.")]
pub struct SizeArgs {
    /// Vertical load P on the bearing, factored, such as "210 kip".
    #[arg(long, allow_hyphen_values = true)]
    pub load: String,
    /// Yield stress of rollers and plates, such as "175 ksi".
    #[arg(long = "yield", allow_hyphen_values = true)]
    pub yield_stress: String,
    /// Crossed rollers in valleys, or parallel ones between flat plates.
    #[arg(long, value_enum, default_value_t)]
    pub template: TemplateName,
    /// Displacement capacity 2 D_r of a bearing of crossed rollers, such as "3 in"; a roller travels half as far.
    #[arg(long, allow_hyphen_values = true)]
    pub capacity: Option<String>,
    /// How many parallel rollers, 1 to 12 [default: as few as will do of a given diameter, else 1].
    #[arg(long)]
    pub rollers: Option<usize>,
    /// Distance between the axes of parallel rollers [default: 1.4 diameters].
    #[arg(long, allow_hyphen_values = true)]
    pub spacing: Option<String>,
    /// Solve the recommended bearing at s = 0 and s = D_r, and hold every part and every line of
    /// contact against its limit.
    #[arg(long)]
    pub verify: bool,
    /// Folder for the case files, results and verdict.
    #[arg(long, default_value = "results/size")]
    pub out: PathBuf,
    /// Where the verdict misses a limit: go on with the design it advises, up to so many designs in
    /// all, each in a folder of its own, design-1 and on.
    #[arg(long, value_name = "DESIGNS", default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=9))]
    pub tries: u8,
    /// Diameter D, instead of a series.
    #[arg(long, allow_hyphen_values = true)]
    pub diameter: Option<String>,
    /// Length of the rollers, L' of crossed ones, instead of what the rule asks for.
    #[arg(long, allow_hyphen_values = true)]
    pub length: Option<String>,
    /// Wall over diameter, such as 0.25 or "25 %" [default: 0.25; parallel rollers are solid].
    #[arg(long, allow_negative_numbers = true, value_parser = share)]
    pub wall: Option<f64>,
    /// Thickness of the plates [default: 4/3 of the wall; 0.3 D with parallel rollers].
    #[arg(long, allow_hyphen_values = true)]
    pub plate: Option<String>,
    /// Slope of the V [default: 4 deg].
    #[arg(long, allow_hyphen_values = true)]
    pub slope: Option<String>,
    /// Coefficient of friction, such as 0.1 or "10 %" [default: 0.1].
    #[arg(long, allow_negative_numbers = true, value_parser = share)]
    pub friction: Option<f64>,
    /// Lever δ of rolling friction, (2-3) [default: 0.002 in].
    #[arg(long, allow_hyphen_values = true)]
    pub rolling_lever: Option<String>,
    /// Ends of the rollers: square, "radius 1 mm" or "crown 20 µm" [default: square].
    #[arg(long)]
    pub end: Option<String>,
    /// Young's modulus [default: 29500 ksi].
    #[arg(long, allow_hyphen_values = true)]
    pub modulus: Option<String>,
    /// Poisson's ratio [default: 0.3].
    #[arg(long, allow_negative_numbers = true, value_parser = share)]
    pub poisson: Option<f64>,
    /// Slope of the stress-strain line beyond yield [default: a hundredth of the modulus].
    #[arg(long, allow_hyphen_values = true)]
    pub tangent_modulus: Option<String>,
    /// Allowed contact pressure over the yield stress [default: 1.65, (2-49)].
    #[arg(long, allow_negative_numbers = true, value_parser = share)]
    pub limit: Option<f64>,
    /// What determines the length of the rollers [default: eccentric].
    #[arg(long, value_enum)]
    pub rule: Option<RuleName>,
    /// Ask the rule for so many times the load [default: 1.4 with eccentric, else 1; 1.1 with parallel rollers].
    #[arg(long, allow_negative_numbers = true, value_parser = share)]
    pub margin: Option<f64>,
    /// Mesh preset of the cases: auto, report-like, h025 or h0125 [default: h0125; auto with parallel rollers].
    #[arg(long)]
    pub mesh: Option<String>,
    /// Units of the answer and of the case files, such as mm-N-MPa.
    #[arg(long)]
    pub units: Option<String>,
    /// Threads to use; by default one a core.
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: Option<u16>,
    /// Print the tables only.
    #[arg(long, short)]
    pub quiet: bool,
}

impl SizeArgs {
    pub(super) fn folder(&self, design: u8) -> PathBuf {
        match self.tries {
            1 => self.out.clone(),
            _ => self.out.join(format!("design-{design}")),
        }
    }

    /// Refuses options that are given though they say nothing of `template`.
    pub(super) fn refuse<const N: usize>(
        &self,
        template: &'static str,
        options: [(&'static str, bool); N],
    ) -> Result<(), SizeError> {
        match options.into_iter().find(|(_, given)| *given) {
            Some((option, _)) => Err(SizeError::Foreign { option, template }),
            None => Ok(()),
        }
    }

    pub(super) fn units(&self) -> Result<UnitSystem, SizeError> {
        let Some(name) = &self.units else {
            return Ok(units_of_load(&self.load).unwrap_or(UnitSystem::InKipKsi));
        };
        UnitSystem::from_name(name).ok_or_else(|| SizeError::Choice {
            option: "--units",
            value: name.clone(),
            choices: format!(
                "one of: {}",
                UnitSystem::ALL.map(UnitSystem::name).join(", ")
            ),
        })
    }

    pub(super) fn end(&self, units: UnitSystem) -> Result<Option<RollerEnd>, SizeError> {
        let Some(text) = self.end.as_deref().map(str::trim) else {
            return Ok(None);
        };
        let length = |size: &str| read_one(units, "--end", size, Dimension::LENGTH);
        match text.split_once(char::is_whitespace) {
            None if text == "square" => Ok(Some(RollerEnd::Square)),
            Some(("radius", size)) => Ok(Some(RollerEnd::Radius(length(size)?))),
            Some(("crown", size)) => Ok(Some(RollerEnd::Crown(length(size)?))),
            _ => Err(SizeError::Choice {
                option: "--end",
                value: text.to_string(),
                choices: "square, \"radius 1 mm\" or \"crown 20 µm\"".to_string(),
            }),
        }
    }

    pub(super) fn preset(&self) -> Result<Option<Preset>, SizeError> {
        let Some(name) = &self.mesh else {
            return Ok(None);
        };
        let preset = name.parse::<Preset>().map_err(|_| SizeError::Choice {
            option: "--mesh",
            value: name.clone(),
            choices: format!("one of: {}", Preset::ALL.map(Preset::name).join(", ")),
        })?;
        Ok(Some(preset))
    }
}

/// The number of a quantity.
pub(super) fn read_one(
    units: UnitSystem,
    option: &'static str,
    text: &str,
    dimension: Dimension,
) -> Result<f64, SizeError> {
    quantity(text, units, dimension).map_err(|error| SizeError::Quantity { option, error })
}

/// The number of a quantity, where it is given.
pub(super) fn read(
    units: UnitSystem,
    option: &'static str,
    text: &Option<String>,
    dimension: Dimension,
) -> Result<Option<f64>, SizeError> {
    let text = text.as_deref();
    text.map(|text| read_one(units, option, text, dimension))
        .transpose()
}
