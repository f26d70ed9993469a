//! Keys of pairs of surfaces: joined, or in contact.

use super::{Keys, key};

pub const TIE: Keys = Keys {
    heading: "[[tie]]",
    about: "Two surfaces that are joined for good, by mortar integrals: their nodes need not meet.",
    keys: &[
        key(
            "surfaces",
            "list of two surfaces",
            "required",
            "what is joined; the force of the tie is told as it acts on the second one",
        ),
        key(
            "name",
            "text",
            "`<first>-<second>`",
            "of the tie in all results",
        ),
        key(
            "tolerance",
            "length",
            "5 % of the side of a facet, on the coarser side",
            "the largest distance of the two that is bridged; a larger one is an error",
        ),
    ],
};

pub const CONTACT: Keys = Keys {
    heading: "[[contact]]",
    about: "A pair of surfaces, or a surface and a rigid plane.",
    keys: &[
        key(
            "name",
            "text",
            "`<upper>-<lower>`",
            "of the interface in all results",
        ),
        key(
            "upper",
            "surface, or a table with `plane`",
            "required",
            "one side",
        ),
        key(
            "lower",
            "surface, or a table with `plane`",
            "required",
            "the other side",
        ),
        key(
            "carrier",
            "`upper` or `lower`",
            "the softer side, of equal steels the one with coarser facets, else the upper one",
            "the non-mortar (slave) side, whose nodes carry the pressure",
        ),
        key("friction", "share, 0 or more", "0", "Coulomb's coefficient"),
        key(
            "penalty_factor",
            "share, positive",
            "1",
            "multiplies the automatic penalty; the converged answer does not depend on it",
        ),
        key(
            "true_geometry",
            "true or false",
            "true",
            "take surfaces whose nodes lie on a cylinder or sphere as that shape in the gap, not as \
             their facets",
        ),
    ],
};

pub const PARTNER: Keys = Keys {
    heading: "contact.upper, contact.lower",
    about: "A rigid plane in place of a surface: `lower = { plane = { point = [0, 0, 0], normal = [0, 0, \
            1] } }`.",
    keys: &[key("plane", "table", "required", "a rigid half space")],
};

pub const PLANE: Keys = Keys {
    heading: "contact.upper.plane, contact.lower.plane",
    about: "The half space behind the plane.",
    keys: &[
        key(
            "point",
            "list of three lengths",
            "required",
            "a point of the plane",
        ),
        key(
            "normal",
            "list of three shares",
            "required",
            "out of the half space; of any length",
        ),
    ],
};
