//! The arrays of a grid.

use std::ops::Range;

use mindeg_mesh::Mesh;

use crate::corners::{degrees, min_angles, positions, segments, triangles};
use crate::names::one_line;
use crate::scanner::Numbers;
use crate::sections::Section;

/// VTK's numbers of the cells that are written.
const LINE: u8 = 3;
const TRIANGLE: u8 = 5;

/// The best minimum angle, which segments have: those who want a minimum are not to find it there.
const EQUILATERAL: f64 = 60.0;

/// The arrays of a mesh as a grid, each a list of sections.
pub(crate) struct Arrays<'a> {
    mesh: &'a dyn Mesh,
    numbers: Numbers,
    /// How many of the mesh's segments are cells.
    pub(crate) segments: u32,
}

impl<'a> Arrays<'a> {
    /// The arrays of a mesh, its segments among the cells if wanted.
    pub(crate) fn new(mesh: &'a dyn Mesh, numbers: Numbers, has_segments: bool) -> Self {
        let all = mesh.lines().last().map_or(0, |line| line.segments.end);
        Self { mesh, numbers, segments: if has_segments { all } else { 0 } }
    }

    pub(crate) fn vertex_count(&self) -> u64 {
        self.mesh.vertex_count().into()
    }

    pub(crate) fn cell_count(&self) -> u64 {
        u64::from(self.mesh.triangle_count()) + u64::from(self.segments)
    }

    /// The number of corners of all cells.
    pub(crate) fn corner_count(&self) -> u64 {
        3 * u64::from(self.mesh.triangle_count()) + 2 * u64::from(self.segments)
    }

    /// Three f64 for each vertex.
    pub(crate) fn points(&self) -> Section<'a> {
        let mesh = self.mesh;
        self.records(mesh.vertex_count(), move |range| positions(mesh, range).map(|p| p.to_array()))
    }

    /// The corners of each cell, i64.
    pub(crate) fn connectivity(&self) -> Vec<Section<'a>> {
        let mesh = self.mesh;
        let cells = self.records(mesh.triangle_count(), move |range| {
            triangles(mesh, range).into_iter().map(|corners| corners.map(i64::from))
        });
        let lines = self.records(self.segments, move |range| {
            segments(mesh, range).into_iter().map(|corners| corners.map(i64::from))
        });
        vec![cells, lines]
    }

    /// Where the corners of each cell end, i64.
    pub(crate) fn offsets(&self) -> Vec<Section<'a>> {
        let triangles = i64::from(self.mesh.triangle_count());
        let of_triangles = self.records(self.mesh.triangle_count(), |range| {
            range.map(|index| [3 * (i64::from(index) + 1)])
        });
        let of_segments = self.records(self.segments, move |range| {
            range.map(move |index| [3 * triangles + 2 * (i64::from(index) + 1)])
        });
        vec![of_triangles, of_segments]
    }

    /// The kind of each cell, u8.
    pub(crate) fn types(&self) -> Vec<Section<'a>> {
        vec![
            self.repeated(self.mesh.triangle_count(), TRIANGLE),
            self.repeated(self.segments, LINE),
        ]
    }

    /// For each cell the number of its corners and the corners, i32.
    pub(crate) fn counted_cells(&self) -> Vec<Section<'a>> {
        let mesh = self.mesh;
        // Legacy VTK has no more vertices than 31 bits tell apart.
        let cells = self.records(mesh.triangle_count(), move |range| {
            let corners = triangles(mesh, range).into_iter();
            corners.map(|[a, b, c]| [3, a as i32, b as i32, c as i32])
        });
        let lines = self.records(self.segments, move |range| {
            segments(mesh, range).into_iter().map(|[a, b]| [2, a as i32, b as i32])
        });
        vec![cells, lines]
    }

    /// The kind of each cell, i32.
    pub(crate) fn wide_types(&self) -> Vec<Section<'a>> {
        vec![
            self.repeated(self.mesh.triangle_count(), i32::from(TRIANGLE)),
            self.repeated(self.segments, i32::from(LINE)),
        ]
    }

    /// The degree of each vertex, i32.
    pub(crate) fn degrees(&self) -> Section<'a> {
        let mesh = self.mesh;
        self.records(mesh.vertex_count(), move |range| {
            // A degree is less than the number of vertices.
            degrees(mesh, range).into_iter().map(|degree| [degree as i32])
        })
    }

    /// The minimum angle of each cell in degrees, f64.
    pub(crate) fn min_angles(&self) -> Vec<Section<'a>> {
        let mesh = self.mesh;
        let of_triangles = self.records(mesh.triangle_count(), move |range| {
            min_angles(mesh, range).map(|angle| [angle])
        });
        vec![of_triangles, self.repeated(self.segments, EQUILATERAL)]
    }

    /// The side of each segment, i32; -1 for a triangle.
    pub(crate) fn sides(&self) -> Vec<Section<'a>> {
        let ends: Vec<u32> = self.mesh.lines().iter().map(|line| line.segments.end).collect();
        let of_segments = self.indices_of(self.segments, ends);
        vec![self.repeated(self.mesh.triangle_count(), -1_i32), of_segments]
    }

    /// The group of each triangle, i32; -1 for a segment.
    pub(crate) fn groups(&self) -> Vec<Section<'a>> {
        let ends: Vec<u32> = self.mesh.groups().iter().map(|group| group.triangles.end).collect();
        let of_triangles = self.indices_of(self.mesh.triangle_count(), ends);
        vec![of_triangles, self.repeated(self.segments, -1_i32)]
    }

    /// For each of `count` items, which of the ranges with these ends it is in.
    fn indices_of(&self, count: u32, ends: Vec<u32>) -> Section<'a> {
        self.records(count, move |range| {
            let mut index = ends.partition_point(|&end| end <= range.start);
            let ends = ends.clone();
            range.map(move |item| {
                while ends.get(index).is_some_and(|&end| end <= item) {
                    index += 1;
                }
                [index as i32]
            })
        })
    }

    /// A line of numbers for each item.
    fn records<T, I, const N: usize>(
        &self,
        count: u32,
        of: impl Fn(Range<u32>) -> I + Sync + 'a,
    ) -> Section<'a>
    where
        T: Number,
        I: Iterator<Item = [T; N]>,
    {
        let numbers = self.numbers;
        let number_len = if numbers == Numbers::Text { T::TEXT_LEN } else { size_of::<T>() };
        Section::new(count, (N * number_len) as u32, move |range, buffer| {
            of(range).for_each(|record| put(record, numbers, buffer));
        })
    }

    fn repeated<T: Number>(&self, count: u32, value: T) -> Section<'a> {
        let mut item = Vec::new();
        put([value], self.numbers, &mut item);
        Section::repeated(count, &item)
    }
}

/// Names, each ended by a zero, as numbers of 8 bits.
pub(crate) fn text_of_names<'n>(
    names: impl Iterator<Item = &'n str>,
    numbers: Numbers,
) -> (Vec<u8>, usize) {
    let bytes: Vec<u8> =
        names.flat_map(|name| one_line(name).into_bytes().into_iter().chain([0])).collect();
    let mut text = Vec::new();
    bytes.iter().for_each(|&byte| put([byte], numbers, &mut text));
    (text, bytes.len())
}

/// Appends the numbers of a record; a text has them in a line.
fn put<T: Number, const N: usize>(record: [T; N], numbers: Numbers, buffer: &mut Vec<u8>) {
    for (index, number) in record.into_iter().enumerate() {
        match numbers {
            Numbers::LittleEndian => number.put_bytes(false, buffer),
            Numbers::BigEndian => number.put_bytes(true, buffer),
            Numbers::Text => {
                if index > 0 {
                    buffer.push(b' ');
                }
                number.put_text(buffer);
            }
        }
    }
    if numbers == Numbers::Text {
        buffer.push(b'\n');
    }
}

/// A number in an array.
trait Number: Copy + Send + Sync {
    /// About how long it is as text, with what follows.
    const TEXT_LEN: usize;

    fn put_bytes(self, is_big: bool, buffer: &mut Vec<u8>);

    fn put_text(self, buffer: &mut Vec<u8>);
}

macro_rules! whole_number {
    ($($kind:ty: $len:literal),*) => {$(
        impl Number for $kind {
            const TEXT_LEN: usize = $len;

            fn put_bytes(self, is_big: bool, buffer: &mut Vec<u8>) {
                let bytes = if is_big { self.to_be_bytes() } else { self.to_le_bytes() };
                buffer.extend_from_slice(&bytes);
            }

            fn put_text(self, buffer: &mut Vec<u8>) {
                buffer.extend_from_slice(itoa::Buffer::new().format(self).as_bytes());
            }
        }
    )*};
}

whole_number!(u8: 4, i32: 8, i64: 10);

impl Number for f64 {
    const TEXT_LEN: usize = 18;

    fn put_bytes(self, is_big: bool, buffer: &mut Vec<u8>) {
        let bytes = if is_big { self.to_be_bytes() } else { self.to_le_bytes() };
        buffer.extend_from_slice(&bytes);
    }

    fn put_text(self, buffer: &mut Vec<u8>) {
        let mut digits = zmij::Buffer::new();
        let text = digits.format_finite(self);
        buffer.extend_from_slice(text.strip_suffix(".0").unwrap_or(text).as_bytes());
    }
}
