//! Bodies that share nodes.

use crate::model::mesh::Mesh;
use crate::model::scene::Scene;
use std::collections::{BTreeMap, BTreeSet};

/// Two bodies that share nodes: they are one there, whatever contact is said to be between them.
pub struct Weld {
    /// Their indices, ascending.
    bodies: [usize; 2],
    /// How many nodes they share.
    nodes: usize,
}

impl Weld {
    /// That they do.
    pub fn in_words(&self, mesh: &Mesh) -> String {
        let [a, b] = self.bodies.map(|index| mesh.bodies[index].name.as_str());
        let count = self.nodes;
        format!("{a} and {b} share {count} nodes: they are joined there, and no contact parts them")
    }
}

/// All of a mesh.
pub fn welds(mesh: &Mesh) -> Vec<Weld> {
    let mut first = vec![usize::MAX; mesh.points.len()];
    let mut shared: BTreeMap<[usize; 2], BTreeSet<u32>> = BTreeMap::new();
    for (index, body) in mesh.bodies.iter().enumerate() {
        for node in mesh.hexes[body.elements.clone()].iter().flatten() {
            match &mut first[*node as usize] {
                none if *none == usize::MAX => *none = index,
                other if *other == index => {}
                other => {
                    shared.entry([*other, index]).or_default().insert(*node);
                }
            }
        }
    }
    let weld = |(bodies, nodes): ([usize; 2], BTreeSet<u32>)| Weld {
        bodies,
        nodes: nodes.len(),
    };
    shared.into_iter().map(weld).collect()
}

/// Those between the bodies of a contact pair, in words: such a mesh was made of one body, and not of two that touch.
pub fn in_contact(scene: &Scene) -> Vec<String> {
    let mesh = &scene.mesh;
    let pairs = scene.contacts.iter().map(|pair| pair.bodies(mesh));
    let pairs: BTreeSet<[Option<usize>; 2]> = pairs.collect();
    let touch = |weld: &&Weld| {
        let [a, b] = weld.bodies.map(Some);
        pairs.contains(&[a, b]) || pairs.contains(&[b, a])
    };
    let welds = welds(mesh);
    (welds.iter().filter(touch))
        .map(|weld| weld.in_words(mesh))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::material::Steel;
    use crate::model::mesh::Body;
    use crate::model::mesh::block::{Block, uniform};
    use crate::model::scene::{ContactPair, Partner, Side};

    #[test]
    fn bodies_of_a_contact_that_share_nodes_are_told() {
        let side = || uniform(0.0, 2.0, 2);
        let mut mesh = Block::new("block", side(), side(), side()).build().unwrap();
        let body = |name: &str, elements| Body {
            name: name.into(),
            elements,
        };
        mesh.bodies = vec![body("low", 0..4), body("high", 4..8)];
        let steel = Steel {
            youngs_modulus: 1.0,
            poissons_ratio: 0.3,
            yield_stress: f64::INFINITY,
            hardening_modulus: 0.0,
        };
        let mut scene = Scene::bare("welded", mesh, steel);
        assert_eq!((welds(&scene.mesh).len(), in_contact(&scene).len()), (1, 0));
        scene.contacts.push(ContactPair {
            name: "high-low".into(),
            upper: Partner::Surface("z_max".into()),
            lower: Partner::Surface("z_min".into()),
            carrier: Side::Upper,
            friction: 0.0,
            penalty_factor: 1.0,
            true_geometry: false,
        });
        let [told] = &in_contact(&scene)[..] else {
            panic!("one is expected")
        };
        assert!(told.starts_with("low and high share 9 nodes"), "{told}");
    }
}
