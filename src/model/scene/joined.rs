//! Bodies that ties or shared nodes join.

use super::{ContactPair, Scene};

/// Of each body the lowest one that ties or shared nodes join it to, by whatever way; itself where there is none.
pub fn joined(scene: &Scene) -> Vec<usize> {
    let mesh = &scene.mesh;
    let mut group: Vec<usize> = (0..mesh.bodies.len()).collect();
    let mut owner = vec![None; mesh.points.len()];
    for (body, own) in mesh.bodies.iter().enumerate() {
        for node in mesh.hexes[own.elements.clone()].iter().flatten() {
            let first = *owner[*node as usize].get_or_insert(body);
            if group[first] != group[body] {
                unite(&mut group, &[first, body]);
            }
        }
    }
    for surfaces in scene.ties.iter().filter_map(|tie| tie.of(mesh)) {
        let bodies = surfaces.into_iter().flat_map(|s| s.bodies(mesh));
        unite(&mut group, &bodies.collect::<Vec<_>>());
    }
    group
}

/// The bodies of a pair and all that are joined to them, ascending.
pub fn joined_to(scene: &Scene, pair: &ContactPair) -> Vec<usize> {
    let group = joined(scene);
    let of_pair: Vec<usize> = (pair.bodies(&scene.mesh).into_iter().flatten())
        .map(|body| group[body])
        .collect();
    (0..group.len())
        .filter(|body| of_pair.contains(&group[*body]))
        .collect()
}

/// Makes one group of those that `bodies` are in.
fn unite(group: &mut [usize], bodies: &[usize]) {
    let members: Vec<usize> = bodies.iter().map(|body| group[*body]).collect();
    let low = members.iter().copied().min().unwrap_or_default();
    for own in group.iter_mut().filter(|own| members.contains(own)) {
        *own = low;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::material::Steel;
    use crate::model::mesh::Body;
    use crate::model::mesh::block::{Block, uniform};

    #[test]
    fn bodies_that_share_nodes_are_joined() {
        let side = || uniform(0.0, 1.0, 1);
        let block = Block::new("block", side(), side(), uniform(0.0, 4.0, 4));
        let mut mesh = block.build().unwrap();
        // One element each; between the second and the third one is missing.
        let body = |(name, e): (&str, usize)| Body {
            name: name.into(),
            elements: e..e + 1,
        };
        mesh.hexes.remove(2);
        mesh.surfaces.clear();
        mesh.bodies = [("core", 0), ("layer", 1), ("apart", 2)].map(body).into();
        let scene = Scene::bare("welded", mesh, Steel::elastic(1.0, 0.3));
        assert_eq!(joined(&scene), [0, 0, 2]);
    }
}
