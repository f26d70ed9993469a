//! Keys of every case.

use super::{Keys, key};

pub const ROOT: Keys = Keys {
    heading: "The top of the file",
    about: "Before the first table.",
    keys: &[
        key(
            "title",
            "text",
            "the name of the file",
            "heads the tables and the files",
        ),
        key(
            "description",
            "text",
            "none",
            "for readers; printed nowhere",
        ),
        key(
            "units",
            "`in-kip-ksi`, `in-lbf-psi`, `mm-N-MPa`, `mm-kN-GPa` or `m-N-Pa`",
            "required",
            "the units of all answers, and of bare numbers; quantities in other units are converted",
        ),
        key(
            "reference",
            "`section-2.6.2`, `prototype-1`, `prototype-2`, `chapter-5` or `ncree`",
            "none",
            "the published study that the case belongs to: its discrepancies are printed with the answer",
        ),
        key(
            "bearing",
            "table",
            "none",
            "two crossed rollers by their dimensions; with neither this nor `line_bearing` the case is a general scene",
        ),
        key(
            "line_bearing",
            "table",
            "none",
            "parallel rollers between two plates by their dimensions",
        ),
        key(
            "steel",
            "table, or the name of a grade",
            "none",
            "the steel of all bodies, and of single ones; `steel = \"S355\"` is `[steel]` with `grade = \"S355\"`",
        ),
        key(
            "grades",
            "path, from the folder of the case",
            "none",
            "a file with steel grades of your own, as in [Steels by name](steels.md)",
        ),
        key(
            "mesh",
            "table",
            "preset `auto` of a bearing; required in a scene",
            "the mesh",
        ),
        key(
            "controls",
            "table",
            "all defaults",
            "tolerances and increments",
        ),
        key(
            "comparison",
            "table",
            "none",
            "printed values to set beside the answer; they decide nothing",
        ),
        key(
            "action",
            "list of tables",
            "none",
            "what acts, for combinations",
        ),
        key(
            "combination",
            "list of tables",
            "none",
            "actions with factors, each combination a case of its own",
        ),
        key(
            "title_block",
            "table",
            "none",
            "whose calculation it is, at the head of `report.html`",
        ),
    ],
};

pub const ACTION: Keys = Keys {
    heading: "[[action]]",
    about: "What acts, at its characteristic value. In a bearing it is a vertical load, and `bearing.load` is left out; in \
            a general scene it is some of the supports, planes, pressures and tractions by name, and `step` is left out.",
    keys: &[
        key("name", "text", "required", "for `combination.factors`"),
        key(
            "load",
            "force",
            "required of a bearing",
            "vertical, on the top face",
        ),
        key(
            "loads",
            "list of names",
            "required of a general scene",
            "what acts; an action that a combination does not name does not act in it, and what belongs to no action acts with factor 1",
        ),
    ],
};

pub const COMBINATION: Keys = Keys {
    heading: "[[combination]]",
    about: "Actions with their factors, as in EN 1990. `brinell run` solves each combination by itself, for contact is not \
            linear, and names the one that governs.",
    keys: &[
        key(
            "name",
            "text",
            "required",
            "of the combination, and of its folder",
        ),
        key(
            "factors",
            "table of shares by name of an action",
            "required",
            "such as `{ permanent = 1.35, traffic = 1.5 }`",
        ),
    ],
};

pub const TITLE_BLOCK: Keys = Keys {
    heading: "[title_block]",
    about: "Heads the page `report.html`, and is in `summary.json`. What is left out stays blank there, to be filled in by hand.",
    keys: &[
        key("project", "text", "blank", "the structure or the order"),
        key("part", "text", "blank", "what is calculated"),
        key("document", "text", "blank", "the number of the calculation"),
        key("revision", "text", "blank", "its revision"),
        key(
            "date",
            "text, such as `\"2026-11-24\"`",
            "blank",
            "its date",
        ),
        key("prepared", "text", "blank", "who made it"),
        key("checked", "text", "blank", "who checked it"),
        key("approved", "text", "blank", "who approved it"),
    ],
};

pub const STEEL: Keys = Keys {
    heading: "[steel]",
    about: "The default of all bodies; `[steel.NAME]` has what the body NAME has otherwise. Isotropic, with a straight hardening line: one of `hardening`, `hardening_modulus` and \
            `tangent_modulus`. What is given here goes before what the grade has.",
    keys: &[
        key(
            "grade",
            "name, as in [Steels by name](steels.md)",
            "none",
            "has E, ν, and as far as known yield stress, ultimate strength and hardness",
        ),
        key(
            "thickness",
            "length",
            "of a bearing: that of the plate, the diameter of the roller",
            "of the product as delivered, by which the strength of a grade goes",
        ),
        key("youngs_modulus", "stress", "of the grade", "E"),
        key(
            "poissons_ratio",
            "share, between -1 and 0.5",
            "of the grade",
            "ν",
        ),
        key(
            "yield_stress",
            "stress",
            "of the grade; else required unless `elastic`",
            "in uniaxial tension",
        ),
        key(
            "hardening",
            "table",
            "none",
            "a second point of the uniaxial curve beyond yield",
        ),
        key(
            "hardening_modulus",
            "stress",
            "0, perfectly plastic",
            "H = dσ/dε_p, stress over plastic strain",
        ),
        key(
            "tangent_modulus",
            "stress, less than E",
            "none",
            "E_t = dσ/dε, stress over total strain; 1/E_t = 1/E + 1/H",
        ),
        key("elastic", "true or false", "false", "never yields"),
        key(
            "ultimate_strength",
            "stress",
            "of the grade",
            "f_u, for design rules",
        ),
        key(
            "hardness",
            "number",
            "of the grade",
            "Brinell hardness HB of the surface, for design rules",
        ),
        key(
            "surface_hardened",
            "true or false",
            "false",
            "is the surface harder than the core, which the yield stress is of? For design rules",
        ),
        key(
            "expansion",
            "expansion, as in `12e-6 1/K`",
            "12e-6 1/K, said as assumed where a body has a temperature",
            "coefficient of thermal expansion",
        ),
    ],
};

pub const HARDENING: Keys = Keys {
    heading: "steel.hardening",
    about: "Such as `hardening = { stress = \"138 ksi\", strain = 0.157, strain_is = \"total\" }`.",
    keys: &[
        key("stress", "stress", "required", "above the yield stress"),
        key("strain", "share", "required", "at that stress"),
        key(
            "strain_is",
            "`total` or `plastic`",
            "`total`",
            "which strain that is",
        ),
    ],
};

pub const CONTROLS: Keys = Keys {
    heading: "[controls]",
    about: "All relative and without units; the defaults suit every case that is shipped.",
    keys: &[
        key(
            "residual",
            "share, at most 1",
            "1e-8",
            "forces that are left over, of the applied force; where rounding leaves more, that, up to 1e-5",
        ),
        key(
            "penetration",
            "share, at most 1",
            "1e-8",
            "largest penetration, of the largest displacement",
        ),
        key(
            "first_increment",
            "share, at most 1",
            "0.25",
            "first increment of a step, of the step, and a third of the largest one; where nothing depends \
             on the path a step is one increment",
        ),
        key(
            "increment_error",
            "true or false",
            "true",
            "where steel yields, solves once more in increments twice as large, for what the increments \
             are worth",
        ),
        key(
            "smallest_increment",
            "share, at most `first_increment`",
            "1e-4",
            "an increment is not cut back below this",
        ),
        key(
            "iterations",
            "whole number, 1 or more",
            "40",
            "Newton iterations before an increment is cut back; twice as many while they come nearer steadily",
        ),
        key(
            "plasticity",
            "true or false",
            "true",
            "false keeps every body elastic",
        ),
        key(
            "half_turn",
            "true or false",
            "true",
            "of a scene that is its own image under a half turn one half is solved; false solves both",
        ),
        key(
            "element",
            "`bbar`, `enhanced` or `full`",
            "`bbar`",
            "element-mean dilatation; incompatible modes, where one or two elements bend; plain, to \
             compare with other programs",
        ),
        key(
            "solver",
            "`auto`, `direct` or `divided`",
            "`auto`",
            "a factor of the condensed bodies, or many small ones: the least memory",
        ),
    ],
};

pub const COMPARISON: Keys = Keys {
    heading: "[comparison]",
    about: "Places of `mises` are bodies, `overall`, `rollers` or `plates`, those of `max_pressure` interfaces or \
            `overall`: `mises = { overall = \"70 ksi\" }`.",
    keys: &[
        key("source", "text", "none", "where the values were printed"),
        key(
            "mises_read",
            "`centroid`, `integration_point` or `nodal`",
            "`centroid`",
            "which reading stands beside the printed Mises stress",
        ),
        key(
            "mises",
            "table of stresses by place",
            "none",
            "largest Mises stresses",
        ),
        key(
            "max_pressure",
            "table of stresses by place",
            "none",
            "largest contact pressures",
        ),
        key(
            "descent",
            "length",
            "none",
            "motion of the top face since all interfaces just touched",
        ),
    ],
};
