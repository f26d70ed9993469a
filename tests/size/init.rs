//! `brinell init`.

use super::{brinell, contains};
use brinell::case;

/// Written, it runs; it is not written over but where that is asked for.
#[test]
fn a_bearing_that_runs() {
    let folder = tempfile::tempdir().unwrap();
    let assert = brinell(folder.path(), &["init"]).code(0);
    contains(
        &assert.get_output().stdout,
        &["next: brinell run bearing.toml"],
    );
    let run = [
        "run",
        "bearing.toml",
        "--mesh",
        "report-like",
        "--quiet",
        "--out",
        "r",
    ];
    brinell(folder.path(), &run).code(0);
    assert!(folder.path().join("r/summary.json").is_file());

    let file = folder.path().join("bearing.toml");
    std::fs::write(&file, "mine").unwrap();
    let assert = brinell(folder.path(), &["init"]).code(2);
    contains(
        &assert.get_output().stderr,
        &["there is already a file bearing.toml", "--force"],
    );
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "mine");
    brinell(folder.path(), &["init", "--force"]).code(0);
    assert!(case::read(&file).is_ok());
}

#[test]
fn a_scene_that_reads() {
    let folder = tempfile::tempdir().unwrap();
    let assert = brinell(
        folder.path(),
        &["init", "--kind", "general", "deep/my.toml"],
    )
    .code(0);
    contains(&assert.get_output().stdout, &["put in your mesh"]);
    let file = folder.path().join("deep/my.toml");
    assert!(case::read(&file).is_ok());
    assert!(
        std::fs::read_to_string(&file)
            .unwrap()
            .contains("brinell run deep/my.toml")
    );
}
