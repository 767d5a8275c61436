//! The tables of vertices and triangles that text formats for solvers share.

use crate::corners::{positions, triangles};
use crate::decimals::{Decimals, push_integer};
use crate::sections::Section;
use mindeg_mesh::Mesh;

/// A line for each vertex: `before`, its number from 1, its first `axes` coordinates, and what
/// `after` appends.
pub(crate) fn vertex_lines<'a>(
    mesh: &'a dyn Mesh,
    before: &'static [u8],
    axes: usize,
    after: impl Fn(u32, &mut Vec<u8>) + Sync + 'a,
) -> Section<'a> {
    Section::new(mesh.vertex_count(), 48, move |range, buffer| {
        let mut decimals = [0; 3].map(|_| Decimals::new());
        for (vertex, point) in range.clone().zip(positions(mesh, range)) {
            buffer.extend_from_slice(before);
            push_integer(u64::from(vertex) + 1, buffer);
            for (decimals, value) in decimals.iter_mut().zip(point.to_array()).take(axes) {
                decimals.push(value, buffer);
            }
            after(vertex, buffer);
            buffer.push(b'\n');
        }
    })
}

/// A line for each triangle: `before`, its number from 1, `between`, its vertices from 1, and what
/// `after` appends.
pub(crate) fn triangle_lines<'a>(
    mesh: &'a dyn Mesh,
    before: &'static [u8],
    between: &'static [u8],
    after: impl Fn(u32, &mut Vec<u8>) + Sync + 'a,
) -> Section<'a> {
    Section::new(mesh.triangle_count(), 40, move |range, buffer| {
        for (index, triangle) in range.clone().zip(triangles(mesh, range)) {
            buffer.extend_from_slice(before);
            push_integer(u64::from(index) + 1, buffer);
            buffer.extend_from_slice(between);
            triangle.into_iter().for_each(|vertex| push_integer(u64::from(vertex) + 1, buffer));
            after(index, buffer);
            buffer.push(b'\n');
        }
    })
}
