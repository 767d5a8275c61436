//! The tables that text formats for solvers share.

use std::ops::Range;
use std::sync::Arc;

use crate::corners::triangles;
use crate::numbers::{Numbers, Row};
use crate::sections::Section;
use mindeg_mesh::Mesh;

/// A line for each item: `before`, its number from 1, and its row.
pub(crate) fn numbered_lines<'a, I: Iterator<Item: Row>>(
    before: &'static str,
    items: Range<u32>,
    rows: impl Fn(Range<u32>) -> I + Sync + 'a,
) -> Section<'a> {
    Numbers::Text.records(items, move |range: Range<u32>| {
        let rows = range.clone().zip(rows(range));
        rows.map(move |(index, row)| (before, from_one([index]), row))
    })
}

/// Indices as files count them, from 1.
pub(crate) fn from_one<const N: usize>(indices: [u32; N]) -> [u64; N] {
    indices.map(|index| u64::from(index) + 1)
}

/// The corners of triangles, counted from 1.
pub(crate) fn corners_from_one(
    mesh: &dyn Mesh,
    range: Range<u32>,
) -> impl Iterator<Item = [u64; 3]> {
    triangles(mesh, range).into_iter().map(from_one)
}

/// The index of the run that each item is in; each run ends where the next begins.
pub(crate) fn runs_of(ends: Arc<[u32]>, items: Range<u32>) -> impl Iterator<Item = i32> {
    let mut index = ends.partition_point(|&end| end <= items.start);
    items.map(move |item| {
        while ends.get(index).is_some_and(|&end| end <= item) {
            index += 1;
        }
        index as i32
    })
}

/// Where the groups of a mesh end.
pub(crate) fn ends_of_groups(mesh: &dyn Mesh) -> Arc<[u32]> {
    mesh.groups().iter().map(|group| group.triangles.end).collect()
}
