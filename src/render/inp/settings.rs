//! What a deck says beyond the scene.

/// How the other program is to treat contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ContactType {
    /// Penalty at points of the faces: the one that copes with friction and plasticity.
    #[default]
    SurfaceToSurface,
    /// Penalty at the nodes of the carrier.
    NodeToSurface,
    /// Dual mortar multipliers (CalculiX). Its carrier must not be held by supports.
    Mortar,
}

/// What the deck says beyond the scene.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Settings {
    /// Of the deck, for its head.
    pub title: String,
    /// Names of the units of length, force and stress.
    pub units: [String; 3],
    /// Element type; `None` takes the one that stands for the element of the scene.
    pub element: Option<String>,
    pub contact: ContactType,
    /// Pressure per overclosure; `None` takes 20 Young's moduli over the shortest edge of the
    /// carriers' faces.
    pub contact_stiffness: Option<f64>,
    /// How far the closing step moves a plane that is driven by force; `None` takes the
    /// shortening of a solid block in place of the bodies, which is safely too little. Where no
    /// plane is driven there is no such step.
    pub closing: Option<f64>,
    /// First increment of the load steps, as a share of the step; `None` takes that of the scene.
    pub increment: Option<f64>,
    /// Linear solver; `None` leaves the choice to the program.
    pub solver: Option<String>,
}
