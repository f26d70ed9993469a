//! Everything the handbooks say about one roller under a load: the first estimate, and the
//! numbers a finite-element answer is held against.

mod answer;

use serde::Serialize;

pub use answer::{
    Below, Displaced, FirstYield, Groove, HandbookAnswer, HandbookBore, Rules, Spread,
};

use crate::analytic::curved_beam::CurvedBeam;
use crate::analytic::displaced::{DisplacedRoller, SpreadLoad};
use crate::analytic::elastic::{Elastic, contact_compliance};
use crate::analytic::error::{self, DomainError};
use crate::analytic::hertz::LineContact;
use crate::analytic::ring::{PlaneState, Ring, RingLoad};
use crate::analytic::sizing::{self, PRESSURE_LIMIT, PRINTED};
use crate::analytic::subsurface::{LineField, onset};
use crate::analytic::vgroove::VGroove;

/// Half-space theory is taken as valid while the half width a is at most this share of the
/// roller's radius, its wall and the plate's thickness.
pub const HALF_SPACE_SHARE: f64 = 0.1;

/// Smallest half angle of a contact that the ring's series is summed for.
const SMALLEST_HALF_ANGLE: f64 = 1e-3;

/// One body's steel.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Metal {
    /// Young's modulus.
    pub youngs_modulus: f64,
    /// Poisson's ratio.
    pub poissons_ratio: f64,
    /// Yield stress.
    pub yield_stress: f64,
}

/// A cylindrical roller on a flat plate (and in a V groove, and off the centre, where given).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Handbook {
    /// Outer diameter D.
    pub diameter: f64,
    /// Wall thickness of a hollow roller; a solid one has none.
    pub wall: Option<f64>,
    /// Length L that bears.
    pub length: f64,
    /// Load P on the roller.
    pub load: f64,
    /// Steel of the roller.
    pub roller: Metal,
    /// Steel of the plate.
    pub plate: Metal,
    /// Thickness of the plate, for the check of the half space.
    pub plate_thickness: Option<f64>,
    /// Distance of the load's resultant from the roller's mid-length.
    pub offset: Option<f64>,
    /// Slope of each side of the groove, in degrees.
    pub groove_angle: Option<f64>,
    /// Coefficient of friction, zero for none.
    pub friction: f64,
}

/// The handbook's answer for a roller.
///
/// Hertz line contact of a cylinder on a flat ([`LineContact`]), the field below it
/// ([`LineField`]), the sizing rules ([`sizing`]), the exact ring under Hertz pressures ([`Ring`],
/// plane strain), the groove ([`VGroove`]) and the displaced roller ([`DisplacedRoller`]), with the
/// load even along the roller. For bodies of different steels, (2-48) and (2-50) take the modulus
/// of the equivalent pair and the lower yield stress.
///
/// # Errors
/// [`DomainError`] for an argument outside its range, by name.
pub fn handbook(input: &Handbook) -> Result<HandbookAnswer, DomainError> {
    let Handbook {
        diameter,
        length,
        load,
        friction,
        ..
    } = *input;
    let radius = 0.5 * error::positive("diameter", diameter)?;
    error::positive("length", length)?;
    error::positive("load", load)?;
    error::friction(friction)?;
    let bodies = ContactBodies::new(input, radius)?;
    let p = error::representable("load per length", load / length)?;
    let contact = LineContact::new(p, radius, bodies.compliance)?;
    let e = sizing::equivalent_modulus(bodies.compliance)?;
    let [roller, plate] = bodies.below(&contact, friction)?;
    let first_yield = bodies.first_yield(length)?;
    let displaced = displaced(input, &bodies)?;
    let bearing_length = displaced.map_or(length, |d| d.block.bearing_length);
    let rules = rules(input, &bodies, &contact, e, bearing_length)?;
    let mut remarks = Vec::new();
    let half_space_valid = half_space(input, &contact, &mut remarks)?;
    let bore = bore(input, &contact, bodies.roller, &mut remarks)?;
    let groove = groove(input, &bodies, p, &mut remarks)?;
    let bore_elastic = bore.is_none_or(|b| b.mises_under_load < input.roller.yield_stress);
    // One steel with ν = 0.3 comes back to its own modulus but for the last digits.
    if (e / input.roller.youngs_modulus - 1.0).abs() > 1e-9 {
        remarks.push(format!(
            "unlike bodies or ν other than 0.3: (2-48), (2-50) with E_s = {e:.6}"
        ));
    }
    Ok(HandbookAnswer {
        line_load: p,
        peak_pressure: contact.peak_pressure,
        peak_pressure_printed: PRINTED.steel_peak_pressure(p, radius, e)?,
        mean_pressure: contact.mean_pressure(),
        contact_width: contact.width(),
        contact_width_printed: PRINTED.contact_width(p, radius, bodies.compliance)?,
        roller,
        plate,
        first_yield,
        rules,
        bore,
        groove,
        displaced,
        half_space_valid,
        elastic: roller.share_of_yield < 1.0
            && plate.share_of_yield < 1.0
            && bore_elastic
            && groove.is_none_or(|groove| groove.elastic),
        within_limit: sizing::within_limit(contact.peak_pressure, bodies.lower_yield)?
            && groove.is_none_or(|groove| groove.within_limit),
        remarks,
    })
}

/// The two bodies of the contact.
struct ContactBodies {
    metals: [Metal; 2],
    radius: f64,
    roller: Elastic,
    compliance: f64,
    lower_yield: f64,
}

impl ContactBodies {
    fn new(input: &Handbook, radius: f64) -> Result<Self, DomainError> {
        let metals = [input.roller, input.plate];
        let roller = Elastic::new(metals[0].youngs_modulus, metals[0].poissons_ratio)?;
        let plate = Elastic::new(metals[1].youngs_modulus, metals[1].poissons_ratio)?;
        let compliance = contact_compliance(roller, plate)?;
        let first = error::positive("yield stress of the roller", metals[0].yield_stress)?;
        let second = error::positive("yield stress of the plate", metals[1].yield_stress)?;
        Ok(Self {
            metals,
            radius,
            roller,
            compliance,
            lower_yield: first.min(second),
        })
    }

    fn below(&self, contact: &LineContact, friction: f64) -> Result<[Below; 2], DomainError> {
        let body = |metal: Metal| -> Result<Below, DomainError> {
            let field = LineField::below(contact, metal.poissons_ratio)?;
            let peak = field.peak_mises();
            let sliding = field.sliding(friction)?;
            Ok(Below {
                mises: peak.value,
                depth: peak.depth,
                share_of_yield: peak.value / metal.yield_stress,
                mises_in_sliding: (friction > 0.0).then(|| sliding.peak_mises().value),
            })
        };
        Ok([body(self.metals[0])?, body(self.metals[1])?])
    }

    fn first_yield(&self, length: f64) -> Result<FirstYield, DomainError> {
        let at = |m: Metal| onset::line_yield_pressure(m.yield_stress, m.poissons_ratio, 0.0);
        let peak_pressure = at(self.metals[0])?.min(at(self.metals[1])?);
        let contact = LineContact::at_peak_pressure(peak_pressure, self.radius, self.compliance)?;
        let line_load = contact.line_load;
        Ok(FirstYield {
            peak_pressure,
            line_load,
            load: line_load * length,
        })
    }

    /// Contact under a line load, the larger Mises stress of the two bodies, and whether neither
    /// yields.
    fn contact(&self, line_load: f64) -> Result<(LineContact, f64, bool), DomainError> {
        let contact = LineContact::new(line_load, self.radius, self.compliance)?;
        let [first, second] = self.below(&contact, 0.0)?;
        let elastic = first.share_of_yield.max(second.share_of_yield) < 1.0;
        Ok((contact, first.mises.max(second.mises), elastic))
    }
}

fn rules(
    input: &Handbook,
    bodies: &ContactBodies,
    contact: &LineContact,
    e: f64,
    bearing_length: f64,
) -> Result<Rules, DomainError> {
    let (exact, y) = (sizing::exact(), bodies.lower_yield);
    let (load, d) = (input.load, input.diameter);
    Ok(Rules {
        pressure_limit: PRESSURE_LIMIT * y,
        pressure_over_yield: contact.peak_pressure / y,
        diameter_times_length: d * bearing_length,
        required_printed: PRINTED.required_diameter_times_length(load, e, y)?,
        required_exact: exact.required_diameter_times_length(load, e, y)?,
        capacity_printed: PRINTED.load_capacity(d, bearing_length, e, y)?,
        capacity_exact: exact.load_capacity(d, bearing_length, e, y)?,
    })
}

fn half_space(
    input: &Handbook,
    contact: &LineContact,
    remarks: &mut Vec<String>,
) -> Result<bool, DomainError> {
    let a = contact.half_width;
    let mut valid = true;
    let sizes = [
        ("radius of the roller", Some(0.5 * input.diameter)),
        ("wall of the roller", input.wall),
        ("thickness of the plate", input.plate_thickness),
    ];
    for (name, size) in sizes {
        let Some(size) = size else { continue };
        let share = a / error::positive(name, size)?;
        if share > HALF_SPACE_SHARE {
            valid = false;
            remarks.push(format!(
                "half the contact width is {share:.2} of the {name}"
            ));
        }
    }
    Ok(valid)
}

fn bore(
    input: &Handbook,
    contact: &LineContact,
    roller: Elastic,
    remarks: &mut Vec<String>,
) -> Result<Option<HandbookBore>, DomainError> {
    let Some(wall) = input.wall else {
        return Ok(None);
    };
    let outer = 0.5 * input.diameter;
    let allowed = wall < outer && wall >= 0.0051 * outer;
    error::require(
        "wall of the roller",
        wall,
        allowed,
        "between 0.51 % of the radius and all of it",
    )?;
    let inner = outer - wall;
    let share = contact.half_width / outer;
    if share > 0.5 {
        remarks.push("the contact is too wide for the ring formulas".into());
        return Ok(None);
    }
    // Narrower pressures are the same to the bore.
    let half_angle = share.asin().max(SMALLEST_HALF_ANGLE);
    let (w, load) = (contact.line_load, RingLoad::SemiElliptic { half_angle });
    let ring = Ring::new(inner, outer, w, roller, PlaneState::Strain, load)?;
    let beam = CurvedBeam::new(inner, outer, w, roller, PlaneState::Strain)?;
    let under = ring.bore_stress(0.0)?;
    if 4.0 * wall < input.diameter * (1.0 - 1e-12) {
        remarks.push(
            "wall below a quarter of the diameter: the reference study asks for a finite-element \
             analysis"
                .into(),
        );
    }
    let outer_change = ring.diameter_change(outer, 0.0)?;
    Ok(Some(HandbookBore {
        hoop_under_load: under.hoop,
        mises_under_load: under.mises(),
        hoop_at_side: ring.bore_stress(std::f64::consts::FRAC_PI_2)?.hoop,
        outer_diameter_change: (half_angle > SMALLEST_HALF_ANGLE).then_some(outer_change),
        inner_diameter_change: ring.diameter_change(inner, 0.0)?,
        curved_beam_hoop: beam.inner_under_load,
        curved_beam_error: beam.inner_under_load / under.hoop - 1.0,
    }))
}

fn groove(
    input: &Handbook,
    bodies: &ContactBodies,
    line_load: f64,
    remarks: &mut Vec<String>,
) -> Result<Option<Groove>, DomainError> {
    let Some(angle) = input.groove_angle else {
        return Ok(None);
    };
    let groove = VGroove::new(
        line_load,
        bodies.radius,
        angle.to_radians(),
        bodies.compliance,
    )?;
    let (contact, mises, elastic) = bodies.contact(groove.normal_load())?;
    if groove.normal_load() > line_load {
        remarks.push(
            "each slope of the groove presses harder than a flat plate, of which the rules speak"
                .into(),
        );
    }
    let together = groove.interaction().ok();
    if together.is_none() {
        remarks.push("the two lines in the groove are too close to be taken apart".into());
    }
    let bounds = groove.normal_load_bounds(input.friction);
    if bounds.is_err() {
        remarks.push("the roller jams in the groove: friction sets no upper bound".into());
    }
    Ok(Some(Groove {
        normal_load: groove.normal_load(),
        normal_load_bounds: bounds.ok(),
        offset: groove.offset(),
        gap_at_root: groove.gap_at_root(),
        peak_pressure: contact.peak_pressure,
        contact_width: contact.width(),
        mises,
        elastic,
        within_limit: sizing::within_limit(contact.peak_pressure, bodies.lower_yield)?,
        peak_pressure_with_interaction: together.map(|t| t.peak_pressure),
    }))
}

fn displaced(input: &Handbook, bodies: &ContactBodies) -> Result<Option<Displaced>, DomainError> {
    let Some(offset) = input.offset else {
        return Ok(None);
    };
    let roller = DisplacedRoller::new(input.load, input.length, offset)?;
    let spread = |picture: SpreadLoad| -> Result<Spread, DomainError> {
        let (contact, mises, elastic) = bodies.contact(picture.largest)?;
        Ok(Spread {
            line_load: picture.largest,
            bearing_length: picture.bearing_length,
            peak_pressure: contact.peak_pressure,
            mises,
            elastic,
            within_limit: sizing::within_limit(contact.peak_pressure, bodies.lower_yield)?,
        })
    };
    let block = spread(roller.block())?;
    let groove = |angle: f64| {
        let (w, c) = (block.line_load, bodies.compliance);
        VGroove::new(w, bodies.radius, angle.to_radians(), c)
    };
    let groove = input.groove_angle.map(groove).transpose()?;
    let on_slope = groove.map(|groove| {
        let [normal, push] = groove.on_one_slope();
        [normal, push * block.bearing_length]
    });
    Ok(Some(Displaced {
        block,
        linear: spread(roller.linear())?,
        on_slope,
        rolling_push: groove.map(|groove| groove.rolling_push() * block.bearing_length),
    }))
}
