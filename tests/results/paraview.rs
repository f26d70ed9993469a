//! The views of a run, drawn by ParaView itself.

use crate::block::{fill_stress, pressed, stack};
use brinell::answer::results::recovery::recover;
use brinell::ground::units::UnitLabels;
use brinell::render::{VtkSeries, paraview};
use std::path::Path;
use std::process::{Command, Output};

/// Prints how many points and how many colours a picture has.
const LOOK: &str = r#"
import sys, numpy, pyvista
image = numpy.asarray(pyvista.read(sys.argv[1]).active_scalars)
print(len(image), len(numpy.unique(image, axis=0)))
"#;

/// Runs the file of views by `pvbatch`, on a screen that is none.
fn draw(views: &Path) -> Output {
    // An X server that is reset whenever its last client leaves is gone when ParaView comes back.
    let server = ["-a", "-s", "-screen 0 1280x1024x24 -noreset", "pvbatch"];
    let output = Command::new("xvfb-run").args(server).arg(views).output();
    output.expect("this test draws by ParaView: install paraview, xvfb and xauth")
}

fn points_and_colours(picture: &Path) -> (usize, usize) {
    let output = Command::new("python3")
        .args(["-c", LOOK])
        .arg(picture)
        .output()
        .unwrap();
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let numbers: Vec<usize> = text
        .split_whitespace()
        .map(|n| n.parse().unwrap())
        .collect();
    assert_eq!(numbers.len(), 2, "no picture at {}", picture.display());
    (numbers[0], numbers[1])
}

#[test]
fn pvbatch_draws_every_view_by_fields_that_exist() {
    let scene = stack();
    let mut state = pressed(&scene);
    fill_stress(&scene, &mut state, |[x, y, z]| {
        [10.0 * x, y * z, -40.0 + z, x * y, y, x * z]
    });
    for (u, point) in state.displacement.iter_mut().zip(&scene.mesh.points) {
        *u = [1e-3 * point[1], 0.0, -0.01 * point[2]];
    }
    let recovered = recover(&scene, &state);
    let folder = tempfile::tempdir().unwrap();
    let mut series = VtkSeries::new(folder.path(), "a case");
    series.write(&scene, &state, &recovered).unwrap();
    let units = UnitLabels::new("in", "kip", "ksi");
    let title = "a \"quoted\" case, 4°";
    let views = paraview::write(
        folder.path(),
        series.name(),
        title,
        &units,
        &scene,
        0,
        (2, 1.0),
    )
    .unwrap();
    assert!(views.ends_with("a_case-views.py"));
    // Without a graphics card, small pictures are drawn sooner.
    let text = std::fs::read_to_string(&views).unwrap();
    let text = text.replace("PICTURE = [1600, 1200]", "PICTURE = [400, 300]");
    std::fs::write(&views, &text).unwrap();
    // The file finds the collection beside it, wherever it is started.
    let output = draw(&views);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    for view in ["mises", "section", "pressure", "deformed"] {
        let picture = folder.path().join(format!("a_case-{view}.png"));
        let (points, colours) = points_and_colours(&picture);
        assert_eq!(points, 400 * 300);
        // The bar alone has twenty.
        assert!(colours > 40, "{colours} colours in {view}");
        std::fs::remove_file(picture).unwrap();
    }
    let wrong = text.replace(
        "\"contact_pressure\", \"contact pressure",
        "\"none\", \"contact pressure",
    );
    assert_ne!(text, wrong);
    std::fs::write(&views, wrong).unwrap();
    let output = draw(&views);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(
        !output.status.success() && said.contains("there is no field none"),
        "{said}"
    );
}
