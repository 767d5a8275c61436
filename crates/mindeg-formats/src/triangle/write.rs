//! Writing .node, .ele and .poly.

use crate::GENERATOR;
use crate::boundary::{MarkedChain, MarkedChains};
use crate::corners::{positions, segments};
use crate::names::one_line;
use crate::numbers::Numbers;
use crate::sections::Section;
use crate::tables::{corners_from_one, ends_of_groups, from_one, numbered_lines, runs_of};
use mindeg_mesh::Mesh;
use std::fmt::Write as _;
use std::ops::Range;
use std::sync::Arc;

/// Each file from front to back.
pub(crate) fn sections(mesh: &dyn Mesh) -> [Vec<Section<'_>>; 3] {
    let boundary = Arc::new(MarkedChains::of(mesh));
    [node(mesh, Arc::clone(&boundary)), ele(mesh), poly(mesh, &boundary)]
}

fn node<'a>(mesh: &'a dyn Mesh, boundary: Arc<MarkedChains<'a>>) -> Vec<Section<'a>> {
    let head = format!("# {GENERATOR}\n{} 2 0 1\n", mesh.vertex_count());
    let rows = move |range: Range<u32>| {
        let markers = range.clone().map(|vertex| [boundary.marker(vertex)]).collect::<Vec<_>>();
        positions(mesh, range).map(|point| [point.x, point.y]).zip(markers)
    };
    vec![Section::bytes(head), numbered_lines(" ", 0..mesh.vertex_count(), rows)]
}

fn ele(mesh: &dyn Mesh) -> Vec<Section<'_>> {
    let ends = ends_of_groups(mesh);
    let has_attributes = ends.len() > 1;
    let (count, attributes) = (mesh.triangle_count(), u8::from(has_attributes));
    let rows = move |range: Range<u32>| {
        let groups = runs_of(Arc::clone(&ends), range.clone());
        corners_from_one(mesh, range)
            .zip(groups.map(move |group| has_attributes.then_some([group + 1])))
    };
    let head = format!("# {GENERATOR}\n{count} 3 {attributes}\n");
    vec![Section::bytes(head), numbered_lines(" ", 0..count, rows)]
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
        // Adding zero turns -0 into 0.
        let point = boundary.point_inside(ring).to_array().map(|x| x + 0.0);
        Numbers::Text.put((" ", [number], point), &mut tail);
        tail.push(b'\n');
    }
    sections.push(Section::bytes(tail));
    sections
}

/// Number, ends and marker of each segment.
fn chain_lines(mesh: &dyn Mesh, chain: MarkedChain) -> Section<'_> {
    let marker = chain.line as u64 + 1;
    numbered_lines(" ", chain.segments, move |range| {
        segments(mesh, range).into_iter().map(move |ends| (from_one(ends), [marker]))
    })
}
