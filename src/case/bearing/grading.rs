//! How many elements a graded line has, as the macro `Spacing` of the templates makes them.

/// A place on a line that nodes are graded towards: where, the element size there (`None`: any), and how many
/// elements of it on either side.
pub(super) type Stop = (f64, Option<f64>, f64);

/// How the elements of a line are graded.
pub(super) struct GradedInterval {
    pub growth: f64,
    pub cap: f64,
    pub least: f64,
    pub uniform: bool,
}

/// The most elements between two stops of a grading, as in the template; an interval that asks for more gets
/// elements larger than it asked for.
const MOST_ELEMENTS: usize = 1000;

impl GradedInterval {
    /// Elements on a line between its first and its last stop, as `meshes/spacing.geo` places them.
    pub fn elements(&self, stops: &[Stop]) -> f64 {
        stops.windows(2).map(|ends| self.interval(ends)).sum()
    }

    fn interval(&self, ends: &[Stop]) -> f64 {
        let [(from, a, fine_a), (to, b, fine_b)] = [ends[0], ends[1]];
        let length: f64 = (to - from).abs();
        if self.uniform {
            return (length / self.cap + 0.5).floor().max(self.least).max(1.0);
        }
        let [a, b] = [a, b].map(|size| size.unwrap_or(1e30));
        let grown = |size: f64, n: usize, fine: f64| {
            size * self.growth.powf((n as f64 + 1.0 - fine).max(0.0))
        };
        let (mut of_a, mut of_b, mut sum) = (0, 0, 0.0);
        for _ in 0..MOST_ELEMENTS {
            if sum >= length * (1.0 - 1e-9) && (of_a + of_b) as f64 >= self.least {
                break;
            }
            let (next_a, next_b) = (grown(a, of_a, fine_a), grown(b, of_b, fine_b));
            if next_a <= next_b * (1.0 + 1e-9) {
                of_a += 1
            } else {
                of_b += 1
            }
            sum += self.cap.min(next_a).min(next_b);
        }
        (of_a + of_b) as f64
    }
}
