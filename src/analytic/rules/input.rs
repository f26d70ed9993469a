//! What the rules are asked of: a roller, what it lies on, and their steels.

use super::rule::{Bound, NoLimit};
use crate::analytic::elastic::{Elastic, contact_compliance};
use crate::analytic::error::{self, DomainError};
use crate::analytic::hertz::LineContact;
use crate::analytic::sizing::equivalent_modulus;
use crate::ground::units::{Dimension, UnitSystem};

/// The steel of one side. What is not known is `None`: rules that want it say so.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RuleSteel {
    /// Young's modulus E.
    pub youngs_modulus: f64,
    /// Poisson's ratio ν.
    pub poissons_ratio: f64,
    /// Yield stress Y.
    pub yield_stress: Option<f64>,
    /// Ultimate strength f_u.
    pub ultimate_strength: Option<f64>,
    /// Brinell hardness of the surface, a bare number.
    pub hardness: Option<f64>,
    /// Is the surface hardened, over a softer core of that yield stress?
    pub surface_hardened: bool,
}

impl RuleSteel {
    /// A steel of which only the elastic constants are known.
    pub fn elastic(youngs_modulus: f64, poissons_ratio: f64) -> Self {
        Self {
            youngs_modulus,
            poissons_ratio,
            yield_stress: None,
            ultimate_strength: None,
            hardness: None,
            surface_hardened: false,
        }
    }
}

/// A roller on what it rolls on; every number but the hardness in the units named.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RuleInput {
    /// Units of all numbers: some rules have constants in units of their own.
    pub units: UnitSystem,
    /// Diameter D of the roller.
    pub diameter: f64,
    /// Diameter of the groove that it lies in, where it lies in one: larger than the roller's. Negative: of a face that
    /// bulges towards the roller. `None` for a flat.
    pub mating_diameter: Option<f64>,
    /// Length L of the roller.
    pub length: f64,
    /// Steels of the roller and of what it lies on.
    pub sides: [RuleSteel; 2],
    /// Radius of the edge of the shorter part, zero for a square one.
    pub end_radius: f64,
    /// By how much the longer part stands out beyond the contact.
    pub overhang: Option<f64>,
    /// How far the bearing rotates about the axis of the roller, in radians.
    pub rotation: Option<f64>,
    /// How often a point of the surface is rolled over, under the full load.
    pub rollings: Option<f64>,
}

impl RuleInput {
    /// A roller with square ends on a flat.
    pub fn new(units: UnitSystem, diameter: f64, length: f64, sides: [RuleSteel; 2]) -> Self {
        Self {
            units,
            diameter,
            mating_diameter: None,
            length,
            sides,
            end_radius: 0.0,
            overhang: None,
            rotation: None,
            rollings: None,
        }
    }
}

/// The input, checked, with what all rules use of it.
pub(super) struct RuleContact<'a> {
    pub input: &'a RuleInput,
    /// Effective radius of the two surfaces.
    pub radius: f64,
    /// C_E.
    pub compliance: f64,
    /// E_s of one steel with ν = 0.3 and the same compliance.
    pub modulus: f64,
}

impl<'a> RuleContact<'a> {
    pub fn new(input: &'a RuleInput) -> Result<Self, DomainError> {
        let roller = error::positive("diameter of the roller", input.diameter)?;
        error::positive("length of the roller", input.length)?;
        error::non_negative("radius of the edge", input.end_radius)?;
        let mut curvature = 2.0 / roller;
        if let Some(groove) = input.mating_diameter {
            let is_larger = groove.is_finite() && (groove > roller || groove < 0.0);
            let allowed = "larger than that of the roller, or negative where it bulges";
            error::require("diameter of the groove", groove, is_larger, allowed)?;
            curvature -= 2.0 / groove;
        }
        for value in [input.overhang, input.rotation].into_iter().flatten() {
            error::non_negative("overhang or rotation", value)?;
        }
        for steel in &input.sides {
            let known = [
                ("yield stress", steel.yield_stress),
                ("ultimate strength", steel.ultimate_strength),
                ("Brinell hardness", steel.hardness),
            ];
            for (name, value) in known {
                value.map(|v| error::positive(name, v)).transpose()?;
            }
        }
        let [first, second] = input
            .sides
            .map(|s| Elastic::new(s.youngs_modulus, s.poissons_ratio));
        let compliance = contact_compliance(first?, second?)?;
        Ok(Self {
            input,
            radius: curvature.recip(),
            compliance,
            modulus: equivalent_modulus(compliance)?,
        })
    }

    /// The limit of a load per length, with the peak pressure that it makes.
    pub fn at_line_load(&self, line_load: f64) -> Result<Bound, NoLimit> {
        let contact = LineContact::new(line_load, self.radius, self.compliance)?;
        Ok(Bound {
            line_load,
            pressure: contact.peak_pressure,
        })
    }

    /// The limit of a peak pressure, with the load per length that makes it.
    pub fn at_pressure(&self, pressure: f64) -> Result<Bound, NoLimit> {
        let contact = LineContact::at_peak_pressure(pressure, self.radius, self.compliance)?;
        Ok(Bound {
            line_load: contact.line_load,
            pressure,
        })
    }

    /// The lower of what both sides have; without one of them none.
    fn lower(&self, name: &'static str, of: fn(&RuleSteel) -> Option<f64>) -> Result<f64, NoLimit> {
        let [first, second] = &self.input.sides;
        match (of(first), of(second)) {
            (Some(a), Some(b)) => Ok(a.min(b)),
            (None, None) => Err(NoLimit::Needs(format!("the {name} of both steels"))),
            (None, _) => Err(NoLimit::Needs(format!("the {name} of the roller's steel"))),
            (_, None) => Err(NoLimit::Needs(format!("the {name} of the plate's steel"))),
        }
    }

    /// The lower yield stress.
    pub fn yield_stress(&self) -> Result<f64, NoLimit> {
        self.lower("yield stress", |steel| steel.yield_stress)
    }

    /// The lower ultimate strength.
    pub fn ultimate_strength(&self) -> Result<f64, NoLimit> {
        self.lower("ultimate strength", |steel| steel.ultimate_strength)
    }

    /// The lower Brinell hardness.
    pub fn hardness(&self) -> Result<f64, NoLimit> {
        self.lower("Brinell hardness", |steel| steel.hardness)
    }

    /// Only a flat will do.
    pub fn on_a_flat(&self) -> Result<(), NoLimit> {
        let Some(groove) = self.input.mating_diameter else {
            return Ok(());
        };
        let flat = "that of a flat: the rule knows no other";
        Err(DomainError::out_of_range("diameter of the groove", groove, flat).into())
    }

    /// The factor that takes a number of these units into those of `system`.
    pub fn factor_to(&self, system: UnitSystem, dimension: Dimension) -> f64 {
        self.input.units.factor_to(system, dimension)
    }
}
