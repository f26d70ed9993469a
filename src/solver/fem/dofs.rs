//! From nodal displacement components to equations.

use crate::model::mesh::Mesh;
use crate::model::scene::{PlaneMotion, Scene};

/// Marks a component without an equation.
pub const FIXED: u32 = u32::MAX;

/// Which equation each displacement component belongs to.
///
/// Equations are numbered vertex by vertex: a vertex is a node with its free components, or one
/// component of a rigid plane, which all its nodes share.
#[derive(Debug, Clone)]
pub struct DofMap {
    /// Equation of each component of each node, or [`FIXED`].
    pub equations: Vec<[u32; 3]>,
    /// First equation of each vertex, and the number of equations at the end.
    pub vertex_start: Vec<u32>,
    /// Equation of each driven component of each rigid plane.
    pub planes: Vec<[Option<u32>; 3]>,
    /// Prescribed components: node, axis, displacement at factor one, and what
    /// prescribes it (a [`Source`]).
    pub prescribed: Vec<Prescribed>,
    /// Is the node the image of another under the half turn? It has the other's equations, x and y exchanged, and moves
    /// along z the other way. Empty where there is no half turn.
    pub turned: Vec<bool>,
}

/// A displacement component whose value is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prescribed {
    /// The node,
    pub node: u32,
    /// the axis (0, 1, 2),
    pub axis: usize,
    /// the displacement at factor one, a length,
    pub value: f64,
    /// and what prescribes it.
    pub source: Source,
}

/// The entry of the scene that prescribes a component.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// A support, by its index in the scene.
    Support(usize),
    /// A rigid plane, by its index in the scene.
    Plane(usize),
}

/// Two entries of a scene disagree about one displacement component.
#[derive(Debug, Clone, PartialEq, thiserror::Error, miette::Diagnostic)]
#[error(
    "surfaces `{first}` and `{second}` prescribe different motions along {axis} for shared nodes \
     (node {node})"
)]
#[diagnostic(
    code(brinell::scene::conflicting_supports),
    help("free the component in one of the two, or separate the surfaces")
)]
pub struct Conflict {
    /// The two surfaces
    pub first: String,
    /// that disagree,
    pub second: String,
    /// the axis,
    pub axis: char,
    /// and a node that both have.
    pub node: u32,
}

impl DofMap {
    /// Numbers the equations of `scene`.
    ///
    /// # Errors
    /// [`Conflict`] where supports and planes contradict each other.
    pub fn new(scene: &Scene) -> Result<Self, Conflict> {
        let mesh = &scene.mesh;
        let mut owner = vec![[None::<Owner>; 3]; mesh.points.len()];
        let mut claim = |mesh: &Mesh, surface: &str, axis: usize, owns: &dyn Fn(u32) -> Owner| {
            for node in mesh.surface(surface).map(|s| s.nodes()).unwrap_or_default() {
                let new = owns(node);
                let slot = &mut owner[node as usize][axis];
                match *slot {
                    Some(old) if !old.agrees(&new) => {
                        return Err(Conflict {
                            first: old.name(scene).to_owned(),
                            second: new.name(scene).to_owned(),
                            axis: ['x', 'y', 'z'][axis],
                            node,
                        });
                    }
                    Some(Owner::Driven(_)) => {}
                    _ => *slot = Some(new),
                }
            }
            Ok(())
        };
        for (index, plane) in scene.rigid_planes.iter().enumerate() {
            for axis in 0..3 {
                let new = match plane.motion[axis] {
                    PlaneMotion::Held(value) => Owner::Held(value, Source::Plane(index)),
                    PlaneMotion::Driven(_) => Owner::Driven(index),
                    PlaneMotion::Free => continue,
                };
                claim(mesh, &plane.surface, axis, &|_| new)?;
            }
        }
        for (index, support) in scene.supports.iter().enumerate() {
            for axis in 0..3 {
                if let Some(constant) = support.components[axis] {
                    let owns = |node: u32| {
                        let value = support.displacement(axis, &mesh.points[node as usize]);
                        Owner::Held(value.unwrap_or(constant), Source::Support(index))
                    };
                    claim(mesh, &support.surface, axis, &owns)?;
                }
            }
        }
        Ok(Self::number(scene, &owner))
    }

    fn number(scene: &Scene, owner: &[[Option<Owner>; 3]]) -> Self {
        let mut map = Self {
            equations: vec![[FIXED; 3]; owner.len()],
            vertex_start: vec![0],
            planes: vec![[None; 3]; scene.rigid_planes.len()],
            prescribed: Vec::new(),
            turned: Vec::new(),
        };
        let cut = Cut::new(scene, owner);
        let mut next = 0u32;
        for (node, axes) in owner.iter().enumerate() {
            let before = next;
            for (axis, owner) in axes.iter().enumerate() {
                match *owner {
                    None if cut.decides(node, axis) => {}
                    None => {
                        map.equations[node][axis] = next;
                        next += 1;
                    }
                    Some(Owner::Held(value, source)) => map.prescribed.push(Prescribed {
                        node: node as u32,
                        axis,
                        value,
                        source,
                    }),
                    Some(Owner::Driven(_)) => {}
                }
            }
            if cut.on_axis(node) {
                map.equations[node][1] = map.equations[node][0];
            }
            if next > before {
                map.vertex_start.push(next);
            }
        }
        for (node, axes) in owner.iter().enumerate() {
            for (axis, owner) in axes.iter().enumerate() {
                if let Some(Owner::Driven(plane)) = *owner {
                    let equation = *map.planes[plane][axis].get_or_insert_with(|| {
                        next += 1;
                        map.vertex_start.push(next);
                        next - 1
                    });
                    map.equations[node][axis] = equation;
                }
            }
        }
        for [node, image] in scene.half_turn.iter().filter(|[a, b]| a != b) {
            let [x, y, z] = map.equations[*node as usize];
            map.equations[*image as usize] = [y, x, z];
        }
        map.turned = cut.turned;
        map
    }

    /// 1, or −1 where the component moves against its equation.
    fn sign(&self, node: usize, axis: usize) -> f64 {
        match axis == 2 && self.turned.get(node).is_some_and(|turned| *turned) {
            true => -1.0,
            false => 1.0,
        }
    }

    /// The [sign](Self::sign) of each of an element's 24 components.
    pub fn signs_of_element(&self, mesh: &Mesh, element: usize) -> [f64; 24] {
        let nodes = mesh.hexes[element];
        std::array::from_fn(|k| self.sign(nodes[k / 3] as usize, k % 3))
    }

    /// Vertex of each equation.
    pub fn vertices(&self) -> Vec<u32> {
        let mut vertex_of = vec![0; self.len()];
        for (vertex, range) in self.vertex_start.windows(2).enumerate() {
            vertex_of[range[0] as usize..range[1] as usize].fill(vertex as u32);
        }
        vertex_of
    }

    /// Equations of an element's 24 components.
    pub fn of_element(&self, mesh: &Mesh, element: usize) -> [u32; 24] {
        let nodes = mesh.hexes[element];
        std::array::from_fn(|k| self.equations[nodes[k / 3] as usize][k % 3])
    }

    /// Number of equations.
    pub fn len(&self) -> usize {
        self.vertex_start.last().map_or(0, |n| *n as usize)
    }

    /// No equation at all?
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Sums nodal vectors into a vector of equations; what acts on fixed components is dropped.
    pub fn gather(&self, nodal: &[[f64; 3]]) -> Vec<f64> {
        let mut out = vec![0.0; self.len()];
        for (node, (equations, values)) in self.equations.iter().zip(nodal).enumerate() {
            for (axis, (equation, value)) in equations.iter().zip(values).enumerate() {
                if *equation != FIXED {
                    out[*equation as usize] += self.sign(node, axis) * value;
                }
            }
        }
        out
    }

    /// Adds `factor` times the solution `x` to the nodal displacements.
    pub fn scatter_add(&self, x: &[f64], factor: f64, nodal: &mut [[f64; 3]]) {
        for (node, (equations, values)) in self.equations.iter().zip(nodal).enumerate() {
            for (axis, (equation, value)) in equations.iter().zip(values).enumerate() {
                if *equation != FIXED {
                    *value += factor * self.sign(node, axis) * x[*equation as usize];
                }
            }
        }
    }
}

/// What the half turn does to the components of the nodes of its cut.
struct Cut {
    /// Image of each node of the cut that has equations of its own; [`FIXED`] of all other nodes.
    image: Vec<u32>,
    /// Is the node such an image?
    turned: Vec<bool>,
    /// Components of the nodes of the cut that supports hold, on either side.
    held: Vec<[bool; 3]>,
}

impl Cut {
    fn new(scene: &Scene, owner: &[[Option<Owner>; 3]]) -> Self {
        let nodes = if scene.half_turn.is_empty() {
            0
        } else {
            owner.len()
        };
        let mut cut = Self {
            image: vec![FIXED; nodes],
            turned: vec![false; nodes],
            held: vec![[false; 3]; nodes],
        };
        for [node, image] in scene.half_turn.iter().map(|pair| pair.map(|n| n as usize)) {
            cut.image[node] = image as u32;
            cut.turned[image] = node != image;
            let [own, other] = [node, image].map(|n| owner[n].map(|o| o.is_some()));
            cut.held[node] = [own[0] || other[1], own[1] || other[0], own[2] || other[2]];
        }
        cut
    }

    fn on_axis(&self, node: usize) -> bool {
        self.image
            .get(node)
            .is_some_and(|image| *image as usize == node)
    }

    /// Has the component no equation of its own, as the half turn holds it or its image has one?
    fn decides(&self, node: usize, axis: usize) -> bool {
        match self.turned.get(node) {
            Some(true) => true,
            Some(false) => self.held[node][axis] || (self.on_axis(node) && axis > 0),
            None => false,
        }
    }
}

#[derive(Debug, Clone, Copy)]
enum Owner {
    Held(f64, Source),
    Driven(usize),
}

impl Owner {
    fn agrees(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Held(a, _), Self::Held(b, _)) => a == b,
            (Self::Driven(a), Self::Driven(b)) => a == b,
            _ => false,
        }
    }

    fn name<'a>(&self, scene: &'a Scene) -> &'a str {
        match *self {
            Self::Held(_, Source::Support(i)) => &scene.supports[i].surface,
            Self::Held(_, Source::Plane(i)) | Self::Driven(i) => &scene.rigid_planes[i].surface,
        }
    }
}
