//! Sizing: the rules against the numbers of the reference study, and `brinell size` and `brinell init`
//! as a user runs them.

mod case_file;
mod command;
mod init;
mod line;
mod rules;
mod verify;

use assert_cmd::assert::Assert;
use assert_cmd::cargo::cargo_bin_cmd;
use std::path::Path;

/// Runs `brinell` with `arguments` in `folder`.
fn brinell(folder: &Path, arguments: &[&str]) -> Assert {
    cargo_bin_cmd!("brinell")
        .current_dir(folder)
        .args(arguments)
        .assert()
}

/// The words of a stream, without the frames and line breaks of an error report.
fn words(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes).replace(['│', '╭', '╰', '─', '·', '×'], " ");
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[track_caller]
fn contains(bytes: &[u8], parts: &[&str]) {
    let text = words(bytes);
    for part in parts {
        assert!(text.contains(part), "`{part}` is not in: {text}");
    }
}
