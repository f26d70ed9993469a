//! An interface of a bearing: where a roller lies on a plate, and how.

/// A roller on a plate: an interface of a bearing.
#[derive(Debug, Clone, PartialEq)]
pub struct Seat {
    /// `<upper>-<lower>`.
    pub interface: String,
    /// Surface of the upper body.
    pub upper: String,
    /// Surface of the lower body.
    pub lower: String,
    /// Body of the roller.
    pub roller: String,
    /// Body of the plate.
    pub plate: String,
    /// Is the roller the upper one of the two?
    pub roller_above: bool,
    /// The axis along the roller: 0 (x) or 1 (y).
    pub axis: usize,
    /// Effective radius R' of roller and plate: 1/R' = 1/R + curvature of the plate.
    pub radius: f64,
    /// Curvature of the plate across the roller: 0 where it is flat, positive where it bulges towards the roller,
    /// negative where it is a groove that the roller lies in.
    pub curvature: f64,
    /// Slope of the plate's face against the horizontal, in radians.
    pub slope: f64,
    /// Where the lines of contact lie in the geometry, along the horizontal axis across the roller, ascending.
    pub lines: Vec<f64>,
    /// Rollers side by side that share the load.
    pub sharing: usize,
    /// Do statics say what share of the load a line has?
    pub determinate: bool,
    /// Length over which the straight part of the roller and the plate face each other.
    pub bears: f64,
    /// Where they cease to, from the middle: at an end of the roller, or of a plate that is shorter than its straight part.
    pub ends_at: f64,
    /// By how much the plate stands out beyond each end of the roller; 0 where it does not.
    pub overhang: f64,
    /// Thickness of the plate below the line.
    pub plate_thickness: f64,
}

impl Seat {
    /// The force normal to the surface that a line takes of `load`, were it spread evenly over rollers and lines.
    pub fn even(&self, load: f64) -> f64 {
        load / ((self.sharing * self.lines.len()) as f64 * self.slope.cos())
    }

    /// Do two lines of one roller lie side by side here, as in a valley?
    pub fn is_valley(&self) -> bool {
        self.lines.len() > 1
    }

    /// How far fine elements must reach from where a line lies in the geometry, to serve `half` to either side of what
    /// is pressed at `across`. What a roller covers between the two lines of its valley is on both their fine elements.
    pub fn reach(&self, across: f64, half: f64) -> f64 {
        match self.lines.as_slice() {
            [_, line] => {
                let across = across.abs();
                let outward = across + half - line;
                let inward = line - (across - half).max(0.0);
                outward.max(inward)
            }
            lines => {
                let off = lines.iter().map(|line| (across - line).abs());
                off.fold(f64::INFINITY, f64::min) + half
            }
        }
    }
}
