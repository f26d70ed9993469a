//! Keys of parallel rollers.

use super::template_loads::{ECCENTRICITY, HORIZONTAL, MOMENT, TOP};
use super::{Keys, key};

pub const LINE_BEARING: Keys = Keys {
    heading: "[line_bearing]",
    about: "One to twelve parallel rollers between two plates, along y, side by side along x. Forces are those of the \
            whole bearing. Rollers are `roller`, or `roller_1`, `roller_2` and so on from the lowest x; plates are \
            `upper_plate` and `lower_plate`.",
    keys: &[
        key("load", "force", "required", "vertical, on the top face"),
        ECCENTRICITY,
        HORIZONTAL,
        MOMENT,
        TOP,
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
        key(
            "roller_wall",
            "length",
            "required unless `solid`",
            "wall of hollow rollers",
        ),
        key("solid", "true or false", "false", "rollers without a bore"),
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
        key(
            "unload",
            "true or false",
            "false",
            "take the load off again in the end, and print the dents that stay",
        ),
        key(
            "unload_to",
            "share between 0 and 0.05",
            "0.001",
            "load that is left after unloading, of the load",
        ),
        key(
            "stages",
            "list of forces, ascending, less than `load`",
            "none",
            "loads at which the descent is read on the way up",
        ),
        key(
            "rollings",
            "number",
            "none",
            "how often a point of the surfaces is rolled over under the full load, for design rules of fatigue",
        ),
    ],
};

pub const LINE_PLATE_THICKNESS: Keys = Keys {
    heading: "line_bearing.plate_thickness",
    about: "Where the plates differ.",
    keys: &[
        key("upper", "length", "required", "of the upper plate"),
        key("lower", "length", "required", "of the lower plate"),
    ],
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
        key(
            "scale",
            "share from 0.02 to 5",
            "1",
            "every element this many times as large",
        ),
        key(
            "roller_size",
            "length",
            "of the preset",
            "element size across the lines of contact, on the rollers",
        ),
        key(
            "plate_size",
            "length",
            "1.06 of `roller_size`",
            "the same on the plates",
        ),
        key(
            "fine_elements",
            "whole number",
            "of the preset",
            "elements of that size on either side of a line",
        ),
        key(
            "fine_layers",
            "whole number",
            "of the preset",
            "layers of that size below a contact face",
        ),
        key(
            "end_size",
            "length",
            "of the preset",
            "element size along a roller at its ends",
        ),
        key(
            "growth",
            "share, 1 to 10",
            "of the preset",
            "largest ratio of neighbouring elements across the lines",
        ),
        key(
            "depth_growth",
            "share, 1 to 10",
            "of the preset",
            "the same into the depth",
        ),
        key(
            "along_growth",
            "share, 1 to 10",
            "of the preset",
            "the same along the rollers",
        ),
        key(
            "around_cap",
            "length",
            "of the preset",
            "largest element around a roller",
        ),
        key(
            "along_cap",
            "length",
            "of the preset",
            "largest element along a roller",
        ),
        key(
            "wall_cap",
            "length",
            "of the preset",
            "largest element through the wall",
        ),
        key(
            "plan_cap",
            "length",
            "of the preset",
            "largest element in plan, of the plates",
        ),
        key(
            "depth_cap",
            "length",
            "of the preset",
            "largest element through the plates",
        ),
        key(
            "wall_least",
            "whole number",
            "of the preset",
            "fewest elements through the wall",
        ),
        key(
            "depth_least",
            "whole number",
            "of the preset",
            "fewest elements through a plate",
        ),
        key(
            "along_least",
            "whole number",
            "of the preset",
            "fewest elements along half a roller",
        ),
    ],
};
