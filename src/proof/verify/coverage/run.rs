//! Making the true values that are missing, and judging claims by them.

use super::bearing::Bearing;
use super::make::make;
use super::measure::{self, ClaimRecord};
use super::page::line;
use super::reference::References;
use super::set::Set;
use super::solution::Keep;
use crate::case::bearing::Preset;
use crate::product::job::JobError;
use crate::solver::solve::Observer;

/// The presets whose claims are judged.
const PRESETS: [&str; 3] = ["h025", "h0125", "auto"];

/// Those of them that there are.
pub fn presets() -> Vec<String> {
    let there = |name: &&str| Preset::ALL.iter().any(|preset| preset.name() == *name);
    let names = PRESETS.into_iter().filter(there);
    names.map(str::to_owned).collect()
}

/// What is to be done, where it is kept and who is told.
pub struct CoverageRun<'a> {
    pub sets: Vec<Set>,
    /// Only bearings whose names begin so; all where there are none.
    pub only: Vec<String>,
    pub presets: Vec<String>,
    /// As drawn, too, and not only elastic?
    pub plastic: bool,
    pub keep: Keep,
    pub observer: &'a mut dyn Observer,
    /// Hears of every bearing that is done.
    pub say: &'a mut dyn FnMut(&str),
}

/// What came of it.
#[derive(Debug, Default)]
pub struct CoverageAnswer {
    pub records: Vec<ClaimRecord>,
    /// Runs that failed or are beyond a limit of every run, and why.
    pub unsolved: Vec<String>,
    /// Bearings without stored true values, and their steel.
    pub unknown: Vec<String>,
    pub interrupted: bool,
}

impl CoverageRun<'_> {
    fn bearings(&self, set: Set) -> Vec<Bearing> {
        let begins = |b: &Bearing| self.only.iter().any(|name| b.name.starts_with(name));
        let wanted = |b: &Bearing| self.only.is_empty() || begins(b);
        set.bearings().into_iter().filter(wanted).collect()
    }

    /// Makes the true values that are missing, quick ones first; each is on disk when it is done.
    ///
    /// # Errors
    /// [`JobError`] where a file cannot be written or a drawn case is not understood.
    pub fn remake(&mut self) -> Result<CoverageAnswer, JobError> {
        let mut answer = CoverageAnswer::default();
        let mut wanted = Vec::new();
        for set in self.sets.clone() {
            for bearing in self.bearings(set) {
                let displaced = bearing.is_displaced()?;
                wanted.push((displaced, false, set, bearing.clone()));
                if self.plastic && !bearing.is_elastic()? {
                    wanted.push((displaced, true, set, bearing));
                }
            }
        }
        // Centred before displaced, elastic before plastic.
        wanted.sort_by_key(|(displaced, plastic, ..)| (*plastic, *displaced));
        for (_, plastic, set, bearing) in wanted {
            let known = References::read(set)?;
            let stored = known.of(&bearing);
            if stored.is_some_and(|s| s.has(!plastic)) {
                continue;
            }
            let name = format!("{}, {}", bearing.name, steel(!plastic));
            match make(&bearing, !plastic, &self.keep, self.observer) {
                Ok(pair) => {
                    let [coarse, fine] = pair.cpu_s;
                    let unknowns = pair.unknowns;
                    (self.say)(&format!(
                        "{name}: {unknowns:?} unknowns, {coarse} and {fine} s"
                    ));
                    // Another process may have added to it.
                    let mut known = References::read(set)?;
                    known.keep(&bearing, !plastic, pair);
                    known.write(set)?;
                }
                Err(error) => {
                    if self.is_interrupted(&mut answer, &name, &error) {
                        return Ok(answer);
                    }
                }
            }
        }
        Ok(answer)
    }

    /// Notes why a run has no result; does the suite end with it?
    fn is_interrupted(&mut self, answer: &mut CoverageAnswer, name: &str, why: &JobError) -> bool {
        answer.interrupted = matches!(why, JobError::Interrupted);
        if !answer.interrupted {
            let text = format!("{name}: {why}");
            (self.say)(&text);
            answer.unsolved.push(text);
        }
        answer.interrupted
    }

    /// Solves the bearings on the presets and judges their claims, those without true values only by each other.
    ///
    /// # Errors
    /// [`JobError`] where a drawn case is not understood.
    pub fn measure(&mut self) -> Result<CoverageAnswer, JobError> {
        let mut answer = CoverageAnswer::default();
        let presets = self.presets.clone();
        for set in self.sets.clone() {
            let known = References::read(set)?;
            let scatter = known.scatter();
            for bearing in self.bearings(set) {
                let both = self.plastic && !bearing.is_elastic()?;
                let steels: &[bool] = if both { &[true, false] } else { &[true] };
                let of = |elastic: bool| known.of(&bearing).filter(|s| s.has(elastic));
                let unknown = steels.iter().filter(|elastic| of(**elastic).is_none());
                let named = unknown.map(|e| format!("{}, {}", bearing.name, steel(*e)));
                answer.unknown.extend(named);
                let runs = (presets.iter()).flat_map(|p| steels.iter().map(move |e| (p, *e)));
                for (preset, elastic) in runs {
                    let name = format!("{}, {preset}, {}", bearing.name, steel(elastic));
                    let truths = (of(elastic), &scatter);
                    let keep = &self.keep;
                    match measure::measure(&bearing, preset, elastic, truths, keep, self.observer) {
                        Ok(run) => {
                            (self.say)(&line(&name, &run.records));
                            let beyond = run.beyond_limits.iter();
                            let beyond = beyond.map(|limit| format!("{name}: {limit}"));
                            answer.unsolved.extend(beyond);
                            answer.records.extend(run.records);
                        }
                        Err(error) => {
                            if self.is_interrupted(&mut answer, &name, &error) {
                                return Ok(answer);
                            }
                        }
                    }
                }
            }
        }
        Ok(answer)
    }
}

fn steel(elastic: bool) -> &'static str {
    if elastic { "elastic" } else { "as drawn" }
}
