//! Numbering the equations of a scene.

use super::cut::Cut;
use super::fixed::FIXED;
use super::further::Further;
use super::map::DofMap;
use super::owner::Owner;
use super::prescribed::{Prescribed, Source};
use crate::ground::geometry::{Vec3, norm, sub};
use crate::model::scene::{PlaneMotion, RigidPlane, Scene};
use crate::solver::fem::tied::{Tied, component};
use std::sync::Arc;

impl DofMap {
    /// Numbers the equations of `scene`, whose components have these owners, or follow others as `tied` says.
    pub fn new(scene: &Scene, owner: &[[Option<Owner>; 3]], tied: Arc<Tied>) -> Self {
        let planes = scene.rigid_planes.len();
        let mut map = Self {
            equations: vec![[FIXED; 3]; owner.len()],
            vertex_start: vec![0],
            planes: vec![[None; 3]; planes],
            turns: vec![[None; 3]; planes],
            turn_length: vec![0.0; planes],
            further: Vec::new(),
            prescribed: Vec::new(),
            turned: Vec::new(),
            tied,
        };
        let cut = Cut::new(scene, owner);
        let mut next = 0u32;
        for (node, axes) in owner.iter().enumerate() {
            let before = next;
            for (axis, owner) in axes.iter().enumerate() {
                match *owner {
                    None if cut.decides(node, axis) => {}
                    None if map.tied.row(component(node as u32, axis)).is_some() => {}
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
                    Some(Owner::Plane(_)) => {}
                }
            }
            if cut.on_axis(node) {
                map.equations[node][1] = map.equations[node][0];
            }
            if next > before {
                map.vertex_start.push(next);
            }
        }
        let place = Placed::of(scene);
        for (node, axes) in owner.iter().enumerate() {
            for (axis, owner) in axes.iter().enumerate() {
                if let Some(Owner::Plane(plane)) = *owner {
                    map.follow(scene, (node, axis), (plane, &place[plane]));
                }
            }
        }
        map.turn_length = place.iter().map(|place| place.length).collect();
        for [node, image] in scene.half_turn.iter().filter(|[a, b]| a != b) {
            let [x, y, z] = map.equations[*node as usize];
            map.equations[*image as usize] = [y, x, z];
        }
        map.turned = cut.turned;
        map.add_tied();
        map
    }

    /// The component `axis` of `node` follows a plane that is driven along it, or free to turn.
    fn follow(
        &mut self,
        scene: &Scene,
        (node, axis): (usize, usize),
        (index, place): (usize, &Placed),
    ) {
        let plane = &scene.rigid_planes[index];
        let arm = sub(scene.mesh.points[node], place.about);
        let mut given = plane.given_turn(axis, arm);
        match plane.motion[axis] {
            PlaneMotion::Held(value) => given += value,
            _ => {
                let equation = self.planes[index][axis].unwrap_or_else(|| self.own_vertex());
                self.planes[index][axis] = Some(equation);
                self.equations[node][axis] = equation;
            }
        }
        if given != 0.0 {
            self.prescribed.push(Prescribed {
                node: node as u32,
                axis,
                value: given,
                source: Source::Plane(index),
            });
        }
        for (about, lever) in plane.free_turns(axis, arm) {
            let equation = self.turns[index][about].unwrap_or_else(|| self.own_vertex());
            self.turns[index][about] = Some(equation);
            self.further.push(Further {
                node: node as u32,
                axis,
                equation,
                lever: lever / place.length,
            });
        }
    }

    /// What follows by a tie hangs on the equations of what it follows.
    fn add_tied(&mut self) {
        let mut shares = Vec::new();
        for (component, row) in self.tied.rows() {
            for (other, factor) in row {
                let (other, along) = (other / 3, (other % 3) as usize);
                let of_other = self.terms(other).filter(|(_, axis, _)| *axis == along);
                shares.extend(of_other.map(|(equation, _, share)| Further {
                    node: component / 3,
                    axis: (component % 3) as usize,
                    equation,
                    lever: factor * share,
                }));
            }
        }
        if !shares.is_empty() {
            self.further.extend(shares);
            self.further.sort_by_key(|further| further.node);
        }
    }

    /// A new equation, which is a vertex by itself.
    fn own_vertex(&mut self) -> u32 {
        let equation = self.len() as u32;
        self.vertex_start.push(equation + 1);
        equation
    }
}

/// Where a rigid plane is.
struct Placed {
    about: Vec3,
    /// Half the distance of its furthest node, or one.
    length: f64,
}

impl Placed {
    /// All planes of a scene.
    fn of(scene: &Scene) -> Vec<Self> {
        let of = |plane: &RigidPlane| {
            let about = plane.point(&scene.mesh, &scene.mirrors);
            let nodes = scene.mesh.nodes_of_surface(&plane.surface).into_iter();
            let away = nodes.map(|n| norm(sub(scene.mesh.points[n as usize], about)));
            let furthest = away.fold(0.0, f64::max);
            let length = if furthest > 0.0 { 0.5 * furthest } else { 1.0 };
            Self { about, length }
        };
        scene.rigid_planes.iter().map(of).collect()
    }
}
