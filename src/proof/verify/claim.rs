//! A claim of the ladder: a value beside a known answer.

/// One claim.
#[derive(Debug, Clone, PartialEq)]
pub struct LadderClaim {
    pub family: &'static str,
    pub claim: String,
    /// Where the reference comes from.
    pub source: &'static str,
    pub reference: f64,
    pub value: f64,
    /// |value − reference| over the scale of the claim, usually the reference itself.
    pub error: f64,
    /// Largest allowed error; infinite where the value is only shown beside others.
    pub tolerance: f64,
    /// Why this tolerance, in one line.
    pub why: &'static str,
    /// Unknowns of the mesh.
    pub dofs: usize,
    /// Wall-clock seconds of the solution that the value was read from.
    pub seconds: f64,
}

impl LadderClaim {
    /// `value` differs from `reference` by no more than the share `tolerance` of it.
    pub fn relative(claim: impl Into<String>, value: f64, reference: f64, tolerance: f64) -> Self {
        Self::scaled(claim, value, reference, reference.abs(), tolerance)
    }

    /// `value` differs from `reference` by no more than the share `tolerance` of `scale`.
    pub fn scaled(
        claim: impl Into<String>,
        value: f64,
        reference: f64,
        scale: f64,
        tolerance: f64,
    ) -> Self {
        Self {
            family: "",
            claim: claim.into(),
            source: "",
            reference,
            value,
            error: (value - reference).abs() / scale,
            tolerance,
            why: "",
            dofs: 0,
            seconds: 0.0,
        }
    }

    /// An error that is to be as good as zero.
    pub fn small(claim: impl Into<String>, error: f64, tolerance: f64) -> Self {
        Self::scaled(claim, error, 0.0, 1.0, tolerance)
    }

    /// A value shown beside the claims, without tolerance.
    pub fn shown(claim: impl Into<String>, value: f64, reference: f64) -> Self {
        Self::relative(claim, value, reference, f64::INFINITY)
    }

    /// Where the reference comes from.
    pub fn from(mut self, source: &'static str) -> Self {
        self.source = source;
        self
    }

    /// Why the tolerance is what it is.
    pub fn because(mut self, why: &'static str) -> Self {
        self.why = why;
        self
    }

    /// Is it only shown beside the claims, without a tolerance?
    pub fn is_shown(&self) -> bool {
        self.tolerance.is_infinite()
    }

    /// Is the error within the tolerance? A value that is no number never is.
    pub fn holds(&self) -> bool {
        self.error <= self.tolerance
    }
}
