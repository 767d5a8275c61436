//! The nodes and line elements of a file, and the rings that they form.

use std::collections::BTreeMap;
use std::sync::Arc as Shared;

use glam::{DVec2, DVec3};

use super::super::curve::Curve;
use super::super::loops::{self, Link};
use super::super::outline::Outlines;
use super::super::plane;
use super::super::text::{at_line, counted};
use crate::error::ReadError;

/// What the sections hold of lines.
#[derive(Default)]
pub(super) struct File {
    /// Names of physical groups of curves, by their tags.
    pub(super) names: BTreeMap<i64, Shared<str>>,
    /// The first physical group of each curve, by the tag of the curve.
    pub(super) groups: BTreeMap<i64, i64>,
    pub(super) points: Vec<DVec3>,
    /// The index of a node, by its tag.
    pub(super) nodes: BTreeMap<i64, u32>,
    pub(super) lines: Vec<Line>,
    /// How many elements are no lines.
    pub(super) others: usize,
}

/// A line element.
pub(super) struct Line {
    /// The line of the text.
    pub(super) line: u64,
    pub(super) nodes: [i64; 2],
    pub(super) curve: i64,
    pub(super) group: Option<i64>,
}

impl File {
    pub(super) fn node(&mut self, line: u64, tag: i64, point: DVec3) -> Result<(), ReadError> {
        let index = u32::try_from(self.points.len());
        let index = index.map_err(|_| at_line(line, "the file has more than 4294967295 nodes"))?;
        if self.nodes.insert(tag, index).is_some() {
            return Err(at_line(line, format!("the node {tag} is there twice")));
        }
        self.points.push(point);
        Ok(())
    }

    pub(super) fn outlines(self) -> Result<Outlines, ReadError> {
        let Self { names, groups, points, nodes, lines, others } = self;
        if lines.is_empty() {
            let others = counted(others, "other element");
            return Err(ReadError::place(
                "$Elements",
                format!(
                    "the file has no line elements, only {others}; mesh the curves with gmsh -1, \
                     and save all elements (Mesh.SaveAll = 1) or a physical group of the curves"
                ),
            ));
        }
        let link = |element: &Line| {
            let node = |tag: i64| {
                nodes.get(&tag).copied().ok_or_else(|| {
                    at_line(element.line, format!("the node {tag} is not in the file"))
                })
            };
            let [a, b] = element.nodes;
            let group = element.group.or_else(|| groups.get(&element.curve).copied());
            let side = group.map(|group| match names.get(&group) {
                Some(name) => Shared::clone(name),
                None => Shared::from(format!("physical {group}")),
            });
            let part_of = element.curve.cast_unsigned();
            Ok(Link { ends: [node(a)?, node(b)?], curve: Curve::Line, side, part_of })
        };
        let links: Vec<Link> = lines.iter().map(link).collect::<Result<_, ReadError>>()?;
        let used = links.iter().flat_map(|link| link.ends).map(|end| points[end as usize].z);
        let mut notes: Vec<String> = plane::check(used)?.into_iter().collect();
        let mut tags = vec![0; points.len()];
        nodes.iter().for_each(|(&tag, &index)| tags[index as usize] = tag);
        let points: Vec<DVec2> = points.iter().map(|point| point.truncate()).collect();
        let (rings, note) =
            loops::rings(&points, &links, |point| format!("node {}", tags[point as usize]))?;
        notes.extend(note);
        if others > 0 {
            notes.push(format!("left out {} that are no lines", counted(others, "element")));
        }
        Outlines::of_rings(rings, notes)
    }
}

/// Whether an element type is a line: of two, three or four nodes, and so on. The first two nodes
/// are its ends.
pub(super) fn is_line(kind: i64) -> bool {
    matches!(kind, 1 | 8 | 26 | 27 | 28)
}
