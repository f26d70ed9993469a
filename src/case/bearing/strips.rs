//! How wide the lines of contact are: as statics predicts, or as a solution found them.

use super::end_shape::RollerEnd;
use super::geometry::BearingGeometry;
use super::seat::Seat;
use crate::analytic::DomainError;
use crate::analytic::displaced::DisplacedRoller;
use crate::analytic::hertz::LineContact;

/// Half-widths of the lines of contact that a mesh is made for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strips {
    /// Half-width a of the narrowest line, where its load is largest.
    pub narrowest: f64,
    /// How far the fine elements must serve, from where a line lies in the geometry: the largest
    /// half-width, and more where a line has moved aside.
    pub widest: f64,
    /// Did a solution find them? Else statics predicts them.
    pub found: bool,
}

/// A line of contact of a solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FoundLine {
    /// Half-width a at its heaviest row.
    pub half_width: f64,
    /// How far fine elements must reach from where a line lies in the geometry.
    pub reach: f64,
}

/// The least half-width that a mesh is made for, as a share of the diameter: strips are narrower only in
/// bearings that carry next to nothing, and would take all elements of the mesh.
const LEAST_HALF_WIDTH: f64 = 1e-3;

/// Of centred bearings half-widths are predicted; the widest line is wider by this, and by what the fine elements reach beyond
/// what they must, in one of six, and the mesh need not be made once more;
const PREDICTED_REACH: f64 = 1.03;
/// and beside fillets, where the plate goes on and a line presses most.
const REACH_AT_FILLETS: f64 = 1.3;

impl Strips {
    /// Of steel on steel at p0 = E*/100, where nothing is known of the load: a = 0.02 R.
    pub fn nominal(diameter: f64) -> Self {
        let widths = [0.02 * (diameter / 2.0)];
        Self::of(diameter, &widths, &widths, false)
    }

    /// As statics predicts them under the load P; `flat` and `valley` are the compliances C_E
    /// between the rollers and the flat plates, and between the rollers and the intermediate plate.
    ///
    /// Even loads are too low: rollers that cross press harder in the middle, the more so the longer and stiffer they
    /// are and the thinner the intermediate plate between them; displaced ones press harder at their ends than a
    /// rigid roller on springs does. Largest load per length, fitted to 70 drawn bearings, of which single ones
    /// differ by an eighth (centred), and to ten, of which they differ by a third (displaced), with the wall w,
    /// D/2 of a solid roller, and the thickness t of the intermediate plate:
    ///
    /// ```text
    /// centred    flat         P/L  (1 + 0.01 (L/D)^2.3 (D/t)^1.1 (w/D)^0.8)
    ///            valley line  P/2L (1 + 0.2 (L/D)^0.8 (D/t)^1.6 (w/D)^0.6)
    /// displaced  flat  1.25 q                      valley line  1.08 q
    /// ```
    /// with q of [`DisplacedRoller::linear`].
    ///
    /// # Errors
    /// [`DomainError`] for a load or compliance that is not positive, or a roller whose load lies
    /// beyond its end.
    pub fn predicted(
        geometry: &BearingGeometry,
        load: f64,
        flat: [f64; 2],
        valley: [f64; 2],
    ) -> Result<Self, DomainError> {
        let roller = &geometry.roller;
        let ([on_flat, in_valley], reach) = if geometry.is_centred() {
            let even = load / roller.length;
            let slender = roller.length / roller.diameter;
            let plate = roller.diameter / geometry.intermediate_thickness;
            let wall = roller.wall.unwrap_or(roller.radius()) / roller.diameter;
            let more = 0.01 * slender.powf(2.3) * plate.powf(1.1) * wall.powf(0.8);
            let more_in_valley = 0.2 * slender.powf(0.8) * plate.powf(1.6) * wall.powf(0.6);
            let reach = match roller.end {
                RollerEnd::Radius(_) => REACH_AT_FILLETS,
                _ => PREDICTED_REACH,
            };
            (
                [even * (1.0 + more), 0.5 * even * (1.0 + more_in_valley)],
                reach,
            )
        } else {
            let linear = DisplacedRoller::new(load, roller.length, geometry.offset)?.linear();
            ([1.25 * linear.largest, 1.08 * linear.largest], 1.0)
        };
        let width = |load: f64, compliance: f64| {
            LineContact::new(load, geometry.radius(), compliance).map(|line| line.half_width)
        };
        let widths = [
            width(on_flat, flat[0])?,
            width(on_flat, flat[1])?,
            width(in_valley, valley[0])?,
            width(in_valley, valley[1])?,
        ];
        let wide = widths.map(|width| reach * width);
        Ok(Self::of(roller.diameter, &widths, &wide, false))
    }

    /// Lines of these half-widths where statics predicts them, on rollers of this diameter.
    pub(super) fn even(diameter: f64, widths: &[f64]) -> Self {
        Self::of(diameter, widths, widths, false)
    }

    /// As these lines have them; `None` where there are none.
    pub fn found(diameter: f64, lines: &[FoundLine]) -> Option<Self> {
        let narrow: Vec<f64> = lines.iter().map(|line| line.half_width).collect();
        let wide: Vec<f64> = (lines.iter())
            .map(|line| line.reach / LEAST_REACH)
            .collect();
        (!lines.is_empty()).then(|| Self::of(diameter, &narrow, &wide, true))
    }

    /// Fine elements reach so many times as far, on rollers of this diameter.
    pub fn widened(&self, diameter: f64, factor: f64) -> Self {
        let wide = [self.widest * factor];
        Self::of(diameter, &[self.narrowest], &wide, self.found)
    }

    fn of(diameter: f64, narrow: &[f64], wide: &[f64], found: bool) -> Self {
        // Three digits: one mesh whatever the units, though the numbers differ in their last ones.
        let rounded = |width: f64| {
            let share = (width / diameter).max(LEAST_HALF_WIDTH);
            let digits = 10f64.powf(2.0 - share.log10().floor());
            (share * digits).round() / digits * diameter
        };
        Self {
            narrowest: rounded(narrow.iter().copied().fold(f64::INFINITY, f64::min)),
            widest: rounded(wide.iter().copied().fold(0.0, f64::max)),
            found,
        }
    }
}

/// The fine elements reach this many half-widths to either side of a line.
pub const LEAST_REACH: f64 = 1.3;
/// Elements across a half-width, at least.
pub const FEWEST_ACROSS: f64 = 3.0;

impl FoundLine {
    /// A line pressed at `across` of a seat.
    pub fn on(seat: &Seat, across: f64, half_width: f64) -> Self {
        Self {
            half_width,
            reach: seat.reach(across, LEAST_REACH * half_width),
        }
    }

    /// Do elements of this size across it, and so many half-widths of them, serve this line? `fine`
    /// is how far elements of `size` reach to either side of where the line lies in the geometry.
    pub fn is_served(&self, size: f64, fine: f64) -> bool {
        FEWEST_ACROSS * size <= self.half_width && self.reach <= fine
    }
}
