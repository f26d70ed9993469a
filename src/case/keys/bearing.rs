//! Keys of a bearing.

use super::template_loads::{ECCENTRICITY, HORIZONTAL, MOMENT, SKEW, TOP};
use super::templates::{
    ALONG_CAP, ALONG_GROWTH, AROUND_CAP, DEPTH_CAP, DEPTH_GROWTH, DEPTH_LEAST, END_SIZE,
    FINE_ELEMENTS, FINE_LAYERS, GROWTH, LOWER_THICKNESS, PLATE_SIZE, ROLLER_SIZE, ROLLER_WALL,
    ROLLINGS, SCALE, SOLID, STAGES, UNLOAD, UNLOAD_TO, UPPER_THICKNESS, WALL_CAP, WALL_LEAST,
};
use super::{Keys, key};

pub const BEARING: Keys = Keys {
    heading: "[bearing]",
    about: "Two crossed rollers between three plates, the intermediate one with V valleys. Forces are \
            those of the whole bearing.",
    keys: &[
        key(
            "load",
            "force",
            "required without `[[combination]]`",
            "vertical, on the top face",
        ),
        ECCENTRICITY,
        HORIZONTAL,
        MOMENT,
        TOP,
        SKEW,
        key(
            "friction",
            "share, 0 or more",
            "required",
            "Coulomb's coefficient of all four interfaces; a displaced roller stays on its slope only \
             from tan(slope/2) on",
        ),
        key(
            "roller_diameter",
            "length",
            "required",
            "D, of both rollers",
        ),
        ROLLER_WALL,
        SOLID,
        key("roller_length", "length", "required", "L, of both rollers"),
        key(
            "roller_end",
            "`\"square\"` or a table",
            "`\"square\"`",
            "shape of the ends; a square one is a singular point",
        ),
        key(
            "offset",
            "length",
            "required",
            "displacement: of the rollers, s, or of the bearing, 2 s, as `offset_is` says",
        ),
        key(
            "offset_is",
            "`roller` or `bearing`",
            "`roller`",
            "what `offset` is the displacement of",
        ),
        key(
            "slope",
            "angle",
            "required",
            "of each side of a valley against the horizontal",
        ),
        key(
            "plate_thickness",
            "length, or a table",
            "required",
            "of all three plates, or of each; of the intermediate one where its valleys cross",
        ),
        key(
            "plate_size",
            "length, or a list of two",
            "L x L",
            "of the plates along x and y",
        ),
        key(
            "full",
            "true or false",
            "false",
            "make no use of symmetry: neither of the mirror planes of a centred bearing nor of the half turn that makes \
             upper and lower half alike",
        ),
        UNLOAD,
        UNLOAD_TO,
        STAGES,
        ROLLINGS,
    ],
};

pub const PLATE_THICKNESS: Keys = Keys {
    heading: "bearing.plate_thickness",
    about: "Where the plates differ.",
    keys: &[
        UPPER_THICKNESS,
        key(
            "intermediate",
            "length",
            "required",
            "of the intermediate plate, where its valleys cross",
        ),
        LOWER_THICKNESS,
    ],
};

pub const ROLLER_END: Keys = Keys {
    heading: "bearing.roller_end",
    about: "One of the two, or both, in place of `\"square\"`.",
    keys: &[
        key("radius", "length", "none", "of a fillet at the ends"),
        key(
            "crown",
            "length",
            "none",
            "drop of a crowned roller at its ends",
        ),
    ],
};

pub const BEARING_MESH: Keys = Keys {
    heading: "[mesh] of a bearing",
    about: "The preset decides; every other key stands in place of one of its numbers. What they do is \
            drawn in [`meshes/README.md`](../../../meshes/README.md).",
    keys: &[
        key(
            "preset",
            "`auto`, `h025`, `h0125` or `report-like`",
            "`auto`",
            "three elements or more across the half-width of every line of contact, meshed once more \
             where the solution finds another width than statics; 0.025 in across the lines of a roller \
             of 3 in (D/120); half of that; the uniform coarse mesh of the reference study, to compare \
             with",
        ),
        SCALE,
        ROLLER_SIZE,
        PLATE_SIZE,
        FINE_ELEMENTS,
        FINE_LAYERS,
        key(
            "crossing_size",
            "length",
            "of the preset",
            "element size along a roller where the other one crosses",
        ),
        END_SIZE,
        GROWTH,
        DEPTH_GROWTH,
        ALONG_GROWTH,
        AROUND_CAP,
        ALONG_CAP,
        WALL_CAP,
        key(
            "plan_cap",
            "length",
            "of the preset",
            "largest element in plan, in the outer plates",
        ),
        key(
            "middle_cap",
            "length",
            "of the preset",
            "largest element in plan, in the intermediate plate",
        ),
        DEPTH_CAP,
        WALL_LEAST,
        DEPTH_LEAST,
        key(
            "along_least",
            "whole number",
            "of the preset",
            "fewest elements along half a roller of a centred bearing",
        ),
    ],
};
