//! `brinell init`: a commented case file to begin with.

use super::output::say;
use super::status::{CommandResult, ExitStatus, bad_input};
use crate::ground::file::{FileError, write_text};
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};

/// What the case describes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Starter {
    /// A bearing of crossed rollers, given by its dimensions.
    Bearing,
    /// Parallel rollers between two plates, given by their dimensions.
    LineBearing,
    /// Bodies, contacts, supports and loads by name on a mesh of yours.
    General,
}

#[derive(Debug, Args)]
pub struct InitArgs {
    /// The file to write [default: bearing.toml, line-bearing.toml or scene.toml].
    pub path: Option<PathBuf>,
    /// What the case describes.
    #[arg(long, value_enum, default_value = "bearing")]
    pub kind: Starter,
    /// Write over a file that is there.
    #[arg(long)]
    pub force: bool,
}

/// Why no case file was written.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
enum InitError {
    #[error("there is already a file {}", .0.display())]
    #[diagnostic(
        code(brinell::init::exists),
        help("name another one, or write over it with --force")
    )]
    Exists(PathBuf),
    #[error(transparent)]
    #[diagnostic(
        code(brinell::init::output),
        help("name another place, or make room and give write permission")
    )]
    Output(#[from] FileError),
}

impl Starter {
    fn file(self) -> &'static str {
        match self {
            Self::Bearing => "bearing.toml",
            Self::LineBearing => "line-bearing.toml",
            Self::General => "scene.toml",
        }
    }

    /// The case file, which says how to run it as `file`.
    fn text(self, file: &Path) -> String {
        let text = match self {
            Self::Bearing => include_str!("bearing.toml"),
            Self::LineBearing => include_str!("line-bearing.toml"),
            Self::General => include_str!("general.toml"),
        };
        text.replace("{file}", &file.display().to_string())
    }
}

/// Carries out the command.
pub fn run(args: &InitArgs) -> CommandResult {
    let path = args.path.clone().unwrap_or_else(|| args.kind.file().into());
    write(args, &path).map_err(bad_input)?;
    let path = path.display();
    say(&format!("written: {path}"));
    say(&match args.kind {
        Starter::Bearing | Starter::LineBearing => format!("next: brinell run {path}"),
        Starter::General => {
            format!("next: put in your mesh and its names, then brinell run {path}")
        }
    });
    Ok(ExitStatus::Done)
}

fn write(args: &InitArgs, path: &Path) -> Result<(), InitError> {
    if path.exists() && !args.force {
        return Err(InitError::Exists(path.to_owned()));
    }
    let text = args.kind.text(path);
    Ok(write_text(path, &text)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{self, Case};

    fn read(kind: Starter, text: &str) -> Case {
        case::parse(kind.file(), text).expect(text)
    }

    #[test]
    fn all_templates_are_cases() {
        let line = Starter::LineBearing.text(Path::new("a.toml"));
        let line = read(Starter::LineBearing, &line);
        assert!(matches!(&line.kind, case::Kind::Bearing(b) if b.geometry.line().is_some()));
        let bearing = read(
            Starter::Bearing,
            &Starter::Bearing.text(Path::new("a.toml")),
        );
        assert!(matches!(bearing.kind, case::Kind::Bearing(_)));
        let general = read(
            Starter::General,
            &Starter::General.text(Path::new("a.toml")),
        );
        assert!(matches!(general.kind, case::Kind::General(_)));
    }

    /// A default that is shown behind a `#` changes nothing where the `#` is taken away.
    #[test]
    fn shown_defaults_are_the_defaults() {
        let shown = [
            "unload = false",
            "unload = false\nunload_to = 0.001",
            "roller_end = \"square\"",
            "offset_is = \"roller\"",
            "plate_size = \"8 in\"",
            "full = false",
        ];
        let text = Starter::Bearing.text(Path::new("a.toml"));
        let case::Kind::Bearing(plain) = read(Starter::Bearing, &text).kind else {
            panic!("not a bearing")
        };
        for line in shown {
            let hidden = format!("# {}", line.replace('\n', "\n# "));
            let with = text.replace(&hidden, line);
            assert_ne!(with, text, "{line}");
            let case::Kind::Bearing(other) = read(Starter::Bearing, &with).kind else {
                panic!("not a bearing")
            };
            assert_eq!(other.geometry, plain.geometry, "{line}");
            assert_eq!(other.unload_to, plain.unload_to, "{line}");
        }
    }

    /// What is shown as an alternative reads, too.
    #[test]
    fn shown_alternatives_read() {
        let bearing = Starter::Bearing.text(Path::new("a.toml"));
        let changes: [(&str, &str); 3] = [
            (
                "tangent_modulus = \"295 ksi\"",
                "hardening = { stress = \"138 ksi\", strain = 0.157, strain_is = \"total\" }",
            ),
            ("# stages", "stages"),
            (
                "# [controls]\n# plasticity = true\n# element",
                "[controls]\nplasticity = true\nelement",
            ),
        ];
        for (from, to) in changes {
            let text = bearing.replace(from, to);
            assert_ne!(text, bearing, "{from}");
            read(Starter::Bearing, &text);
        }
        let line = Starter::LineBearing.text(Path::new("a.toml"));
        let changes = [
            (
                "# rollers = 3\n# spacing = \"280 mm\"",
                "rollers = 3\nspacing = \"280 mm\"\nplate_size = [\"900 mm\", \"500 mm\"]",
            ),
            ("solid = true", "roller_wall = \"40 mm\""),
            ("# plate_curve", "plate_curve"),
            ("# roller_end", "roller_end"),
        ];
        for (from, to) in changes {
            let mut text = line.replace(from, to);
            assert_ne!(text, line, "{from}");
            if from.contains("rollers") {
                text = text.replace("plate_size = [\"300 mm\", \"500 mm\"]\n", "");
            }
            read(Starter::LineBearing, &text);
        }
        let general = Starter::General.text(Path::new("a.toml"));
        let changes = [
            ("# symmetry", "symmetry"),
            ("# unit", "unit"),
            ("# carrier", "carrier"),
            (
                "# [[step]]\n# name = \"load\"\n# factor",
                "[[step]]\nname = \"load\"\nfactor",
            ),
            (
                "# [[pressure]]\n# surface = \"upper_side\"\n# value",
                "[[pressure]]\nsurface = \"upper_side\"\nvalue",
            ),
        ];
        for (from, to) in changes {
            let text = general.replace(from, to);
            assert_ne!(text, general, "{from}");
            read(Starter::General, &text);
        }
    }
}
