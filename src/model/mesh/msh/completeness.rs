//! Is every physical group there, whole, and under a name of its own?

use super::error::MeshError;
use super::groups::Groups;
use super::names::{ENTITIES, name_of};
use super::raw::{Key, Places, Raw};
use std::collections::BTreeSet;

impl Groups<'_> {
    /// Refuses physical volumes and surfaces that have a name but no elements, and entities in
    /// them that have no elements: a part of the body would be missing.
    pub fn check_complete(&self, raw: &Raw, places: &Places<'_>) -> Result<(), MeshError> {
        let empty = |dimension: u8, tag: i64, part: String| {
            let (name, kind) = (
                name_of(raw, (dimension, tag)),
                ENTITIES[usize::from(dimension)],
            );
            let source_name = places.source.to_owned();
            Err(MeshError::EmptyGroup {
                source_name,
                kind,
                name,
                tag,
                part,
            })
        };
        let named: BTreeSet<Key> = raw.names.keys().copied().filter(|key| key.0 >= 2).collect();
        for (dimension, tag) in named {
            let there = match dimension {
                2 => self.surfaces.contains_key(&tag),
                _ => self.volumes.iter().any(|(other, _)| *other == tag),
            };
            if !there {
                return empty(dimension, tag, String::new());
            }
        }
        let meshed: BTreeSet<Key> = raw
            .elements
            .blocks
            .iter()
            .filter(|block| block.count > 0)
            .map(|block| (block.kind.dimension, block.entity))
            .collect();
        let mut entities: Vec<_> = raw.entities.iter().filter(|(key, _)| key.0 >= 2).collect();
        entities.sort_unstable();
        for (key, (_, tags)) in entities {
            if let (Some(tag), false) = (tags.first(), meshed.contains(key)) {
                let part = format!(" in {} {}", ENTITIES[usize::from(key.0)], key.1);
                return empty(key.0, *tag, part);
            }
        }
        Ok(())
    }

    /// Refuses two physical volumes, or two physical surfaces, of one name.
    pub fn check_names(&self, raw: &Raw, places: &Places<'_>) -> Result<(), MeshError> {
        let volumes = self.volumes.iter().map(|(tag, _)| (3, *tag));
        let mut seen = BTreeSet::new();
        for key in volumes.chain(self.surfaces.keys().map(|tag| (2, *tag))) {
            let (kind, name) = (ENTITIES[usize::from(key.0)], name_of(raw, key));
            if !seen.insert((key.0, name.clone())) {
                let source_name = places.source.to_owned();
                return Err(MeshError::DuplicateName {
                    source_name,
                    kind,
                    name,
                });
            }
        }
        Ok(())
    }
}
