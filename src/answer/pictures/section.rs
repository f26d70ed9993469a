//! Bodies cut by coordinate planes: what stands in the plane, with a nodal field.

use super::patch::Patch;
use crate::answer::results::recovery::Recovered;
use crate::model::mesh::Mesh;
use crate::model::mesh::hexahedron::EDGES;

/// The plane where the coordinate `axis` is `at`, drawn with the axes `drawn` along and up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    pub axis: usize,
    pub at: f64,
    pub drawn: [usize; 2],
}

/// What a plane shows of a body.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Section {
    /// An element each.
    pub patches: Vec<Patch>,
    /// The skin of the body.
    pub outlines: Vec<[[f64; 2]; 2]>,
}

impl Plane {
    /// Cuts body `body`; values are the nodal averages of the Mises stress.
    pub fn cut(&self, mesh: &Mesh, recovered: &Recovered, body: usize) -> Section {
        let elements = mesh.bodies.get(body).map_or(0..0, |b| b.elements.clone());
        let patches = elements.filter_map(|element| {
            let corners = mesh.corners(element);
            let stress = recovered.points.cells[element].map(|p| recovered.mises_nodal[p as usize]);
            self.polygon(&corners, &stress)
        });
        let faces = mesh.outer_faces(body).into_iter();
        let outlines = faces.filter_map(|face| self.segment(&face.corners(mesh)));
        Section {
            patches: patches.collect(),
            outlines: outlines.collect(),
        }
    }

    fn side(&self, point: &[f64; 3]) -> f64 {
        point[self.axis] - self.at
    }

    /// Where the edge from `a` to `b` meets the plane, as a share of it.
    fn share(&self, a: &[f64; 3], b: &[f64; 3]) -> Option<f64> {
        let (from, to) = (self.side(a), self.side(b));
        ((from >= 0.0) != (to >= 0.0)).then(|| from / (from - to))
    }

    fn meet(&self, a: &[f64; 3], b: &[f64; 3]) -> Option<([f64; 2], f64)> {
        let share = self.share(a, b)?;
        let at = self.drawn.map(|k| a[k] + share * (b[k] - a[k]));
        Some((at, share))
    }

    /// The corners of the cut through a hexahedron, in their order around it.
    fn polygon(&self, corners: &[[f64; 3]; 8], values: &[f64; 8]) -> Option<Patch> {
        let points = EDGES.iter().filter_map(|[a, b]| {
            let (at, share) = self.meet(&corners[*a], &corners[*b])?;
            Some((at, values[*a] + share * (values[*b] - values[*a])))
        });
        let mut points: Vec<([f64; 2], f64)> = points.collect();
        let count = points.len() as f64;
        if points.len() < 3 {
            return None;
        }
        let middle = [0, 1].map(|k| points.iter().map(|(at, _)| at[k]).sum::<f64>() / count);
        let angle = |at: &[f64; 2]| (at[1] - middle[1]).atan2(at[0] - middle[0]);
        points.sort_by(|a, b| angle(&a.0).total_cmp(&angle(&b.0)));
        let (corners, values) = points.into_iter().unzip();
        Some(Patch { corners, values })
    }

    fn segment(&self, corners: &[[f64; 3]; 4]) -> Option<[[f64; 2]; 2]> {
        let sides = (0..4).map(|k| (&corners[k], &corners[(k + 1) % 4]));
        let mut meets = sides.filter_map(|(a, b)| Some(self.meet(a, b)?.0));
        Some([meets.next()?, meets.next()?])
    }
}

impl Section {
    /// Together with its image at the opposite coordinates along the page; the seam is no edge.
    pub fn mirrored(mut self) -> Self {
        let at = |ends: &[[f64; 2]; 2]| ends.map(|[u, _]| u.abs());
        let reach = self.outlines.iter().flat_map(at).fold(0.0, f64::max);
        let seam = |ends: &[[f64; 2]; 2]| at(ends).iter().all(|u| *u <= 1e-6 * reach);
        self.outlines.retain(|ends| !seam(ends));
        let images: Vec<Patch> = self.patches.iter().map(|patch| patch.image(0)).collect();
        let edges: Vec<[[f64; 2]; 2]> = (self.outlines.iter())
            .map(|ends| ends.map(|[u, v]| [-u, v]))
            .collect();
        self.patches.extend(images);
        self.outlines.extend(edges);
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::mesh::hexahedron::CORNERS;

    #[test]
    fn a_cube_is_cut_into_a_square_with_its_values() {
        let plane = Plane {
            axis: 2,
            at: 0.5,
            drawn: [0, 1],
        };
        let values = CORNERS.map(|c| c[2]);
        let patch = plane.polygon(&CORNERS, &values).unwrap();
        assert_eq!(patch.corners.len(), 4);
        assert!(patch.values.iter().all(|v| (v - 0.5).abs() < 1e-12));
        let area: f64 = (0..4)
            .map(|k| {
                let ([x, y], [u, v]) = (patch.corners[k], patch.corners[(k + 1) % 4]);
                0.5 * (x * v - u * y)
            })
            .sum();
        assert!((area - 4.0).abs() < 1e-12);
        let beside = Plane { at: 1.5, ..plane };
        assert_eq!(beside.polygon(&CORNERS, &values), None);
    }
}
