//! Writing fort.14.

use crate::boundary::{MarkedChain, MarkedChains, chain_vertices};
use crate::corners::positions;
use crate::names::one_line;
use crate::numbers::Numbers;
use crate::sections::Section;
use crate::tables::{corners_from_one, from_one, numbered_lines};
use crate::{made_by, mesh_name};
use mindeg_mesh::{LineKind, Mesh, filled};
use std::ops::Range;

/// The file from front to back, with a boundary that has no lines inside.
pub(crate) fn sections<'a>(mesh: &'a dyn Mesh, boundary: MarkedChains<'_>) -> Vec<Section<'a>> {
    let name = one_line(mesh_name(mesh));
    let (elements, nodes) = (mesh.triangle_count(), mesh.vertex_count());
    // OCSMesh reads no line with more than the two numbers.
    let head = format!("{name}\n {elements} {nodes}\n");
    let corners = |range| corners_from_one(mesh, range).map(|corners| ([3], corners));
    let mut sections = vec![
        Section::bytes(head),
        numbered_lines(" ", 0..nodes, |range| points(mesh, range)),
        numbered_lines(" ", 0..elements, corners),
    ];
    let [open, closed] = segments(&boundary);
    let by = format!(", by {}", made_by(mesh));
    for (kind, by, boundaries) in [("open", &*by, open), ("land", "", closed)] {
        let nodes: u64 = boundaries.iter().map(|segment| segment.node_count()).sum();
        sections.push(Section::bytes(format!(
            " {} = number of {kind} boundaries{by}\n {nodes} = number of all nodes of {kind} \
             boundaries\n",
            boundaries.len()
        )));
        for (segment, number) in boundaries.into_iter().zip(1..) {
            segment.push_sections(mesh, &boundary.names, number, &mut sections);
        }
    }
    sections
}

/// Each vertex with its depth for z.
fn points(mesh: &dyn Mesh, range: Range<u32>) -> impl Iterator<Item = [f64; 3]> {
    let depths = filled(range.clone(), 0.0, |first, out| mesh.fill_depths(first, out));
    // Adding zero turns -0 into 0.
    positions(mesh, range).zip(depths).map(|(point, depth)| [point.x, point.y, depth + 0.0])
}

/// A boundary segment of the file.
struct Segment {
    kind: LineKind,
    /// Several for an island.
    chains: Vec<MarkedChain>,
}

/// The open ones, then the others.
fn segments(boundary: &MarkedChains<'_>) -> [Vec<Segment>; 2] {
    let mut segments = Vec::new();
    let mut taken = 0;
    let mut push = |ring: &[MarkedChain], is_ring: bool| {
        let others =
            if is_ring && boundary.is_hole(ring) { LineKind::Island } else { LineKind::Land };
        let kind = |chain: &MarkedChain| chain.kind.unwrap_or(others);
        if is_ring && ring.iter().all(|chain| kind(chain) == LineKind::Island) {
            segments.push(Segment { kind: LineKind::Island, chains: ring.to_vec() });
            return;
        }
        for chain in ring {
            // A part of a ring cannot be an island.
            let is_open = kind(chain) == LineKind::Open;
            let kind = if is_open { LineKind::Open } else { LineKind::Land };
            segments.push(Segment { kind, chains: vec![chain.clone()] });
        }
    };
    for ring in boundary.rings() {
        push(&boundary.chains[taken..ring.start], false);
        push(&boundary.chains[ring.clone()], true);
        taken = ring.end;
    }
    push(&boundary.chains[taken..], false);
    let (open, closed) = segments.into_iter().partition(|segment| segment.kind == LineKind::Open);
    [open, closed]
}

impl Segment {
    /// ADCIRC closes islands, so that their first vertex does not come again.
    fn node_counts(&self) -> impl Iterator<Item = u32> {
        let last = u32::from(self.kind != LineKind::Island);
        self.chains.iter().map(move |chain| chain.segments.len() as u32 + last)
    }

    fn node_count(&self) -> u64 {
        self.node_counts().map(u64::from).sum()
    }

    fn push_sections<'a>(
        self,
        mesh: &'a dyn Mesh,
        names: &[String],
        number: u32,
        sections: &mut Vec<Section<'a>>,
    ) {
        let (code, kind) = match self.kind {
            LineKind::Open => ("", "open"),
            LineKind::Land => ("0 ", "land"),
            LineKind::Island => ("1 ", "island"),
        };
        let names: Vec<_> =
            self.chains.iter().map(|chain| one_line(&names[chain.name as usize])).collect();
        sections.push(Section::bytes(format!(
            " {} {code}= nodes of {kind} boundary {number} ({})\n",
            self.node_count(),
            names.join(", ")
        )));
        let counts: Vec<_> = self.node_counts().collect();
        for (chain, count) in self.chains.into_iter().zip(counts) {
            let vertices = move |range| {
                let vertices = chain_vertices(mesh, &chain, range).into_iter();
                vertices.map(|vertex| (" ", from_one([vertex])))
            };
            sections.push(Numbers::Text.records(0..count, vertices));
        }
    }
}
