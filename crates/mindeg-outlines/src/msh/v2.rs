//! The sections of MSH 2.2.

use super::content::{File, Line, is_line};
use super::rows::Rows;
use crate::error::ReadError;

/// The type of an element that is a point.
const POINT: i64 = 15;

pub(super) fn nodes(rows: &mut Rows<'_>, file: &mut File) -> Result<(), ReadError> {
    let count = rows.next("the number of nodes")?.whole("number of nodes")?;
    for _ in 0..count {
        let mut row = rows.next("a node")?;
        let tag = row.whole("number of the node")?;
        let point = row.point()?;
        file.node(row.line, tag, point)?;
    }
    Ok(())
}

pub(super) fn elements(rows: &mut Rows<'_>, file: &mut File) -> Result<(), ReadError> {
    let count = rows.next("the number of elements")?.whole("number of elements")?;
    for _ in 0..count {
        let mut row = rows.next("an element")?;
        row.whole("number of the element")?;
        let kind = row.whole("type of the element")?;
        if !is_line(kind) {
            file.others += usize::from(kind != POINT);
            continue;
        }
        let tags = row.whole("number of tags")?;
        let mut group = None;
        let mut curve = 0;
        for tag in 0..tags {
            let value = row.whole("tag")?;
            match tag {
                0 => group = Some(value).filter(|&group| group != 0).map(i64::saturating_abs),
                1 => curve = value,
                _ => {}
            }
        }
        let nodes = [row.whole("first node")?, row.whole("second node")?];
        file.lines.push(Line { line: row.line, nodes, curve, group });
    }
    Ok(())
}
