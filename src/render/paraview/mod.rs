//! A Python file beside the collection of a run that opens its useful views in ParaView, and draws
//! them to pictures where it is run by `pvbatch`.

use crate::ground::file::{FileError, write_atomically};
use crate::ground::units::UnitLabels;
use crate::model::scene::Scene;
use std::path::{Path, PathBuf};

/// All of it but what differs from run to run.
const VIEWS: &str = include_str!("views.py");

/// What the file is called, for the collection `<name>.pvd`.
pub fn file_name(name: &str) -> String {
    format!("{name}-views.py")
}

/// Writes `<name>-views.py` into `folder`, for the collection `<name>.pvd` there, and returns its
/// path. The figures are of the end of step `reported`; `(up, sign)` are the axis nearest to the load and the sign against it. The hyphen keeps Python from taking a case called `numpy` for the module.
///
/// # Errors
/// [`FileError::Write`] names the path.
pub fn write(
    folder: &Path,
    name: &str,
    title: &str,
    units: &UnitLabels,
    scene: &Scene,
    reported: usize,
    (up, sign): (usize, f64),
) -> Result<PathBuf, FileError> {
    let path = folder.join(file_name(name));
    let here = std::path::absolute(folder).unwrap_or_else(|_| folder.to_path_buf());
    let full_load = reported + 1;
    let contact = if scene.contacts.is_empty() {
        "False"
    } else {
        "True"
    };
    write_atomically(&path, |out| {
        writeln!(out, "# The useful views of {name}.pvd in ParaView.")?;
        writeln!(out, "#")?;
        writeln!(out, "#     paraview --script={name}-views.py")?;
        writeln!(out, "#     pvbatch {name}-views.py")?;
        writeln!(out, "#")?;
        writeln!(
            out,
            "# The first shows them side by side; the second writes a picture of each beside this\n\
             # file. Without a screen (Debian): xvfb-run -a -s -noreset pvbatch {name}-views.py\n"
        )?;
        writeln!(out, "NAME = {}", quoted(name))?;
        writeln!(out, "TITLE = {}", quoted(title))?;
        let (length, stress) = (quoted(&units.length), quoted(&units.stress));
        writeln!(out, "LENGTH, STRESS = {length}, {stress}")?;
        writeln!(out, "# Axes: planes of symmetry, and against the load.")?;
        writeln!(out, "MIRRORS = {:?}", scene.mirrors)?;
        writeln!(out, "UP, SIGN = {up}, {sign:?}")?;
        writeln!(out, "ACROSS = [axis for axis in range(3) if axis != UP]")?;
        writeln!(out, "# In steps, as the collection counts.")?;
        writeln!(out, "FULL_LOAD = {full_load}.0")?;
        writeln!(out, "CONTACT = {contact}")?;
        writeln!(out, "FOLDER = {}\n", quoted(&here.to_string_lossy()))?;
        out.write_all(VIEWS.as_bytes())
    })?;
    Ok(path)
}

/// A text as Python reads it; it reads what JSON does.
fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}
