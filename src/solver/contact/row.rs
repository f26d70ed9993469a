//! What the mortar operator of a pair is at one carrier node.

use crate::ground::geometry::Vec3;

/// Contact row of one carrier node. Lengths and stresses in the units of the scene.
#[derive(Debug, Clone)]
pub struct Row {
    /// The carrier node.
    pub node: u32,
    /// Carrier nodes beside it that it stands for, too: the other side covers but a sliver of their areas.
    pub absorbed: Vec<u32>,
    /// w_A, the area that the node stands for, as far as the other side covers it.
    pub area: f64,
    /// d_A = Σ coefficient · displacement over nodes of both sides, those of the other side negative. Axis
    /// by axis, as images of nodes behind a mirror plane take part, which move the other way across it.
    pub terms: Vec<(u32, [f64; 3])>,
    /// Unit normal from the carrier to the other side.
    pub normal: Vec3,
    /// Two unit tangents; `None` without friction. Where both sides slide by nothing along a tangent, on a
    /// mirror plane or on a plane that both are held on, it is zero.
    pub tangents: Option<[Vec3; 2]>,
    /// Initial gap, open positive.
    pub gap: f64,
    /// Stress per length: about the traction over the closure that it makes, the scale of the penalty. From the
    /// layers of elements beside the contact, and larger where the other side covers little: the traction on a
    /// small area moves the bodies little.
    pub stiffness: f64,
}

impl Row {
    /// The carrier nodes that the row is of.
    pub fn nodes(&self) -> impl Iterator<Item = u32> {
        [self.node].into_iter().chain(self.absorbed.iter().copied())
    }
}
