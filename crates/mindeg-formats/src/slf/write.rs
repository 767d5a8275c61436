//! Writing SELAFIN and the boundary conditions beside it.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::sync::Arc;

use mindeg_mesh::{LineKind, Mesh, TriMesh, filled};

use super::read::{BOTTOM, TITLE, VARIABLE};
use crate::corners::{positions, segments, triangles};
use crate::names::word;
use crate::numbers::{Numbers, Row};
use crate::sections::Section;
use crate::{WriteError, mesh_name};

const BIG: Numbers = Numbers::BigEndian;

/// Each file from front to back.
pub(super) fn sections(mesh: &dyn Mesh) -> Result<[Vec<Section<'_>>; 2], WriteError> {
    let boundary = boundary_points(mesh)?;
    let conditions = Section::bytes(conditions(mesh, &boundary));
    Ok([geometry(mesh, &boundary), vec![conditions]])
}

fn geometry<'a>(mesh: &'a dyn Mesh, boundary: &[u32]) -> Vec<Section<'a>> {
    let (vertices, count) = (mesh.vertex_count(), mesh.triangle_count());
    let mut numbers = vec![0_i32; vertices as usize];
    boundary.iter().zip(1..).for_each(|(&vertex, number)| numbers[vertex as usize] = number);
    let title = [padded(mesh_name(mesh), TITLE[0]), padded("SERAFIND", TITLE[1])].concat();
    let variable = [padded(BOTTOM[0], VARIABLE[0]), padded("M", VARIABLE[1])].concat();
    let corners = move |range| triangles(mesh, range).into_iter().map(|ends| ends.map(from_one));
    let coordinate = |axis: usize| {
        BIG.records(0..vertices, move |range| positions(mesh, range).map(move |at| [at[axis]]))
    };
    let heights = BIG.records(0..vertices, |range| {
        let depths = filled(range, 0.0, |first, out| mesh.fill_depths(first, out));
        // Subtracting from zero turns a depth of 0 into 0, not -0.
        depths.into_iter().map(|depth| [0.0 - depth])
    });
    let numbers: Arc<[i32]> = numbers.into();
    let numbers = BIG.records(0..vertices, move |range| {
        let numbers = Arc::clone(&numbers);
        range.map(move |vertex| [numbers[vertex as usize]])
    });
    let records = [
        Section::bytes(title),
        row([1_i32, 0]),
        Section::bytes(variable),
        row([1_i32, 0, 0, 0, 0, 0, 0, 0, 0, 0]),
        row([count as i32, vertices as i32, 3, 1]),
        BIG.records(0..count, corners),
        numbers,
        coordinate(0),
        coordinate(1),
        row([0.0_f64]),
        heights,
    ];
    // Fortran writes the length of a record before and behind it.
    let framed = records.into_iter().flat_map(|record| {
        let length = || row([record.byte_len() as i32]);
        [length(), length()].into_iter().zip([Some(record), None])
    });
    framed.flat_map(|(length, record)| [Some(length), record]).flatten().collect()
}

fn row<'a>(row: impl Row) -> Section<'a> {
    let mut bytes = Vec::new();
    BIG.put(row, &mut bytes);
    Section::bytes(bytes)
}

/// An index as files count them; there are fewer than 31 bits count.
fn from_one(index: u32) -> i32 {
    index as i32 + 1
}

/// Letters of ASCII in a field of this length.
fn padded(text: &str, len: usize) -> Vec<u8> {
    let ascii = |letter: char| if matches!(letter, ' '..='~') { letter as u8 } else { b'?' };
    text.chars().map(ascii).chain(std::iter::repeat(b' ')).take(len).collect()
}

/// The points of the boundary in TELEMAC's order.
fn boundary_points(mesh: &dyn Mesh) -> Result<Vec<u32>, WriteError> {
    let refused = |problem: String| WriteError::Refused(format!("SELAFIN: {problem}"));
    let list = TriMesh::of(mesh).map_err(|error| refused(error.to_string()))?;
    let at = |vertex: u32| list.positions()[vertex as usize].truncate();
    let mut loops = Vec::new();
    let mut seen = vec![false; list.positions().len()];
    for mut boundary in list.boundary_loops() {
        let vertices = &mut boundary.vertices;
        let twice = vertices.iter().find(|&&vertex| {
            std::mem::replace(&mut seen[vertex as usize], true) || !boundary.closed
        });
        if let Some(vertex) = twice {
            return Err(refused(format!(
                "the boundary passes vertex {vertex} (counted from 0) twice, and a boundary point has one number; part \
                 the mesh there (mindeg mesh --condition parts holes that touch)"
            )));
        }
        let from = at(vertices[0]);
        let doubled_area: f64 =
            vertices.windows(2).map(|ends| (at(ends[0]) - from).perp_dot(at(ends[1]) - from)).sum();
        let sum = |index: &usize| at(vertices[*index]).element_sum();
        let first = (0..vertices.len()).min_by(|a, b| sum(a).total_cmp(&sum(b)));
        vertices.rotate_left(first.unwrap_or(0));
        loops.push((doubled_area < 0.0, boundary.vertices));
    }
    // Outer boundaries first; else in their order.
    loops.sort_by_key(|(is_hole, _)| *is_hole);
    Ok(loops.into_iter().flat_map(|(_, vertices)| vertices).collect())
}

/// The conditions at the boundary: thirteen columns a point, then the name of its line.
fn conditions(mesh: &dyn Mesh, boundary: &[u32]) -> String {
    let (mut open, mut names) = (BTreeSet::new(), BTreeMap::new());
    for (index, line) in mesh.lines().iter().enumerate() {
        for ends in segments(mesh, line.segments.clone()) {
            names.insert(ends[0], word(&line.name));
            if mesh.line_kind(index) == Some(LineKind::Open) {
                open.extend(ends);
            }
        }
    }
    let mut text = String::new();
    for (vertex, number) in boundary.iter().zip(1..) {
        let (codes, tracer) = if open.contains(vertex) { ("5 4 4", 4) } else { ("2 2 2", 2) };
        let name = names.get(vertex).map(|name| format!(" # {name}")).unwrap_or_default();
        let node = from_one(*vertex);
        let _ =
            writeln!(text, "{codes} 0.0 0.0 0.0 0.0 {tracer} 0.0 0.0 0.0 {node} {number}{name}");
    }
    text
}
