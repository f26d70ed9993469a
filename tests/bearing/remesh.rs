//! The preset `auto`: meshed once more where its first guess of the strips is wrong.

use brinell::case::bearing::Strips;
use brinell::case::{self, Case, Kind};
use brinell::product::job::{self, Options, Outcome};
use brinell::solver::solve::Observer;
use std::path::Path;

/// The initial design of the study, elastic, on a mesh made coarse for the sake of time: what is
/// asked of it is asked of the mesh that it is a scale of.
fn centre(guess: Option<f64>) -> Case {
    let path =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/section-2.6.2/initial-centre.toml");
    let text = std::fs::read_to_string(path).unwrap();
    let text = text.replace("preset = \"auto\"", "preset = \"auto\"\nscale = 2.5");
    let mut case = case::parse("centre.toml", &text).unwrap();
    case.set_elastic();
    if let Some(width) = guess {
        case.set_strips(Strips {
            narrowest: width,
            widest: width,
            found: false,
        });
    }
    case
}

#[derive(Default)]
struct Heard(Vec<String>);

impl Observer for Heard {
    fn message(&mut self, text: &str) {
        self.0.push(text.to_owned());
    }
}

impl Heard {
    fn count(&self, part: &str) -> usize {
        self.0.iter().filter(|line| line.contains(part)).count()
    }
}

fn run(case: &Case, out: &Path, resume: bool) -> (Outcome, Heard) {
    let mut heard = Heard::default();
    let options = Options {
        out: Some(out.to_owned()),
        resume,
        ..Options::default()
    };
    let outcome = job::run(case, &options, &mut heard).unwrap();
    (outcome, heard)
}

fn strips(case: &Case) -> Strips {
    match &case.kind {
        Kind::Bearing(bearing) => bearing.mesh.strips.unwrap(),
        Kind::General(_) => unreachable!("the case is a bearing"),
    }
}

#[test]
fn a_guess_that_is_right_is_kept() {
    let folder = tempfile::tempdir().unwrap();
    let (outcome, heard) = run(&centre(None), folder.path(), false);
    assert_eq!(heard.count("meshed once more"), 0, "{:?}", heard.0);
    assert!(!folder.path().join("mesh-strips.txt").exists());
    assert!(outcome.summary.answer.converged);
    // Statics, and a solution 350 thousand unknowns fine: 0.0329 and 0.0323 in.
    let guess = strips(&centre(None));
    assert!((guess.narrowest / 0.0323 - 1.0).abs() < 0.1, "{guess:?}");
    assert!((guess.widest / 0.0329 - 1.0).abs() < 0.1, "{guess:?}");
}

#[test]
fn a_guess_that_is_wrong_is_mended_once() {
    // Three times too wide, so that the elements are too large; three times too narrow, so that
    // the strip ends among coarse ones.
    for guess in [0.1, 0.011] {
        let folder = tempfile::tempdir().unwrap();
        let case = centre(Some(guess));
        let (outcome, heard) = run(&case, folder.path(), false);
        assert_eq!(heard.count("meshed once more"), 1, "{:?}", heard.0);
        assert_eq!(heard.count("calling gmsh"), 2);
        assert!(outcome.summary.answer.converged);
        let text = std::fs::read_to_string(folder.path().join("mesh-strips.txt")).unwrap();
        let widths: Vec<f64> = (text.split_whitespace())
            .map(|word| word.parse().unwrap())
            .collect();
        // A look at the first increment, on elements that are far too large in the one case: the
        // load per length is then known to some per cent, the width to half of that.
        assert!((widths[0] / 0.0323 - 1.0).abs() < 0.1, "{widths:?}");
        assert!((widths[1] / 0.0329 - 1.0).abs() < 0.1, "{widths:?}");

        // Going on takes up the second mesh.
        let (again, heard) = run(&case, folder.path(), true);
        assert_eq!(heard.count("meshed once more"), 0, "{:?}", heard.0);
        assert_eq!(heard.count("calling gmsh"), 0);
        assert_eq!(again.summary.counters.dofs, outcome.summary.counters.dofs);
        assert_eq!(again.summary.answer.descent, outcome.summary.answer.descent);
    }
}
