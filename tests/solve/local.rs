//! A coarse mesh of one's own is refined where a target asks for it, whatever presses how hard.

use brinell::case;
use brinell::prelude::*;
use brinell::product::job::Options;
use brinell::product::target::{Target, TargetLimits, TargetVerdict, refine};
use brinell::proof::verify::stream::Stream;
use std::f64::consts::PI;
use std::path::Path;

/// The round punch of the tutorial, R = 50 mm and 5 mm wide to its side, on a plate: eight elements of one size across the
/// face, an element of 0.6 mm being larger than the half-width of the contact. Punches of 60 to 400 GPa, 5 to 80 MPa on a
/// top of 10 mm.
#[test]
fn a_punch_of_eight_elements_is_refined_to_one_per_cent_of_hertz() {
    let mut stream = Stream::new(1, 1);
    let (mut resolved, mut covered) = (0, 0);
    for _ in 0..6 {
        let modulus = stream.between([60.0, 400.0]);
        let pressure = stream.between([5.0, 80.0]);
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("case.toml");
        std::fs::write(&file, punch(modulus, pressure)).unwrap();
        let case = case::read(&file).unwrap();
        let target = "1%".parse::<Target>().unwrap();
        let (levels, verdict, _) = refine(
            &case,
            &target,
            &TargetLimits::default(),
            &Options::default(),
            &mut Silent,
            |_| (),
        )
        .unwrap();
        assert!(matches!(verdict, TargetVerdict::Met), "{verdict:?}");

        let steel = |modulus| Elastic::new(modulus, 0.3).unwrap();
        let compliance = contact_compliance(steel(1000.0 * modulus), steel(210e3)).unwrap();
        let load = 10.0 * pressure;
        let half_width = (4.0 * load * 50.0 * compliance / PI).sqrt();
        let exact = 2.0 * load / (PI * half_width);
        let last = levels.last().unwrap();
        let value = |level: &brinell::product::target::Level| {
            let mut figures = level.figures.iter();
            let found = figures.find(|f| f.what == Quantity::PeakPressure).unwrap();
            (found.value, found.estimate)
        };
        let (found, _) = value(last);
        assert!(
            (found / exact - 1.0).abs() < 0.01,
            "{modulus} GPa, {pressure} MPa: {found} {exact}"
        );
        // Levels on the way have bars that hold.
        for level in &levels[..levels.len() - 1] {
            for (figure, end) in level.figures.iter().zip(&last.figures) {
                let Some(bar) = figure.estimate else { continue };
                assert_eq!(figure.what, end.what);
                resolved += 1;
                let room = bar + end.estimate.unwrap();
                covered += usize::from((figure.value - end.value).abs() <= room);
            }
        }
    }
    assert!(
        resolved > 80 && 100 * covered >= 95 * resolved,
        "{covered} of {resolved}"
    );
}

fn punch(modulus: f64, pressure: f64) -> String {
    let mesh = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/round-punch-8.msh.gz");
    format!(
        "units = \"mm-N-MPa\"\nsymmetry = [\"x\"]\n[mesh]\nfile = {mesh:?}\n\
         [steel]\nyoungs_modulus = \"210 GPa\"\npoissons_ratio = 0.3\nelastic = true\n\
         [steel.punch]\nyoungs_modulus = \"{modulus} GPa\"\npoissons_ratio = 0.3\nelastic = true\n\
         [[contact]]\nupper = \"punch_face\"\nlower = \"plate_face\"\nfriction = 0\n\
         [[pressure]]\nsurface = \"top\"\nvalue = \"{pressure} MPa\"\n\
         [[support]]\nsurface = \"base\"\nfixed = \"xyz\"\n\
         [[support]]\nsurface = \"symmetry\"\nfixed = \"x\"\n\
         [[support]]\nsurface = \"back\"\nfixed = \"z\"\n\
         [[support]]\nsurface = \"front\"\nfixed = \"z\"\n"
    )
}
