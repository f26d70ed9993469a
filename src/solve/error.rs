//! Why a scene could not be solved.

use crate::fem::dofs::Conflict;
use crate::linear::cholesky::FactorError;

/// Why a scene could not be solved. What was accepted before went to the observer.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum SolveError {
    #[error(transparent)]
    #[diagnostic(transparent)]
    Conflict(#[from] Conflict),
    #[error("nothing is free to move: every displacement component is prescribed")]
    #[diagnostic(
        code(brinell::solve::nothing_free),
        help("free a surface, or apply a load")
    )]
    NothingFree,
    #[error("{0}")]
    #[diagnostic(code(brinell::solve::factor), help("a coarser mesh needs less memory"))]
    Factor(#[from] FactorError),
    #[error("body `{body}` is free to move along {axis}: no support and no contact holds it")]
    #[diagnostic(
        code(brinell::solve::free_body),
        help("support it, bring it into contact, or give the contact friction")
    )]
    FreeBody { body: String, axis: char },
    #[error(
        "step `{step}` did not converge beyond {percent:.3} % of its load: after {iterations} \
         iterations the residual was {residual:.1e} of the load and the largest contact violation \
         {penetration:.1e} of the displacement"
    )]
    #[diagnostic(
        code(brinell::solve::not_converged),
        help(
            "the states up to there are kept; a load beyond the plastic limit ends like this, \
             otherwise try a smaller first increment or a finer mesh at the contact"
        )
    )]
    NotConverged {
        step: String,
        percent: f64,
        iterations: usize,
        residual: f64,
        penetration: f64,
    },
    #[error("what stays after unloading was not found: {residual:.1e} of the forces are left over")]
    #[diagnostic(
        code(brinell::solve::spring_back),
        help("`solver = \"direct\"` under [controls] takes more memory and is more robust")
    )]
    SpringBack { residual: f64 },
    #[error("{0}")]
    Observer(Box<dyn std::error::Error + Send + Sync>),
}
