//! From the tags of a file, which may be sparse, to indices.

use std::collections::HashMap;

/// Finds the index of a tag.
pub(super) enum TagMap {
    /// Index of each tag from the smallest on; [`NONE`] in the holes.
    Dense {
        smallest: u64,
        indices: Vec<u32>,
    },
    Sparse(HashMap<u64, u32>),
}

const NONE: u32 = u32::MAX;

impl TagMap {
    /// A map from `tags` to their places in the list, of which there must be fewer than
    /// `u32::MAX`.
    ///
    /// # Errors
    /// The first and second place of a tag that occurs twice.
    pub fn new(tags: &[u64]) -> Result<Self, (usize, usize)> {
        let (smallest, largest) = tags
            .iter()
            .fold((u64::MAX, 0), |(low, high), &t| (low.min(t), high.max(t)));
        let span = largest.saturating_sub(smallest);
        let dense = (tags.len() as u64).saturating_mul(4).saturating_add(1024);
        if span < dense {
            let mut indices = vec![NONE; span as usize + 1];
            for (index, tag) in (0u32..).zip(tags) {
                let slot = &mut indices[(tag - smallest) as usize];
                if *slot != NONE {
                    return Err((*slot as usize, index as usize));
                }
                *slot = index;
            }
            return Ok(Self::Dense { smallest, indices });
        }
        let mut indices = HashMap::with_capacity(tags.len());
        for (index, tag) in (0u32..).zip(tags) {
            if let Some(first) = indices.insert(*tag, index) {
                return Err((first as usize, index as usize));
            }
        }
        Ok(Self::Sparse(indices))
    }

    /// The index of `tag`.
    pub fn get(&self, tag: u64) -> Option<u32> {
        match self {
            Self::Dense { smallest, indices } => {
                let offset = usize::try_from(tag.checked_sub(*smallest)?).ok()?;
                indices.get(offset).copied().filter(|index| *index != NONE)
            }
            Self::Sparse(indices) => indices.get(&tag).copied(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dense_and_sparse_tags_are_found() {
        for tags in [vec![7, 5, 6], vec![u64::MAX, 0, 12]] {
            let map = TagMap::new(&tags).unwrap_or_else(|_| panic!("no tag is there twice"));
            for (index, tag) in (0u32..).zip(&tags) {
                assert_eq!(map.get(*tag), Some(index));
            }
            assert_eq!(map.get(4), None);
            assert_eq!(map.get(u64::MAX - 1), None);
        }
        assert!(TagMap::new(&[]).is_ok_and(|map| map.get(0).is_none()));
    }

    #[test]
    fn the_two_places_of_a_repeated_tag_are_told() {
        assert_eq!(TagMap::new(&[1, 2, 3, 2]).err(), Some((1, 3)));
        assert_eq!(TagMap::new(&[1, u64::MAX, 1]).err(), Some((0, 2)));
    }
}
