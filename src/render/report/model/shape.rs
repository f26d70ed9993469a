//! The bodies and their fields for the view in space: elements where they are few enough to be cut,
//! else the outer faces alone.

use super::pack::{Packed, quantised};
use crate::answer::pictures::Pictures;
use crate::answer::results::recovery::Recovered;
use crate::ground::file::FileError;
use crate::ground::geometry::bounds;
use crate::ground::units::UnitLabels;
use crate::model::mesh::Face;
use crate::model::scene::Scene;
use crate::model::state::State;
use crate::render::OutputError;
use crate::render::report::FILE;
use serde::Serialize;
use std::path::Path;

/// With more elements than this the page holds their outer faces only: 150 thousand are some 3 MB.
pub const MOST_ELEMENTS: usize = 150_000;

/// What the page must know to unpack the arrays, and to name what they hold.
#[derive(Debug, Clone, Serialize)]
pub struct Header {
    pub points: usize,
    pub faces: usize,
    /// Zero where the bodies cannot be cut.
    pub elements: usize,
    /// Least and largest coordinates, modelled part.
    pub low: [f64; 3],
    pub high: [f64; 3],
    /// Largest component of a displacement.
    pub displacement: f64,
    pub bodies: Vec<Part>,
    pub fields: Vec<Field>,
    pub mirrors: Vec<usize>,
    /// Places worth a look: name, point and size of the neighbourhood.
    pub places: Vec<Spot>,
    pub length: String,
}

/// A body: its share of the faces and elements.
#[derive(Debug, Clone, Serialize)]
pub struct Part {
    pub name: String,
    pub faces: [usize; 2],
    pub elements: [usize; 2],
}

/// A scalar at the points.
#[derive(Debug, Clone, Serialize)]
pub struct Field {
    pub name: &'static str,
    pub unit: String,
    /// The value of the last step; the first is zero.
    pub largest: f64,
    /// Said under the colours.
    pub note: &'static str,
}

/// A place worth a look.
#[derive(Debug, Clone, Serialize)]
pub struct Spot {
    pub name: String,
    pub at: [f64; 3],
    pub size: f64,
}

/// Header and packed arrays.
#[derive(Debug, Clone)]
pub struct Shape {
    pub header: Header,
    pub arrays: String,
}

/// The arrays, in this order: three coordinates, three displacements (16 bits each), the fields
/// (16 bits), the four corners of the faces, the eight corners of the elements (32 bits).
///
/// # Errors
/// Where they cannot be compressed.
pub fn shape(
    scene: &Scene,
    state: &State,
    (recovered, pictures): (&Recovered, &Pictures),
    units: &UnitLabels,
    places: Vec<Spot>,
) -> Result<Shape, OutputError> {
    let mesh = &scene.mesh;
    let skins: Vec<Vec<Face>> = (0..mesh.bodies.len())
        .map(|b| mesh.outer_faces(b))
        .collect();
    let cuttable = mesh.hexes.len() <= MOST_ELEMENTS;
    let mut faces: Vec<[u32; 4]> = Vec::new();
    let mut bodies = Vec::new();
    for (body, skin) in mesh.bodies.iter().zip(&skins) {
        let first = faces.len();
        faces.extend(skin.iter().map(|face| as_points(face, mesh, recovered)));
        let elements = if cuttable {
            [body.elements.start, body.elements.end]
        } else {
            [0, 0]
        };
        bodies.push(Part {
            name: body.name.clone(),
            faces: [first, faces.len()],
            elements,
        });
    }
    let mut elements: Vec<[u32; 8]> = if cuttable {
        recovered.points.cells.clone()
    } else {
        Vec::new()
    };
    let points = renumber(&mut faces, &mut elements, recovered.points.node.len());
    let node = |point: &u32| recovered.points.node[*point as usize] as usize;
    let mut packed = Packed::default();
    let (low, high) = bounds_or_unit(points.iter().map(|p| mesh.points[node(p)]));
    for axis in 0..3 {
        let steps = points.iter().map(|p| {
            let at = mesh.points[node(p)][axis];
            quantised(at, low[axis], high[axis])
        });
        packed.short(&steps.collect::<Vec<_>>());
    }
    let moved = points.iter().flat_map(|p| state.displacement[node(p)]);
    let displacement = moved.fold(0.0f64, |most, u| most.max(u.abs()));
    for axis in 0..3 {
        let steps = points.iter().map(|p| {
            let u = state.displacement[node(p)][axis];
            quantised(u, -displacement, displacement)
        });
        packed.short(&steps.collect::<Vec<_>>());
    }
    let mut fields = Vec::new();
    for (values, field) in scalars(recovered, pictures, units) {
        let shown = || points.iter().map(|p| values[*p as usize]);
        let largest = shown().fold(0.0, f64::max);
        let steps = shown().map(|v| quantised(v, 0.0, largest));
        packed.short(&steps.collect::<Vec<_>>());
        fields.push(Field { largest, ..field });
    }
    packed.groups(&faces);
    packed.groups(&elements);
    let header = Header {
        points: points.len(),
        faces: faces.len(),
        elements: elements.len(),
        low,
        high,
        displacement,
        bodies,
        fields,
        mirrors: scene.mirrors.clone(),
        places,
        length: units.length.clone(),
    };
    let arrays = packed.text().map_err(|source| FileError::Write {
        path: Path::new(FILE).to_path_buf(),
        source,
    })?;
    Ok(Shape { header, arrays })
}

/// The corners of a face by the points of its body.
fn as_points(face: &Face, mesh: &crate::model::mesh::Mesh, recovered: &Recovered) -> [u32; 4] {
    let element = face.element as usize;
    let corner = |node: u32| {
        let at = mesh.hexes[element].iter().position(|n| *n == node);
        at.map_or(node, |k| recovered.points.cells[element][k])
    };
    face.nodes.map(corner)
}

/// Renumbers faces and elements by the points that they use; these are returned, in their order.
fn renumber(faces: &mut [[u32; 4]], elements: &mut [[u32; 8]], count: usize) -> Vec<u32> {
    let mut used = vec![false; count];
    let corners = faces.iter().flatten().chain(elements.iter().flatten());
    corners.for_each(|p| used[*p as usize] = true);
    let points: Vec<u32> = (0..count as u32).filter(|p| used[*p as usize]).collect();
    let mut number = vec![0u32; count];
    (0u32..)
        .zip(&points)
        .for_each(|(k, p)| number[*p as usize] = k);
    let all = faces
        .iter_mut()
        .flatten()
        .chain(elements.iter_mut().flatten());
    all.for_each(|p| *p = number[*p as usize]);
    points
}

fn bounds_or_unit(points: impl Iterator<Item = [f64; 3]>) -> ([f64; 3], [f64; 3]) {
    let [low, high] = bounds(points);
    if low[0] <= high[0] {
        (low, high)
    } else {
        ([0.0; 3], [1.0; 3])
    }
}

/// What can be shown in colour, at the points of the bodies.
fn scalars<'a>(
    recovered: &'a Recovered,
    pictures: &'a Pictures,
    units: &UnitLabels,
) -> Vec<(&'a [f64], Field)> {
    let field = |name, unit: &str, note| Field {
        name,
        unit: unit.to_string(),
        largest: 0.0,
        note,
    };
    vec![
        (
            &recovered.mises_nodal,
            field("Mises stress", &units.stress, "nodal average of each body"),
        ),
        (
            &pictures.pressure,
            field(
                "contact pressure",
                &units.stress,
                "on the surface of each pair that carries it; hide the body before it",
            ),
        ),
        (
            &pictures.plastic_strain,
            field(
                "plastic strain",
                "",
                "equivalent, nodal average of each body",
            ),
        ),
    ]
}
