//! How well shaped the elements of a body are.

use super::Mesh;
use super::hexahedron::{edge_lengths, scaled_jacobians, volume};

/// Shape of the elements of one body.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyQuality {
    /// Name of the body.
    pub name: String,
    /// Number of its elements.
    pub elements: usize,
    /// Smallest scaled Jacobian at any corner: 1 for boxes, positive for every sound element.
    pub min_scaled_jacobian: f64,
    /// Largest ratio of the longest to the shortest edge of an element.
    pub max_aspect_ratio: f64,
    /// Shortest and longest edge, in the length unit of the mesh.
    pub edge_lengths: [f64; 2],
    /// Volume, in the cube of the length unit.
    pub volume: f64,
}

impl Mesh {
    /// The shape of the elements, one entry a body, in the order of the bodies.
    pub fn quality(&self) -> Vec<BodyQuality> {
        self.bodies
            .iter()
            .map(|body| {
                let mut quality = BodyQuality {
                    name: body.name.clone(),
                    elements: body.elements.len(),
                    min_scaled_jacobian: f64::INFINITY,
                    max_aspect_ratio: 0.0,
                    edge_lengths: [f64::INFINITY, 0.0],
                    volume: 0.0,
                };
                body.elements
                    .clone()
                    .for_each(|element| quality.add(&self.corners(element)));
                quality
            })
            .collect()
    }
}

impl BodyQuality {
    fn add(&mut self, corners: &[[f64; 3]; 8]) {
        let smallest = scaled_jacobians(corners)
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        self.min_scaled_jacobian = self.min_scaled_jacobian.min(smallest);
        let (mut shortest, mut longest) = (f64::INFINITY, 0.0f64);
        for length in edge_lengths(corners) {
            shortest = shortest.min(length);
            longest = longest.max(length);
        }
        self.max_aspect_ratio = self.max_aspect_ratio.max(longest / shortest);
        self.edge_lengths = [
            self.edge_lengths[0].min(shortest),
            self.edge_lengths[1].max(longest),
        ];
        self.volume += volume(corners);
    }
}

#[cfg(test)]
mod tests {
    use crate::model::mesh::block::{Block, uniform};

    /// Figures of a box of cells 1 x 2 x 4 sheared by 45 degrees, by hand.
    #[test]
    fn a_sheared_box_is_measured() {
        let lists = [
            uniform(0.0, 2.0, 2),
            uniform(0.0, 4.0, 2),
            uniform(0.0, 8.0, 2),
        ];
        let [x, y, z] = lists;
        let mesh = Block::new("box", x, y, z)
            .mapped(|[x, y, z]| [x + y, y, z])
            .build()
            .unwrap();
        let [quality] = &mesh.quality()[..] else {
            panic!("one body")
        };
        assert_eq!((quality.name.as_str(), quality.elements), ("box", 8));
        assert!((quality.min_scaled_jacobian - 0.5f64.sqrt()).abs() < 1e-14);
        assert!((quality.max_aspect_ratio - 4.0).abs() < 1e-14);
        assert_eq!(quality.edge_lengths, [1.0, 4.0]);
        assert!((quality.volume - 64.0).abs() < 1e-12);
    }
}
