//! What a scene is asked before it is one.

use super::axis::Axis;
use super::error::BuildError;
use super::load::{Load, LoadKind};
use crate::model::material::Steel;
use crate::model::mesh::Mesh;
use crate::model::scene::{
    Controls, OFF_PLANE, Step, Support, Temperature, Tie, faces_in_plane, reaches_into_plane,
};
use std::collections::{BTreeMap, BTreeSet};

/// The steel of every body, in the order of the mesh; of several for one body the last.
pub(super) fn check_steels(
    mesh: &Mesh,
    steels: &[(String, Steel)],
) -> Result<Vec<Steel>, BuildError> {
    for (body, steel) in steels {
        if mesh.body(body).is_none() {
            let user = format!("the steel of `{body}`");
            return Err(unknown(
                &user,
                "body",
                body,
                mesh.bodies.iter().map(|b| &b.name),
            ));
        }
        let (e, nu) = (steel.youngs_modulus, steel.poissons_ratio);
        let (y, h) = (steel.yield_stress, steel.hardening_modulus);
        let numbers = [
            ("Young's modulus", e, e > 0.0 && e.is_finite(), "positive"),
            (
                "Poisson's ratio",
                nu,
                nu > -1.0 && nu < 0.5,
                "above -1 and below 0.5",
            ),
            ("the yield stress", y, y > 0.0, "positive, or infinite"),
            (
                "the hardening modulus",
                h,
                h >= 0.0 && h.is_finite(),
                "zero or positive",
            ),
        ];
        if let Some((what, value, _, allowed)) = numbers.into_iter().find(|number| !number.2) {
            return Err(BuildError::Number {
                what,
                of: body.clone(),
                value,
                allowed,
            });
        }
    }
    let of = |name: &String| {
        let last = steels.iter().rev().find(|(body, _)| body == name);
        last.map(|(_, steel)| *steel)
            .ok_or_else(|| BuildError::NoSteel { body: name.clone() })
    };
    mesh.bodies.iter().map(|body| of(&body.name)).collect()
}

/// Is there a surface called `name`, and has it faces?
pub(super) fn check_surface(mesh: &Mesh, user: &str, name: &str) -> Result<(), BuildError> {
    match mesh.surface(name) {
        Some(surface) if surface.faces.is_empty() => Err(BuildError::NoFaces { name: name.into() }),
        Some(_) => Ok(()),
        None => {
            let names = mesh.surfaces.iter().map(|s| &s.name);
            Err(unknown(user, "surface", name, names))
        }
    }
}

/// Has everything of a kind a name of its own?
pub(super) fn check_names<'n>(
    kind: &'static str,
    names: impl Iterator<Item = &'n String>,
) -> Result<(), BuildError> {
    let mut seen = BTreeSet::new();
    for name in names {
        if !seen.insert(name) {
            let name = name.clone();
            return Err(BuildError::Twice { kind, name });
        }
    }
    Ok(())
}

/// Does each of these, by its name, join two surfaces that no other one does?
pub(super) fn check_sides<'n>(
    all: impl Iterator<Item = (&'n String, [&'n String; 2])>,
) -> Result<(), BuildError> {
    let mut seen = BTreeMap::new();
    for (name, mut sides) in all {
        sides.sort();
        let surfaces = sides.map(String::clone);
        if sides[0] == sides[1] {
            let [surface, _] = surfaces;
            let name = name.clone();
            return Err(BuildError::WithItself { name, surface });
        }
        if let Some(other) = seen.insert(sides, name) {
            return Err(BuildError::SameSides {
                name: name.clone(),
                other: other.clone(),
                surfaces,
            });
        }
    }
    Ok(())
}

pub(super) fn check_supports(mesh: &Mesh, supports: &[Support]) -> Result<(), BuildError> {
    for support in supports {
        check_surface(mesh, "a support", &support.surface)?;
        let gradient = support.gradient.iter().flatten();
        let mut numbers = support.components.iter().flatten().chain(gradient);
        if let Some(value) = numbers.find(|x| !x.is_finite()) {
            return Err(BuildError::Number {
                what: "a displacement",
                of: support.name.clone(),
                value: *value,
                allowed: "finite",
            });
        }
    }
    Ok(())
}

/// As of a case file.
pub(super) fn check_controls(controls: &Controls, scene: &str) -> Result<(), BuildError> {
    let shares = [
        ("residual", controls.residual),
        ("penetration", controls.penetration),
        ("first_increment", controls.first_increment),
        ("smallest_increment", controls.smallest_increment),
    ];
    let wrong = |what, value, allowed| BuildError::Number {
        what,
        of: scene.to_owned(),
        value,
        allowed,
    };
    if let Some((what, value)) = shares.into_iter().find(|(_, x)| !Controls::is_share(*x)) {
        return Err(wrong(what, value, Controls::SHARE));
    }
    let reach = controls.contact_reach;
    if !(reach > 0.0 && reach.is_finite()) {
        return Err(wrong("contact_reach", reach, "positive"));
    }
    match controls.iterations {
        0 => Err(wrong("iterations", 0.0, "1 or more")),
        _ => Ok(()),
    }
}

pub(super) fn check_loads(mesh: &Mesh, loads: &[Load]) -> Result<(), BuildError> {
    for load in loads {
        check_surface(mesh, &format!("the load `{}`", load.name), &load.surface)?;
        if let Some(value) = load.numbers().into_iter().find(|x| !x.is_finite()) {
            return Err(BuildError::Number {
                what: "a component",
                of: load.name.clone(),
                value,
                allowed: "finite",
            });
        }
    }
    Ok(())
}

/// Nothing presses what lies in the plane of symmetry across `axis`.
pub(super) fn check_loads_in_mirror(
    mesh: &Mesh,
    loads: &[Load],
    axis: Axis,
) -> Result<(), BuildError> {
    let presses = |load: &&Load| !matches!(load.kind, LoadKind::Plane(_));
    let reaches = |load: &&Load| reaches_into_plane(mesh, &load.surface, axis.index());
    match loads.iter().filter(presses).find(reaches) {
        None => Ok(()),
        Some(load) => Err(BuildError::LoadInMirror {
            load: load.name.clone(),
            surface: load.surface.clone(),
            axis: axis.letter(),
        }),
    }
}

pub(super) fn check_ties(mesh: &Mesh, ties: &[Tie]) -> Result<(), BuildError> {
    check_names("tie", ties.iter().map(|tie| &tie.name))?;
    check_sides(ties.iter().map(|tie| (&tie.name, tie.surfaces.each_ref())))?;
    for tie in ties {
        for surface in &tie.surfaces {
            check_surface(mesh, &format!("the tie `{}`", tie.name), surface)?;
        }
        if let Some(value) = tie.tolerance.filter(|t| !(*t > 0.0 && t.is_finite())) {
            return Err(BuildError::Number {
                what: "the tolerance",
                of: tie.name.clone(),
                value,
                allowed: "positive",
            });
        }
    }
    Ok(())
}

/// Differences of temperature of bodies that the mesh has, none across a plane of symmetry.
pub(super) fn check_temperatures(
    mesh: &Mesh,
    temperatures: &[Temperature],
    mirrors: &[Axis],
) -> Result<(), BuildError> {
    for temperature in temperatures {
        let Temperature { name, body, .. } = temperature;
        if mesh.body(body).is_none() {
            let user = format!("the temperature `{name}`");
            let known = mesh.bodies.iter().map(|body| &body.name);
            return Err(unknown(&user, "body", body, known));
        }
        let wrong = |what, value, allowed| BuildError::Number {
            what,
            of: name.clone(),
            value,
            allowed,
        };
        let numbers = [temperature.expansion, temperature.value];
        let mut numbers = numbers.into_iter().chain(temperature.gradient);
        if let Some(value) = numbers.find(|x| !x.is_finite()) {
            return Err(wrong("a number", value, "finite"));
        }
        let across = mirrors
            .iter()
            .map(|axis| temperature.gradient[axis.index()]);
        if let Some(value) = across.into_iter().find(|along| *along != 0.0) {
            let allowed = "zero along an axis that the scene is mirrored along";
            return Err(wrong("the gradient", value, allowed));
        }
    }
    Ok(())
}

/// Steps call loads and temperatures, by their names, and supports.
pub(super) fn check_steps(
    steps: &[Step],
    loads: &[&String],
    supports: &[Support],
) -> Result<(), BuildError> {
    let names = || {
        let supports = supports.iter().map(|support| &support.name);
        loads.iter().copied().chain(supports)
    };
    check_names("load", loads.iter().copied())?;
    check_names("step", steps.iter().map(|step| &step.name))?;
    for step in steps {
        check_names("factor", step.factors.iter().map(|(name, _)| name))?;
        let is_load = |name: &String| loads.contains(&name);
        let moves = |name: &String| supports.iter().any(|s| s.name == *name && s.moves());
        let both = step
            .factors
            .iter()
            .find(|(name, _)| is_load(name) && moves(name));
        if let Some((name, _)) = both {
            let (kind, name) = ("loads or prescribed motion", name.clone());
            return Err(BuildError::Twice { kind, name });
        }
        let user = format!("the step `{}`", step.name);
        for (name, _) in &step.factors {
            if !names().any(|known| known == name) {
                return Err(unknown(&user, "load", name, names()));
            }
        }
        let mut factors = step
            .factors
            .iter()
            .map(|(_, factor)| *factor)
            .chain([step.factor]);
        if let Some(value) = factors.find(|f| !f.is_finite()) {
            return Err(BuildError::Number {
                what: "a factor",
                of: step.name.clone(),
                value,
                allowed: "finite",
            });
        }
    }
    Ok(())
}

fn unknown<'n>(
    user: &str,
    kind: &'static str,
    name: &str,
    known: impl Iterator<Item = &'n String>,
) -> BuildError {
    let known: Vec<&str> = known.map(String::as_str).collect();
    BuildError::Unknown {
        user: user.into(),
        kind,
        name: name.into(),
        known: known.join(", "),
    }
}

/// Refuses a model that lies on the negative side of the plane of symmetry across `axis` too, or has no face in it: it is
/// not the half that is asked for.
pub(super) fn check_mirror(mesh: &Mesh, axis: Axis, scene: &str) -> Result<(), BuildError> {
    let [low, high] = mesh.range_along(axis.index());
    let near = OFF_PLANE * (high - low);
    let faces = faces_in_plane(mesh, axis.index()).len();
    match faces > 0 && low >= -near {
        true => Ok(()),
        false => Err(BuildError::Mirror {
            scene: scene.into(),
            axis: axis.letter(),
            low,
            high,
            faces,
        }),
    }
}
