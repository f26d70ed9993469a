//! The mesh files that come with the program belong to the bearings they are named after.

use std::path::Path;

use brinell::case::Kind;
use brinell::case::bearing::{
    BearingGeometry, MeshRequest, Preset, RollerEnd, RollerShape, fingerprint, mesh_scale,
};
use brinell::model::mesh::msh;

#[test]
fn shipped_meshes_carry_the_fingerprints_of_their_bearings() {
    for (design, length) in [("initial", 8.0), ("revised", 10.5)] {
        for (place, offset) in [("centre", 0.0), ("offset-1.25", 1.25), ("offset-2.5", 2.5)] {
            for preset in [Preset::H025, Preset::ReportLike] {
                let geometry = BearingGeometry {
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
                };
                let request = MeshRequest {
                    preset,
                    ..MeshRequest::default()
                };
                let name = format!("meshes/section-2.6.2/{design}-{place}-{preset}.msh.gz");
                let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(&name);
                let mesh = msh::read(&path).expect(&name);
                let wanted = fingerprint(&geometry, &request);
                assert_eq!(mesh.fingerprint.as_deref(), Some(wanted.as_str()), "{name}");
                let scale = mesh_scale(&mesh, &geometry).expect(&name);
                assert!((scale - 1.0).abs() < 1e-12, "{name}");
                assert_eq!(mesh.bodies.len(), 5);
            }
        }
    }
}

/// Those of the preset `auto` also depend on the load and the steels.
#[test]
fn shipped_meshes_sized_by_their_lines_are_those_of_the_cases() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for design in ["initial", "revised"] {
        for place in ["centre", "offset-1.25", "offset-2.5"] {
            let name = format!("section-2.6.2/{design}-{place}");
            let case = brinell::case::read(&root.join(format!("cases/{name}.toml"))).expect(&name);
            let Kind::Bearing(bearing) = &case.kind else {
                panic!("{name} is a bearing");
            };
            assert_eq!(bearing.mesh.preset, Preset::Auto, "{name}");
            let mesh = msh::read(&root.join(format!("meshes/{name}-auto.msh.gz"))).expect(&name);
            let wanted = bearing.fingerprint();
            assert_eq!(mesh.fingerprint.as_deref(), Some(wanted.as_str()), "{name}");
        }
    }
}
