//! The two fine meshes of a bearing, from which its true values are extrapolated.

use super::solution::SolvedBearing;
use crate::case::bearing::{MeshRequest, Preset};
use crate::case::{BearingCase, Case, CaseError, ErrorKind, Kind};
use std::f64::consts::PI;

/// How fine. A displaced bearing is modelled as a whole, at some four times the cost.
struct Fineness {
    /// Elements across the narrowest half-width.
    across: f64,
    /// Of the smallest elements, below the surface.
    layers: f64,
    growth: f64,
    /// Elements around and through the walls of rollers, in diameters: they decide about the descent
    /// and the stress of the bore.
    far: f64,
}

const CENTRED: Fineness = Fineness {
    across: 5.5,
    layers: 4.0,
    growth: 1.8,
    far: 0.045,
};

const DISPLACED: Fineness = Fineness {
    across: 4.5,
    layers: 3.0,
    growth: 2.2,
    far: 0.06,
};

/// Element sizes of the two meshes, relative to that; finer last. Flow takes ten increments and more, so that
/// its meshes have to be coarser.
const ELASTIC_SIZES: [f64; 2] = [1.12, 0.8];
const PLASTIC_SIZES: [f64; 2] = [1.96, 1.4];

/// Elements of the finer mesh, at most. Of bearings that take more both meshes are coarser, and their true values less certain.
const MOST_ELEMENTS: f64 = 2e5;

/// How many of the widest half-widths the fine zone reaches to either side.
const FINE_ZONE: f64 = 1.4;

/// Elements at the ends of rollers, of their length: four in what belongs to a loaded edge, a fiftieth of the
/// contact surface. Beside that the stress away from edges is largest.
const AT_ENDS: f64 = 0.02 / 4.0;

/// `case` on its two fine meshes. How wide its strips are is known from the line loads of `coarse`,
/// which coarse meshes have within some per cent.
///
/// # Errors
/// Where the case is no bearing, or a mesh cannot be made so fine.
pub fn cases(case: &Case, coarse: &SolvedBearing) -> Result<[(f64, Case); 2], CaseError> {
    let [coarser, finer] = match case.controls.plasticity {
        true => PLASTIC_SIZES,
        false => ELASTIC_SIZES,
    };
    let finest = scaled(case, coarse, finer)?;
    let counted = finest.bearing().map_or(0.0, BearingCase::elements);
    let larger = (counted / MOST_ELEMENTS).max(1.0).cbrt();
    let case = |scale: f64| Ok::<_, CaseError>((scale, scaled(case, coarse, larger * scale)?));
    Ok([case(coarser)?, case(finer)?])
}

fn scaled(case: &Case, coarse: &SolvedBearing, scale: f64) -> Result<Case, CaseError> {
    let mut case = case.clone();
    let wrong = |text: String| CaseError::new(ErrorKind::Value, text);
    let Kind::Bearing(bearing) = &mut case.kind else {
        return Err(wrong("fine meshes are those of bearings".into()));
    };
    let geometry = &bearing.geometry;
    let fineness = if bearing.is_whole() {
        DISPLACED
    } else {
        CENTRED
    };
    let rollers = geometry.rollers(bearing.mesh.full);
    let roller = rollers.first().map_or("", |roller| roller.body.as_str());
    let steel = bearing.steels.of(roller)?;
    let radius = geometry.roller().radius();
    let compliance = 2.0 * (1.0 - steel.poissons_ratio.powi(2)) / steel.youngs_modulus;
    let half_width = |load: f64| (4.0 * load * radius * compliance / PI).sqrt();
    let widths = coarse.strips.values().map(|s| half_width(s.line_load));
    let (narrow, wide) = widths.fold((f64::INFINITY, 0.0f64), |(least, most), a| {
        (least.min(a), most.max(a))
    });
    if !(wide > 0.0) {
        return Err(wrong("nothing is in contact".into()));
    }
    let size = narrow / fineness.across;
    let far = fineness.far * geometry.diameter();
    let wall = geometry.wall().unwrap_or(radius);
    let preset = MeshRequest {
        preset: Preset::H0125,
        ..MeshRequest::default()
    };
    let at_ends = AT_ENDS * geometry.roller().length;
    let at_ends = at_ends.min(preset.sizes(bearing.layout()).end_size);
    let overrides = [
        ("roller_size", size),
        ("end_size", at_ends),
        ("fine_elements", (FINE_ZONE * wide / size).ceil()),
        ("fine_layers", fineness.layers),
        ("growth", fineness.growth),
        ("depth_growth", fineness.growth),
        ("around_cap", far),
        ("wall_cap", far.min(wall / 6.0)),
    ];
    bearing.mesh = MeshRequest {
        overrides: overrides
            .map(|(key, value)| (key.to_owned(), value))
            .to_vec(),
        scale,
        full: bearing.mesh.full,
        ..preset
    };
    let fits = bearing.mesh.check(bearing.layout());
    fits.map_err(|error| wrong(error.to_string()))?;
    Ok(case)
}
