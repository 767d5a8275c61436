//! The sections of MSH 4.1.

use super::content::{File, Line, is_line};
use super::rows::Rows;
use crate::error::ReadError;

/// `$Entities`: which physical groups the curves belong to.
pub(super) fn entities(rows: &mut Rows<'_>, file: &mut File) -> Result<(), ReadError> {
    let mut counts = rows.next("the numbers of entities")?;
    let points = counts.whole("number of points")?;
    let curves = counts.whole("number of curves")?;
    for _ in 0..points {
        rows.next("a point")?;
    }
    for _ in 0..curves {
        let mut row = rows.next("a curve")?;
        let tag = row.whole("tag of the curve")?;
        row.point()?;
        row.point()?;
        let groups = row.whole("number of physical groups")?;
        if groups > 0 {
            // Negative where the group runs the other way.
            let group = row.whole("tag of the physical group")?;
            file.groups.insert(tag, group.saturating_abs());
        }
    }
    Ok(())
}

pub(super) fn nodes(rows: &mut Rows<'_>, file: &mut File) -> Result<(), ReadError> {
    let blocks = rows.next("the number of blocks")?.whole("number of blocks")?;
    let mut tags = Vec::new();
    for _ in 0..blocks {
        let mut block = rows.next("a block of nodes")?;
        block.whole("dimension")?;
        block.whole("tag of the entity")?;
        block.whole("mark of parametric nodes")?;
        let count = block.whole("number of nodes")?;
        tags.clear();
        for _ in 0..count {
            tags.push(rows.next("the tag of a node")?.whole("tag of the node")?);
        }
        for &tag in &tags {
            let mut row = rows.next("a node")?;
            let point = row.point()?;
            file.node(row.line, tag, point)?;
        }
    }
    Ok(())
}

pub(super) fn elements(rows: &mut Rows<'_>, file: &mut File) -> Result<(), ReadError> {
    let blocks = rows.next("the number of blocks")?.whole("number of blocks")?;
    for _ in 0..blocks {
        let mut block = rows.next("a block of elements")?;
        let dimension = block.whole("dimension")?;
        let curve = block.whole("tag of the entity")?;
        let kind = block.whole("type of the elements")?;
        let count = block.whole("number of elements")?;
        for _ in 0..count {
            let mut row = rows.next("an element")?;
            row.whole("tag of the element")?;
            if is_line(kind) {
                let nodes = [row.whole("first node")?, row.whole("second node")?];
                file.lines.push(Line { line: row.line, nodes, curve, group: None });
            } else if dimension > 0 {
                file.others += 1;
            }
        }
    }
    Ok(())
}
