//! Why figures of contacts and of what they press are not resolved.

pub(super) const COARSE: &str = "the nodes are too far apart for the strip or patch of contact: the figure belongs to \
                      the mesh";
pub(super) const FILLET: &str = "the facets are too long for a fillet under load: where it begins the pressure may have a higher \
                      and narrow peak";
pub(super) const SHAPE: &str = "the facets there are too coarse for the shape of the surface, such as a fillet: the figure \
                     belongs to the mesh";
pub(super) const POKES: &str = "a corner or an edge of one side lies deeper in the other than facets explain: how bodies turn about it belongs \
                     to the mesh";
pub(super) const LONG_FACES: &str = "beside a singular edge whose faces are longer than its stress reaches: how much of it is left there belongs \
                          to the mesh";
pub(super) const MEAN_OF_MOTIONS: &str = "a mean of the travels that are prescribed, weighted by the forces with which they are resisted";
pub(super) const UNKNOWN_STIFFNESS: &str = "the mesh is too coarse to tell how far too stiff it is";
