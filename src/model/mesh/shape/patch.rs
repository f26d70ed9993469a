//! A surface moved to the origin and scaled to unit size.

use std::collections::HashMap;

use nalgebra::Vector3;

use super::surface_shape::Shape;
use crate::ground::order::ascending;
use crate::model::mesh::{Mesh, Surface};

pub(super) struct Patch {
    /// Its nodes, about the middle of their bounding box, in units of its diagonal.
    pub points: Vec<Vector3<f64>>,
    /// The same of each part of it that hangs together.
    pieces: Vec<Vec<Vector3<f64>>>,
    pub facets: Vec<Facet>,
    /// Area divided by the diagonal: about the smaller extent of the surface.
    pub width: f64,
    /// Is there a node that is not on the rim?
    pub has_inner_node: bool,
    middle: Vector3<f64>,
    size: f64,
}

pub(super) struct Facet {
    pub corners: [Vector3<f64>; 4],
    pub centre: Vector3<f64>,
    /// Outward unit normal.
    pub normal: Vector3<f64>,
    pub area: f64,
}

impl Patch {
    /// The patch of `surface`, unless it has no extent or a facet without area.
    pub fn new(mesh: &Mesh, surface: &Surface) -> Option<Self> {
        let mut nodes = surface.nodes();
        let has_inner_node = has_inner_node(surface, nodes.len());
        // What hangs is in the middle of a chord.
        nodes.retain(|node| mesh.hung(*node).is_none());
        let place = |node: u32| mesh.points.get(node as usize).copied().map(Vector3::from);
        let points: Vec<Vector3<f64>> = nodes.iter().filter_map(|n| place(*n)).collect();
        let first = points.first()?;
        let low = points.iter().fold(*first, |a, b| a.inf(b));
        let high = points.iter().fold(*first, |a, b| a.sup(b));
        let (middle, size) = ((low + high) / 2.0, (high - low).norm());
        if !(size.is_finite() && size > 0.0) {
            return None;
        }
        let scaled = |p: Vector3<f64>| (p - middle) / size;
        let mut facets = Vec::with_capacity(surface.faces.len());
        for face in &surface.faces {
            let corners = face.nodes.map(|n| place(n).map(scaled));
            let [Some(a), Some(b), Some(c), Some(d)] = corners else {
                return None;
            };
            let area = (c - a).cross(&(d - b)) / 2.0;
            facets.push(Facet {
                corners: [a, b, c, d],
                centre: (a + b + c + d) / 4.0,
                normal: area.try_normalize(0.0)?,
                area: area.norm(),
            });
        }
        let of_piece = |nodes: Vec<u32>| {
            let places = nodes.into_iter().filter_map(place);
            places.map(scaled).collect()
        };
        Some(Self {
            pieces: pieces(mesh, surface).into_iter().map(of_piece).collect(),
            points: points.into_iter().map(scaled).collect(),
            width: facets.iter().map(|f| f.area).sum(),
            facets,
            has_inner_node,
            middle,
            size,
        })
    }

    /// The plane of the mean normal through the mean of the nodes, and how far off it nodes are:
    /// infinitely, where the normals cancel.
    pub fn plane(&self) -> (Shape, f64) {
        let sum: Vector3<f64> = self.facets.iter().map(|f| f.normal * f.area).sum();
        if sum.norm() <= 1e-6 * self.width {
            return (Shape::Facets, f64::INFINITY);
        }
        let normal = sum.normalize();
        let mean = self.points.iter().sum::<Vector3<f64>>() / self.points.len() as f64;
        let off = self
            .points
            .iter()
            .map(|p| (p - mean).dot(&normal).abs())
            .fold(0.0, f64::max);
        (
            Shape::Plane {
                point: mean.into(),
                normal: normal.into(),
            },
            off,
        )
    }

    /// In how many rows along `axis` the nodes stand, of the piece that has most.
    pub fn rows(&self, point: Vector3<f64>, axis: Vector3<f64>, radius: f64) -> usize {
        let rows = self.pieces.iter().map(|p| rows(p, (point, axis, radius)));
        rows.max().unwrap_or(0)
    }

    /// `shape` of the patch as a shape of the surface.
    pub fn in_place(&self, shape: Shape) -> Shape {
        let place = |p: [f64; 3]| (self.middle + Vector3::from(p) * self.size).into();
        match shape {
            Shape::Plane { point, normal } => Shape::Plane {
                point: place(point),
                normal,
            },
            Shape::Cylinder {
                point,
                axis,
                radius,
                convex,
            } => Shape::Cylinder {
                point: place(point),
                axis,
                radius: radius * self.size,
                convex,
            },
            Shape::Sphere {
                centre,
                radius,
                convex,
            } => Shape::Sphere {
                centre: place(centre),
                radius: radius * self.size,
                convex,
            },
            Shape::Facets => Shape::Facets,
        }
    }
}

/// Whether one of the `count` nodes is on no edge that only one facet has.
fn has_inner_node(surface: &Surface, count: usize) -> bool {
    let mut edges: HashMap<[u32; 2], usize> = HashMap::new();
    for face in &surface.faces {
        for k in 0..4 {
            let (a, b) = (face.nodes[k], face.nodes[(k + 1) % 4]);
            *edges.entry([a.min(b), a.max(b)]).or_default() += 1;
        }
    }
    let rim = edges.into_iter().filter(|(_, facets)| *facets == 1);
    ascending(rim.flat_map(|(edge, _)| edge)).len() < count
}

/// In how many rows along an axis some points of a cylinder stand.
fn rows(
    points: &[Vector3<f64>],
    (point, axis, radius): (Vector3<f64>, Vector3<f64>, f64),
) -> usize {
    // Angles from the middle of the nodes, or from the first where they are all around.
    let across = |p: &Vector3<f64>| (p - point) - axis * (p - point).dot(&axis);
    let sum: Vector3<f64> = points.iter().map(across).sum();
    let mean = sum / points.len() as f64;
    let first = points.first().map(across).unwrap_or_default();
    let start = if mean.norm() > 1e-3 * radius {
        mean
    } else {
        first
    };
    let side = axis.cross(&start);
    let angle = |p: &Vector3<f64>| across(p).dot(&side).atan2(across(p).dot(&start));
    let mut angles: Vec<f64> = points.iter().map(angle).collect();
    angles.sort_unstable_by(f64::total_cmp);
    let (Some(low), Some(high)) = (angles.first(), angles.last()) else {
        return 0;
    };
    let apart = 1e-3 * (high - low);
    1 + angles.windows(2).filter(|w| w[1] - w[0] > apart).count()
}

/// The nodes of each part of a surface that hangs together, without those that hang.
fn pieces(mesh: &Mesh, surface: &Surface) -> Vec<Vec<u32>> {
    let mut faces_at: HashMap<u32, Vec<usize>> = HashMap::new();
    for (index, face) in surface.faces.iter().enumerate() {
        for node in face.nodes {
            faces_at.entry(node).or_default().push(index);
        }
    }
    let mut seen = vec![false; surface.faces.len()];
    let mut pieces = Vec::new();
    for start in 0..seen.len() {
        let (mut next, mut nodes) = (vec![start], Vec::new());
        while let Some(face) = next.pop() {
            if std::mem::replace(&mut seen[face], true) {
                continue;
            }
            for node in surface.faces[face].nodes {
                nodes.push(node);
                next.extend(faces_at[&node].iter().filter(|other| !seen[**other]));
            }
        }
        let mut nodes = ascending(nodes);
        nodes.retain(|node| mesh.hung(*node).is_none());
        pieces.push(nodes);
    }
    pieces.retain(|nodes| !nodes.is_empty());
    pieces
}
