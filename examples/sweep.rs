//! A sweep in a loop: the pressure of a roller under four loads, which grows with the root of the load.
//!
//! ```text
//!      | | | | |  250, 500, 1000, 2000 N/mm
//!     +---------+
//!     |        /      a quarter of the roller, R = 10 mm, on a rigid flat,
//!     |_____.-'       mirrored along x; plane strain along z
//!     ///////////
//! ```
//! mm, N, MPa. Hertz: p₀ = √(w E*/πR); K. L. Johnson, *Contact Mechanics*, 4.45. Each load gets a mesh for the width of
//! its contact.
//!
//! For sweeps of bearings over many cores or machines there is the command `brinell sweep`.

use brinell::prelude::*;
use std::error::Error;

/// Radius of the roller, mm.
const RADIUS: f64 = 10.0;
/// Loads per length, N/mm.
const LOADS: [(f64, &str); 4] = [
    (250.0, "p0 at 250 N/mm, MPa"),
    (500.0, "p0 at 500 N/mm, MPa"),
    (1000.0, "p0 at 1000 N/mm, MPa"),
    (2000.0, "p0 at 2000 N/mm, MPa"),
];

/// What, by finite elements, in closed form.
type Figures = Result<Vec<(&'static str, f64, f64)>, Box<dyn Error>>;

pub fn figures() -> Figures {
    LOADS
        .into_iter()
        .map(|(load, what)| one(load, what))
        .collect()
}

fn one(load: f64, what: &'static str) -> Result<(&'static str, f64, f64), Box<dyn Error>> {
    let elastic = Elastic::new(210e3, 0.3)?;
    let compliance = contact_compliance(elastic, Elastic::RIGID)?;
    let hertz = LineContact::new(load, RADIUS, compliance)?;
    let a = hertz.half_width;
    let roller = Cylinder::quarter("roller", RADIUS, a).fine(a / 6.0, 1.5 * a);
    let flat = Contact::on_plane("roller_contact", [0.0; 3], [0.0, 1.0, 0.0]);
    let scene = SceneBuilder::new("roller on a rigid flat")
        .body(roller, Steel::elastic(210e3, 0.3))
        .contact(flat.named("flat"))
        .load(Load::pressure("roller_top", load / (2.0 * RADIUS)))
        .mirror(Axis::X)
        .plane_strain(Axis::Z)
        .build()?;
    let answer = Solved::of(scene)?;
    let contact = answer.interface("flat").ok_or("no contact")?;
    Ok((what, contact.max_pressure, hertz.peak_pressure))
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{:<36} {:>12} {:>12} {:>8}", "", "computed", "exact", "off");
    for (what, value, exact) in figures()? {
        let off = 100.0 * (value / exact - 1.0);
        println!("{what:<36} {value:>12.5} {exact:>12.5} {off:>6.2} %");
    }
    Ok(())
}
