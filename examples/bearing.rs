//! A bearing from numbers: the stack of two crossed rollers and three plates, as a case file describes it.
//!
//! ```text
//!        | | | | | |  65 kip
//!      =================  upper plate
//!            ( o )        upper roller along y, 3 in, hollow
//!      ------.   .------  intermediate plate, V valleys of 4 degrees
//!      ------'   '------
//!            ( o )        lower roller along x
//!      =================  lower plate, fixed below
//! ```
//! in, kip, ksi. Statics: every interface passes all of the load on, and in a V each of the two lines bears
//! w/(2 cos θ) per length, without friction; friction changes that by 1 %. Hertz for the load per length spread evenly:
//! K. L. Johnson, *Contact Mechanics*, 4.45. The roller bends and bears more in the middle, so that the pressure is 6 to 7 %
//! higher there.
//!
//! A mesh of these numbers ships with Brinell. For any other ones gmsh is called.

use brinell::analytic::vgroove::VGroove;
use brinell::answer::results::contact_lines::contact_lines;
use brinell::answer::results::interface::interfaces;
use brinell::answer::results::line_frame::LineFrame;
use brinell::case;
use brinell::prelude::*;
use brinell::product::job::{self, Options};
use std::error::Error;

const CASE: &str = r#"
title = "a bearing"
units = "in-kip-ksi"
[bearing]
load = "65 kip"
friction = 0.15
roller_diameter = "3 in"
roller_wall = "0.75 in"
roller_length = "8 in"
offset = "0 in"
slope = "4 deg"
plate_thickness = "1 in"
[steel]
youngs_modulus = "29500 ksi"
poissons_ratio = 0.3
elastic = true
[mesh]
preset = "h025"
"#;
/// Meshes are sought by the name of the case.
const NAME: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/cases/section-2.6.2/initial-centre.toml"
);

/// What, by finite elements, in closed form.
type Figures = Result<Vec<(&'static str, f64, f64)>, Box<dyn Error>>;

pub fn figures() -> Figures {
    let bearing = case::parse(NAME, CASE)?;
    let outcome = job::run(&bearing, &Options::default(), &mut Silent)?;
    let (scene, state) = (&outcome.scene, outcome.state());

    let (load, length, radius) = (65.0, 8.0, 1.5);
    let elastic = Elastic::new(29_500.0, 0.3)?;
    let compliance = contact_compliance(elastic, elastic)?;
    let hertz = LineContact::new(load / length, radius, compliance)?;
    let valley = VGroove::new(load / length, radius, 4f64.to_radians(), compliance)?;

    let all = interfaces(scene, state);
    let named = |name: &str| {
        all.iter()
            .position(|i| i.name == name)
            .ok_or("no such interface")
    };
    let (flat, groove) = (
        named("upper_plate-upper_roller")?,
        named("upper_roller-intermediate_plate")?,
    );
    // The upper roller, and its lines, run along y.
    let line = |pair| {
        let frame = LineFrame::of_axis(scene, 1).ok_or("the load acts along y")?;
        let lines = contact_lines(scene, state, pair, &frame);
        lines.into_iter().next().ok_or("no line")
    };
    let heaviest = line(flat)?.peak().ok_or("no load")?.0;
    let found = LineContact::new(heaviest, radius, compliance)?;
    Ok(vec![
        (
            "force on the upper roller, kip",
            all[flat].normal_force,
            load,
        ),
        (
            "force on the middle plate, kip",
            all[groove].normal_force,
            load,
        ),
        (
            "load of a line in the V, kip/in",
            line(groove)?.mean(),
            valley.normal_load(),
        ),
        (
            "Hertz pressure, upper plate, ksi",
            found.peak_pressure,
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
