//! Nodes that stand in rows across a direction.

/// Rows of nodes, by their coordinate along that direction, ascending.
pub struct NodeRows {
    /// Coordinate of each row.
    pub at: Vec<f64>,
    /// Its nodes, as places among all.
    pub members: Vec<Vec<usize>>,
}

impl NodeRows {
    /// Those of nodes with these coordinates; `None` unless there are two rows, and three nodes in each.
    pub fn of(coordinates: &[f64]) -> Option<Self> {
        const FEWEST: usize = 3;
        let place = |i: &usize| coordinates[*i];
        let mut order: Vec<usize> = (0..coordinates.len()).collect();
        order.sort_by(|a, b| place(a).total_cmp(&place(b)));
        let same = 1e-6 * (place(order.last()?) - place(order.first()?));
        let (mut at, mut members): (Vec<f64>, Vec<Vec<usize>>) = (Vec::new(), Vec::new());
        for i in order {
            let here = place(&i);
            match members.last_mut() {
                Some(row) if at.last().is_some_and(|a| here - a <= same) => row.push(i),
                _ => {
                    at.push(here);
                    members.push(vec![i]);
                }
            }
        }
        let are_rows = at.len() > 1 && members.iter().all(|row| row.len() >= FEWEST);
        are_rows.then_some(Self { at, members })
    }
}
