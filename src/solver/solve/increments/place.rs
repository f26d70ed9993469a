//! Places of a model in words.

use crate::model::mesh::Body;
use crate::solver::fem::dofs::FIXED;
use crate::solver::solve::model::system::Model;

pub fn body_of<'m>(model: &'m Model, node: u32) -> &'m Body {
    let mesh = &model.scene.mesh;
    let element = mesh.hexes.iter().position(|h| h.contains(&node));
    &mesh.bodies[mesh.body_of(element.unwrap_or(0))]
}

/// Node and axis of an equation.
pub fn place(model: &Model, equation: usize) -> Option<(u32, usize)> {
    let nodes = (0..).zip(&model.dofs.equations);
    let on = |e: &u32| *e != FIXED && *e as usize == equation;
    let mut found = nodes.filter_map(|(node, axes)| Some((node, axes.iter().position(on)?)));
    found.next()
}

pub fn place_in_words(model: &Model, equation: usize) -> String {
    let Some((node, _)) = place(model, equation) else {
        return "the motion of a rigid plane".to_owned();
    };
    let at = model.scene.mesh.points[node as usize];
    format!("`{}` at {}", body_of(model, node).name, point(at))
}

/// The contact that is furthest from settled.
pub fn contact_in_words(model: &Model, row: Option<usize>, changed: usize) -> String {
    let Some(row) = row.and_then(|row| model.rows.get(row)) else {
        return "there is no contact".to_owned();
    };
    let at = model.scene.mesh.points[row.row.node as usize];
    let pair = &model.scene.contacts[row.pair].name;
    let at = point(at);
    format!("`{pair}` at {at}, {changed} contact nodes still changing")
}

fn point(at: [f64; 3]) -> String {
    let size = at.iter().fold(0.0f64, |size, c| size.max(c.abs()));
    let plain = size == 0.0 || (1e-2..1e5).contains(&size);
    let [x, y, z] = at.map(|c| {
        if plain {
            format!("{c:.4}")
        } else {
            format!("{c:.3e}")
        }
    });
    format!("({x}, {y}, {z})")
}
