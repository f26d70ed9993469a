//! `brinell verify`: the ladder of problems with known answers.

use super::console::Console;
use super::output::say;
use super::status::{CommandResult, ExitStatus, bad_input};
use super::threads::set_threads;
use crate::ground::file::{write_atomically, write_text};
use crate::proof::verify::coverage::{self, CoverageAnswer, Keep, Set};
use crate::proof::verify::stability::StabilitySection;
use crate::proof::verify::{
    Extent, LadderClaim, VerifyError, extreme, families, matrix, random, stability,
};
use clap::Args;
use std::path::{Path, PathBuf};

#[derive(Debug, Args)]
pub struct VerifyArgs {
    /// Climb the whole ladder, the slow rungs too.
    #[arg(long)]
    pub all: bool,
    /// One family only; `extreme` runs the cases of cases/extreme at the edge of what can be solved,
    /// `random` cases that nobody has chosen, `coverage` asks of many bearings whether their error bars hold.
    #[arg(long, value_name = "NAME")]
    pub suite: Option<String>,
    /// Write docs/verification.md; docs/stability.md for the extreme and the random cases, docs/coverage.md for
    /// the bars.
    #[arg(long)]
    pub write: bool,
    /// What cases are drawn by: thirty bearings of crossed rollers and ten of parallel ones beside the ten that have names (coverage), or all (random).
    #[arg(long, value_name = "SEED", default_value_t = 1)]
    pub seed: u64,
    /// With --suite random: how many bearings, and as many stacks of blocks [default: 300 and 200].
    #[arg(long, value_name = "COUNT")]
    pub count: Option<usize>,
    /// Of random cases or of bearings, only those whose names begin so; may be given again.
    #[arg(long, value_name = "NAME")]
    pub only: Vec<String>,
    /// Folder for the cases that are drawn. With --suite coverage also for coverage.jsonl with a claim a line,
    /// and for what --resume reads.
    #[arg(long, value_name = "FOLDER")]
    pub out: Option<PathBuf>,
    /// Threads to use, for random cases and coverage [default: one a core].
    #[arg(long, value_name = "COUNT")]
    pub threads: Option<u16>,
    #[command(flatten)]
    pub coverage: CoverageArgs,
}

#[derive(Debug, Args)]
#[command(next_help_heading = "With --suite coverage")]
pub struct CoverageArgs {
    /// Make the stored true values that are missing, on two fine meshes each: hours. What is done is
    /// kept; delete a file of cases/coverage to have all of it anew.
    #[arg(long)]
    pub remake: bool,
    /// Only on this mesh [default: on h025, h0125 and auto]; may be given again.
    #[arg(long, value_name = "PRESET", value_parser = super::preset::parser())]
    pub mesh: Vec<String>,
    /// With elastic steel only.
    #[arg(long)]
    pub elastic: bool,
    /// Read solutions that an earlier run left in --out, and solve only what is not there.
    #[arg(long, requires = "out")]
    pub resume: bool,
}

/// The page that `--write` writes, from the folder where the command is run.
const VERIFICATION_PAGE: &str = "docs/verification.md";

/// The suite of extreme cases, and the page of these and of random ones.
const EXTREME_SUITE: &str = "cases/extreme/suite.toml";
const STABILITY_PAGE: &str = "docs/stability.md";

/// The page of the coverage suite; that of another seed than the first has the seed in its name.
fn coverage_page(seed: u64) -> PathBuf {
    match seed {
        1 => "docs/coverage.md".into(),
        _ => format!("docs/coverage-seed-{seed}.md").into(),
    }
}

/// A claim a line, in the folder of `--out`.
const COVERAGE_LINES: &str = "coverage.jsonl";

/// Carries out the command.
pub fn run(args: &VerifyArgs) -> CommandResult {
    if args.suite.as_deref() == Some("extreme") {
        return run_extreme(args.write);
    }
    if args.suite.as_deref() == Some("random") {
        return run_random(args);
    }
    if args.suite.as_deref() == Some("coverage") {
        return run_coverage(args);
    }
    let extent = if args.all { Extent::All } else { Extent::Fast };
    let families = families(args.suite.as_deref()).map_err(bad_input)?;
    say(&matrix::head());
    let mut claims: Vec<LadderClaim> = Vec::new();
    let mut unsolved: Vec<(&str, VerifyError)> = Vec::new();
    for family in families {
        match family.measure(extent) {
            Ok(measured) => {
                for claim in measured {
                    say(&matrix::line(&claim));
                    claims.push(claim);
                }
            }
            Err(error) => {
                say(&format!("FAILS {:12} {error}", family.name));
                unsolved.push((family.name, error));
            }
        }
    }
    say(&format!(
        "\n{}; {} families not solved",
        matrix::tally(&claims),
        unsolved.len()
    ));
    if args.write {
        write(Path::new(VERIFICATION_PAGE), &claims, &unsolved)
            .map_err(|error| cannot(Path::new(VERIFICATION_PAGE), error))?;
        say(&format!("written to {VERIFICATION_PAGE}"));
    }
    let sound = claims.iter().all(LadderClaim::holds) && unsolved.is_empty();
    Ok(ExitStatus::of(sound))
}

fn run_extreme(write: bool) -> CommandResult {
    let suite = Path::new(EXTREME_SUITE);
    let cases = extreme::read(suite).map_err(bad_input)?;
    let folder = suite.parent().unwrap_or(suite);
    say(&extreme::head());
    let outcomes = cases.iter().map(|case| {
        let outcome = case.run(folder);
        say(&extreme::line(&outcome));
        outcome
    });
    let outcomes: Vec<_> = outcomes.collect();
    let failed = outcomes.iter().filter(|o| !o.holds()).count();
    say(&format!(
        "\n{} cases, {failed} not as expected",
        outcomes.len()
    ));
    if write {
        write_section(StabilitySection::Extreme, &extreme::section(&outcomes))?;
    }
    Ok(ExitStatus::of(failed == 0))
}

/// Draws and solves random cases.
fn run_random(args: &VerifyArgs) -> CommandResult {
    set_threads(args.threads);
    if let Some(out) = &args.out {
        std::fs::create_dir_all(out).map_err(|error| cannot(out, error))?;
    }
    say(&random::head());
    let kinds = random::COUNT.map(|(kind, count)| (kind, args.count.unwrap_or(count)));
    let mut sets = Vec::new();
    for (kind, count) in kinds {
        let wanted = |number: &usize| {
            let name = kind.name(args.seed, *number);
            args.only.is_empty() || args.only.iter().any(|only| name.starts_with(only))
        };
        let numbers: Vec<usize> = (0..count).filter(wanted).collect();
        for number in &numbers {
            if let (Some(out), Some(text)) =
                (&args.out, random::case_text(kind, args.seed, *number))
            {
                let path = out.join(format!("{}.toml", kind.name(args.seed, *number)));
                write_text(&path, &text).map_err(|error| cannot(&path, error))?;
            }
        }
        let outcomes = numbers.into_iter().map(|number| {
            let outcome = random::run(kind, args.seed, number);
            say(&random::line(&outcome));
            outcome
        });
        sets.push((kind.title(), outcomes.collect::<Vec<_>>()));
    }
    for (what, outcomes) in &sets {
        say(&format!("\n{what}. {}", random::tally(outcomes)));
    }
    if args.write {
        let section = random::section(&drawn_by(args), &sets);
        write_section(StabilitySection::Random, &section)?;
    }
    let mut all = sets.iter().flat_map(|(_, outcomes)| outcomes);
    Ok(ExitStatus::of(all.all(random::RandomOutcome::holds)))
}

/// The arguments that say which random cases are drawn.
fn drawn_by(args: &VerifyArgs) -> String {
    let mut words = format!("--seed {}", args.seed);
    if let Some(count) = args.count {
        words.push_str(&format!(" --count {count}"));
    }
    for only in &args.only {
        words.push_str(&format!(" --only {only}"));
    }
    words
}

fn cannot(path: &Path, error: impl std::fmt::Display) -> (ExitStatus, miette::Report) {
    bad_input(miette::miette!(
        "{} cannot be written: {error}",
        path.display()
    ))
}

fn write_section(
    section: StabilitySection,
    text: &str,
) -> Result<(), (ExitStatus, miette::Report)> {
    let page = Path::new(STABILITY_PAGE);
    stability::write(page, section, text).map_err(|error| cannot(page, error))?;
    say(&format!("written to {STABILITY_PAGE}"));
    Ok(())
}

fn run_coverage(all: &VerifyArgs) -> CommandResult {
    let (args, write) = (&all.coverage, all.write);
    set_threads(all.threads);
    let mut console = Console::new(true);
    let mut suite = coverage::CoverageRun {
        sets: vec![Set::Named, Set::Drawn(all.seed), Set::DrawnLines(all.seed)],
        only: all.only.clone(),
        presets: if args.mesh.is_empty() {
            coverage::presets()
        } else {
            args.mesh.clone()
        },
        plastic: !args.elastic,
        keep: Keep {
            folder: all.out.clone(),
            resume: args.resume,
        },
        observer: &mut console,
        say: &mut |text| say(text),
    };
    if let Some(out) = &all.out {
        std::fs::create_dir_all(out).map_err(|error| cannot(out, error))?;
        for bearing in suite.sets.iter().flat_map(|set| set.bearings()) {
            let path = out.join(format!("{}.toml", bearing.name));
            std::fs::write(&path, &bearing.text).map_err(|error| cannot(&path, error))?;
        }
    }
    let answer = if args.remake {
        suite.remake()
    } else {
        suite.measure()
    };
    let sets = suite.sets.clone();
    console.finish();
    let answer = answer.map_err(bad_input)?;
    if args.remake {
        return Ok(status(&answer, true));
    }
    if let Some(out) = &all.out {
        let written = write_atomically(&out.join(COVERAGE_LINES), |file| {
            for record in &answer.records {
                serde_json::to_writer(&mut *file, record)?;
                writeln!(file)?;
            }
            Ok(())
        });
        written.map_err(|error| bad_input(miette::miette!("{error}")))?;
    }
    let criteria = coverage::criteria(&answer.records);
    say(coverage::demands(&criteria).trim_end());
    if write && !answer.interrupted {
        let page = coverage::page(&answer.records, &sets, &answer.unsolved, &answer.unknown);
        let path = coverage_page(all.seed);
        std::fs::write(&path, page).map_err(|error| cannot(&path, error))?;
        say(&format!("written to {}", path.display()));
    }
    Ok(status(
        &answer,
        criteria.iter().all(|c| c.holds() != Some(false)),
    ))
}

fn status(answer: &CoverageAnswer, sound: bool) -> ExitStatus {
    match answer.interrupted {
        true => ExitStatus::Interrupted,
        false => ExitStatus::of(sound && answer.unsolved.is_empty()),
    }
}

fn write(
    path: &Path,
    claims: &[LadderClaim],
    unsolved: &[(&str, VerifyError)],
) -> std::io::Result<()> {
    let mut text = matrix::page(claims);
    for (name, error) in unsolved {
        text.push_str(&format!("\nFamily `{name}` was not solved: {error}.\n"));
    }
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder)?;
    }
    std::fs::write(path, text)
}
