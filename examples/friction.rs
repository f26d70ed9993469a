//! Two rollers pressed together and pushed sideways with half of what makes them slide: the middle sticks.
//!
//! ```text
//!      | | | | | P, then -> Q = μP/2
//!     +---------+
//!      \  half /       two equal half rollers, R = 20 mm, μ = 0.3,
//!       `--_--´        the lower one held at its cut; plane strain along z
//!       ,--¯--.    y
//!      /  half \   |
//!     +---------+  +-- x
//! ```
//! mm, N, MPa. The closed form of C. Cattaneo (1938) and R. D. Mindlin (1949): the strip that sticks has the half-width
//! c = a √(1 - Q/μP); K. L. Johnson, *Contact Mechanics*, 7.2(d).

use brinell::prelude::*;
use brinell::proof::closed_forms::friction::CattaneoMindlin;
use std::error::Error;

/// Radius, mm, load per length, N/mm, and Coulomb's coefficient.
const RADIUS: f64 = 20.0;
const LOAD: f64 = 2000.0;
const FRICTION: f64 = 0.3;

/// What, by finite elements, in closed form.
type Figures = Result<Vec<(&'static str, f64, f64)>, Box<dyn Error>>;

pub fn figures() -> Figures {
    let steel = Steel::elastic(210e3, 0.3);
    let elastic = Elastic::new(210e3, 0.3)?;
    // Two equal rollers touch as one of half the radius touches a plane.
    let hertz = LineContact::new(LOAD, 0.5 * RADIUS, contact_compliance(elastic, elastic)?)?;
    let push = 0.5 * FRICTION * LOAD;
    let exact = CattaneoMindlin::new(hertz, push, FRICTION)?;
    let a = hertz.half_width;

    let thick = a;
    let half = |name| Cylinder::half(name, RADIUS, thick).fine(a / 12.0, 1.5 * a);
    // The cut of the upper half stays straight under the force P, and follows Q.
    let straight = [
        PlaneMotion::Driven(0.0),
        PlaneMotion::Driven(-LOAD * thick),
        PlaneMotion::Free,
    ];
    let shear = Load::force("upper_top", [push * thick, 0.0, 0.0]).named("push");
    let scene = SceneBuilder::new("two rollers")
        .body(half("upper"), steel)
        .body(half("lower").below(), steel)
        .contact(
            Contact::between("upper_contact", "lower_contact")
                .named("contact")
                .friction(FRICTION),
        )
        .fix("lower_top")
        .load(Load::plane("upper_top", straight).named("press"))
        .load(shear)
        .step_but("press", 1.0, &[("push", 0.0)])
        .step("push", 1.0)
        .plane_strain(Axis::Z)
        .build()?;
    let answer = Solved::of(scene)?;

    let contact = answer.interface("contact").ok_or("no contact")?;
    // Beyond the sticking strip the traction is μp: what is missing of it is half an ellipse of half-width c.
    let field = answer.contact("contact").ok_or("no contact")?;
    let (mut missing, mut second) = (0.0, 0.0);
    for (i, node) in field.nodes.iter().enumerate() {
        let x = answer.scene.mesh.points[*node as usize][0];
        let spare = (FRICTION * field.pressure[i] - field.traction[i][0]) * field.area[i];
        (missing, second) = (missing + spare, second + spare * x * x);
    }
    Ok(vec![
        (
            "largest pressure, MPa",
            contact.max_pressure,
            hertz.peak_pressure,
        ),
        ("Q passed on, N/mm", contact.force[0] / thick, push),
        (
            "half-width that sticks, mm",
            2.0 * (second / missing).sqrt(),
            exact.stick_half_width,
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
