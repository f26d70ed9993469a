//! `brinell size` of two crossed rollers.

use super::args::{RuleName, SizeArgs, read, read_one};
use super::verdict::verdict;
use crate::cli::console::{Console, LEGEND};
use crate::cli::output::{say, say_written};
use crate::cli::status::{CommandResult, ExitStatus, bad_input};
use crate::cli::threads::set_threads;
use crate::ground::units::Dimension;
use crate::product::size::{
    DesignVerdict, LengthRule, Proposal, Request, Setting, SizeError, render_verdict, table,
    verify, write,
};
use std::path::{Path, PathBuf};

/// Carries out the command.
pub fn run(args: &SizeArgs) -> CommandResult {
    let mut request = args.crossed().map_err(bad_input)?;
    set_threads(args.threads);
    let mut console = Console::new(args.quiet);
    for design in 1.. {
        let proposal = Proposal::new(&request).map_err(bad_input)?;
        say(&table::render(&proposal));
        let Some(choice) = proposal.choice() else {
            return Ok(ExitStatus::Failed);
        };
        let folder = args.folder(design);
        let written =
            write(&proposal, choice, &folder).map_err(|error| bad_input(SizeError::from(error)))?;
        say_written(&written);
        if !args.verify {
            return Ok(ExitStatus::Done);
        }
        if !args.quiet && design == 1 {
            say(&format!("\n{LEGEND}\n"));
        }
        let verification = verify(&proposal, choice, &folder, &mut console);
        let Some(verdict) = verdict(verification, &mut console)? else {
            return Ok(ExitStatus::Interrupted);
        };
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
    say_written(&all);
}

impl SizeArgs {
    /// The request for crossed rollers that these arguments put.
    ///
    /// # Errors
    /// [`SizeError`] names the option.
    fn crossed(&self) -> Result<Request, SizeError> {
        let units = self.units()?;
        self.refuse(
            "crossed",
            [
                ("--rollers", self.rollers.is_some()),
                ("--spacing", self.spacing.is_some()),
            ],
        )?;
        let maybe = |option, text: &Option<String>, dimension| read(units, option, text, dimension);
        let Some(capacity) = maybe("--capacity", &self.capacity, Dimension::LENGTH)? else {
            return Err(SizeError::Missing);
        };
        let own = Request::new(
            units,
            read_one(units, "--load", &self.load, Dimension::FORCE)?,
            read_one(units, "--yield", &self.yield_stress, Dimension::STRESS)?,
            capacity,
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
            LengthRule::Eccentric => own.margin.value,
            LengthRule::Printed | LengthRule::Exact => 1.0,
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
}

impl RuleName {
    fn rule(self) -> LengthRule {
        match self {
            Self::Printed => LengthRule::Printed,
            Self::Exact => LengthRule::Exact,
            Self::Eccentric => LengthRule::Eccentric,
        }
    }
}
