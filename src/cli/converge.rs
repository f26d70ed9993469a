//! `brinell converge`: one case on a series of meshes, error against unknowns and run time.

use super::console::Console;
use super::failure::failure;
use super::output::say;
use super::status::{CommandResult, ExitStatus, bad_input};
use crate::case::{self, Case, Kind};
use crate::model::scene::ElementKind;
use crate::product::converge::problem_h::{self, is_problem_h};
use crate::product::converge::{
    self, ConvergeError, MeshSeries, Study, json, page, peers, plot, table,
};
use crate::render::plot::write;
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};

/// A formulation of the hexahedron.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ElementName {
    Bbar,
    Full,
    Enhanced,
}

#[derive(Debug, Args)]
pub struct ConvergeArgs {
    /// The case file, or `problem-h` for the built-in problem H.
    pub case: PathBuf,
    /// Levels to solve [default: 5 of problem H, 3 of others, all mesh files].
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u8).range(2..=9))]
    pub levels: Option<u8>,
    /// Divides the element sizes of a bearing from level to level.
    #[arg(long, default_value_t = std::f64::consts::SQRT_2)]
    pub factor: f64,
    /// Of a general scene: the mesh files of the series, coarse to fine, in place of splitting its
    /// own. Of a bearing: the preset of level 0.
    #[arg(long, value_name = "FILE|PRESET")]
    pub mesh: Vec<PathBuf>,
    /// The elements to solve with [default: that of the case; both for problem H].
    #[arg(long, value_enum, value_delimiter = ',')]
    pub element: Vec<ElementName>,
    /// Keep every body elastic.
    #[arg(long)]
    pub elastic: bool,
    /// Folder for converge.json and converge.svg [default: results/ and the name of the case with
    /// -converge].
    #[arg(long, value_name = "FOLDER")]
    pub out: Option<PathBuf>,
    /// Threads to use [default: one a core].
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: Option<u16>,
    /// Write docs/convergence.md and its picture; problem H only.
    #[arg(long)]
    pub write: bool,
}

/// Names of what is written to the folder.
const JSON_FILE: &str = "converge.json";
const PLOT_FILE: &str = "converge.svg";

/// Carries out the command.
pub fn run(args: &ConvergeArgs) -> CommandResult {
    let job = Job::new(args).map_err(bad_input)?;
    super::threads::set_threads(args.threads);
    let mut console = Console::new(true);
    let mut study = Study::new(&job.case.title, job.series.words());
    say(&format!(
        "{}\n{}\n\n{}",
        study.case,
        study.series,
        table::head()
    ));
    let stopped = job.solve(&mut study, &mut console);
    console.finish();
    if !study.levels.is_empty() {
        say(&table::render(&study));
        say(&format!("written to {}", job.out.display()));
    }
    match stopped {
        Ok(ExitStatus::Done) if args.write => {
            let written = peers::peers().and_then(|peers| page::write_page(&study, &peers));
            written.map_err(bad_input)?;
            say(&format!("written to {} and {}", page::PAGE, page::PICTURE));
            Ok(ExitStatus::Done)
        }
        Ok(status) => Ok(status),
        Err(error) => Err(failure(&console, error)),
    }
}

/// What is to be solved.
struct Job {
    case: Case,
    series: MeshSeries,
    levels: usize,
    elements: Vec<ElementKind>,
    out: PathBuf,
}

impl Job {
    fn new(args: &ConvergeArgs) -> Result<Self, ConvergeError> {
        let built_in = args.case.as_os_str() == problem_h::NAME && !args.case.exists();
        let mut case = if built_in {
            problem_h::case()?
        } else {
            case::read(&args.case)?
        };
        if args.write && !is_problem_h(&case) {
            return Err(ConvergeError::Choice {
                what: "--write",
                why: "the page in docs/ is about problem H".into(),
                help: "run `brinell converge problem-h --write`",
            });
        }
        if args.elastic {
            case.set_elastic();
        }
        let series = match (&case.kind, &args.mesh[..]) {
            (Kind::Bearing(_), [preset]) => {
                case.set_preset(&preset.to_string_lossy())?;
                MeshSeries::of(&case, &[], args.factor)?
            }
            _ => MeshSeries::of(&case, &args.mesh, args.factor)?,
        };
        let most = match &series {
            MeshSeries::Files(files) => files.len(),
            _ => usize::MAX,
        };
        let mut elements: Vec<ElementKind> = Vec::new();
        for element in &args.element {
            let kind = match element {
                ElementName::Bbar => ElementKind::Bbar,
                ElementName::Full => ElementKind::Full,
                ElementName::Enhanced => ElementKind::Enhanced,
            };
            if !elements.contains(&kind) {
                elements.push(kind);
            }
        }
        if elements.is_empty() {
            elements = if is_problem_h(&case) {
                vec![ElementKind::Bbar, ElementKind::Enhanced]
            } else {
                vec![case.controls.element]
            };
        }
        let stem = args.case.file_stem().unwrap_or(args.case.as_os_str());
        let folder = format!("{}-converge", stem.to_string_lossy());
        Ok(Self {
            levels: args.levels.map_or(series.levels(), usize::from).min(most),
            out: args
                .out
                .clone()
                .unwrap_or_else(|| Path::new("results").join(folder)),
            case,
            series,
            elements,
        })
    }

    /// Solves level by level, each with every element, and writes after each what there is.
    fn solve(&self, study: &mut Study, console: &mut Console) -> Result<ExitStatus, ConvergeError> {
        for level in 0..self.levels {
            for element in &self.elements {
                let solved = converge::run(
                    &self.case,
                    &self.series,
                    level,
                    *element,
                    &self.out,
                    console,
                )?;
                let Some((level, quantities)) = solved else {
                    return Ok(ExitStatus::Interrupted);
                };
                say(&table::line(&level));
                study.push(level, quantities);
                json::write(study, &self.out.join(JSON_FILE))?;
                let figure = plot::figure(study);
                if !figure.panels.is_empty() {
                    write(&figure, &self.out.join(PLOT_FILE))?;
                }
            }
        }
        Ok(ExitStatus::Done)
    }
}
