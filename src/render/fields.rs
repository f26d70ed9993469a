//! The two grids of an increment: the bodies and the contact surfaces.

use std::borrow::Cow;

use super::encode::Values;
use super::grid::{Array, CellType, Grid};
use crate::answer::results::recovery::Recovered;
use crate::ground::units::UnitLabels;
use crate::model::scene::Scene;
use crate::model::state::State;
use crate::render::OutputError;

/// The bodies: points `displacement`, `stress` (xx yy zz xy yz zx), `mises_nodal`; cells `body`,
/// `mises_mean`, `mises_max`, `peeq`. Undeformed, modelled part only.
///
/// A node that two bodies share appears once for each.
///
/// # Errors
/// [`OutputError::Misfit`] where the state is not one of the scene.
pub fn bodies<'a>(
    scene: &'a Scene,
    state: &'a State,
    recovered: &'a Recovered,
) -> Result<Grid<'a>, OutputError> {
    state.check(scene)?;
    let mesh = &scene.mesh;
    let nodes = &recovered.points.node;
    let body: Vec<i32> = (0..mesh.hexes.len())
        .map(|e| mesh.body_of(e) as i32)
        .collect();
    let scalar = |name, values: &'a [f64]| Array::scalar(name, Values::F64(values.into()));
    Ok(Grid {
        points: at_points(&mesh.points, nodes),
        cell_type: CellType::Hexahedron,
        connectivity: recovered
            .points
            .cells
            .as_flattened()
            .iter()
            .map(|p| i64::from(*p))
            .collect(),
        point_data: vec![
            Array::vector("displacement", at_points(&state.displacement, nodes)),
            Array::tensor("stress", recovered.nodal_stress.as_flattened()),
            scalar("mises_nodal", &recovered.mises_nodal),
        ],
        cell_data: vec![
            Array::scalar("body", Values::I32(body.into())),
            scalar("mises_mean", &recovered.mises_mean),
            scalar("mises_max", &recovered.mises_max),
            scalar("peeq", &recovered.peeq),
        ],
        names: vec![(
            "body_names",
            mesh.bodies.iter().map(|b| b.name.clone()).collect(),
        )],
    })
}

/// Nodal vectors at the points; without shared nodes these are the nodes themselves.
fn at_points<'a>(nodal: &'a [[f64; 3]], nodes: &[u32]) -> Cow<'a, [f64]> {
    if nodes.len() == nodal.len() {
        return nodal.as_flattened().into();
    }
    nodes
        .iter()
        .flat_map(|n| nodal[*n as usize])
        .collect::<Vec<f64>>()
        .into()
}

/// The carrier surfaces of all contact pairs: points `contact_pressure` (compression positive),
/// `gap` (open positive, not a number where nothing is within reach), `traction` (tangential, on
/// the lower body), `slip`, `contact_status` (0 open, 1 stick, 2 slip) and `displacement`; cells
/// `interface`, the index of the pair. A node in two pairs appears once for each.
///
/// # Errors
/// [`OutputError::Misfit`] where the state is not one of the scene, [`OutputError::NoCarrier`]
/// where a pair has no surface.
pub fn contacts<'a>(scene: &'a Scene, state: &State) -> Result<Grid<'a>, OutputError> {
    state.check(scene)?;
    let mut surfaces = Surfaces::default();
    for pair in 0..scene.contacts.len() {
        surfaces.add(scene, state, pair)?;
    }
    let scalar = |name, values: Vec<f64>| Array::scalar(name, Values::F64(values.into()));
    Ok(Grid {
        points: surfaces.points.into(),
        cell_type: CellType::Quad,
        connectivity: surfaces.connectivity,
        point_data: vec![
            Array::vector("displacement", surfaces.displacement),
            scalar("contact_pressure", surfaces.pressure),
            scalar("gap", surfaces.gap),
            Array::vector("traction", surfaces.traction),
            scalar("slip", surfaces.slip),
            Array::scalar("contact_status", Values::U8(surfaces.status.into())),
        ],
        cell_data: vec![Array::scalar(
            "interface",
            Values::I32(surfaces.interface.into()),
        )],
        names: vec![(
            "interface_names",
            scene
                .contacts
                .iter()
                .map(|pair| pair.name.clone())
                .collect(),
        )],
    })
}

/// The field data `units` of a grid: what its coordinates and every array that has a unit are in, as "gap: mm".
pub fn units(grid: &Grid, units: &UnitLabels) -> (&'static str, Vec<String>) {
    let arrays = grid.point_data.iter().chain(&grid.cell_data);
    let unit = |name: &str| match name {
        "displacement" | "gap" | "slip" => Some(&units.length),
        "stress" | "mises_nodal" | "mises_mean" | "mises_max" | "contact_pressure" | "traction" => {
            Some(&units.stress)
        }
        _ => None,
    };
    let of_arrays =
        arrays.filter_map(|array| Some(format!("{}: {}", array.name, unit(array.name)?)));
    let points = format!("Points: {}", units.length);
    ("units", std::iter::once(points).chain(of_arrays).collect())
}

#[derive(Default)]
struct Surfaces {
    points: Vec<f64>,
    connectivity: Vec<i64>,
    interface: Vec<i32>,
    displacement: Vec<f64>,
    pressure: Vec<f64>,
    gap: Vec<f64>,
    traction: Vec<f64>,
    slip: Vec<f64>,
    status: Vec<u8>,
}

impl Surfaces {
    fn add(&mut self, scene: &Scene, state: &State, pair: usize) -> Result<(), OutputError> {
        let surface = scene.carrier(pair).ok_or_else(|| OutputError::NoCarrier {
            pair: scene.contacts[pair].name.clone(),
        })?;
        let field = &state.contacts[pair];
        let first = self.pressure.len();
        let nodes = surface.nodes();
        for node in &nodes {
            self.points.extend(scene.mesh.points[*node as usize]);
            self.displacement.extend(state.displacement[*node as usize]);
            let entry = field.nodes.binary_search(node).ok();
            self.pressure.push(entry.map_or(0.0, |i| field.pressure[i]));
            // An infinite gap would spoil every colour scale.
            let gap = entry.map(|i| field.gap[i]).filter(|g| g.is_finite());
            self.gap.push(gap.unwrap_or(f64::NAN));
            self.traction
                .extend(entry.map_or([0.0; 3], |i| field.traction[i]));
            self.slip.push(entry.map_or(0.0, |i| field.slip[i]));
            self.status.push(entry.map_or(0, |i| field.status[i]));
        }
        for face in &surface.faces {
            // Every node of a face is in the list made from the faces.
            let point = |node: u32| first + nodes.partition_point(|n| *n < node);
            self.connectivity
                .extend(face.nodes.map(|node| point(node) as i64));
            self.interface.push(pair as i32);
        }
        Ok(())
    }
}
