//! Why a scene could not be solved.

use crate::model::state::turn::TOO_FAR;
use crate::solver::fem::dofs::Conflict;
use crate::solver::linear::cholesky::FactorError;
use crate::solver::solve::checkpoint::kept::Stranger;
use crate::solver::solve::no_balance::NoBalance;
use crate::solver::solve::ties::error::TieError;

/// Why a scene could not be solved. What was accepted before went to the observer.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum SolveError {
    /// Two supports prescribe the same displacement differently.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Conflict(#[from] Conflict),
    /// Surfaces cannot be tied.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Tie(#[from] TieError),
    /// Every displacement component is prescribed.
    #[error("nothing is free to move: every displacement component is prescribed")]
    #[diagnostic(
        code(brinell::solve::nothing_free),
        help("free a surface, or apply a load")
    )]
    NothingFree,
    /// The squares of the loads leave the range of floating-point numbers.
    #[error("the loads are too large: their squares leave the range of floating-point numbers")]
    #[diagnostic(
        code(brinell::solve::out_of_range),
        help(
            "look for a slip in a load or its unit, or choose units in which the numbers are nearer to 1"
        )
    )]
    OutOfRange,
    /// A matrix could not be factored: memory ran out, or it is not positive definite.
    #[error("{0}")]
    #[diagnostic(code(brinell::solve::factor), help("a coarser mesh needs less memory"))]
    Factor(#[from] FactorError),
    /// The scene needs more memory than there is.
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
        /// Unknowns of the scene.
        unknowns: usize,
        /// Bytes.
        needed: f64,
        /// Bytes that are left.
        available: f64,
    },
    /// A body can move without any resistance.
    #[error(
        "body `{body}` is free to move along {axis}: {}{}",
        not_held(contacts),
        in_pieces(*pieces)
    )]
    #[diagnostic(
        code(brinell::solve::free_body),
        help("support it, bring it into contact, or give the contact friction, or more of it")
    )]
    FreeBody {
        /// Name of the body.
        body: String,
        /// `x`, `y` or `z`.
        axis: char,
        /// Names of its contact pairs.
        contacts: Vec<String>,
        /// Parts of the body that share no nodes.
        pieces: usize,
    },
    /// Rigid bodies cannot be in balance under the loads.
    #[error("{0}")]
    #[diagnostic(code(brinell::solve::no_balance), help("{}", .0.remedy()))]
    NoBalance(Box<NoBalance>),
    /// The smallest increment did not converge.
    #[error(
        "step `{step}` did not converge beyond {percent:.3} % of its load: after {iterations} \
         iterations the residual was {residual:.1e} of the load, most of it in {place}, and the \
         largest contact violation {penetration:.1e} of the displacement: {contact}{}",
        in_addition(obstacle.as_deref())
    )]
    #[diagnostic(
        code(brinell::solve::not_converged),
        help("the states up to there are kept; {}", towards_balance(obstacle.as_deref()))
    )]
    NotConverged {
        /// Name of the step.
        step: String,
        /// Share of the step that was reached, in percent.
        percent: f64,
        /// Iterations that were spent.
        iterations: usize,
        /// Force that is left over, as a share.
        residual: f64,
        /// Contact violation over the largest displacement.
        penetration: f64,
        /// Where the residual and the violation are largest, in words.
        place: String,
        /// The contact that is furthest from settled, in words.
        contact: String,
        /// What stands in the way, where that can be told.
        obstacle: Option<Box<Obstacle>>,
    },
    /// So much of a body flows that it carries no more.
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
        /// Share of the step that was reached, in percent.
        percent: f64,
        /// Name of the body.
        body: String,
        /// Share of its elements that flow, in percent.
        share: f64,
    },
    /// A body turns farther than small rotations describe.
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
        /// Share of the step that was reached, in percent.
        percent: f64,
        /// Name of the body.
        body: String,
        /// Radians.
        angle: f64,
    },
    /// Taking the load off takes too many iterations.
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
        /// Share of the step that was reached, in percent.
        percent: f64,
        /// Iterations that were spent.
        iterations: usize,
    },
    /// The displacement that stays was not found.
    #[error("what stays after unloading was not found: {residual:.1e} of the forces are left over")]
    #[diagnostic(
        code(brinell::solve::spring_back),
        help("`solver = \"direct\"` under [controls] takes more memory and is more robust")
    )]
    SpringBack {
        /// Force that is left over, as a share.
        residual: f64,
    },
    /// A checkpoint belongs to another scene.
    #[error(transparent)]
    #[diagnostic(
        code(brinell::solve::restart),
        help("run it from the start, or give the case and the mesh that the earlier run had")
    )]
    Restart(#[from] Stranger),
    /// The observer stopped the solution with an error.
    #[error("{0}")]
    Observer(Box<dyn std::error::Error + Send + Sync>),
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

fn not_held(contacts: &[String]) -> String {
    match contacts {
        [] => "no support and no contact holds it".to_owned(),
        some => format!(
            "no support holds it, and contact does not (`{}`): it opens, or slides beyond its friction",
            some.join("`, `")
        ),
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
    if bytes < 1e7 {
        format!("{:.0e}", 1e-9 * bytes)
    } else {
        format!("{:.2}", 1e-9 * bytes)
    }
}

/// The body of which most flows.
#[derive(Debug, Clone, PartialEq)]
pub struct Flowing {
    /// Its name.
    pub body: String,
    /// Share of its elements that flow, in percent.
    pub percent: f64,
}

/// What most likely keeps an increment from balance.
#[derive(Debug, Clone, PartialEq)]
pub enum Obstacle {
    /// So much flows that the load may be beyond the plastic limit.
    Flow(Flowing),
    /// Rounding leaves up to this residual, and no more is left.
    Rounding(f64),
}

/// For the end of a message.
fn in_addition(obstacle: Option<&Obstacle>) -> String {
    match obstacle {
        Some(Obstacle::Flow(Flowing { body, percent })) => {
            format!("; {percent:.1} % of the elements of `{body}` flow")
        }
        Some(Obstacle::Rounding(share)) => format!(
            "; rounding alone leaves up to {share:.0e} of the load, as stiff bodies move along with what is far softer"
        ),
        None => String::new(),
    }
}

/// What may help where no balance was found.
fn towards_balance(obstacle: Option<&Obstacle>) -> String {
    match obstacle {
        Some(Obstacle::Flow(Flowing { body, .. })) => format!(
            "most likely the load is near the plastic limit of `{body}` or beyond it: less load, a thicker \
             section or a harder steel; else a finer mesh at the contact"
        ),
        Some(Obstacle::Rounding(share)) => format!(
            "bodies whose stiffness differs less, or a `residual` under `[controls]` of {:.0e}, which forces in the \
             result are then known to",
            2.0 * share
        ),
        None => "try a smaller first increment, or a finer mesh at the contact".to_owned(),
    }
}
