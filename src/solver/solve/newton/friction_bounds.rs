//! Friction bounds from iteration to iteration.
//!
//! The bound μ p of an iteration is that of the pressure before it. Where friction and pressure feel each other the
//! bounds near their values by the same share again and again, and what is left can be told from two steps
//! (Anderson 1965, with one step of memory).

use crate::solver::contact::law::Node;
use crate::solver::solve::params::{BOUND_EXTRAPOLATION_BACK, BOUND_EXTRAPOLATION_ON};

/// Remembers the last step.
#[derive(Default)]
pub struct Bounds {
    /// Bounds of the iteration before, and what its pressures asked for.
    last: Option<(Vec<f64>, Vec<f64>)>,
}

impl Bounds {
    /// The bounds of the next iteration, where `wanted` is what the pressures ask for now; `settled` where no node
    /// changed between open, stick and slip.
    pub fn next(&mut self, nodes: &[Node], wanted: Vec<f64>, settled: bool) -> Vec<f64> {
        let now: Vec<f64> = nodes.iter().map(|node| node.bound).collect();
        let mut next = wanted.clone();
        if let (true, Some((before, asked))) = (settled, &self.last) {
            let (mut along, mut size) = (0.0, 0.0);
            for i in 0..now.len() {
                let (missed, change) = (
                    wanted[i] - now[i],
                    wanted[i] - now[i] - asked[i] + before[i],
                );
                along += missed * change;
                size += change * change;
            }
            let share = if size > 0.0 {
                (along / size).clamp(-BOUND_EXTRAPOLATION_ON, BOUND_EXTRAPOLATION_BACK)
            } else {
                0.0
            };
            for i in 0..now.len() {
                next[i] = (wanted[i] - share * (wanted[i] - asked[i])).max(0.0);
            }
        }
        self.last = Some((now, wanted));
        next
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bounds that near (1, 2) by 0.45 in every iteration are there in three.
    #[test]
    fn a_steady_approach_is_cut_short() {
        let mut bounds = Bounds::default();
        let mut nodes = [Node::default(); 2];
        for _ in 0..3 {
            let limit = [1.0, 2.0];
            let wanted = [0, 1].map(|i| limit[i] + 0.45 * (nodes[i].bound - limit[i]));
            let next = bounds.next(&nodes, wanted.to_vec(), true);
            nodes.iter_mut().zip(next).for_each(|(n, b)| n.bound = b);
        }
        assert!((nodes[0].bound - 1.0).abs() < 1e-12 && (nodes[1].bound - 2.0).abs() < 1e-12);
    }
}
