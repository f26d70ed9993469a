//! The preset `auto`: element sizes from the half-widths of the lines of contact.

use super::roller_shape::RollerShape;
use super::sizes::{OwnSizes, PLATE_TO_ROLLER, Sizes};
use super::strips::Strips;

/// Elements across the half-width of the narrowest line: a tenth more than are asked for, on the
/// plates too, whose elements are the larger ones.
const ELEMENTS_ACROSS: f64 = 3.5;
/// Fine elements reach this many half-widths of the widest line.
const FINE_REACH: f64 = 1.35;
/// More fine rows than this are of no use: lines whose widths differ so much cannot share a size.
const MOST_ROWS: f64 = 40.0;

/// Elements along a roller over the length in which bending of its wall dies away, at most. (Largest line loads of four rollers with walls
/// of 0.07 D were 1.0 to 1.6 bars too small with 0.8.)
const OF_BENDING: f64 = 0.4;

/// Sizes for lines of these widths.
///
/// What they do, measured on ten bearings: the size across decides p0 and the half-width, and its
/// layers below the face the Mises stress, whose peak is 0.8 a deep; what is round of the roller,
/// and the layers of its wall, decide the stress of the bore and the descent; all others move them
/// by 0.3 % at most.
pub(super) fn sizes(roller: &RollerShape, own: OwnSizes, strips: &Strips) -> Sizes {
    let diameter = roller.diameter;
    let fine = strips.narrowest / ELEMENTS_ACROSS;
    let rows = (FINE_REACH * strips.widest / fine - 1e-6).ceil();
    let half_length = roller.length / 2.0;
    let end_size = own.end_size((diameter / 20.0).min(half_length / 16.0));
    // A crown changes all along the roller, and facets as long as a sixth of its half carry 3 % too much in its middle.
    let longest = match roller.end.is_crowned() {
        true => half_length / 12.0,
        false => half_length / 6.0,
    };
    // A wall that is thinner than a quarter of the diameter bends: elements around it as large beside it as beside that quarter, and
    // more layers in it, for its bending counts for more.
    let four_walls = diameter.min(4.0 * roller.nominal_wall());
    let thin = four_walls / diameter;
    // Along the roller bending of such a wall dies away within the root of radius and wall, and the load with it.
    let wall = roller.nominal_wall();
    let dies_away = (0.5 * (diameter - wall) * wall).sqrt();
    let bends = if thin < 1.0 {
        OF_BENDING * dies_away
    } else {
        longest
    };
    Sizes {
        uniform: false,
        roller_size: fine,
        plate_size: PLATE_TO_ROLLER * fine,
        fine_elements: rows.clamp(1.0, MOST_ROWS),
        fine_layers: 3.0,
        crossing_size: own.crossing_size,
        end_size,
        growth: 2.5,
        depth_growth: 2.5,
        along_growth: 2.0,
        around_cap: 0.1 * four_walls,
        along_cap: (0.4 * diameter).min(longest).min(bends),
        wall_cap: 0.057 * four_walls * thin.sqrt(),
        plan_cap: own.plan_cap,
        middle_cap: own.middle_cap,
        depth_cap: own.depth_cap,
        wall_least: 9.0,
        depth_least: 5.0,
        along_least: 8.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::bearing::geometry::BearingGeometry;
    use crate::case::bearing::layout::Layout;
    use crate::case::bearing::preset::Preset;
    use crate::case::bearing::sample::initial;
    use crate::case::bearing::strips::{self, FoundLine};

    const STEEL: f64 = 2.0 * 0.91 / 29500.0;

    fn predicted(geometry: &BearingGeometry, load: f64) -> Strips {
        Strips::predicted(geometry, load, [STEEL; 2], [STEEL; 2]).unwrap()
    }

    #[test]
    fn every_line_has_three_elements_across_and_fine_ones_beyond_its_edge() {
        for (offset, load) in [(0.0, 65.0), (0.0, 6.5), (2.5, 65.0), (2.5, 120.0)] {
            let geometry = BearingGeometry {
                offset,
                ..initial()
            };
            let strips = predicted(&geometry, load);
            let sizes = geometry.preset_sizes(Preset::Auto, &strips);
            assert!(strips::FEWEST_ACROSS * sizes.plate_size <= strips.narrowest);
            assert!(sizes.fine_elements * sizes.roller_size >= strips::LEAST_REACH * strips.widest);
            assert!(sizes.fine_elements <= 6.0, "no more rows than that takes");
        }
    }

    #[test]
    fn a_quarter_of_the_load_has_half_the_width() {
        let [full, quarter] = [65.0, 16.25].map(|load| predicted(&initial(), load));
        assert!((full.narrowest / quarter.narrowest - 2.0).abs() < 0.01);
        let floor = predicted(&initial(), 1e-3);
        assert_eq!(floor.narrowest, 1e-3 * 3.0);
    }

    #[test]
    fn what_was_found_serves_what_was_found() {
        let geometry = initial();
        let seats = geometry.seats(false);
        let line = |valley: bool, across, half_width| {
            let seat = &seats[usize::from(valley)];
            FoundLine::on(seat, across, half_width)
        };
        let at = geometry.v_line();
        // The narrow line alone, a wide one beside it, one that has moved aside, two that merged.
        for lines in [
            vec![line(true, at, 0.02)],
            vec![line(true, at, 0.02), line(false, 0.0, 0.05)],
            vec![line(true, at + 0.01, 0.03)],
            vec![line(true, 0.0, 0.15), line(false, 0.0, 0.1)],
        ] {
            let strips = Strips::found(geometry.roller.diameter, &lines).unwrap();
            let sizes = geometry.preset_sizes(Preset::Auto, &strips);
            let reach = sizes.fine_elements * sizes.roller_size;
            for line in lines {
                assert!(line.is_served(sizes.plate_size, reach), "{line:?}");
                assert!(!line.is_served(0.4 * line.half_width, reach));
                assert!(!line.is_served(sizes.plate_size, 0.5 * line.half_width));
            }
        }
        assert_eq!(Strips::found(geometry.roller.diameter, &[]), None);
    }
}
