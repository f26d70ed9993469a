//! What the handbook answers, in the units of the input; stresses tension positive, pressures and
//! loads compression positive.

use serde::Serialize;

/// Largest Mises stress below the contact in one body.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Below {
    /// Mises stress.
    pub mises: f64,
    /// Depth below the surface.
    pub depth: f64,
    /// Mises stress over the body's yield stress.
    pub share_of_yield: f64,
    /// Largest Mises stress if the roller slid on the plate with the given friction.
    pub mises_in_sliding: Option<f64>,
}

/// First yield below the contact, in the body that yields first.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FirstYield {
    /// Peak pressure of the contact.
    pub peak_pressure: f64,
    /// Load per length.
    pub line_load: f64,
    /// Load on the whole roller.
    pub load: f64,
}

/// The design rules (2-49) and (2-50) of the reference study.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Rules {
    /// 1.65 times the lower yield stress.
    pub pressure_limit: f64,
    /// Peak pressure over that yield stress.
    pub pressure_over_yield: f64,
    /// D L as it is; for a displaced roller with the length that bears (2-51).
    pub diameter_times_length: f64,
    /// D L that (2-50) asks for with its printed constant 8.
    pub required_printed: f64,
    /// D L that the limit (2-49) in truth asks for, constant 7.7832.
    pub required_exact: f64,
    /// Load that this D L may carry, with the constant 8 and with the exact one.
    pub capacity_printed: f64,
    /// The same with the exact constant.
    pub capacity_exact: f64,
}

/// Ring bending of a hollow roller squeezed between two flats.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct HandbookBore {
    /// Hoop stress on the inner wall under the load, and its Mises stress in plane strain.
    pub hoop_under_load: f64,
    /// Mises stress there, in plane strain.
    pub mises_under_load: f64,
    /// Hoop stress on the inner wall at 90 degrees.
    pub hoop_at_side: f64,
    /// Changes of the outer and the inner diameter along the load. The outer one grows without
    /// bound as the contact narrows; none below a/R = 1e-3.
    pub outer_diameter_change: Option<f64>,
    /// Of the inner diameter.
    pub inner_diameter_change: f64,
    /// Hoop stress under the load by the curved-beam formula, and its relative error.
    pub curved_beam_hoop: f64,
    /// Relative error of that formula.
    pub curved_beam_error: f64,
}

/// The two lines of contact in the groove.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Groove {
    /// Force per length across each line without friction, and its bounds with friction.
    pub normal_load: f64,
    /// Its bounds with friction.
    pub normal_load_bounds: Option<[f64; 2]>,
    /// Distance of each line from the root.
    pub offset: f64,
    /// Gap over the root.
    pub gap_at_root: f64,
    /// Peak pressure and width of each line as if alone.
    pub peak_pressure: f64,
    /// Full width of each line.
    pub contact_width: f64,
    /// Largest Mises stress below a line.
    pub mises: f64,
    /// No yield below a line.
    pub elastic: bool,
    /// The peak pressure of each is within (2-49).
    pub within_limit: bool,
    /// Peak pressure with the other line's effect; none where the two merge.
    pub peak_pressure_with_interaction: Option<f64>,
}

/// One picture of a displaced roller's line load, at its largest.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Spread {
    /// Largest load per length.
    pub line_load: f64,
    /// Length that bears.
    pub bearing_length: f64,
    /// Peak pressure under that load.
    pub peak_pressure: f64,
    /// Larger of the two bodies' Mises stresses below the contact, elastic.
    pub mises: f64,
    /// No yield below the contact.
    pub elastic: bool,
    /// The peak pressure is within (2-49).
    pub within_limit: bool,
}

/// A displaced roller.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Displaced {
    /// Even load over L - 2e, as (2-51) assumes.
    pub block: Spread,
    /// Linear load without tension.
    pub linear: Spread,
    /// On one slope of the groove without friction, block load: force per length across it, and the horizontal
    /// force on the whole roller that the other contacts must react.
    pub on_slope: Option<[f64; 2]>,
    /// That force where friction between flat faces and slope holds the roller, half as large.
    pub rolling_push: Option<f64>,
}

/// What the handbooks say.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HandbookAnswer {
    /// Load per length p, spread evenly.
    pub line_load: f64,
    /// Peak pressure: exact, and by (2-48) with its printed 0.418.
    pub peak_pressure: f64,
    /// By (2-48) with its printed 0.418.
    pub peak_pressure_printed: f64,
    /// Mean pressure of the contact.
    pub mean_pressure: f64,
    /// Full contact width 2a: exact, and by (2-47) with its printed 2.263.
    pub contact_width: f64,
    /// By (2-47) with its printed 2.263.
    pub contact_width_printed: f64,
    /// Below the contact, in the roller.
    pub roller: Below,
    /// Below the contact, in the plate.
    pub plate: Below,
    /// Where yielding begins.
    pub first_yield: FirstYield,
    /// The design rules.
    pub rules: Rules,
    /// The bore of a hollow roller.
    pub bore: Option<HandbookBore>,
    /// The V groove, where the roller lies in one.
    pub groove: Option<Groove>,
    /// Off the centre, where it is.
    pub displaced: Option<Displaced>,
    /// The contact is small against radius, wall and plate ([`HALF_SPACE_SHARE`](super::HALF_SPACE_SHARE)).
    pub half_space_valid: bool,
    /// Nothing yields, neither below the contacts, those in the groove among them, nor at the bore; the roller centred.
    pub elastic: bool,
    /// The peak pressure is within (2-49), in the groove too; the roller centred.
    pub within_limit: bool,
    /// What limits the numbers above, in words.
    pub remarks: Vec<String>,
}
