//! Temperatures of bodies as those of their nodes.

use super::InpError;
use crate::ground::geometry::sub;
use crate::model::scene::{Scene, Step, Temperature};
use crate::render::inp::{Heat, NodalTemperature};
use std::collections::BTreeMap;

/// Expansion of the bodies that have a temperature, and the temperatures of their nodes at the end of every step.
///
/// Several temperatures of one body add up as strains; the expansion is that of the first.
///
/// # Errors
/// [`InpError::SharedHeat`] where two bodies want other temperatures of a node that they share.
pub fn heat(scene: &Scene) -> Result<Heat, InpError> {
    let mut heat = Heat::default();
    for temperature in &scene.temperatures {
        if let Some(body) = scene.mesh.body(&temperature.body) {
            heat.expansions.entry(body).or_insert(temperature.expansion);
        }
    }
    if heat.expansions.is_empty() {
        return Ok(heat);
    }
    heat.steps = (scene.steps.iter())
        .map(|step| of_step(scene, step, &heat.expansions))
        .collect::<Result<_, _>>()?;
    Ok(heat)
}

fn of_step(
    scene: &Scene,
    step: &Step,
    expansions: &BTreeMap<usize, f64>,
) -> Result<Vec<NodalTemperature>, InpError> {
    let mesh = &scene.mesh;
    let mut all: BTreeMap<u32, (f64, usize)> = BTreeMap::new();
    for (body, expansion) in expansions {
        let middle = mesh.middle_of_body(*body, &scene.mirrors);
        let name = &mesh.bodies[*body].name;
        let own: Vec<&Temperature> =
            (scene.temperatures.iter().filter(|t| t.body == *name)).collect();
        let strain = |arm| {
            let factored = own.iter().map(|t| step.factor_of(&t.name) * t.strain(arm));
            factored.sum::<f64>()
        };
        for node in mesh.hexes[mesh.bodies[*body].elements.clone()].as_flattened() {
            let value = strain(sub(mesh.points[*node as usize], middle)) / expansion;
            let (other, of) = *all.entry(*node).or_insert((value, *body));
            if of != *body && other != value {
                return Err(InpError::SharedHeat {
                    node: *node as usize + 1,
                    bodies: [of, *body].map(|b| mesh.bodies[b].name.clone()),
                });
            }
        }
    }
    let nodes = all.into_iter();
    Ok(nodes
        .map(|(node, (value, _))| NodalTemperature { node, value })
        .collect())
}
