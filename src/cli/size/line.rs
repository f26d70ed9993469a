//! `brinell size --template line`: parallel rollers.

use super::args::{SizeArgs, read, read_one};
use super::verdict::verdict;
use crate::cli::console::{Console, LEGEND};
use crate::cli::output::{say, say_written};
use crate::cli::status::{CommandResult, ExitStatus, bad_input};
use crate::cli::threads::set_threads;
use crate::ground::units::Dimension;
use crate::product::size::{
    LineProposal, LineRequest, Setting, SizeError, render_line, verify_line, write_line,
};

/// Carries out the command.
pub fn run(args: &SizeArgs) -> CommandResult {
    let mut request = request(args).map_err(bad_input)?;
    set_threads(args.threads);
    let mut console = Console::new(args.quiet);
    for design in 1..=args.tries {
        let proposal = LineProposal::new(&request).map_err(bad_input)?;
        say(&render_line(&proposal));
        let Some(choice) = proposal.choice() else {
            return Ok(ExitStatus::Failed);
        };
        let folder = args.folder(design);
        let written = write_line(&proposal, choice, &folder)
            .map_err(|error| bad_input(SizeError::from(error)))?;
        say_written(&written);
        if !args.verify {
            return Ok(ExitStatus::Done);
        }
        if !args.quiet && design == 1 {
            say(&format!("\n{LEGEND}\n"));
        }
        let verification = verify_line(&proposal, choice, &folder, &mut console);
        let Some(verdict) = verdict(verification, &mut console)? else {
            return Ok(ExitStatus::Interrupted);
        };
        say(&format!("\n{}", verdict.render()));
        let files = ["verdict.json", "verdict.md", "line/report.html"];
        say_written(&files.map(|name| folder.join(name)));
        match verdict.advised(&request) {
            _ if verdict.met => return Ok(ExitStatus::Done),
            Some(advised) => request = advised,
            None => break,
        }
    }
    Ok(ExitStatus::Failed)
}

/// The request that these arguments put.
fn request(args: &SizeArgs) -> Result<LineRequest, SizeError> {
    args.refuse(
        "line",
        [
            ("--capacity", args.capacity.is_some()),
            ("--slope", args.slope.is_some()),
            ("--rolling-lever", args.rolling_lever.is_some()),
            ("--rule", args.rule.is_some()),
        ],
    )?;
    let units = args.units()?;
    let length = |option, text: &Option<String>| read(units, option, text, Dimension::LENGTH);
    let stress = |option, text: &Option<String>| read(units, option, text, Dimension::STRESS);
    let own = LineRequest::new(
        units,
        read_one(units, "--load", &args.load, Dimension::FORCE)?,
        read_one(units, "--yield", &args.yield_stress, Dimension::STRESS)?,
    );
    let modulus = Setting::or(stress("--modulus", &args.modulus)?, own.modulus.value);
    let tangent = stress("--tangent-modulus", &args.tangent_modulus)?;
    let request = LineRequest {
        modulus,
        poissons_ratio: Setting::or(args.poisson, own.poissons_ratio.value),
        tangent_modulus: Setting::or(tangent, modulus.value / 100.0),
        friction: Setting::or(args.friction, own.friction.value),
        rollers: args.rollers,
        diameter: length("--diameter", &args.diameter)?,
        length: length("--length", &args.length)?,
        spacing: length("--spacing", &args.spacing)?,
        wall: args.wall,
        plate: length("--plate", &args.plate)?,
        end: Setting::or(args.end(units)?, own.end.value),
        limit: Setting::or(args.limit, own.limit.value),
        margin: Setting::or(args.margin, own.margin.value),
        preset: Setting::or(args.preset()?, own.preset.value),
        ..own
    };
    request.check()?;
    Ok(request)
}
