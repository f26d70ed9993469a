//! States of the half, unfolded into states of the whole, and back.

use super::folded::HalfTurn;
use super::turn::{turned, turned_point, turned_stress};
use crate::ground::geometry::{Vec3, add, scale};
use crate::model::state::{ContactField, PlaneField, State};

impl HalfTurn {
    /// The state of the whole that `half`, a state of the half, is one half of. The bottom stands.
    pub fn unfold(&self, half: &State) -> State {
        let travel = half.planes.first().map_or(0.0, |plane| plane.travel[2]);
        State {
            step: half.step,
            time: half.time,
            displacement: self.unfold_displacement(&half.displacement, travel),
            stress: self.by_element(&half.stress, turned_stress),
            peeq: self.by_element(&half.peeq, |p| p),
            ties: Vec::new(),
            contacts: self.contacts(&half.contacts),
            planes: half.planes.iter().map(of_the_whole).collect(),
            energy: half.energy.map(|energy| energy.times(2.0)),
        }
    }

    /// Displacements of the whole from those of the half, whose top moves by `travel` along z.
    pub fn unfold_displacement(&self, half: &[Vec3], travel: f64) -> Vec<Vec3> {
        let of = |(own, image): &(u32, bool)| {
            let own = half[*own as usize];
            let seen = if *image { turned(own) } else { own };
            add(seen, [0.0, 0.0, travel])
        };
        self.nodes.iter().map(of).collect()
    }

    /// Displacements that stay in the whole from those of the half, whose top has moved.
    pub fn unfold_stays(&self, half: &[Vec3]) -> Vec<Vec3> {
        let top = self.half.rigid_planes.first().map(|plane| &plane.surface);
        let node = top.and_then(|top| self.half.mesh.surface(top)?.faces.first());
        let travel = node.map_or(0.0, |face| half[face.nodes[0] as usize][2]);
        self.unfold_displacement(half, travel)
    }

    /// Displacements, stresses and plastic strains of the half in a state of the whole. The half is displaced as in the
    /// whole: seen from the bottom.
    pub fn fold(&self, whole: &State) -> State {
        let elements = self.whole_elements.iter();
        State {
            step: whole.step,
            time: whole.time,
            displacement: (self.whole_nodes.iter())
                .map(|n| whole.displacement[*n as usize])
                .collect(),
            stress: (elements.clone())
                .filter_map(|e| whole.stress.get(*e as usize).copied())
                .collect(),
            peeq: elements
                .filter_map(|e| whole.peeq.get(*e as usize).copied())
                .collect(),
            ..State::default()
        }
    }

    /// Values at the integration points, which stand in the order of the corners; nothing where there are none.
    fn by_element<T: Copy>(&self, half: &[[T; 8]], turn: impl Fn(T) -> T) -> Vec<[T; 8]> {
        if half.is_empty() {
            return Vec::new();
        }
        let of = |(own, corners): &(u32, Option<[u8; 8]>)| {
            let values = &half[*own as usize];
            corners.map_or(*values, |corners| {
                corners.map(|corner| turn(values[usize::from(corner)]))
            })
        };
        self.elements.iter().map(of).collect()
    }

    fn contacts(&self, half: &[ContactField]) -> Vec<ContactField> {
        let pairs = self.pairs.iter().zip(&self.carriers);
        let fields = pairs.map(|((own, image), nodes)| self.contact(&half[*own], nodes, *image));
        fields.collect()
    }

    /// The field of a pair of the whole on its carrier's `nodes`, from that of the half.
    fn contact(&self, half: &ContactField, nodes: &[u32], image: bool) -> ContactField {
        let mut field = ContactField::open(nodes.to_vec());
        // What acts on the lower body acts, turned, on the upper one.
        let on_lower = |force: Vec3| match image {
            true => scale(turned(force), -1.0),
            false => force,
        };
        let place = |at: Vec3| match image {
            true => turned_point(at, self.middle),
            false => at,
        };
        for (at, node) in nodes.iter().enumerate() {
            let own = self.nodes[*node as usize].0;
            let Ok(from) = half.nodes.binary_search(&own) else {
                continue;
            };
            field.pressure[at] = half.pressure[from];
            field.multiplier[at] = half.multiplier[from];
            field.gap[at] = half.gap[from];
            field.traction[at] = on_lower(half.traction[from]);
            field.slip[at] = half.slip[from];
            field.status[at] = half.status[from];
            field.area[at] = half.area[from];
            field.force[at] = on_lower(half.force[from]);
            field.acts_at[at] = half.acts_at[from].map(place);
            field.sagitta[at] = half.sagitta[from];
        }
        field.penetration = half.penetration;
        field.at_rim = half.at_rim;
        field.unexplained = half.unexplained;
        field.unexplained_at = half.unexplained_at.map(place);
        field
    }
}

/// The top moves twice as far in the whole, under the same force.
fn of_the_whole(half: &PlaneField) -> PlaneField {
    let [x, y, z] = half.travel;
    PlaneField {
        travel: [x, y, 2.0 * z],
        ..*half
    }
}
