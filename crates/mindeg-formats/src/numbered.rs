//! Vertices and elements as solvers' files have them: each vertex with a number of its own, and
//! elements that name vertices by these, before or after them.

use crate::ReadError;
use crate::face_list::FaceList;
use crate::lists::push;
use glam::DVec3;
use mindeg_mesh::{Group, Line, LineKind, NonTriangles, TriMesh};
use std::collections::TryReserveError;

/// The contents of the lines read so far.
#[derive(Default)]
pub(crate) struct Numbered {
    ids: Vec<u32>,
    positions: Vec<DVec3>,
    elements: Vec<Element>,
    segments: Vec<[Named; 2]>,
    lines: Vec<Line>,
    kinds: Vec<Option<LineKind>>,
    /// The files that have the elements and the segments, where they are several.
    files: Option<[&'static str; 2]>,
}

/// A triangle or a quadrilateral.
struct Element {
    line: u64,
    corners: [u32; 4],
    is_quad: bool,
    /// The number of its material, zone or the like.
    material: i64,
}

/// The number of a vertex, and the line that names it.
type Named = (u32, u64);

impl Numbered {
    /// The contents of several files: the elements are in the first, the segments in the second.
    pub(crate) fn of_files(files: [&'static str; 2]) -> Self {
        Self { files: Some(files), ..Self::default() }
    }

    pub(crate) fn vertex(&mut self, id: u32, position: DVec3) -> Result<(), TryReserveError> {
        push(&mut self.ids, id)?;
        push(&mut self.positions, position)
    }

    /// Adds an element of three or four corners, which a line of the file has.
    pub(crate) fn element(
        &mut self,
        line: u64,
        corners: &[u32],
        material: i64,
    ) -> Result<(), TryReserveError> {
        let mut four = [0; 4];
        four[..corners.len()].copy_from_slice(corners);
        let is_quad = corners.len() == 4;
        push(&mut self.elements, Element { line, corners: four, is_quad, material })
    }

    /// Adds segments, each from a vertex to the next, to a line of the mesh: to the last one, if that
    /// has this name and kind, else to a new one.
    pub(crate) fn string(
        &mut self,
        name: &str,
        kind: Option<LineKind>,
        vertices: impl IntoIterator<Item = Named>,
    ) -> Result<(), TryReserveError> {
        // More segments than 32 bits count would take more vertices than are read.
        let start = self.segments.len() as u32;
        let mut vertices = vertices.into_iter();
        let Some(mut before) = vertices.next() else { return Ok(()) };
        for vertex in vertices {
            push(&mut self.segments, [before, vertex])?;
            before = vertex;
        }
        let end = self.segments.len() as u32;
        match self.lines.last_mut() {
            Some(line) if line.name == name && self.kinds.last() == Some(&kind) => {
                line.segments.end = end;
            }
            _ if start < end => {
                let name = name.to_owned();
                push(&mut self.lines, Line { name, segments: start..end, is_straight: false })?;
                push(&mut self.kinds, kind)?;
            }
            _ => {}
        }
        Ok(())
    }

    /// The mesh; materials, if there are several, become groups named `material` and their number.
    pub(crate) fn into_mesh(self, material: &str) -> Result<TriMesh, ReadError> {
        let ids = Ids::new(self.ids)?;
        let within = |error: ReadError, file: usize| match self.files {
            Some(files) => error.within(files[file]),
            None => error,
        };
        let mut faces = FaceList::default();
        let mut groups: Vec<(i64, Group)> = Vec::new();
        for element in &self.elements {
            let mut corners = [0; 4];
            let count = if element.is_quad { 4 } else { 3 };
            for (corner, &id) in corners.iter_mut().zip(&element.corners[..count]) {
                *corner = ids.index(id, element.line).map_err(|error| within(error, 0))?;
            }
            let start = faces.triangle_count() as u32;
            faces.push(&corners[..count])?;
            let end = faces.triangle_count() as u32;
            match groups.last_mut() {
                Some((number, group)) if *number == element.material => group.triangles.end = end,
                _ => {
                    let name = format!("{material} {}", element.material);
                    push(&mut groups, (element.material, Group::new(name, start..end)))?;
                }
            }
        }
        let mut segments = Vec::new();
        segments.try_reserve_exact(self.segments.len())?;
        for ends in self.segments {
            let [a, b] = ends.map(|(id, line)| ids.index(id, line));
            let within = |error| within(error, 1);
            segments.push([a.map_err(within)?, b.map_err(within)?]);
        }
        let counts =
            NonTriangles { line_segments: segments.len() as u64, ..NonTriangles::default() };
        let mesh = faces.into_mesh(self.positions, counts)?.with_lines(self.lines, segments)?;
        let mesh = mesh.with_line_kinds(self.kinds);
        let mut numbers: Vec<_> = groups.iter().map(|(number, _)| *number).collect();
        numbers.sort_unstable();
        numbers.dedup();
        Ok(match groups.len() {
            0 | 1 => mesh,
            count if count == numbers.len() => {
                mesh.with_groups(groups.into_iter().map(|(_, group)| group).collect())
            }
            _ => {
                let note = format!(
                    "{} {material}s, whose triangles do not follow one another, are not kept",
                    numbers.len()
                );
                mesh.with_notes(vec![note])
            }
        })
    }
}

/// Which vertex has which number.
enum Ids {
    /// Numbers that follow one another.
    InOrder { first: u32, count: u32 },
    /// Number and index, in the order of numbers.
    Sorted(Vec<(u32, u32)>),
}

impl Ids {
    fn new(ids: Vec<u32>) -> Result<Self, ReadError> {
        let first = ids.first().copied().unwrap_or(0);
        if ids.iter().zip(u64::from(first)..).all(|(&id, expected)| u64::from(id) == expected) {
            return Ok(Self::InOrder { first, count: ids.len() as u32 });
        }
        let mut sorted = Vec::new();
        sorted.try_reserve_exact(ids.len())?;
        sorted.extend(ids.into_iter().zip(0..));
        sorted.sort_unstable();
        if let Some(twice) = sorted.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            let problem = format!(
                "is the number of two vertices, {} and {} (counted from 0)",
                twice[0].1, twice[1].1
            );
            return Err(ReadError::place(twice[0].0.to_string(), problem));
        }
        Ok(Self::Sorted(sorted))
    }

    /// The index of the vertex with a number, which a line names.
    fn index(&self, id: u32, line: u64) -> Result<u32, ReadError> {
        let index = match self {
            Self::InOrder { first, count } => id.checked_sub(*first).filter(|index| index < count),
            Self::Sorted(sorted) => {
                let found = sorted.binary_search_by_key(&id, |&(id, _)| id);
                found.ok().map(|found| sorted[found].1)
            }
        };
        index.ok_or_else(|| {
            let numbers = match self {
                Self::InOrder { first, count } if *count > 0 => {
                    format!(
                        "; the file has {first} to {}",
                        u64::from(*first) + u64::from(*count) - 1
                    )
                }
                _ => String::new(),
            };
            ReadError::line(line, format!("vertex {id} does not exist{numbers}"))
        })
    }
}
