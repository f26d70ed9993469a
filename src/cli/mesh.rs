//! `brinell mesh`: the mesh of a bearing case, by gmsh.

use super::case_file::read_case;
use super::output::say;
use super::status::{CommandResult, ExitStatus, bad_input};
use crate::product::job::{self, JobError};
use crate::solver::solve::unknowns;
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct MeshArgs {
    /// The case file.
    pub case: PathBuf,
    /// Mesh preset [default: that of the case].
    #[arg(long, value_name = "PRESET", value_parser = super::preset::parser())]
    pub mesh: Option<String>,
    /// Model the whole bearing though it is symmetric.
    #[arg(long)]
    pub full: bool,
    /// The mesh file to write, compressed where its name ends in `.gz`; `brinell run --out` looks for mesh.msh.gz in its
    /// folder.
    #[arg(long, value_name = "FILE", default_value = "mesh.msh.gz")]
    pub out: PathBuf,
}

/// Carries out the command.
pub fn run(args: &MeshArgs) -> CommandResult {
    let text = make(args).map_err(bad_input)?;
    say(&text);
    Ok(ExitStatus::Done)
}

fn make(args: &MeshArgs) -> Result<String, JobError> {
    let case = read_case(&args.case, args.mesh.as_deref(), args.full, false)?;
    let mesh = job::make_mesh(&case, &args.out)?;
    let in_file = mesh.points.clone();
    // Ends and curved faces get their shape here, which the file does not have.
    let scene = case.scene(mesh)?;
    let is_shaped = in_file != scene.mesh.points;
    let mut lines = vec![format!(
        "{}: {} nodes, {} hexahedra, {} unknowns",
        args.out.display(),
        scene.mesh.points.len(),
        scene.mesh.hexes.len(),
        unknowns(&scene)?
    )];
    for quality in scene.mesh.quality() {
        lines.push(format!(
            "  {:20} {:7} hexahedra, scaled Jacobian >= {:.3}, aspect ratio <= {:.1}",
            quality.name, quality.elements, quality.min_scaled_jacobian, quality.max_aspect_ratio
        ));
    }
    if is_shaped {
        lines.push(
            "The file has rollers with straight ends and flat plates: crowns, fillets and curved faces get their shape when this case is \
             run. A scene of your own on this file would be another bearing; `brinell export` writes the shape, too."
                .to_owned(),
        );
    }
    Ok(lines.join("\n"))
}
