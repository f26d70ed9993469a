//! Plastic history by element.

use crate::model::material::j2::PlasticPoint;

/// Plastic history of an element's integration points; `None` while it never yielded.
pub type PlasticElement = Option<Box<[PlasticPoint; 8]>>;

/// Plastic elements, ascending, with their integration points.
pub type Plastic = Vec<(u32, [PlasticPoint; 8])>;

/// Plastic strains of elements at their integration points, with engineering shears.
pub type PlasticStrains = Vec<(u32, [[f64; 6]; 8])>;

/// The integration points of an element; virgin ones where it is none of the `plastic` ones.
pub fn points(plastic: &Plastic, element: u32) -> [PlasticPoint; 8] {
    let at = plastic.binary_search_by_key(&element, |(e, _)| *e);
    at.map_or_else(|_| Default::default(), |at| plastic[at].1)
}
