//! Element sizes of the presets, for two crossed rollers of any dimensions.

use std::f64::consts::PI;

use super::auto;
use super::geometry::BearingGeometry;
use super::layout::Layout;
use super::preset::Preset;
use super::roller_shape::RollerShape;
use super::sizes::{OwnSizes, PLATE_TO_ROLLER, Sizes};
use super::strips::Strips;

/// The element sizes for a bearing whose lines of contact are as wide as `strips`; all but
/// `auto` look at the diameter alone.
pub(super) fn sizes(preset: Preset, geometry: &BearingGeometry, strips: &Strips) -> Sizes {
    let (roller, unit) = (geometry.roller(), unit(geometry.roller.diameter));
    match preset {
        Preset::Auto => auto::sizes(&roller, auto_own(geometry), strips),
        Preset::H025 => graded(&roller, own(geometry), 0.025 * unit, [2.0, 1.0]),
        Preset::H0125 => graded(&roller, own(geometry), 0.0125 * unit, [3.0, 1.0]),
        Preset::ReportLike => report_like(geometry),
    }
}

/// A scale for lengths: 1 for the reference bearing, of 3 in, as the names of the presets have it.
pub(super) fn unit(diameter: f64) -> f64 {
    diameter / 3.0
}

fn half_plan(geometry: &BearingGeometry) -> f64 {
    geometry.plan[0].max(geometry.plan[1]) / 2.0
}

fn own(geometry: &BearingGeometry) -> OwnSizes {
    let unit = unit(geometry.roller.diameter);
    OwnSizes {
        crossing_size: (0.1 * unit).min(geometry.roller.length / 2.0 / 20.0),
        plan_cap: unit.min(half_plan(geometry) / 4.0),
        middle_cap: (0.7 * unit).min(half_plan(geometry) / 5.0),
        depth_cap: (0.3 * unit).min(geometry.thinnest_plate() / 3.0),
        end_zone: geometry.end_zone(false),
    }
}

fn auto_own(geometry: &BearingGeometry) -> OwnSizes {
    let diameter = geometry.roller.diameter;
    // Loads are largest there where rollers are centred; where they are displaced, near the ends.
    let finer = if geometry.is_centred() { 2.0 } else { 1.0 };
    OwnSizes {
        crossing_size: (diameter / 10.0).min(geometry.roller.length / 20.0) / finer,
        plan_cap: (0.43 * diameter).min(half_plan(geometry) / 4.0),
        middle_cap: (0.33 * diameter).min(half_plan(geometry) / 5.0),
        depth_cap: (0.1 * diameter).min(geometry.thinnest_plate() / 3.0),
        end_zone: geometry.end_zone(false),
    }
}

/// Graded from `size` across the contact lines, with so many `rows` of it on either side and `layers` below.
pub(super) fn graded(
    roller: &RollerShape,
    own: OwnSizes,
    size: f64,
    [rows, layers]: [f64; 2],
) -> Sizes {
    let unit = unit(roller.diameter);
    let half_length = roller.length / 2.0;
    Sizes {
        uniform: false,
        roller_size: size,
        plate_size: PLATE_TO_ROLLER * size,
        fine_elements: rows,
        fine_layers: layers,
        crossing_size: own.crossing_size,
        end_size: own.end_size((0.15 * unit).min(half_length / 16.0)),
        growth: 2.0,
        depth_growth: 2.0,
        along_growth: 1.5,
        around_cap: 0.5 * unit,
        along_cap: (0.5 * unit).min(half_length / 8.0),
        wall_cap: roller.nominal_wall() * 0.4,
        plan_cap: own.plan_cap,
        middle_cap: own.middle_cap,
        depth_cap: own.depth_cap,
        wall_least: 6.0,
        depth_least: 5.0,
        along_least: 12.0,
    }
}

/// Rollers: 24 elements around, 2 through the wall, 0.5 in along; plates: 0.3 in, 3 layers.
fn report_like(geometry: &BearingGeometry) -> Sizes {
    let unit = unit(geometry.roller.diameter);
    let around = PI * geometry.roller.diameter / 24.0;
    let wall = geometry.roller().nominal_wall();
    Sizes {
        uniform: true,
        roller_size: around,
        plate_size: 0.3 * unit,
        fine_elements: 1.0,
        fine_layers: 1.0,
        crossing_size: 0.5 * unit,
        end_size: 0.5 * unit,
        growth: 1.0,
        depth_growth: 1.0,
        along_growth: 1.0,
        around_cap: around,
        along_cap: 0.5 * unit,
        wall_cap: wall / 2.0,
        plan_cap: 0.3 * unit,
        middle_cap: 0.3 * unit,
        depth_cap: geometry.thinnest_plate() / 3.0,
        wall_least: 2.0,
        depth_least: 3.0,
        along_least: 1.0,
    }
}
