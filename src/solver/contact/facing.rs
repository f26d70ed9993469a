//! Where two surfaces face each other, and how far apart they are: a look that no contact row takes
//! part in.
//!
//! From each node and each facet's middle on either side the true surface of the other side is sought
//! along the normal. A displacement then changes the gap at such a [`Sight`] by the relative motion
//! of the two points that it joins. So overlap is found wherever bodies meet, whether or not the
//! contact operator was prepared for it there.

use super::pair::{Opposite, Pair};
use super::side::Side;
pub use super::sight::Sight;
use super::viewer::Viewer;

/// All sights of a pair whose undeformed gap is at most `distance`, both ways.
pub fn sights(pair: &Pair, distance: f64) -> Vec<Sight> {
    let carrier = Viewer::new(Side::new(pair, pair.carrier));
    let surface = match pair.opposite {
        Opposite::Surface(surface) => surface,
        Opposite::Plane { point, normal } => return carrier.onto_plane(point, normal, distance),
    };
    let opposite = Viewer::new(Side::new(pair, surface));
    let mut all = carrier.look(&opposite.scenery(pair.mirrors, distance), true);
    all.extend(opposite.look(&carrier.scenery(pair.mirrors, distance), false));
    all
}
