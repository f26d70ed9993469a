//! A steel roller pressed on a steel block: Hertz's line contact.
//!
//! ```text
//!      | | | | |  pressure on the cut       a quarter of the roller and a half of the
//!     +---------+                           block, x >= 0, are mirrored along x;
//!     |        /   roller, R = 10 mm        plane strain along z
//!     |_____.-'
//!     +---------+    y
//!     |  block  |    |
//!     +---------+    +-- x
//! ```
//! mm, N, MPa. The closed form: K. L. Johnson, *Contact Mechanics*, 4.42 to 4.45, for half planes; the finite bodies
//! change the pressure by 0.1 to 0.2 %, and the Mises stress in the block by 1 to 2 %.

use brinell::analytic::subsurface::LineField;
use brinell::prelude::*;
use std::error::Error;

/// Radius of the roller, mm, and load per length, N/mm.
const RADIUS: f64 = 10.0;
const LOAD: f64 = 1000.0;

/// What, by finite elements, in closed form.
type Figures = Result<Vec<(&'static str, f64, f64)>, Box<dyn Error>>;

pub fn figures() -> Figures {
    let steel = Steel::elastic(210e3, 0.3);
    let elastic = Elastic::new(210e3, 0.3)?;
    let hertz = LineContact::new(LOAD, RADIUS, contact_compliance(elastic, elastic)?)?;
    let a = hertz.half_width;

    // Eight elements across the half-width, then larger and larger ones.
    let (size, fine, thick) = (a / 8.0, 1.5 * a, a);
    let grown = Grading::new(size, fine, 3.0 * RADIUS, 1.25).nodes(1);
    let deep = grown.iter().rev().map(|y| -y).collect();
    let roller = Cylinder::quarter("roller", RADIUS, thick).fine(size, fine);
    let block = Block::new("block", grown, deep, uniform(0.0, thick, 1));
    let scene = SceneBuilder::new("roller on block")
        .body(roller, steel)
        .body(block, steel)
        .contact(Contact::between("roller_contact", "block_y_max").named("contact"))
        .fix("block_y_min")
        .load(Load::pressure("roller_top", LOAD / (2.0 * RADIUS)))
        .mirror(Axis::X)
        .plane_strain(Axis::Z)
        .build()?;
    let answer = Solved::of(scene)?;

    let contact = answer.interface("contact").ok_or("no contact")?;
    let half_width = answer.spread("contact", 0, 0.0).ok_or("no contact")?;
    let below = LineField::below(&hertz, 0.3)?.peak_mises().value;
    let block = answer.body("block").and_then(|body| body.mises_max.nodal);
    Ok(vec![
        (
            "largest pressure, MPa",
            contact.max_pressure,
            hertz.peak_pressure,
        ),
        ("half-width, mm", half_width, a),
        (
            "largest Mises stress, block, MPa",
            block.unwrap_or(0.0),
            below,
        ),
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
