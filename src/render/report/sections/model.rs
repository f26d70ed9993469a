//! The model: elements and their shapes, supports, loads, contact, symmetry and why.

use crate::ground::geometry::AXES;
use crate::model::scene::{ElementKind, Partner, PlaneMotion, PlaneTurn, Side, TractionValue};
use crate::render::report::Inputs;
use crate::render::report::html::list;
use crate::render::table::html::tables;
use crate::render::table::{Cell, Table};
use crate::render::text::significant;
use maud::{Markup, html};

/// All of it.
pub fn model(inputs: &Inputs) -> Markup {
    html! {
        (list("How it is idealised", &idealised(inputs)))
        (tables(&[mesh(inputs), held(inputs), loaded(inputs), contact(inputs)]))
    }
}

/// What was chosen, and why.
fn idealised(inputs: &Inputs) -> Vec<String> {
    let (scene, summary) = (inputs.scene, inputs.summary);
    let element = match scene.controls.element {
        ElementKind::Bbar => {
            "Hexahedra of eight nodes with one dilatation an element (B-bar): they neither lock in plastic flow nor in contact."
        }
        ElementKind::Enhanced => {
            "Hexahedra of eight nodes with incompatible modes: they bend with one or two through a thickness."
        }
        ElementKind::Full => {
            "Hexahedra of eight nodes, fully integrated: stiffer in bending and in plastic flow than others, to compare with \
             other programs."
        }
    };
    let mut said = vec![
        element.to_owned(),
        "Small displacements and rotations; contact is sought where bodies stand before they are loaded, and a warning \
         tells where a body turns so far that this matters."
            .to_owned(),
    ];
    said.push(match summary.answer.plasticity {
        true => "Steel is elastic up to its yield stress, then plastic by Mises with a straight hardening line.".to_owned(),
        false => "Steel is elastic.".to_owned(),
    });
    said.push(
        "Contact is without adhesion, by mortar integrals on the carrier surface and multipliers that are exact at the end \
         of each increment; friction is Coulomb's."
            .to_owned(),
    );
    let mirrors: Vec<&str> = scene.mirrors.iter().map(|axis| AXES[*axis % 3]).collect();
    said.push(match mirrors.is_empty() {
        true => "No plane of symmetry is named: forces and areas are those of what is modelled, loads per length those of whole strips, \
                 also where supports hold both bodies in a plane that cuts one."
            .to_owned(),
        false => format!(
            "Bodies, supports and loads are mirrored at {} = 0: one side of each plane is modelled, held across it, and \
             forces and areas are told of the whole.",
            mirrors.join(" = 0 and ")
        ),
    });
    said
}

fn mesh(inputs: &Inputs) -> Table {
    let unit = &inputs.summary.units.length;
    let mut table = Table::new("Mesh")
        .words("body")
        .figures(["elements"])
        .figure("shortest edge", unit)
        .figure("longest edge", unit)
        .figures(["least scaled Jacobian", "largest aspect ratio"])
        .about("A scaled Jacobian is 1 of a box, and above 0 of every sound element. Long elements lie along rollers, \
                where little changes.");
    for body in inputs.scene.mesh.quality() {
        let [shortest, longest] = body.edge_lengths;
        table.row([
            (&body.name).into(),
            body.elements.into(),
            Cell::rough(shortest),
            Cell::rough(longest),
            Cell::rough(body.min_scaled_jacobian),
            Cell::rough(body.max_aspect_ratio),
        ]);
    }
    table
}

fn held(inputs: &Inputs) -> Table {
    let unit = &inputs.summary.units.length;
    let mut table = Table::new("Supports")
        .words("surface")
        .words(&format!("displacement, {unit}"))
        .words("as");
    let both = |along: usize, by: f64| format!("{} = {}", AXES[along], significant(by, 4));
    for support in &inputs.scene.supports {
        let held = support.components.iter().enumerate();
        let held = held.filter_map(|(axis, by)| Some(both(axis, (*by)?)));
        let held: Vec<String> = held.collect();
        table.row([
            (&support.surface).into(),
            held.join(", ").into(),
            "every node".into(),
        ]);
    }
    for plane in &inputs.scene.rigid_planes {
        let motion = plane.motion.iter().enumerate();
        let held = motion.filter_map(|(axis, motion)| match motion {
            PlaneMotion::Held(by) => Some(both(axis, *by)),
            _ => None,
        });
        let turned = plane.turn.iter().enumerate();
        let turned = turned.filter_map(|(axis, turn)| match turn {
            PlaneTurn::Held(by) if *by != 0.0 => {
                let by = significant(*by, 4);
                Some(format!("turned about {} by {by} rad", AXES[axis]))
            }
            _ => None,
        });
        let held: Vec<String> = held.chain(turned).collect();
        if !held.is_empty() {
            table.row([
                (&plane.surface).into(),
                held.join(", ").into(),
                "a rigid plane".into(),
            ]);
        }
    }
    table
}

fn loaded(inputs: &Inputs) -> Table {
    let (scene, units) = (inputs.scene, &inputs.summary.units);
    let mut table = Table::new("Loads on the modelled part")
        .words("surface")
        .words("load at factor one")
        .words("as");
    for plane in &scene.rigid_planes {
        for (axis, motion) in plane.motion.iter().enumerate() {
            if let PlaneMotion::Driven(force) = motion {
                let force = significant(*force, 5);
                table.row([
                    (&plane.surface).into(),
                    format!("{force} {} along {}", units.force, AXES[axis]).into(),
                    "a force on a rigid plane".into(),
                ]);
            }
        }
        for (axis, turn) in plane.turn.iter().enumerate() {
            if let PlaneTurn::Driven(moment) = turn {
                let moment = significant(*moment, 5);
                table.row([
                    (&plane.surface).into(),
                    format!(
                        "{moment} {} {} about {}",
                        units.force, units.length, AXES[axis]
                    )
                    .into(),
                    "a moment on a rigid plane that is free to turn".into(),
                ]);
            }
        }
    }
    for traction in &scene.tractions {
        let (value, how) = match traction.value {
            TractionValue::Pressure(p) => (significant(p, 5), "a pressure"),
            TractionValue::Vector(t) => (
                t.map(|t| significant(t, 5)).join(", "),
                "a traction along x, y, z",
            ),
        };
        table.row([
            (&traction.surface).into(),
            format!("{value} {}", units.stress).into(),
            how.into(),
        ]);
    }
    table
}

fn contact(inputs: &Inputs) -> Table {
    let mut table = Table::new("Contact pairs")
        .words("interface")
        .words("upper surface")
        .words("lower surface")
        .words("pressure is carried by")
        .figures(["friction"])
        .words("shape");
    for pair in &inputs.scene.contacts {
        let name = |side: &Partner| match side {
            Partner::Surface(name) => name.clone(),
            Partner::Plane { .. } => "a rigid plane".to_owned(),
        };
        let carrier = match pair.carrier {
            Side::Upper => "the upper one",
            Side::Lower => "the lower one",
        };
        let shape = match pair.true_geometry {
            true => "true, where it is known",
            false => "of the facets",
        };
        table.row([
            (&pair.name).into(),
            name(&pair.upper).into(),
            name(&pair.lower).into(),
            carrier.into(),
            Cell::rough(pair.friction),
            shape.into(),
        ]);
    }
    table
}
