//! A thick tube is pressurised until it yields half through, and unloaded: its bore stays wider.
//!
//! ```text
//!     y
//!     |_____
//!     |     `-.        a quarter of the tube, a = 100 mm, b = 200 mm,
//!     |___     \       mirrored along x and y; plane strain along z
//!     p   `.    \
//!      ->   |    |
//!           +----+-- x
//! ```
//! mm, kN, GPa. The closed form: R. Hill, *The Mathematical Theory of Plasticity*, 1950, chapter V, with linear
//! hardening; it takes the steel as incompressible, so ν = 0.4999 here. Unloading is elastic.

use brinell::prelude::*;
use brinell::proof::closed_forms::steel::BilinearSteel;
use brinell::proof::closed_forms::tube::Tube;
use std::error::Error;
use std::f64::consts::FRAC_PI_2;

/// Inner and outer radius, and the radius up to which the tube yields, mm.
const INNER: f64 = 100.0;
const OUTER: f64 = 200.0;
const FRONT: f64 = 150.0;
const POISSON: f64 = 0.4999;

/// What, by finite elements, in closed form.
type Figures = Result<Vec<(&'static str, f64, f64)>, Box<dyn Error>>;

pub fn figures() -> Figures {
    let curve = BilinearSteel::new(210.0, 0.24, 5.0)?;
    let tube = Tube::new(INNER, OUTER, curve)?;
    let pressure = tube.pressure_at_front(FRONT)?;

    let quarter = Block::new(
        "tube",
        uniform(INNER, OUTER, 20),
        uniform(0.0, FRAC_PI_2, 20),
        uniform(0.0, 10.0, 1),
    );
    let steel = Steel {
        youngs_modulus: curve.youngs_modulus(),
        poissons_ratio: POISSON,
        yield_stress: curve.yield_stress(),
        hardening_modulus: curve.hardening_modulus(),
    };
    let scene = SceneBuilder::new("tube")
        .body(quarter.mapped(cylindrical).face("x_min", "bore"), steel)
        .load(Load::pressure("tube_bore", pressure))
        .step("load", 1.0)
        .step("unload", 0.0)
        .mirror(Axis::X)
        .mirror(Axis::Y)
        .plane_strain(Axis::Z)
        .build()?;
    let answer = Solved::of(scene)?;

    // The node of the bore on the x axis.
    let mesh = &answer.scene.mesh;
    let on_axis = |p: &[f64; 3]| (p[0] - INNER).abs() + p[1].abs() < 1e-9 * INNER;
    let node = mesh.points.iter().position(on_axis).ok_or("no such node")?;
    let moved = |step| {
        answer
            .at_end_of(step)
            .map_or(0.0, |state| state.displacement[node][0])
    };
    let loaded = tube.displacement_incompressible(FRONT, INNER)?;
    let back = tube.elastic_displacement(pressure, POISSON, INNER)?;
    Ok(vec![
        ("bore under pressure, moved by, mm", moved(0), loaded),
        ("bore unloaded, moved by, mm", moved(1), loaded - back),
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
