//! One half of a scene that is its own image.

use super::alike;
use super::folded::HalfTurn;
use super::image::Images;
use super::reason::NoHalfTurn;
use crate::ground::order::ascending;
use crate::model::mesh::{Body, Face, Mesh, Surface};
use crate::model::scene::{Partner, Scene};

/// How near to the mid-plane, of the height of the model, the middle of an element is on it.
const ON_THE_MIDDLE: f64 = 1e-6;

impl HalfTurn {
    /// Folds `scene`, where it is its own image.
    ///
    /// # Errors
    /// [`NoHalfTurn`] says what breaks the symmetry.
    pub fn of(scene: &Scene) -> Result<Self, NoHalfTurn> {
        alike::loads(scene)?;
        let images = Images::of(&scene.mesh, &scene.materials)?;
        let bottom = alike::supports(scene, &images)?;
        let pairs = alike::contacts(scene, &images)?;
        fold(scene, images, bottom, pairs)
    }
}

/// The half of `scene` on the side of its load, `bottom` being the support opposite to it and `pairs` the image of each
/// contact pair.
fn fold(
    scene: &Scene,
    images: Images,
    bottom: usize,
    pairs: Vec<usize>,
) -> Result<HalfTurn, NoHalfTurn> {
    let mesh = &scene.mesh;
    let loaded = (scene.rigid_planes.first())
        .and_then(|plane| mesh.surface(&plane.surface)?.faces.first())
        .ok_or(NoHalfTurn::Load)?;
    let above = |element: usize| {
        let corners = mesh.corners(element);
        corners.iter().map(|p| p[2] - images.middle).sum::<f64>() / 8.0
    };
    let side = above(loaded.element as usize);
    let mut keep = Vec::with_capacity(mesh.hexes.len());
    for element in 0..mesh.hexes.len() {
        let height = above(element) / side;
        // Both of a pair of elements on the mid-plane would be kept, or neither.
        let across = height.abs() < ON_THE_MIDDLE;
        if across {
            return Err(NoHalfTurn::Layers {
                body: mesh.bodies[mesh.body_of(element)].name.clone(),
            });
        }
        keep.push(height > 0.0);
    }
    let whole_elements: Vec<u32> = (0..)
        .zip(&keep)
        .filter_map(|(e, k)| k.then_some(e))
        .collect();
    let (half_mesh, whole_nodes) = part(mesh, &keep, &whole_elements);
    let own_nodes = places(&whole_nodes, mesh.points.len());
    let own_elements = places(&whole_elements, mesh.hexes.len());
    // Tied to its image: what is in the half and so is its image.
    let cut = (0..).zip(&whole_nodes).filter_map(|(own, node)| {
        let image = own_nodes[images.nodes[*node as usize] as usize];
        (image != u32::MAX && own <= image).then_some([own, image])
    });
    let cut: Vec<[u32; 2]> = cut.collect();

    let on_cut = |surface: &Surface| {
        let nodes = surface.nodes();
        let has = |n: &u32| nodes.binary_search(n).is_ok();
        cut.iter().flatten().any(has)
    };
    let mut kept_pairs = Vec::new();
    let mut half_contacts = Vec::new();
    for (index, pair) in scene.contacts.iter().enumerate() {
        let sides = [&pair.upper, &pair.lower].map(|side: &Partner| {
            let whole = side.surface(mesh).map_or(0, |s| s.faces.len());
            let own = side.surface(&half_mesh);
            let left = own.map_or(0, |s| s.faces.len());
            (whole, left, own.is_some_and(on_cut))
        });
        let all = sides.iter().all(|(whole, left, cut)| left == whole && !cut);
        let none = sides.iter().all(|(_, left, _)| *left == 0);
        if !all && !none {
            return Err(NoHalfTurn::Contact {
                pair: pair.name.clone(),
            });
        }
        if all {
            kept_pairs.push(index);
            half_contacts.push(pair.clone());
        }
    }
    let of_pair = |index: usize| {
        let own = |pair: usize| kept_pairs.iter().position(|kept| *kept == pair);
        own(index)
            .map(|own| (own, false))
            .or_else(|| own(pairs[index]).map(|own| (own, true)))
            .ok_or_else(|| NoHalfTurn::Contact {
                pair: scene.contacts[index].name.clone(),
            })
    };
    let pairs = (0..scene.contacts.len())
        .map(of_pair)
        .collect::<Result<_, _>>()?;
    let carriers = (0..scene.contacts.len())
        .map(|pair| scene.carrier(pair).map(Surface::nodes).unwrap_or_default())
        .collect();

    let supports = scene.supports.iter().enumerate();
    let supports = supports.filter(|(index, support)| {
        let left = half_mesh.surface(&support.surface);
        *index != bottom && left.is_some_and(|s| !s.faces.is_empty())
    });
    let materials = scene.materials.iter().zip(&mesh.bodies);
    let materials = materials.filter(|(_, body)| half_mesh.body(&body.name).is_some());
    let half = Scene {
        name: scene.name.clone(),
        materials: materials.map(|(steel, _)| *steel).collect(),
        contacts: half_contacts,
        supports: supports.map(|(_, support)| support.clone()).collect(),
        rigid_planes: scene.rigid_planes.clone(),
        tractions: Vec::new(),
        steps: scene.steps.clone(),
        mirrors: scene.mirrors.clone(),
        temperatures: Vec::new(),
        ties: Vec::new(),
        half_turn: cut,
        controls: scene.controls,
        mesh: half_mesh,
    };
    let nodes = (0..mesh.points.len()).map(|node| match own_nodes[node] {
        u32::MAX => (own_nodes[images.nodes[node] as usize], true),
        own => (own, false),
    });
    let elements = (0..mesh.hexes.len()).map(|element| match own_elements[element] {
        u32::MAX => {
            let image = images.elements[element];
            let corners = corners_of_image(mesh, &images, (element, image as usize));
            (own_elements[image as usize], Some(corners))
        }
        own => (own, None),
    });
    let folded = HalfTurn {
        nodes: nodes.collect(),
        elements: elements.collect(),
        whole_nodes,
        whole_elements,
        pairs,
        carriers,
        middle: images.middle,
        half,
    };
    let complete = folded.nodes.iter().all(|(own, _)| *own != u32::MAX)
        && folded.elements.iter().all(|(own, _)| *own != u32::MAX);
    match complete {
        true => Ok(folded),
        false => Err(NoHalfTurn::Load),
    }
}

/// The corner of the element `image` that each corner of `element` is turned into.
fn corners_of_image(mesh: &Mesh, images: &Images, (element, image): (usize, usize)) -> [u8; 8] {
    mesh.hexes[element].map(|node| {
        let turned = images.nodes[node as usize];
        let at = mesh.hexes[image].iter().position(|n| *n == turned);
        at.unwrap_or_default() as u8
    })
}

/// Where in a `list` each of `count` numbers stands; `u32::MAX` for one that does not.
fn places(list: &[u32], count: usize) -> Vec<u32> {
    let mut places = vec![u32::MAX; count];
    for (place, number) in (0..).zip(list) {
        places[*number as usize] = place;
    }
    places
}

/// The elements of a mesh that are kept, and the node of `mesh` of each node.
fn part(mesh: &Mesh, keep: &[bool], elements: &[u32]) -> (Mesh, Vec<u32>) {
    let nodes = ascending(elements.iter().flat_map(|e| mesh.hexes[*e as usize]));
    let own = places(&nodes, mesh.points.len());
    let own_element = places(elements, mesh.hexes.len());
    let bodies = mesh.bodies.iter().filter_map(|body| {
        let [from, to] = [body.elements.start, body.elements.end]
            .map(|end| elements.partition_point(|e| (*e as usize) < end));
        (from < to).then(|| Body {
            name: body.name.clone(),
            elements: from..to,
        })
    });
    let surfaces = mesh.surfaces.iter().map(|surface| {
        let faces = surface.faces.iter().filter(|f| keep[f.element as usize]);
        Surface {
            name: surface.name.clone(),
            faces: faces
                .map(|face| Face {
                    nodes: face.nodes.map(|n| own[n as usize]),
                    element: own_element[face.element as usize],
                })
                .collect(),
        }
    });
    let part = Mesh {
        source: mesh.source.clone(),
        points: nodes.iter().map(|n| mesh.points[*n as usize]).collect(),
        hexes: (elements.iter())
            .map(|e| mesh.hexes[*e as usize].map(|n| own[n as usize]))
            .collect(),
        bodies: bodies.collect(),
        surfaces: surfaces.collect(),
        hanging: Vec::new(),
        fingerprint: mesh.fingerprint.clone(),
    };
    (part, nodes)
}
