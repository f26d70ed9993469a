//! Element sizes of the presets, for two crossed rollers of any dimensions.

use std::f64::consts::PI;

use super::auto;
use super::geometry::BearingGeometry;
use super::preset::Preset;
use super::sizes::{PLATE_TO_ROLLER, Sizes};
use super::strips::Strips;

/// The element sizes for a bearing whose lines of contact are as wide as `strips`; all but
/// `auto` look at the diameter alone.
pub(super) fn sizes(preset: Preset, geometry: &BearingGeometry, strips: &Strips) -> Sizes {
    match preset {
        Preset::Auto => auto::sizes(geometry, strips),
        Preset::H025 => graded(geometry, 0.025, 2.0),
        Preset::H0125 => graded(geometry, 0.0125, 3.0),
        Preset::Series => series(geometry),
        Preset::ReportLike => report_like(geometry),
    }
}

/// A scale for lengths: 1 for the reference bearing.
fn unit(geometry: &BearingGeometry) -> f64 {
    geometry.diameter / 3.0
}

/// Graded from `size` across the contact lines, with `fine_elements` of it on either side.
fn graded(geometry: &BearingGeometry, size: f64, fine_elements: f64) -> Sizes {
    let unit = unit(geometry);
    let half_length = geometry.length / 2.0;
    let half_plan = geometry.plan[0].max(geometry.plan[1]) / 2.0;
    let wall = geometry.wall.unwrap_or(geometry.radius() / 2.0);
    let mut sizes = Sizes {
        uniform: false,
        roller_size: size * unit,
        plate_size: PLATE_TO_ROLLER * size * unit,
        fine_elements,
        fine_layers: 1.0,
        crossing_size: (0.1 * unit).min(half_length / 20.0),
        end_size: (0.15 * unit).min(half_length / 16.0),
        growth: 2.0,
        depth_growth: 2.0,
        along_growth: 1.5,
        around_cap: 0.5 * unit,
        along_cap: (0.5 * unit).min(half_length / 8.0),
        wall_cap: wall * 0.4,
        plan_cap: unit.min(half_plan / 4.0),
        middle_cap: (0.7 * unit).min(half_plan / 5.0),
        depth_cap: (0.3 * unit).min(geometry.thinnest_plate() / 3.0),
        wall_least: 6.0,
        depth_least: 5.0,
        along_least: 12.0,
    };
    if let Some(radius) = geometry.end.radius() {
        // A few elements on the fillet.
        sizes.end_size = sizes.end_size.min(radius / 3.0);
    }
    sizes
}

fn series(geometry: &BearingGeometry) -> Sizes {
    let base = graded(geometry, 0.025, 2.0);
    Sizes {
        crossing_size: 1.2 * base.crossing_size,
        growth: 2.25,
        depth_growth: 2.25,
        along_growth: 1.8,
        around_cap: 1.5 * base.around_cap,
        along_cap: 1.2 * base.along_cap,
        wall_cap: geometry.wall.unwrap_or(geometry.radius() / 2.0) * 4.0 / 15.0,
        plan_cap: 1.5 * base.plan_cap,
        middle_cap: 1.5 * base.middle_cap,
        depth_cap: 1.3 * base.depth_cap,
        wall_least: 4.0,
        depth_least: 4.0,
        ..base
    }
}

/// Rollers: 24 elements around, 2 through the wall, 0.5 in along; plates: 0.3 in, 3 layers.
fn report_like(geometry: &BearingGeometry) -> Sizes {
    let unit = unit(geometry);
    let around = PI * geometry.diameter / 24.0;
    let wall = geometry.wall.unwrap_or(geometry.radius() / 2.0);
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
