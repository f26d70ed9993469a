//! Where a patch of contact ends on a mesh: between nodes that press and nodes beside them that do not.

use crate::answer::results::edges::boundary;
use crate::ground::geometry::{Vec3, add, dot, norm, scale, sub};
use crate::model::mesh::Surface;
use crate::model::scene::Scene;
use crate::model::state::ContactField;
use std::collections::BTreeSet;

/// Share of the pressure further in below which the pressure of a node at the border of its surface is that of a rim within its row: of
/// one that falls evenly to nothing at the border a third is left.
const WITHIN: f64 = 0.5;

/// Area of the nodes in contact next to one that is not, and of those, and of nodes in contact at the border of the surface that
/// the rim lies [within](WITHIN), modelled part.
pub(super) fn area(scene: &Scene, field: &ContactField, pair: usize) -> f64 {
    let mut rim: BTreeSet<u32> = sides(scene, field, pair).into_iter().flatten().collect();
    rim.extend(within_last_row(scene, field, pair));
    let index = |node: &u32| field.nodes.binary_search(node).ok();
    (rim.iter().filter_map(index)).map(|i| field.area[i]).sum()
}

/// The nodes in contact at the border of the carrier that press less than one beside them further in.
fn within_last_row(scene: &Scene, field: &ContactField, pair: usize) -> Vec<u32> {
    let Some(surface) = scene.carrier(pair) else {
        return Vec::new();
    };
    let pressure = |node: u32| {
        let index = field.nodes.binary_search(&node).ok()?;
        field.is_active(index).then(|| field.pressure[index])
    };
    let border: BTreeSet<u32> = boundary(scene, surface).into_iter().flatten().collect();
    // Along the border pressures vary for other reasons.
    let is_low = |(own, other): &(u32, u32)| {
        let inwards = border.contains(own) && !border.contains(other);
        let both = pressure(*own).zip(pressure(*other)).filter(|_| inwards);
        both.is_some_and(|(own, other)| own < WITHIN * other)
    };
    let sides = surface.faces.iter();
    let sides = sides.flat_map(|face| [0, 1, 2, 3].map(|side| face.edge(side)));
    let both_ways = sides.flat_map(|[a, b]| [(a, b), (b, a)]);
    both_ways.filter(is_low).map(|(own, _)| own).collect()
}

/// The rim of a patch as its largest pressure sees it.
pub(super) struct Rim {
    /// Where that is.
    peak: Vec3,
    /// Sides of the carrier's faces across the rim, by their ends from the peak.
    sides: Vec<[Vec3; 2]>,
}

impl Rim {
    /// Around the node `top` of the carrier.
    pub(super) fn around(scene: &Scene, field: &ContactField, pair: usize, top: usize) -> Self {
        let peak = scene.mesh.points[field.nodes[top] as usize];
        let across = sides(scene, field, pair).into_iter();
        Self {
            peak,
            sides: across.map(|side| from(scene, peak, side)).collect(),
        }
    }

    /// Mean square of its distance from the peak.
    pub(super) fn squared_radius(&self) -> f64 {
        mean(self.sides.iter().map(|side| square(middle(side))))
    }

    /// Mean square of the faces' length outwards across the rim over its distance from the peak: of the side of the pair of
    /// which it is more.
    pub(super) fn squared_spacing(&self, scene: &Scene, pair: usize) -> f64 {
        let [_, other] = scene.contacts[pair].carrier_first();
        let others = other.surface(&scene.mesh).map_or(0.0, |surface| {
            // Once a node: it is a corner of several faces.
            let mut inside = surface.nodes();
            inside.retain(|node| self.encloses(sub(scene.mesh.points[*node as usize], self.peak)));
            let is_inside = |node| Some(inside.binary_search(&node).is_ok());
            let across = sides_where(surface, is_inside).into_iter();
            mean(across.map(|side| outwards(&from(scene, self.peak, side))))
        });
        mean(self.sides.iter().map(outwards)).max(others)
    }

    /// Is a place, from the peak, nearer than the rim in the same direction?
    fn encloses(&self, place: Vec3) -> bool {
        let rim = self.sides.iter().map(middle);
        let towards = |rim: &Vec3| dot(place, *rim) / norm(*rim);
        let rim = rim.max_by(|a, b| towards(a).total_cmp(&towards(b)));
        rim.is_some_and(|rim| square(place) < square(rim))
    }
}

/// Sides of the carrier's faces between a node that presses and one that does not, each once.
fn sides(scene: &Scene, field: &ContactField, pair: usize) -> BTreeSet<[u32; 2]> {
    let index = |node: u32| field.nodes.binary_search(&node).ok();
    scene.carrier(pair).map_or_else(BTreeSet::new, |surface| {
        sides_where(surface, |node| index(node).map(|i| field.is_active(i)))
    })
}

/// Sides of faces of which one end is inside and the other is not, each once; nothing is known of ends that are `None`.
fn sides_where(surface: &Surface, inside: impl Fn(u32) -> Option<bool>) -> BTreeSet<[u32; 2]> {
    let mut found = BTreeSet::new();
    for face in &surface.faces {
        for ends in [0, 1, 2, 3].map(|side| face.edge(side)) {
            if let [Some(first), Some(second)] = ends.map(&inside)
                && first != second
            {
                found.insert(ends);
            }
        }
    }
    found
}

fn from(scene: &Scene, peak: Vec3, side: [u32; 2]) -> [Vec3; 2] {
    side.map(|node| sub(scene.mesh.points[node as usize], peak))
}

fn middle([a, b]: &[Vec3; 2]) -> Vec3 {
    scale(add(*a, *b), 0.5)
}

fn square(v: Vec3) -> f64 {
    dot(v, v)
}

/// Square of the length of a side outwards over the distance of its middle.
fn outwards(side: &[Vec3; 2]) -> f64 {
    let radius = middle(side);
    (dot(sub(side[1], side[0]), radius) / square(radius)).powi(2)
}

/// Zero of nothing.
pub(super) fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let [sum, number] = values.fold([0.0, 0.0], |[sum, number], v| [sum + v, number + 1.0]);
    sum / f64::max(number, 1.0)
}
