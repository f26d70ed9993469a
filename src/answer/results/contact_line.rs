//! What one line of contact carries, row by row.

use super::strip_row::StripRow;

/// One line of contact along a carrier surface whose nodes stand in rows across it.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactLine {
    /// Where it runs: the mean of the coordinate across, weighted by force.
    pub across: f64,
    /// Coordinates of the rows along the surface, ascending.
    pub at: Vec<f64>,
    /// Force normal to the surface per length at each row, of the whole line where a plane of symmetry
    /// cuts it, whether `symmetry` names it or supports make it; zero where it has lifted off.
    pub load: Vec<f64>,
    /// Length over which it carries and length over which it does not, in the whole.
    pub length: f64,
    /// Length over which it has lifted off, in the whole.
    pub lifted_off: f64,
    /// How many such lines there are in the whole of its two bodies: mirror planes that cut these, but not it, double it.
    pub images: usize,
    /// Does one open node part it from another line of the pair?
    pub is_parted: bool,
    /// The row that carries most per length.
    pub heaviest: StripRow,
}

/// Rows of half a line stand for two.
const MIRRORED: f64 = 1.5;

impl ContactLine {
    /// The largest load per length and where it is; `None` where nothing is carried.
    pub fn peak(&self) -> Option<(f64, f64)> {
        let rows = self.load.iter().copied().zip(self.at.iter().copied());
        rows.filter(|(load, _)| *load > 0.0)
            .reduce(|most, row| if row.0 > most.0 { row } else { most })
    }

    /// Load per length at the coordinate `along`, straight between rows, and beyond the last one as there; `None` where there are none.
    pub fn load_at(&self, along: f64) -> Option<f64> {
        let next = self.at.partition_point(|row| *row < along);
        let row = |index: usize| Some((*self.at.get(index)?, *self.load.get(index)?));
        match (next.checked_sub(1).and_then(row), row(next)) {
            (Some((a, before)), Some((b, after))) => {
                Some(before + (after - before) * (along - a) / (b - a))
            }
            (Some((_, end)), None) | (None, Some((_, end))) => Some(end),
            (None, None) => None,
        }
    }

    /// The load per length of its heaviest row.
    pub fn heaviest_load(&self) -> f64 {
        self.load[self.heaviest.row]
    }

    /// The same as a mean over the lengths to the rows beside it, weighted by the hat function of the row and less what a
    /// slope makes of lengths that differ: what is left where loads alternate from row to row, as beside a fillet.
    pub fn heaviest_mean_load(&self) -> f64 {
        let row = self.heaviest.row;
        let beside = |row: usize| Some((*self.at.get(row)?, *self.load.get(row)?));
        let (at, load) = (self.at[row], self.load[row]);
        let (Some((a, p)), Some((b, q))) = (row.checked_sub(1).and_then(beside), beside(row + 1))
        else {
            return load;
        };
        let (before, after) = (at - a, b - at);
        let mean =
            (before * (p + 2.0 * load) + after * (q + 2.0 * load)) / (3.0 * (before + after));
        mean - (after - before) / 3.0 * (q - p) / (before + after)
    }

    /// Is it a line? Where it lifts off it has to be three times as long as it is wide: a patch that is
    /// no longer is one of spheres.
    pub fn is_long(&self) -> bool {
        self.lifted_off <= 0.0 || self.length > 6.0 * self.heaviest.half_width
    }

    /// How many rows in the whole one row of the modelled part stands for.
    pub fn length_share(&self) -> f64 {
        match self.extent() {
            Some(extent) => (self.length + self.lifted_off) / extent,
            None => 1.0,
        }
    }

    /// The middle of the carrier, along it.
    pub fn middle(&self) -> Option<f64> {
        Some(0.5 * (self.at.first()? + self.at.last()?))
    }

    /// How far from its resultant its loads act in the mean, ∫ q |x − x̄| / ∫ q, of the modelled part; `None` where
    /// nothing is carried.
    pub fn spread(&self) -> Option<f64> {
        let force = self.force();
        let mean = |distance: &dyn Fn(f64) -> f64| {
            let moments = self.row_forces().map(|(at, f)| f * distance(at));
            moments.sum::<f64>() / force
        };
        let centre = mean(&|x| x);
        (force > 0.0).then(|| mean(&|x| (x - centre).abs()))
    }

    /// How far its resultant would act from where it does if every row carried what the rows beside it say, independently of the
    /// others: the root of the sum of squares; `None` where nothing is carried.
    pub fn scatter(&self) -> Option<f64> {
        let force = self.force();
        let centre: f64 = self.row_forces().map(|(at, f)| f * at).sum::<f64>() / force;
        let rows = self.at.windows(3).zip(self.load.windows(3));
        let moments = rows
            .zip(lengths(&self.at).into_iter().skip(1))
            .map(|((at, q), length)| {
                let share = (at[1] - at[0]) / (at[2] - at[0]);
                let straight = q[0] + share * (q[2] - q[0]);
                (q[1] - straight) * length * (at[1] - centre)
            });
        (force > 0.0).then(|| moments.map(|m| m * m).sum::<f64>().sqrt() / force)
    }

    /// Load per length, spread evenly over the whole length of the carrier.
    pub fn mean(&self) -> f64 {
        self.extent().map_or(0.0, |extent| self.force() / extent)
    }

    /// The load per length at its heaviest row as statics alone has it: the force and its moment on all that is in contact, even or evenly
    /// rising. What is more there is made by bodies that bend. `None` where nothing is carried.
    pub fn of_statics(&self) -> Option<f64> {
        let rows = self.at.iter().zip(&self.load).zip(lengths(&self.at));
        let pressing = rows.filter(|((_, load), _)| **load > 0.0);
        let sums = pressing.fold([0.0; 5], |[l, y, yy, f, fy], ((at, load), length)| {
            let force = load * length;
            [
                l + length,
                y + length * at,
                yy + length * at * at,
                f + force,
                fy + force * at,
            ]
        });
        let [length, first, second, force, moment] = sums;
        let even = (force > 0.0).then(|| force / length)?;
        let centre = first / length;
        let inertia = second - first * centre;
        // A mirror plane makes it even.
        let is_mirrored = self.length_share() > MIRRORED;
        let slope = match is_mirrored || inertia <= 0.0 {
            true => 0.0,
            false => (moment - force * centre) / inertia,
        };
        Some(even + slope * (self.heaviest.at - centre))
    }

    /// From its first row to its last one; `None` where it has not two.
    fn extent(&self) -> Option<f64> {
        let extent = self.at.last()? - self.at.first()?;
        (extent > 0.0).then_some(extent)
    }

    fn force(&self) -> f64 {
        self.row_forces().map(|(_, force)| force).sum()
    }

    /// Place and force of every row.
    fn row_forces(&self) -> impl Iterator<Item = (f64, f64)> {
        let rows = self.at.iter().zip(&self.load).zip(lengths(&self.at));
        rows.map(|((at, load), length)| (*at, load * length))
    }
}

/// The length that each row stands for, to the middles between it and its neighbours.
pub(super) fn lengths(at: &[f64]) -> Vec<f64> {
    let last = at.len().saturating_sub(1);
    let length = |i: usize| 0.5 * (at[(i + 1).min(last)] - at[i.saturating_sub(1)]);
    (0..at.len()).map(length).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(at: [f64; 3], load: [f64; 3]) -> ContactLine {
        ContactLine {
            is_parted: false,
            across: 0.0,
            at: at.to_vec(),
            load: load.to_vec(),
            length: at[2] - at[0],
            lifted_off: 0.0,
            images: 1,
            heaviest: StripRow {
                row: 1,
                ..StripRow::default()
            },
        }
    }

    #[test]
    fn even_and_evenly_rising_loads_do_not_scatter() {
        let even = line([0.0, 1.0, 4.0], [10.0, 12.0, 18.0]);
        assert!(even.scatter().unwrap() < 1e-12);
        // 9 in the middle where 12 would be straight: forces of 5, 18 and 27, about 2.64.
        let uneven = line([0.0, 1.0, 4.0], [10.0, 9.0, 18.0]);
        let centre = (9.0 * 2.0 + 27.0 * 4.0) / 50.0;
        let moment = 3.0 * 2.0 * (centre - 1.0);
        assert!((uneven.scatter().unwrap() - moment / 50.0).abs() < 1e-12);
        assert_eq!(line([0.0, 1.0, 4.0], [0.0; 3]).scatter(), None);
    }

    #[test]
    fn statics_makes_loads_that_rise_evenly() {
        let rising = line([0.0, 1.0, 2.0], [10.0, 12.0, 14.0]);
        let read = |line: ContactLine| {
            let heaviest = StripRow {
                at: line.at[line.heaviest.row],
                ..line.heaviest
            };
            ContactLine { heaviest, ..line }.of_statics()
        };
        assert!((read(rising).unwrap() - 12.0).abs() < 1e-12);
        // A bump of 4 in the middle: its force is spread over both halves.
        let bump = line([0.0, 1.0, 2.0], [10.0, 16.0, 14.0]);
        assert!((read(bump).unwrap() - 14.0).abs() < 1e-12);
        assert_eq!(read(line([0.0, 1.0, 2.0], [0.0; 3])), None);
    }

    #[test]
    fn a_mean_load_is_that_of_the_row_where_loads_rise_evenly() {
        let even = line([0.0, 1.0, 4.0], [10.0, 12.0, 18.0]);
        assert!((even.heaviest_mean_load() - 12.0).abs() < 1e-12);
        // Loads of 30 that alternate by 3 on both sides: two thirds of that are gone.
        let alternating = line([0.0, 1.0, 2.0], [27.0, 33.0, 27.0]);
        assert!((alternating.heaviest_mean_load() - 31.0).abs() < 1e-12);
    }
}
