//! Named runs of triangles and segments, as a file has them one after the other.

use std::collections::{HashMap, TryReserveError};

use glam::DVec3;
use mindeg_mesh::{Group, Line, TriMesh, TriMeshError};

use crate::lists::push;

/// The lines of a file, whether or not it has faces.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Polylines {
    /// All points of the file.
    pub positions: Vec<DVec3>,
    /// The segments of all lines.
    pub segments: Vec<[u32; 2]>,
    /// The runs of segments; those without a name have an empty one.
    pub lines: Vec<Line>,
    /// How many faces and volumes the file has besides.
    pub others: u64,
}

/// Segments in the order of a file, with what each belongs to: a curve, a side, a part.
#[derive(Default)]
pub(crate) struct Segments {
    segments: Vec<[u32; 2]>,
    /// Each run: what it belongs to, its name, and the end of its segments.
    runs: Vec<(i64, String, u32)>,
}

impl Segments {
    /// Adds a segment of the thing with a number. O(1); `name` is asked at the start of a run.
    pub(crate) fn push(
        &mut self,
        of: i64,
        segment: [u32; 2],
        name: impl FnOnce() -> String,
    ) -> Result<(), TryReserveError> {
        push(&mut self.segments, segment)?;
        let end = self.segments.len() as u32;
        match self.runs.last_mut() {
            Some((last, _, last_end)) if *last == of => *last_end = end,
            _ => push(&mut self.runs, (of, name(), end))?,
        }
        Ok(())
    }

    pub(crate) fn count(&self) -> usize {
        self.segments.len()
    }

    /// The mesh with a line for each thing, in the order in which they first come.
    pub(crate) fn give_to(self, mesh: TriMesh) -> Result<TriMesh, TriMeshError> {
        let (lines, segments) = self.into_lines();
        mesh.with_lines(lines, segments)
    }

    /// A line for each thing, in the order in which they first come, and all segments.
    pub(crate) fn into_lines(self) -> (Vec<Line>, Vec<[u32; 2]>) {
        let Self { mut segments, mut runs } = self;
        let mut order = HashMap::new();
        for (of, _, _) in &runs {
            let next = order.len();
            order.entry(*of).or_insert(next);
        }
        if order.len() < runs.len() {
            // Some come again: those of each are put together, in the order of the file.
            let mut starts = 0;
            let mut parts: Vec<Vec<[u32; 2]>> = vec![Vec::new(); order.len()];
            let mut names: Vec<(i64, String, u32)> = Vec::new();
            for (of, name, end) in runs {
                let part = order[&of];
                parts[part].extend_from_slice(&segments[starts as usize..end as usize]);
                if part == names.len() {
                    names.push((of, name, 0));
                }
                starts = end;
            }
            let mut end = 0;
            for (part, name) in parts.iter().zip(&mut names) {
                end += part.len() as u32;
                name.2 = end;
            }
            segments = parts.concat();
            runs = names;
        }
        let mut start = 0;
        let line = |(_, name, end): (i64, String, u32)| {
            let segments = start..end;
            start = end;
            Line { name, segments, is_straight: false }
        };
        (runs.into_iter().map(line).collect(), segments)
    }
}

/// Runs of triangles in the order of a file, with what each belongs to.
#[derive(Default)]
pub(crate) struct TriangleRuns {
    /// The owner of a run, its name, and the end of its triangles.
    runs: Vec<(i64, String, u32)>,
}

impl TriangleRuns {
    /// The triangles up to `end` belong to the thing with a number. `name` is asked at the start of a
    /// run.
    pub(crate) fn push(
        &mut self,
        of: i64,
        end: usize,
        name: impl FnOnce() -> String,
    ) -> Result<(), TryReserveError> {
        let end = end as u32;
        match self.runs.last_mut() {
            Some((last, _, last_end)) if *last == of => *last_end = end,
            _ => push(&mut self.runs, (of, name(), end))?,
        }
        Ok(())
    }

    /// No runs, if all triangles are in one.
    pub(crate) fn unless_one(self) -> Self {
        if self.runs.len() > 1 { self } else { Self::default() }
    }

    /// The mesh with a group for each thing; in one piece, with a note, if the triangles of one
    /// thing, a `what`, do not follow one another.
    pub(crate) fn give_to(self, mesh: TriMesh, what: &str) -> (TriMesh, Option<String>) {
        let mut things: Vec<_> = self.runs.iter().map(|run| run.0).collect();
        things.sort_unstable();
        things.dedup();
        let has_names = self.runs.iter().any(|(_, name, _)| !name.is_empty());
        if self.runs.is_empty() || !has_names {
            return (mesh, None);
        }
        if things.len() < self.runs.len() {
            let note = format!(
                "the triangles of {} {what} do not follow one another; their names are not kept",
                things.len()
            );
            return (mesh, Some(note));
        }
        let mut start = 0;
        let group = |(_, name, end): (i64, String, u32)| {
            let triangles = start..end;
            start = end;
            Group::new(name, triangles)
        };
        (mesh.with_groups(self.runs.into_iter().map(group).collect()), None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use mindeg_mesh::Triangles;

    fn square() -> TriMesh {
        let points = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
        TriMesh::new(points, vec![[0, 1, 2], [0, 2, 3]]).unwrap()
    }

    #[test]
    fn segments_of_one_thing_are_put_together() {
        let mut segments = Segments::default();
        for (of, segment) in [(7, [0, 1]), (7, [1, 2]), (5, [2, 3]), (7, [3, 0])] {
            segments.push(of, segment, || format!("side {of}")).unwrap();
        }
        let mesh = segments.give_to(square()).unwrap();
        assert_eq!(mesh.segments(), [[0, 1], [1, 2], [3, 0], [2, 3]]);
        let lines: Vec<_> =
            mesh.lines().iter().map(|line| (line.name.clone(), line.segments.clone())).collect();
        assert_eq!(lines, [("side 7".to_owned(), 0..3), ("side 5".to_owned(), 3..4)]);
    }

    #[test]
    fn groups_are_kept_where_they_follow_one_another() {
        let runs = |of: [i64; 2]| {
            let mut runs = TriangleRuns::default();
            for (of, end) in of.into_iter().zip(1..) {
                runs.push(of, end, || format!("{of}")).unwrap();
            }
            runs.give_to(square(), "parts")
        };
        let (mesh, note) = runs([4, 2]);
        let groups: Vec<_> = mesh.groups().iter().map(|group| group.triangles.clone()).collect();
        assert_eq!((groups, note), (vec![0..1, 1..2], None));
        let mut again = TriangleRuns::default();
        for (of, end) in [(1, 1), (2, 2), (1, 3)] {
            again.push(of, end, || "a".to_owned()).unwrap();
        }
        let (_, note) = again.give_to(square(), "parts");
        assert!(note.unwrap().starts_with("the triangles of 2 parts do not follow"));
    }
}
