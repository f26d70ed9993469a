//! What the contacts of a scene do for the travel of its loads.

use super::line::turned_by_place;
use crate::analytic::hertz::LineContact;
use crate::answer::results::hertz::HeaviestLine;
use crate::answer::results::interface::Interface;
use crate::answer::results::line_frame::LineFrame;
use crate::answer::results::load::{applied, copies, cutting_pair, direction, times};
use crate::answer::results::strip_row::StripRow;
use crate::ground::geometry::{cross, dot, norm, sub};
use crate::model::scene::{RigidPlane, Scene};
use crate::model::state::State;
use crate::solver::solve::overlap_at_touch;
use std::f64::consts::PI;

/// Of the travel, beyond which nothing is known of what is missing.
pub(super) const MOST_MISSING: f64 = 0.5;

/// What the contact pairs of a scene carry, in their order.
#[derive(Debug, Clone, Copy)]
pub struct Contacts<'a> {
    /// Forces on the whole.
    pub interfaces: &'a [Interface],
    /// The heaviest line of each, where it has lines.
    pub lines: &'a [Option<HeaviestLine>],
}

impl Contacts<'_> {
    /// Work of the forces of the contacts on how much `closer` bodies come below strips than the mesh has it, which the
    /// smoothed stress knows nothing of: of a line, its Hertz contact and the compliance of both bodies.
    pub(super) fn work_below_strips(
        &self,
        scene: &Scene,
        closer: impl Fn(&HeaviestLine, &LineContact, f64) -> f64,
    ) -> f64 {
        let work = |index: usize| {
            let (line, hertz) = self.strip(index)?;
            let compliance = scene.compliance(&scene.contacts[index]).ok()?;
            Some(closer(line, &hertz, compliance) * self.force(scene, index)?)
        };
        (0..scene.contacts.len()).filter_map(work).sum()
    }

    /// Work of the forces of all other contacts on the overlap that their bodies were brought into touch with.
    pub(super) fn work_elsewhere(&self, scene: &Scene) -> f64 {
        let others = (0..scene.contacts.len()).filter(|index| self.strip(*index).is_none());
        let work = |index: usize| {
            let force = self.force(scene, index).filter(|force| *force > 0.0)?;
            Some(overlap_at_touch(scene, &scene.contacts[index]) * force)
        };
        others.filter_map(work).sum()
    }

    /// How far a rigid plane that turns freely may go as few nodes do not say where the contacts bear below it: a rocker rolls
    /// until its load is above them.
    pub(super) fn rolls(&self, scene: &Scene) -> f64 {
        let along = direction(scene);
        let of_pair = |plane: &RigidPlane, interface: &Interface, line: &HeaviestLine| {
            let arm = sub(
                plane.point(&scene.mesh, &scene.mirrors),
                interface.centre_of_force?,
            );
            Some(norm(cross(arm, along)) * turned_by_place(line))
        };
        let of_plane = |plane: &RigidPlane| {
            let surface = scene.mesh.surface(&plane.surface);
            let body = surface.and_then(|surface| surface.body(&scene.mesh));
            let pairs = self.interfaces.iter().zip(self.lines);
            let lines = pairs.filter_map(|(interface, line)| {
                let line = line.as_ref()?;
                let is_braced =
                    body.is_some_and(|body| self.rests_on_several(scene, (body, &line.frame)));
                of_pair(plane, interface, line).filter(|_| !is_braced)
            });
            lines.sum::<f64>()
        };
        let planes = scene.rigid_planes.iter();
        planes
            .filter(|plane| plane.turns_freely())
            .map(of_plane)
            .sum()
    }

    /// Do several lines along `frame` press on a body side by side? They keep it from rolling about any of them.
    fn rests_on_several(&self, scene: &Scene, (body, frame): (usize, &LineFrame)) -> bool {
        let across = cross(direction(scene), frame.along);
        let of_pair = |pair: usize| {
            let line = self.lines.get(pair)?.as_ref()?;
            let is_on_it = scene.contacts[pair]
                .bodies(&scene.mesh)
                .contains(&Some(body));
            let at = dot(self.interfaces.get(pair)?.centre_of_force?, across);
            (is_on_it && line.frame.is_parallel(frame))
                .then(|| (at, line.line.heaviest.pressed_width()))
        };
        let lines: Vec<(f64, f64)> = (0..scene.contacts.len()).filter_map(of_pair).collect();
        let beside =
            |(at, width): &(f64, f64)| lines.iter().any(|other| (at - other.0).abs() > *width);
        lines.iter().any(beside)
    }

    /// Is a body pressed along a long strip?
    pub(super) fn is_below_strip(&self, scene: &Scene, body: usize) -> bool {
        let pairs = scene.contacts.iter().enumerate();
        let mut of_body = pairs.filter(|(_, pair)| pair.bodies(&scene.mesh).contains(&Some(body)));
        of_body.any(|(index, _)| self.strip(index).is_some())
    }

    /// The Hertzian strip of a pair, where it is a long one.
    fn strip(&self, pair: usize) -> Option<(&HeaviestLine, LineContact)> {
        let line = self.lines.get(pair)?.as_ref()?;
        Some((line, line.strip()?))
    }

    /// By which share a pair may carry more or less of the load than it does on the mesh, where it does not carry all of it.
    ///
    /// What carries the rest beside it is a spring in parallel: where that is too stiff by a share, the travel is too small by the
    /// same share as the force of the pair, and that share is no more than its part of the load.
    pub(super) fn shared_off(
        &self,
        (scene, state): (&Scene, &State),
        pair: usize,
        travel_off: f64,
    ) -> f64 {
        let load = applied(scene, state);
        let force = self.force(scene, pair).filter(|_| load > 0.0);
        let rest = force.map_or(0.0, |force| (1.0 - force / load).max(0.0));
        travel_off.min(MOST_MISSING * rest)
    }

    /// What a pair presses by on the whole; images of it beside a mirror plane carry as much.
    fn force(&self, scene: &Scene, pair: usize) -> Option<f64> {
        let images = copies(scene) / times(&cutting_pair(scene, pair));
        Some(self.interfaces.get(pair)?.normal_force.abs() * images)
    }
}

/// How much closer bodies come below a strip that the mesh is too coarse for. A line load q presses two half spaces of the
/// compliance C together by 2 q C/π times the logarithm of a length over the half-width a (Johnson, Contact Mechanics,
/// section 5.6); the mesh has its node spacing for a where that is more.
pub(super) fn unseen_approach(line: &HeaviestLine, hertz: &LineContact, compliance: f64) -> f64 {
    let seen = line.line.heaviest.middle_spacing() / hertz.half_width;
    2.0 * line.line_load * compliance / PI * seen.ln().max(0.0)
}

/// By how much a round side of the relative radius R overlaps the other one before any load: bodies that float are brought
/// into touch where the least weighted gap vanishes, and the travel counts from there. With rows of the spacing h that is
/// h²/12R, and e²/2R more where the nearest node is e from the line of touch.
///
/// A strip of one element or two finds the first part by itself, or does not. Of 90 plane strips with 1 to 8 nodes to the
/// half-width, of random radii, depths, moduli and gradings, travels were short by (0.00 to 0.10) h²/R with a node on the
/// line and by (0.08 to 0.24) h²/R with it midway. Returned is what the mesh misses, and what it perhaps misses besides.
pub(super) fn overlap_of_strip(strip: &StripRow, hertz: &LineContact) -> [f64; 2] {
    let spacing = strip.middle_spacing();
    let of_spacing = spacing.powi(2) / (12.0 * hertz.radius);
    let off_line = strip.off_centre().powi(2) / (2.0 * hertz.radius);
    let unseen = (hertz.half_width / spacing - 1.0).clamp(0.0, 1.0);
    [unseen * of_spacing + off_line, (1.0 - unseen) * of_spacing]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a row with a node on the line of touch, and of one with it midway between nodes.
    #[test]
    fn the_overlap_of_a_strip_is_that_of_the_weighted_gap() {
        let strip = |shift: f64| StripRow {
            nodes: [-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0]
                .map(|x| (x + shift, 1.0))
                .to_vec(),
            ..StripRow::default()
        };
        let hertz = LineContact::new(1.0, 10.0, 1.0).unwrap();
        let hertz = LineContact {
            half_width: 3.0,
            ..hertz
        };
        assert!((overlap_of_strip(&strip(0.0), &hertz)[0] - 1.0 / 120.0).abs() < 1e-15);
        let midway = 1.0 / 120.0 + 0.25 / 20.0;
        assert!((overlap_of_strip(&strip(0.5), &hertz)[0] - midway).abs() < 1e-15);
        let coarse = LineContact {
            half_width: 1.0,
            ..hertz
        };
        assert_eq!(overlap_of_strip(&strip(0.0), &coarse), [0.0, 1.0 / 120.0]);
    }
}
