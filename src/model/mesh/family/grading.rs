//! Element sizes that grow smoothly away from the contact, and stay nested when split.

/// Equal cells near the contact, growing ones beyond, as a smooth map of a parameter.
///
/// With ξ the number of cells from the contact, s = h ξ up to the `fine` cells, and beyond
/// s = h fine + h (q^k − 1) / ln q with k = ξ − fine, q such that the last cell ends at `total`.
/// Halving the steps of ξ splits every cell, and the size keeps growing smoothly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grading {
    size: f64,
    fine: usize,
    growing: usize,
    growth: f64,
}

impl Grading {
    /// Cells of equal length, at most: a section of so many squared has no room in memory.
    pub const MOST_CELLS: usize = 10_000;

    /// Cells of length `size` over at least `fine` (a length), growing by about `growth` a cell
    /// up to `total`; `fine` < `total`, `growth` > 1.
    ///
    /// Other numbers, and more than [`MOST_CELLS`](Self::MOST_CELLS) of equal length, give no cell; a
    /// [`Block`](crate::model::mesh::block::Block) of one node says that its coordinates are none.
    pub fn new(size: f64, fine: f64, total: f64, growth: f64) -> Self {
        let is_whole = [size, fine, total, growth.ln()]
            .iter()
            .all(|x| *x > 0.0 && x.is_finite());
        if !is_whole || fine / size > Self::MOST_CELLS as f64 {
            let [fine, growing] = [0; 2];
            return Self {
                size,
                fine,
                growing,
                growth,
            };
        }
        let cells = (fine / size - 1e-9).ceil().max(1.0);
        let rest = (total / size - cells).max(1.0);
        let growing = (rest * growth.ln()).ln_1p() / growth.ln();
        let growing = growing.round().max(1.0);
        Self {
            size,
            fine: cells as usize,
            growing: growing as usize,
            growth: growth_to(rest, growing),
        }
    }

    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.fine + self.growing
    }

    /// Distance from the contact at parameter `xi`, in cells.
    pub fn at(&self, xi: f64) -> f64 {
        let beyond = xi - self.fine as f64;
        if beyond <= 0.0 {
            return self.size * xi;
        }
        let log = self.growth.ln();
        let grown = if log.abs() < 1e-12 {
            beyond
        } else {
            (beyond * log).exp_m1() / log
        };
        self.size * (self.fine as f64 + grown)
    }

    /// Distances of all nodes where every cell is split into `parts`.
    pub fn nodes(&self, parts: usize) -> Vec<f64> {
        (0..=self.cells() * parts)
            .map(|k| self.at(k as f64 / parts as f64))
            .collect()
    }
}

/// The q for which (q^m − 1) / ln q = `rest`.
fn growth_to(rest: f64, m: f64) -> f64 {
    let length = |log: f64| (m * log).exp_m1() / log;
    // The length rises with the growth; bisect its logarithm.
    let (mut low, mut high) = (1e-9, 5.0);
    if length(low) >= rest {
        return 1.0;
    }
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if length(middle) < rest {
            low = middle;
        } else {
            high = middle;
        }
    }
    (0.5f64 * (low + high)).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn splitting_keeps_the_nodes_and_ends_at_the_total() {
        let grading = Grading::new(0.1, 0.35, 3.0, 1.4);
        let (coarse, fine) = (grading.nodes(1), grading.nodes(2));
        assert!((coarse[coarse.len() - 1] - 3.0).abs() < 1e-12);
        for (k, s) in coarse.iter().enumerate() {
            assert_eq!(*s, fine[2 * k]);
        }
        assert!(fine.windows(2).all(|w| w[0] < w[1]));
        assert!((fine[1] - 0.05).abs() < 1e-15);
    }

    #[test]
    fn numbers_that_make_no_grading_give_no_cell() {
        let nan = f64::NAN;
        let wrong = [
            [0.0, 1.0, 3.0, 1.4],
            [-0.1, 1.0, 3.0, 1.4],
            [0.1, nan, 3.0, 1.4],
            [0.1, 1.0, f64::INFINITY, 1.4],
            [0.1, 1.0, 3.0, 1.0],
            [1e-9, 1.0, 3.0, 1.4],
        ];
        for [size, fine, total, growth] in wrong {
            assert_eq!(Grading::new(size, fine, total, growth).cells(), 0);
        }
    }
}
