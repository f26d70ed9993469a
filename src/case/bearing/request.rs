//! What a case asks of the mesh: a preset, numbers in place of its own, a scale.

use std::ops::RangeInclusive;

use super::error::GeometryError;
use super::layout::Layout;
use super::preset::Preset;
use super::scales::Scales;
use super::sizes::{MESH_KEYS, MOST_GROWTH, PLATE_TO_ROLLER, SizeKind, Sizes};
use super::strips::{FoundLine, Strips};

/// How a bearing is to be meshed.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshRequest {
    /// Which choice of element sizes.
    pub preset: Preset,
    /// What `auto` is sized by; `None` where nothing is known of the load.
    pub strips: Option<Strips>,
    /// Numbers in place of those of the preset, by key of [`MESH_KEYS`]; lengths in the unit of
    /// the bearing. A `roller_size` without a `plate_size` changes both.
    pub overrides: Vec<(String, f64)>,
    /// Every element this many times as large as those say, in every direction, the grading kept;
    /// see [`Sizes::scaled`].
    pub scale: f64,
    /// Beyond that, groups of elements by themselves.
    pub scales: Scales,
    /// All four quarters of a centred bearing; a displaced one is always whole.
    pub full: bool,
}

impl Default for MeshRequest {
    fn default() -> Self {
        Self {
            preset: Preset::default(),
            strips: None,
            overrides: Vec::new(),
            scale: 1.0,
            scales: Scales::default(),
            full: false,
        }
    }
}

/// Scales beyond these make no mesh that is of use: 5 leaves one element where there were five.
const SCALES: RangeInclusive<f64> = 0.02..=5.0;

/// More fine elements than this are not added for rollers askew: they are coarser instead.
const MOST_STRAY: f64 = 150.0;

impl MeshRequest {
    /// The sizes of the preset with the overrides in their places, all scaled; overrides whose keys
    /// are not in [`MESH_KEYS`] are passed over.
    pub fn sizes(&self, geometry: &dyn Layout) -> Sizes {
        self.scales.of(self.unscaled(geometry).scaled(self.scale))
    }

    fn unscaled(&self, geometry: &dyn Layout) -> Sizes {
        let strips = (self.strips).unwrap_or_else(|| Strips::nominal(geometry.diameter()));
        let mut sizes = geometry.preset_sizes(self.preset, &strips);
        for (key, value) in &self.overrides {
            if let Some(number) = sizes.get_mut(key) {
                *number = *value;
            }
        }
        let given = |key: &str| self.gives(key);
        let mut is_new = given("roller_size");
        // Fine elements lie along the plates, and the lines of rollers askew do not.
        if !given("fine_elements") {
            let least = geometry.stray() / MOST_STRAY;
            if !is_new && sizes.roller_size < least {
                sizes.roller_size = least;
                is_new = true;
            }
            sizes.fine_elements += (geometry.stray() / sizes.roller_size).ceil();
        }
        if is_new && !given("plate_size") {
            sizes.plate_size = PLATE_TO_ROLLER * sizes.roller_size;
        }
        sizes
    }

    /// Is there a number in place of that of the preset?
    fn gives(&self, key: &str) -> bool {
        self.overrides.iter().any(|(k, _)| k == key)
    }

    /// The keys of `[mesh]` that stand in place of numbers of the preset, or change them.
    pub fn own_numbers(&self) -> Vec<String> {
        let scale = (self.scale != 1.0).then(|| "scale".to_owned());
        let overrides = self.overrides.iter().map(|(key, _)| key.clone());
        scale.into_iter().chain(overrides).collect()
    }

    /// The same mesh with every element `scale` times as large, see [`Sizes::scaled`].
    pub fn scaled(&self, scale: f64) -> Self {
        Self {
            scale: self.scale * scale,
            ..self.clone()
        }
    }

    /// The same mesh with elements at the contact `scale` times as large.
    pub fn sharpened(&self, scale: f64) -> Self {
        self.refined(&Scales {
            contact: scale,
            ..Scales::default()
        })
    }

    /// The same mesh with groups of elements this many times as large.
    pub fn refined(&self, scales: &Scales) -> Self {
        Self {
            scales: self.scales.and(scales),
            ..self.clone()
        }
    }

    /// Lines of contact that these elements do not serve: fewer than three across a half-width, or
    /// coarser ones within 1.3 of it, on the rollers. Asked before they are scaled, so that all scales of a mesh
    /// are made for the same lines.
    pub fn unserved<'l>(
        &self,
        geometry: &dyn Layout,
        lines: &'l [FoundLine],
    ) -> Vec<&'l FoundLine> {
        let sizes = self.unscaled(geometry);
        let size = sizes.roller_size;
        let fine = sizes.fine_elements * size - geometry.stray();
        let unserved = |line: &&FoundLine| !line.is_served(size, fine);
        lines.iter().filter(unserved).collect()
    }

    /// Can this mesh be made?
    ///
    /// # Errors
    /// Names the first number that is out of its range, with the range.
    pub fn check(&self, geometry: &dyn Layout) -> Result<(), GeometryError> {
        geometry.check()?;
        let (least, most) = (SCALES.start(), SCALES.end());
        GeometryError::unless(
            SCALES.contains(&self.scale),
            "scale",
            self.scale,
            || format!("must lie between {least} and {most}"),
            "every element this many times as large as the preset has it",
        )?;
        // Scaling mends counts of none, so what was asked for is looked at, too.
        let unscaled = self.unscaled(geometry);
        check_sizes(&unscaled, geometry).map_err(|error| match error.key {
            // The case says a size, and not over how many of them a roller askew strays.
            "fine_elements" if !self.gives("fine_elements") => GeometryError {
                key: "roller_size",
                value: unscaled.roller_size,
                range: implied(&error),
                help: "a larger size, or rollers less askew",
            },
            _ => error,
        })?;
        check_sizes(&self.sizes(geometry), geometry).map_err(|error| match self.scale {
            1.0 => error,
            // The case says a scale, and not this size.
            scale => GeometryError {
                key: "scale",
                value: scale,
                range: implied(&error),
                help: "a scale nearer to 1, or another preset",
            },
        })
    }
}

/// What a number makes of another one that cannot be.
fn implied(error: &GeometryError) -> String {
    format!(
        "makes `{}` {}, which {}",
        error.key, error.value, error.range
    )
}

/// Can a mesh of these sizes be made?
fn check_sizes(sizes: &Sizes, geometry: &dyn Layout) -> Result<(), GeometryError> {
    for (key, value) in MESH_KEYS.iter().zip(sizes.values()) {
        let (least, most, range) = match key.kind {
            // Finer meshes than this could not be solved, nor made in reasonable time.
            SizeKind::Length => {
                let least = 1e-4 * geometry.diameter();
                let range = format!("must be at least {least} (1e-4 diameters)");
                (least, f64::MAX, range)
            }
            SizeKind::Count => (1.0, 200.0, "must lie between 1 and 200".into()),
            SizeKind::Ratio => {
                let range = format!("must lie between 1 and {MOST_GROWTH}");
                (1.0, MOST_GROWTH, range)
            }
        };
        let help = "a size, count or growth of the bearing template";
        GeometryError::unless(
            value >= least && value <= most,
            key.key,
            value,
            || range,
            help,
        )?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::bearing::geometry::BearingGeometry;
    use crate::case::bearing::sample::initial;

    #[test]
    fn overrides_take_the_place_of_the_preset() {
        let request = MeshRequest {
            overrides: vec![("roller_size".into(), 0.05), ("growth".into(), 1.3)],
            ..MeshRequest::default()
        };
        let sizes = request.sizes(&initial());
        assert_eq!([sizes.roller_size, sizes.growth], [0.05, 1.3]);
        assert!((sizes.plate_size - 0.053).abs() < 1e-12);
        assert!(request.check(&initial()).is_ok());
    }

    #[test]
    fn a_scale_takes_every_number_along() {
        let base = MeshRequest {
            preset: Preset::H025,
            overrides: vec![("wall_least".into(), 8.0), ("growth".into(), 4.0)],
            ..MeshRequest::default()
        };
        let half = base.scaled(0.5).sizes(&initial());
        assert_eq!(half, base.sizes(&initial()).scaled(0.5));
        let found = [half.roller_size, half.wall_least, half.growth];
        assert_eq!(found, [0.0125, 16.0, 2.0]);
        assert_eq!(base.scaled(0.5).scaled(2.0), base, "no rounding adds up");
        for scale in [0.0, -1.0, f64::NAN, 50.0] {
            let error = base.scaled(scale).check(&initial()).expect_err("a scale");
            assert_eq!(error.key, "scale");
        }
    }

    #[test]
    fn every_scale_up_to_the_largest_makes_a_mesh() {
        for preset in Preset::ALL {
            let request = MeshRequest {
                preset,
                scale: 5.0,
                ..MeshRequest::default()
            };
            assert_eq!(request.check(&initial()), Ok(()), "{preset}");
        }
        // What a scale makes of a size is put down to the scale.
        let fine = MeshRequest {
            scale: 0.02,
            ..MeshRequest::default()
        };
        let error = fine.check(&initial()).expect_err("too fine");
        assert_eq!(error.key, "scale");
        assert!(error.range.contains("`roller_size`"), "{error}");
    }

    #[test]
    fn a_sharper_contact_leaves_the_rest() {
        let base = MeshRequest::default();
        let (before, after) = (
            base.sizes(&initial()),
            base.sharpened(0.5).sizes(&initial()),
        );
        assert_eq!(after.roller_size, 0.5 * before.roller_size);
        assert_eq!(after.fine_elements, 2.0 * before.fine_elements);
        assert_eq!(after.crossing_size, before.crossing_size);
    }

    #[test]
    fn fine_elements_reach_the_lines_of_rollers_askew() {
        let askew = BearingGeometry {
            skew: [0.1, 0.0],
            ..initial()
        };
        let with = |preset, overrides: &[(&str, f64)]| MeshRequest {
            preset,
            strips: Strips::found(
                3.0,
                &[FoundLine {
                    half_width: 0.003,
                    reach: 0.01,
                }],
            ),
            overrides: overrides.iter().map(|(k, v)| (k.to_string(), *v)).collect(),
            ..MeshRequest::default()
        };
        for request in [
            with(Preset::Auto, &[]),
            with(Preset::H025, &[]),
            with(Preset::H025, &[("roller_size", 0.005)]),
        ] {
            assert_eq!(request.check(&askew), Ok(()));
            let sizes = request.sizes(&askew);
            assert!(sizes.fine_elements * sizes.roller_size > askew.stray());
            assert_eq!(sizes.plate_size, PLATE_TO_ROLLER * sizes.roller_size);
        }
        let own = with(Preset::H025, &[("fine_elements", 3.0)]);
        assert_eq!(own.sizes(&askew).fine_elements, 3.0);
        let error = with(Preset::H025, &[("roller_size", 0.001)]).check(&askew);
        let error = error.expect_err("four hundred elements");
        assert_eq!(error.key, "roller_size");
        assert!(error.range.contains("makes `fine_elements` 404"), "{error}");
    }

    #[test]
    fn each_scale_has_its_own_sizes() {
        let base = MeshRequest::default();
        let scales = Scales {
            contact: 0.5,
            transition: 0.25,
            round: 0.25,
            along: 0.5,
        };
        let (before, after) = (
            base.sizes(&initial()),
            base.refined(&scales).sizes(&initial()),
        );
        let ratio = |of: fn(&Sizes) -> f64| of(&after) / of(&before);
        assert_eq!(ratio(|s| s.roller_size), 0.5);
        assert_eq!(ratio(|s| s.around_cap), 0.25);
        assert_eq!(ratio(|s| s.plan_cap), 0.5);
        assert_eq!(ratio(|s| s.end_size), 0.5);
        assert_eq!(after.along_growth, before.along_growth.sqrt());
        assert_eq!(after.growth, before.growth.sqrt());
        assert_eq!(after.depth_growth, before.depth_growth.sqrt());
        let none = base.refined(&scales.part(0.0)).sizes(&initial());
        assert_eq!(none, before);
    }

    #[test]
    fn impossible_sizes_are_refused_by_name() {
        for (key, value) in [
            ("roller_size", 0.0),
            ("end_size", -1.0),
            ("growth", 0.9),
            ("fine_layers", 0.0),
            ("depth_cap", f64::NAN),
        ] {
            let request = MeshRequest {
                overrides: vec![(key.into(), value)],
                ..MeshRequest::default()
            };
            let error = request.check(&initial()).expect_err(key);
            assert_eq!(error.key, key);
        }
    }
}
