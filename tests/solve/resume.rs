//! A run that was stopped goes on as if it had not been.
//!
//! Source: the same run, left alone. Tolerance: both end within the residual that is asked for,
//! 1e-8 of the load.

use brinell::case::{self, Case};
use brinell::model::state::State;
use brinell::product::job::{self, JobError, Options, Outcome};
use brinell::solver::solve::Observer;
use std::error::Error;
use std::path::Path;

fn case() -> Case {
    let path =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/section-2.6.2/initial-centre.toml");
    let mut case = case::read(&path).unwrap();
    case.set_preset("report-like").unwrap();
    case
}

/// Stops after some increments.
struct Patience(usize);

impl Observer for Patience {
    fn increment(&mut self, _: &State) -> Result<(), Box<dyn Error + Send + Sync>> {
        self.0 -= 1;
        Ok(())
    }

    fn cancelled(&self) -> bool {
        self.0 == 0
    }
}

fn run(case: &Case, out: &Path, resume: bool, increments: usize) -> Result<Outcome, JobError> {
    let options = Options {
        out: Some(out.to_owned()),
        elastic_peaks: false,
        resume,
        report: false,
    };
    job::run(case, &options, &mut Patience(increments))
}

fn difference<const N: usize>(a: &[[f64; N]], b: &[[f64; N]]) -> f64 {
    let (a, b) = (a.as_flattened(), b.as_flattened());
    let largest = a.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    let pairs = a.iter().zip(b);
    pairs.fold(0.0, |m: f64, (a, b)| m.max((a - b).abs())) / largest
}

#[test]
fn a_run_that_was_stopped_goes_on_as_if_it_had_not_been() {
    let folder = tempfile::tempdir().unwrap();
    let (alone, stopped) = (folder.path().join("alone"), folder.path().join("stopped"));
    let case = case();
    let reference = run(&case, &alone, false, usize::MAX).unwrap();
    assert!(run(&case, &stopped, false, 1).unwrap().interrupted);
    assert!(run(&case, &stopped, true, 2).unwrap().interrupted);
    let resumed = run(&case, &stopped, true, usize::MAX).unwrap();
    assert!(!resumed.interrupted);

    let (a, b) = (reference.state(), resumed.state());
    assert!(difference(&a.displacement, &b.displacement) < 1e-8);
    let flat =
        |state: &State| -> Vec<[f64; 6]> { state.stress.iter().flatten().copied().collect() };
    assert!(difference(&flat(a), &flat(b)) < 1e-7);
    assert_eq!(a.peeq.len(), b.peeq.len());

    // The collections name the same increments.
    let collection = |out: &Path| std::fs::read_to_string(out.join("initial-centre.pvd")).unwrap();
    assert_eq!(collection(&alone), collection(&stopped));

    // What is done is read, not solved again.
    let again = run(&case, &stopped, true, usize::MAX).unwrap();
    assert_eq!(
        again.summary.counters.iterations,
        resumed.summary.counters.iterations
    );
}

#[test]
fn a_checkpoint_of_another_case_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let case = case();
    run(&case, folder.path(), false, 1).unwrap();
    let mut other = case.clone();
    other.set_elastic();
    let error = run(&other, folder.path(), true, usize::MAX).unwrap_err();
    assert!(
        error.to_string().contains("another case or mesh"),
        "{error}"
    );

    let file = folder.path().join("checkpoint.bin");
    let mut bytes = std::fs::read(&file).unwrap();
    let last = bytes.len() - 1;
    bytes[last] ^= 1;
    std::fs::write(&file, &bytes).unwrap();
    let error = run(&case, folder.path(), true, usize::MAX).unwrap_err();
    assert!(error.to_string().contains("damaged"), "{error}");
    std::fs::write(&file, &bytes[..10]).unwrap();
    let error = run(&case, folder.path(), true, usize::MAX).unwrap_err();
    assert!(error.to_string().contains("not a checkpoint"), "{error}");
}

#[test]
fn two_runs_do_not_write_into_one_folder() {
    struct Second<'p>(&'p Path, Option<JobError>);
    impl Observer for Second<'_> {
        fn increment(&mut self, _: &State) -> Result<(), Box<dyn Error + Send + Sync>> {
            self.1 = run(&case(), self.0, false, usize::MAX).err();
            Ok(())
        }

        fn cancelled(&self) -> bool {
            self.1.is_some()
        }
    }
    let folder = tempfile::tempdir().unwrap();
    let options = Options {
        out: Some(folder.path().to_owned()),
        ..Options::default()
    };
    let mut second = Second(folder.path(), None);
    job::run(&case(), &options, &mut second).unwrap();
    let error = second.1.expect("the second run is refused");
    assert!(error.to_string().contains("another run"), "{error}");
}
