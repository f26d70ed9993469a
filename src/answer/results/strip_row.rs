//! The nodes across a line of contact, and how closely they stand.

/// The row of nodes across a line where it carries most.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StripRow {
    /// Its index among the rows of the line, and the coordinate along.
    pub row: usize,
    /// Coordinate of the row along the surface.
    pub at: f64,
    /// Distance of its nodes along the surface from the centre of pressure, ascending, and the
    /// coefficients of their hat functions: from the open node on one side to that on the other, or
    /// from the plane of symmetry that cuts the strip.
    pub nodes: Vec<(f64, f64)>,
    /// The centre of pressure, on the undeformed carrier.
    pub centre: [f64; 3],
    /// Does a plane of symmetry cut it?
    pub mirrored: bool,
    /// Half-width 2 sqrt(∫ p x² / ∫ p), p = Σ c N.
    pub half_width: f64,
}

impl StripRow {
    /// Distance between the last node in contact and the first open one, the larger of both sides:
    /// the edge of the strip lies anywhere between them.
    pub fn edge_spacing(&self) -> f64 {
        let gaps = self
            .nodes
            .windows(2)
            .filter(|w| (w[0].1 == 0.0) != (w[1].1 == 0.0));
        let widest = gaps.map(|w| w[1].0 - w[0].0).fold(0.0, f64::max);
        // All nodes press: to the end of the surface.
        if widest > 0.0 {
            widest
        } else {
            self.middle_spacing()
        }
    }

    /// Does it press at one end of the surface, by half of its largest pressure and more? Then it is the half of a strip, unless a plane of
    /// symmetry is known to cut it there.
    pub fn is_cut(&self) -> bool {
        let most = self.nodes.iter().map(|(_, c)| *c).fold(0.0, f64::max);
        let presses = |end: Option<&(f64, f64)>| end.is_some_and(|(_, c)| *c > 0.5 * most);
        !self.mirrored && presses(self.nodes.first()) != presses(self.nodes.last())
    }

    /// How much of the row the nodes in contact stand for.
    pub fn pressed_width(&self) -> f64 {
        let pressed = |node: &(f64, f64)| f64::from(u8::from(node.1 > 0.0));
        let width = |w: &[(f64, f64)]| 0.5 * (w[1].0 - w[0].0) * (pressed(&w[0]) + pressed(&w[1]));
        let modelled: f64 = self.nodes.windows(2).map(width).sum();
        if self.mirrored {
            2.0 * modelled
        } else {
            modelled
        }
    }

    /// The larger of both.
    pub fn spacing(&self) -> f64 {
        self.middle_spacing().max(self.edge_spacing())
    }

    /// Distance of the node next to the centre of pressure from it.
    pub fn off_centre(&self) -> f64 {
        self.middle().map_or(0.0, |i| self.nodes[i].0.abs())
    }

    /// The node next to the centre of pressure.
    fn middle(&self) -> Option<usize> {
        (0..self.nodes.len()).min_by(|a, b| {
            let off = |i: &usize| self.nodes[*i].0.abs();
            off(a).total_cmp(&off(b))
        })
    }

    /// The larger distance from the node next to the centre to its neighbours.
    pub fn middle_spacing(&self) -> f64 {
        let Some(middle) = self.middle() else {
            return 0.0;
        };
        let apart = |a: usize, b: usize| match (self.nodes.get(a), self.nodes.get(b)) {
            (Some(a), Some(b)) => b.0 - a.0,
            _ => 0.0,
        };
        apart(middle.wrapping_sub(1), middle).max(apart(middle, middle + 1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_in_contact_stand_for_half_the_way_to_those_beside() {
        let row = |nodes: &[(f64, f64)], mirrored: bool| StripRow {
            nodes: nodes.to_vec(),
            mirrored,
            ..StripRow::default()
        };
        let whole = row(
            &[(-3.0, 0.0), (-1.0, 1.0), (0.0, 2.0), (1.0, 1.0), (3.0, 0.0)],
            false,
        );
        let half = row(&[(0.0, 2.0), (1.0, 1.0), (3.0, 0.0)], true);
        let cut = row(&half.nodes, false);
        assert_eq!(
            [&whole, &half, &cut].map(StripRow::is_cut),
            [false, false, true]
        );
        assert_eq!([whole, half].map(|row| row.pressed_width()), [4.0; 2]);
    }
}
