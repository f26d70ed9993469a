//! The strips of a pair, and the sections of a body through its nodes below them.

use super::reading::BelowStrips;
use crate::answer::results::contact_line::ContactLine;
use crate::answer::results::edges::SingularEdges;
use crate::answer::results::hertz::{Departure, HeaviestLine};
use crate::answer::results::recovery::Recovered;
use crate::ground::geometry::{Vec3, norm, scale, sub, unit};
use crate::model::scene::Scene;

/// Distances from a strip, in its half-widths, between which the rest of the stress is taken from nodes: farther in, elements do
/// not follow the stress of the strip, farther out the rest changes.
pub(super) const RING: [f64; 2] = [2.0, 4.5];

/// Distance along a strip, in its half-widths, within which nodes are those of one section.
pub(super) const SAME_SECTION: f64 = 1e-3;

/// The strips of a pair.
pub(super) struct Strips<'l> {
    pub pair: usize,
    /// Does it carry up to an edge, or to a fillet that is not resolved?
    pub at_edge: bool,
    pub line: &'l HeaviestLine,
    /// Every strip, the heaviest first, with a place on it and the normal of its surfaces there.
    pub places: Vec<Strip<'l>>,
    pub half_width: f64,
    pub peak_pressure: f64,
}

pub(super) struct Strip<'l> {
    pub loads: &'l ContactLine,
    pub centre: Vec3,
    pub normal: Vec3,
}

impl<'l> Strips<'l> {
    /// Those of the pair with that index.
    pub fn of(
        scene: &Scene,
        pair: usize,
        line: &'l HeaviestLine,
        edges: &SingularEdges,
    ) -> Option<Self> {
        let hertz = line.strip()?;
        let [carrier, _] = scene.contacts.get(pair)?.carrier_first();
        let surface = carrier.surface(&scene.mesh)?;
        let nodes = surface.nodes();
        let frame = &line.frame;
        let own = std::iter::once(&line.line);
        let mut places = Vec::new();
        for loads in own.chain(&line.others) {
            let centre = loads.heaviest.centre;
            let from = |node: &u32| norm(sub(scene.mesh.points[*node as usize], centre));
            let nearest = nodes.iter().min_by(|a, b| from(a).total_cmp(&from(b)))?;
            let mut normal = frame.square(surface.area_vector_at(&scene.mesh, *nearest));
            let is_cut = loads.heaviest.mirrored;
            if is_cut {
                normal = sub(normal, scale(frame.across, frame.across(&normal)));
            }
            let normal = unit(normal)?;
            places.push(Strip {
                loads,
                centre,
                normal,
            });
            if line.is_mirrored && !is_cut {
                let image = |v: Vec3| sub(v, scale(frame.across, 2.0 * frame.across(&v)));
                places.push(Strip {
                    loads,
                    centre: image(centre),
                    normal: image(normal),
                });
            }
        }
        let is_loaded = line.departs == Some(Departure::LoadedEdge);
        Some(Self {
            pair,
            at_edge: is_loaded || edges.loaded.unseen_pressure(pair) > 0.0,
            line,
            places,
            half_width: hertz.half_width,
            peak_pressure: hertz.peak_pressure,
        })
    }

    /// Of all sections of the body through its nodes.
    pub fn largest(
        &self,
        (scene, edges): (&Scene, &SingularEdges),
        recovered: &Recovered,
        body: usize,
        (forces, turns): (&dyn Fn(f64) -> Vec3, [f64; 2]),
    ) -> Option<BelowStrips> {
        let own = self.places.first()?;
        let frame = &self.line.frame;
        let nu = scene.materials.get(body)?.poissons_ratio;
        let reach = RING[1] * self.half_width;
        let mut near: Vec<(f64, usize)> = Vec::new();
        for (point, node) in recovered.points.node.iter().enumerate() {
            let at = scene.mesh.points[*node as usize];
            if recovered.points.body_of(point) == Some(body)
                && norm(frame.square(sub(at, own.centre))) <= reach
            {
                near.push((frame.along(&at), point));
            }
        }
        near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let is_next =
            |a: &(f64, usize), b: &(f64, usize)| b.0 - a.0 < SAME_SECTION * self.half_width;
        let sections = near.chunk_by(is_next);
        let read = |section: &[(f64, usize)]| {
            let along = section.first()?.0;
            let at = frame.moved(own.centre, along);
            if edges.are_near(&at) {
                return None;
            }
            let points = section.iter().map(|(_, point)| {
                let node = recovered.points.node[*point] as usize;
                (scene.mesh.points[node], recovered.nodal_stress[*point])
            });
            let row = self.row_next_to(along)?;
            self.read(along, nu, &points.collect::<Vec<_>>(), (forces(row), turns))
        };
        let all = sections.filter_map(read);
        all.reduce(|a, b| if b.mises > a.mises { b } else { a })
    }

    /// The row of its line that is nearest to the section at `along`.
    fn row_next_to(&self, along: f64) -> Option<f64> {
        let rows = self.line.line.at.iter().copied();
        rows.min_by(|a, b| (a - along).abs().total_cmp(&(b - along).abs()))
    }
}
