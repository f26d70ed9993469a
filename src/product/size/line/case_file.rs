//! The case file of proposed rollers: TOML that `brinell run` reads.

use super::candidate::LineCandidate;
use super::proposal::LineProposal;
use crate::ground::units::Dimension;
use crate::product::size::case_file::{end, exactly, steel};

/// The case file of `candidate`, called `name`.
pub fn case_file(proposal: &LineProposal, candidate: &LineCandidate, name: &str) -> String {
    let (request, c) = (&proposal.request, candidate);
    let units = request.units;
    let length = |value| exactly(units, value, Dimension::LENGTH);
    let show = |value, dimension| units.show(value, dimension);
    let mut lines = vec![
        format!(
            "# Sized by `brinell size --template line` for {}, steel of {}.",
            show(request.load, Dimension::FORCE),
            show(request.yield_stress, Dimension::STRESS)
        ),
        "#".to_owned(),
        format!("#     brinell run {name}.toml"),
        String::new(),
        format!(
            "title = \"{} on {} of {} x {}\"",
            show(request.load, Dimension::FORCE),
            match c.rollers {
                1 => "a roller".to_owned(),
                n => format!("{n} rollers"),
            },
            show(c.diameter, Dimension::LENGTH),
            show(c.length, Dimension::LENGTH)
        ),
        format!("units = \"{units}\""),
        String::new(),
        "[line_bearing]".to_owned(),
        format!(
            "load = \"{}\"",
            exactly(units, request.load, Dimension::FORCE)
        ),
        format!("friction = {}", request.friction.value),
    ];
    if c.rollers > 1 {
        lines.push(format!("rollers = {}", c.rollers));
        lines.push(format!("spacing = \"{}\"", length(c.spacing)));
    }
    lines.push(format!("roller_diameter = \"{}\"", length(c.diameter)));
    lines.push(match c.wall {
        Some(wall) => format!("roller_wall = \"{}\"", length(wall)),
        None => "solid = true".to_owned(),
    });
    let [wide, long] = c.geometry.upper.plan;
    lines.extend([
        format!(
            "# {} are asked for, for {} times the load.",
            show(c.required_length, Dimension::LENGTH),
            request.margin.value
        ),
        format!("roller_length = \"{}\"", length(c.length)),
        format!("roller_end = {}", end(units, request.end.value)),
        format!("plate_thickness = \"{}\"", length(c.plate)),
        format!("plate_size = [\"{}\", \"{}\"]", length(wide), length(long)),
        String::new(),
        steel(
            units,
            [
                request.modulus.value,
                request.yield_stress,
                request.tangent_modulus.value,
            ],
            request.poissons_ratio.value,
        ),
        "[mesh]".to_owned(),
        format!("preset = \"{}\"", request.preset.value),
    ]);
    lines.join("\n") + "\n"
}
