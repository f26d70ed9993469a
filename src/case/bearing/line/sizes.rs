//! Element sizes of the presets, for parallel rollers of any dimensions: those of rollers, with what goes by their plates.

use super::geometry::LineGeometry;
use crate::case::bearing::auto;
use crate::case::bearing::layout::Layout;
use crate::case::bearing::preset::Preset;
use crate::case::bearing::preset_sizes::{graded, unit};
use crate::case::bearing::sizes::{OwnSizes, Sizes};
use crate::case::bearing::strips::Strips;

/// The sizes of a preset for lines of these widths.
pub(super) fn sizes(preset: Preset, geometry: &LineGeometry, strips: &Strips) -> Sizes {
    let (roller, own) = (geometry.roller(), own(geometry));
    let unit = unit(geometry.roller.diameter);
    match preset {
        Preset::Auto => auto::sizes(&roller, own, strips),
        // These have no mesh `report-like`.
        Preset::H025 | Preset::ReportLike => graded(&roller, own, 0.025 * unit, [2.0, 1.0]),
        Preset::H0125 => graded(&roller, own, 0.0125 * unit, [3.0, 1.0]),
    }
}

fn own(geometry: &LineGeometry) -> OwnSizes {
    let (diameter, plates) = (geometry.roller.diameter, [geometry.upper, geometry.lower]);
    let least = |of: &dyn Fn(usize) -> f64| of(0).min(of(1));
    let half_plan = least(&|plate| plates[plate].plan[0]) / 2.0;
    let pitch = match geometry.rollers {
        1 => half_plan,
        _ => geometry.spacing.min(half_plan),
    };
    OwnSizes {
        // Nothing crosses the rollers, and there is no plate in the middle.
        crossing_size: (diameter / 6.0).min(geometry.roller.length / 16.0),
        middle_cap: diameter,
        plan_cap: (0.3 * diameter).min(pitch / 4.0),
        depth_cap: (0.1 * diameter).min(least(&|plate| plates[plate].thickness) / 3.0),
        end_zone: geometry.end_zone(),
    }
}
