//! The elements that claims are made of.

use crate::model::scene::ElementKind;

/// An element, and what claims call it.
pub type NamedElement = (ElementKind, &'static str);

/// Both elements.
pub const ELEMENTS: [NamedElement; 2] = [
    (ElementKind::Bbar, "B-bar"),
    (ElementKind::Enhanced, "enhanced"),
];
