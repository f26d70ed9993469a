//! `brinell size`: from load, steel and displacement to a bearing, and a verdict on it.

use super::console::{Console, LEGEND};
use super::failure::failure;
use super::output::say;
use super::status::{CommandResult, ExitStatus};
use super::threads::set_threads;
use crate::case::bearing::{Preset, RollerEnd};
use crate::ground::units::{Dimension, UnitSystem};
use crate::product::converge::ConvergeError;
use crate::product::size::{
    DesignVerdict, Proposal, Request, Rule, Setting, SizeError, Verification, quantity,
    render_verdict, table, units_of_load, verify, write,
};
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};

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
when it is given again. Exit status: 0 all limits met, 1 one missed, 2 bad input, 3 not converged, \
130 interrupted.")]
pub struct SizeArgs {
    /// Vertical load P on the bearing, factored, such as "210 kip".
    #[arg(long, allow_hyphen_values = true)]
    pub load: String,
    /// Yield stress of rollers and plates, such as "175 ksi".
    #[arg(long = "yield", allow_hyphen_values = true)]
    pub yield_stress: String,
    /// Displacement capacity 2 D_r of the bearing, such as "3 in"; a roller travels half as far.
    #[arg(long, allow_hyphen_values = true)]
    pub capacity: String,
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
    /// Final length L', instead of what the rule asks for.
    #[arg(long, allow_hyphen_values = true)]
    pub length: Option<String>,
    /// Wall over diameter [default: 0.25].
    #[arg(long, allow_negative_numbers = true)]
    pub wall: Option<f64>,
    /// Thickness of the plates [default: 4/3 of the wall].
    #[arg(long, allow_hyphen_values = true)]
    pub plate: Option<String>,
    /// Slope of the V [default: 4 deg].
    #[arg(long, allow_hyphen_values = true)]
    pub slope: Option<String>,
    /// Coefficient of friction [default: 0.1].
    #[arg(long, allow_negative_numbers = true)]
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
    #[arg(long, allow_negative_numbers = true)]
    pub poisson: Option<f64>,
    /// Slope of the stress-strain line beyond yield [default: a hundredth of the modulus].
    #[arg(long, allow_hyphen_values = true)]
    pub tangent_modulus: Option<String>,
    /// Allowed contact pressure over the yield stress [default: 1.65, (2-49)].
    #[arg(long, allow_negative_numbers = true)]
    pub limit: Option<f64>,
    /// What determines the length of the rollers [default: eccentric].
    #[arg(long, value_enum)]
    pub rule: Option<RuleName>,
    /// Ask the rule for so many times the load [default: 1.4 with eccentric, else 1].
    #[arg(long, allow_negative_numbers = true)]
    pub margin: Option<f64>,
    /// Mesh preset of the cases: auto, report-like, h025 or h0125 [default: h0125].
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

/// Carries out the command.
pub fn run(args: &SizeArgs) -> CommandResult {
    let bad = |error: SizeError| (ExitStatus::BadInput, error.into());
    let mut request = args.request().map_err(bad)?;
    set_threads(args.threads);
    let mut console = Console::new(args.quiet);
    for design in 1.. {
        let proposal = Proposal::new(&request).map_err(bad)?;
        say(&table::render(&proposal));
        let Some(choice) = proposal.choice() else {
            return Ok(ExitStatus::Failed);
        };
        let folder = args.folder(design);
        let written = write(&proposal, choice, &folder).map_err(|error| bad(error.into()))?;
        say(&format!("written: {}", names(&written)));
        if !args.verify {
            return Ok(ExitStatus::Done);
        }
        if !args.quiet && design == 1 {
            say(&format!("\n{LEGEND}\n"));
        }
        let verdict = match verify(&proposal, choice, &folder, &mut console) {
            Ok(Verification::Done(verdict)) => verdict,
            Ok(Verification::Interrupted) => {
                console.finish();
                return Ok(ExitStatus::Interrupted);
            }
            Err(SizeError::Job(error)) => return Err(failure(&console, ConvergeError::Job(error))),
            Err(error) => return Err(bad(error)),
        };
        console.finish();
        told(&verdict, &folder);
        if verdict.met {
            return Ok(ExitStatus::Done);
        }
        match verdict.advice {
            Some(advice) if design < args.tries && advice.diameter.is_some() => {
                request = advice.request;
            }
            _ => break,
        }
    }
    Ok(ExitStatus::Failed)
}

fn told(verdict: &DesignVerdict, folder: &Path) {
    say(&format!("\n{}", render_verdict(verdict)));
    let names = ["verdict.json", "verdict.md"].map(|name| folder.join(name));
    let fields = verdict.positions.iter();
    let fields = fields.map(|p| folder.join(p.position).join(format!("{}.pvd", p.position)));
    let all: Vec<PathBuf> = names.into_iter().chain(fields).collect();
    say(&format!("written: {}", self::names(&all)));
}

fn names(paths: &[PathBuf]) -> String {
    let names: Vec<String> = paths.iter().map(|p| p.display().to_string()).collect();
    names.join(", ")
}

impl SizeArgs {
    fn folder(&self, design: u8) -> PathBuf {
        match self.tries {
            1 => self.out.clone(),
            _ => self.out.join(format!("design-{design}")),
        }
    }

    /// The request that these arguments put.
    ///
    /// # Errors
    /// [`SizeError`] names the option.
    pub fn request(&self) -> Result<Request, SizeError> {
        let units = self.units()?;
        let read = |option: &'static str, text: &str, dimension| {
            let number = quantity(text, units, dimension);
            number.map_err(|error| SizeError::Quantity { option, error })
        };
        let maybe = |option, text: &Option<String>, dimension| {
            let text = text.as_deref();
            text.map(|text| read(option, text, dimension)).transpose()
        };
        let own = Request::new(
            units,
            read("--load", &self.load, Dimension::FORCE)?,
            read("--yield", &self.yield_stress, Dimension::STRESS)?,
            read("--capacity", &self.capacity, Dimension::LENGTH)?,
        );
        let modulus = Setting::or(
            maybe("--modulus", &self.modulus, Dimension::STRESS)?,
            own.modulus.value,
        );
        let tangent = maybe(
            "--tangent-modulus",
            &self.tangent_modulus,
            Dimension::STRESS,
        )?;
        let slope = maybe("--slope", &self.slope, Dimension::ANGLE)?;
        let lever = maybe("--rolling-lever", &self.rolling_lever, Dimension::LENGTH)?;
        let rule = Setting::or(self.rule.map(RuleName::rule), own.rule.value);
        let margin = match rule.value {
            Rule::Eccentric => own.margin.value,
            Rule::Printed | Rule::Exact => 1.0,
        };
        let request = Request {
            modulus,
            poissons_ratio: Setting::or(self.poisson, own.poissons_ratio.value),
            tangent_modulus: Setting::or(tangent, modulus.value / 100.0),
            slope: Setting::or(slope, own.slope.value),
            friction: Setting::or(self.friction, own.friction.value),
            rolling_lever: Setting::or(lever, own.rolling_lever.value),
            diameter: maybe("--diameter", &self.diameter, Dimension::LENGTH)?,
            length: maybe("--length", &self.length, Dimension::LENGTH)?,
            wall: Setting::or(self.wall, own.wall.value),
            plate: maybe("--plate", &self.plate, Dimension::LENGTH)?,
            end: Setting::or(self.end(units)?, own.end.value),
            limit: Setting::or(self.limit, own.limit.value),
            margin: Setting::or(self.margin, margin),
            preset: Setting::or(self.preset()?, own.preset.value),
            rule,
            ..own
        };
        request.check()?;
        Ok(request)
    }

    fn units(&self) -> Result<UnitSystem, SizeError> {
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

    fn end(&self, units: UnitSystem) -> Result<Option<RollerEnd>, SizeError> {
        let Some(text) = self.end.as_deref().map(str::trim) else {
            return Ok(None);
        };
        let length = |size: &str| {
            let number = quantity(size, units, Dimension::LENGTH);
            number.map_err(|error| SizeError::Quantity {
                option: "--end",
                error,
            })
        };
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

    fn preset(&self) -> Result<Option<Preset>, SizeError> {
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

impl RuleName {
    fn rule(self) -> Rule {
        match self {
            Self::Printed => Rule::Printed,
            Self::Exact => Rule::Exact,
            Self::Eccentric => Rule::Eccentric,
        }
    }
}
