//! The arrays of a grid.

use std::ops::Range;

use mindeg_mesh::Mesh;

use crate::corners::{degrees, min_angles, positions, segments, triangles};
use crate::names::one_line;
use crate::numbers::{Number, Numbers};
use crate::sections::Section;
use crate::tables::NamedRuns;

/// VTK's numbers of the cells that are written.
const LINE: u8 = 3;
const TRIANGLE: u8 = 5;

/// The best minimum angle, which segments have: those who want a minimum are not to find it there.
const EQUILATERAL: f64 = 60.0;

/// The arrays of a mesh as a grid, each a list of sections.
pub(crate) struct Arrays<'a> {
    mesh: &'a dyn Mesh,
    numbers: Numbers,
    triangles: Range<u32>,
    /// The mesh's segments that are cells.
    segments: Range<u32>,
}

/// A number for each point or cell.
pub(crate) struct Field<'a> {
    pub(crate) name: &'static str,
    /// Whether the numbers are f64; else i32.
    pub(crate) is_float: bool,
    pub(crate) sections: Vec<Section<'a>>,
}

impl<'a> Arrays<'a> {
    /// The arrays of a mesh, its segments among the cells if wanted.
    pub(crate) fn new(mesh: &'a dyn Mesh, numbers: Numbers, has_segments: bool) -> Self {
        let all = mesh.lines().last().map_or(0, |line| line.segments.end);
        let segments = 0..if has_segments { all } else { 0 };
        Self { mesh, numbers, triangles: 0..mesh.triangle_count(), segments }
    }

    pub(crate) fn cell_count(&self) -> u64 {
        self.triangles.len() as u64 + self.segments.len() as u64
    }

    /// The number of corners of all cells.
    pub(crate) fn corner_count(&self) -> u64 {
        3 * self.triangles.len() as u64 + 2 * self.segments.len() as u64
    }

    /// Three f64 for each vertex.
    pub(crate) fn points(&self) -> Vec<Section<'a>> {
        let mesh = self.mesh;
        let points = move |range| positions(mesh, range).map(|p| p.to_array());
        vec![self.numbers.records(0..mesh.vertex_count(), points)]
    }

    /// The corners of each cell, i64.
    pub(crate) fn connectivity(&self) -> Vec<Section<'a>> {
        let mesh = self.mesh;
        let of_triangles =
            move |range| triangles(mesh, range).into_iter().map(|corners| corners.map(i64::from));
        let of_segments =
            move |range| segments(mesh, range).into_iter().map(|corners| corners.map(i64::from));
        vec![
            self.numbers.records(self.triangles.clone(), of_triangles),
            self.numbers.records(self.segments.clone(), of_segments),
        ]
    }

    /// Where the corners of each cell end, i64.
    pub(crate) fn offsets(&self) -> Vec<Section<'a>> {
        let ends = |start: i64, corners: i64| {
            move |range: Range<u32>| {
                range.map(move |index| [start + corners * (i64::from(index) + 1)])
            }
        };
        let corners = 3 * self.triangles.len() as i64;
        vec![
            self.numbers.records(self.triangles.clone(), ends(0, 3)),
            self.numbers.records(self.segments.clone(), ends(corners, 2)),
        ]
    }

    /// The type of each cell.
    pub(crate) fn types<T: Number + From<u8>>(&self) -> Vec<Section<'a>> {
        let counts = [(self.triangles.end, TRIANGLE), (self.segments.end, LINE)];
        counts.map(|(count, kind)| self.numbers.repeated(count, [T::from(kind)])).into()
    }

    /// For each cell the number of its corners and the corners, i32.
    pub(crate) fn counted_cells(&self) -> Vec<Section<'a>> {
        let mesh = self.mesh;
        // Legacy VTK has no more vertices than 31 bits tell apart.
        let of_triangles = move |range| {
            let corners = triangles(mesh, range).into_iter();
            corners.map(|[a, b, c]| [3, a as i32, b as i32, c as i32])
        };
        let of_segments =
            move |range| segments(mesh, range).into_iter().map(|[a, b]| [2, a as i32, b as i32]);
        vec![
            self.numbers.records(self.triangles.clone(), of_triangles),
            self.numbers.records(self.segments.clone(), of_segments),
        ]
    }

    /// The degree of each vertex.
    pub(crate) fn degrees(&self) -> Field<'a> {
        let mesh = self.mesh;
        // A degree is less than the number of vertices.
        let degrees = move |range| degrees(mesh, range).into_iter().map(|degree| [degree as i32]);
        let sections = vec![self.numbers.records(0..mesh.vertex_count(), degrees)];
        Field { name: "degree", is_float: false, sections }
    }

    /// The minimum angle of each cell in degrees; the index of the name of each segment's side, and of each
    /// triangle's group, if there are several, -1 for the other cells.
    pub(crate) fn of_cells(&self) -> Vec<Field<'a>> {
        let mesh = self.mesh;
        let angles = move |range| min_angles(mesh, range).map(|angle| [angle]);
        let angles = self.numbers.records(self.triangles.clone(), angles);
        let of_segments = self.numbers.repeated(self.segments.end, [EQUILATERAL]);
        let sections = vec![angles, of_segments];
        let mut fields = vec![Field { name: "min_angle", is_float: true, sections }];
        let [no_side, no_group] = [self.triangles.end, self.segments.end]
            .map(|count| self.numbers.repeated(count, [-1_i32]));
        let indices = |items: Range<u32>, runs: NamedRuns| {
            self.numbers.records(items, move |range| runs.of(range).map(|index| [index]))
        };
        if !self.segments.is_empty() {
            let sections = vec![no_side, indices(self.segments.clone(), NamedRuns::of_lines(mesh))];
            fields.push(Field { name: "side", is_float: false, sections });
        }
        let groups = NamedRuns::of_groups(mesh);
        if groups.names.len() > 1 {
            let sections = vec![indices(self.triangles.clone(), groups), no_group];
            fields.push(Field { name: "group", is_float: false, sections });
        }
        fields
    }
}

/// Names, each ended by a zero, as numbers of 8 bits.
pub(crate) fn text_of_names(names: &[String], numbers: Numbers) -> (Vec<u8>, usize) {
    let ended = |name: &String| one_line(name).into_bytes().into_iter().chain([0]);
    let bytes: Vec<u8> = names.iter().flat_map(ended).collect();
    let mut text = Vec::new();
    for &byte in &bytes {
        numbers.put([byte], &mut text);
        numbers.end_line(&mut text);
    }
    (text, bytes.len())
}
