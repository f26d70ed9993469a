//! Within an iteration: the traction of a node as a function of its relative displacement d.

use super::node::{Node, NodeResponse, Status};
use super::parameters::Law;

impl Law {
    /// Traction and tangent of a node at d.
    ///
    /// The tangent is symmetric: the normal and the tangential part do not feel each other, as the
    /// bound on the shear is that of the iteration before, and both parts are symmetric themselves.
    pub fn traction(&self, node: &Node, d: &[f64; 3]) -> NodeResponse {
        let mut answer = NodeResponse::default();
        if !node.closed {
            return answer;
        }
        answer.status = Status::Slip;
        let penalty = self.penalty(node);
        answer.traction[0] = node.multiplier[0] + penalty * d[0];
        answer.tangent[0][0] = penalty;
        if self.friction == 0.0 {
            return answer;
        }
        if !node.cautious && !node.sticks {
            for i in 0..2 {
                let [s, t] = node.slope[i];
                let moved = s * (d[1] - node.origin[0]) + t * (d[2] - node.origin[1]);
                answer.traction[1 + i] = node.multiplier[1 + i] + moved;
                answer.tangent[1 + i][1..].copy_from_slice(&node.slope[i]);
            }
            return answer;
        }
        let soft = self.tangential_penalty(node);
        let stick = if node.cautious { soft } else { penalty };
        let elastic = [1, 2].map(|i| node.multiplier[i] + stick * d[i]);
        let shear = elastic[0].hypot(elastic[1]);
        if !node.cautious || shear <= node.bound {
            answer.status = Status::Stick;
            for i in 0..2 {
                answer.traction[1 + i] = elastic[i];
                answer.tangent[1 + i][1 + i] = stick;
            }
            return answer;
        }
        let e = elastic.map(|t| t / shear);
        let turn = soft * node.bound / shear;
        for i in 0..2 {
            answer.traction[1 + i] = node.bound * e[i];
            for j in 0..2 {
                let across = f64::from(u8::from(i == j)) - e[i] * e[j];
                answer.tangent[1 + i][1 + j] = turn * across;
            }
        }
        answer
    }
}
