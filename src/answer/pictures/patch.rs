//! A piece of a field in a plane.

/// A convex polygon, and the value at each corner.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Patch {
    pub corners: Vec<[f64; 2]>,
    pub values: Vec<f64>,
}

impl Patch {
    /// At the opposite coordinates along the page, or up it with `k` = 1.
    pub fn image(&self, k: usize) -> Self {
        let turned = |corner: &[f64; 2]| {
            let mut corner = *corner;
            corner[k] = -corner[k];
            corner
        };
        Self {
            corners: self.corners.iter().map(turned).collect(),
            values: self.values.clone(),
        }
    }
}
