//! Element sizes and counts of the bearing template, under their names in the case file and in
//! the template.

/// Element sizes and counts of a mesh, lengths in the unit of the bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sizes {
    /// Equal elements of the largest sizes, and node rows only on the centre lines.
    pub uniform: bool,
    /// Across the contact lines, on the rollers.
    pub roller_size: f64,
    /// Across the contact lines, on the plates: unlike that of the rollers, so that the nodes of
    /// the two sides do not meet.
    pub plate_size: f64,
    /// Elements of that size on either side of a contact line.
    pub fine_elements: f64,
    /// Layers of that size below a contact face.
    pub fine_layers: f64,
    /// Along a roller, where the other one crosses.
    pub crossing_size: f64,
    /// Along a roller, at its ends.
    pub end_size: f64,
    /// Largest ratio of neighbouring elements: across the lines.
    pub growth: f64,
    /// ... into the depth.
    pub depth_growth: f64,
    /// ... along the rollers.
    pub along_growth: f64,
    /// Largest element around a roller.
    pub around_cap: f64,
    /// ... along a roller.
    pub along_cap: f64,
    /// ... through the wall of a roller.
    pub wall_cap: f64,
    /// ... in plan, in the flat plates.
    pub plan_cap: f64,
    /// ... in plan, in the intermediate plate.
    pub middle_cap: f64,
    /// ... through the plates.
    pub depth_cap: f64,
    /// Fewest elements through the wall.
    pub wall_least: f64,
    /// ... through each plate.
    pub depth_least: f64,
    /// ... along half a roller of a centred bearing.
    pub along_least: f64,
}

/// What a number of [`Sizes`] measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A length, in the unit of the case.
    Length,
    /// A number of elements.
    Count,
    /// A ratio.
    Ratio,
}

/// A number of [`Sizes`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MeshKey {
    /// In `[mesh]` of a case file.
    pub key: &'static str,
    /// In the template.
    pub parameter: &'static str,
    /// What kind of number it is.
    pub kind: Kind,
}

const fn key(key: &'static str, parameter: &'static str, kind: Kind) -> MeshKey {
    MeshKey {
        key,
        parameter,
        kind,
    }
}

/// The numbers of [`Sizes`] that a case file may set.
pub const MESH_KEYS: [MeshKey; 18] = [
    key("roller_size", "RollerSize", Kind::Length),
    key("plate_size", "PlateSize", Kind::Length),
    key("fine_elements", "FineElements", Kind::Count),
    key("fine_layers", "FineLayers", Kind::Count),
    key("crossing_size", "CrossingSize", Kind::Length),
    key("end_size", "EndSize", Kind::Length),
    key("growth", "Growth", Kind::Ratio),
    key("depth_growth", "DepthGrowth", Kind::Ratio),
    key("along_growth", "AlongGrowth", Kind::Ratio),
    key("around_cap", "AroundCap", Kind::Length),
    key("along_cap", "AlongCap", Kind::Length),
    key("wall_cap", "WallCap", Kind::Length),
    key("plan_cap", "PlanCap", Kind::Length),
    key("middle_cap", "MiddleCap", Kind::Length),
    key("depth_cap", "DepthCap", Kind::Length),
    key("wall_least", "WallLeast", Kind::Count),
    key("depth_least", "DepthLeast", Kind::Count),
    key("along_least", "AlongLeast", Kind::Count),
];

impl Sizes {
    /// The numbers, in the order of [`MESH_KEYS`].
    pub fn values(&self) -> [f64; MESH_KEYS.len()] {
        let mut copy = *self;
        copy.fields().map(|field| *field)
    }

    /// Every element `scale` times as large, the grading kept: over a given distance the size
    /// grows by the same factor. Counts are rounded.
    pub fn scaled(mut self, scale: f64) -> Self {
        for (key, field) in MESH_KEYS.iter().zip(self.fields()) {
            *field = match key.kind {
                Kind::Length => *field * scale,
                Kind::Count => (*field / scale).round().max(1.0),
                Kind::Ratio => field.powf(scale),
            };
        }
        self
    }

    /// The number called `key` in a case file.
    pub fn get_mut(&mut self, key: &str) -> Option<&mut f64> {
        let index = MESH_KEYS.iter().position(|k| k.key == key)?;
        self.fields().into_iter().nth(index)
    }

    fn fields(&mut self) -> [&mut f64; MESH_KEYS.len()] {
        [
            &mut self.roller_size,
            &mut self.plate_size,
            &mut self.fine_elements,
            &mut self.fine_layers,
            &mut self.crossing_size,
            &mut self.end_size,
            &mut self.growth,
            &mut self.depth_growth,
            &mut self.along_growth,
            &mut self.around_cap,
            &mut self.along_cap,
            &mut self.wall_cap,
            &mut self.plan_cap,
            &mut self.middle_cap,
            &mut self.depth_cap,
            &mut self.wall_least,
            &mut self.depth_least,
            &mut self.along_least,
        ]
    }
}
