//! Keys of parallel rollers.

use super::template_loads::{ECCENTRICITY, HORIZONTAL, MOMENT, SKEW, TOP};
use super::templates::{
    ALONG_CAP, ALONG_GROWTH, AROUND_CAP, DEPTH_CAP, DEPTH_GROWTH, DEPTH_LEAST, END_SIZE,
    FINE_ELEMENTS, FINE_LAYERS, GROWTH, LOWER_THICKNESS, PLATE_SIZE, ROLLER_SIZE, ROLLER_WALL,
    ROLLINGS, SCALE, SOLID, STAGES, UNLOAD, UNLOAD_TO, UPPER_THICKNESS, WALL_CAP, WALL_LEAST,
};
use super::{Keys, key};

pub const LINE_BEARING: Keys = Keys {
    heading: "[line_bearing]",
    about: "One to twelve parallel rollers between two plates, along y, side by side along x. Forces are those of the \
            whole bearing. Rollers are `roller`, or `roller_1`, `roller_2` and so on from the lowest x; plates are \
            `upper_plate` and `lower_plate`.",
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
            "Coulomb's coefficient of all interfaces",
        ),
        key("rollers", "whole number, 1 to 12", "1", "how many rollers"),
        key(
            "spacing",
            "length",
            "required with two rollers or more",
            "distance between the axes of neighbours",
        ),
        key("roller_diameter", "length", "required", "D, of all rollers"),
        ROLLER_WALL,
        SOLID,
        key("roller_length", "length", "required", "L, of all rollers"),
        key(
            "roller_end",
            "`\"square\"` or a table",
            "`\"square\"`",
            "shape of the ends; a square one is a singular point where a plate stands out beyond it",
        ),
        key(
            "plate_thickness",
            "length, or a table",
            "required",
            "of both plates, or of each; of a curved one at the line of contact",
        ),
        key(
            "plate_size",
            "length, a list of two, or a table",
            "3/4 D beyond the outermost axes along x, L along y",
            "of both plates along x and y, or of each",
        ),
        key(
            "plate_curve",
            "table",
            "none",
            "one of the plates a cylinder along the roller; with a single roller",
        ),
        key(
            "full",
            "true or false",
            "false",
            "make no use of the mirror planes x = 0 and y = 0",
        ),
        UNLOAD,
        UNLOAD_TO,
        STAGES,
        ROLLINGS,
    ],
};

pub const LINE_PLATE_THICKNESS: Keys = Keys {
    heading: "line_bearing.plate_thickness",
    about: "Where the plates differ.",
    keys: &[UPPER_THICKNESS, LOWER_THICKNESS],
};

pub const LINE_PLATE_SIZE: Keys = Keys {
    heading: "line_bearing.plate_size",
    about: "Where the plates differ.",
    keys: &[
        key(
            "upper",
            "length, or a list of two",
            "required",
            "of the upper plate along x and y",
        ),
        key(
            "lower",
            "length, or a list of two",
            "required",
            "of the lower plate along x and y",
        ),
    ],
};

pub const LINE_PLATE_CURVE: Keys = Keys {
    heading: "line_bearing.plate_curve",
    about: "The effective radius R' of the contact follows from 1/R' = 2/D + 1/r where the face bulges, and from 1/R' = \
            2/D - 1/r in a groove.",
    keys: &[
        key(
            "plate",
            "`upper` or `lower`",
            "required",
            "which of the two",
        ),
        key("radius", "length", "required", "r, of the face"),
        key(
            "sense",
            "`convex` or `concave`",
            "required",
            "bulging towards the roller, or a groove that the roller lies in",
        ),
    ],
};

pub const LINE_BEARING_MESH: Keys = Keys {
    heading: "[mesh] of a line bearing",
    about: "As of a bearing of crossed rollers, but for what parallel ones do not have.",
    keys: &[
        key(
            "preset",
            "`auto`, `h025` or `h0125`",
            "`auto`",
            "three elements or more across the half-width of every line of contact, meshed once more \
             where the solution finds another width than an even load makes; D/120 across the lines; half of that",
        ),
        SCALE,
        ROLLER_SIZE,
        PLATE_SIZE,
        FINE_ELEMENTS,
        FINE_LAYERS,
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
            "largest element in plan, of the plates",
        ),
        DEPTH_CAP,
        WALL_LEAST,
        DEPTH_LEAST,
        key(
            "along_least",
            "whole number",
            "of the preset",
            "fewest elements along half a roller",
        ),
    ],
};
