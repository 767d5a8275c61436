//! The elements of a file in its order, and the named runs of triangles and segments.

use std::collections::{HashMap, HashSet, TryReserveError};
use std::ops::Range;

use glam::DVec3;
use mindeg_mesh::{Group, Line, NamedVertex, NonTriangles, PeriodicLine, TriMesh};

use crate::ReadError;
use crate::face_list::FaceList;
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
    /// The surfaces that the file says the lines bound.
    pub surfaces: Vec<PlaneSurface>,
    /// The lines that are others, moved.
    pub periodic: Vec<PeriodicLine>,
    /// The points that the file lists by themselves; those without a name have an empty one.
    pub points: Vec<NamedVertex>,
    /// The names of groups that lack what another group has, too: it is in one alone.
    pub left_groups: Vec<String>,
    /// How many faces and volumes the file has besides.
    pub others: u64,
    /// Whether edges of higher order were taken by their ends.
    pub are_straightened: bool,
}

/// A surface of a file by the edges around it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlaneSurface {
    /// The name of its physical group; empty if it has none.
    pub name: String,
    /// The edges between it and what lies beside it, in any order and direction.
    pub edges: Vec<[u32; 2]>,
}

/// The elements of a file so far, in its order.
#[derive(Default)]
pub(crate) struct Elements {
    pub(crate) faces: FaceList,
    /// The runs of faces: a group, a surface.
    pub(crate) groups: Runs,
    pub(crate) segments: Segments,
    pub(crate) points: u64,
    pub(crate) volumes: u64,
    /// Whether edges or faces of higher order were taken by their corners.
    pub(crate) are_straightened: bool,
}

impl Elements {
    /// The mesh of these elements, with a group for each `thing` and a note of volumes, which are called
    /// `volumes`.
    pub(crate) fn into_mesh(
        self,
        positions: Vec<DVec3>,
        things: &str,
        volumes: &str,
    ) -> Result<TriMesh, ReadError> {
        let Self { faces, groups, segments, points, volumes: count, are_straightened } = self;
        let line_segments = segments.segments.len() as u64;
        let counts = NonTriangles { line_segments, points, ..NonTriangles::default() };
        let (lines, segments) = segments.into_lines();
        let mesh = faces.into_mesh(positions, counts)?.with_lines(lines, segments)?;
        let (mesh, note) = groups.give_to(mesh, things);
        let volumes = (count > 0).then(|| format!("{count} {volumes}"));
        let mesh = match are_straightened {
            true => mesh.with_dropped(vec!["the curved edges of elements of higher order"]),
            false => mesh,
        };
        Ok(mesh.with_notes(note.into_iter().chain(volumes).collect()))
    }

    /// The lines alone, and how much there is besides.
    pub(crate) fn into_polylines(self, positions: Vec<DVec3>) -> Polylines {
        let others = self.faces.face_count() + self.volumes;
        let (lines, segments) = self.segments.into_lines();
        let are_straightened = self.are_straightened;
        Polylines { positions, segments, lines, others, are_straightened, ..Polylines::default() }
    }
}

/// Segments in the order of a file, with what each belongs to: a curve, a side, a group.
#[derive(Default)]
pub(crate) struct Segments {
    segments: Vec<[u32; 2]>,
    runs: Runs,
}

impl Segments {
    /// Adds a segment of the thing with a number. O(1); `name` is called at the start of a run.
    pub(crate) fn push(
        &mut self,
        of: i64,
        segment: [u32; 2],
        name: impl FnOnce() -> String,
    ) -> Result<(), TryReserveError> {
        push(&mut self.segments, segment)?;
        self.runs.push(of, self.segments.len(), name)
    }

    /// The segments of each thing.
    pub(crate) fn by_thing(&self) -> HashMap<i64, Vec<[u32; 2]>> {
        let mut found: HashMap<i64, Vec<[u32; 2]>> = HashMap::new();
        let mut start = 0;
        for (of, _, end) in &self.runs.0 {
            let own = &self.segments[start..*end as usize];
            found.entry(*of).or_default().extend_from_slice(own);
            start = *end as usize;
        }
        found
    }

    /// The index of the line of each thing.
    pub(crate) fn line_of_thing(&self) -> HashMap<i64, u32> {
        let mut indices = HashMap::new();
        for (of, ..) in &self.runs.0 {
            let next = indices.len() as u32;
            indices.entry(*of).or_insert(next);
        }
        indices
    }

    /// A line for each thing, in the order in which they first come, and all segments.
    pub(crate) fn into_lines(self) -> (Vec<Line>, Vec<[u32; 2]>) {
        let mut indices = HashMap::new();
        let mut things: Vec<(String, Vec<[u32; 2]>)> = Vec::new();
        for (of, name, range) in self.runs.ranges() {
            let index = *indices.entry(of).or_insert(things.len());
            if index == things.len() {
                things.push((name, Vec::new()));
            }
            let range = range.start as usize..range.end as usize;
            things[index].1.extend_from_slice(&self.segments[range]);
        }
        let (mut lines, mut segments) = (Vec::new(), Vec::with_capacity(self.segments.len()));
        for (name, of_thing) in things {
            let start = segments.len() as u32;
            segments.extend(of_thing);
            let range = start..segments.len() as u32;
            lines.push(Line { name, segments: range, is_straight: false });
        }
        (lines, segments)
    }
}

/// Runs of items in the order of a file: the number of the thing that each belongs to, its name, and its
/// end.
#[derive(Default)]
pub(crate) struct Runs(Vec<(i64, String, u32)>);

impl Runs {
    /// The items up to `end` belong to the thing with a number. `name` is called at the start of a run.
    pub(crate) fn push(
        &mut self,
        of: i64,
        end: usize,
        name: impl FnOnce() -> String,
    ) -> Result<(), TryReserveError> {
        // More items than 32 bits count are refused at the end.
        let end = end as u32;
        match self.0.last_mut() {
            Some((last, _, last_end)) if *last == of => *last_end = end,
            _ => push(&mut self.0, (of, name(), end))?,
        }
        Ok(())
    }

    fn ranges(self) -> impl Iterator<Item = (i64, String, Range<u32>)> {
        let mut start = 0;
        self.0
            .into_iter()
            .map(move |(of, name, end)| (of, name, std::mem::replace(&mut start, end)..end))
    }

    /// No runs, if all triangles are in one.
    pub(crate) fn unless_one(self) -> Self {
        if self.0.len() > 1 { self } else { Self::default() }
    }

    /// The mesh with a group for each thing; in one piece, with a note, if the triangles of one
    /// thing, one of `things`, do not follow one another.
    pub(crate) fn give_to(self, mesh: TriMesh, things: &str) -> (TriMesh, Option<String>) {
        let count = self.0.iter().map(|run| run.0).collect::<HashSet<_>>().len();
        if self.0.iter().all(|(_, name, _)| name.is_empty()) {
            return (mesh, None);
        }
        if count < self.0.len() {
            let note = format!(
                "the triangles of {count} {things} do not follow one another; their names are not kept"
            );
            return (mesh, Some(note));
        }
        let groups = self.ranges().map(|(_, name, triangles)| Group::new(name, triangles));
        (mesh.with_groups(groups.collect()), None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let (lines, segments) = segments.into_lines();
        assert_eq!(segments, [[0, 1], [1, 2], [3, 0], [2, 3]]);
        let lines: Vec<_> = lines.into_iter().map(|line| (line.name, line.segments)).collect();
        assert_eq!(lines, [("side 7".to_owned(), 0..3), ("side 5".to_owned(), 3..4)]);
    }

    #[test]
    fn groups_are_kept_where_they_follow_one_another() {
        let runs = |of: [i64; 2]| {
            let mut runs = Runs::default();
            for (of, end) in of.into_iter().zip(1..) {
                runs.push(of, end, || format!("{of}")).unwrap();
            }
            runs.give_to(square(), "parts")
        };
        let (mesh, note) = runs([4, 2]);
        let groups: Vec<_> = mesh.groups().iter().map(|group| group.triangles.clone()).collect();
        assert_eq!((groups, note), (vec![0..1, 1..2], None));
        let mut again = Runs::default();
        for (of, end) in [(1, 1), (2, 2), (1, 3)] {
            again.push(of, end, || "a".to_owned()).unwrap();
        }
        let (_, note) = again.give_to(square(), "parts");
        assert!(note.unwrap().starts_with("the triangles of 2 parts do not follow"));
    }
}
