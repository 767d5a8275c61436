//! Writing .node, .ele and .poly.

use crate::boundary::{MarkedChain, MarkedChains};
use crate::corners::{positions, segments};
use crate::made_by;
use crate::names::{MARKER, PHYSICAL, REGION, numbers, one_line};
use crate::numbers::Numbers;
use crate::sections::Section;
use crate::tables::{NamedRuns, corners_from_one, from_one, numbered_lines};
use mindeg_mesh::{ByName, Mesh};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::ops::Range;
use std::sync::Arc;

/// Each file from front to back.
pub(crate) fn sections(mesh: &dyn Mesh) -> [Vec<Section<'_>>; 3] {
    let boundary = Arc::new(MarkedChains::of(mesh));
    let points = mesh.named_vertices();
    let names = boundary.names.iter().chain(points.iter().map(|point| &point.name));
    let ByName { names, of } = ByName::new(names);
    let markers: Arc<[i64]> = numbered(&names, MARKER).into();
    let of_points = points.iter().zip(&of[boundary.names.len()..]);
    let points = of_points.map(|(point, name)| (point.vertex, markers[*name as usize])).collect();
    let poly = poly(mesh, &boundary, &names, &markers);
    [node(mesh, boundary, markers, points), ele(mesh), poly]
}

/// The numbers of names, which count in 64 bits.
fn numbered(names: &[String], word: &str) -> Vec<i64> {
    numbers(names.iter().map(String::as_str), &[word, PHYSICAL], i64::MIN..=i64::MAX)
}

fn node<'a>(
    mesh: &'a dyn Mesh,
    boundary: Arc<MarkedChains<'a>>,
    markers: Arc<[i64]>,
    points: BTreeMap<u32, i64>,
) -> Vec<Section<'a>> {
    let head = format!("{} 2 0 1 # {}\n", mesh.vertex_count(), made_by(mesh));
    let rows = move |range: Range<u32>| {
        let marker = |vertex| {
            let of_line = || boundary.name_of(vertex).map(|name| markers[name as usize]);
            [points.get(&vertex).copied().or_else(of_line).unwrap_or(0)]
        };
        let markers = range.clone().map(marker).collect::<Vec<_>>();
        positions(mesh, range).map(|point| [point.x, point.y]).zip(markers)
    };
    vec![Section::bytes(head), numbered_lines(" ", 0..mesh.vertex_count(), rows)]
}

fn ele(mesh: &dyn Mesh) -> Vec<Section<'_>> {
    let groups = NamedRuns::of_groups(mesh);
    let attributes = numbered(&groups.names, REGION);
    let has_attributes = attributes.len() > 1 || attributes.first().is_some_and(|one| *one != 1);
    let (count, columns) = (mesh.triangle_count(), u8::from(has_attributes));
    let rows = move |range: Range<u32>| {
        let own = |group| attributes.get(group as usize).filter(|_| has_attributes);
        let own: Vec<_> =
            groups.of(range.clone()).map(|group| own(group).map(|it| [*it])).collect();
        corners_from_one(mesh, range).zip(own)
    };
    let head = format!("{count} 3 {columns} # {}\n", made_by(mesh));
    vec![Section::bytes(head), numbered_lines(" ", 0..count, rows)]
}

fn poly<'a>(
    mesh: &'a dyn Mesh,
    boundary: &MarkedChains<'_>,
    names: &[String],
    markers: &[i64],
) -> Vec<Section<'a>> {
    let mut head = format!("# {}\n", made_by(mesh));
    for (name, marker) in names.iter().zip(markers) {
        let plain = format!("{MARKER} {marker}");
        if *name != plain {
            let _ = writeln!(head, "# {plain}: {}", one_line(name));
        }
    }
    let count: u64 = boundary.chains.iter().map(|chain| chain.segments.len() as u64).sum();
    let _ = writeln!(head, "0 2 0 1\n{count} 1");
    let mut sections = vec![Section::bytes(head)];
    sections.extend(
        boundary
            .chains
            .iter()
            .map(|chain| chain_lines(mesh, chain.clone(), markers[chain.name as usize])),
    );
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
fn chain_lines(mesh: &dyn Mesh, chain: MarkedChain, marker: i64) -> Section<'_> {
    numbered_lines(" ", chain.segments, move |range| {
        segments(mesh, range).into_iter().map(move |ends| (from_one(ends), [marker]))
    })
}
