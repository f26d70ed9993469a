//! Which component can follow which: no circle may arise.

use crate::solver::fem::tied::{Component, Follower, Tied};
use std::collections::BTreeMap;

/// Followers under way, in no order yet.
#[derive(Default, Clone)]
pub struct Order {
    follows: BTreeMap<Component, Vec<Component>>,
}

impl Order {
    /// Does the component follow others already?
    pub fn has(&self, component: Component) -> bool {
        self.follows.contains_key(&component)
    }

    /// Does one of `from` follow `target`, by whatever way, or is it the same?
    pub fn reaches(&self, from: impl IntoIterator<Item = Component>, target: Component) -> bool {
        let mut open: Vec<Component> = from.into_iter().collect();
        let mut known = Vec::new();
        while let Some(component) = open.pop() {
            if component == target {
                return true;
            }
            if let Some(next) = self.follows.get(&component)
                && !known.contains(&component)
            {
                known.push(component);
                open.extend(next);
            }
        }
        false
    }

    /// The component follows these, too.
    pub fn insert(&mut self, component: Component, terms: impl IntoIterator<Item = Component>) {
        self.follows.entry(component).or_default().extend(terms);
    }
}

/// Puts `followers`, among which is no circle, into `tied`: what is followed first.
pub fn sorted(followers: Vec<Follower>, mut tied: Tied) -> Tied {
    let place: BTreeMap<Component, usize> = (followers.iter().enumerate())
        .map(|(k, f)| (f.component, k))
        .collect();
    let mut waiting: Vec<Option<Follower>> = followers.into_iter().map(Some).collect();
    for first in 0..waiting.len() {
        let mut open = vec![first];
        while let Some(k) = open.last().copied() {
            let Some(follower) = &waiting[k] else {
                open.pop();
                continue;
            };
            let terms = follower.terms.iter().filter_map(|(c, _)| place.get(c));
            let before: Vec<usize> = terms.copied().filter(|p| waiting[*p].is_some()).collect();
            if before.is_empty() {
                open.pop();
                if let Some(follower) = waiting[k].take() {
                    tied.push(follower);
                }
            } else {
                open.extend(before);
            }
        }
    }
    tied
}
