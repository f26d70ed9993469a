//! Which elements belong to which physical groups.

use crate::ground::order::ascending;
use std::collections::BTreeMap;

use super::error::MeshError;
use super::kind::{HEXAHEDRON, QUADRILATERAL};
use super::names::{ENTITIES, name_of};
use super::place::FilePlace;
use super::raw::{Block, Group, Key, Places, Raw};

/// The runs of elements sorted by physical groups.
#[derive(Default)]
pub(super) struct Groups<'a> {
    /// Physical tag and hexahedra of each physical volume, in order of first appearance.
    pub volumes: Vec<(i64, Vec<&'a Block>)>,
    /// Quadrilaterals of each physical surface, by physical tag.
    pub surfaces: BTreeMap<i64, Vec<&'a Block>>,
    /// Elements of physical points and curves.
    pub lower: Vec<(Key, &'a Block)>,
}

impl<'a> Groups<'a> {
    /// Sorts the elements of `raw`. Every volume element must be a hexahedron of exactly one
    /// physical volume, every surface element in a physical surface a quadrilateral.
    pub fn new(raw: &'a Raw, places: &Places<'_>) -> Result<Self, MeshError> {
        let mut groups = Self::default();
        let blocks = || raw.elements.blocks.iter().filter(|block| block.count > 0);
        let source_name = places.source.to_owned();
        if !blocks().any(|block| block.kind.dimension == 3) {
            return Err(MeshError::NoVolumes { source_name });
        }
        let by_entity = blocks().any(|block| block.group == Group::OfEntity);
        if by_entity && raw.entities.is_empty() {
            return Err(MeshError::MissingSection {
                source_name,
                section: "Entities",
            });
        }
        let mut grouped = false;
        for block in blocks().filter(|block| block.kind.dimension == 3) {
            grouped |= !known_tags(raw, block, places)?.is_empty();
        }
        if !grouped {
            return Err(MeshError::NoPhysicalVolume { source_name });
        }
        for block in blocks() {
            match block.kind.dimension {
                3 => groups.add_volume(raw, block, places)?,
                2 => groups.add_surface(raw, block, places)?,
                dimension => {
                    let keys = known_tags(raw, block, places)?
                        .into_iter()
                        .map(|t| (dimension, t));
                    groups.lower.extend(keys.map(|key| (key, block)));
                }
            }
        }
        Ok(groups)
    }

    fn add_volume(
        &mut self,
        raw: &Raw,
        block: &'a Block,
        places: &Places<'_>,
    ) -> Result<(), MeshError> {
        let (place, element) = first(raw, block, places);
        let tags = known_tags(raw, block, places)?;
        let [tag] = tags.as_slice() else {
            let entity = entity(block);
            if tags.is_empty() {
                return Err(MeshError::UngroupedVolume {
                    place,
                    element,
                    entity,
                });
            }
            let names: Vec<_> = tags
                .iter()
                .map(|t| format!("`{}`", name_of(raw, (3, *t))))
                .collect();
            let names = names.join(", ");
            return Err(MeshError::SeveralVolumes {
                place,
                element,
                entity,
                names,
            });
        };
        if block.kind.code != HEXAHEDRON {
            let (body, kind) = (name_of(raw, (3, *tag)), block.kind.name);
            return Err(MeshError::NotHexahedron {
                place,
                element,
                body,
                kind,
            });
        }
        match self.volumes.iter_mut().find(|(other, _)| other == tag) {
            Some((_, blocks)) => blocks.push(block),
            None => self.volumes.push((*tag, vec![block])),
        }
        Ok(())
    }

    fn add_surface(
        &mut self,
        raw: &Raw,
        block: &'a Block,
        places: &Places<'_>,
    ) -> Result<(), MeshError> {
        for tag in known_tags(raw, block, places)? {
            if block.kind.code != QUADRILATERAL {
                let (place, element) = first(raw, block, places);
                let (surface, kind) = (name_of(raw, (2, tag)), block.kind.name);
                return Err(MeshError::NotQuadrilateral {
                    place,
                    element,
                    surface,
                    kind,
                });
            }
            self.surfaces.entry(tag).or_default().push(block);
        }
        Ok(())
    }
}

/// Physical tags of a run, each once; none where its entity is unknown.
fn tags(raw: &Raw, block: &Block) -> Vec<i64> {
    ascending(match block.group {
        Group::Tag(0) => Vec::new(),
        Group::Tag(tag) => vec![tag],
        Group::OfEntity => {
            let key = (block.kind.dimension, block.entity);
            raw.entities
                .get(&key)
                .map(|(_, tags)| tags.clone())
                .unwrap_or_default()
        }
    })
}

/// Physical tags of a run, whose entity must be known.
fn known_tags(raw: &Raw, block: &Block, places: &Places<'_>) -> Result<Vec<i64>, MeshError> {
    let key = (block.kind.dimension, block.entity);
    if block.group == Group::OfEntity && !raw.entities.contains_key(&key) {
        let (place, _) = first(raw, block, places);
        return Err(MeshError::UnknownEntity {
            place,
            entity: entity(block),
        });
    }
    Ok(tags(raw, block))
}

fn entity(block: &Block) -> String {
    format!(
        "{} {}",
        ENTITIES[usize::from(block.kind.dimension)],
        block.entity
    )
}

/// Place and tag of the first element of a run.
fn first(raw: &Raw, block: &Block, places: &Places<'_>) -> (FilePlace, u64) {
    let mark = raw
        .elements
        .marks
        .get(block.first)
        .copied()
        .unwrap_or_default();
    let tag = raw
        .elements
        .tags
        .get(block.first)
        .copied()
        .unwrap_or_default();
    (places.place("Elements", mark), tag)
}
