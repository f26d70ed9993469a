//! What can be wrong with a mesh file, and what to do about it.

use miette::Diagnostic;
use thiserror::Error;

use super::place::{At, FilePlace};

const EXPORT: &str = "write the mesh again, for example with `gmsh -3 -format msh41 -bin`";

/// Why a mesh file was refused.
#[derive(Debug, Error, Diagnostic)]
pub enum MeshError {
    /// The file cannot be read.
    #[error("{source_name}: cannot read the mesh file")]
    #[diagnostic(code(brinell::mesh::read), help("check the path and the permissions"))]
    Read {
        /// Name of the file.
        source_name: String,
        /// What the system says.
        source: std::io::Error,
    },

    /// It is damaged or cut off.
    #[error("{source_name}: the gzip compression is damaged or cut off: {reason}")]
    #[diagnostic(code(brinell::mesh::gzip), help("copy or compress the file again"))]
    Gzip {
        /// Name of the file.
        source_name: String,
        /// Why, in words.
        reason: String,
    },

    /// It is no mesh of gmsh.
    #[error(
        "{source_name}: not a gmsh mesh, for it does not begin with a section such as $MeshFormat"
    )]
    #[diagnostic(code(brinell::mesh::not_msh), help("{EXPORT}"))]
    NotMsh {
        /// Name of the file.
        source_name: String,
    },

    /// A version or kind of MSH that is not read.
    #[error("{place}: MSH {what} is not supported")]
    #[diagnostic(
        code(brinell::mesh::version),
        help("MSH 4.1 and 2.2 are read: `gmsh -format msh41` or `-format msh22` writes them")
    )]
    Version {
        /// Where in the file.
        place: FilePlace,
        /// What is meant, in words.
        what: String,
    },

    /// Something else stands where a number or name should.
    #[error("{place}: {expected} expected, found {found}")]
    #[diagnostic(code(brinell::mesh::syntax), help("the file is damaged: {EXPORT}"))]
    Syntax {
        /// Where in the file.
        place: FilePlace,
        /// What should stand there.
        expected: String,
        /// What stands there.
        found: String,
    },

    /// The file ends too early.
    #[error("{place}: the file ends where {expected} is expected")]
    #[diagnostic(code(brinell::mesh::truncated), help("the file is cut off: {EXPORT}"))]
    Truncated {
        /// Where in the file.
        place: FilePlace,
        /// What should stand there.
        expected: String,
    },

    /// A count is wrong.
    #[error("{place}: {count} {what} are announced, {found}")]
    #[diagnostic(
        code(brinell::mesh::count),
        help("the count is wrong or data are missing: {EXPORT}")
    )]
    Count {
        /// Where in the file.
        place: FilePlace,
        /// What is meant, in words.
        what: &'static str,
        /// How many.
        count: u64,
        /// What stands there.
        found: String,
    },

    /// There is more than was announced.
    #[error("{place}: data after the end of what the header announces: {found}")]
    #[diagnostic(code(brinell::mesh::surplus), help("the count is too small: {EXPORT}"))]
    Surplus {
        /// Where in the file.
        place: FilePlace,
        /// What stands there.
        found: String,
    },

    /// A section is missing.
    #[error("{source_name}: there is no ${section} section")]
    #[diagnostic(code(brinell::mesh::missing_section), help("{EXPORT}"))]
    MissingSection {
        /// Name of the file.
        source_name: String,
        /// Name of the section.
        section: &'static str,
    },

    /// A section is there twice.
    #[error("{place}: the section is there a second time")]
    #[diagnostic(code(brinell::mesh::repeated_section), help("keep one of the two"))]
    RepeatedSection {
        /// Where in the file.
        place: FilePlace,
    },

    /// A tag is there twice.
    #[error("{place}: {what} {tag} is there already, at {first}")]
    #[diagnostic(
        code(brinell::mesh::duplicate_tag),
        help("renumber so that every tag is used once")
    )]
    DuplicateTag {
        /// Where in the file.
        place: FilePlace,
        /// What is meant, in words.
        what: &'static str,
        /// Its tag.
        tag: String,
        /// Where, or which, was there first.
        first: At,
    },

    /// A physical name is there twice.
    #[error("{source_name}: two physical {kind}s are called `{name}`")]
    #[diagnostic(code(brinell::mesh::duplicate_name), help("rename one of them"))]
    DuplicateName {
        /// Name of the file.
        source_name: String,
        /// Its kind.
        kind: &'static str,
        /// Its name.
        name: String,
    },

    /// A coordinate is no number.
    #[error("{place}: coordinate {axis} of node {node} is {value}")]
    #[diagnostic(
        code(brinell::mesh::not_finite),
        help("node coordinates must be finite numbers")
    )]
    NotFinite {
        /// Where in the file.
        place: FilePlace,
        /// Tag of the node.
        node: u64,
        /// The axis: x, y or z.
        axis: char,
        /// The number.
        value: f64,
    },

    /// An element uses a node that does not exist.
    #[error("{place}: element {element} uses node {node}, which does not exist")]
    #[diagnostic(
        code(brinell::mesh::unknown_node),
        help("add the node to $Nodes or take the element out of $Elements")
    )]
    UnknownNode {
        /// Where in the file.
        place: FilePlace,
        /// The element.
        element: u64,
        /// Tag of the node.
        node: u64,
    },

    /// Elements belong to an entity that does not exist.
    #[error("{place}: {entity}, which the elements here belong to, is not in $Entities")]
    #[diagnostic(code(brinell::mesh::unknown_entity), help("{EXPORT}"))]
    UnknownEntity {
        /// Where in the file.
        place: FilePlace,
        /// The entity of the geometry, in words.
        entity: String,
    },

    /// There are no volume elements.
    #[error("{source_name}: there are no volume elements")]
    #[diagnostic(
        code(brinell::mesh::no_volumes),
        help("mesh the volumes (`gmsh -3`) and put each into a physical volume")
    )]
    NoVolumes {
        /// Name of the file.
        source_name: String,
    },

    /// There are no bodies.
    #[error("{source_name}: there is no physical volume")]
    #[diagnostic(
        code(brinell::mesh::no_physical_volume),
        help(
            "name each body, in the .geo file: `Physical Volume(\"roller\") = {{1}};` (gmsh writes \
             no groups to MSH 2.2 where `Mesh.SaveAll` is set)"
        )
    )]
    NoPhysicalVolume {
        /// Name of the file.
        source_name: String,
    },

    /// An element belongs to no body.
    #[error("{place}: element {element} of {entity} belongs to no physical volume")]
    #[diagnostic(
        code(brinell::mesh::ungrouped_volume),
        help("add the volume to the physical volume of its body, or leave it out of the mesh")
    )]
    UngroupedVolume {
        /// Where in the file.
        place: FilePlace,
        /// The element.
        element: u64,
        /// The entity of the geometry, in words.
        entity: String,
    },

    /// An element belongs to several bodies.
    #[error("{place}: element {element} of {entity} belongs to several physical volumes: {names}")]
    #[diagnostic(
        code(brinell::mesh::several_volumes),
        help("a volume is part of exactly one body: keep one of the groups")
    )]
    SeveralVolumes {
        /// Where in the file.
        place: FilePlace,
        /// The element.
        element: u64,
        /// The entity of the geometry, in words.
        entity: String,
        /// Their names.
        names: String,
    },

    /// A body or surface has no elements.
    #[error("{source_name}: physical {kind} `{name}` (tag {tag}) has no elements{part}")]
    #[diagnostic(
        code(brinell::mesh::empty_group),
        help("mesh its {kind}s, or take the group out of the geometry")
    )]
    EmptyGroup {
        /// Name of the file.
        source_name: String,
        /// Its kind.
        kind: &'static str,
        /// Its name.
        name: String,
        /// Its tag.
        tag: i64,
        /// What is known of it besides, in words.
        part: String,
    },

    /// A body has elements that are no hexahedra.
    #[error(
        "{place}: element {element} of physical volume `{body}` is a {kind}, not an eight-node hexahedron"
    )]
    #[diagnostic(
        code(brinell::mesh::not_hexahedron),
        help(
            "use transfinite or extruded volumes with `Recombine`, of first order (`Mesh.ElementOrder = 1;`)"
        )
    )]
    NotHexahedron {
        /// Where in the file.
        place: FilePlace,
        /// The element.
        element: u64,
        /// Name of the body.
        body: String,
        /// Its kind.
        kind: &'static str,
    },

    /// A surface has elements that are no quadrilaterals.
    #[error(
        "{place}: element {element} of physical surface `{surface}` is a {kind}, not a four-node quadrilateral"
    )]
    #[diagnostic(
        code(brinell::mesh::not_quadrilateral),
        help("use `Recombine Surface`, of first order (`Mesh.ElementOrder = 1;`)")
    )]
    NotQuadrilateral {
        /// Where in the file.
        place: FilePlace,
        /// The element.
        element: u64,
        /// Name of the surface.
        surface: String,
        /// Its kind.
        kind: &'static str,
    },

    /// A hexahedron has no volume.
    #[error("{place}: element {element} of physical volume `{body}` is degenerate: {why}")]
    #[diagnostic(
        code(brinell::mesh::degenerate),
        help(
            "every hexahedron needs eight different nodes and a volume: move or merge the nodes differently"
        )
    )]
    Degenerate {
        /// Where in the file.
        place: FilePlace,
        /// The element.
        element: u64,
        /// Name of the body.
        body: String,
        /// Why, in words.
        why: String,
    },

    /// A hexahedron is folded.
    #[error(
        "{place}: element {element} of physical volume `{body}` is inverted: scaled Jacobian {jacobian:.3} at node {node}"
    )]
    #[diagnostic(
        code(brinell::mesh::inverted),
        help(
            "the element is folded or numbered backwards: mesh the volume with less distortion or smaller elements"
        )
    )]
    Inverted {
        /// Where in the file.
        place: FilePlace,
        /// The element.
        element: u64,
        /// Name of the body.
        body: String,
        /// Tag of the node.
        node: u64,
        /// Scaled Jacobian there.
        jacobian: f64,
    },

    /// A hexahedron is there twice.
    #[error(
        "{place}: elements {first} and {element} are the same hexahedron, in physical volumes {bodies}"
    )]
    #[diagnostic(
        code(brinell::mesh::repeated_element),
        help("put every volume into exactly one physical volume")
    )]
    RepeatedElement {
        /// Where in the file.
        place: FilePlace,
        /// The element.
        element: u64,
        /// Where, or which, was there first.
        first: u64,
        /// Names of their bodies.
        bodies: String,
    },

    /// A node is used by no body, or wrongly.
    #[error("{place}: node {node}{owner} {use_of_it}")]
    #[diagnostic(
        code(brinell::mesh::unused_node),
        help("take the node out of the mesh, or mesh the volume it should belong to")
    )]
    UnusedNode {
        /// Where in the file.
        place: FilePlace,
        /// Tag of the node.
        node: u64,
        /// What it belongs to, in words.
        owner: String,
        /// How it is used, in words.
        use_of_it: String,
    },

    /// An element of a surface is no outer face of a body.
    #[error("{place}: element {element} of physical surface `{surface}` {why}")]
    #[diagnostic(
        code(brinell::mesh::surface_face),
        help("a physical surface is made of outer faces of hexahedra, each once")
    )]
    SurfaceFace {
        /// Where in the file.
        place: FilePlace,
        /// The element.
        element: u64,
        /// Name of the surface.
        surface: String,
        /// Why, in words.
        why: String,
    },

    /// The mesh is too large.
    #[error("{source_name}: {count} {what} are more than the {limit} that fit")]
    #[diagnostic(code(brinell::mesh::too_large), help("use a coarser mesh"))]
    TooLarge {
        /// Name of the file.
        source_name: String,
        /// How many.
        count: u64,
        /// The largest number that fits.
        limit: u64,
        /// What is meant, in words.
        what: &'static str,
    },
}
