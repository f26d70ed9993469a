//! Running gmsh on a geometry.

use std::ffi::{OsStr, OsString};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::Command;

use miette::Diagnostic;
use thiserror::Error;

/// Environment variable that names the gmsh executable, where it is not `gmsh`.
const EXECUTABLE: &str = "BRINELL_GMSH";

/// Why gmsh made no mesh.
#[derive(Debug, Error, Diagnostic)]
pub enum GmshError {
    #[error("the mesh generator gmsh was not found (as `{executable}`)")]
    #[diagnostic(
        code(brinell::gmsh::missing),
        help(
            "install the Debian package `gmsh` (`apt install gmsh`) or the PyPI wheel `gmsh` \
             (`pip install gmsh`), or name the executable in the environment variable {EXECUTABLE}"
        )
    )]
    Missing { executable: String },

    #[error("gmsh (`{executable}`) cannot be started")]
    #[diagnostic(
        code(brinell::gmsh::start),
        help(
            "check that it is an executable file; the environment variable {EXECUTABLE} names it"
        )
    )]
    Start {
        executable: String,
        source: std::io::Error,
    },

    #[error("gmsh parameter `{name}` = {value} is not a number that gmsh can take")]
    #[diagnostic(
        code(brinell::gmsh::parameter),
        help("give a finite number to a named constant")
    )]
    Parameter { name: String, value: f64 },

    #[error("{}: the geometry file cannot be read", geo.display())]
    #[diagnostic(
        code(brinell::gmsh::geometry),
        help("check the path and the permissions")
    )]
    Geometry {
        geo: PathBuf,
        source: std::io::Error,
    },

    #[error("gmsh failed on {} ({status}):\n{messages}", geo.display())]
    #[diagnostic(
        code(brinell::gmsh::failed),
        help("correct the geometry or the parameters given to it: {parameters}")
    )]
    Failed {
        geo: PathBuf,
        status: String,
        messages: String,
        parameters: String,
    },

    #[error("gmsh's mesh cannot be stored as {}", out.display())]
    #[diagnostic(
        code(brinell::gmsh::store),
        help("check the directory and its permissions")
    )]
    Store {
        out: PathBuf,
        source: std::io::Error,
    },
}

/// Meshes the geometry `geo` in three dimensions with the constants `parameters` set, and writes
/// the mesh to `out` as binary MSH 4.1. An older `out` is replaced only by a complete mesh.
///
/// # Errors
/// gmsh is missing or fails, a parameter is not finite, or `out` cannot be written.
pub fn run(geo: &Path, parameters: &[(String, f64)], out: &Path) -> Result<(), GmshError> {
    let executable = std::env::var_os(EXECUTABLE).filter(|name| !name.is_empty());
    run_with(
        executable.as_deref().unwrap_or(OsStr::new("gmsh")),
        geo,
        parameters,
        out,
    )
}

fn run_with(
    executable: &OsStr,
    geo: &Path,
    parameters: &[(String, f64)],
    out: &Path,
) -> Result<(), GmshError> {
    // gmsh would mesh a missing or unreadable file as an empty geometry.
    std::fs::File::open(geo).map_err(|source| GmshError::Geometry {
        geo: geo.to_owned(),
        source,
    })?;
    let unfinished = unfinished(out);
    let result = Command::new(executable)
        // Options that a user keeps at home make other meshes; below a file there are none.
        .env("GMSH_HOME", geo)
        .args(["-3", "-format", "msh41", "-bin"])
        .args(settings(parameters)?)
        .arg("-o")
        .arg(&unfinished)
        .arg(geo)
        .output();
    let output = result.map_err(|source| {
        let executable = executable.to_string_lossy().into_owned();
        match source.kind() {
            ErrorKind::NotFound => GmshError::Missing { executable },
            _ => GmshError::Start { executable, source },
        }
    })?;
    let messages = [output.stderr, output.stdout].map(|b| String::from_utf8_lossy(&b).into_owned());
    let complaints = complaints(&messages);
    let failed = complaints.iter().any(|line| line.starts_with("Error"));
    if failed || !output.status.success() || !unfinished.exists() {
        // The mesh of a failed run is incomplete; that it may be missing altogether is no matter.
        let _ = std::fs::remove_file(&unfinished);
        return Err(GmshError::Failed {
            geo: geo.to_owned(),
            status: output.status.to_string(),
            messages: complaints.join("\n"),
            parameters: listed(parameters),
        });
    }
    std::fs::rename(&unfinished, out).map_err(|source| GmshError::Store {
        out: out.to_owned(),
        source,
    })
}

/// The name under which gmsh writes until the mesh is complete.
fn unfinished(out: &Path) -> PathBuf {
    let mut name = OsString::from(out.as_os_str());
    name.push(format!(".{}.part", std::process::id()));
    PathBuf::from(name)
}

fn settings(parameters: &[(String, f64)]) -> Result<Vec<String>, GmshError> {
    let mut arguments = Vec::with_capacity(3 * parameters.len());
    for (name, value) in parameters {
        // gmsh takes a name that begins with a dash for an option.
        if !value.is_finite() || name.is_empty() || name.starts_with('-') {
            return Err(GmshError::Parameter {
                name: name.clone(),
                value: *value,
            });
        }
        arguments.extend(["-setnumber".to_owned(), name.clone(), format!("{value:?}")]);
    }
    Ok(arguments)
}

/// The lines in which gmsh complains, errors first; without any, its last words.
fn complaints(messages: &[String]) -> Vec<&str> {
    let lines = || messages.iter().flat_map(|text| text.lines()).map(str::trim);
    let mut found: Vec<&str> = lines().filter(|line| line.starts_with("Error")).collect();
    found.extend(lines().filter(|line| line.starts_with("Warning")));
    if found.is_empty() {
        found = lines().filter(|line| !line.is_empty()).collect();
        found.drain(..found.len().saturating_sub(5));
    }
    found
}

fn listed(parameters: &[(String, f64)]) -> String {
    if parameters.is_empty() {
        return "none".to_owned();
    }
    let all: Vec<_> = parameters
        .iter()
        .map(|(name, value)| format!("{name} = {value:?}"))
        .collect();
    all.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    const GEO: &str = "DefineConstant[ size = 1, cells = 1 ];
        Point(1) = {0, 0, 0}; Point(2) = {size, 0, 0};
        Line(1) = {1, 2}; Transfinite Curve {1} = cells + 1;
        a[] = Extrude {0, size, 0} { Curve{1}; Layers{cells}; Recombine; };
        b[] = Extrude {0, 0, size} { Surface{a[1]}; Layers{cells}; Recombine; };
        Physical Volume(\"cube\") = {b[1]};";

    fn written(text: &str) -> (tempfile::TempDir, PathBuf, PathBuf) {
        let dir = tempfile::tempdir().unwrap();
        let (geo, out) = (dir.path().join("part.geo"), dir.path().join("part.msh"));
        std::fs::write(&geo, text).unwrap();
        (dir, geo, out)
    }

    #[test]
    fn parameters_reach_the_geometry() {
        let (_dir, geo, out) = written(GEO);
        run(
            &geo,
            &[("size".into(), -2.5e-7), ("cells".into(), 3.0)],
            &out,
        )
        .unwrap();
        let mesh = crate::model::mesh::msh::read(&out).unwrap();
        assert_eq!(mesh.hexes.len(), 27);
        let least = mesh.points.iter().map(|p| p[2]).fold(0.0, f64::min);
        assert!((least + 2.5e-7).abs() < 1e-15);
    }

    /// The test runs itself once more, with a home whose options make each hexahedron eight.
    #[test]
    fn options_at_home_change_no_mesh() {
        const HOME: &str = "GMSH_HOME";
        const HERE: &str = "options_at_home_change_no_mesh";
        let (dir, geo, out) = written(GEO);
        if std::env::var_os(HOME).is_none() {
            let options = "Mesh.SubdivisionAlgorithm = 2;";
            std::fs::write(dir.path().join(".gmsh-options"), options).unwrap();
            let mut again = Command::new(std::env::current_exe().unwrap());
            let again = again.arg(HERE).env(HOME, dir.path()).output().unwrap();
            assert!(again.status.success(), "{again:?}");
        } else {
            run(&geo, &[], &out).unwrap();
            assert_eq!(crate::model::mesh::msh::read(&out).unwrap().hexes.len(), 1);
        }
    }

    #[test]
    fn an_error_of_gmsh_is_told_and_the_old_mesh_stays() {
        let (dir, geo, out) = written("Error(\"the roller is thinner than its wall\");");
        std::fs::write(&out, "old").unwrap();
        let error = run(&geo, &[("wall".into(), 2.0)], &out).unwrap_err();
        assert!(
            error
                .to_string()
                .contains("the roller is thinner than its wall"),
            "{error}"
        );
        assert!(error.help().unwrap().to_string().contains("wall = 2.0"));
        assert_eq!(std::fs::read_to_string(&out).unwrap(), "old");
        assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 2);
    }

    #[test]
    fn a_missing_gmsh_is_named_with_the_way_to_install_it() {
        let (_dir, geo, out) = written(GEO);
        let error = run_with(OsStr::new("no-such-gmsh"), &geo, &[], &out).unwrap_err();
        assert!(error.to_string().contains("`no-such-gmsh`"));
        let help = error.help().unwrap().to_string();
        for word in ["apt install gmsh", "pip install gmsh", "BRINELL_GMSH"] {
            assert!(help.contains(word), "{help}");
        }
    }

    #[test]
    fn missing_geometry_and_wild_parameters_are_refused() {
        let (dir, geo, out) = written(GEO);
        let nowhere = dir.path().join("nowhere.geo");
        assert!(matches!(
            run(&nowhere, &[], &out),
            Err(GmshError::Geometry { .. })
        ));
        let wild = run(&geo, &[("size".into(), f64::NAN)], &out);
        assert!(matches!(wild, Err(GmshError::Parameter { .. })));
    }
}
