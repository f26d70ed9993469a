//! Makes the mesh files of the reference study in `meshes/section-2.6.2/` with gmsh:
//! `cargo run --release --example ship_meshes`.

use std::path::Path;

use brinell::case;
use brinell::case::bearing::{
    BearingGeometry, CROSSED, MeshRequest, Preset, RollerEnd, RollerShape, fingerprint,
    gmsh_parameters, write_with_fingerprint,
};
use brinell::model::mesh::gmsh;
use brinell::product::job;
use miette::{IntoDiagnostic, Result};

const OUT: &str = "meshes/section-2.6.2";
const CASES: &str = "cases/section-2.6.2";

fn main() -> Result<()> {
    let work = std::env::temp_dir().join(format!("brinell-meshes-{}", std::process::id()));
    std::fs::create_dir_all(&work).into_diagnostic()?;
    std::fs::create_dir_all(OUT).into_diagnostic()?;
    let template = CROSSED.write(&work).into_diagnostic()?;
    for (design, length) in [("initial", 8.0), ("revised", 10.5)] {
        for (place, offset) in [("centre", 0.0), ("offset-1.25", 1.25), ("offset-2.5", 2.5)] {
            for preset in [Preset::H025, Preset::ReportLike] {
                let name = format!("{design}-{place}-{preset}");
                let raw = work.join(format!("{name}.msh"));
                let out = Path::new(OUT).join(format!("{name}.msh.gz"));
                let geometry = reference(length, offset);
                let request = MeshRequest {
                    preset,
                    ..MeshRequest::default()
                };
                request.check(&geometry)?;
                gmsh::run(&template, &gmsh_parameters(&geometry, &request), &raw)?;
                let fingerprint = fingerprint(&geometry, &request);
                write_with_fingerprint(&raw, &fingerprint, &out).into_diagnostic()?;
                let size = std::fs::metadata(&out).into_diagnostic()?.len();
                println!("{} {fingerprint} {} kB", out.display(), size.div_ceil(1000));
            }
        }
    }
    for design in ["initial", "revised"] {
        for place in ["centre", "offset-1.25", "offset-2.5"] {
            ship_case(&format!("{design}-{place}"))?;
        }
    }
    std::fs::remove_dir_all(&work).into_diagnostic()
}

/// The mesh that the case itself asks for, by its load and steels.
fn ship_case(name: &str) -> Result<()> {
    let case = case::read(&Path::new(CASES).join(format!("{name}.toml")))?;
    let out = Path::new(OUT).join(format!("{name}-auto.msh.gz"));
    job::make_mesh(&case, &out)?;
    let size = std::fs::metadata(&out).into_diagnostic()?.len();
    println!("{} {} kB", out.display(), size.div_ceil(1000));
    Ok(())
}

/// The bearing of the reference study, in inches.
fn reference(length: f64, offset: f64) -> BearingGeometry {
    BearingGeometry {
        roller: RollerShape {
            diameter: 3.0,
            wall: Some(0.75),
            length,
            end: RollerEnd::Square,
        },
        slope: 4f64.to_radians(),
        offset,
        intermediate_thickness: 1.0,
        upper_thickness: 1.0,
        lower_thickness: 1.0,
        plan: [length, length],
        skew: [0.0; 2],
    }
}
