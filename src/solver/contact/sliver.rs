//! Carrier nodes of which the other side covers next to nothing.
//!
//! Where the other side ends just beyond a node of the carrier, the hat function of the next node is met by a
//! sliver only. Its force is next to none whatever its pressure, so that nothing tells that pressure: its
//! multiplier creeps, and with it the iterations. Such a node has no multiplier of its own. Its hat function
//! is added to that of a node beside it (as at the edges of mortar surfaces, Cichosz and Bischoff 2011): the
//! functions still sum to one wherever the sides face each other, so that no force is lost and a uniform
//! pressure passes the patch test.

use super::node_sum::NodeSum;
use std::collections::BTreeMap;

/// Share of a facet's area that the other side has to cover before a node for it to have a multiplier. Down to this share the
/// penalty grows as the share falls, and a multiplier comes near its value as quickly as others do; the shear of a cautious
/// node still by a factor of 1.6 an iteration. Below it pressures would be large numbers on next to no area.
const LEAST_COVERED: f64 = 0.02;

/// Shares that differ by no more than this count as equal, so that rounding decides no tie.
const TIE: f64 = 1e-9;

/// Adds the sums of slivers to those of the nodes beside them. `facets` are the nodes of all facets that the
/// other side covers in part. Likewise those of the nodes `follow`, ascending, which have no multiplier: a tie moves them.
pub(super) fn absorb(
    nodes: &mut BTreeMap<u32, NodeSum>,
    follow: &[u32],
    facets: impl Iterator<Item = [u32; 4]>,
) {
    let follows = |node: &u32| follow.binary_search(node).is_ok();
    let slivers: BTreeMap<u32, f64> = nodes
        .iter()
        .map(|(node, sum)| (*node, sum.covered()))
        .filter(|(node, covered)| *covered > 0.0 && (*covered < LEAST_COVERED || follows(node)))
        .collect();
    // Of the nodes at the other ends of its edges that which is covered most; a tie goes to the lower number.
    let mut beside: BTreeMap<u32, (f64, u32)> = BTreeMap::new();
    if slivers.is_empty() {
        return;
    }
    for facet in facets {
        for (a, node) in facet.iter().enumerate() {
            if !slivers.contains_key(node) {
                continue;
            }
            for other in [facet[(a + 1) % 4], facet[(a + 3) % 4]] {
                let Some(sum) = nodes.get(&other).filter(|_| !follows(&other)) else {
                    continue;
                };
                let candidate = (sum.covered(), other);
                let best = beside.entry(*node).or_insert(candidate);
                let more = candidate.0 - best.0;
                if more > TIE || (more >= -TIE && other < best.1) {
                    *best = candidate;
                }
            }
        }
    }
    // Least covered first: what a sliver takes over goes on with it.
    let mut order: Vec<(f64, u32)> = slivers.iter().map(|(node, c)| (*c, *node)).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
    for (_, node) in order {
        let Some(&(_, into)) = beside.get(&node) else {
            continue;
        };
        if into == node || !nodes.contains_key(&into) {
            continue;
        }
        if let Some(sum) = nodes.remove(&node)
            && let Some(master) = nodes.get_mut(&into)
        {
            master.absorb(node, &sum);
        }
    }
}
