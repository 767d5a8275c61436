//! The tables that text formats for solvers share.

use std::ops::Range;
use std::sync::Arc;

use crate::corners::triangles;
use crate::numbers::{Numbers, Row};
use crate::sections::Section;
use mindeg_mesh::{ByName, Mesh};

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

/// The lines or groups of a mesh: each ends where the next begins, and those of one name are one.
#[derive(Clone)]
pub(crate) struct NamedRuns {
    pub(crate) names: Arc<[String]>,
    /// The end of each run, and the index of its name.
    runs: Arc<[(u32, u32)]>,
}

impl NamedRuns {
    pub(crate) fn of_lines(mesh: &dyn Mesh) -> Self {
        let lines = mesh.lines();
        Self::new(lines.iter().map(|line| (&*line.name, line.segments.end)))
    }

    pub(crate) fn of_groups(mesh: &dyn Mesh) -> Self {
        Self::new(mesh.groups().iter().map(|group| (group.label(), group.triangles.end)))
    }

    fn new<'a>(runs: impl Iterator<Item = (&'a str, u32)> + Clone) -> Self {
        let ByName { names, of } = ByName::new(runs.clone().map(|(name, _)| name));
        let runs = runs.map(|(_, end)| end).zip(of).collect();
        Self { names: names.into(), runs }
    }

    /// The index of the name of each item.
    pub(crate) fn of(&self, items: Range<u32>) -> impl Iterator<Item = i32> + use<> {
        let runs = Arc::clone(&self.runs);
        let mut run = runs.partition_point(|&(end, _)| end <= items.start);
        items.map(move |item| {
            while runs.get(run).is_some_and(|&(end, _)| end <= item) {
                run += 1;
            }
            runs.get(run).map_or(0, |&(_, name)| name as i32)
        })
    }
}
