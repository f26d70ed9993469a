//! `[[rigid_plane]]`: how a surface moves and turns as one.

use super::axes::{by_axis, displacements, letters, modelled_share};
use super::error::{CaseError, ErrorKind};
use super::parse::Table;
use super::place::KeyPlace;
use crate::ground::geometry::AXES;
use crate::ground::units::Dimension;
use crate::model::scene::{PlaneMotion, PlaneTurn, RigidPlane};

/// Reads everything but name and surface. Forces and moments are given for the whole and come out for the part of it
/// that is modelled beside the symmetry planes across `mirrors`.
pub(super) fn read(table: &Table, mirrors: &[usize]) -> Result<RigidPlane, CaseError> {
    let motion = motion(table, mirrors)?;
    let about = table.maybe("about", |field| field.vector(Dimension::LENGTH));
    Ok(RigidPlane {
        turn: turn(table, mirrors, &motion)?,
        about: about?.map(|about| about.value),
        motion,
        ..RigidPlane::default()
    })
}

fn motion(table: &Table, mirrors: &[usize]) -> Result<[PlaneMotion; 3], CaseError> {
    let held = displacements(table)?;
    let mut motion = held.map(|d| d.map_or(PlaneMotion::Free, PlaneMotion::Held));
    for (axis, force) in by_axis(table, "force", Dimension::FORCE)? {
        if held[axis].is_some() {
            let why = format!("{} is already fixed or displaced", AXES[axis]);
            return Err(force.place.error(ErrorKind::Conflict, why));
        }
        if mirrors.contains(&axis) {
            let why = format!(
                "a force along {0} breaks the symmetry about {0} = 0",
                AXES[axis]
            );
            return Err(force.place.error(ErrorKind::Conflict, why));
        }
        motion[axis] = PlaneMotion::Driven(force.value * modelled_share(mirrors));
    }
    Ok(motion)
}

fn turn(
    table: &Table,
    mirrors: &[usize],
    motion: &[PlaneMotion; 3],
) -> Result<[PlaneTurn; 3], CaseError> {
    let mut turn = [PlaneTurn::default(); 3];
    let possible = |axis: usize, place: &KeyPlace| {
        if let Some(mirror) = mirrors.iter().find(|mirror| **mirror != axis) {
            let (axis, mirror) = (AXES[axis], AXES[*mirror]);
            let why = format!("a turn about {axis} breaks the symmetry about {mirror} = 0");
            let help = format!("drop \"{mirror}\" from `symmetry`, and mesh the other half too");
            return Err(place.error(ErrorKind::Conflict, why).help(help));
        }
        let moves = |across: usize| across != axis && motion[across] != PlaneMotion::Free;
        if !(0..3).any(moves) {
            let why = format!(
                "a turn about {} moves nothing: every node is free along both other axes",
                AXES[axis]
            );
            let help = "hold, displace or drive the plane across the axis that it turns about";
            return Err(place.error(ErrorKind::Conflict, why).help(help));
        }
        Ok(())
    };
    let free = letters(table, "turns")?;
    if let Some(field) = table.get("turns") {
        for axis in &free {
            possible(*axis, &field.place())?;
            turn[*axis] = PlaneTurn::Driven(0.0);
        }
    }
    for (axis, angle) in by_axis(table, "rotation", Dimension::ANGLE)? {
        possible(axis, &angle.place)?;
        if free.contains(&axis) {
            let why = format!("it is free to turn about {}, as `turns` says", AXES[axis]);
            return Err(angle.place.error(ErrorKind::Conflict, why));
        }
        if angle.value.abs() > LARGEST_ANGLE {
            let why = format!(
                "is {:.3} rad; what turns move is taken as linear in the angle, up to {LARGEST_ANGLE} rad",
                angle.value
            );
            return Err(angle.place.error(ErrorKind::Value, why));
        }
        turn[axis] = PlaneTurn::Held(angle.value);
    }
    for (axis, moment) in by_axis(table, "moment", Dimension::MOMENT)? {
        if !free.contains(&axis) {
            let why = format!(
                "the plane does not turn about {} under a moment",
                AXES[axis]
            );
            let help = format!("name the axis in `turns`, as in turns = \"{}\"", AXES[axis]);
            return Err(moment.place.error(ErrorKind::Conflict, why).help(help));
        }
        turn[axis] = PlaneTurn::Driven(moment.value * modelled_share(mirrors));
    }
    Ok(turn)
}

/// Angles beyond it are refused, in radians: the displacements of a turn are then wrong by 0.5 % of
/// themselves, and contact is not where it was integrated.
pub(super) const LARGEST_ANGLE: f64 = 0.1;
