//! Keys of a general scene.

use super::{Key, Keys, key};

pub const SCENE: Keys = Keys {
    heading: "Beside those of every case",
    about: "Bodies are the physical volumes of the mesh, surfaces its physical surfaces.",
    keys: &[
        key(
            "body",
            "list of tables",
            "all bodies of the mesh",
            "bodies with a steel of their own",
        ),
        key(
            "contact",
            "list of tables",
            "none",
            "pairs of surfaces that may touch",
        ),
        key(
            "tie",
            "list of tables",
            "none",
            "pairs of surfaces that are joined, though their meshes do not match",
        ),
        key(
            "support",
            "list of tables",
            "none",
            "surfaces that are held or displaced",
        ),
        key(
            "rigid_plane",
            "list of tables",
            "none",
            "surfaces that move as one, held, displaced, turned or driven by a force",
        ),
        key(
            "pressure",
            "list of tables",
            "none",
            "pressures on surfaces",
        ),
        key(
            "traction",
            "list of tables",
            "none",
            "forces per area on surfaces",
        ),
        key(
            "temperature",
            "list of tables",
            "none",
            "differences of temperature of bodies",
        ),
        key(
            "step",
            "list of tables",
            "one, to the full load",
            "loading in steps",
        ),
        key(
            "symmetry",
            "list of `x`, `y`, `z`",
            "none",
            "axes whose coordinate plane mirrors the model: the mesh is on the positive side of it, all faces \
             in it are held square to it, and forces are given for the whole",
        ),
    ],
};

pub const FILE_MESH: Keys = Keys {
    heading: "[mesh] of a scene",
    about: "A file of gmsh, MSH 4.1 or 2.2, text or binary, plain or gzip, of linear hexahedra.",
    keys: &[
        key(
            "file",
            "text",
            "required",
            "path, relative to the folder of the case",
        ),
        key(
            "unit",
            "unit of length",
            "that of the case",
            "what the coordinates are in",
        ),
    ],
};

pub const FAMILY_MESH: Keys = Keys {
    heading: "[mesh] that is built in",
    about: "In place of a file.",
    keys: &[
        key("family", "`problem-h`", "required", "which"),
        key(
            "level",
            "whole number, 1 to 8",
            "2",
            "2 x 2^level elements across the half-width",
        ),
    ],
};

pub const BODY: Keys = Keys {
    heading: "[[body]]",
    about: "Optional: for a steel of its own, or so that a body that is missing from the mesh is told.",
    keys: &[
        key("name", "text", "required", "of the physical volume"),
        key(
            "steel",
            "table as [steel], or the name of a grade",
            "[steel]",
            "what the body has otherwise",
        ),
    ],
};

/// What entries on surfaces have in common.
const NAME: Key = key("name", "text", "that of the surface", "for `step.factors`");

const SURFACE: Key = key("surface", "text", "required", "of the mesh");

const FIXED: Key = key(
    "fixed",
    "some of the letters xyz",
    "none",
    "components that stay",
);

const DISPLACEMENT: Key = key(
    "displacement",
    "table by axis of lengths",
    "none",
    "components that are displaced, at factor one",
);

pub const SUPPORT: Keys = Keys {
    heading: "[[support]]",
    about: "Holds or displaces the nodes of a surface.",
    keys: &[NAME, SURFACE, FIXED, DISPLACEMENT],
};

pub const RIGID_PLANE: Keys = Keys {
    heading: "[[rigid_plane]]",
    about: "A surface that moves as one: along each axis that is fixed, displaced or driven, as a rigid plane does. It \
            does not turn unless it is told to. Reactions, moments and angles are about its point.",
    keys: &[
        NAME,
        SURFACE,
        FIXED,
        DISPLACEMENT,
        key(
            "force",
            "table by axis of forces",
            "none",
            "components that are driven by this force on the whole, at factor one",
        ),
        key(
            "rotation",
            "table by axis of angles",
            "none",
            "small angles that it is turned by, at factor one, as in `{ x = \"2 mrad\" }`",
        ),
        key(
            "turns",
            "some of the letters xyz",
            "none",
            "axes that it is free to turn about; a force then acts at the point `about`",
        ),
        key(
            "moment",
            "table by axis of moments",
            "0",
            "moments on the whole about axes that it is free to turn about, at factor one",
        ),
        key(
            "about",
            "list of three lengths",
            "the middle of the box around the surface",
            "the point that it turns about, at which forces act and which moments are about",
        ),
    ],
};

pub const LOAD: Keys = Keys {
    heading: "[[pressure]], [[traction]]",
    about: "Forces per area, which keep their directions.",
    keys: &[
        NAME,
        SURFACE,
        key(
            "value",
            "stress of a pressure, list of three stresses of a traction",
            "required",
            "a pressure is positive in compression, a traction along the axes",
        ),
    ],
};

pub const TEMPERATURE: Keys = Keys {
    heading: "[[temperature]]",
    about: "By how much a body is warmer than where it is free of stress: a difference, not a reading. Also in a `[bearing]`.",
    keys: &[
        key("name", "text", "that of the body", "for `step.factors`"),
        key("body", "text", "required", "of the mesh"),
        key(
            "value",
            "difference of temperature",
            "0",
            "in the middle of the box around the body, at factor one: `\"20 K\"`, `\"36 degF\"`",
        ),
        key(
            "gradient",
            "list of three differences of temperature per length",
            "none",
            "its change along x, y and z, as in `[0, 0, \"0.1 K/mm\"]`",
        ),
    ],
};

/// What an entry by axis takes.
const BY_AXIS: &str = "length, force, angle or moment";

pub const AXES: Keys = Keys {
    heading: "displacement, force, rotation, moment",
    about: "Of supports and rigid planes: `force = { z = \"-40 N\" }`.",
    keys: &[
        key("x", BY_AXIS, "none", "along or about x"),
        key("y", BY_AXIS, "none", "along or about y"),
        key("z", BY_AXIS, "none", "along or about z"),
    ],
};

pub const STEP: Keys = Keys {
    heading: "[[step]]",
    about: "Loads and displacements move linearly to these factors, one step after the other.",
    keys: &[
        key("name", "text", "required", "of the step in all results"),
        key(
            "factor",
            "share",
            "1",
            "of everything that `factors` does not name",
        ),
        key(
            "factors",
            "table of shares by name of a support, plane or load",
            "none",
            "factors of their own",
        ),
    ],
};
