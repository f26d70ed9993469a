//! From a bearing to the numbers of the gmsh template, and from its mesh back to its unit.

use super::layout::Layout;
use super::parameter::Parameter;
use super::request::MeshRequest;
use super::sizes::{MESH_KEYS, SizeKind};
use crate::model::mesh::Mesh;

/// Everything that the mesh depends on, and nothing else.
pub(super) fn parameters(geometry: &dyn Layout, request: &MeshRequest) -> Vec<Parameter> {
    let sizes = request.sizes(geometry);
    let mut list = geometry.parameters(request.full, sizes.uniform);
    let keys = MESH_KEYS.iter().zip(sizes.values());
    let used = keys.filter(|(key, _)| !geometry.without().contains(&key.key));
    list.extend(used.map(|(key, value)| Parameter {
        name: key.parameter,
        value,
        is_length: key.kind == SizeKind::Length,
    }));
    list
}

/// The numbers of the template, to be handed to gmsh as `-setnumber <name> <value>`. Check the
/// request first.
pub fn gmsh_parameters(geometry: &dyn Layout, request: &MeshRequest) -> Vec<(String, f64)> {
    let list = parameters(geometry, request);
    list.into_iter()
        .map(|p| (p.name.to_string(), p.value))
        .collect()
}

/// The factor that brings the coordinates of a mesh of this bearing, made in some other unit,
/// into the unit of `geometry`: by the height of the stack. `None` for a mesh without height.
pub fn mesh_scale(mesh: &Mesh, geometry: &dyn Layout) -> Option<f64> {
    let [low, high] = mesh.range_along(2);
    let [bottom, top] = geometry.height_range();
    let scale = (top - bottom) / (high - low);
    (high > low && scale.is_finite()).then_some(scale)
}

/// Brings a mesh of this bearing into the unit of `geometry`; a mesh that already has it is left
/// untouched to the last bit. `false` for a mesh without height.
pub fn rescale(mesh: &mut Mesh, geometry: &dyn Layout) -> bool {
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
