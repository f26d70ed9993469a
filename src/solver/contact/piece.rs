//! What one carrier facet gathers from the segments in which it overlaps the other side.

use super::mortar::Pair;
use super::search::FacetTree;
use super::segment::{SegmentPoint, View};
use super::side::Side;
use crate::ground::geometry::{Vec3, add, dot, norm, scale, sub, unit};

/// Integrals over a facet, each with the hat function of one carrier node: of one, of the outward normals of the
/// carrier and of the other side, of the gap between the true surfaces, of the stiffness per area.
#[derive(Debug, Clone, Copy, Default)]
pub struct Gathered {
    pub area: f64,
    pub normals: [Vec3; 2],
    pub gap: Vec3,
    pub stiffness: f64,
}

impl Gathered {
    /// Sums two.
    pub fn add(&mut self, other: &Self) {
        self.area += other.area;
        let [own, across] = self.normals;
        self.normals = [add(own, other.normals[0]), add(across, other.normals[1])];
        self.gap = add(self.gap, other.gap);
        self.stiffness += other.stiffness;
    }

    /// The normal of the contact, from the carrier to the other side: that of the side which is flat here, where
    /// one is. A flat side tells it to the last digit; the mean of both, which is taken elsewhere, leans where
    /// the nodes do not lie evenly about the line of contact, and with it the force.
    pub fn normal(&self) -> Vec3 {
        const BENT: f64 = 1e-10;
        let flat = |normal: Vec3| norm(normal) >= (1.0 - BENT) * self.area;
        let [own, across] = self.normals;
        match [own, across].map(flat) {
            [true, false] => own,
            [false, true] => scale(across, -1.0),
            _ => sub(own, across),
        }
    }
}

/// What a carrier facet gathers, corner by corner.
#[derive(Default)]
pub struct Piece {
    pub corners: [Gathered; 4],
    /// ∫ N_a N_b dA over the facet's own nodes.
    pub products: [[f64; 4]; 4],
    /// The same with the nodes of each facet across.
    pub across: Vec<Across>,
    /// Sum of the mean normals of both sides.
    facing: Vec3,
}

/// An opposite facet below a carrier facet.
pub struct Across {
    pub nodes: [u32; 4],
    /// Signs of the facet's image, see [`Side::signs`].
    pub signs: Vec3,
    /// ∫ N_a N_b dA: carrier nodes by opposite nodes.
    pub products: [[f64; 4]; 4],
}

/// A quadrature point with the gap, the outward normals of both sides and the stiffness there.
struct Measured {
    point: SegmentPoint,
    gap: Vec3,
    normals: [Vec3; 2],
    stiffness: f64,
}

impl Piece {
    fn add(&mut self, at: &Measured) {
        let SegmentPoint { carrier, area, .. } = at.point;
        let [own, across] = at.normals;
        self.facing = add(self.facing, scale(sub(own, across), area));
        add_products(&mut self.products, &carrier, &carrier, area);
        for (corner, shape) in self.corners.iter_mut().zip(carrier) {
            let weight = shape * area;
            corner.add(&Gathered {
                area: weight,
                normals: at.normals.map(|normal| scale(normal, weight)),
                gap: scale(at.gap, weight),
                stiffness: weight * at.stiffness,
            });
        }
    }

    /// Nothing at all, where nothing lies across.
    fn some(self) -> Option<Self> {
        self.corners.iter().any(|c| c.area != 0.0).then_some(self)
    }
}

fn add_products(products: &mut [[f64; 4]; 4], a: &[f64; 4], b: &[f64; 4], area: f64) {
    for (row, a) in products.iter_mut().zip(a) {
        for (value, b) in row.iter_mut().zip(b) {
            *value += area * a * b;
        }
    }
}

/// Facet `index` of the carrier before the facets of `opposite`.
///
/// The facet is projected along the mean normal of both sides, found in a few passes: seen so, two
/// bodies that are mirror images face each other point by point.
pub fn on_surface(
    pair: &Pair,
    carrier: &Side,
    index: usize,
    opposite: &Side,
    tree: &FacetTree,
) -> Option<Piece> {
    const PASSES: usize = 4;
    const SAME: f64 = 1e-10;
    let (corners, normal) = (&carrier.corners[index], carrier.normals[index]);
    let farthest = pair.farthest(corners);
    let facet = Facing {
        index,
        others: tree.near(
            corners,
            normal.map(|n| farthest * n.abs() + 0.1 * pair.reach),
        ),
        carrier,
        opposite,
    };
    let mut direction = normal;
    let mut out = facet.project(direction, farthest);
    for _ in 1..PASSES {
        let Some(mean) = unit(out.facing) else { break };
        if norm(sub(mean, direction)) < SAME {
            break;
        }
        direction = mean;
        out = facet.project(direction, farthest);
    }
    out.some()
}

/// A carrier facet and what may lie opposite.
struct Facing<'a> {
    index: usize,
    others: Vec<usize>,
    carrier: &'a Side,
    opposite: &'a Side,
}

impl Facing<'_> {
    /// What the facet gathers when projected along `direction`.
    fn project(&self, direction: Vec3, farthest: f64) -> Piece {
        let (carrier, opposite, index) = (self.carrier, self.opposite, self.index);
        let normal = carrier.normals[index];
        let mut piece = Piece::default();
        if dot(normal, direction) < 0.5 {
            return piece;
        }
        let view = View::new(&carrier.corners[index], normal, direction);
        for &other in &self.others {
            if dot(normal, opposite.normals[other]) > -0.3 {
                continue;
            }
            let stiffness = series(carrier.stiffness[index], opposite.stiffness[other]);
            let mut products = [[0.0; 4]; 4];
            view.overlap(&opposite.corners[other], |point| {
                let (xs, ns) = carrier.at(index, &point.carrier);
                let (xm, nm) = opposite.at(other, &point.opposite);
                let gap = sub(xm, xs);
                if dot(gap, normal).abs() > farthest {
                    return;
                }
                add_products(&mut products, &point.carrier, &point.opposite, point.area);
                piece.add(&Measured {
                    point,
                    gap,
                    normals: [ns, nm],
                    stiffness,
                });
            });
            if products != [[0.0; 4]; 4] {
                piece.across.push(Across {
                    nodes: opposite.nodes[other],
                    signs: opposite.signs[other],
                    products,
                });
            }
        }
        piece
    }
}

/// Facet `index` of the carrier before a rigid half space.
pub fn on_plane(
    pair: &Pair,
    carrier: &Side,
    index: usize,
    origin: Vec3,
    normal: Vec3,
) -> Option<Piece> {
    let facing = carrier.normals[index];
    if dot(facing, normal) > -0.3 {
        return None;
    }
    let farthest = pair.farthest(&carrier.corners[index]);
    let mut piece = Piece::default();
    View::new(&carrier.corners[index], facing, facing).whole(|point| {
        let (x, _) = carrier.at(index, &point.carrier);
        let distance = dot(sub(x, origin), normal);
        if distance.abs() <= farthest {
            piece.add(&Measured {
                point,
                gap: scale(normal, -distance),
                normals: [scale(normal, -1.0), normal],
                stiffness: carrier.stiffness[index],
            });
        }
    });
    piece.some()
}

/// Two layers in series.
fn series(a: f64, b: f64) -> f64 {
    a * b / (a + b)
}
