//! Why what was described is no scene.

use crate::model::mesh::block::BlockError;
use crate::model::mesh::family::FamilyError;
use crate::model::mesh::join::JoinError;
use crate::model::mesh::msh::MeshError;

/// Why what was described is no scene. Every message names the body, the surface or the load that is meant.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum BuildError {
    /// No body was given.
    #[error("the scene `{scene}` has no bodies")]
    #[diagnostic(code(brinell::build::empty), help("add one with `SceneBuilder::body`"))]
    Empty {
        /// Name of the scene.
        scene: String,
    },
    /// A body has no steel.
    #[error("the body `{body}` has no steel")]
    #[diagnostic(
        code(brinell::build::no_steel),
        help("name it in `SceneBuilder::steel`, or give all bodies of a mesh one with `body`")
    )]
    NoSteel {
        /// Name of the body.
        body: String,
    },
    /// A number is out of its range.
    #[error("{what} of `{of}` is {value}: it must be {allowed}")]
    #[diagnostic(
        code(brinell::build::number),
        help("look for a slip in the number or its unit")
    )]
    Number {
        /// What the number is, such as "Young's modulus".
        what: &'static str,
        /// Body, surface or load that it belongs to.
        of: String,
        /// The number.
        value: f64,
        /// The numbers that are allowed, in words.
        allowed: &'static str,
    },
    /// A name that the mesh does not have.
    #[error("`{user}` asks for the {kind} `{name}`, which no mesh has")]
    #[diagnostic(code(brinell::build::unknown), help("there are: {known}"))]
    Unknown {
        /// Who asks: a contact, support, load, steel or step.
        user: String,
        /// "body", "surface" or "load".
        kind: &'static str,
        /// The name.
        name: String,
        /// All names of that kind.
        known: String,
    },
    /// Two of a kind have one name.
    #[error("there are two {kind}s called `{name}`")]
    #[diagnostic(
        code(brinell::build::twice),
        help("steps and answers call them by their names: give each its own")
    )]
    Twice {
        /// Such as "contact", "load", "tie", "step" or "factor".
        kind: &'static str,
        /// The name.
        name: String,
    },
    /// A contact or a tie joins what another one does, or a surface with itself.
    #[error("`{name}` joins the surfaces `{}` and `{}`, as `{other}` does", surfaces[0], surfaces[1])]
    #[diagnostic(
        code(brinell::build::same_sides),
        help("leave one of them out: both would carry half of the load")
    )]
    SameSides {
        /// The second one.
        name: String,
        /// The first one.
        other: String,
        /// Their surfaces.
        surfaces: [String; 2],
    },
    /// A contact or a tie of a surface with itself.
    #[error("`{name}` joins the surface `{surface}` with itself")]
    #[diagnostic(code(brinell::build::itself), help("name the surfaces of both sides"))]
    WithItself {
        /// The contact or tie.
        name: String,
        /// The surface.
        surface: String,
    },
    /// A mesh that was made or changed in code is not whole.
    #[error("the mesh {mesh} is not whole: {why}")]
    #[diagnostic(
        code(brinell::build::broken),
        help("look at what was changed; nodes and elements count from 0")
    )]
    Broken {
        /// Where the mesh came from.
        mesh: String,
        /// What is wrong.
        why: String,
    },
    /// A surface without faces.
    #[error("the surface `{name}` has no faces")]
    #[diagnostic(
        code(brinell::build::no_faces),
        help("look at the condition that marks it, or at the groups of the mesh file")
    )]
    NoFaces {
        /// Name of the surface.
        name: String,
    },
    /// The model is no half of a symmetric one.
    #[error(
        "the scene `{scene}` cannot be mirrored along {axis}: its nodes reach from {low} to {high}, with \
         {faces} faces on {axis} = 0"
    )]
    #[diagnostic(
        code(brinell::build::mirror),
        help("mesh what lies on the positive side of that plane, or leave `mirror` out")
    )]
    Mirror {
        /// Name of the scene.
        scene: String,
        /// Axis across which it is mirrored.
        axis: char,
        /// Smallest coordinate along it.
        low: f64,
        /// Largest coordinate along it.
        high: f64,
        /// Outer faces in the plane.
        faces: usize,
    },
    /// A load acts where the other half begins.
    #[error(
        "the load `{load}` acts on faces of the surface `{surface}` in the plane {axis} = 0, across which the scene is mirrored: these \
         are inside the whole"
    )]
    #[diagnostic(
        code(brinell::build::load_in_mirror),
        help("mark a surface without them, or leave `mirror` out if the body ends there")
    )]
    LoadInMirror {
        /// Name of the load.
        load: String,
        /// Its surface.
        surface: String,
        /// Axis across which the scene is mirrored.
        axis: char,
    },
    /// A block could not be meshed.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Block(#[from] BlockError),
    /// A cylinder could not be meshed.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Family(#[from] FamilyError),
    /// Bodies do not go into one mesh.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Join(#[from] JoinError),
    /// A mesh file could not be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Mesh(#[from] Box<MeshError>),
}
