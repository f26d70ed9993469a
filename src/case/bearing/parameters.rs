//! From a bearing to the numbers of the gmsh template, and from its mesh back to its unit.

use super::geometry::BearingGeometry;
use super::request::MeshRequest;
use super::sizes::{MESH_KEYS, SizeKind};
use crate::model::mesh::Mesh;

/// A number of the template, with what it measures.
pub(super) struct Parameter {
    pub name: &'static str,
    pub value: f64,
    pub is_length: bool,
}

/// Everything that the mesh depends on, and nothing else.
pub(super) fn parameters(geometry: &BearingGeometry, request: &MeshRequest) -> Vec<Parameter> {
    let length = |name, value| Parameter {
        name,
        value,
        is_length: true,
    };
    let number = |name, value| Parameter {
        name,
        value,
        is_length: false,
    };
    let sizes = request.sizes(geometry);
    let whole = request.full || !geometry.is_centred();
    let mut list = vec![
        length("Diameter", geometry.diameter),
        length("Wall", geometry.wall.unwrap_or(0.0)),
        length("RollerLength", geometry.length),
        number("Slope", geometry.slope),
        length("Offset", geometry.offset),
        length("UpperThickness", geometry.upper_thickness),
        length("MiddleThickness", geometry.intermediate_thickness),
        length("LowerThickness", geometry.lower_thickness),
        length("PlanX", geometry.plan[0]),
        length("PlanY", geometry.plan[1]),
        number("Full", f64::from(u8::from(whole))),
        number("Uniform", f64::from(u8::from(sizes.uniform))),
    ];
    for (key, value) in MESH_KEYS.iter().zip(sizes.values()) {
        list.push(Parameter {
            name: key.parameter,
            value,
            is_length: key.kind == SizeKind::Length,
        });
    }
    list
}

/// The numbers of the template, to be handed to gmsh as `-setnumber <name> <value>`. Check the
/// request first.
pub fn gmsh_parameters(geometry: &BearingGeometry, request: &MeshRequest) -> Vec<(String, f64)> {
    let list = parameters(geometry, request);
    list.into_iter()
        .map(|p| (p.name.to_string(), p.value))
        .collect()
}

/// The factor that brings the coordinates of a mesh of this bearing, made in some other unit,
/// into the unit of `geometry`: by the height of the stack. `None` for a mesh without height.
pub fn mesh_scale(mesh: &Mesh, geometry: &BearingGeometry) -> Option<f64> {
    let heights = mesh.points.iter().map(|p| p[2]);
    let [low, high] = heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| {
        [low.min(z), high.max(z)]
    });
    let [bottom, top] = geometry.height_range();
    let scale = (top - bottom) / (high - low);
    (high > low && scale.is_finite()).then_some(scale)
}

/// Brings a mesh of this bearing into the unit of `geometry`; a mesh that already has it is left
/// untouched to the last bit. `false` for a mesh without height.
pub fn rescale(mesh: &mut Mesh, geometry: &BearingGeometry) -> bool {
    let Some(scale) = mesh_scale(mesh, geometry) else {
        return false;
    };
    if (scale - 1.0).abs() > 1e-12 {
        for coordinate in mesh.points.iter_mut().flatten() {
            *coordinate *= scale;
        }
    }
    true
}
