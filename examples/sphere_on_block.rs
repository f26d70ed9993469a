//! A steel ball pressed on a steel block: Hertz's point contact.
//!
//! A contact feels what lies within a few of its widths: a cap of the ball and a part of the block, each ten contact
//! radii wide and high, stand for both. What is left out makes the cap softer by some (1/10)³.
//!
//! ```text
//!        | | |  rigid plane, pressed down
//!      +-------+      a quarter, x >= 0 and y >= 0, is mirrored along x and y
//!      |  cap  |
//!      +---__..+      z
//!      +-------+      |
//!      | block |      +-- x
//!      +-------+
//! ```
//! mm, N, MPa. The closed form: K. L. Johnson, *Contact Mechanics*, 3.22 to 3.24.

use brinell::prelude::*;
use std::error::Error;

/// Radius of the ball, mm, and load, N.
const RADIUS: f64 = 50.0;
const LOAD: f64 = 1000.0;

/// What, by finite elements, in closed form.
type Figures = Result<Vec<(&'static str, f64, f64)>, Box<dyn Error>>;

pub fn figures() -> Figures {
    let steel = Steel::elastic(210e3, 0.3);
    let elastic = Elastic::new(210e3, 0.3)?;
    let hertz = PointContact::new(LOAD, RADIUS, contact_compliance(elastic, elastic)?)?;
    let a = hertz.contact_radius;

    // Five elements along the contact radius; the block's are a tenth longer.
    let across = |size: f64| Grading::new(size * a / 5.0, 1.2 * a, 10.0 * a, 1.6).nodes(1);
    let upward = |size: f64| Grading::new(size * a / 5.0, 0.8 * a, 10.0 * a, 1.6).nodes(1);
    // A box whose lower face is bent to the sphere, the upper one staying flat.
    let rise = |x: f64, y: f64| RADIUS - (RADIUS * RADIUS - x * x - y * y).sqrt();
    let cap = Block::new("cap", across(1.0), across(1.0), upward(1.0))
        .mapped(|[x, y, z]| [x, y, z + rise(x, y) * (1.0 - z / (10.0 * a)).max(0.0)]);
    let deep = upward(1.1).iter().rev().map(|z| -z).collect();
    let block = Block::new("block", across(1.1), across(1.1), deep);
    let scene = SceneBuilder::new("ball on block")
        .body(cap, steel)
        .body(block, steel)
        .contact(Contact::between("cap_z_min", "block_z_max").named("contact"))
        .hold("block_z_min", Axis::Z)
        // The modelled quarter bears a quarter of the load.
        .load(Load::press("cap_z_max", Axis::Z, -0.25 * LOAD))
        .mirror(Axis::X)
        .mirror(Axis::Y)
        .build()?;
    let answer = Solved::of(scene)?;

    let contact = answer.interface("contact").ok_or("no contact")?;
    let spread = answer.spread("contact", 0, 0.0).ok_or("no contact")?;
    Ok(vec![
        ("force, N", contact.normal_force, LOAD),
        (
            "largest pressure, MPa",
            contact.max_pressure,
            hertz.peak_pressure,
        ),
        ("contact radius, mm", 0.5 * 5f64.sqrt() * spread, a),
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
