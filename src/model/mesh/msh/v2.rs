//! The layout of MSH 2.2.

use super::cursor::{Cursor, Encoding};
use super::error::MeshError;
use super::kind::GmshElement;
use super::raw::{Block, Elements, Group, Nodes};

/// `$Nodes`.
pub(super) fn nodes(cursor: &mut Cursor<'_>) -> Result<Nodes, MeshError> {
    let count = count(cursor, "nodes", 4, 28)?;
    let mut nodes = Nodes {
        tags: Vec::with_capacity(count),
        points: Vec::with_capacity(count),
        marks: Vec::with_capacity(count),
        blocks: Vec::new(),
    };
    for _ in 0..count {
        nodes.marks.push(cursor.begin("a node")?);
        let tag = cursor.natural("a node tag")?;
        nodes.tags.push(tag);
        nodes.points.push(cursor.point(tag)?);
        cursor.finish()?;
    }
    Ok(nodes)
}

/// `$Elements`.
pub(super) fn elements(cursor: &mut Cursor<'_>) -> Result<Elements, MeshError> {
    let count = count(cursor, "elements", 4, 8)?;
    let mut elements = Elements {
        tags: Vec::with_capacity(count),
        marks: Vec::with_capacity(count),
        ..Elements::default()
    };
    while elements.tags.len() < count {
        match cursor.encoding {
            Encoding::Text => {
                let mark = cursor.begin("an element")?;
                let tag = cursor.natural("an element tag")?;
                let kind = kind(cursor)?;
                let tags = cursor.natural("the number of tags")?;
                element(cursor, &mut elements, mark, tag, kind, tags)?;
                cursor.finish()?;
            }
            Encoding::Binary { .. } => batch(cursor, &mut elements, count)?,
        }
    }
    Ok(elements)
}

/// A header and the elements that it announces, in binary.
fn batch(cursor: &mut Cursor<'_>, elements: &mut Elements, total: usize) -> Result<(), MeshError> {
    let kind = kind(cursor)?;
    let count = cursor.natural("the number of elements that follow")?;
    let tags = cursor.natural("the number of tags")?;
    let width = usize::try_from(tags)
        .unwrap_or(usize::MAX)
        .saturating_add(1 + kind.nodes);
    let count = cursor.bounded(count, "elements", width, width.saturating_mul(4))?;
    if elements.tags.len() + count > total {
        let found = format!("but {} are there up to here", elements.tags.len() + count);
        let (place, what) = (cursor.place(), "elements");
        return Err(MeshError::Count {
            place,
            what,
            count: total as u64,
            found,
        });
    }
    for _ in 0..count {
        let mark = cursor.begin("an element")?;
        let tag = cursor.natural("an element tag")?;
        element(cursor, elements, mark, tag, kind, tags)?;
    }
    Ok(())
}

/// The tags and nodes of one element: the physical tag, the entity's tag, others (the parts of a
/// partition), the nodes.
fn element(
    cursor: &mut Cursor<'_>,
    elements: &mut Elements,
    mark: u64,
    tag: u64,
    kind: &'static GmshElement,
    tags: u64,
) -> Result<(), MeshError> {
    let (mut physical, mut entity) = (0, 0);
    for k in 0..tags {
        // Signs only turn orientations.
        let value = cursor.int("a tag of the element")?.abs();
        match k {
            0 => physical = value,
            1 => entity = value,
            _ => {}
        }
    }
    let (first, first_node) = (elements.tags.len(), elements.nodes.len());
    for _ in 0..kind.nodes {
        elements.nodes.push(cursor.natural("a node tag")?);
    }
    elements.marks.push(mark);
    elements.tags.push(tag);
    let group = Group::Tag(physical);
    match elements.blocks.last_mut() {
        Some(last) if last.kind == kind && last.entity == entity && last.group == group => {
            last.count += 1;
        }
        _ => elements.blocks.push(Block {
            kind,
            entity,
            group,
            first,
            count: 1,
            first_node,
        }),
    }
    Ok(())
}

fn kind(cursor: &mut Cursor<'_>) -> Result<&'static GmshElement, MeshError> {
    let code = cursor.int("an element type")?;
    GmshElement::of(code)
        .ok_or_else(|| cursor.syntax("a known element type", code.to_string().as_bytes()))
}

/// The number of records, which stands in text even in a binary file.
fn count(
    cursor: &mut Cursor<'_>,
    what: &'static str,
    numbers: usize,
    bytes: usize,
) -> Result<usize, MeshError> {
    let expected = format!("the number of {what}");
    cursor.begin(&expected)?;
    let count = cursor.text_size(&expected)?;
    match cursor.encoding {
        Encoding::Text => cursor.finish()?,
        // The records begin with the next byte: blanks must not be passed.
        Encoding::Binary { .. } => {
            cursor.rest_of_line();
        }
    }
    cursor.bounded(count, what, numbers, bytes)
}
