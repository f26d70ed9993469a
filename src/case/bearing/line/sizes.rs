//! Element sizes of the presets, for parallel rollers of any dimensions.

use super::geometry::LineGeometry;
use crate::case::bearing::end_shape::RollerEnd;
use crate::case::bearing::preset::Preset;
use crate::case::bearing::sizes::{PLATE_TO_ROLLER, Sizes};
use crate::case::bearing::strips::Strips;

/// Elements across the half-width of the narrowest line, and half-widths of the widest line that fine ones reach: as of
/// crossed rollers.
const ELEMENTS_ACROSS: f64 = 3.5;
const FINE_REACH: f64 = 1.35;
/// More fine rows than this are of no use.
const MOST_ROWS: f64 = 40.0;

/// The sizes of a preset for lines of these widths.
pub(super) fn sizes(preset: Preset, geometry: &LineGeometry, strips: &Strips) -> Sizes {
    // 1 for a roller of 3 in, as the names of the presets have it.
    let unit = geometry.diameter / 3.0;
    match preset {
        Preset::Auto => auto(geometry, strips),
        Preset::H025 => graded(geometry, 0.025 * unit, [2.0, 1.0]),
        Preset::H0125 => graded(geometry, 0.0125 * unit, [3.0, 1.0]),
        Preset::Series | Preset::ReportLike => Sizes {
            growth: 2.25,
            depth_growth: 2.25,
            wall_least: 4.0,
            depth_least: 4.0,
            ..graded(geometry, 0.025 * unit, [2.0, 1.0])
        },
    }
}

/// Sized by the lines of contact; what decides which figure is as of crossed rollers.
fn auto(geometry: &LineGeometry, strips: &Strips) -> Sizes {
    let diameter = geometry.diameter;
    let fine = strips.narrowest / ELEMENTS_ACROSS;
    let rows = (FINE_REACH * strips.widest / fine - 1e-6).ceil();
    let base = graded(geometry, fine, [rows.clamp(1.0, MOST_ROWS), 3.0]);
    let wall = geometry.wall.unwrap_or(diameter / 4.0);
    let half_length = geometry.length / 2.0;
    let end_size = (diameter / 20.0).min(half_length / 16.0);
    // A few elements on a fillet.
    let (end_size, along_growth) = match geometry.end.radius() {
        Some(radius) => {
            let least = strips.narrowest / 2.0;
            (end_size.min((radius / 8.0).max(least)), 1.6)
        }
        None => (end_size, 2.0),
    };
    Sizes {
        end_size,
        growth: 2.5,
        depth_growth: 2.5,
        along_growth,
        around_cap: 0.1 * diameter,
        along_cap: match geometry.end {
            // A crown changes all along the roller.
            RollerEnd::Crown(_) | RollerEnd::CrownedRadius { .. } => half_length / 10.0,
            _ => (0.4 * diameter).min(half_length / 6.0),
        },
        wall_cap: (0.057 * diameter).min(0.4 * wall),
        wall_least: 9.0,
        along_least: 8.0,
        ..base
    }
}

fn graded(geometry: &LineGeometry, size: f64, [rows, layers]: [f64; 2]) -> Sizes {
    let diameter = geometry.diameter;
    let half_length = geometry.length / 2.0;
    let wall = geometry.wall.unwrap_or(diameter / 4.0);
    let plates = [geometry.upper, geometry.lower];
    let narrowest = plates
        .map(|p| p.plan[0])
        .into_iter()
        .fold(f64::INFINITY, f64::min);
    let thinnest = plates
        .map(|p| p.thickness)
        .into_iter()
        .fold(f64::INFINITY, f64::min);
    let pitch = match geometry.rollers {
        1 => narrowest / 2.0,
        _ => geometry.spacing.min(narrowest / 2.0),
    };
    let end_size = (0.05 * diameter).min(half_length / 16.0);
    let along_cap = (diameter / 6.0).min(half_length / 8.0);
    Sizes {
        uniform: false,
        roller_size: size,
        plate_size: PLATE_TO_ROLLER * size,
        fine_elements: rows,
        fine_layers: layers,
        crossing_size: along_cap,
        end_size: geometry
            .end
            .radius()
            .map_or(end_size, |radius| end_size.min(radius / 3.0)),
        growth: 2.0,
        depth_growth: 2.0,
        along_growth: 1.5,
        around_cap: diameter / 6.0,
        along_cap,
        wall_cap: 0.4 * wall,
        plan_cap: (0.3 * diameter).min(pitch / 4.0),
        middle_cap: diameter,
        depth_cap: (0.1 * diameter).min(thinnest / 3.0),
        wall_least: 6.0,
        depth_least: 5.0,
        along_least: 12.0,
    }
}
