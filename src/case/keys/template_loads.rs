//! Keys of loads that templates have in common.

use super::{Key, Keys, key};

pub(super) const ECCENTRICITY: Key = key(
    "eccentricity",
    "list of two lengths",
    "[0, 0]",
    "where the load acts, along x and y from the middle of the top; with `top = \"free\"`",
);

pub(super) const HORIZONTAL: Key = key(
    "horizontal",
    "list of two forces",
    "none: the top does not move sideways",
    "along x and y, on the top; it moves along an axis with a force",
);

pub(super) const MOMENT: Key = key(
    "moment",
    "list of two moments",
    "[0, 0]",
    "about x and y, on the top; with `top = \"free\"`",
);

pub(super) const TOP: Key = key(
    "top",
    "`held`, `free` or a table with `tilt`",
    "`held`",
    "does the top turn about x and y: not, under the moments, or by given angles; about the middle of the axes of parallel \
     rollers, about the lower face of the upper plate of crossed ones",
);

pub(super) const SKEW: Key = key(
    "skew",
    "angle, or a list of one for each roller",
    "0",
    "rollers askew: turned about the vertical through their middles, by the right hand about +z; up to 0.1 rad; the upper \
     and the lower of crossed rollers; lengths are measured along the plates",
);

pub const TILTED_TOP: Keys = Keys {
    heading: "bearing.top, line_bearing.top",
    about: "A top that is turned by given small angles: `top = { tilt = [\"2 mrad\", \"0 mrad\"] }`.",
    keys: &[key(
        "tilt",
        "list of two angles",
        "required",
        "about x and y; up to 0.1 rad",
    )],
};
