//! The cases of the study, and what they are solved on.

use crate::case::{self, Case};
use crate::product::converge::ConvergeError;
use crate::product::job::{self, Options};
use crate::product::target::{self, Goal, Level, Target, TargetLimits, TargetVerdict};
use crate::render::Summary;
use crate::solver::solve::Observer;
use std::path::{Path, PathBuf};

/// Name of the study on the command line and in case files.
pub const NAME: &str = "section-2.6.2";

/// A case of the study.
#[derive(Debug, Clone, Copy)]
pub struct Member {
    pub name: &'static str,
    text: &'static str,
}

macro_rules! member {
    ($name:literal) => {
        Member {
            name: $name,
            text: include_str!(concat!("../../../cases/section-2.6.2/", $name, ".toml")),
        }
    };
}

/// Both designs at the centre and at both readings of their displacement.
pub const MEMBERS: [Member; 6] = [
    member!("initial-centre"),
    member!("initial-offset-1.25"),
    member!("initial-offset-2.5"),
    member!("revised-centre"),
    member!("revised-offset-1.25"),
    member!("revised-offset-2.5"),
];

/// Preset of the coarse mesh.
const REPORT_LIKE: &str = "report-like";
/// Folder of the resolved meshes.
const RESOLVED: &str = "resolved";

/// What the finest mesh of each case should reach: all certified figures within three per cent.
const TARGET: Target = Target {
    goal: Goal::Certified,
    within: 0.03,
};

/// Which meshes a study is run on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Meshes {
    pub report_like: bool,
    pub resolved: bool,
}

/// A case, solved.
#[derive(Debug, Clone)]
pub struct SolvedMember {
    pub name: &'static str,
    pub report_like: Option<Summary>,
    /// Resolved meshes, coarse to fine.
    pub resolved: Vec<Level>,
    /// Why the finest of them misses the target, where it does.
    pub missed: Option<String>,
}

impl Member {
    /// The case, loaded and unloaded, on its own preset.
    ///
    /// # Errors
    /// None for the cases that are built in.
    pub fn case(&self) -> Result<Case, ConvergeError> {
        let path = format!("cases/section-2.6.2/{}.toml", self.name);
        let mut case = case::parse(&path, self.text)?;
        case.set_unloading()?;
        Ok(case)
    }

    /// Solves the case on `meshes`, results in folders below `out`; `None` where the observer
    /// stopped it.
    ///
    /// # Errors
    /// Where a mesh cannot be made or the solver does not converge.
    pub fn solve(
        &self,
        meshes: Meshes,
        out: &Path,
        observer: &mut dyn Observer,
    ) -> Result<Option<SolvedMember>, ConvergeError> {
        let mut solved = SolvedMember {
            name: self.name,
            report_like: None,
            resolved: Vec::new(),
            missed: None,
        };
        let options = |mesh: &str| Options {
            out: Some(out.join(self.name).join(mesh)),
            elastic_peaks: true,
            resume: false,
            report: true,
        };
        if meshes.report_like {
            let mut case = self.case()?;
            case.set_preset(REPORT_LIKE)?;
            let outcome = job::run(&case, &options(REPORT_LIKE), observer)?;
            if outcome.interrupted {
                return Ok(None);
            }
            solved.report_like = Some(outcome.summary);
        }
        if meshes.resolved {
            let (case, options) = (self.case()?, options(RESOLVED));
            let limits = TargetLimits::default();
            let (levels, verdict, _) =
                target::refine(&case, &TARGET, &limits, &options, observer, |_| {})?;
            solved.resolved = levels;
            solved.missed = match verdict {
                TargetVerdict::Interrupted => return Ok(None),
                TargetVerdict::NotMet(why) => Some(why),
                TargetVerdict::Met => None,
            };
        }
        Ok(Some(solved))
    }
}

impl SolvedMember {
    /// Results of the finest resolved mesh, below `out`.
    pub fn folder(&self, out: &Path) -> PathBuf {
        let level = self.resolved.len().saturating_sub(1);
        let case = out.join(self.name).join(RESOLVED);
        target::folder(&case, level)
    }

    /// The finest resolved mesh.
    pub fn finest(&self) -> Option<&Summary> {
        self.resolved.last().map(|level| &level.summary)
    }
}
