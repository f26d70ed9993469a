//! The layout of MSH 4.1.

use super::cursor::Cursor;
use super::error::MeshError;
use super::kind::GmshElement;
use super::names::ENTITIES;
use super::raw::{Block, Elements, Group, Key, Nodes, Raw};

/// `$Entities`: only the physical tags of each entity are kept.
pub(super) fn entities(cursor: &mut Cursor<'_>, raw: &mut Raw) -> Result<(), MeshError> {
    cursor.begin("the numbers of entities")?;
    let mut counts = [0; 4];
    for count in &mut counts {
        *count = cursor.size("a number of entities")?;
    }
    cursor.finish()?;
    for (dimension, count) in (0u8..).zip(counts) {
        // A point has three coordinates, any other entity the six of its bounding box.
        let coordinates = if dimension == 0 { 3 } else { 6 };
        let count = cursor.bounded(count, "entities", 2 + coordinates, 12 + 8 * coordinates)?;
        for _ in 0..count {
            let mark = cursor.begin("an entity")?;
            let tag = cursor.int("the tag of an entity")?;
            for _ in 0..coordinates {
                cursor.real("a bound of the entity")?;
            }
            let mut physical = tags(cursor, "physical tags of the entity")?;
            physical.retain(|tag| *tag != 0);
            if dimension > 0 {
                tags(cursor, "bounding entities")?;
            }
            if let Some((first, _)) = raw.entities.insert((dimension, tag), (mark, physical)) {
                let (place, first) = (cursor.place_of(mark), cursor.at(first));
                let what = ENTITIES[usize::from(dimension)];
                return Err(MeshError::DuplicateTag {
                    place,
                    what,
                    tag: tag.to_string(),
                    first,
                });
            }
            cursor.finish()?;
        }
    }
    Ok(())
}

/// A count and as many tags, without their signs (which only turn orientations).
fn tags(cursor: &mut Cursor<'_>, what: &'static str) -> Result<Vec<i64>, MeshError> {
    let count = cursor.size(what)?;
    let count = cursor.bounded(count, what, 1, 4)?;
    (0..count).map(|_| Ok(cursor.int(what)?.abs())).collect()
}

/// `$Nodes`.
pub(super) fn nodes(cursor: &mut Cursor<'_>) -> Result<Nodes, MeshError> {
    let (blocks, total) = header(cursor, "nodes")?;
    let total = cursor.bounded(total, "nodes", 4, 32)?;
    let mut nodes = Nodes {
        tags: Vec::with_capacity(total),
        points: Vec::with_capacity(total),
        marks: Vec::with_capacity(total),
        blocks: Vec::new(),
    };
    for _ in 0..blocks {
        cursor.begin("a block of nodes")?;
        let entity = entity(cursor)?;
        let parametric = cursor.int("the parametric flag")? != 0;
        let count = cursor.size("the number of nodes in the block")?;
        within(cursor, "nodes", total, nodes.tags.len(), count)?;
        cursor.finish()?;
        let parameters = if parametric { usize::from(entity.0) } else { 0 };
        let count = cursor.bounded(count, "nodes", 4 + parameters, 32 + 8 * parameters)?;
        let first = nodes.tags.len();
        nodes.blocks.push((first, entity));
        for _ in 0..count {
            nodes.marks.push(cursor.begin("a node tag")?);
            nodes.tags.push(cursor.size("a node tag")?);
            cursor.finish()?;
        }
        for k in first..first + count {
            cursor.begin("the coordinates of a node")?;
            let tag = nodes.tags.get(k).copied().unwrap_or_default();
            nodes.points.push(cursor.point(tag)?);
            for _ in 0..parameters {
                cursor.real("a parametric coordinate")?;
            }
            cursor.finish()?;
        }
    }
    complete(cursor, "nodes", total, nodes.tags.len())?;
    Ok(nodes)
}

/// `$Elements`.
pub(super) fn elements(cursor: &mut Cursor<'_>) -> Result<Elements, MeshError> {
    let (blocks, total) = header(cursor, "elements")?;
    let total = cursor.bounded(total, "elements", 2, 16)?;
    let mut elements = Elements {
        tags: Vec::with_capacity(total),
        marks: Vec::with_capacity(total),
        ..Elements::default()
    };
    for _ in 0..blocks {
        cursor.begin("a block of elements")?;
        let (dimension, entity) = entity(cursor)?;
        let code = cursor.int("an element type")?;
        let kind = GmshElement::of(code)
            .ok_or_else(|| cursor.syntax("a known element type", code.to_string().as_bytes()))?;
        if kind.dimension != dimension {
            let expected = format!("an element type of dimension {dimension}");
            return Err(cursor.syntax(&expected, kind.name.as_bytes()));
        }
        let count = cursor.size("the number of elements in the block")?;
        within(cursor, "elements", total, elements.tags.len(), count)?;
        cursor.finish()?;
        let count = cursor.bounded(count, "elements", 1 + kind.nodes, 8 + 8 * kind.nodes)?;
        let (first, first_node) = (elements.tags.len(), elements.nodes.len());
        let group = Group::OfEntity;
        elements.blocks.push(Block {
            kind,
            entity,
            group,
            first,
            count,
            first_node,
        });
        elements.nodes.reserve(count * kind.nodes);
        for _ in 0..count {
            elements.marks.push(cursor.begin("an element")?);
            elements.tags.push(cursor.size("an element tag")?);
            for _ in 0..kind.nodes {
                elements.nodes.push(cursor.size("a node tag")?);
            }
            cursor.finish()?;
        }
    }
    complete(cursor, "elements", total, elements.tags.len())?;
    Ok(elements)
}

/// The first line of `$Nodes` and `$Elements`: number of blocks, number of records. The smallest
/// and largest tag, which follow, are not relied on.
fn header(cursor: &mut Cursor<'_>, what: &str) -> Result<(u64, u64), MeshError> {
    cursor.begin(&format!("the number of blocks of {what}"))?;
    let blocks = cursor.size("the number of blocks")?;
    let total = cursor.size(&format!("the number of {what}"))?;
    cursor.size("the smallest tag")?;
    cursor.size("the largest tag")?;
    cursor.finish()?;
    Ok((blocks, total))
}

fn entity(cursor: &mut Cursor<'_>) -> Result<Key, MeshError> {
    let dimension = cursor.int("the dimension of an entity")?;
    let tag = cursor.int("the tag of an entity")?;
    match u8::try_from(dimension) {
        Ok(dimension) if dimension <= 3 => Ok((dimension, tag)),
        _ => Err(cursor.syntax("a dimension from 0 to 3", dimension.to_string().as_bytes())),
    }
}

/// Refuses a block that goes beyond the total that the header announced.
fn within(
    cursor: &Cursor<'_>,
    what: &'static str,
    total: usize,
    before: usize,
    count: u64,
) -> Result<(), MeshError> {
    let sum = (before as u64).saturating_add(count);
    if sum <= total as u64 {
        return Ok(());
    }
    let found = format!("but the blocks up to here have {sum}");
    Err(MeshError::Count {
        place: cursor.place(),
        what,
        count: total as u64,
        found,
    })
}

fn complete(
    cursor: &Cursor<'_>,
    what: &'static str,
    total: usize,
    found: usize,
) -> Result<(), MeshError> {
    if found == total {
        return Ok(());
    }
    let found = format!("but the blocks together have {found}");
    Err(MeshError::Count {
        place: cursor.place(),
        what,
        count: total as u64,
        found,
    })
}
