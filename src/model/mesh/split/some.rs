//! Local refinement: some hexahedra split, each in its own directions, beside others that stay whole.
//!
//! Elements beside each other differ by one split at most: where a marked element has a node that hangs on another one, that
//! is split first. And a marked element is split along every direction in which one of its edges has a node already, or gets
//! one. So a face is either split alike from both sides, or whole on one of them, and what hangs on it follows its corners.

use super::nodes::{Directions, Nodes, child};
use super::{MOST_HEXAHEDRA, SplitError};
use crate::model::mesh::hexahedron::{CORNERS, EDGES, FACES, side_of};
use crate::model::mesh::surface::sorted;
use crate::model::mesh::{Body, Face, Hanging, Mesh, Surface};
use std::collections::{BTreeMap, HashSet};

/// A mesh of which some elements are split.
#[derive(Debug, Clone, PartialEq)]
pub struct Refined {
    /// The mesh, with its hanging nodes,
    pub mesh: Mesh,
    /// and of each element of it the one that it is, or is a piece of.
    pub of: Vec<u32>,
}

impl Mesh {
    /// The hexahedra split along the directions that are `marked`, two, four or eight pieces of each, new nodes as in
    /// [`split`](Mesh::split); beside them some more, so that elements beside each other differ by one split. What lies on an
    /// edge or face of an element that stays whole hangs in its middle, on round surfaces, too: there the sides of both
    /// meet. A mesh with hanging nodes may be split again.
    ///
    /// # Errors
    /// [`SplitError`] for a mesh that becomes too large or folded.
    pub fn split_some(&self, marked: impl Fn(usize) -> Directions) -> Result<Refined, SplitError> {
        let marks = (0..self.hexes.len()).map(marked).collect();
        Ok(self.split_marked(marks)?.0)
    }

    /// Also along which directions each piece has been split.
    fn split_marked(
        &self,
        mut marks: Vec<Directions>,
    ) -> Result<(Refined, Vec<Directions>), SplitError> {
        let mut result = Refined {
            mesh: self.clone(),
            of: (0..self.hexes.len() as u32).collect(),
        };
        let mut split = vec![[false; 3]; marks.len()];
        loop {
            complete(&result.mesh, &mut marks);
            let first = coarser(&result.mesh, &marks);
            let is_last = first.iter().all(|mark| *mark == [false; 3]);
            let (done, along) = match is_last {
                true => {
                    let done = result.mesh.step(&marks)?;
                    let along = done.of.iter().map(|e| marks[*e as usize]).collect();
                    (done, along)
                }
                false => result.mesh.split_marked(first)?,
            };
            let pieces = || (done.of.iter().map(|e| *e as usize)).zip(&along);
            let left = pieces().map(|(e, along)| [0, 1, 2].map(|k| marks[e][k] && !along[k]));
            let all = pieces().map(|(e, along)| [0, 1, 2].map(|k| split[e][k] || along[k]));
            (marks, split) = (left.collect(), all.collect());
            result = Refined {
                of: done.of.iter().map(|e| result.of[*e as usize]).collect(),
                mesh: done.mesh,
            };
            if is_last {
                return Ok((result, split));
            }
        }
    }

    /// One split of marked elements, which have no hanging nodes themselves.
    fn step(&self, marks: &[Directions]) -> Result<Refined, SplitError> {
        let pieces = |mark: &Directions| 1usize << mark.iter().filter(|m| **m).count();
        let result = marks.iter().map(pieces).sum();
        if result > MOST_HEXAHEDRA {
            return Err(SplitError::TooLarge {
                mesh: self.source.clone(),
                elements: self.hexes.len(),
                result,
            });
        }
        let mut nodes = Nodes::with_hanging(self, marks);
        let (mut hexes, mut of, mut start) = (Vec::new(), Vec::new(), Vec::new());
        for ((hex, mark), number) in self.hexes.iter().zip(marks).zip(0..) {
            start.push(hexes.len());
            let lattice = nodes.part(hex, *mark);
            hexes.extend(places(*mark).map(|at| child(&lattice, at, *mark)));
            of.resize(hexes.len(), number);
        }
        start.push(hexes.len());
        let on_pieces = |face: &Face| {
            let element = face.element as usize;
            let (mark, first) = (marks[element], start[element]);
            let side = side_of(&self.hexes[element], &face.nodes);
            let touching = (first..).zip(places(mark)).filter_map(move |(piece, at)| {
                let (corners, axis, sign) = side?;
                (!mark[axis] || at[axis] == sign).then_some((piece, corners))
            });
            let faces = touching.map(|(piece, corners)| Face {
                nodes: corners.map(|c| hexes[piece][c]),
                element: piece as u32,
            });
            faces.collect::<Vec<_>>()
        };
        let surfaces = self.surfaces.iter().map(|surface| Surface {
            name: surface.name.clone(),
            faces: surface.faces.iter().flat_map(on_pieces).collect(),
        });
        let surfaces = surfaces.collect();
        let bodies = self.bodies.iter().map(|body| Body {
            name: body.name.clone(),
            elements: start[body.elements.start]..start[body.elements.end],
        });
        // What is split along all directions has a node in every middle.
        let lacks = |(_, of): &(&[u32; 8], &u32)| marks[**of as usize] != [true; 3];
        let lacking = hexes.iter().zip(&of).filter(lacks);
        let hanging: BTreeMap<u32, Vec<u32>> =
            lacking.flat_map(|(hex, _)| nodes.hanging(hex)).collect();
        let mesh = Mesh {
            source: match self.source.ends_with(REFINED) {
                true => self.source.clone(),
                false => format!("{}{REFINED}", self.source),
            },
            surfaces,
            bodies: bodies.collect(),
            points: nodes.points,
            hexes,
            hanging: (hanging.into_iter())
                .map(|(node, corners)| Hanging { node, corners })
                .collect(),
            fingerprint: None,
        };
        Ok(Refined {
            mesh: self.sound(mesh)?,
            of,
        })
    }
}

/// What is said of a mesh of which elements were split.
const REFINED: &str = ", refined";

/// The corners that the pieces of an element stand at.
fn places(mark: Directions) -> impl Iterator<Item = [f64; 3]> {
    let first = move |at: &[f64; 3]| (0..3).all(|k| mark[k] || at[k] < 0.0);
    CORNERS.into_iter().filter(first)
}

/// The direction of an edge.
fn along([a, b]: [usize; 2]) -> usize {
    (0..3)
        .find(|k| CORNERS[a][*k] != CORNERS[b][*k])
        .unwrap_or_default()
}

/// Marks every direction of a marked element in which one of its edges has a node in its middle, or gets one.
fn complete(mesh: &Mesh, marks: &mut [Directions]) {
    let of_edge = |h: &Hanging| <[u32; 2]>::try_from(h.corners.as_slice()).ok();
    let mut halved: HashSet<[u32; 2]> = mesh.hanging.iter().filter_map(of_edge).collect();
    loop {
        let marked = || {
            let all = mesh.hexes.iter().enumerate();
            all.flat_map(|(e, hex)| {
                EDGES.map(|ends| (e, along(ends), sorted(ends.map(|c| hex[c]))))
            })
        };
        let cut = marked().filter(|(e, axis, _)| marks[*e][*axis]);
        halved.extend(cut.map(|(_, _, key)| key));
        let more: Vec<(usize, usize)> = marked()
            .filter(|(e, axis, key)| {
                marks[*e].contains(&true) && !marks[*e][*axis] && halved.contains(key)
            })
            .map(|(e, axis, _)| (e, axis))
            .collect();
        if more.is_empty() {
            return;
        }
        more.into_iter().for_each(|(e, axis)| marks[e][axis] = true);
    }
}

/// What has to be split before the marked elements, as nodes of these hang on it.
fn coarser(mesh: &Mesh, marks: &[Directions]) -> Vec<Directions> {
    let mut wanted: HashSet<&[u32]> = HashSet::new();
    for (hex, mark) in mesh.hexes.iter().zip(marks) {
        if mark.contains(&true) {
            let hung = hex.iter().filter_map(|node| mesh.hung(*node));
            wanted.extend(hung.map(|h| h.corners.as_slice()));
        }
    }
    let mut first = vec![[false; 3]; marks.len()];
    if wanted.is_empty() {
        return first;
    }
    for (hex, first) in mesh.hexes.iter().zip(&mut first) {
        for ends in EDGES {
            let key = sorted(ends.map(|c| hex[c]));
            first[along(ends)] |= wanted.contains(key.as_slice());
        }
        for face in FACES {
            if wanted.contains(sorted(face.map(|c| hex[c])).as_slice()) {
                first[along([face[0], face[1]])] = true;
                first[along([face[1], face[2]])] = true;
            }
        }
    }
    first
}
