//! The figures of a bearing on its two fine meshes, and the true values that they tell.

use super::solution::SolvedBearing;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What is claimed of the descent, and that of the nodes, to which nothing is added for what the mesh misses.
const DESCENT: &str = "descent";
const DESCENT_OF_MESH: &str = "descent_of_mesh";

/// Figures of the far field: no contact strip has to be resolved for them.
const FAR_FIELD: [&str; 3] = [DESCENT, DESCENT_OF_MESH, "bore_mises"];

/// Share of the difference of two meshes that is extrapolated near the contact: half of it, and a little more so that
/// the uncertainty, as large, holds both no change and all of it.
const EXTRAPOLATED_SHARE: f64 = 0.55;

/// Figures by what they are and where, each on the coarser and on the finer mesh; none where that
/// mesh does not have it.
pub type FigurePairs = BTreeMap<String, BTreeMap<String, [Option<f64>; 2]>>;

/// A bearing on its two meshes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MeshPair {
    pub version: String,
    pub unknowns: [usize; 2],
    pub cpu_s: [f64; 2],
    pub figures: FigurePairs,
}

/// A true value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Truth {
    #[serde(rename = "true_value")]
    pub value: f64,
    /// How far it may be off.
    pub uncertainty: f64,
}

impl MeshPair {
    /// The true value of a figure.
    ///
    /// The descent is told by two series, that of the nodes and that of what is claimed. Both tend to the true one,
    /// the latter much faster, so that it is taken; it is no more certain than the two agree.
    pub fn truth(&self, what: &str, place: &str, scatter: &BTreeMap<String, f64>) -> Option<Truth> {
        let limit = |what| self.limit(what, place, scatter);
        if what != DESCENT {
            return limit(what);
        }
        let of_nodes = limit(DESCENT_OF_MESH)?;
        let Some(claimed) = limit(DESCENT) else {
            return Some(of_nodes);
        };
        let apart = (claimed.value - of_nodes.value).abs();
        Some(Truth {
            uncertainty: claimed.uncertainty.max(apart),
            ..claimed
        })
    }

    /// What the two meshes tend to.
    ///
    /// Errors of order 2, as those of the descent and of the stress of the bore are, extrapolate by the
    /// difference of the meshes once more, at sizes of 1 to 1.4. Readings near the contact may not extrapolate
    /// at all: about half of the difference is added. The uncertainty, as much again, holds both; where errors of
    /// either sign can cancel it is no less than this share of what the figure scatters by in the middle of all bearings.
    fn limit(&self, what: &str, place: &str, scatter: &BTreeMap<String, f64>) -> Option<Truth> {
        let [coarse, fine] = *self.figures.get(what)?.get(place)?;
        let (coarse, fine) = (coarse?, fine?);
        let step = fine - coarse;
        let smooth = FAR_FIELD.contains(&what);
        let floor = match what {
            DESCENT_OF_MESH | "bore_mises" => 0.0,
            // A line that touches over all of its length does so on any mesh.
            _ if step == 0.0 => 0.0,
            _ => scatter.get(what).copied().unwrap_or(0.0) * fine.abs(),
        };
        Some(Truth {
            value: fine
                + if smooth {
                    step
                } else {
                    EXTRAPOLATED_SHARE * step
                },
            uncertainty: EXTRAPOLATED_SHARE * step.abs().max(floor),
        })
    }

    /// The figures of the coarser and of the finer mesh.
    pub fn new(solved: &[SolvedBearing; 2]) -> Self {
        let mut figures = FigurePairs::new();
        for (mesh, solved) in solved.iter().enumerate() {
            for reading in &solved.readings {
                let places = figures.entry(reading.what.clone()).or_default();
                places.entry(reading.place.clone()).or_default()[mesh] =
                    Some(rounded(reading.value));
            }
            if let Some(descent) = solved.descent_of_mesh {
                let places = figures.entry(DESCENT_OF_MESH.into()).or_default();
                let descent = Some(rounded(descent));
                places.entry("overall".into()).or_default()[mesh] = descent;
            }
            // A body that has not flowed has no claim of it, and a plastic strain of zero.
            for (body, flow) in &solved.flow {
                let places = figures.entry("peak_plastic_strain".into()).or_default();
                places.entry(body.clone()).or_default()[mesh] = Some(rounded(*flow));
            }
        }
        Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            unknowns: solved.each_ref().map(|s| s.unknowns),
            cpu_s: solved.each_ref().map(|s| (10.0 * s.cpu_s).round() / 10.0),
            figures,
        }
    }
}

/// To seven digits: files stay small.
fn rounded(value: f64) -> f64 {
    format!("{value:.6e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pair<const N: usize>(figures: [(&str, [f64; 2]); N]) -> MeshPair {
        let overall = |two: [f64; 2]| BTreeMap::from([("overall".to_owned(), two.map(Some))]);
        MeshPair {
            version: String::new(),
            unknowns: [0; 2],
            cpu_s: [0.0; 2],
            figures: (figures.into_iter())
                .map(|(what, two)| (what.to_owned(), overall(two)))
                .collect(),
        }
    }

    /// Nothing is claimed of the descent where the mesh adds nothing; an error of the nodes of 1 %, and one of 0.2 %
    /// where some of it is added. Of another order they do not agree.
    #[test]
    fn the_descent_is_told_by_two_series() {
        let on =
            |error: f64, order: f64| [1.4f64, 1.0].map(|h| 10.0 * (1.0 - error * h.powf(order)));
        let truth = |pair: MeshPair| pair.truth(DESCENT, "overall", &BTreeMap::new()).unwrap();
        let nodes = truth(pair([(DESCENT_OF_MESH, on(0.01, 2.0))]));
        assert!((nodes.value - 10.0).abs() < 0.005 && nodes.uncertainty > 0.05);
        let both = |order| {
            let of_nodes = (DESCENT_OF_MESH, on(0.01, order));
            truth(pair([(DESCENT, on(0.002, 2.0)), of_nodes]))
        };
        let second = both(2.0);
        assert!((second.value - 10.0).abs() < 0.001 && second.uncertainty < 0.015);
        assert!(both(1.0).uncertainty > 0.05);
    }

    /// An error of order 2 at sizes of 1.4 and 1 is (1.4² − 1) = 0.96 of the difference on the finer mesh.
    #[test]
    fn true_values_are_within_their_uncertainty() {
        for order in [2.0, 2.3, 2.6] {
            // The floor is 0.55 % of the value on the finer mesh, 9.9.
            for (what, least) in [("bore_mises", 0.0), ("peak_pressure", 0.054)] {
                let on = |size: f64| 10.0 * (1.0 - 0.01 * size.powf(order));
                let pair = pair([(what, [on(1.4), on(1.0)])]);
                let scatter = BTreeMap::from([("peak_pressure".to_owned(), 0.01)]);
                let truth = pair.truth(what, "overall", &scatter).unwrap();
                let error = (truth.value - 10.0).abs();
                assert!(
                    error <= truth.uncertainty,
                    "{what} {order}: {error} {truth:?}"
                );
                assert!(truth.uncertainty >= least);
                // No more than the difference of the meshes, or the floor.
                assert!(truth.uncertainty <= (on(1.4) - on(1.0)).abs().max(0.1));
            }
        }
    }
}
