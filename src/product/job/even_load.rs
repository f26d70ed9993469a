//! What the handbook says of the rollers of a bearing under an even line load.

use super::error::JobError;
use crate::analytic::DomainError;
use crate::analytic::handbook::{Handbook, Metal, handbook};
use crate::case::BearingCase;
use crate::case::bearing::BearingGeometry;
use crate::model::scene::Scene;

/// Figures of a bearing whose rollers share the load evenly, each along its whole length.
pub(super) struct EvenlyLoaded {
    /// Hertz's pressure on a flat plate, or where it is largest.
    pub peak_pressure: f64,
    /// Hertz's pressure of interfaces that differ from that.
    pressures: Vec<(String, f64)>,
    /// Largest Mises stress below a line, in a plate.
    pub plate_mises: f64,
    /// The same in a roller.
    pub roller_mises: f64,
    /// On the inner wall of a hollow roller.
    pub bore_mises: Option<f64>,
}

impl EvenlyLoaded {
    /// Of `bearing` in the steels of `scene`.
    ///
    /// # Errors
    /// Where a closed form has no value.
    pub fn of(bearing: &BearingCase, scene: &Scene) -> Result<Self, JobError> {
        let of = match bearing.geometry.crossed() {
            Some(geometry) => Self::crossed(bearing, geometry, scene),
            None => Self::parallel(bearing, scene),
        };
        of.map_err(|error| JobError::ClosedForm {
            what: "the roller under an even line load".to_owned(),
            why: error.to_string(),
        })
    }

    /// Hertz's pressure of an interface.
    pub fn peak_pressure_of(&self, interface: &str) -> f64 {
        let own = self.pressures.iter().find(|(name, _)| name == interface);
        own.map_or(self.peak_pressure, |(_, pressure)| *pressure)
    }

    fn crossed(
        bearing: &BearingCase,
        g: &BearingGeometry,
        scene: &Scene,
    ) -> Result<Self, DomainError> {
        let hertz = handbook(&Handbook {
            diameter: g.roller.diameter,
            wall: g.roller.wall,
            length: g.roller.length,
            load: bearing.load,
            roller: metal(scene, "upper_roller"),
            plate: metal(scene, "intermediate_plate"),
            plate_thickness: Some(g.intermediate_thickness),
            offset: (g.offset > 0.0).then_some(g.offset),
            groove_angle: Some(g.slope.to_degrees()),
            friction: bearing.friction,
        })?;
        let valleys = bearing.seats().into_iter().filter(|seat| seat.is_valley());
        let pressures = hertz.groove.map_or(Vec::new(), |groove| {
            valleys
                .map(|seat| (seat.interface, groove.peak_pressure))
                .collect()
        });
        Ok(Self {
            peak_pressure: hertz.peak_pressure,
            pressures,
            plate_mises: hertz.plate.mises,
            roller_mises: hertz.roller.mises,
            bore_mises: hertz.bore.map(|ring| ring.mises_under_load),
        })
    }

    fn parallel(bearing: &BearingCase, scene: &Scene) -> Result<Self, DomainError> {
        let g = &bearing.geometry;
        let mut even = Self {
            peak_pressure: 0.0,
            pressures: Vec::new(),
            plate_mises: 0.0,
            roller_mises: 0.0,
            bore_mises: None,
        };
        for seat in bearing.seats() {
            // On a curved plate as on a flat of the same effective radius; the ring is that of the roller.
            let roller = Handbook {
                diameter: g.diameter(),
                wall: g.wall(),
                length: g.length(),
                load: seat.even(bearing.load),
                roller: metal(scene, &seat.roller),
                plate: metal(scene, &seat.plate),
                plate_thickness: Some(seat.plate_thickness),
                offset: None,
                groove_angle: None,
                friction: bearing.friction,
            };
            let hertz = handbook(&Handbook {
                diameter: 2.0 * seat.radius,
                wall: None,
                ..roller
            })?;
            let largest = |most: &mut f64, value: f64| *most = most.max(value);
            largest(&mut even.peak_pressure, hertz.peak_pressure);
            largest(&mut even.plate_mises, hertz.plate.mises);
            largest(&mut even.roller_mises, hertz.roller.mises);
            even.pressures.push((seat.interface, hertz.peak_pressure));
            if g.wall().is_some() && even.bore_mises.is_none() {
                even.bore_mises = handbook(&roller)?.bore.map(|ring| ring.mises_under_load);
            }
        }
        Ok(even)
    }
}

/// The steel of a body.
fn metal(scene: &Scene, body: &str) -> Metal {
    let index = scene.mesh.body(body).unwrap_or(0);
    let steel = &scene.materials[index];
    Metal {
        youngs_modulus: steel.youngs_modulus,
        poissons_ratio: steel.poissons_ratio,
        // No figure that is taken from here depends on it.
        yield_stress: match steel.is_elastic() {
            true => steel.youngs_modulus,
            false => steel.yield_stress,
        },
    }
}
