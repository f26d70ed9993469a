//! Problem H as quantities with known limits.

use super::limits::{HALF_WIDTH, MISES_BLOCK, MISES_CYLINDER, MISES_SOURCE, PRESSURE};
use super::reading::ProblemHReading;
use crate::product::converge::quantity::{Known, StudyQuantity};

/// The quantities of a reading, each with its limit where that is known.
pub fn quantities(reading: &ProblemHReading) -> Vec<StudyQuantity> {
    const HERTZ: &str = "Hertz's line contact (Johnson, Contact Mechanics, 4.43 and 4.45)";
    const NORM: &str = "distance from Hertz's half ellipse in L2, over the norm of the ellipse";
    // From the series of that program: its meshes, and its two ways to take the gap.
    let (contact, stress) = (0.0015, 0.002);
    let quantity = |name: &str, unit: &str, value: f64, known: Option<(f64, f64, &'static str)>| {
        let known = known.map(|(value, within, origin)| Known {
            value,
            within,
            origin,
        });
        StudyQuantity {
            name: name.into(),
            unit: unit.into(),
            value,
            known,
            at_singular_edge: false,
        }
    };
    let mut list = vec![
        quantity(
            "p0",
            "ksi",
            reading.pressure,
            Some((PRESSURE, contact, HERTZ)),
        ),
        quantity(
            "half-width",
            "in",
            reading.half_width,
            Some((HALF_WIDTH, contact, HERTZ)),
        ),
        quantity("pressure L2", "", reading.profile, Some((0.0, 0.0, NORM))),
        quantity("potential energy", "kip", reading.energy, None),
    ];
    let bodies = [
        ("block", reading.block, MISES_BLOCK),
        ("cylinder", reading.cylinder, MISES_CYLINDER),
    ];
    for (body, mises, limit) in bodies {
        let readings = [
            ("centroid", mises.centroid),
            ("nodal", mises.nodal),
            ("integration point", mises.integration_point),
        ];
        for (place, value) in readings {
            let name = format!("Mises {body}, {place}");
            list.push(quantity(
                &name,
                "ksi",
                value,
                Some((limit, stress, MISES_SOURCE)),
            ));
        }
    }
    list
}
