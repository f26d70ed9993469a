//! `brinell run`: one case from its file to tables, `summary.json` and VTK files.

use super::case_file::{change, read_case, results_folder};
use super::combinations;
use super::console::{Console, LEGEND};
use super::failure::failure;
use super::output::say;
use super::status::{CommandResult, ExitStatus, bad_input};
use super::threads::set_threads;
use crate::case::Case;
use crate::case::combinations::{Combination, combinations as combinations_at};
use crate::product::converge::ConvergeError;
use crate::product::job::{self, JobError, Options, Outcome};
use crate::product::target::{self, Level, Target, TargetLimits, TargetVerdict};
use crate::render::{digest, terminal};
use crate::solver::solve::{Counters, Phase};
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "Examples:
  brinell run case.toml                       a digest here, files in results/case
  brinell run case.toml --all-tables          and every table
  brinell run case.toml --mesh h0125          another mesh
  brinell run case.toml --target mises=3%     finer meshes until the stress is that good
  brinell run case.toml --resume              on from where it was stopped

Exit status: 0 done and converged, 1 solved but a limit missed, 2 bad input, 3 not converged,
130 interrupted.")]
pub struct RunArgs {
    /// The case file.
    pub case: PathBuf,
    /// Mesh preset of a bearing [default: that of the case].
    #[arg(long, value_name = "PRESET", value_parser = super::preset::parser())]
    pub mesh: Option<String>,
    /// Folder for summary.json, report.html and the VTK files [default: results/ and the name of the
    /// case].
    #[arg(long, value_name = "FOLDER")]
    pub out: Option<PathBuf>,
    /// Threads to use [default: one a core].
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: Option<u16>,
    /// Model the whole bearing though it is symmetric.
    #[arg(long)]
    pub full: bool,
    /// Keep every body elastic.
    #[arg(long)]
    pub elastic: bool,
    /// Leave out the second solution without plasticity, which gives the elastic peaks.
    #[arg(long)]
    pub no_elastic_peaks: bool,
    /// Print every table after the digest; report.html has them too.
    #[arg(long)]
    pub all_tables: bool,
    /// Print every table, and say for each thing left out what that saved.
    #[arg(long)]
    pub explain: bool,
    /// Refine the mesh until the certified figures are as good as asked for, such as 3%, or one of them, such as
    /// mises=2%; each mesh writes into a folder of its own, level-0 and on. Certified: pressure, hertz-p0, line-load,
    /// elastic-mises, bore and descent. Others: mises, plastic-strain, half-width, area.
    #[arg(long, value_name = "[FIGURE=]PERCENT")]
    pub target: Option<String>,
    /// Go on after the last increment of an earlier run of this case into the same folder.
    #[arg(long)]
    pub resume: bool,
    /// Leave out report.html, the page of the run for a browser.
    #[arg(long)]
    pub no_report: bool,
    /// Print no iterations, only what came of them.
    #[arg(long, short)]
    pub quiet: bool,
}

/// Carries out the command.
pub fn run(args: &RunArgs) -> CommandResult {
    let combinations = combinations_of(args).map_err(bad_input)?;
    set_threads(args.threads);
    let options = Options {
        out: Some(results_folder(&args.out, &args.case)),
        elastic_peaks: !args.no_elastic_peaks,
        resume: args.resume,
        report: !args.no_report,
    };
    if let Some(all) = combinations {
        let mut console = Console::new(args.quiet);
        let title = all.first().map_or("", |one| {
            let title = one.case.title.as_str();
            let own = title.strip_suffix(&one.name);
            own.and_then(|own| own.strip_suffix(": ")).unwrap_or(title)
        });
        return combinations::run(title, &all, &options, &mut console);
    }
    let case = read_case(&args.case, args.mesh.as_deref(), args.full, args.elastic);
    let case = case.map_err(bad_input)?;
    let target = args.target.as_deref().map(str::parse::<Target>).transpose();
    let target = target.map_err(bad_input)?;
    let mut console = Console::new(args.quiet);
    if !args.quiet {
        say(&format!("{LEGEND}\n"));
    }
    let result = match &target {
        None => (job::run(&case, &options, &mut console))
            .map(|outcome| (outcome, None, options.out.clone()))
            .map_err(ConvergeError::from),
        Some(target) => refined(&case, target, &options, &mut console),
    };
    console.finish();
    match result {
        Ok((outcome, missed_target, out)) => {
            let mut missed = outcome.missed_limits(&case);
            say(&digest::digest(&outcome.summary, &missed));
            if args.all_tables || args.explain {
                say(&terminal::tables(&outcome.summary, args.explain));
                say(&timer_table(&outcome.solution.counters));
            }
            if let Some(out) = &out {
                let (out, page) = (out.display(), options.report);
                let page = if page { ", or report.html there" } else { "" };
                say(&format!(
                    "written to {out}; every table: --all-tables{page}"
                ));
            }
            missed.extend(missed_target);
            for limit in &missed {
                say(&format!("FAILED: {limit}"));
            }
            Ok(match outcome.interrupted {
                true => ExitStatus::Interrupted,
                false => ExitStatus::of(missed.is_empty()),
            })
        }
        Err(error) => Err(failure(&console, error)),
    }
}

/// The finest mesh that the target took, why the target is missed where it is, and the folder of that mesh.
fn refined(
    case: &Case,
    target: &Target,
    options: &Options,
    console: &mut Console,
) -> Result<(Outcome, Option<String>, Option<PathBuf>), ConvergeError> {
    let told = |level: &Level| say(&target::table(std::slice::from_ref(level)));
    let (levels, verdict, outcome) = target::refine(
        case,
        target,
        &TargetLimits::default(),
        options,
        console,
        told,
    )?;
    say(&target::table(&levels));
    let last = target::last_level(&levels, &verdict);
    let folder = (options.out.as_deref()).map(|out| target::folder(out, last));
    let missed = match verdict {
        TargetVerdict::NotMet(why) => Some(format!("{}: {why}", target.goal.name())),
        TargetVerdict::Met | TargetVerdict::Interrupted => None,
    };
    Ok((outcome, missed, folder))
}

/// Seconds by phase of the solution.
fn timer_table(counters: &Counters) -> String {
    let phases = Phase::ALL.iter().map(|phase| {
        format!(
            "  {:14} {:9.2} s",
            phase.name(),
            counters.timers.seconds(*phase)
        )
    });
    let factor = format!(
        "  factor         {:9.1} million entries",
        1e-6 * counters.factor_entries as f64
    );
    let lines: Vec<String> = phases.chain([factor]).collect();
    format!("Solution\n{}", lines.join("\n"))
}

/// The combinations of the case, with what the arguments change; `None` where it is one case.
fn combinations_of(args: &RunArgs) -> Result<Option<Vec<Combination>>, JobError> {
    let Some(mut all) = combinations_at(&args.case)? else {
        return Ok(None);
    };
    let refused = [
        (args.target.is_some(), "--target"),
        (args.resume, "--resume"),
        (args.all_tables, "--all-tables"),
        (args.explain, "--explain"),
    ];
    if let Some((_, option)) = refused.into_iter().find(|(asked, _)| *asked) {
        return Err(JobError::Combinations { option });
    }
    for combination in &mut all {
        let case = &mut combination.case;
        change(case, args.mesh.as_deref(), args.full, args.elastic)?;
    }
    Ok(Some(all))
}
