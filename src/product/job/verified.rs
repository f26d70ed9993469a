//! The families of claims that cover what a run used, as the verification last measured them.

use crate::case::Case;
use crate::model::mesh::shape::{Shape, fit};
use crate::model::scene::{Partner, Scene};
use crate::render::report::calculation::VerifiedBy;

/// The page that `brinell verify --all --write` writes.
const PAGE: &str = include_str!("../../../docs/verification.md");

/// Claims of a family on the page, and how many of them are outside of their tolerance.
fn claims(family: &str) -> (usize, usize) {
    let rows = PAGE.lines().filter_map(|line| {
        let mut cells = line.split('|').skip(1).map(str::trim);
        let verdict = cells.next()?;
        (cells.next()? == family && verdict != "shown").then_some(verdict)
    });
    rows.fold((0, 0), |(all, outside), verdict| {
        (all + 1, outside + usize::from(verdict != "ok"))
    })
}

/// The families that are about what `scene` uses.
pub fn verified(case: &Case, scene: &Scene) -> Vec<VerifiedBy> {
    let yields = scene.may_yield();
    let friction = scene.rubs();
    let is_round = |side: &Partner, sphere: bool| {
        let surface = side.surface(&scene.mesh);
        surface.is_some_and(|surface| match fit(&scene.mesh, surface) {
            Shape::Cylinder { .. } => !sphere,
            Shape::Sphere { .. } => sphere,
            _ => false,
        })
    };
    let any_round = |sphere: bool| {
        let mut pairs = scene.contacts.iter();
        pairs.any(|pair| is_round(&pair.upper, sphere) || is_round(&pair.lower, sphere))
    };
    let bearing = case.bearing();
    let lines = bearing.is_some() || any_round(false);
    let hollow = bearing.is_some_and(|bearing| bearing.geometry.wall().is_some());
    let ends = bearing.is_some();
    let dents = bearing.is_some_and(|bearing| bearing.unload_to.is_some());
    let families = [
        (
            true,
            "elements and contact between meshes that do not match",
            "patch",
        ),
        (true, "bending of elements", "bending"),
        (
            lines,
            "lines of contact: pressure, width, stress below",
            "hertz-line",
        ),
        (any_round(true), "contact of spheres", "hertz-sphere"),
        (bearing.is_some(), "a roller on two slopes", "v-groove"),
        (hollow, "hollow rollers: bore and flattening", "ring"),
        (ends, "edges of surfaces that carry", "punch"),
        (ends, "rounded edges", "rounded-punch"),
        (friction, "friction: stick and slip", "cattaneo-mindlin"),
        (friction, "friction: sliding", "full-sliding"),
        (yields, "plastic flow, one direction", "uniaxial"),
        (yields, "plastic flow of a tube up to its limit", "tube"),
        (yields, "plastic flow below a contact", "sphere-plastic"),
        (dents, "dents that stay", "dents"),
        (
            true,
            "contact forces do not depend on the penalty",
            "penalty",
        ),
        (true, "the error bars", "certificate"),
    ];
    let used = families.into_iter().filter(|(used, ..)| *used);
    let rows = used.map(|(_, used, family)| {
        let (claims, outside) = claims(family);
        VerifiedBy {
            used,
            family,
            claims,
            outside,
        }
    });
    rows.filter(|row| row.claims > 0).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ground::order::ascending;

    /// The page counts its claims itself, in its head.
    #[test]
    fn claims_are_counted_as_the_page_does() {
        // A second table says where the numbers come from.
        let table = PAGE.split("## ").next().unwrap_or(PAGE).lines();
        let judged = table.filter_map(|line| {
            let mut cells = line.split('|').skip(1).map(str::trim);
            let verdict = cells.next()?;
            (!verdict.is_empty() && !verdict.starts_with('-')).then(|| cells.next())?
        });
        let [all, outside] = ascending(judged)
            .iter()
            .map(|family| claims(family))
            .fold([0, 0], |sum, (all, outside)| {
                [sum[0] + all, sum[1] + outside]
            });
        assert!(
            PAGE.contains(&format!("{} claims, {outside} outside", all)),
            "{all} {outside}"
        );
        assert!(claims("hertz-line").0 > 30);
    }
}
