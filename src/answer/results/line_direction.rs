//! The direction along which the lines of contact of a pair run.

use super::circle::FittedCircle;
use super::line_frame::{LineFrame, axis_of, facing, is_mirrored};
use super::load::direction;
use super::own_directions::{AXES, first_side, length, own_directions, snapped};
use super::rows::NodeRows;
use crate::ground::geometry::{Vec3, dot, tangents};
use crate::model::mesh::shape::{Shape, fit};
use crate::model::mesh::{Mesh, Surface};
use crate::model::scene::Scene;

/// The frame of the lines of contact pair `pair`, along that about which one of its surfaces is round, a cylinder or
/// a roller with fillets or a crown; else along the longer side across the load of the more slender of the two. The carrier's nodes
/// stand in rows across it, where they do in any. `None` where the pair has no carrier surface, or the load acts along the line.
pub fn line_frame(scene: &Scene, pair: usize) -> Option<LineFrame> {
    let carrier = scene.carrier(pair)?;
    let contact = &scene.contacts[pair];
    let sides = [&contact.upper, &contact.lower].into_iter();
    let sides: Vec<&Surface> = sides.filter_map(|side| side.surface(&scene.mesh)).collect();
    let up = facing(scene, &sides);
    let nodes = carrier.nodes();
    let in_rows = |frame: &LineFrame| {
        let along = nodes
            .iter()
            .map(|n| frame.along(&scene.mesh.points[*n as usize]));
        NodeRows::of(&along.collect::<Vec<_>>()).is_some()
    };
    let [likely, fallback] = directions(scene, &sides, carrier);
    let frame = |along: &Vec3| LineFrame::new(*along, up);
    let mut frames = likely.iter().chain(&fallback).filter_map(frame);
    // Without rows no line is read, but slices are.
    let slices = || fallback.iter().find_map(frame);
    frames.find(in_rows).or_else(slices)
}

/// Directions along which lines may run, the likeliest first, and those that do where no rows tell.
fn directions(scene: &Scene, sides: &[&Surface], carrier: &Surface) -> [Vec<Vec3>; 2] {
    let mesh = &scene.mesh;
    let round = sides.iter().flat_map(|surface| match fit(mesh, surface) {
        Shape::Cylinder { axis, .. } => along_cylinder(axis),
        Shape::Facets => about(scene, surface).into_iter().collect(),
        Shape::Plane { .. } | Shape::Sphere { .. } => Vec::new(),
    });
    let round: Vec<Vec3> = round.collect();
    match round.first().copied() {
        Some(first) => [round, vec![first]],
        None => {
            // Axes in their order, which decides where sides are alike.
            let own = |surface: &Surface| {
                let own = of_surface(scene, surface);
                let are_axes = own.iter().all(|direction| axis_of(direction).is_some());
                if are_axes { AXES } else { own }
            };
            let axes = |_: &Surface| AXES;
            [
                vec![longest(scene, (sides, carrier), &own)],
                vec![longest(scene, (sides, carrier), &axes)],
            ]
        }
    }
}

/// From this cosine on rows of a plate along an axis may be those of a cylinder: rollers may be a tenth of a radian askew.
const ALONG: f64 = 0.99;

/// That of a cylinder, and of a plate below it that is square to the axes.
fn along_cylinder(direction: Vec3) -> Vec<Vec3> {
    let next = AXES
        .into_iter()
        .find(|axis| dot(*axis, direction).abs() > ALONG);
    let all = [snapped(direction), direction].into_iter().chain(next);
    all.collect()
}

/// Those of a surface, see [`own_directions`].
fn of_surface(scene: &Scene, surface: &Surface) -> [Vec3; 3] {
    own_directions(scene, &surface.nodes(), first_side(surface))
}

/// The direction about which the rows of nodes of a surface are round, most of all.
fn about(scene: &Scene, surface: &Surface) -> Option<Vec3> {
    let own = of_surface(scene, surface);
    let oblique = own.into_iter().filter(|own| axis_of(own).is_none());
    let round = AXES.into_iter().chain(oblique);
    let round = round.filter_map(|along| Some((radius_about(&scene.mesh, surface, along)?, along)));
    let most = round.min_by(|a, b| a.0.total_cmp(&b.0));
    most.map(|(_, along)| along)
}

/// The largest radius of the rows of a surface across a direction, where each is round, and all about one line. Those of a surface that
/// is nearly plane stand on circles that are much larger than itself: they count as straight.
fn radius_about(mesh: &Mesh, surface: &Surface, along: Vec3) -> Option<f64> {
    const FEWEST_ROWS: usize = 3;
    /// Of the radius, how far the centres may be apart.
    const CENTRED: f64 = 1e-3;
    /// Largest radius over the size of the surface. The nodes of a flat V lie on a circle, too, if that is large enough.
    const ROUND: f64 = 2.0;
    let plane = tangents(along);
    let nodes = surface.nodes();
    let places: Vec<Vec3> = nodes.iter().map(|n| mesh.points[*n as usize]).collect();
    let coordinates: Vec<f64> = places.iter().map(|at| dot(along, *at)).collect();
    let rows = NodeRows::of(&coordinates)?.members;
    let in_plane = |i: &usize| plane.map(|side| dot(side, places[*i]));
    let circles: Option<Vec<FittedCircle>> = (rows.iter())
        .map(|row| FittedCircle::through(&row.iter().map(in_plane).collect::<Vec<_>>()))
        .collect();
    let circles = circles.filter(|circles| circles.len() >= FEWEST_ROWS)?;
    let size = plane.map(|side| length(mesh, &nodes, side));
    let first = circles[0].centre;
    let are_round = circles.iter().all(|circle| {
        let [x, y] = circle.centre;
        let off = (x - first[0]).hypot(y - first[1]);
        off <= CENTRED * circle.radius && circle.radius <= ROUND * size[0].max(size[1])
    });
    let radii = circles.iter().map(|circle| circle.radius);
    are_round.then(|| radii.fold(0.0, f64::max))
}

/// The longer side across the load of the more slender surface of a pair; of the carrier, if both are alike. Sides are along the
/// `directions` of a surface.
fn longest(
    scene: &Scene,
    (sides, carrier): (&[&Surface], &Surface),
    directions: &dyn Fn(&Surface) -> [Vec3; 3],
) -> Vec3 {
    // A mirrored side is twice as long as it looks.
    let length = |surface: &Surface, along: Vec3| {
        let mirrored = is_mirrored(&along, &scene.mirrors);
        length(&scene.mesh, &surface.nodes(), along) * if mirrored { 2.0 } else { 1.0 }
    };
    /// Sides that differ by less are alike.
    const ALIKE: f64 = 1.0 + 1e-9;
    let load = direction(scene);
    let longer = |surface: &Surface| {
        let all = directions(surface);
        let by_load = |k: &usize| dot(all[*k], load).abs();
        let facing = (0..3).max_by(|a, b| by_load(a).total_cmp(&by_load(b)));
        // In their order, whatever rounding makes of the angles.
        let mut across = (0..3).filter(|k| Some(*k) != facing).map(|k| all[k]);
        let [one, other] = [0, 1].map(|_| across.next().unwrap_or(all[0]));
        let [a, b] = [one, other].map(|along| length(surface, along));
        let slenderness = a.max(b) / a.min(b).max(f64::MIN_POSITIVE);
        (slenderness, if b > ALIKE * a { other } else { one })
    };
    let own = longer(carrier);
    let more = |most: (f64, Vec3), other: (f64, Vec3)| match other.0 > 1.001 * most.0 {
        true => other,
        false => most,
    };
    sides.iter().map(|side| longer(side)).fold(own, more).1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::material::Steel;
    use crate::model::mesh::block::{Block, cylindrical, uniform};
    use std::f64::consts::TAU;

    /// A roller along x, half as long as it is wide, whose radius falls by `drop` towards its ends.
    fn roller(drop: impl Fn(f64) -> f64 + 'static) -> Mesh {
        let along_x = move |[r, angle, x]: [f64; 3]| {
            let [y, z, x] = cylindrical([r - drop(x), angle, x]);
            [x, y, z]
        };
        Block::new(
            "roller",
            uniform(1.5, 2.0, 1),
            uniform(0.0, TAU / 2.0, 24),
            uniform(-1.0, 1.0, 10),
        )
        .mapped(along_x)
        .build()
        .unwrap()
    }

    fn axis_about(mesh: &Mesh, name: &str) -> Option<usize> {
        let scene = Scene::bare("roller", mesh.clone(), Steel::elastic(1.0, 0.3));
        axis_of(&about(&scene, mesh.surface(name).unwrap())?)
    }

    /// The axis of a short roller with a fillet or a crown is that about which it is round, not its longer side.
    #[test]
    fn a_roller_is_round_about_its_axis_whatever_its_ends_are() {
        let fillet = |x: f64| 0.3 - (0.16 - (x.abs() - 0.7).max(0.0).powi(2)).sqrt() + 0.1;
        let crown = |x: f64| 0.01 * x * x;
        assert_eq!(axis_about(&roller(|_| 0.0), "x_max"), Some(0));
        assert_eq!(axis_about(&roller(fillet), "x_max"), Some(0));
        assert_eq!(axis_about(&roller(crown), "x_max"), Some(0));
        // Its flat end has none.
        assert_eq!(axis_about(&roller(crown), "z_max"), None);
    }
}
