//! Writing .node, .ele and .poly.

use crate::GENERATOR;
use crate::boundary::{MarkedChain, MarkedChains};
use crate::corners::segments;
use crate::decimals::{Decimals, push_integer};
use crate::names::one_line;
use crate::sections::Section;
use crate::tables::{triangle_lines, vertex_lines};
use mindeg_mesh::Mesh;
use std::fmt::Write as _;
use std::sync::Arc;

/// Each file from front to back.
pub(crate) fn sections(mesh: &dyn Mesh) -> [Vec<Section<'_>>; 3] {
    let boundary = Arc::new(MarkedChains::of(mesh));
    [node(mesh, Arc::clone(&boundary)), ele(mesh), poly(mesh, &boundary)]
}

fn node<'a>(mesh: &'a dyn Mesh, boundary: Arc<MarkedChains<'a>>) -> Vec<Section<'a>> {
    let head = format!("# {GENERATOR}\n{} 2 0 1\n", mesh.vertex_count());
    let marker = move |vertex, buffer: &mut Vec<u8>| push_integer(boundary.marker(vertex), buffer);
    vec![Section::bytes(head), vertex_lines(mesh, b"", 2, marker)]
}

fn ele(mesh: &dyn Mesh) -> Vec<Section<'_>> {
    let ends: Vec<u32> = mesh.groups().iter().map(|group| group.triangles.end).collect();
    let attributes = u32::from(ends.len() > 1);
    let head = format!("# {GENERATOR}\n{} 3 {attributes}\n", mesh.triangle_count());
    let attribute = move |triangle: u32, buffer: &mut Vec<u8>| {
        if attributes > 0 {
            push_integer(ends.partition_point(|&end| end <= triangle) + 1, buffer);
        }
    };
    vec![Section::bytes(head), triangle_lines(mesh, b"", b"", attribute)]
}

fn poly<'a>(mesh: &'a dyn Mesh, boundary: &MarkedChains<'_>) -> Vec<Section<'a>> {
    let mut head = format!("# {GENERATOR}\n");
    for (line, marker) in mesh.lines().iter().zip(1..) {
        let _ = writeln!(head, "# marker {marker}: {}", one_line(&line.name));
    }
    let count: u64 = boundary.chains.iter().map(|chain| chain.segments.len() as u64).sum();
    let _ = writeln!(head, "0 2 0 1\n{count} 1");
    let mut sections = vec![Section::bytes(head)];
    sections.extend(boundary.chains.iter().map(|chain| chain_lines(mesh, chain.clone())));
    let rings = boundary.rings().into_iter().map(|ring| &boundary.chains[ring]);
    let holes: Vec<_> = rings.filter(|ring| boundary.is_hole(ring)).collect();
    let mut tail = format!("{}\n", holes.len()).into_bytes();
    for (ring, number) in holes.into_iter().zip(1_u32..) {
        push_integer(number, &mut tail);
        // Adding zero turns -0 into 0.
        let point = boundary.point_inside(ring).to_array().map(|x| x + 0.0);
        point.into_iter().for_each(|x| Decimals::new().push(x, &mut tail));
        tail.push(b'\n');
    }
    sections.push(Section::bytes(tail));
    sections
}

/// Number, ends and marker of each segment.
fn chain_lines(mesh: &dyn Mesh, chain: MarkedChain) -> Section<'_> {
    Section::of(chain.segments, 32, move |range, buffer| {
        for (index, ends) in range.clone().zip(segments(mesh, range)) {
            push_integer(u64::from(index) + 1, buffer);
            ends.into_iter().for_each(|vertex| push_integer(u64::from(vertex) + 1, buffer));
            push_integer(chain.line as u64 + 1, buffer);
            buffer.push(b'\n');
        }
    })
}
