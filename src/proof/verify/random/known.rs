//! What is known of a case without solving it: whether it can be in balance, and how much it can carry.

use crate::model::state::turn::TOO_FAR;

/// Something that a case has to have for balance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BalanceLimit {
    pub what: &'static str,
    pub has: f64,
    /// What it needs at least, on some mesh, and what is enough on all.
    pub needs: [f64; 2],
}

impl BalanceLimit {
    /// One that is needed to within this share of it, or of what there is.
    pub fn about(what: &'static str, has: f64, needs: f64, within: f64) -> Self {
        let off = within * has.abs().max(needs);
        Self {
            what,
            has,
            needs: [needs - off, needs + off],
        }
    }
}

/// What is known of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct KnownOfCase {
    /// What balance of rigid bodies needs.
    pub limits: Vec<BalanceLimit>,
    /// An upper bound of the plastic limit load.
    pub plastic: f64,
    pub load: f64,
    /// About how far a body turns, in radians, as columns that give way would have it; zero where that is not known.
    pub turn: f64,
}

/// Can bodies be in balance?
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StaticBalance {
    Sure,
    /// So near the limit that a mesh may say one or the other.
    Close,
    None,
}

impl KnownOfCase {
    pub fn balance(&self) -> StaticBalance {
        let mut limits = self.limits.iter();
        if limits.clone().any(|limit| limit.has < limit.needs[0]) {
            StaticBalance::None
        } else if limits.any(|limit| limit.has < limit.needs[1]) {
            StaticBalance::Close
        } else {
            StaticBalance::Sure
        }
    }

    /// What is missing for balance, in words.
    pub fn missing(&self) -> Option<String> {
        let lacking = |limit: &&BalanceLimit| limit.has < limit.needs[0];
        let limit = self.limits.iter().find(lacking)?;
        Some(format!(
            "{} {:.4} where {:.4} is needed",
            limit.what, limit.has, limit.needs[0]
        ))
    }

    /// May a body turn too far for small rotations? Columns know it to a factor of three.
    pub fn turns_far(&self) -> bool {
        3.0 * self.turn > TOO_FAR
    }

    /// Is the load beyond what plastic steel can carry?
    pub fn is_overloaded(&self) -> bool {
        self.load > self.plastic
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn known(has: f64) -> KnownOfCase {
        KnownOfCase {
            limits: vec![BalanceLimit::about("friction", has, 0.1, 0.03)],
            plastic: 1.0,
            load: 2.0,
            turn: 0.02,
        }
    }

    #[test]
    fn a_limit_is_met_missed_or_close() {
        let found = [0.2, 0.102, 0.098, 0.05].map(|has| known(has).balance());
        use StaticBalance::{Close, None, Sure};
        assert_eq!(found, [Sure, Close, Close, None]);
        assert!(
            known(0.05)
                .missing()
                .is_some_and(|m| m.contains("friction"))
        );
        assert!(known(0.2).missing().is_none() && known(0.2).is_overloaded());
        assert!(!known(0.2).turns_far());
    }
}
