//! Printing the page of a run to PDF, by Chromium.

use crate::ground::file::{FileError, write_atomically};
use crate::render::report;
use miette::Diagnostic;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use thiserror::Error;

/// Environment variable that names the browser, where it is none of [`NAMES`].
const EXECUTABLE: &str = "BRINELL_CHROMIUM";

/// What the browser is called on common systems.
const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "chrome"];

/// Name of the printed page in the folder of a run.
pub const FILE: &str = "report.pdf";

/// The paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Paper {
    /// 210 by 297 mm.
    A4,
    /// 8.5 by 11 in.
    Letter,
}

impl Paper {
    /// As style sheets call it.
    fn name(self) -> &'static str {
        match self {
            Self::A4 => "A4",
            Self::Letter => "letter",
        }
    }
}

/// Why a page is not printed.
#[derive(Debug, Error, Diagnostic)]
pub enum PrintError {
    #[error("{}: there is no page of a run", .0.display())]
    #[diagnostic(
        code(brinell::print::page),
        help("`brinell run CASE.toml --out FOLDER` writes FOLDER/report.html")
    )]
    Page(PathBuf, #[source] std::io::Error),
    #[error("no Chromium was found (as {})", NAMES.join(", "))]
    #[diagnostic(
        code(brinell::print::missing),
        help(
            "install the Debian package `chromium`, name the browser in the environment variable {EXECUTABLE}, or \
             open the page in any browser and print it there"
        )
    )]
    Missing,
    #[error("`{0}` cannot be started")]
    #[diagnostic(
        code(brinell::print::start),
        help(
            "check that it is an executable file; the environment variable {EXECUTABLE} names it"
        )
    )]
    Start(String, #[source] std::io::Error),
    #[error("`{browser}` printed nothing ({status}):\n{messages}")]
    #[diagnostic(
        code(brinell::print::failed),
        help("open the page in any browser and print it there")
    )]
    Failed {
        browser: String,
        status: String,
        messages: String,
    },
    #[error("no room to print in {}", .0.display())]
    #[diagnostic(
        code(brinell::print::room),
        help("check the directory and its permissions")
    )]
    Room(PathBuf, #[source] std::io::Error),
    #[error(transparent)]
    #[diagnostic(
        code(brinell::print::output),
        help("check the folder and its permissions")
    )]
    Output(#[from] FileError),
}

/// Prints the page in `folder` beside it, and returns the path of what was printed.
///
/// # Errors
/// [`PrintError`]; what an earlier printing left stays.
pub fn print(folder: &Path, paper: Paper) -> Result<PathBuf, PrintError> {
    let page = folder.join(report::FILE);
    let text = std::fs::read_to_string(&page).map_err(|e| PrintError::Page(page, e))?;
    // The printer decides about the paper, and here we are the printer.
    let size = format!("<style>@page {{ size: {} }}</style></head>", paper.name());
    let text = text.replacen("</head>", &size, 1);
    let room = std::env::temp_dir().join(format!("brinell-print-{}", std::process::id()));
    // A folder that is there is somebody else's, and stays.
    std::fs::create_dir(&room).map_err(|error| PrintError::Room(room.clone(), error))?;
    let printed = in_room(&room, &text);
    // Nothing is lost where a leftover stays.
    let _ = std::fs::remove_dir_all(&room);
    let printed = printed?;
    let out = folder.join(FILE);
    write_atomically(&out, |file| file.write_all(&printed))?;
    Ok(out)
}

/// The printed page; `room` is a folder of its own.
fn in_room(room: &Path, text: &str) -> Result<Vec<u8>, PrintError> {
    let no_room = |error| PrintError::Room(room.to_owned(), error);
    let (page, pdf) = (room.join(report::FILE), room.join(FILE));
    std::fs::write(&page, text).map_err(no_room)?;
    let named = std::env::var(EXECUTABLE)
        .ok()
        .filter(|name| !name.is_empty());
    let names = named.map_or_else(|| NAMES.map(str::to_owned).to_vec(), |name| vec![name]);
    for browser in names {
        let output = Command::new(&browser)
            .args([
                "--headless=new",
                "--no-first-run",
                "--disable-dev-shm-usage",
            ])
            // The view in space is drawn without a graphics card, and is done before the page is printed.
            .args([
                "--use-angle=swiftshader",
                "--enable-unsafe-swiftshader",
                "--virtual-time-budget=30000",
            ])
            .args(sandbox())
            .arg(format!(
                "--user-data-dir={}",
                room.join("profile").display()
            ))
            .arg("--no-pdf-header-footer")
            .arg(format!("--print-to-pdf={}", pdf.display()))
            .arg(format!("file://{}", page.display()))
            .stdin(Stdio::null())
            .output();
        let output = match output {
            Err(error) if error.kind() == ErrorKind::NotFound => continue,
            output => output.map_err(|error| PrintError::Start(browser.clone(), error))?,
        };
        let printed = std::fs::read(&pdf).unwrap_or_default();
        if printed.starts_with(b"%PDF") {
            return Ok(printed);
        }
        return Err(PrintError::Failed {
            browser,
            status: output.status.to_string(),
            messages: String::from_utf8_lossy(&output.stderr).into_owned(),
        });
    }
    Err(PrintError::Missing)
}

/// Chromium refuses to run as root within its sandbox. The page forbids itself every access to the network.
fn sandbox() -> Option<&'static str> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        let root = std::fs::metadata("/proc/self").is_ok_and(|process| process.uid() == 0);
        root.then_some("--no-sandbox")
    }
    #[cfg(not(unix))]
    None
}
