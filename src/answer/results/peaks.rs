//! Per body: the three Mises peaks and where they are, plastic strain and yielded volume.

use super::around::{Around, around};
use super::below_strips::{BelowStrips, below_strips};
use super::edges::{ByEdge, SingularEdges};
use super::hertz::HeaviestLine;
use super::hex::{GaussRule, centre};
use super::load::{cutting, times};
use super::recovery::{Recovered, recover};
use super::tensor::mises;
use crate::ground::geometry::Vec3;
use crate::model::mesh::Body;
use crate::model::scene::Scene;
use crate::model::state::State;

/// What a peak was read from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// The centre of an element.
    Element(usize),
    /// An integration point of an element.
    IntegrationPoint {
        /// Index of the element.
        element: usize,
        /// Index of the point in it.
        point: usize,
    },
    /// A node of the mesh.
    Node(usize),
}

/// A largest value and where it is. Of equal values the one with the lowest index counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// The value, in the stress unit of the scene.
    pub value: f64,
    /// What it was read from.
    pub place: Place,
    /// Undeformed coordinates of the place.
    pub at: [f64; 3],
}

/// Two readings of a largest Mises stress, and what is around it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MisesPeaks {
    /// Mises stress of the nodal average.
    pub nodal: Peak,
    /// Mises stress of the mean stress tensor of an element.
    pub centroid: Peak,
    /// Around the node.
    pub around: Around,
    /// Does a singular edge cease to reach just at the node?
    pub is_on_border: bool,
}

/// The peaks of one body; `None` for a body without elements.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyPeaks {
    /// Name of the body.
    pub name: String,
    /// Mises stress of the mean stress tensor of an element.
    pub centroid: Option<Peak>,
    /// Mises stress at an integration point.
    pub integration_point: Option<Peak>,
    /// Mises stress of the nodal average.
    pub nodal: Option<Peak>,
    /// Around the node of that.
    pub around: Around,
    /// Where the nodal peak lies beside a singular edge, or a finer mesh may show a larger one there: the peaks of what
    /// does not.
    pub away: Option<(ByEdge, MisesPeaks)>,
    /// The peak below its strips, as half spaces have it.
    pub below_strips: Option<BelowStrips>,
    /// Largest equivalent plastic strain at an integration point.
    pub peeq_max: f64,
    /// Mean of the equivalent plastic strain in the element that holds the largest.
    pub peeq_mean: f64,
    /// Volume of the integration points that have yielded, in the whole body.
    pub yielded_volume: f64,
    /// Volume of the whole body.
    pub volume: f64,
}

/// The peaks of every body in `state`, where its fields are not at hand.
pub fn peaks_in(scene: &Scene, state: &State) -> Vec<BodyPeaks> {
    let edges = SingularEdges::find(scene, state);
    let lines = HeaviestLine::of_pairs(scene, state, &edges.loaded);
    peaks((scene, state), &recover(scene, state), &edges, &lines)
}

/// The index of the largest value; of equal values the first. Passes over what is not a number.
fn first_largest(values: impl Iterator<Item = (usize, f64)>) -> Option<(usize, f64)> {
    let mut best: Option<(usize, f64)> = None;
    for (index, value) in values {
        if !value.is_nan() && best.is_none_or(|(_, largest)| value > largest) {
            best = Some((index, value));
        }
    }
    best
}

/// Finds the peaks of every body, in the order of the mesh; `lines` are the heaviest ones of the pairs.
pub fn peaks(
    (scene, state): (&Scene, &State),
    recovered: &Recovered,
    edges: &SingularEdges,
    lines: &[Option<HeaviestLine>],
) -> Vec<BodyPeaks> {
    let below = below_strips((scene, state), recovered, lines, edges);
    let mesh = &scene.mesh;
    let rule = GaussRule::new();
    let nodal = nodal_peaks(scene, recovered, |_| true);
    let far = |at: &[f64; 3]| !edges.are_near(at);
    // Few scenes have a peak at an edge, and then it is worth a second look.
    let by_edge = |(body, peak): (usize, &Option<Peak>)| {
        let peak = peak.as_ref()?;
        edges.decide(scene, body, (peak.value, &peak.at))
    };
    let by_edge: Vec<Option<ByEdge>> = nodal.iter().enumerate().map(by_edge).collect();
    let away = if by_edge.iter().any(Option::is_some) {
        nodal_peaks(scene, recovered, far)
    } else {
        vec![None; nodal.len()]
    };
    let centroid_peak = |body: &Body, counts: &dyn Fn(&[f64; 3]) -> bool| {
        let mut best: Option<Peak> = None;
        for element in body.elements.clone() {
            let value = recovered.mises_mean[element];
            if value.is_nan() || best.is_some_and(|peak| value <= peak.value) {
                continue;
            }
            let at = centre(&mesh.corners(element));
            if counts(&at) {
                let place = Place::Element(element);
                best = Some(Peak { value, place, at });
            }
        }
        best
    };
    let body_peaks = |(index, body): (usize, &Body)| {
        let nodal = nodal[index];
        let around = |peak: &Peak, is_away: bool| match peak.place {
            Place::Node(node) => {
                let peak = (node, peak.value);
                let is_beside = |at: &Vec3| is_away && edges.are_near(at);
                let is_coarse = |at: &Vec3| is_away && edges.are_coarsely_near(at);
                let edges = (is_beside, is_coarse);
                around((scene, body), state, recovered, &rule, peak, edges)
            }
            _ => Around::default(),
        };
        let elements = body.elements.clone();
        let over = |field: &[f64]| first_largest(elements.clone().map(|e| (e, field[e])));
        let centroid = centroid_peak(body, &|_| true);
        let away = away[index].zip(by_edge[index]).and_then(|(nodal, by)| {
            let away = MisesPeaks {
                nodal,
                centroid: centroid_peak(body, &far)?,
                around: around(&nodal, true),
                is_on_border: edges.end_at(&nodal.at),
            };
            Some((by, away))
        });
        let integration_point = over(&recovered.mises_max).and_then(|(element, _)| {
            let values = state.stress[element].iter().map(mises).enumerate();
            let (point, value) = first_largest(values)?;
            let at = rule.position(point, &mesh.corners(element));
            Some(Peak {
                value,
                place: Place::IntegrationPoint { element, point },
                at,
            })
        });
        let peeq = over(&recovered.peeq);
        let (mut yielded, mut volume) = (0.0, 0.0);
        for e in elements.clone() {
            for (peeq, v) in state.peeq_of(e).iter().zip(recovered.volumes[e]) {
                volume += v;
                if *peeq > 0.0 {
                    yielded += v;
                }
            }
        }
        let copies = times(&cutting(scene, index));
        BodyPeaks {
            name: body.name.clone(),
            centroid,
            integration_point,
            nodal,
            around: (nodal.as_ref())
                .map(|peak| around(peak, false))
                .unwrap_or_default(),
            away,
            below_strips: below[index],
            peeq_max: peeq.map_or(0.0, |(_, largest)| largest),
            peeq_mean: peeq.map_or(0.0, |(e, _)| state.peeq_of(e).iter().sum::<f64>() / 8.0),
            yielded_volume: copies * yielded,
            volume: copies * volume,
        }
    };
    mesh.bodies.iter().enumerate().map(body_peaks).collect()
}

/// The nodal peak of every body, of the nodes that count.
fn nodal_peaks(
    scene: &Scene,
    recovered: &Recovered,
    counts: impl Fn(&[f64; 3]) -> bool,
) -> Vec<Option<Peak>> {
    let mut best: Vec<Option<Peak>> = vec![None; scene.mesh.bodies.len()];
    for (point, &value) in recovered.mises_nodal.iter().enumerate() {
        let Some(body) = recovered.points.body_of(point) else {
            continue;
        };
        if !value.is_nan() && best[body].is_none_or(|peak| value > peak.value) {
            let node = recovered.points.node[point] as usize;
            let at = scene.mesh.points[node];
            if counts(&at) {
                best[body] = Some(Peak {
                    value,
                    place: Place::Node(node),
                    at,
                });
            }
        }
    }
    best
}

impl Peak {
    /// The element the peak was read from; `None` for a nodal peak.
    pub fn element(&self) -> Option<usize> {
        match self.place {
            Place::Element(element) | Place::IntegrationPoint { element, .. } => Some(element),
            Place::Node(_) => None,
        }
    }
}
