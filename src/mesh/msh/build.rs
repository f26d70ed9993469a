//! From the contents of a file to a mesh, checking that everything fits.

use rayon::prelude::*;

use super::Reading;
use super::error::{MeshError, Place};
use super::groups::{ENTITIES, Groups, name_of};
use super::raw::{Block, Places, Raw};
use super::tags::TagMap;
use crate::mesh::hexahedron::{Orientation, mirrored, orientation, scaled_jacobians};
use crate::mesh::surface::{FaceFinder, FaceMatch};
use crate::mesh::{Body, Face, Mesh, Surface};

/// Builds the mesh of the file whose contents are `raw`.
pub(super) fn build(raw: Raw, places: &Places<'_>) -> Result<Reading, MeshError> {
    let file = File { raw: &raw, places };
    let indices = file.node_indices()?;
    file.check_element_tags()?;
    let groups = Groups::new(&raw, places)?;
    let nodes = file.element_nodes(&indices)?;

    let mut mesh = Mesh {
        source: places.source.to_owned(),
        ..Mesh::default()
    };
    // Which element of the file each hexahedron is.
    let mut origin: Vec<usize> = Vec::new();
    for (tag, blocks) in &groups.volumes {
        let start = mesh.hexes.len();
        for block in blocks {
            for (element, hex) in (block.first..).zip(block_nodes::<8>(&nodes, block)) {
                mesh.hexes.push(*hex);
                origin.push(element);
            }
        }
        mesh.bodies.push(Body {
            name: name_of(&raw, (3, *tag)),
            elements: start..mesh.hexes.len(),
        });
    }
    mesh.points.clone_from(&raw.nodes.points);
    file.check_repeated(&mesh, &origin)?;
    let mut notes = file.orient(&mut mesh, &origin)?;

    let used = file.check_use(&mesh, &groups, &nodes)?;
    let finder = FaceFinder::new(&mesh.hexes, mesh.points.len());
    for (tag, blocks) in &groups.surfaces {
        let surface = Surface {
            name: name_of(&raw, (2, *tag)),
            faces: Vec::new(),
        };
        let quads = blocks
            .iter()
            .flat_map(|block| (block.first..).zip(block_nodes::<4>(&nodes, block).iter().copied()));
        mesh.surfaces
            .push(file.match_faces(&mesh, &finder, surface, quads)?);
    }
    let left_out = compact(&mut mesh, &used);
    if left_out > 0 {
        notes.push(format!(
            "{}: {left_out} nodes that belong to no hexahedron were left out",
            places.source
        ));
    }
    mesh.fingerprint = raw.fingerprint;
    Ok(Reading { mesh, notes })
}

/// The nodes of the elements of a run, by index.
fn block_nodes<'a, const N: usize>(nodes: &'a [u32], block: &Block) -> &'a [[u32; N]] {
    let all = nodes.get(block.first_node..block.first_node + N * block.count);
    all.unwrap_or_default().as_chunks().0
}

/// The contents of a file, with the means to say where something stands.
#[derive(Clone, Copy)]
struct File<'a> {
    raw: &'a Raw,
    places: &'a Places<'a>,
}

impl File<'_> {
    fn node_indices(&self) -> Result<TagMap, MeshError> {
        let nodes = &self.raw.nodes;
        self.limit(nodes.tags.len(), "nodes")?;
        TagMap::new(&nodes.tags)
            .map_err(|twice| self.twice("Nodes", "node", &nodes.tags, &nodes.marks, twice))
    }

    fn check_element_tags(&self) -> Result<(), MeshError> {
        let elements = &self.raw.elements;
        self.limit(elements.tags.len(), "elements")?;
        TagMap::new(&elements.tags).map(|_| ()).map_err(|twice| {
            self.twice(
                "Elements",
                "element",
                &elements.tags,
                &elements.marks,
                twice,
            )
        })
    }

    fn limit(&self, count: usize, what: &'static str) -> Result<(), MeshError> {
        let (count, limit) = (count as u64, u64::from(u32::MAX) - 1);
        if count <= limit {
            return Ok(());
        }
        let source_name = self.places.source.to_owned();
        Err(MeshError::TooLarge {
            source_name,
            count,
            limit,
            what,
        })
    }

    fn twice(
        &self,
        section: &str,
        what: &'static str,
        tags: &[u64],
        marks: &[u64],
        (first, second): (usize, usize),
    ) -> MeshError {
        let mark = |k: usize| marks.get(k).copied().unwrap_or_default();
        let place = self.places.place(section, mark(second));
        let tag = tags.get(second).copied().unwrap_or_default().to_string();
        MeshError::DuplicateTag {
            place,
            what,
            tag,
            first: self.places.at(mark(first)),
        }
    }

    /// The nodes of all elements, also those that are not needed, by index instead of tag.
    fn element_nodes(&self, indices: &TagMap) -> Result<Vec<u32>, MeshError> {
        let elements = &self.raw.elements;
        let mut nodes = Vec::with_capacity(elements.nodes.len());
        for block in &elements.blocks {
            for (element, tags) in block.iter(elements) {
                for &node in tags {
                    let Some(index) = indices.get(node) else {
                        let (place, element) = self.element(element);
                        return Err(MeshError::UnknownNode {
                            place,
                            element,
                            node,
                        });
                    };
                    nodes.push(index);
                }
            }
        }
        Ok(nodes)
    }

    /// Place and tag of element `element` of the file.
    fn element(&self, element: usize) -> (Place, u64) {
        let elements = &self.raw.elements;
        let mark = elements.marks.get(element).copied().unwrap_or_default();
        let tag = elements.tags.get(element).copied().unwrap_or_default();
        (self.places.place("Elements", mark), tag)
    }

    fn node_tag(&self, node: u32) -> u64 {
        self.raw
            .nodes
            .tags
            .get(node as usize)
            .copied()
            .unwrap_or_default()
    }

    /// Refuses hexahedra with a node twice, and two hexahedra of the same nodes.
    fn check_repeated(&self, mesh: &Mesh, origin: &[usize]) -> Result<(), MeshError> {
        let sorted = |hex: &[u32; 8]| {
            let mut nodes = *hex;
            nodes.sort_unstable();
            nodes
        };
        let twice = |hex: &[u32; 8]| sorted(hex).windows(2).find(|w| w[0] == w[1]).map(|w| w[0]);
        if let Some((k, node)) = mesh
            .hexes
            .iter()
            .enumerate()
            .find_map(|(k, hex)| Some((k, twice(hex)?)))
        {
            let why = format!("it has node {} twice", self.node_tag(node));
            return Err(self.degenerate(mesh, origin, k, why));
        }
        let mut keys: Vec<([u32; 8], u32)> = mesh
            .hexes
            .par_iter()
            .map(sorted)
            .zip(0..mesh.hexes.len() as u32)
            .collect();
        keys.par_sort_unstable();
        let Some((first, second)) = keys
            .windows(2)
            .find(|w| w[0].0 == w[1].0)
            .map(|w| (w[0].1 as usize, w[1].1 as usize))
        else {
            return Ok(());
        };
        let (place, element) = self.element(origin[second]);
        let (_, first_tag) = self.element(origin[first]);
        let [one, other] = [first, second].map(|k| &mesh.bodies[mesh.body_of(k)].name);
        let bodies = format!("`{one}` and `{other}`");
        Err(MeshError::RepeatedElement {
            place,
            element,
            first: first_tag,
            bodies,
        })
    }

    fn degenerate(&self, mesh: &Mesh, origin: &[usize], k: usize, why: String) -> MeshError {
        let (place, element) = self.element(origin[k]);
        let body = mesh.bodies[mesh.body_of(k)].name.clone();
        MeshError::Degenerate {
            place,
            element,
            body,
            why,
        }
    }

    /// Checks the Jacobians. A body all of whose elements are numbered for the mirror image is
    /// renumbered and noted; any other element that is not sound is refused.
    fn orient(&self, mesh: &mut Mesh, origin: &[usize]) -> Result<Vec<String>, MeshError> {
        let mut notes = Vec::new();
        let found: Vec<Orientation> = (0..mesh.hexes.len())
            .into_par_iter()
            .map(|k| orientation(&mesh.corners(k)))
            .collect();
        for body in &mesh.bodies {
            let range = body.elements.clone();
            let here = &found[range.clone()];
            if here.iter().all(|o| *o == Orientation::Mirrored) {
                for hex in &mut mesh.hexes[range.clone()] {
                    *hex = mirrored(*hex);
                }
                notes.push(format!(
                    "{}: the {} hexahedra of physical volume `{}` are numbered for the mirror \
                     image; their nodes were reordered",
                    self.places.source,
                    range.len(),
                    body.name
                ));
                continue;
            }
            let wrong = |o: &&Orientation| !matches!(o, Orientation::Sound | Orientation::Mirrored);
            let worst = here
                .iter()
                .position(|o| wrong(&o))
                .or_else(|| here.iter().position(|o| *o == Orientation::Mirrored));
            if let Some(k) = worst {
                return Err(self.unsound(mesh, origin, range.start + k, here[k]));
            }
        }
        Ok(notes)
    }

    fn unsound(&self, mesh: &Mesh, origin: &[usize], k: usize, found: Orientation) -> MeshError {
        let node = |corner: usize| self.node_tag(mesh.hexes[k][corner]);
        let (corner, jacobian) = match found {
            Orientation::Flat { corner, jacobian } => {
                let node = node(corner);
                let why = format!("it is flat at node {node} (scaled Jacobian {jacobian:.1e})");
                return self.degenerate(mesh, origin, k, why);
            }
            Orientation::Inverted { corner, jacobian } => (corner, jacobian),
            Orientation::Sound | Orientation::Mirrored => {
                (0, scaled_jacobians(&mesh.corners(k))[0])
            }
        };
        let (place, element) = self.element(origin[k]);
        let body = mesh.bodies[mesh.body_of(k)].name.clone();
        MeshError::Inverted {
            place,
            element,
            body,
            node: node(corner),
            jacobian,
        }
    }

    /// Which nodes the hexahedra use. Other nodes must be used by points, curves or surfaces that
    /// belong to no physical group, as gmsh writes them when asked to save all: such a node is
    /// the centre of an arc, for example.
    fn check_use(
        &self,
        mesh: &Mesh,
        groups: &Groups<'_>,
        nodes: &[u32],
    ) -> Result<Vec<bool>, MeshError> {
        let mut used = vec![false; mesh.points.len()];
        for &node in mesh.hexes.iter().flatten() {
            used[node as usize] = true;
        }
        for ((dimension, tag), block) in &groups.lower {
            let range = block.first_node..block.first_node + block.count * block.kind.nodes;
            let lone = nodes
                .get(range)
                .unwrap_or_default()
                .iter()
                .find(|n| !used[**n as usize]);
            if let Some(&node) = lone {
                let kind = ENTITIES[usize::from(*dimension)];
                let name = name_of(self.raw, (*dimension, *tag));
                let use_of_it = format!("belongs to physical {kind} `{name}` but to no hexahedron");
                return Err(self.unused(node, use_of_it));
            }
        }
        let mut touched = used.clone();
        for &node in nodes {
            touched[node as usize] = true;
        }
        match (0u32..).zip(&touched).find(|(_, touched)| !**touched) {
            Some((node, _)) => Err(self.unused(node, "belongs to no element".to_owned())),
            None => Ok(used),
        }
    }

    fn unused(&self, node: u32, use_of_it: String) -> MeshError {
        let nodes = &self.raw.nodes;
        let mark = nodes.marks.get(node as usize).copied().unwrap_or_default();
        let block = nodes
            .blocks
            .partition_point(|(first, _)| *first <= node as usize);
        let owner = match block.checked_sub(1).and_then(|k| nodes.blocks.get(k)) {
            Some((_, key)) => format!(" of {} {}", ENTITIES[usize::from(key.0.min(3))], key.1),
            None => String::new(),
        };
        let place = self.places.place("Nodes", mark);
        MeshError::UnusedNode {
            place,
            node: self.node_tag(node),
            owner,
            use_of_it,
        }
    }

    /// Fills `surface` with the faces that its quadrilaterals (element of the file, nodes) are.
    fn match_faces(
        &self,
        mesh: &Mesh,
        finder: &FaceFinder<'_>,
        mut surface: Surface,
        quads: impl Iterator<Item = (usize, [u32; 4])>,
    ) -> Result<Surface, MeshError> {
        let mut origin: Vec<usize> = Vec::new();
        let refused = |element: usize, surface: &Surface, why: String| {
            let (place, element) = self.element(element);
            MeshError::SurfaceFace {
                place,
                element,
                surface: surface.name.clone(),
                why,
            }
        };
        for (element, nodes) in quads {
            let why = match finder.find(nodes) {
                FaceMatch::Outer(face) => {
                    surface.faces.push(face);
                    origin.push(element);
                    continue;
                }
                FaceMatch::None => {
                    let tags = nodes.map(|node| self.node_tag(node).to_string());
                    format!("is the face of no hexahedron (nodes {})", tags.join(", "))
                }
                FaceMatch::Between(one, other) => {
                    let [one, other] =
                        [one, other].map(|k| &mesh.bodies[mesh.body_of(k as usize)].name);
                    if one == other {
                        format!("lies inside physical volume `{one}`, between two hexahedra")
                    } else {
                        format!(
                            "lies between physical volumes `{one}` and `{other}`, which share its nodes"
                        )
                    }
                }
            };
            return Err(refused(element, &surface, why));
        }
        let mut order: Vec<usize> = (0..surface.faces.len()).collect();
        let key = |k: &usize| {
            let Face { nodes, element } = surface.faces[*k];
            (element, nodes, *k)
        };
        order.sort_unstable_by_key(key);
        for pair in order.windows(2) {
            if surface.faces[pair[0]] == surface.faces[pair[1]] {
                let (_, first) = self.element(origin[pair[0]]);
                let why = format!("is the same face as element {first}");
                return Err(refused(origin[pair[1]], &surface, why));
            }
        }
        Ok(surface)
    }
}

/// Leaves out the nodes that are not `used` and returns how many they were.
fn compact(mesh: &mut Mesh, used: &[bool]) -> usize {
    let mut next = 0u32;
    let fresh: Vec<u32> = used
        .iter()
        .map(|used| {
            let index = next;
            next += u32::from(*used);
            index
        })
        .collect();
    let left_out = used.len() - next as usize;
    if left_out > 0 {
        let renumber = |node: &mut u32| *node = fresh[*node as usize];
        mesh.hexes.iter_mut().flatten().for_each(renumber);
        let faces = mesh.surfaces.iter_mut().flat_map(|s| &mut s.faces);
        faces.flat_map(|face| &mut face.nodes).for_each(renumber);
        let mut keep = used.iter();
        mesh.points
            .retain(|_| keep.next().is_some_and(|used| *used));
    }
    left_out
}
