//! A contact field without the nodes at which nothing is to be told.
//!
//! A field stands on all of its carrier's surface. Where many pairs share one, as pads on a plate, each faces a few of its
//! nodes only, and the ends of many steps would be kept mostly for the others.

use crate::model::state::ContactField;
use serde::{Deserialize, Serialize};

/// The nodes of a contact field that face something, and what is told of the pair as a whole.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(in crate::solver::solve) struct Packed {
    facing: Vec<Facing>,
    penetration: f64,
    at_rim: f64,
    unexplained: f64,
    unexplained_at: Option<[f64; 3]>,
}

/// One node of a contact field.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Facing {
    node: u32,
    pressure: f64,
    multiplier: f64,
    gap: f64,
    traction: [f64; 3],
    slip: f64,
    status: u8,
    area: f64,
    force: [f64; 3],
    acts_at: [[f64; 3]; 2],
    sagitta: f64,
}

impl Facing {
    fn of(field: &ContactField, at: usize) -> Self {
        Self {
            node: field.nodes[at],
            pressure: field.pressure[at],
            multiplier: field.multiplier[at],
            gap: field.gap[at],
            traction: field.traction[at],
            slip: field.slip[at],
            status: field.status[at],
            area: field.area[at],
            force: field.force[at],
            acts_at: field.acts_at[at],
            sagitta: field.sagitta[at],
        }
    }

    fn put(&self, field: &mut ContactField, at: usize) {
        field.pressure[at] = self.pressure;
        field.multiplier[at] = self.multiplier;
        field.gap[at] = self.gap;
        field.traction[at] = self.traction;
        field.slip[at] = self.slip;
        field.status[at] = self.status;
        field.area[at] = self.area;
        field.force[at] = self.force;
        field.acts_at[at] = self.acts_at;
        field.sagitta[at] = self.sagitta;
    }

    /// Is it as in [`ContactField::open`], to the last bit?
    fn is_nothing(&self) -> bool {
        let scalars = [
            self.pressure,
            self.multiplier,
            self.slip,
            self.area,
            self.sagitta,
        ];
        let mut values = (scalars.into_iter())
            .chain(self.traction)
            .chain(self.force)
            .chain(self.acts_at.into_iter().flatten());
        self.status == 0 && self.gap == f64::INFINITY && values.all(|v| v.to_bits() == 0)
    }
}

impl Packed {
    pub fn new(field: &ContactField) -> Self {
        let all = (0..field.nodes.len()).map(|at| Facing::of(field, at));
        Self {
            facing: all.filter(|node| !node.is_nothing()).collect(),
            penetration: field.penetration,
            at_rim: field.at_rim,
            unexplained: field.unexplained,
            unexplained_at: field.unexplained_at,
        }
    }

    /// The whole field on `nodes`, which are those of the carrier.
    pub fn unpack(&self, nodes: Vec<u32>) -> ContactField {
        let mut field = ContactField {
            penetration: self.penetration,
            at_rim: self.at_rim,
            unexplained: self.unexplained,
            unexplained_at: self.unexplained_at,
            ..ContactField::open(nodes)
        };
        for own in &self.facing {
            if let Ok(at) = field.nodes.binary_search(&own.node) {
                own.put(&mut field, at);
            }
        }
        field
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_field_comes_back_to_the_last_bit_and_is_kept_where_something_is_told() {
        let nodes: Vec<u32> = (0..100).map(|n| 3 * n).collect();
        let mut field = ContactField::open(nodes.clone());
        // Each array alone keeps a node; a zero with a sign is a value, too.
        field.pressure[10] = 0.1 + 0.2;
        field.multiplier[11] = -1.0;
        field.gap[12] = 0.5;
        field.traction[13] = [0.0, -0.0, 0.0];
        field.slip[14] = 1e-300;
        field.status[15] = 2;
        field.area[16] = 4.0;
        field.force[17] = [0.0, 0.0, 7.0];
        field.acts_at[18] = [[0.0; 3], [0.0, 1.0, 0.0]];
        field.sagitta[19] = 1e-9;
        field.penetration = 0.25;
        field.at_rim = 0.125;
        field.unexplained = 0.0625;
        field.unexplained_at = Some([1.0, 2.0, 3.0]);
        let packed = Packed::new(&field);
        assert_eq!(packed.facing.len(), 10);
        // Debug tells zeros with a sign apart.
        assert_eq!(format!("{:?}", packed.unpack(nodes)), format!("{field:?}"));
    }
}
