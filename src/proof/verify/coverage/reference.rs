//! True values, from two fine meshes, and how far they may be off themselves.

use super::bearing::Bearing;
use super::fine;
use super::quantile::quantile;
use super::set::Set;
use super::solution::{self, Keep, SolvedBearing};
use crate::ground::file::FileError;
use crate::ground::file::write_atomically;
use crate::ground::hash::Fnv;
use crate::product::job::JobError;
use crate::solver::solve::Observer;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Where the files are, from the folder of the project.
const FOLDER: &str = "cases/coverage";

/// Figures of the far field: no contact strip has to be resolved for them.
const FAR_FIELD: [&str; 2] = ["descent", "bore_mises"];

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

/// What is stored of a bearing.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Stored {
    pub bearing: String,
    /// Hash of the text of its case: another one of the same name is another bearing.
    pub case: String,
    /// All steel elastic.
    pub elastic: Option<MeshPair>,
    /// As drawn, where that is not elastic.
    pub own: Option<MeshPair>,
}

impl Stored {
    /// Is that pair there?
    pub fn has(&self, elastic: bool) -> bool {
        match elastic {
            true => self.elastic.is_some(),
            false => self.own.is_some(),
        }
    }
}

/// The references of a set.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct References(Vec<Stored>);

/// A true value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Truth {
    #[serde(rename = "true_value")]
    pub value: f64,
    /// How far it may be off.
    pub uncertainty: f64,
}

pub fn path(set: Set) -> PathBuf {
    Path::new(FOLDER).join(format!("{set}.json"))
}

fn hash(bearing: &Bearing) -> String {
    format!("{:016x}", Fnv::of(bearing.text.as_bytes()))
}

impl References {
    /// Those of `set`; none where there is no file, or it is of another format.
    pub fn read(set: Set) -> Self {
        let text = std::fs::read_to_string(path(set)).unwrap_or_default();
        Self(serde_json::from_str(&text).unwrap_or_default())
    }

    /// How many bearings are stored.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// One bearing a line.
    ///
    /// # Errors
    /// [`FileError::Write`].
    pub fn write(&self, set: Set) -> Result<(), FileError> {
        write_atomically(&path(set), |out| {
            for (number, stored) in self.0.iter().enumerate() {
                write!(out, "{}", if number == 0 { "[\n" } else { ",\n" })?;
                serde_json::to_writer(&mut *out, stored)?;
            }
            writeln!(out, "\n]")
        })
    }

    /// What is stored of `bearing`.
    pub fn of(&self, bearing: &Bearing) -> Option<&Stored> {
        let same = |s: &&Stored| s.bearing == bearing.name && s.case == hash(bearing);
        self.0.iter().find(same)
    }

    /// The entry of `bearing`, empty where there was none or one of another bearing.
    fn entry(&mut self, bearing: &Bearing) -> &mut Stored {
        let fresh = || Stored {
            bearing: bearing.name.clone(),
            case: hash(bearing),
            ..Stored::default()
        };
        match self.0.iter().position(|s| s.bearing == bearing.name) {
            Some(at) => {
                if self.0[at].case != hash(bearing) {
                    self.0[at] = fresh();
                }
                &mut self.0[at]
            }
            None => {
                self.0.push(fresh());
                let last = self.0.len() - 1;
                &mut self.0[last]
            }
        }
    }

    /// Keeps a pair.
    pub fn keep(&mut self, bearing: &Bearing, elastic: bool, pair: MeshPair) {
        let stored = self.entry(bearing);
        match elastic {
            true => stored.elastic = Some(pair),
            false => stored.own = Some(pair),
        }
    }

    /// By how much the two meshes differ, relative to the value, in the middle of all bearings, by
    /// figure.
    pub fn scatter(&self) -> BTreeMap<String, f64> {
        let pairs = (self.0.iter()).flat_map(|s| s.elastic.iter().chain(&s.own));
        let mut all: BTreeMap<String, Vec<f64>> = BTreeMap::new();
        for (what, places) in pairs.flat_map(|pair| &pair.figures) {
            let differences = places.values().filter_map(|two| match two {
                [Some(coarse), Some(fine)] if *fine != 0.0 => Some((coarse / fine - 1.0).abs()),
                _ => None,
            });
            all.entry(what.clone()).or_default().extend(differences);
        }
        let middle = |list: Vec<f64>| quantile(list, 0.5).unwrap_or(0.0);
        all.into_iter()
            .map(|(what, list)| (what, middle(list)))
            .collect()
    }
}

impl MeshPair {
    /// The true value of a figure.
    ///
    /// Errors of order 2, as those of the descent and of the stress of the bore are, extrapolate by the
    /// difference of the meshes once more, at sizes of 1 to 1.4. Readings near the contact may not extrapolate
    /// at all: about half of the difference is added. The uncertainty, as much again, holds both; it is no less
    /// than this share of what the figure scatters by in the middle of all bearings.
    pub fn truth(&self, what: &str, place: &str, scatter: &BTreeMap<String, f64>) -> Option<Truth> {
        let [coarse, fine] = *self.figures.get(what)?.get(place)?;
        let (coarse, fine) = (coarse?, fine?);
        let step = fine - coarse;
        const EXTRAPOLATED_SHARE: f64 = 0.55;
        let smooth = FAR_FIELD.contains(&what);
        let floor = match smooth {
            true => 0.0,
            // A line that touches over all of its length does so on any mesh.
            false if step == 0.0 => 0.0,
            false => scatter.get(what).copied().unwrap_or(0.0) * fine.abs(),
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

    fn new(solved: &[SolvedBearing; 2]) -> Self {
        let mut figures = FigurePairs::new();
        for (mesh, solved) in solved.iter().enumerate() {
            for reading in &solved.readings {
                let places = figures.entry(reading.what.clone()).or_default();
                places.entry(reading.place.clone()).or_default()[mesh] =
                    Some(rounded(reading.value));
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

/// Solves `bearing` on its two fine meshes.
///
/// # Errors
/// [`JobError`].
pub fn make(
    bearing: &Bearing,
    elastic: bool,
    keep: &Keep,
    observer: &mut dyn Observer,
) -> Result<MeshPair, JobError> {
    let twin = bearing.twin()?;
    let own = bearing.case()?;
    let name = |mesh: &str, elastic: bool| {
        let steel = if elastic { "elastic" } else { "own" };
        format!("{}/{mesh}-{steel}", bearing.name)
    };
    let mut coarse = twin.clone();
    coarse.set_preset("h025")?;
    let coarse = solution::solve(&coarse, (keep, &name("h025", true)), false, observer)?;
    let case = if elastic { &twin } else { &own };
    let mut solved = Vec::new();
    for (scale, case) in fine::cases(case, &coarse)? {
        let name = name(&format!("fine-{scale}"), elastic);
        solved.push(solution::solve(&case, (keep, &name), false, observer)?);
    }
    match <[SolvedBearing; 2]>::try_from(solved) {
        Ok(pair) => Ok(MeshPair::new(&pair)),
        Err(_) => Err(JobError::Interrupted),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pair(what: &str, two: [f64; 2]) -> MeshPair {
        let places = BTreeMap::from([("overall".to_owned(), two.map(Some))]);
        MeshPair {
            version: String::new(),
            unknowns: [0; 2],
            cpu_s: [0.0; 2],
            figures: BTreeMap::from([(what.to_owned(), places)]),
        }
    }

    /// An error of order 2 at sizes of 1.4 and 1 is (1.4² − 1) = 0.96 of the difference on the finer mesh.
    #[test]
    fn true_values_are_within_their_uncertainty() {
        for order in [2.0, 2.3, 2.6] {
            // The floor is 0.55 % of the value on the finer mesh, 9.9.
            for (what, least) in [("descent", 0.0), ("peak_pressure", 0.054)] {
                let on = |size: f64| 10.0 * (1.0 - 0.01 * size.powf(order));
                let pair = pair(what, [on(1.4), on(1.0)]);
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

    #[test]
    fn what_is_stored_of_a_bearing_is_not_taken_for_another_one() {
        let mut bearing = Set::Named.bearings().remove(0);
        let mut known = References::default();
        known.keep(&bearing, true, pair("descent", [1.0, 2.0]));
        known.keep(&bearing, false, pair("descent", [1.0, 3.0]));
        assert!(
            known
                .of(&bearing)
                .is_some_and(|s| s.has(true) && s.has(false))
        );
        bearing.text.push('\n');
        assert!(known.of(&bearing).is_none());
        known.keep(&bearing, true, pair("descent", [1.0, 2.0]));
        assert!(known.of(&bearing).is_some_and(|s| !s.has(false)));
        assert_eq!(known.0.len(), 1);
    }
}
