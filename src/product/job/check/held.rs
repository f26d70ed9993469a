//! What holds a body, and what does not, in words.

use crate::ground::geometry::AXES;
use crate::model::scene::{Partner, PlaneMotion, PlaneTurn, Scene};
use crate::solver::solve::FreeMotion;

/// Supports, rigid planes and contacts on body number `body`.
pub fn held_by(scene: &Scene, body: usize) -> Vec<String> {
    let on = |surface: &str| {
        let surface = scene.mesh.surface(surface).into_iter();
        let mut bodies = surface.flat_map(|surface| surface.bodies(&scene.mesh));
        bodies.any(|other| other == body)
    };
    let axes = |which: &dyn Fn(usize) -> bool| -> String {
        let axes: Vec<&str> = (0..3).filter(|a| which(*a)).map(|a| AXES[a]).collect();
        axes.join(", ")
    };
    let mut list = Vec::new();
    for support in scene.supports.iter().filter(|s| on(&s.surface)) {
        let held = axes(&|axis| support.components[axis].is_some());
        list.push(format!("support {} ({held})", support.name));
    }
    for plane in scene.rigid_planes.iter().filter(|p| on(&p.surface)) {
        let held = axes(&|axis| matches!(plane.motion[axis], PlaneMotion::Held(_)));
        let driven = axes(&|axis| matches!(plane.motion[axis], PlaneMotion::Driven(_)));
        let turns = axes(&|axis| matches!(plane.turn[axis], PlaneTurn::Driven(_)));
        let turned =
            axes(&|axis| matches!(plane.turn[axis], PlaneTurn::Held(angle) if angle != 0.0));
        let words = [
            ("holds", held),
            ("drives", driven),
            ("turns it about", turned),
            ("lets it turn about", turns),
        ];
        let words = words.iter().filter(|(_, axes)| !axes.is_empty());
        let words: Vec<String> = words.map(|(word, axes)| format!("{word} {axes}")).collect();
        list.push(format!("rigid plane {} ({})", plane.name, words.join(", ")));
    }
    for pair in &scene.contacts {
        let takes_part = |partner: &Partner| match partner {
            Partner::Surface(surface) => on(surface),
            Partner::Plane { .. } => false,
        };
        if takes_part(&pair.upper) || takes_part(&pair.lower) {
            let rubs = if pair.friction > 0.0 {
                ""
            } else {
                ", frictionless"
            };
            list.push(format!("contact {}{rubs}", pair.name));
        }
    }
    list
}

/// A motion that nothing resists.
pub fn free_in_words(free: &FreeMotion) -> String {
    // What is less than this share of the motion is rounding, or the facets of a round surface.
    const PART: f64 = 0.05;
    let part = |what: &str, vector: [f64; 3]| {
        let largest = vector.iter().fold(0.0f64, |most, c| most.max(c.abs()));
        let axes = (0..3).filter(|a| largest > PART && vector[*a].abs() > PART);
        let axes: Vec<&str> = axes.map(|a| AXES[a]).collect();
        (!axes.is_empty()).then(|| format!("{what} {}", axes.join(" and ")))
    };
    let moves = part("move along", free.translation);
    let turns = part("turn about", free.turn);
    let motion: Vec<String> = moves.into_iter().chain(turns).collect();
    let (body, motion) = (&free.body, motion.join(" and "));
    match (free.closes, free.driven) {
        (true, _) => format!(
            "{body} is free to {motion} at first touch: contact that closes under the load has to hold it"
        ),
        (false, true) => format!(
            "{body} is free to {motion}: no support and no contact resists the load there; support \
             it, or give the contact friction"
        ),
        (false, false) => format!(
            "{body} is free to {motion}: nothing resists that, and the load does not ask for it; a \
             support says where it stays"
        ),
    }
}
