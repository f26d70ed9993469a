//! Keys of a bearing.

use super::template_loads::{ECCENTRICITY, HORIZONTAL, MOMENT, TOP};
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
        key(
            "roller_wall",
            "length",
            "required unless `solid`",
            "wall of hollow rollers",
        ),
        key("solid", "true or false", "false", "rollers without a bore"),
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

pub const PLATE_THICKNESS: Keys = Keys {
    heading: "bearing.plate_thickness",
    about: "Where the plates differ.",
    keys: &[
        key("upper", "length", "required", "of the upper plate"),
        key(
            "intermediate",
            "length",
            "required",
            "of the intermediate plate, where its valleys cross",
        ),
        key("lower", "length", "required", "of the lower plate"),
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
            "crossing_size",
            "length",
            "of the preset",
            "element size along a roller where the other one crosses",
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
            "largest element in plan, in the outer plates",
        ),
        key(
            "middle_cap",
            "length",
            "of the preset",
            "largest element in plan, in the intermediate plate",
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
            "fewest elements along half a roller of a centred bearing",
        ),
    ],
};
