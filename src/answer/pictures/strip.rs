//! The stress across each line of contact and below it, where it carries most, beside Hertz's.

use crate::analytic::hertz::LineContact;
use crate::analytic::subsurface::LineField;
use crate::answer::results::contact_lines::contact_lines;
use crate::answer::results::depth::mises_along;
use crate::answer::results::line_direction::line_frame;
use crate::answer::results::line_frame::{LineFrame, name_of};
use crate::answer::results::recovery::Recovered;
use crate::answer::results::strip_profile::{StripProfile, strip_profile};
use crate::answer::results::strip_sides::StripSides;
use crate::model::scene::Scene;
use crate::model::state::State;
use std::f64::consts::PI;

/// Points of a curve: place and value.
pub type Curve = Vec<(f64, f64)>;

/// A line of contact, what was computed across and below it, and Hertz's contact under the same load per
/// length.
#[derive(Debug, Clone, PartialEq)]
pub struct StripPicture {
    pub interface: String,
    /// The directions along and across it, and its mean coordinate across.
    pub frame: LineFrame,
    /// What the direction along it is called: x, y, z or its components.
    pub direction: String,
    pub across: f64,
    pub half_width: f64,
    pub profile: StripProfile,
    /// `None` where the curvature of a surface is not known, or the two do not curve apart.
    pub hertz: Option<LineContact>,
    /// Hertz's pressure against the distance from the middle; dense where it is steep.
    pub ellipse: Curve,
    /// How deep the curves below reach.
    pub reach: f64,
    /// Mises stress against depth, square to the surface below the centre of pressure: into the carrier's body
    /// and into the other, with their names. A rigid plane has none.
    pub below: [Option<(String, Curve)>; 2],
    /// The same of an elastic half space in plane strain under Hertz's pressure without friction, for each
    /// Poisson's ratio of the two bodies.
    pub closed_form: Vec<(f64, Curve)>,
}

/// As deep as so many half-widths.
const REACH: f64 = 6.0;

/// Every line of contact of the modelled part.
pub fn strips(scene: &Scene, state: &State, recovered: &Recovered) -> Vec<StripPicture> {
    let mut all = Vec::new();
    for (pair, contact) in scene.contacts.iter().enumerate() {
        let Some(frame) = line_frame(scene, pair) else {
            continue;
        };
        for line in contact_lines(scene, state, pair, &frame) {
            let Some(profile) = strip_profile(scene, state, pair, &frame, &line) else {
                continue;
            };
            let half_width = line.heaviest.half_width;
            let sides = StripSides::of(scene, contact, (&frame, &line.heaviest));
            let hertz = sides.under(scene, contact, profile.line_load);
            let reach = REACH * hertz.map_or(half_width, |hertz| hertz.half_width);
            let partners = contact.carrier_first();
            let bodies = partners.map(|partner| partner.body(&scene.mesh));
            all.push(StripPicture {
                interface: contact.name.clone(),
                frame,
                direction: name_of(&frame.along),
                across: line.across,
                half_width,
                ellipse: hertz.as_ref().map_or_else(Vec::new, ellipse),
                reach,
                below: below((scene, recovered), bodies, &profile, reach),
                closed_form: closed_form(scene, bodies, hertz.as_ref(), reach),
                hertz,
                profile,
            });
        }
    }
    all
}

/// Computed stress into both bodies.
fn below(
    (scene, recovered): (&Scene, &Recovered),
    [carrier, other]: [Option<usize>; 2],
    profile: &StripProfile,
    reach: f64,
) -> [Option<(String, Curve)>; 2] {
    [(carrier, -1.0), (other, 1.0)].map(|(body, sign)| {
        let body = body?;
        let into = profile.normal.map(|n| sign * n);
        let curve = mises_along(scene, recovered, body, (profile.centre, into), reach);
        Some((scene.mesh.bodies[body].name.clone(), curve))
    })
}

/// One curve for each of the Poisson's ratios.
fn closed_form(
    scene: &Scene,
    bodies: [Option<usize>; 2],
    hertz: Option<&LineContact>,
    reach: f64,
) -> Vec<(f64, Curve)> {
    const POINTS: u32 = 90;
    let mut ratios: Vec<f64> = Vec::new();
    for body in bodies.into_iter().flatten() {
        let ratio = scene.materials[body].poissons_ratio;
        if !ratios.contains(&ratio) {
            ratios.push(ratio);
        }
    }
    let curve = |field: LineField| {
        let depths = (0..=POINTS).map(|k| reach * f64::from(k) / f64::from(POINTS));
        let points = depths.filter_map(|z| Some((z, field.stress(0.0, z).ok()?.mises())));
        points.collect()
    };
    let field = |ratio: f64| Some((ratio, curve(LineField::below(hertz?, ratio).ok()?)));
    ratios.into_iter().filter_map(field).collect()
}

fn ellipse(hertz: &LineContact) -> Curve {
    const POINTS: u32 = 60;
    let place = |k: u32| -(PI * f64::from(k) / f64::from(POINTS)).cos();
    let points = (0..=POINTS).map(place).filter_map(|share| {
        let x = share * hertz.half_width;
        Some((x, hertz.pressure(x).ok()?))
    });
    points.collect()
}
