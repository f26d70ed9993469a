//! Keys that templates have in common, beside their loads: of rollers, of the way of the load, and of meshes.

use super::{Key, key};

pub(super) const ROLLER_WALL: Key = key(
    "roller_wall",
    "length",
    "required unless `solid`",
    "wall of hollow rollers",
);

pub(super) const SOLID: Key = key("solid", "true or false", "false", "rollers without a bore");

pub(super) const UNLOAD: Key = key(
    "unload",
    "true or false",
    "false",
    "take the load off again in the end, and print the dents that stay",
);

pub(super) const UNLOAD_TO: Key = key(
    "unload_to",
    "share between 0 and 0.05",
    "0.001",
    "load that is left after unloading, of the load",
);

pub(super) const STAGES: Key = key(
    "stages",
    "list of forces, ascending, less than `load`",
    "none",
    "loads at which the descent is read on the way up",
);

pub(super) const ROLLINGS: Key = key(
    "rollings",
    "number",
    "none",
    "how often a point of the surfaces is rolled over under the full load, for design rules of fatigue",
);

pub(super) const SCALE: Key = key(
    "scale",
    "share from 0.02 to 5",
    "1",
    "every element this many times as large",
);

pub(super) const ROLLER_SIZE: Key = key(
    "roller_size",
    "length",
    "of the preset",
    "element size across the lines of contact, on the rollers",
);

pub(super) const UPPER_THICKNESS: Key = key("upper", "length", "required", "of the upper plate");

pub(super) const LOWER_THICKNESS: Key = key("lower", "length", "required", "of the lower plate");

pub(super) const PLATE_SIZE: Key = key(
    "plate_size",
    "length",
    "1.06 of `roller_size`",
    "the same on the plates",
);

pub(super) const FINE_ELEMENTS: Key = key(
    "fine_elements",
    "whole number",
    "of the preset",
    "elements of that size on either side of a line",
);

pub(super) const FINE_LAYERS: Key = key(
    "fine_layers",
    "whole number",
    "of the preset",
    "layers of that size below a contact face",
);

pub(super) const END_SIZE: Key = key(
    "end_size",
    "length",
    "of the preset",
    "element size along a roller at its ends",
);

pub(super) const GROWTH: Key = key(
    "growth",
    "share, 1 to 10",
    "of the preset",
    "largest ratio of neighbouring elements across the lines",
);

pub(super) const DEPTH_GROWTH: Key = key(
    "depth_growth",
    "share, 1 to 10",
    "of the preset",
    "the same into the depth",
);

pub(super) const ALONG_GROWTH: Key = key(
    "along_growth",
    "share, 1 to 10",
    "of the preset",
    "the same along the rollers",
);

pub(super) const AROUND_CAP: Key = key(
    "around_cap",
    "length",
    "of the preset",
    "largest element around a roller",
);

pub(super) const ALONG_CAP: Key = key(
    "along_cap",
    "length",
    "of the preset",
    "largest element along a roller",
);

pub(super) const WALL_CAP: Key = key(
    "wall_cap",
    "length",
    "of the preset",
    "largest element through the wall",
);

pub(super) const DEPTH_CAP: Key = key(
    "depth_cap",
    "length",
    "of the preset",
    "largest element through the plates",
);

pub(super) const WALL_LEAST: Key = key(
    "wall_least",
    "whole number",
    "of the preset",
    "fewest elements through the wall",
);

pub(super) const DEPTH_LEAST: Key = key(
    "depth_least",
    "whole number",
    "of the preset",
    "fewest elements through a plate",
);
