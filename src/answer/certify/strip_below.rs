//! Long strips and the stress below them, as a half space has it.

use super::line;
use crate::analytic::subsurface::LineField;
use crate::answer::results::hertz::{Departure, HeaviestLine};
use crate::ground::geometry::{dot, norm, range, sub};
use crate::model::mesh::Mesh;
use crate::model::scene::{ContactPair, Scene, joined_to};

/// Facets in a half-width between which the nodal peak begins to be corrected by what extrapolation overshoots, and is wholly.
/// On coarser meshes the stress below a strip is as much too small as extrapolation makes it too large.
const CORRECTED: [f64; 2] = [3.0, 3.5];

/// Distance of nodes over the half-width of a strip above which the peak below is not read.
const COARSEST: f64 = 0.9;

/// By how much elements at the peak are larger than facets of the strip in the meshes that the shares of errors were found
/// on.
const GROWTH: f64 = 1.4;

/// A long strip on a body.
pub(super) struct StripBelow<'l> {
    pub body: usize,
    /// Largest Mises stress below its heaviest row, in a half space; `None` where a layer makes it another one.
    pub mises: Option<f64>,
    /// By the load of that row, or as found below a layer.
    pub half_width: f64,
    line: &'l HeaviestLine,
    mesh: &'l Mesh,
}

impl<'l> StripBelow<'l> {
    /// The strips on the bodies of `scene` below the heaviest lines of its pairs, on either side, and on what is joined to them.
    pub fn all(scene: &'l Scene, lines: &'l [Option<HeaviestLine>]) -> Vec<Self> {
        let of_pair = |(pair, line): (&ContactPair, &'l Option<HeaviestLine>)| {
            let line = line.as_ref()?;
            let (half_space, half_width) = match line.departs {
                // Of the elastic peak, flow or not.
                Some(Departure::Layered) if line.is_long() => (None, line.line.heaviest.half_width),
                _ => line.strip().map(|hertz| (Some(hertz), hertz.half_width))?,
            };
            let on = |body: usize| {
                let nu = scene.materials.get(body)?.poissons_ratio;
                let mises = match half_space {
                    Some(hertz) => Some(LineField::below(&hertz, nu).ok()?.peak_mises().value),
                    None => None,
                };
                Some(Self {
                    body,
                    mises,
                    half_width,
                    line,
                    mesh: &scene.mesh,
                })
            };
            let own = pair.bodies(&scene.mesh);
            // What is joined to a body goes on with it, where the strip is near.
            let goes_on = |strip: &Self| {
                let is_below = |node: &u32| strip.is_above(&scene.mesh.points[*node as usize]);
                let elements = scene.mesh.bodies[strip.body].elements.clone();
                own.contains(&Some(strip.body))
                    || scene.mesh.hexes[elements].iter().flatten().any(is_below)
            };
            let all = joined_to(scene, pair).into_iter().filter_map(on);
            // Where lines merge no strip makes the peak; that nodes are too far apart for is narrower still.
            let makes_it = |strip: &Self| line.departs != Some(Departure::Width) || !strip.shows();
            Some(all.filter(makes_it).filter(goes_on).collect::<Vec<_>>())
        };
        let pairs = scene.contacts.iter().zip(lines).filter_map(of_pair);
        pairs.flatten().collect()
    }

    /// Distance of the nodes in its middle.
    pub fn spacing(&self) -> f64 {
        self.line.line.heaviest.middle_spacing()
    }

    /// See [`line::spread_otherwise`].
    pub fn spread_otherwise(&self, travel_off: f64) -> f64 {
        line::spread_otherwise(self.line, travel_off)
    }

    /// Does the mesh show the peak below it?
    pub fn shows(&self) -> bool {
        self.spacing() <= COARSEST * self.half_width
    }

    /// How far the elements of its body about a node reach square to the line, the most of them: across it, or down.
    pub fn reach_at(&self, node: usize) -> f64 {
        let frame = &self.line.frame;
        let is_at_node = |element: &usize| self.mesh.hexes[*element].contains(&(node as u32));
        let elements = self.mesh.bodies[self.body].elements.clone();
        let reach = |element: usize| {
            let corners = self.mesh.corners(element);
            [frame.across, frame.up].map(|direction| {
                let [low, high] = range(corners.map(|corner| dot(direction, corner)));
                high - low
            })
        };
        let all = elements.filter(is_at_node).flat_map(reach);
        all.fold(0.0, f64::max)
    }

    /// Does it where elements reach that far? Below a layer they may be larger than those that press.
    pub fn shows_at(&self, reach: f64) -> bool {
        match self.mises {
            Some(_) => self.shows(),
            None => self.widest(reach) <= COARSEST * self.half_width,
        }
    }

    /// The larger of that, the one at its edge and what the elements around the peak below reach, where they
    /// grow more with depth than [`GROWTH`].
    pub fn widest(&self, reach: f64) -> f64 {
        let spacing = self.line.line.heaviest.spacing();
        spacing.max(reach / GROWTH)
    }

    /// Pressure, stress and width of the strip where it passes over that, over those of its heaviest row: roots of the loads
    /// per length.
    pub fn share(&self, at: &[f64; 3]) -> f64 {
        let load = self.line.line.load_at(self.line.frame.along(at));
        load.map_or(1.0, |load| (load / self.line.line_load).max(0.0).sqrt())
    }

    /// Is the nodal peak below the strip corrected, where its load is that share of the largest? One where it is wholly.
    pub fn resolves(&self, share: f64, reach: f64) -> f64 {
        let [from, to] = CORRECTED;
        let facets = share * self.half_width / self.widest(reach);
        ((facets - from) / (to - from)).clamp(0.0, 1.0)
    }

    /// Is that in its middle, on the surface?
    pub fn is_at(&self, at: &[f64; 3]) -> bool {
        const NEAR: f64 = 0.3;
        let off = self
            .line
            .frame
            .square(sub(*at, self.line.line.heaviest.centre));
        norm(off) <= NEAR * self.half_width
    }

    /// Is that below the strip?
    pub fn is_above(&self, at: &[f64; 3]) -> bool {
        let centre = self.line.line.heaviest.centre;
        let frame = &self.line.frame;
        norm(frame.square(sub(*at, centre))) <= 3.0 * self.half_width.max(self.spacing())
    }
}
