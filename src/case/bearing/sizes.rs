//! Element sizes and counts of the bearing template, under their names in the case file and in
//! the template.

use super::end_zone::EndZone;

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

/// Sizes that go by the plates and by what lies across a roller: each template has its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct OwnSizes {
    /// As of [`Sizes`].
    pub crossing_size: f64,
    /// As of [`Sizes`].
    pub plan_cap: f64,
    /// As of [`Sizes`].
    pub middle_cap: f64,
    /// As of [`Sizes`].
    pub depth_cap: f64,
    /// What lies at the ends of rollers.
    pub end_zone: EndZone,
}

impl OwnSizes {
    /// See [`EndZone::end_size`].
    pub fn end_size(&self, most: f64) -> f64 {
        self.end_zone.end_size(most)
    }
}

/// What a number of [`Sizes`] measures, which decides how it scales.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SizeKind {
    /// A length.
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
    /// What is measured.
    pub kind: SizeKind,
}

const fn key(key: &'static str, parameter: &'static str, kind: SizeKind) -> MeshKey {
    MeshKey {
        key,
        parameter,
        kind,
    }
}

/// The numbers of [`Sizes`] that a case file may set.
pub const MESH_KEYS: [MeshKey; 18] = [
    key("roller_size", "RollerSize", SizeKind::Length),
    key("plate_size", "PlateSize", SizeKind::Length),
    key("fine_elements", "FineElements", SizeKind::Count),
    key("fine_layers", "FineLayers", SizeKind::Count),
    key("crossing_size", "CrossingSize", SizeKind::Length),
    key("end_size", "EndSize", SizeKind::Length),
    key("growth", "Growth", SizeKind::Ratio),
    key("depth_growth", "DepthGrowth", SizeKind::Ratio),
    key("along_growth", "AlongGrowth", SizeKind::Ratio),
    key("around_cap", "AroundCap", SizeKind::Length),
    key("along_cap", "AlongCap", SizeKind::Length),
    key("wall_cap", "WallCap", SizeKind::Length),
    key("plan_cap", "PlanCap", SizeKind::Length),
    key("middle_cap", "MiddleCap", SizeKind::Length),
    key("depth_cap", "DepthCap", SizeKind::Length),
    key("wall_least", "WallLeast", SizeKind::Count),
    key("depth_least", "DepthLeast", SizeKind::Count),
    key("along_least", "AlongLeast", SizeKind::Count),
];

/// Plate elements across a contact line against those of the roller: unequal, so that the nodes of the two
/// surfaces do not meet.
pub(super) const PLATE_TO_ROLLER: f64 = 1.06;

/// The most by which an element may be larger than the one before it.
pub(super) const MOST_GROWTH: f64 = 10.0;

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
                SizeKind::Length => *field * scale,
                SizeKind::Count => (*field / scale).round().max(1.0),
                // Beyond that the next element is a coarse one anyway.
                SizeKind::Ratio => field.powf(scale).min(MOST_GROWTH),
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
