//! A mesh of your own, made by gmsh: a hollow roller squeezed between two plates.
//!
//! ```text
//!        | | |
//!      +-------+  upper       half of the stack, x >= 0, is in the file, 1 mm thick along y;
//!      +-------+              roller: R = 80 mm, bore 40 mm
//!        ,---.
//!       ( ( )   roller        physical volumes:   roller, upper, lower
//!        `---´                physical surfaces:  roller_top, roller_bottom, upper_face, ...
//!      +-------+
//!      +-------+  lower       z up
//! ```
//! mm, N, MPa. In the file the bodies stand 0.05 mm apart: gaps between bodies are closed before they are loaded.
//! Hertz, K. L. Johnson, *Contact Mechanics*, 4.42 to 4.45: at both lines, whatever the roller's bore does.

use brinell::prelude::*;
use std::error::Error;

/// Load on the whole, N; outer radius and thickness of the slice, mm.
const LOAD: f64 = 1000.0;
const RADIUS: f64 = 80.0;
const THICK: f64 = 1.0;
/// Text or binary, packed or not.
const FILE: &str = "tests/fixtures/roller-between-plates.msh.gz";

/// What, by finite elements, in closed form.
type Figures = Result<Vec<(&'static str, f64, f64)>, Box<dyn Error>>;

pub fn figures() -> Figures {
    let elastic = Elastic::new(210e3, 0.3)?;
    let compliance = contact_compliance(elastic, elastic)?;
    let hertz = LineContact::new(LOAD / THICK, RADIUS, compliance)?;

    let straight_down = [
        PlaneMotion::Held(0.0),
        PlaneMotion::Held(0.0),
        // The modelled half bears half of the load.
        PlaneMotion::Driven(-0.5 * LOAD),
    ];
    let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(FILE);
    let scene = SceneBuilder::new("roller between plates")
        .body(MeshFile::at(file), Steel::elastic(210e3, 0.3))
        .contact(
            Contact::between("upper_face", "roller_top")
                .named("above")
                .friction(0.15),
        )
        .contact(
            Contact::between("roller_bottom", "lower_face")
                .named("below")
                .friction(0.15),
        )
        .fix("lower_bottom")
        .load(Load::plane("upper_top", straight_down))
        .mirror(Axis::X)
        .hold("symy", Axis::Y)
        .hold("endy", Axis::Y)
        .build()?;
    let answer = Solved::of(scene)?;

    // Across the strip the mesh has few nodes: Hertz's pressure under the line load that was found is known better than
    // the largest at a node.
    let read = |what, place| {
        let claim = answer.figure(what, place).ok_or("no contact");
        claim.map(|claim| claim.value)
    };
    Ok(vec![
        (
            "pressure above, MPa",
            read(Quantity::PeakPressure, "above")?,
            hertz.peak_pressure,
        ),
        (
            "pressure below, MPa",
            read(Quantity::PeakPressure, "below")?,
            hertz.peak_pressure,
        ),
        (
            "by the line load, MPa",
            read(Quantity::HertzPressure, "below")?,
            hertz.peak_pressure,
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
