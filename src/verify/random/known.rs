//! What is known of a case without solving it: whether it can be in balance, and how much it can carry.

/// Something that a case has to have for balance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    pub what: &'static str,
    pub has: f64,
    pub needs: f64,
    /// By how much of it a mesh may be wrong.
    pub within: f64,
}

/// What is known of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Known {
    /// What balance of rigid bodies needs.
    pub limits: Vec<Limit>,
    /// An upper bound of the plastic limit load.
    pub plastic: f64,
    pub load: f64,
}

/// Can bodies be in balance?
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Balance {
    Sure,
    /// So near the limit that a mesh may say one or the other.
    Close,
    None,
}

impl Known {
    pub fn balance(&self) -> Balance {
        let over = |limit: &Limit| (limit.has - limit.needs) / limit.has.abs().max(limit.needs);
        let mut limits = self.limits.iter();
        if limits.clone().any(|limit| over(limit) < -limit.within) {
            Balance::None
        } else if limits.any(|limit| over(limit) < limit.within) {
            Balance::Close
        } else {
            Balance::Sure
        }
    }

    /// What is missing for balance, in words.
    pub fn missing(&self) -> Option<String> {
        let lacking = |limit: &&Limit| limit.has < limit.needs;
        let limit = self.limits.iter().find(lacking)?;
        Some(format!(
            "{} {:.4} where {:.4} is needed",
            limit.what, limit.has, limit.needs
        ))
    }

    /// Is the load beyond what plastic steel can carry?
    pub fn is_overloaded(&self) -> bool {
        self.load > self.plastic
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn known(has: f64) -> Known {
        Known {
            limits: vec![Limit {
                what: "friction",
                has,
                needs: 0.1,
                within: 0.03,
            }],
            plastic: 1.0,
            load: 2.0,
        }
    }

    #[test]
    fn a_limit_is_met_missed_or_close() {
        let found = [0.2, 0.102, 0.098, 0.05].map(|has| known(has).balance());
        use Balance::{Close, None, Sure};
        assert_eq!(found, [Sure, Close, Close, None]);
        assert!(
            known(0.05)
                .missing()
                .is_some_and(|m| m.contains("friction"))
        );
        assert!(known(0.2).missing().is_none() && known(0.2).is_overloaded());
    }
}
