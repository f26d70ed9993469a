//! A roller squeezed against a rigid flat: how far does its middle come down?
//!
//! ```text
//!     +---------+    the cut at mid-height is moved down as a rigid plane by its load
//!     |        /
//!     |      /       a quarter of the roller, R = 10 mm, mirrored along x;
//!     |___.-'        plane strain along z
//!     ///////////    rigid flat, y = 0
//! ```
//! mm, N, MPa. Half a cylinder squeezed by two opposed Hertz pressures: K. L. Johnson, *Contact Mechanics*, (5.57),
//! δ = w (1 - ν²)/πE [2 ln(4R/a) - 1], 0.04 to 0.7 % below the exact series. In it the mid-plane carries no shear and
//! stays plane, as it does here.

use brinell::prelude::*;
use brinell::proof::closed_forms::approach::half_cylinder;
use std::error::Error;

/// Radius, mm, and load per length, N/mm.
const RADIUS: f64 = 10.0;
const LOAD: f64 = 1000.0;

/// What, by finite elements, in closed form.
type Figures = Result<Vec<(&'static str, f64, f64)>, Box<dyn Error>>;

pub fn figures() -> Figures {
    let elastic = Elastic::new(210e3, 0.3)?;
    let compliance = contact_compliance(elastic, Elastic::RIGID)?;
    let hertz = LineContact::new(LOAD, RADIUS, compliance)?;
    let a = hertz.half_width;

    let thick = a;
    let roller = Cylinder::quarter("roller", RADIUS, thick);
    let flat = Contact::on_plane("roller_contact", [0.0; 3], [0.0, 1.0, 0.0]);
    let scene = SceneBuilder::new("roller on a rigid flat")
        .body(roller.fine(a / 8.0, 1.5 * a), Steel::elastic(210e3, 0.3))
        .contact(flat.named("flat"))
        // The modelled half bears half of the load.
        .load(Load::press("roller_top", Axis::Y, -0.5 * LOAD * thick))
        .mirror(Axis::X)
        .plane_strain(Axis::Z)
        .build()?;
    let answer = Solved::of(scene)?;

    let contact = answer.interface("flat").ok_or("no contact")?;
    let descent = answer.descent().ok_or("no load")?;
    let exact = half_cylinder(&hertz, RADIUS, elastic)?;
    Ok(vec![
        ("force per length, N/mm", contact.normal_force / thick, LOAD),
        (
            "largest pressure, MPa",
            contact.max_pressure,
            hertz.peak_pressure,
        ),
        ("descent of the mid-plane, mm", descent, exact),
    ])
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{:<36} {:>12} {:>12} {:>8}", "", "computed", "exact", "off");
    for (what, value, exact) in figures()? {
        let off = 100.0 * (value / exact - 1.0);
        println!("{what:<36} {value:>12.5} {exact:>12.5} {off:>6.2} %");
    }
    Ok(())
}
