//! Why a scene could not be solved.

use super::restart::Stranger;
use crate::ground::geometry::Vec3;
use crate::model::state::turn::TOO_FAR;
use crate::solver::fem::dofs::Conflict;
use crate::solver::linear::cholesky::FactorError;
use std::fmt;

/// Why a scene could not be solved. What was accepted before went to the observer.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum SolveError {
    /// Supports contradict each other.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Conflict(#[from] Conflict),
    /// Every displacement is prescribed.
    #[error("nothing is free to move: every displacement component is prescribed")]
    #[diagnostic(
        code(brinell::solve::nothing_free),
        help("free a surface, or apply a load")
    )]
    NothingFree,
    /// Loads are beyond what numbers can hold.
    #[error("the loads are too large: their squares leave the range of floating-point numbers")]
    #[diagnostic(
        code(brinell::solve::out_of_range),
        help(
            "look for a slip in a load or its unit, or choose units in which the numbers are nearer to 1"
        )
    )]
    OutOfRange,
    /// A matrix could not be factorised.
    #[error("{0}")]
    #[diagnostic(code(brinell::solve::factor), help("a coarser mesh needs less memory"))]
    Factor(#[from] FactorError),
    /// There is not enough memory.
    #[error(
        "{unknowns} unknowns take about {} GB of memory, and {:.2} GB are left",
        gigabytes(*needed),
        1e-9 * available
    )]
    #[diagnostic(
        code(brinell::solve::memory),
        help("a coarser mesh, or `solver = \"divided\"` under [controls], which takes the least")
    )]
    Memory {
        /// Number of unknowns.
        unknowns: usize,
        /// Bytes.
        needed: f64,
        /// Bytes that are left.
        available: f64,
    },
    /// A body is held by nothing.
    #[error(
        "body `{body}` is free to move along {axis}: no support and no contact holds it{}",
        in_pieces(*pieces)
    )]
    #[diagnostic(
        code(brinell::solve::free_body),
        help("support it, bring it into contact, or give the contact friction")
    )]
    FreeBody {
        /// Name of the body.
        body: String,
        /// The axis: x, y or z.
        axis: char,
        /// Parts of the body that share no nodes.
        pieces: usize,
    },
    /// Rigid bodies cannot be in balance under the loads.
    #[error("{0}")]
    #[diagnostic(code(brinell::solve::no_balance), help("{}", .0.remedy()))]
    NoBalance(Box<NoBalance>),
    /// No balance was found.
    #[error(
        "step `{step}` did not converge beyond {percent:.3} % of its load: after {iterations} \
         iterations the residual was {residual:.1e} of the load, most of it in {place}, and the \
         largest contact violation {penetration:.1e} of the displacement: {contact}"
    )]
    #[diagnostic(
        code(brinell::solve::not_converged),
        help(
            "the states up to there are kept; try a smaller first increment, or a \
             finer mesh at the contact; a load near the plastic limit can end like this, too"
        )
    )]
    NotConverged {
        /// Name of the step.
        step: String,
        /// Share of the step that was reached, in per cent.
        percent: f64,
        /// Newton iterations that were spent.
        iterations: usize,
        /// Residual force over applied force.
        residual: f64,
        /// Largest contact violation over the displacement.
        penetration: f64,
        /// Where the residual and the violation are largest, in words.
        place: String,
        /// What is known of the contact there, in words.
        contact: String,
    },
    /// A body gives way: the plastic limit.
    #[error(
        "body `{body}` gives way beyond {percent:.3} % of step `{step}`: {share:.1} % of its elements \
         flow, and no increment beyond finds balance"
    )]
    #[diagnostic(
        code(brinell::solve::limit_load),
        help(
            "this is the plastic limit, or nearly so: the states up to there are kept; less load, a \
             thicker wall or a harder steel"
        )
    )]
    LimitLoad {
        /// Name of the step.
        step: String,
        /// Share of the step that was reached, in per cent.
        percent: f64,
        /// Name of the body.
        body: String,
        /// Share of its elements that flow, in per cent.
        share: f64,
    },
    /// A body turns further than small rotations allow.
    #[error(
        "body `{body}` turns by {angle:.3} rad beyond {percent:.3} % of step `{step}`: rotations are taken as \
         small, and up to {TOO_FAR} rad are solved for"
    )]
    #[diagnostic(
        code(brinell::solve::turns_far),
        help(
            "the states up to there are kept; less load or offset, more friction, or a support that holds it"
        )
    )]
    TurnsFar {
        /// Name of the step.
        step: String,
        /// Share of the step that was reached, in per cent.
        percent: f64,
        /// Name of the body.
        body: String,
        /// Radians.
        angle: f64,
    },
    /// Taking a load off takes too many iterations.
    #[error(
        "step `{step}` came to {percent:.3} % in {iterations} iterations, more than are spent on taking a load off"
    )]
    #[diagnostic(
        code(brinell::solve::crawls),
        help(
            "without load bodies that only contact holds all but float: take off less of it, or use a finer mesh"
        )
    )]
    Crawls {
        /// Name of the step.
        step: String,
        /// Share of the step that was reached, in per cent.
        percent: f64,
        /// Newton iterations that were spent.
        iterations: usize,
    },
    /// What stays after unloading was not found.
    #[error("what stays after unloading was not found: {residual:.1e} of the forces are left over")]
    #[diagnostic(
        code(brinell::solve::spring_back),
        help("`solver = \"direct\"` under [controls] takes more memory and is more robust")
    )]
    SpringBack {
        /// Residual force over applied force.
        residual: f64,
    },
    /// The state to go on from belongs to another scene.
    #[error(transparent)]
    #[diagnostic(
        code(brinell::solve::restart),
        help("run it from the start, or give the case and the mesh that the earlier run had")
    )]
    Restart(#[from] Stranger),
    /// The observer stopped the run with an error.
    #[error("{0}")]
    Observer(Box<dyn std::error::Error + Send + Sync>),
}

/// Rigid bodies cannot be in balance under the loads of a step, whatever the solution tries.
#[derive(Debug, Clone, PartialEq)]
pub struct NoBalance {
    /// Name of the step.
    pub step: String,
    /// Share of the step that was reached, in per cent.
    pub percent: f64,
    /// Name of the body.
    pub body: String,
    /// Does it turn, whatever the friction?
    pub tips: bool,
    /// Unit vector along which it slides, or about which it turns.
    pub along: Vec3,
    /// The contact pair that it bears on most, and where.
    pub bears: Option<(String, Vec3)>,
    /// The least coefficient of friction with which the bodies stand, if any does.
    pub friction: Option<f64>,
}

impl fmt::Display for NoBalance {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let vector = |v: Vec3| {
            let [x, y, z] = v.map(|c| if c.abs() < 5e-4 { 0.0 } else { c });
            format!("({x:.3}, {y:.3}, {z:.3})")
        };
        let how = match (self.tips, self.friction) {
            (true, _) => "tips or rolls, turning about",
            (false, Some(_)) => "slides along",
            (false, None) => "moves off along",
        };
        write!(
            f,
            "there is no balance beyond {:.3} % of step `{}`: body `{}` {how} {}",
            self.percent,
            self.step,
            self.body,
            vector(self.along)
        )?;
        if let Some((pair, [x, y, z])) = &self.bears {
            write!(
                f,
                "; it bears on `{pair}` about ({x:.4e}, {y:.4e}, {z:.4e})"
            )?;
        }
        write!(
            f,
            ". So says the statics of rigid bodies, without any solution"
        )
    }
}

impl NoBalance {
    fn remedy(&self) -> String {
        match self.friction {
            Some(friction) => format!(
                "the bodies, as they are meshed, stand with a coefficient of friction of {friction:.4} or more, or with less slope \
                 or offset"
            ),
            None => "no friction helps: bring the load nearer to the middle of what carries it (less offset), or \
                     support the body; where the balance is close, a mesh that follows round ends and faces \
                     more finely"
                .to_owned(),
        }
    }
}

impl SolveError {
    /// Was no balance found, whatever the reason, rather than the input refused?
    pub fn is_of_balance(&self) -> bool {
        matches!(
            self,
            Self::NotConverged { .. }
                | Self::FreeBody { .. }
                | Self::NoBalance(_)
                | Self::LimitLoad { .. }
                | Self::TurnsFar { .. }
                | Self::Crawls { .. }
        )
    }
}

fn in_pieces(pieces: usize) -> String {
    match pieces {
        0..=1 => String::new(),
        _ => format!("; it falls into {pieces} pieces that share no nodes"),
    }
}

/// What is next to nothing is more than what is left.
fn gigabytes(bytes: f64) -> String {
    match bytes < 1e7 {
        true => format!("{:.0e}", 1e-9 * bytes),
        false => format!("{:.2}", 1e-9 * bytes),
    }
}
