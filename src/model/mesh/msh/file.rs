//! The contents of a file, with the means to say where something stands.

use super::error::MeshError;
use super::place::FilePlace;
use super::raw::{Places, Raw};
use super::tags::TagMap;

/// The contents of a file, with the means to say where something stands.
#[derive(Clone, Copy)]
pub(super) struct File<'a> {
    pub raw: &'a Raw,
    pub places: &'a Places<'a>,
}

impl File<'_> {
    pub fn node_indices(&self) -> Result<TagMap, MeshError> {
        let nodes = &self.raw.nodes;
        self.limit(nodes.tags.len(), "nodes")?;
        TagMap::new(&nodes.tags)
            .map_err(|twice| self.twice("Nodes", "node", &nodes.tags, &nodes.marks, twice))
    }

    pub fn check_element_tags(&self) -> Result<(), MeshError> {
        let elements = &self.raw.elements;
        self.limit(elements.tags.len(), "elements")?;
        TagMap::new(&elements.tags).map(|_| ()).map_err(|twice| {
            self.twice(
                "Elements",
                "element",
                &elements.tags,
                &elements.marks,
                twice,
            )
        })
    }

    fn limit(&self, count: usize, what: &'static str) -> Result<(), MeshError> {
        let (count, limit) = (count as u64, u64::from(u32::MAX) - 1);
        if count <= limit {
            return Ok(());
        }
        let source_name = self.places.source.to_owned();
        Err(MeshError::TooLarge {
            source_name,
            count,
            limit,
            what,
        })
    }

    fn twice(
        &self,
        section: &str,
        what: &'static str,
        tags: &[u64],
        marks: &[u64],
        (first, second): (usize, usize),
    ) -> MeshError {
        let mark = |k: usize| marks.get(k).copied().unwrap_or_default();
        let place = self.places.place(section, mark(second));
        let tag = tags.get(second).copied().unwrap_or_default().to_string();
        MeshError::DuplicateTag {
            place,
            what,
            tag,
            first: self.places.at(mark(first)),
        }
    }

    /// The nodes of all elements, also those that are not needed, by index instead of tag.
    pub fn element_nodes(&self, indices: &TagMap) -> Result<Vec<u32>, MeshError> {
        let elements = &self.raw.elements;
        let mut nodes = Vec::with_capacity(elements.nodes.len());
        for block in &elements.blocks {
            for (element, tags) in block.iter(elements) {
                for &node in tags {
                    let Some(index) = indices.get(node) else {
                        let (place, element) = self.element(element);
                        return Err(MeshError::UnknownNode {
                            place,
                            element,
                            node,
                        });
                    };
                    nodes.push(index);
                }
            }
        }
        Ok(nodes)
    }

    /// Place and tag of element `element` of the file.
    pub fn element(&self, element: usize) -> (FilePlace, u64) {
        let elements = &self.raw.elements;
        let mark = elements.marks.get(element).copied().unwrap_or_default();
        let tag = elements.tags.get(element).copied().unwrap_or_default();
        (self.places.place("Elements", mark), tag)
    }

    pub fn node_tag(&self, node: u32) -> u64 {
        self.raw
            .nodes
            .tags
            .get(node as usize)
            .copied()
            .unwrap_or_default()
    }
}
