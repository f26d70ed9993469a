//! A steel roller on a block of bronze: which body gives way, and where it is stressed most.
//!
//! ```text
//!      | | | | |  pressure on the cut       a quarter of the roller and a half of the
//!     +---------+                           block, x >= 0, are mirrored along x;
//!     |        /   steel, R = 20 mm         plane strain along z
//!     |_____.-'
//!     +---------+    y
//!     | bronze  |    |
//!     +---------+    +-- x
//! ```
//! mm, N, MPa. Hertz's contact knows both materials by one number, 1/E* = (1 - ν₁²)/E₁ + (1 - ν₂²)/E₂. Each body's
//! Mises stress below it depends on its own ν, by McEwen's field: K. L. Johnson, *Contact Mechanics*, 4.49. Without
//! friction nothing else couples them.

use brinell::analytic::subsurface::LineField;
use brinell::prelude::*;
use std::error::Error;

/// Radius of the roller, mm, and load per length, N/mm.
const RADIUS: f64 = 20.0;
const LOAD: f64 = 1500.0;
/// Young's modulus, MPa, and Poisson's ratio.
const STEEL: (f64, f64) = (210e3, 0.3);
const BRONZE: (f64, f64) = (110e3, 0.34);

/// What, by finite elements, in closed form.
type Figures = Result<Vec<(&'static str, f64, f64)>, Box<dyn Error>>;

pub fn figures() -> Figures {
    let (steel, bronze) = (
        Elastic::new(STEEL.0, STEEL.1)?,
        Elastic::new(BRONZE.0, BRONZE.1)?,
    );
    let hertz = LineContact::new(LOAD, RADIUS, contact_compliance(steel, bronze)?)?;
    let a = hertz.half_width;

    let (size, fine, thick) = (a / 10.0, 1.5 * a, a);
    // A block of twice the radius would have 1.4 % more stress below the strip than a half space.
    let wide = Grading::new(size, fine, 8.0 * RADIUS, 1.2).nodes(1);
    let deep = wide.iter().rev().map(|y| -y).collect();
    let roller = Cylinder::quarter("roller", RADIUS, thick).fine(size, fine);
    let scene = SceneBuilder::new("steel on bronze")
        .body(roller, Steel::elastic(STEEL.0, STEEL.1))
        .body(
            Block::new("block", wide, deep, uniform(0.0, thick, 1)),
            Steel::elastic(BRONZE.0, BRONZE.1),
        )
        .contact(Contact::between("roller_contact", "block_y_max").named("contact"))
        .fix("block_y_min")
        .load(Load::pressure("roller_top", LOAD / (2.0 * RADIUS)))
        .mirror(Axis::X)
        .plane_strain(Axis::Z)
        .build()?;
    let answer = Solved::of(scene)?;

    let contact = answer.interface("contact").ok_or("no contact")?;
    let mut figures = vec![
        (
            "largest pressure, MPa",
            contact.max_pressure,
            hertz.peak_pressure,
        ),
        (
            "half-width, mm",
            answer.spread("contact", 0, 0.0).ok_or("no contact")?,
            a,
        ),
    ];
    let bodies = [
        ("roller", STEEL.1, "largest Mises stress, roller, MPa"),
        ("block", BRONZE.1, "largest Mises stress, block, MPa"),
    ];
    for (body, poisson, what) in bodies {
        let exact = LineField::below(&hertz, poisson)?.peak_mises().value;
        let peak = answer.body(body).and_then(|body| body.mises_max.nodal);
        figures.push((what, peak.ok_or("no body")?, exact));
    }
    Ok(figures)
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{:<36} {:>12} {:>12} {:>8}", "", "computed", "exact", "off");
    for (what, value, exact) in figures()? {
        let off = 100.0 * (value / exact - 1.0);
        println!("{what:<36} {value:>12.5} {exact:>12.5} {off:>6.2} %");
    }
    Ok(())
}
