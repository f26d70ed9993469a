//! Displacement components that follow others: u_c = Σ f u_d.
//!
//! A component that follows has no equation. What it would have had is shared out to those that it follows, by virtual
//! work: with u = T x the stiffness of what remains is Tᵀ K T and its forces are Tᵀ f. So ties add no unknowns, and the
//! matrix stays as well conditioned as that of one body.

use crate::solver::fem::dofs::FIXED;

/// Three times the number of a node, plus the axis.
pub type Component = u32;

/// The component of `node` along `axis`.
pub fn component(node: u32, axis: usize) -> Component {
    3 * node + axis as u32
}

/// A component that follows others.
#[derive(Debug, Clone, PartialEq)]
pub struct Follower {
    /// The component,
    pub component: Component,
    /// what it follows, with factors,
    pub terms: Vec<(Component, f64)>,
    /// and the tie of the scene that joins them; `None` where the node hangs on an edge or face of a larger element.
    pub tie: Option<u32>,
}

/// All components that follow others.
#[derive(Debug, Clone, Default)]
pub struct Tied {
    /// Each follows only free components and followers before it.
    followers: Vec<Follower>,
    /// Place in `followers` of each component, or [`FIXED`]; empty where nothing is tied.
    place: Vec<u32>,
    /// In the order of `followers`: the same with free components only.
    resolved: Vec<Vec<(Component, f64)>>,
    /// Area that each node stands for in its ties, the integral of its dual function.
    pub areas: Vec<NodeArea>,
    /// By tie: the largest distance that it bridges, and the share of its carrier that is joined.
    pub joints: Vec<Joint>,
}

/// A tied node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodeArea {
    /// The tie of the scene,
    pub tie: u32,
    /// the node,
    pub node: u32,
    /// the area that its force acts on,
    pub area: f64,
    /// and the outward unit normal of its surface.
    pub normal: [f64; 3],
}

/// How a tie joins.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Joint {
    /// Index of the surface whose nodes follow.
    pub follows: usize,
    /// The largest distance that it bridges, a length.
    pub distance: f64,
    /// The largest that may be.
    pub tolerance: f64,
    /// Share of the area of the surface that follows which the other one covers.
    pub covered: f64,
}

impl Tied {
    /// Nothing follows yet, of as many `nodes`.
    pub fn new(nodes: usize) -> Self {
        Self {
            place: vec![FIXED; 3 * nodes],
            ..Self::default()
        }
    }

    /// No tie at all?
    pub fn is_empty(&self) -> bool {
        self.followers.is_empty()
    }

    /// Adds a follower, which nothing before it follows.
    pub fn push(&mut self, follower: Follower) {
        let mut sum: Vec<(Component, f64)> = Vec::new();
        for (component, factor) in &follower.terms {
            match self.row(*component) {
                None => sum.push((*component, *factor)),
                Some(row) => sum.extend(row.iter().map(|(c, f)| (*c, factor * f))),
            }
        }
        sum.sort_by_key(|(component, _)| *component);
        let mut merged: Vec<(Component, f64)> = Vec::new();
        for (component, factor) in sum {
            match merged.last_mut() {
                Some(last) if last.0 == component => last.1 += factor,
                _ => merged.push((component, factor)),
            }
        }
        self.place[follower.component as usize] = self.followers.len() as u32;
        self.resolved.push(merged);
        self.followers.push(follower);
    }

    /// What a component follows, free components only; `None` where it follows nothing.
    pub fn row(&self, component: Component) -> Option<&[(Component, f64)]> {
        let place = *self.place.get(component as usize)?;
        (place != FIXED).then(|| self.resolved[place as usize].as_slice())
    }

    /// Every component that follows, and what, free components only.
    pub fn rows(&self) -> impl Iterator<Item = (Component, &[(Component, f64)])> {
        let followers = self.followers.iter().map(|follower| follower.component);
        followers.zip(self.resolved.iter().map(Vec::as_slice))
    }

    /// Does a component of `node` follow others?
    pub fn has(&self, node: u32) -> bool {
        (0..3).any(|axis| self.row(component(node, axis)).is_some())
    }

    /// Moves the components that follow with those that they follow.
    pub fn spread(&self, nodal: &mut [[f64; 3]]) {
        for follower in &self.followers {
            let of = |(c, f): &(Component, f64)| f * nodal[*c as usize / 3][*c as usize % 3];
            let value = follower.terms.iter().map(of).sum();
            let c = follower.component as usize;
            nodal[c / 3][c % 3] = value;
        }
    }

    /// Shares out nodal forces to the components that are followed, by virtual work, and hands on what each follower
    /// had.
    pub fn fold(&self, nodal: &mut [[f64; 3]], mut each: impl FnMut(&Follower, f64)) {
        for follower in self.followers.iter().rev() {
            let c = follower.component as usize;
            let force = std::mem::take(&mut nodal[c / 3][c % 3]);
            each(follower, force);
            for (other, factor) in &follower.terms {
                nodal[*other as usize / 3][*other as usize % 3] += factor * force;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Component 0 of node 1 follows those of nodes 0 and 2; component 0 of node 3 follows that of node 1.
    fn chain() -> Tied {
        let mut tied = Tied::new(4);
        tied.push(Follower {
            component: 3,
            terms: vec![(0, 0.25), (6, 0.75)],
            tie: Some(0),
        });
        tied.push(Follower {
            component: 9,
            terms: vec![(3, 2.0), (6, 1.0)],
            tie: Some(1),
        });
        tied
    }

    #[test]
    fn a_chain_is_resolved() {
        assert_eq!(chain().row(9), Some(&[(0, 0.5), (6, 2.5)][..]));
        assert_eq!(chain().row(0), None);
        assert!(chain().has(3) && !chain().has(2));
    }

    #[test]
    fn motions_and_forces_do_the_same_work() {
        let mut u = vec![[4.0, 0.0, 0.0], [0.0; 3], [8.0, 1.0, 0.0], [0.0; 3]];
        chain().spread(&mut u);
        assert_eq!([u[1][0], u[3][0]], [7.0, 22.0]);
        let forces = vec![
            [1.0, 0.0, 0.0],
            [3.0, 0.0, 0.0],
            [5.0, 2.0, 0.0],
            [7.0, 0.0, 0.0],
        ];
        let work = |f: &[[f64; 3]]| -> f64 {
            let pairs = f.as_flattened().iter().zip(u.as_flattened());
            pairs.map(|(f, u)| f * u).sum()
        };
        let mut folded = forces.clone();
        let mut told = Vec::new();
        chain().fold(&mut folded, |follower, force| {
            told.push((follower.tie, follower.component, force));
        });
        // Node 1 hands on what it got from node 3.
        assert_eq!(told, [(Some(1), 9, 7.0), (Some(0), 3, 17.0)]);
        assert_eq!(work(&forces), work(&folded));
        assert_eq!([folded[1][0], folded[3][0]], [0.0; 2]);
    }
}
