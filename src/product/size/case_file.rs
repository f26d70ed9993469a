//! The case files of a proposed bearing: TOML that `brinell run` reads, with where each number is
//! from.

use super::candidate::Candidate;
use super::proposal::Proposal;
use crate::case::bearing::RollerEnd;
use crate::ground::units::{Dimension, UnitSystem};
use crate::render::text::significant;
use std::fmt::Write;

/// Where the rollers stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Position {
    /// s = 0.
    Centre,
    /// s = D_r.
    Displaced,
}

impl Position {
    /// Those that a bearing has to be verified at: one that does not move has only one.
    pub fn of(capacity: f64) -> &'static [Self] {
        if capacity > 0.0 {
            &[Self::Centre, Self::Displaced]
        } else {
            &[Self::Centre]
        }
    }

    /// Name of its case file, without the ending, and of its results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Centre => "centre",
            Self::Displaced => "displaced",
        }
    }
}

/// The case file of `candidate` at `position`.
pub fn case_file(proposal: &Proposal, candidate: &Candidate, position: Position) -> String {
    let request = &proposal.request;
    let units = request.units;
    let length = |value| exactly(units, value, Dimension::LENGTH);
    let shown = |value| units.show(value, Dimension::LENGTH);
    let offset = match position {
        Position::Centre => 0.0,
        Position::Displaced => request.roller_displacement(),
    };
    let c = candidate;
    let lines = [
        "[bearing]".to_string(),
        format!("load = \"{}\"", exactly(units, request.load, Dimension::FORCE)),
        "# Coulomb's coefficient, of all four interfaces.".to_string(),
        format!("friction = {}", request.friction.value),
        format!("roller_diameter = \"{}\"", length(c.diameter)),
        format!("# {} of the diameter.", significant(c.wall / c.diameter, 3)),
        format!("roller_wall = \"{}\"", length(c.wall)),
        "# L'. Equations (2-50) and (2-51) ask for".to_string(),
        format!(
            "# {} (constant 8) or {} (exact constant, 7.783),",
            shown(c.printed.final_length),
            shown(c.exact.final_length)
        ),
        format!(
            "# statics of the displaced roller, with its margin, for {}.",
            shown(c.eccentric_length)
        ),
        format!("roller_length = \"{}\"", length(c.length)),
        format!("roller_end = {}", end(units, request.end.value)),
        "# s, of the roller axes from the centre of the intermediate plate; the bearing moves by twice \
         as much."
            .to_string(),
        format!("offset = \"{}\"", length(offset)),
        format!("slope = \"{}\"", exactly(units, request.slope.value, Dimension::ANGLE)),
        "# Of the intermediate plate: where its valleys cross.".to_string(),
        format!("plate_thickness = \"{}\"", length(c.plate)),
        format!("plate_size = \"{}\"  # as long and wide as a roller", length(c.length)),
        String::new(),
        steel(
            units,
            [request.modulus.value, request.yield_stress, request.tangent_modulus.value],
            request.poissons_ratio.value,
        ),
        "[mesh]".to_string(),
        "# auto, report-like, h025 or h0125.".to_string(),
        format!("preset = \"{}\"", request.preset.value),
    ];
    head(proposal, candidate, position) + &lines.join("\n") + "\n"
}

fn head(proposal: &Proposal, candidate: &Candidate, position: Position) -> String {
    let request = &proposal.request;
    let units = request.units;
    let show = |value, dimension| units.show(value, dimension);
    let length = |value| show(value, Dimension::LENGTH);
    let load = show(request.load, Dimension::FORCE);
    let file = format!("{}.toml", position.name());
    let place = match position {
        Position::Centre => "rollers at the centre".to_string(),
        Position::Displaced => format!("rollers {} off", length(request.roller_displacement())),
    };
    let mut text = format!(
        "# Sized by `brinell size` for {load}, steel of {}, displacement of {}.\n\
         #\n\
         #     brinell run {file}\n\
         #\n",
        show(request.yield_stress, Dimension::STRESS),
        length(request.capacity),
    );
    let picture = [
        (
            "  | | | | | |",
            format!("{load}, moves down without turning"),
        ),
        (
            "=================",
            format!("upper plate, {}", length(candidate.plate)),
        ),
        (
            "      ( o )",
            format!(
                "upper roller along y, {}, wall {}",
                length(candidate.diameter),
                length(candidate.wall)
            ),
        ),
        (
            "------.   .------",
            format!(
                "intermediate plate, V valleys of {},",
                show(request.slope.value, Dimension::ANGLE)
            ),
        ),
        (
            "------'   '------",
            format!("{} where they cross", length(candidate.plate)),
        ),
        (
            "      ( o )",
            "lower roller along x (drawn turned by 90 deg)".to_string(),
        ),
        (
            "=================",
            format!("lower plate, {}, fixed below", length(candidate.plate)),
        ),
    ];
    for (part, words) in picture {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "#      {part:<17}  {words}");
    }
    let _ = write!(
        text,
        "\ntitle = \"{load} on rollers of {} x {}, {place}\"\nunits = \"{units}\"\n\n",
        length(candidate.diameter),
        length(candidate.length),
    );
    text
}

/// The table `[steel]`, of Young's modulus, yield stress and tangent modulus, and an empty line.
pub(super) fn steel(units: UnitSystem, stresses: [f64; 3], poissons_ratio: f64) -> String {
    let [modulus, strength, tangent] =
        stresses.map(|value| exactly(units, value, Dimension::STRESS));
    format!(
        "[steel]\nyoungs_modulus = \"{modulus}\"\npoissons_ratio = {poissons_ratio}\nyield_stress = \"{strength}\"\n\
         # Slope of the stress-strain line beyond yield.\ntangent_modulus = \"{tangent}\"\n"
    )
}

pub(super) fn end(units: UnitSystem, end: RollerEnd) -> String {
    let length = |value| exactly(units, value, Dimension::LENGTH);
    match end {
        RollerEnd::Square => "\"square\"".to_string(),
        RollerEnd::Radius(radius) => format!("{{ radius = \"{}\" }}", length(radius)),
        RollerEnd::CrownedRadius { radius, crown } => format!(
            "{{ radius = \"{}\", crown = \"{}\" }}",
            length(radius),
            length(crown)
        ),
        RollerEnd::Crown(drop) => format!("{{ crown = \"{}\" }}", length(drop)),
    }
}

/// `value` in as few digits as read back to the very same number.
pub(super) fn exactly(units: UnitSystem, value: f64, dimension: Dimension) -> String {
    let reads_back = |text: &String| super::request::quantity(text, units, dimension) == Ok(value);
    let unit = units.unit(dimension);
    let shown = units.shown(value, dimension);
    // Fifteen digits and fewer undo what converting did to the last ones.
    let rounded = (5..16).filter_map(|digits| format!("{shown:.digits$e}").parse::<f64>().ok());
    rounded
        .map(|number| format!("{number} {unit}"))
        .find(reads_back)
        .unwrap_or_else(|| units.write(value, dimension))
}
