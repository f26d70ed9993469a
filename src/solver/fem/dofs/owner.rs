//! What decides a displacement component.

use super::prescribed::Source;
use crate::model::scene::Scene;

/// What decides a displacement component.
#[derive(Debug, Clone, Copy)]
pub enum Owner {
    /// Given, at factor one.
    Held(f64, Source),
    /// It follows a rigid plane, by its index, that is driven or free to turn.
    Plane(usize),
}

impl Owner {
    /// Do both say the same, in every step?
    pub fn agrees(&self, other: &Self, scene: &Scene) -> bool {
        match (self, other) {
            (Self::Held(a, by), Self::Held(b, other)) => {
                let factor = |source: &Source, step| scene.factor(source.load(scene), step, 1.0);
                let mut steps = 0..scene.steps.len();
                a == b && (*a == 0.0 || steps.all(|s| factor(by, s) == factor(other, s)))
            }
            (Self::Plane(a), Self::Plane(b)) => a == b,
            _ => false,
        }
    }

    /// Name of the surface of the scene that decides.
    pub fn name<'a>(&self, scene: &'a Scene) -> &'a str {
        match *self {
            Self::Held(_, Source::Support(i)) => &scene.supports[i].surface,
            Self::Held(_, Source::Plane(i)) | Self::Plane(i) => &scene.rigid_planes[i].surface,
        }
    }
}
