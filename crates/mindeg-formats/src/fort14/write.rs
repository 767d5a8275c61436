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

/// The names of sides of outlines on the box around their degrees, and of land without a name, which nobody gave.
const PLAIN: [&str; 5] = ["south", "east", "north", "west", "land"];

/// A boundary segment of the file.
struct Segment {
    kind: LineKind,
    /// Each begins where the one before ends.
    chains: Vec<MarkedChain>,
}

/// The open ones, then the others.
fn segments(boundary: &MarkedChains<'_>) -> [Vec<Segment>; 2] {
    let mut segments = Vec::new();
    let mut taken = 0;
    let mut push = |ring: &[MarkedChain], is_ring: bool| {
        let others =
            if is_ring && boundary.is_hole(ring) { LineKind::Island } else { LineKind::Land };
        let kind = move |chain: &MarkedChain| chain.kind.unwrap_or(others);
        // ADCIRC knows a whole island only, which its parts may call land.
        let is = |wanted: LineKind| move |chain: &MarkedChain| kind(chain) == wanted;
        let is_island = ring.iter().all(is(LineKind::Island))
            || boundary.is_hole(ring)
                && ring.iter().any(is(LineKind::Island))
                && !ring.iter().any(is(LineKind::Open));
        if is_ring && is_island {
            segments.push(Segment { kind: LineKind::Island, chains: ring.to_vec() });
            return;
        }
        // A part of a ring that is open elsewhere cannot be an island.
        let kind = |chain: &MarkedChain| match kind(chain) {
            LineKind::Open => LineKind::Open,
            LineKind::Land | LineKind::Island => LineKind::Land,
        };
        let name = |chain: &MarkedChain| &*boundary.names[chain.name as usize];
        let goes_on = |a: &MarkedChain, b: &MarkedChain| {
            let names = [a, b].map(name);
            let is_plain = |name: &&str| is_counted(name) || PLAIN.contains(name);
            // A box around degrees cuts a sea by its sides, and water is open beside a named part, too.
            let is_one = a.name == b.name
                || names.iter().all(is_plain)
                || names.contains(&LineKind::Open.name());
            a.end == b.start && kind(a) == kind(b) && is_one
        };
        let mut chains = ring.to_vec();
        if is_ring && let Some(at) = ring.windows(2).position(|pair| !goes_on(&pair[0], &pair[1])) {
            // From there on no segment is in two parts.
            chains.rotate_left(at + 1);
        }
        for chains in chains.chunk_by(goes_on) {
            segments.push(Segment { kind: kind(&chains[0]), chains: chains.to_vec() });
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

/// Whether a name only counts the sides of a ring: these have no name of their own, and are as many as a coast has bends.
fn is_counted(name: &str) -> bool {
    let mut words = name.rsplit(' ');
    let is_number = words.next().is_some_and(|word| word.parse::<u32>().is_ok());
    is_number && words.next() == Some("side") && matches!(words.next_back(), None | Some("hole"))
}

impl Segment {
    /// ADCIRC closes islands, so that their first vertex does not come again.
    fn node_counts(&self) -> impl Iterator<Item = u32> {
        let is_last =
            |index: usize| self.kind != LineKind::Island && index + 1 == self.chains.len();
        let count = move |(index, chain): (usize, &MarkedChain)| {
            chain.segments.len() as u32 + u32::from(is_last(index))
        };
        self.chains.iter().enumerate().map(count)
    }

    /// The names of the sides, each once, or that of the kind where they have none.
    fn name(&self, names: &[String], kind: &str) -> String {
        if let [chain] = &self.chains[..] {
            return one_line(&names[chain.name as usize]);
        }
        let mut own: Vec<String> = Vec::new();
        for name in self.chains.iter().map(|chain| &names[chain.name as usize]) {
            let name = one_line(name);
            if !is_counted(&name) && !own.contains(&name) {
                own.push(name);
            }
        }
        if own.is_empty() { kind.to_owned() } else { own.join(", ") }
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
        let kind = self.kind.name();
        let code = match self.kind {
            LineKind::Open => "",
            LineKind::Land => "0 ",
            LineKind::Island => "1 ",
        };
        sections.push(Section::bytes(format!(
            " {} {code}= nodes of {kind} boundary {number} ({})\n",
            self.node_count(),
            self.name(names, kind)
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
