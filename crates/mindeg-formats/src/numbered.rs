//! Vertices and elements as solvers' files have them: each vertex with a number of its own, and
//! elements that name vertices by these, before or after them.

use crate::ReadError;
use crate::face_list::FaceList;
use crate::lists::push;
use crate::runs::Runs;
use glam::DVec3;
use mindeg_mesh::{Line, LineKind, NonTriangles, TriMesh};
use std::collections::TryReserveError;

/// Vertices, each with a number of its own.
#[derive(Default)]
pub(crate) struct Nodes {
    pub(crate) positions: Vec<DVec3>,
    count: u32,
    /// The number of the first vertex.
    first: u64,
    /// Number and index of every vertex, in the order of numbers, unless they count up from the first.
    numbers: Option<Vec<(u64, u32)>>,
}

/// The number of a vertex, and the line that names it.
pub(crate) type Named = (u32, u64);

impl Nodes {
    pub(crate) fn push(&mut self, number: u64, position: DVec3) -> Result<(), TryReserveError> {
        self.push_number(number)?;
        push(&mut self.positions, position)
    }

    /// Adds a vertex whose position follows.
    pub(crate) fn push_number(&mut self, number: u64) -> Result<(), TryReserveError> {
        if self.count == 0 {
            self.first = number;
        }
        let index = self.count;
        let counts_up = number.checked_sub(self.first) == Some(index.into());
        if !counts_up && self.numbers.is_none() {
            let mut numbers = Vec::new();
            numbers.try_reserve(index as usize + 1)?;
            numbers.extend((0..index).map(|index| (self.first + u64::from(index), index)));
            self.numbers = Some(numbers);
        }
        if let Some(numbers) = &mut self.numbers {
            push(numbers, (number, index))?;
        }
        // More than 32 bits count are refused with the positions.
        self.count = index.saturating_add(1);
        Ok(())
    }

    /// Makes the vertices ready to be found.
    pub(crate) fn sort(&mut self) -> Result<(), ReadError> {
        let Some(numbers) = &mut self.numbers else { return Ok(()) };
        numbers.sort_unstable();
        let Some(pair) = numbers.windows(2).find(|pair| pair[0].0 == pair[1].0) else {
            return Ok(());
        };
        let [(number, first), (_, second)] = [pair[0], pair[1]];
        let problem = format!(
            "two vertices, {first} and {second} (counted from 0), have the number {number}"
        );
        Err(ReadError::place("", problem))
    }

    /// The index of the vertex with a number.
    pub(crate) fn index(&self, number: u64) -> Option<u32> {
        match &self.numbers {
            None => {
                let index = u32::try_from(number.checked_sub(self.first)?).ok()?;
                (index < self.count).then_some(index)
            }
            Some(numbers) => {
                let found = numbers.binary_search_by_key(&number, |&(number, _)| number).ok()?;
                Some(numbers[found].1)
            }
        }
    }

    /// The index of the vertex that a line names.
    pub(crate) fn named(&self, (number, line): Named) -> Result<u32, ReadError> {
        self.index(number.into()).ok_or_else(|| {
            let known = match self.numbers {
                None if self.count > 0 => {
                    let last = self.first + u64::from(self.count) - 1;
                    format!("; the file has {} to {last}", self.first)
                }
                _ => String::new(),
            };
            ReadError::line(line, format!("vertex {number} does not exist{known}"))
        })
    }
}

/// The contents of the lines read so far.
#[derive(Default)]
pub(crate) struct Numbered {
    pub(crate) nodes: Nodes,
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

impl Numbered {
    /// The contents of several files: the elements are in the first, the segments in the second.
    pub(crate) fn of_files(files: [&'static str; 2]) -> Self {
        Self { files: Some(files), ..Self::default() }
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
    pub(crate) fn into_mesh(mut self, material: &str) -> Result<TriMesh, ReadError> {
        self.nodes.sort()?;
        let within = |error: ReadError, file: usize| match self.files {
            Some(files) => error.within(files[file]),
            None => error,
        };
        let mut faces = FaceList::default();
        let mut groups = Runs::default();
        for element in &self.elements {
            let mut corners = [0; 4];
            let count = if element.is_quad { 4 } else { 3 };
            for (corner, &id) in corners.iter_mut().zip(&element.corners[..count]) {
                let found = self.nodes.named((id, element.line));
                *corner = found.map_err(|error| within(error, 0))?;
            }
            faces.push(&corners[..count])?;
            let name = || format!("{material} {}", element.material);
            groups.push(element.material, faces.triangle_count(), name)?;
        }
        let mut segments = Vec::new();
        segments.try_reserve_exact(self.segments.len())?;
        for ends in self.segments {
            let [a, b] = ends.map(|end| self.nodes.named(end));
            let within = |error| within(error, 1);
            segments.push([a.map_err(within)?, b.map_err(within)?]);
        }
        let counts =
            NonTriangles { line_segments: segments.len() as u64, ..NonTriangles::default() };
        let mesh = faces.into_mesh(self.nodes.positions, counts)?;
        let mesh = mesh.with_lines(self.lines, segments)?.with_line_kinds(self.kinds);
        let (mesh, note) = groups.unless_one().give_to(mesh, &format!("{material}s"));
        Ok(mesh.with_notes(note.into_iter().collect()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vertices_are_found_by_any_numbers() {
        for numbers in [&[1, 2, 3, 4][..], &[0, 1], &[7, 8, 12, 9], &[5, 3], &[u64::MAX, 0, 1]] {
            let mut nodes = Nodes::default();
            numbers.iter().for_each(|&number| nodes.push_number(number).unwrap());
            nodes.sort().unwrap();
            for (&number, index) in numbers.iter().zip(0..) {
                assert_eq!(nodes.index(number), Some(index), "{numbers:?}");
            }
            assert_eq!(nodes.index(99), None);
            assert_eq!(nodes.index(13), None);
        }
        let mut nodes = Nodes::default();
        [4, 5, 4].iter().for_each(|&number| nodes.push_number(number).unwrap());
        let problem = "two vertices, 0 and 2 (counted from 0), have the number 4";
        assert_eq!(nodes.sort().unwrap_err().to_string(), problem);
    }
}
