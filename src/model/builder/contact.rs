//! Contact pairs by the names of their surfaces.

use crate::ground::geometry::{norm, scale};
use crate::model::scene::{ContactPair, Partner, Side};

/// Two surfaces, or a surface and a rigid plane, that may touch; frictionless where nothing else is said.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    pub(super) pair: ContactPair,
    pub(super) carrier: Option<Side>,
}

impl Contact {
    /// Contact of the surface `upper` with the surface `lower`; its name is `<upper>-<lower>`. Forces are told as
    /// they act on the lower one.
    pub fn between(upper: &str, lower: &str) -> Self {
        let lower_partner = Partner::Surface(lower.into());
        Self::of(format!("{upper}-{lower}"), upper, lower_partner)
    }

    /// Contact of `surface` with the rigid half space behind the plane through `point`, whose outward normal is along
    /// `normal` (of any length); its name is `<surface>-plane`.
    pub fn on_plane(surface: &str, point: [f64; 3], normal: [f64; 3]) -> Self {
        let normal = scale(normal, 1.0 / norm(normal));
        let plane = Partner::Plane { point, normal };
        Self::of(format!("{surface}-plane"), surface, plane)
    }

    fn of(name: String, upper: &str, lower: Partner) -> Self {
        Self {
            pair: ContactPair {
                name,
                upper: Partner::Surface(upper.into()),
                lower,
                carrier: Side::Upper,
                friction: 0.0,
                penalty_factor: 1.0,
                true_geometry: true,
            },
            carrier: None,
        }
    }

    /// With Coulomb's coefficient of friction, zero or positive.
    pub fn friction(mut self, coefficient: f64) -> Self {
        self.pair.friction = coefficient;
        self
    }

    /// Calls it `name`.
    pub fn named(mut self, name: &str) -> Self {
        self.pair.name = name.into();
        self
    }

    /// The side whose nodes carry the pressure (the non-mortar or slave side); by default the one that
    /// [`choose`](crate::model::scene::carrier::choose) finds.
    pub fn carried_by(mut self, side: Side) -> Self {
        self.carrier = Some(side);
        self
    }

    /// Takes the facets of the mesh for the true shape of the surfaces, and not the circular cylinder or sphere
    /// that their nodes lie on.
    pub fn faceted(mut self) -> Self {
        self.pair.true_geometry = false;
        self
    }
}
