//! The sizing rules (2-49) to (2-51) of the reference study, in the summary.

use crate::analytic::rules::RuleVerdict;
use serde::Serialize;

/// What the sizing rules say of a bearing, and of the lines of a general scene.
#[derive(Debug, Clone, Default, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Sizing {
    /// (2-50) and (2-51), of a bearing; none where nothing can yield.
    pub rule: Option<SizingRule>,
    /// (2-49) under the actual load of each line of contact.
    pub lines: Vec<SizedLine>,
    /// Contacts at a point or over an ellipse, beside first yield.
    pub patches: Vec<SizedPatch>,
}

/// Hertz's elliptic contact under the force of a patch, beside the pressure at which steel first yields below it.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SizedPatch {
    pub interface: String,
    /// How many such patches the whole has.
    pub images: usize,
    /// Force of one of them.
    pub force: f64,
    /// Relative radii of curvature in the principal planes, the larger one first.
    pub relative_radii: [f64; 2],
    /// Semi-axes of the ellipse in those planes.
    pub semi_axes: [f64; 2],
    /// p0.
    pub hertz_pressure: f64,
    /// p0 at which the side that yields first does, by Mises on the axis; none where neither yields.
    pub first_yield: Option<f64>,
    /// p0 over that.
    pub utilisation: Option<f64>,
    /// Why the patch is not Hertz's, where it is not.
    pub not_hertz: Option<&'static str>,
}

/// The rule (2-50) with the effective length of (2-51).
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SizingRule {
    /// The interface whose steels ask for most.
    pub interface: String,
    /// P on one roller.
    pub load: f64,
    pub diameter: f64,
    /// L', of the roller.
    pub length: f64,
    /// D_r of this case, from the centre.
    pub displacement: f64,
    /// L = L' - 2 D_r, (2-51): what is taken to bear.
    pub effective_length: f64,
    /// With the constant as the study prints it, and with the exact one.
    pub printed: Demand,
    pub exact: Demand,
}

/// (2-50) with one constant: D L ≥ P E_s / (c σ_y²).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Demand {
    /// c.
    pub constant: f64,
    /// D L that the load asks for, and the D L that there is; areas.
    pub required_diameter_times_length: f64,
    pub provided: f64,
    /// L' = L + 2 D_r that the load asks for, (2-51).
    pub required_length: f64,
    pub met: bool,
}

/// The demand σ_c ≤ 1.65 σ_y, (2-49), on a line of contact.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SizedLine {
    pub interface: String,
    /// Mean coordinate across, and how many such lines the whole bearing has.
    pub across: f64,
    pub images: usize,
    /// Relative radius of curvature that p0 is of.
    pub relative_radius: f64,
    /// Why the strip is not Hertz's, where that is known of this line and it is not.
    pub not_hertz: Option<&'static str>,
    /// Is this both lines of a V, which the mesh does not tell apart? Then its largest load is that of both, p0 that of one
    /// line under it, which is a bound, and the even load that of each.
    pub merged: bool,
    /// Largest force normal to the surface per length, and the coordinate along where it is.
    pub peak_line_load: f64,
    pub at: f64,
    /// From there to the nearer end of the roller. Near zero, the end makes the peak, which then
    /// belongs to the mesh.
    pub from_end: f64,
    /// p0 under that load, as if it were the same all along.
    pub hertz_pressure: f64,
    /// 1.65 times the lower yield stress of the two sides; none where neither yields.
    pub limit: Option<f64>,
    /// p0 over the limit.
    pub utilisation: Option<f64>,
    /// What that may be off by; none where nothing is known of it.
    pub error: Option<f64>,
    /// Is p0 within the limit, whatever it may be off by? Null of two lines in one, where that is open.
    pub met: Option<bool>,
    /// What (2-49) says, as far as p0 is known.
    pub verdict: Option<RuleVerdict>,
    /// The same for the force of the line spread evenly over the length that bears, less 2 D_r of a displaced roller, (2-51).
    pub even: EvenLoad,
}

/// A line of contact under an even load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct EvenLoad {
    pub line_load: f64,
    pub hertz_pressure: f64,
    pub utilisation: Option<f64>,
    pub met: Option<bool>,
}
