//! Runs the blocks of the README and of the tutorials.
//!
//! Each page has a folder of its own, with the cases and meshes of the repository in it. `sh` blocks
//! are run there in their order, `brinell` and `cargo run --release --` being the program under test.
//! After the language may stand: `slow` (only with `--ignored`), `exit-2` (the status that the
//! last command ends with), `ci` (what runs these tests: not run here). A block with a file name is
//! written to it; every `toml` block of a whole case is read as one. A `text` block is an excerpt of what the
//! commands before it printed, unless it says `sample`.
//!
//! `BRINELL_BOOK_PAGE=tutorials/first-run` runs the pages only that have this in their path.

use crate::blocks::{Block, blocks};
use crate::output::missing;
use crate::pages::{read, root, tutorials};
use std::path::Path;
use std::process::{Command, Stdio};

#[test]
fn quick_blocks_run() {
    every_page(false);
}

#[test]
#[ignore = "takes long: cargo test --release --test book -- --ignored"]
fn slow_blocks_run() {
    every_page(true);
}

fn every_page(slow: bool) {
    let mut wrong = Vec::new();
    let wanted = std::env::var("BRINELL_BOOK_PAGE").unwrap_or_default();
    let pages = std::iter::once("README.md".to_string()).chain(tutorials());
    for name in pages.filter(|name| name.contains(&wanted)) {
        let blocks = blocks(&read(&name));
        // Where nothing is slow, the quick test has run it all.
        if slow && !blocks.iter().any(|block| block.is("slow")) {
            continue;
        }
        let page = Page::new(&name);
        wrong.extend(page.run(&blocks, slow));
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n\n"));
}

struct Page {
    name: String,
    folder: tempfile::TempDir,
}

impl Page {
    fn new(name: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        for part in ["cases", "meshes"] {
            std::os::unix::fs::symlink(root().join(part), folder.path().join(part)).unwrap();
        }
        // What the README calls a case of yours.
        let case = root().join("cases/section-2.6.2/initial-centre.toml");
        std::fs::copy(case, folder.path().join("CASE.toml")).unwrap();
        Self {
            name: name.to_string(),
            folder,
        }
    }

    /// What is wrong with the blocks.
    fn run(&self, blocks: &[Block], slow: bool) -> Vec<String> {
        let mut wrong = Vec::new();
        let mut printed: Option<String> = None;
        for block in blocks {
            let at = format!("{}, line {}", self.name, block.line);
            self.write(block);
            match block.language() {
                "sh" if block.is("ci") => {}
                "sh" if block.is("slow") && !slow => printed = None,
                "sh" => match self.shell(block) {
                    Ok(text) => printed = Some(text),
                    Err(why) => {
                        wrong.push(format!("{at}: {why}"));
                        printed = None;
                    }
                },
                "toml" => wrong.extend(self.toml(block).map(|why| format!("{at}: {why}"))),
                "text" if !block.is("sample") => {
                    let Some(printed) = &printed else { continue };
                    if let Some(line) = missing(&block.text, printed) {
                        wrong.push(format!("{at}: `{line}` is not in\n{printed}"));
                    }
                }
                _ => {}
            }
        }
        wrong
    }

    /// What the commands of a block print.
    fn shell(&self, block: &Block) -> Result<String, String> {
        let program = Path::new(env!("CARGO_BIN_EXE_brinell"));
        let path = std::env::var("PATH").unwrap_or_default();
        let path = format!("{}:{path}", program.parent().unwrap().display());
        let script = block.text.replace("cargo run --release --", "brinell");
        let output = Command::new("sh")
            .args(["-e", "-c", &script])
            .current_dir(self.folder.path())
            .env("PATH", path)
            .env("NO_COLOR", "1")
            .env("LC_ALL", "C.UTF-8")
            .stdin(Stdio::null())
            .output()
            .map_err(|error| error.to_string())?;
        let text = [output.stdout, output.stderr].map(|b| String::from_utf8_lossy(&b).into_owned());
        let status = block.info.iter().find_map(|w| w.strip_prefix("exit-"));
        let status = status.map_or(0, |status| status.parse().unwrap());
        match output.status.code() == Some(status) {
            true => Ok(text.concat()),
            false => Err(format!(
                "ends with {} in place of {status}:\n{script}\n{}",
                output.status,
                text.concat()
            )),
        }
    }

    /// Writes a block with a file name.
    fn write(&self, block: &Block) {
        if let Some(file) = block.info.iter().find(|word| word.contains('.')) {
            std::fs::write(self.folder.path().join(file), &block.text).unwrap();
        }
    }

    /// What is wrong with a whole case.
    fn toml(&self, block: &Block) -> Option<String> {
        let whole = block.text.contains("units =");
        let read = || brinell::case::parse("case.toml", &block.text);
        whole.then(read)?.err().map(|error| error.to_string())
    }
}
