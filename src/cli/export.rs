//! `brinell export`: a case as a deck for CalculiX or Abaqus.

use super::case_file::read_case;
use super::output::say;
use super::status::{CommandResult, ExitStatus, bad_input};
use crate::product::job::{self, JobError};
use crate::render::inp::{ContactType, Settings};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// A file format of other programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// The keywords of CalculiX and Abaqus.
    Inp,
}

/// Contact of the deck.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum DeckContact {
    /// Penalty at points of the faces; copes with friction and plasticity.
    SurfaceToSurface,
    /// Penalty at the nodes.
    NodeToSurface,
    /// Multipliers, of CalculiX; wrong where a symmetry plane cuts the contact.
    Mortar,
}

/// Linear solvers of CalculiX.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Solver {
    Spooles,
    Pardiso,
    Pastix,
    IterativeScaling,
    IterativeCholesky,
}

/// Element types of the deck.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum DeckElement {
    #[value(name = "C3D8")]
    C3d8,
    #[value(name = "C3D8I")]
    C3d8i,
    #[value(name = "C3D8R")]
    C3d8r,
}

#[derive(Debug, Args)]
pub struct ExportArgs {
    /// The case file.
    pub case: PathBuf,
    /// File format.
    #[arg(long, value_enum)]
    pub format: Format,
    /// Mesh preset of a bearing [default: that of the case].
    #[arg(long, value_name = "PRESET", value_parser = super::preset::parser())]
    pub mesh: Option<String>,
    /// Folder for the deck, which is called as the case file.
    #[arg(long, value_name = "FOLDER")]
    pub out: PathBuf,
    /// Model the whole bearing though it is symmetric.
    #[arg(long)]
    pub full: bool,
    /// Keep every body elastic.
    #[arg(long)]
    pub elastic: bool,
    /// Pressure per overclosure in the stress and length of the case [default: 20 Young's
    /// moduli over the shortest edge of the faces that press].
    #[arg(long, value_name = "K")]
    pub contact_stiffness: Option<f64>,
    /// Kind of contact.
    #[arg(long, value_enum, default_value = "surface-to-surface")]
    pub contact: DeckContact,
    /// How far the closing step moves what the load steps drive by force, in the length of the
    /// case. Nine tenths of the descent save increments in a symmetric bearing; in a displaced one
    /// CalculiX then loses its way [default: the shortening of a solid block, safely too little].
    /// Where pressure alone drives, the bodies start with this overlap instead [default: just
    /// touching].
    #[arg(long, value_name = "LENGTH")]
    pub closing: Option<f64>,
    /// First increment of the load steps, as a share of the step [default: that of the case].
    #[arg(long, value_name = "SHARE", value_parser = super::share::share)]
    pub increment: Option<f64>,
    /// Linear solver [default: left to the program].
    #[arg(long, value_enum)]
    pub solver: Option<Solver>,
    /// Element type [default: C3D8, or C3D8I for the enhanced element].
    #[arg(long, value_enum)]
    pub element: Option<DeckElement>,
}

/// Carries out the command.
pub fn run(args: &ExportArgs) -> CommandResult {
    let Format::Inp = args.format;
    let exported = export(args).map_err(bad_input)?;
    say(&exported);
    Ok(ExitStatus::Done)
}

fn export(args: &ExportArgs) -> Result<String, JobError> {
    let case = read_case(&args.case, args.mesh.as_deref(), args.full, args.elastic)?;
    let exported = job::export(&case, settings(args), &args.out, &mut |line| say(line))?;
    Ok(format!(
        "{}: {} nodes, {} elements",
        exported.path.display(),
        exported.nodes,
        exported.elements
    ))
}

fn settings(args: &ExportArgs) -> Settings {
    let solver = args.solver.map(|solver| match solver {
        Solver::Spooles => "SPOOLES",
        Solver::Pardiso => "PARDISO",
        Solver::Pastix => "PASTIX",
        Solver::IterativeScaling => "ITERATIVE SCALING",
        Solver::IterativeCholesky => "ITERATIVE CHOLESKY",
    });
    let element = args.element.map(|element| match element {
        DeckElement::C3d8 => "C3D8",
        DeckElement::C3d8i => "C3D8I",
        DeckElement::C3d8r => "C3D8R",
    });
    Settings {
        element: element.map(str::to_string),
        contact: match args.contact {
            DeckContact::SurfaceToSurface => ContactType::SurfaceToSurface,
            DeckContact::NodeToSurface => ContactType::NodeToSurface,
            DeckContact::Mortar => ContactType::Mortar,
        },
        contact_stiffness: args.contact_stiffness,
        closing: args.closing,
        increment: args.increment,
        solver: solver.map(str::to_string),
        ..Settings::default()
    }
}
