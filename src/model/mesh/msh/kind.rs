//! The element types of gmsh.

/// An element type.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct GmshElement {
    pub code: i64,
    pub name: &'static str,
    /// 0 for points to 3 for volumes.
    pub dimension: u8,
    pub nodes: usize,
}

/// The four-node quadrilateral.
pub(super) const QUADRILATERAL: i64 = 3;
/// The eight-node hexahedron.
pub(super) const HEXAHEDRON: i64 = 5;

impl GmshElement {
    /// The type that gmsh writes as `code`.
    pub fn of(code: i64) -> Option<&'static GmshElement> {
        KINDS.iter().find(|kind| kind.code == code)
    }
}

const fn kind(code: i64, name: &'static str, dimension: u8, nodes: usize) -> GmshElement {
    GmshElement {
        code,
        name,
        dimension,
        nodes,
    }
}

/// From the element types of the MSH format's documentation.
static KINDS: [GmshElement; 37] = [
    kind(1, "two-node line", 1, 2),
    kind(2, "three-node triangle", 2, 3),
    kind(3, "four-node quadrilateral", 2, 4),
    kind(4, "four-node tetrahedron", 3, 4),
    kind(5, "eight-node hexahedron", 3, 8),
    kind(6, "six-node prism", 3, 6),
    kind(7, "five-node pyramid", 3, 5),
    kind(8, "three-node line", 1, 3),
    kind(9, "six-node triangle", 2, 6),
    kind(10, "nine-node quadrilateral", 2, 9),
    kind(11, "ten-node tetrahedron", 3, 10),
    kind(12, "27-node hexahedron", 3, 27),
    kind(13, "18-node prism", 3, 18),
    kind(14, "14-node pyramid", 3, 14),
    kind(15, "point", 0, 1),
    kind(16, "eight-node quadrilateral", 2, 8),
    kind(17, "20-node hexahedron", 3, 20),
    kind(18, "15-node prism", 3, 15),
    kind(19, "13-node pyramid", 3, 13),
    kind(20, "nine-node triangle", 2, 9),
    kind(21, "ten-node triangle", 2, 10),
    kind(22, "12-node triangle", 2, 12),
    kind(23, "15-node triangle", 2, 15),
    kind(24, "15-node triangle", 2, 15),
    kind(25, "21-node triangle", 2, 21),
    kind(26, "four-node line", 1, 4),
    kind(27, "five-node line", 1, 5),
    kind(28, "six-node line", 1, 6),
    kind(29, "20-node tetrahedron", 3, 20),
    kind(30, "35-node tetrahedron", 3, 35),
    kind(31, "56-node tetrahedron", 3, 56),
    kind(36, "16-node quadrilateral", 2, 16),
    kind(37, "25-node quadrilateral", 2, 25),
    kind(90, "40-node prism", 3, 40),
    kind(91, "75-node prism", 3, 75),
    kind(92, "64-node hexahedron", 3, 64),
    kind(93, "125-node hexahedron", 3, 125),
];
