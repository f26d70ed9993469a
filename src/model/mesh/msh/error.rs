//! What can be wrong with a mesh file, and what to do about it.

use miette::Diagnostic;
use thiserror::Error;

use super::place::{At, Place};

const EXPORT: &str = "write the mesh again, for example with `gmsh -3 -format msh41 -bin`";

/// Why a mesh file was refused.
#[derive(Debug, Error, Diagnostic)]
pub enum MeshError {
    #[error("{source_name}: cannot read the mesh file")]
    #[diagnostic(code(brinell::mesh::read), help("check the path and the permissions"))]
    Read {
        source_name: String,
        source: std::io::Error,
    },

    #[error("{source_name}: the gzip compression is damaged or cut off: {reason}")]
    #[diagnostic(code(brinell::mesh::gzip), help("copy or compress the file again"))]
    Gzip { source_name: String, reason: String },

    #[error(
        "{source_name}: not a gmsh mesh, for it does not begin with a section such as $MeshFormat"
    )]
    #[diagnostic(code(brinell::mesh::not_msh), help("{EXPORT}"))]
    NotMsh { source_name: String },

    #[error("{place}: MSH {what} is not supported")]
    #[diagnostic(
        code(brinell::mesh::version),
        help("MSH 4.1 and 2.2 are read: `gmsh -format msh41` or `-format msh22` writes them")
    )]
    Version { place: Place, what: String },

    #[error("{place}: {expected} expected, found {found}")]
    #[diagnostic(code(brinell::mesh::syntax), help("the file is damaged: {EXPORT}"))]
    Syntax {
        place: Place,
        expected: String,
        found: String,
    },

    #[error("{place}: the file ends where {expected} is expected")]
    #[diagnostic(code(brinell::mesh::truncated), help("the file is cut off: {EXPORT}"))]
    Truncated { place: Place, expected: String },

    #[error("{place}: {count} {what} are announced, {found}")]
    #[diagnostic(
        code(brinell::mesh::count),
        help("the count is wrong or data are missing: {EXPORT}")
    )]
    Count {
        place: Place,
        what: &'static str,
        count: u64,
        found: String,
    },

    #[error("{place}: data after the end of what the header announces: {found}")]
    #[diagnostic(code(brinell::mesh::surplus), help("the count is too small: {EXPORT}"))]
    Surplus { place: Place, found: String },

    #[error("{source_name}: there is no ${section} section")]
    #[diagnostic(code(brinell::mesh::missing_section), help("{EXPORT}"))]
    MissingSection {
        source_name: String,
        section: &'static str,
    },

    #[error("{place}: the section is there a second time")]
    #[diagnostic(code(brinell::mesh::repeated_section), help("keep one of the two"))]
    RepeatedSection { place: Place },

    #[error("{place}: {what} {tag} is there already, at {first}")]
    #[diagnostic(
        code(brinell::mesh::duplicate_tag),
        help("renumber so that every tag is used once")
    )]
    DuplicateTag {
        place: Place,
        what: &'static str,
        tag: String,
        first: At,
    },

    #[error("{source_name}: two physical {kind}s are called `{name}`")]
    #[diagnostic(code(brinell::mesh::duplicate_name), help("rename one of them"))]
    DuplicateName {
        source_name: String,
        kind: &'static str,
        name: String,
    },

    #[error("{place}: coordinate {axis} of node {node} is {value}")]
    #[diagnostic(
        code(brinell::mesh::not_finite),
        help("node coordinates must be finite numbers")
    )]
    NotFinite {
        place: Place,
        node: u64,
        axis: char,
        value: f64,
    },

    #[error("{place}: element {element} uses node {node}, which does not exist")]
    #[diagnostic(
        code(brinell::mesh::unknown_node),
        help("add the node to $Nodes or take the element out of $Elements")
    )]
    UnknownNode {
        place: Place,
        element: u64,
        node: u64,
    },

    #[error("{place}: {entity}, which the elements here belong to, is not in $Entities")]
    #[diagnostic(code(brinell::mesh::unknown_entity), help("{EXPORT}"))]
    UnknownEntity { place: Place, entity: String },

    #[error("{source_name}: there are no volume elements")]
    #[diagnostic(
        code(brinell::mesh::no_volumes),
        help("mesh the volumes (`gmsh -3`) and put each into a physical volume")
    )]
    NoVolumes { source_name: String },

    #[error("{source_name}: there is no physical volume")]
    #[diagnostic(
        code(brinell::mesh::no_physical_volume),
        help(
            "name each body, in the .geo file: `Physical Volume(\"roller\") = {{1}};` (gmsh writes \
             no groups to MSH 2.2 where `Mesh.SaveAll` is set)"
        )
    )]
    NoPhysicalVolume { source_name: String },

    #[error("{place}: element {element} of {entity} belongs to no physical volume")]
    #[diagnostic(
        code(brinell::mesh::ungrouped_volume),
        help("add the volume to the physical volume of its body, or leave it out of the mesh")
    )]
    UngroupedVolume {
        place: Place,
        element: u64,
        entity: String,
    },

    #[error("{place}: element {element} of {entity} belongs to several physical volumes: {names}")]
    #[diagnostic(
        code(brinell::mesh::several_volumes),
        help("a volume is part of exactly one body: keep one of the groups")
    )]
    SeveralVolumes {
        place: Place,
        element: u64,
        entity: String,
        names: String,
    },

    #[error("{source_name}: physical {kind} `{name}` (tag {tag}) has no elements{part}")]
    #[diagnostic(
        code(brinell::mesh::empty_group),
        help("mesh its {kind}s, or take the group out of the geometry")
    )]
    EmptyGroup {
        source_name: String,
        kind: &'static str,
        name: String,
        tag: i64,
        part: String,
    },

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
        place: Place,
        element: u64,
        body: String,
        kind: &'static str,
    },

    #[error(
        "{place}: element {element} of physical surface `{surface}` is a {kind}, not a four-node quadrilateral"
    )]
    #[diagnostic(
        code(brinell::mesh::not_quadrilateral),
        help("use `Recombine Surface`, of first order (`Mesh.ElementOrder = 1;`)")
    )]
    NotQuadrilateral {
        place: Place,
        element: u64,
        surface: String,
        kind: &'static str,
    },

    #[error("{place}: element {element} of physical volume `{body}` is degenerate: {why}")]
    #[diagnostic(
        code(brinell::mesh::degenerate),
        help(
            "every hexahedron needs eight different nodes and a volume: move or merge the nodes differently"
        )
    )]
    Degenerate {
        place: Place,
        element: u64,
        body: String,
        why: String,
    },

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
        place: Place,
        element: u64,
        body: String,
        node: u64,
        jacobian: f64,
    },

    #[error(
        "{place}: elements {first} and {element} are the same hexahedron, in physical volumes {bodies}"
    )]
    #[diagnostic(
        code(brinell::mesh::repeated_element),
        help("put every volume into exactly one physical volume")
    )]
    RepeatedElement {
        place: Place,
        element: u64,
        first: u64,
        bodies: String,
    },

    #[error("{place}: node {node}{owner} {use_of_it}")]
    #[diagnostic(
        code(brinell::mesh::unused_node),
        help("take the node out of the mesh, or mesh the volume it should belong to")
    )]
    UnusedNode {
        place: Place,
        node: u64,
        owner: String,
        use_of_it: String,
    },

    #[error("{place}: element {element} of physical surface `{surface}` {why}")]
    #[diagnostic(
        code(brinell::mesh::surface_face),
        help("a physical surface is made of outer faces of hexahedra, each once")
    )]
    SurfaceFace {
        place: Place,
        element: u64,
        surface: String,
        why: String,
    },

    #[error("{source_name}: {count} {what} are more than the {limit} that fit")]
    #[diagnostic(code(brinell::mesh::too_large), help("use a coarser mesh"))]
    TooLarge {
        source_name: String,
        count: u64,
        limit: u64,
        what: &'static str,
    },
}
