//! The bearing template made into a general model.

use super::bearing_case::{BearingCase, LOADED_PLANE};
use super::layout::RollerPlace;
use super::preset::Preset;
use super::seat::Seat;
use crate::case::axes::modelled_share;
use crate::case::contact::Contact;
use crate::case::interfaces::{BOTTOM, SYMMETRIES, TOP};
use crate::case::load::Loads;
use crate::case::model::MeshlessScene;
use crate::case::place::{KeyPlace, Located};
use crate::case::source::Source;
use crate::model::scene::{
    Controls, Partner, PlaneTurn, RigidPlane, Side, Step, Support, Temperature,
};

impl BearingCase {
    /// The model: four contact pairs, the top face a rigid plane
    /// that moves along z under the load, and otherwise as `top` and `horizontal` say, the bottom face fixed.
    pub(in crate::case) fn model(
        &self,
        name: &str,
        source: &Source,
        controls: Controls,
    ) -> MeshlessScene {
        let place = KeyPlace {
            source: source.clone(),
            key: self.layout().table().to_string(),
            span: 0..0,
        };
        MeshlessScene {
            name: name.to_string(),
            steels: self.steels.clone(),
            contacts: self.contacts(&place),
            ties: Vec::new(),
            loads: self.loads(&place),
            mirrors: self.mirrors(),
            controls: Controls {
                half_turn: controls.half_turn && !self.mesh.full,
                ..controls
            },
        }
    }

    fn contacts(&self, place: &KeyPlace) -> Vec<Contact> {
        let located = |value| Located {
            value,
            place: place.clone(),
        };
        let pair = |seat: Seat| Contact {
            name: Located {
                value: seat.interface,
                place: place.clone(),
            },
            upper: located(Partner::Surface(seat.upper)),
            lower: located(Partner::Surface(seat.lower)),
            carrier: None,
            // Both halves of the stack alike.
            preferred: if seat.roller_above {
                Side::Upper
            } else {
                Side::Lower
            },
            friction: self.friction,
            friction_is_default: false,
            penalty_factor: 1.0,
            // The coarse comparison mesh is a polygon in the gap too.
            true_geometry: self.mesh.preset != Preset::ReportLike,
        };
        self.seats().into_iter().map(pair).collect()
    }

    fn loads(&self, place: &KeyPlace) -> Loads {
        let support = |name: &str, surface: &str, components| Located {
            value: Support {
                name: name.to_string(),
                surface: surface.to_string(),
                components,
                ..Support::default()
            },
            place: place.clone(),
        };
        let mut supports = vec![support("bottom", BOTTOM, [Some(0.0); 3])];
        for axis in self.mirrors() {
            let mut components = [None; 3];
            components[axis] = Some(0.0);
            supports.push(support(SYMMETRIES[axis], SYMMETRIES[axis], components));
        }
        let mirrors = self.mirrors();
        let vertical = self.load * modelled_share(&mirrors);
        let pivot = self.layout().pivot();
        let [_, top] = self.layout().height_range();
        let (motion, turn) = self.loads.plane(vertical, top - pivot[2]);
        // Across a symmetry plane a turn about its normal is its own image, and no other is.
        let mut turn = turn;
        for (axis, turn) in turn.iter_mut().enumerate() {
            if mirrors.iter().any(|mirror| *mirror != axis) {
                *turn = PlaneTurn::default();
            }
        }
        let plane = RigidPlane {
            name: LOADED_PLANE.to_string(),
            surface: TOP.to_string(),
            motion,
            turn,
            about: (turn != <[PlaneTurn; 3]>::default()).then_some(pivot),
        };
        let stage = |(share, count): (&f64, i32)| Step::to(format!("stage {count}"), *share);
        let mut steps: Vec<Step> = self.stages.iter().zip(1..).map(stage).collect();
        steps.push(Step::to("load", 1.0));
        steps.extend(self.unload_to.map(|share| Step::to("unload", share)));
        let planes = vec![Located {
            value: plane,
            place: place.clone(),
        }];
        Loads {
            supports,
            planes,
            tractions: Vec::new(),
            temperatures: self.modelled_temperatures(),
            steps,
        }
    }

    /// Those of bodies that are modelled: images have what stands for them.
    fn modelled_temperatures(&self) -> Vec<Located<Temperature>> {
        let modelled = self.layout().rollers(self.mesh.full);
        let is = |rollers: &[RollerPlace], body: &str| rollers.iter().any(|r| r.body == body);
        let rollers = self.layout().rollers(true);
        let temperatures = self.temperatures.iter().filter(|temperature| {
            let body = &temperature.value.body;
            is(&modelled, body) || !is(&rollers, body)
        });
        temperatures.cloned().collect()
    }
}
