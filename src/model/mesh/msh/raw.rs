//! The contents of a mesh file as they stand there, before anything is matched.

use std::collections::HashMap;

use super::kind::GmshElement;
use super::place::{At, FilePlace};

/// A dimension (0 to 3) and the tag of an entity or physical group of it.
pub(super) type Key = (u8, i64);

#[derive(Default)]
pub(super) struct Raw {
    /// `$PhysicalNames`, with the marks of their lines.
    pub names: HashMap<Key, (u64, String)>,
    /// Marks and physical tags of the entities of `$Entities` (MSH 4.1).
    pub entities: HashMap<Key, (u64, Vec<i64>)>,
    pub nodes: Nodes,
    pub elements: Elements,
    pub fingerprint: Option<String>,
}

#[derive(Default)]
pub(super) struct Nodes {
    pub tags: Vec<u64>,
    pub points: Vec<[f64; 3]>,
    /// Line or byte offset of each node.
    pub marks: Vec<u64>,
    /// First node and entity of each block (MSH 4.1), ascending.
    pub blocks: Vec<(usize, Key)>,
}

#[derive(Default)]
pub(super) struct Elements {
    pub tags: Vec<u64>,
    /// Line or byte offset of each element.
    pub marks: Vec<u64>,
    /// Node tags of all elements, one after the other.
    pub nodes: Vec<u64>,
    /// Runs of elements of one type and one membership; they cover all elements.
    pub blocks: Vec<Block>,
}

/// A run of elements.
pub(super) struct Block {
    pub kind: &'static GmshElement,
    /// Tag of the entity they mesh; its dimension is that of their type.
    pub entity: i64,
    pub group: Group,
    /// Index of the first, and how many.
    pub first: usize,
    pub count: usize,
    /// Where the nodes of the first begin in [`Elements::nodes`].
    pub first_node: usize,
}

/// How a run of elements says which physical groups it belongs to.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Group {
    /// By its entity (MSH 4.1).
    OfEntity,
    /// By a physical tag of its own (MSH 2.2), zero for none.
    Tag(i64),
}

impl Block {
    /// The elements of the run: index and node tags.
    pub fn iter<'a>(&self, elements: &'a Elements) -> impl Iterator<Item = (usize, &'a [u64])> {
        let width = self.kind.nodes;
        let end = self.first_node + width * self.count;
        let nodes = elements.nodes.get(self.first_node..end).unwrap_or_default();
        (self.first..).zip(nodes.chunks_exact(width))
    }
}

/// Turns marks of nodes and elements into places, once the file is read.
pub(super) struct Places<'a> {
    pub source: &'a str,
    /// Whether marks are lines.
    pub text: bool,
}

impl Places<'_> {
    pub fn at(&self, mark: u64) -> At {
        if self.text {
            At::Line(mark)
        } else {
            At::Byte(mark)
        }
    }

    pub fn place(&self, section: &str, mark: u64) -> FilePlace {
        FilePlace {
            source: self.source.to_owned(),
            section: section.to_owned(),
            at: self.at(mark),
        }
    }
}
