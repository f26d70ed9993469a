//! How many elements the template will make, counted before gmsh is called: a slip in a size would keep it busy
//! for hours and fill the memory.

use std::f64::consts::PI;

use super::end_zone::EndZone;
use super::geometry::BearingGeometry;
use super::grading::{GradedInterval, Stop};
use super::sizes::Sizes;

/// Elements of the mesh of `geometry`, all of it or the quarter of a centred bearing: of a hollow roller to the
/// element, of a solid one to a few per cent.
pub fn elements(geometry: &BearingGeometry, sizes: &Sizes, whole: bool) -> f64 {
    let count = Count {
        geometry,
        sizes,
        whole,
    };
    let [x, y] = geometry.plan;
    2.0 * count.roller()
        + count.flat_plate(geometry.upper_thickness, [x, y])
        + count.flat_plate(geometry.lower_thickness, [y, x])
        + count.intermediate_plate()
}

struct Count<'a> {
    geometry: &'a BearingGeometry,
    sizes: &'a Sizes,
    whole: bool,
}

impl Count<'_> {
    fn grading(&self, growth: f64, cap: f64, least: f64) -> GradedInterval {
        let uniform = self.sizes.uniform;
        GradedInterval {
            growth,
            cap,
            least,
            uniform,
        }
    }

    /// On a line that is the same on both sides of its middle stop: half of it on a quarter.
    fn halved(&self, grading: &GradedInterval, stops: &[Stop]) -> f64 {
        let first = if self.whole { 0 } else { stops.len() / 2 };
        grading.elements(&stops[first..])
    }

    fn roller(&self) -> f64 {
        let (geometry, sizes) = (self.geometry, self.sizes);
        let radius = geometry.radius();
        let centred = geometry.offset == 0.0;
        let fine = |at| (at, Some(sizes.roller_size), sizes.fine_elements);
        let any = |at| (at, None, sizes.fine_elements);
        let (turn, contact) = (PI * radius, geometry.slope * radius);
        let stops = match (sizes.uniform, centred) {
            (true, _) => vec![any(-turn), any(0.0), any(turn)],
            (_, false) => vec![fine(-turn), fine(contact), fine(turn)],
            (_, true) => {
                let bottom = [fine(-contact), any(0.0), fine(contact)];
                [vec![fine(-turn)], bottom.to_vec(), vec![fine(turn)]].concat()
            }
        };
        let grading = self.grading(sizes.growth, sizes.around_cap, 1.0);
        let around = self.halved(&grading, &stops);

        let inner = geometry
            .roller
            .wall
            .map_or(0.5 * radius, |wall| radius - wall);
        let surface = (radius, Some(sizes.roller_size), sizes.fine_layers);
        let wall = self.grading(sizes.depth_growth, sizes.wall_cap, sizes.wall_least);
        let through = wall.elements(&[(inner, None, 1.0), surface]);

        let least = if centred { sizes.along_least } else { 1.0 };
        let grading = self.grading(sizes.along_growth, sizes.along_cap, least);
        let half = 0.5 * geometry.roller.length;
        let along = match *geometry.plate_edges() {
            [edge] => self.along_roller(&grading, edge, &[(half, None)]),
            [edge, far] => {
                let beyond = [(far, Some(sizes.end_size)), (half, None)];
                self.along_roller(&grading, edge, &beyond)
            }
            _ => self.along_roller(&grading, half, &[]),
        };

        // Each side of the core of a solid roller has a quarter of the elements of a turn.
        let core = match (geometry.roller.wall, self.whole) {
            (Some(_), _) => 0.0,
            (None, true) => around * around / 16.0,
            (None, false) => around * around / 8.0,
        };
        (around * through + core) * along
    }

    /// From where the rollers cross to both ends of what is pressed, and on to places `beyond` them, with the element sizes wanted there.
    fn along_roller(
        &self,
        inside: &GradedInterval,
        half: f64,
        beyond: &[(f64, Option<f64>)],
    ) -> f64 {
        let (geometry, sizes) = (self.geometry, self.sizes);
        let crossing = if sizes.uniform { 0.0 } else { geometry.offset };
        let crossing = (crossing, Some(sizes.crossing_size), 1.0);
        let zone = self.end_zone(half);
        let outside = GradedInterval {
            least: 1.0,
            ..*inside
        };
        let towards = |side: &f64| {
            let mut stops = zone.stops(sizes.end_size, side * half);
            stops.extend(beyond.iter().map(|(edge, size)| (side * edge, *size, 1.0)));
            inside.elements(&[crossing, stops[0]]) + outside.elements(&stops)
        };
        let sides: &[f64] = if self.whole { &[-1.0, 1.0] } else { &[1.0] };
        sides.iter().map(towards).sum()
    }

    /// Of a roller or plate that ends so far from the middle: a plate that is shorter than the roller has a sharp edge.
    fn end_zone(&self, half: f64) -> EndZone {
        let zone = self.geometry.end_zone(self.sizes.uniform);
        match half < 0.5 * self.geometry.roller.length * (1.0 - 1e-9) {
            true => zone.sharp(),
            false => zone,
        }
    }

    /// The plate above or below both rollers, across and along its own.
    fn flat_plate(&self, thickness: f64, [across, along]: [f64; 2]) -> f64 {
        let (geometry, sizes) = (self.geometry, self.sizes);
        let (centre, any) = (2.0 * geometry.offset, None);
        let line = if sizes.uniform {
            (centre, any, 1.0)
        } else {
            (geometry.offset, Some(sizes.plate_size), sizes.fine_elements)
        };
        let edge = |at| (at, any, sizes.fine_elements);
        let stops = [
            edge(centre - 0.5 * across),
            line,
            edge(centre + 0.5 * across),
        ];
        let grading = self.grading(sizes.growth, sizes.plan_cap, 1.0);
        let across = self.halved(&grading, &stops);

        let outside = along > geometry.roller.length * (1.0 + 1e-9) && !sizes.uniform;
        let far = if outside {
            geometry.roller.length
        } else {
            along
        };
        let cap = if sizes.uniform {
            sizes.plan_cap
        } else {
            sizes.along_cap
        };
        let grading = self.grading(sizes.along_growth, cap, 1.0);
        let edge = [(0.5 * along, None)];
        let beyond = if outside { &edge[..] } else { &[] };
        let along = self.along_roller(&grading, 0.5 * far, beyond);

        let face = (0.0, Some(sizes.plate_size), sizes.fine_layers);
        let depth = self.grading(sizes.depth_growth, sizes.depth_cap, sizes.depth_least);
        across * along * depth.elements(&[face, (thickness, any, 1.0)])
    }

    fn intermediate_plate(&self) -> f64 {
        let (geometry, sizes) = (self.geometry, self.sizes);
        let thickness = geometry.intermediate_thickness;
        let face = |at| (at, Some(sizes.plate_size), sizes.fine_layers);
        let least = match sizes.uniform {
            true => sizes.depth_least,
            false => (sizes.depth_least / 2.0).ceil(),
        };
        let depth = self.grading(sizes.depth_growth, sizes.depth_cap, least);
        let through = match sizes.uniform {
            true => vec![face(0.0), face(thickness)],
            false => vec![face(0.0), (0.5 * thickness, None, 1.0), face(thickness)],
        };
        let grading = self.grading(sizes.growth, sizes.middle_cap, 1.0);
        let in_plan = |plan: f64| self.halved(&grading, &self.across_plate(0.5 * plan));
        let [x, y] = geometry.plan.map(in_plan);
        x * y * depth.elements(&through)
    }

    /// From edge to edge of the intermediate plate, over the V line (of a centred bearing, either of them).
    fn across_plate(&self, half: f64) -> Vec<Stop> {
        let (geometry, sizes) = (self.geometry, self.sizes);
        let v_line = geometry.v_line();
        let any = |at| (at, None, 1.0);
        let fine = |at| (at, Some(sizes.plate_size), sizes.fine_elements);
        match (sizes.uniform, geometry.offset == 0.0) {
            (true, _) => vec![any(-half), any(0.0), any(half)],
            (_, true) => vec![any(-half), fine(-v_line), any(0.0), fine(v_line), any(half)],
            (_, false) => {
                let end = 0.5 * geometry.roller.length;
                let outside = half > end * (1.0 + 1e-9) && end > v_line * (1.0 + 1e-9);
                let last = if outside { end } else { half };
                let mut stops = vec![any(-half), any(0.0), fine(v_line)];
                stops.extend(self.end_zone(last).stops(sizes.end_size, last));
                stops.extend(outside.then(|| any(half)));
                stops
            }
        }
    }
}
