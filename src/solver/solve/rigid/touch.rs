//! A contact point as the rigid-body modes see it.

use crate::ground::geometry::{Vec3, tangents};
use crate::solver::solve::rigid::resistance::relative;
use crate::solver::solve::rigid::rigid_bodies::RigidBodies;
use crate::solver::solve::rows::contact_row::ContactRow;
use nalgebra::{DMatrix, DVector};

/// A contact point as the motions of rigid bodies see it: closure, and slip along both tangents.
pub struct Touch {
    pub friction: f64,
    pub normal: DVector<f64>,
    pub tangents: Option<[DVector<f64>; 2]>,
}

impl Touch {
    /// Of a contact row, for the motions in the columns of `free`.
    pub fn new(contact: &ContactRow, bodies: &RigidBodies, free: &DMatrix<f64>) -> Self {
        Self::along(contact, contact.row.tangents, (bodies, free))
    }

    /// The same with tangents where there is no friction, too.
    pub fn rough(contact: &ContactRow, bodies: &RigidBodies, free: &DMatrix<f64>) -> Self {
        let row = &contact.row;
        let both = row.tangents.unwrap_or_else(|| tangents(row.normal));
        Self::along(contact, Some(both), (bodies, free))
    }

    fn along(
        contact: &ContactRow,
        tangents: Option<[Vec3; 2]>,
        (bodies, free): (&RigidBodies, &DMatrix<f64>),
    ) -> Self {
        let on = |direction: Vec3| {
            let mut sum = DVector::zeros(free.ncols());
            for (body, values) in relative(contact, direction, bodies) {
                for (i, value) in values.into_iter().enumerate() {
                    sum += value * free.row(6 * body + i).transpose();
                }
            }
            sum
        };
        Self {
            friction: contact.law.friction,
            normal: on(contact.row.normal),
            tangents: tangents.map(|t| t.map(on)),
        }
    }
}
