//! The lines of a mesh as solvers' files have them: as chains of vertices, rings and markers.

use glam::{DVec2, DVec3};
use mindeg_mesh::ear_clipping::cut_polygon;
use mindeg_mesh::{ByName, Line, LineKind, Mesh, TriMesh, edges_of, filled, sorted};
use std::ops::Range;

use crate::corners::{segments, triangles};

/// The mesh with a line for each loop of its boundary, named `boundary 1` and so on, if it has no lines
/// and is not closed: what [formats with a boundary](crate::Format::has_boundary) ask for.
///
/// Each line runs with the mesh on its left, so those around holes run clockwise. O(n log n) time.
///
/// # Example
///
/// ```
/// use mindeg_formats::{obj, with_boundary_lines};
///
/// let mesh = obj::read("v 0 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\n".as_bytes())?;
/// assert_eq!(with_boundary_lines(mesh).segments(), [[0, 1], [1, 2], [2, 0]]);
/// # Ok::<(), mindeg_formats::ReadError>(())
/// ```
#[must_use]
pub fn with_boundary_lines(mesh: TriMesh) -> TriMesh {
    if !mesh.segments().is_empty() {
        return mesh;
    }
    let mut lines = Vec::new();
    let mut segments = Vec::new();
    for (boundary, number) in mesh.boundary_loops().into_iter().zip(1..) {
        let start = segments.len() as u32;
        let vertices = &boundary.vertices;
        segments.extend(vertices.windows(2).map(|ends| [ends[0], ends[1]]));
        if let (true, [first, .., last]) = (boundary.closed, &vertices[..]) {
            segments.push([*last, *first]);
        }
        // A boundary has fewer edges than the mesh has corners; what 32 bits do not count is left.
        let Ok(end) = u32::try_from(segments.len()) else { return mesh };
        if start < end {
            let name = format!("boundary {number}");
            lines.push(Line { name, segments: start..end, is_straight: false });
        }
    }
    mesh.with_lines(lines, segments).expect("the boundary has vertices of the mesh")
}

/// Segments looked at at a time.
const BLOCK: u32 = 1 << 12;

/// Segments of lines of one name and kind, of which each begins where the one before ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct MarkedChain {
    /// The index of the name of the lines.
    pub(crate) name: u32,
    pub(crate) kind: Option<LineKind>,
    pub(crate) segments: Range<u32>,
    pub(crate) start: u32,
    pub(crate) end: u32,
}

/// All lines of a mesh.
pub(crate) struct MarkedChains<'a> {
    mesh: &'a dyn Mesh,
    pub(crate) chains: Vec<MarkedChain>,
    /// The names of the lines.
    pub(crate) names: Vec<String>,
    of_vertices: NamesOfVertices,
}

/// The index of the name of each vertex.
enum NamesOfVertices {
    /// Segment i begins at vertex i: the chains tell.
    InOrder,
    /// `u32::MAX` for none.
    Listed(Vec<u32>),
}

impl<'a> MarkedChains<'a> {
    /// Looks at every segment. O(n) time; next to no memory where segments come in the order of
    /// vertices, as round a domain, else O(n).
    pub(crate) fn of(mesh: &'a dyn Mesh) -> Self {
        let lines = mesh.lines();
        let ByName { names, of } = ByName::new(lines.iter().map(|line| &line.name));
        let mut chains: Vec<MarkedChain> = Vec::new();
        let mut is_in_order = true;
        for (index, (line, name)) in lines.iter().zip(of).enumerate() {
            let (range, kind) = (line.segments.clone(), mesh.line_kind(index));
            let goes_on = |chain: &MarkedChain, at: u32, a: u32| {
                let is_closed = at == range.start && chain.start == chain.end;
                (chain.name, chain.kind, chain.end) == (name, kind, a) && !is_closed
            };
            for start in range.clone().step_by(BLOCK as usize) {
                let block = start..start.saturating_add(BLOCK).min(range.end);
                for (index, [a, b]) in block.clone().zip(segments(mesh, block)) {
                    is_in_order &= a == index;
                    match chains.last_mut() {
                        Some(chain) if goes_on(chain, index, a) => {
                            chain.segments.end = index + 1;
                            chain.end = b;
                        }
                        _ => {
                            let segments = index..index + 1;
                            chains.push(MarkedChain { name, kind, segments, start: a, end: b });
                        }
                    }
                }
            }
        }
        // Where a chain ends at a vertex that begins none, its marker is the chain's.
        let count = lines.last().map_or(0, |line| line.segments.end);
        is_in_order &= chains.iter().all(|chain| chain.end < count);
        let of_vertices = match is_in_order {
            true => NamesOfVertices::InOrder,
            false => NamesOfVertices::Listed(listed(mesh, &chains)),
        };
        Self { mesh, chains, names, of_vertices }
    }

    /// The index of the name of the line that begins or goes on at a vertex.
    pub(crate) fn name_of(&self, vertex: u32) -> Option<u32> {
        match &self.of_vertices {
            NamesOfVertices::Listed(names) => {
                Some(names[vertex as usize]).filter(|name| *name != u32::MAX)
            }
            NamesOfVertices::InOrder => {
                let chain = self.chains.partition_point(|chain| chain.segments.end <= vertex);
                self.chains.get(chain).map(|chain| chain.name)
            }
        }
    }

    /// Leaves out segments with triangles on both sides: they are no boundary. Gives the names of
    /// their lines, each once. O(n log n) time for n triangles and
    /// segments.
    pub(crate) fn leave_out_inner(&mut self) -> Vec<String> {
        let of_chain = |chain: &MarkedChain| segments(self.mesh, chain.segments.clone());
        let mut edges: Vec<[u32; 2]> = self.chains.iter().flat_map(of_chain).map(sorted).collect();
        edges.sort_unstable();
        edges.dedup();
        let mut beside = vec![0_u8; edges.len()];
        let count = self.mesh.triangle_count();
        for start in (0..count).step_by(BLOCK as usize) {
            for [a, b, c] in triangles(self.mesh, start..start.saturating_add(BLOCK).min(count)) {
                for edge in edges_of([a, b, c]) {
                    if let Ok(at) = edges.binary_search(&sorted(edge)) {
                        beside[at] = beside[at].saturating_add(1);
                    }
                }
            }
        }
        let is_inner =
            |edge: [u32; 2]| edges.binary_search(&sorted(edge)).is_ok_and(|at| beside[at] > 1);
        let (mut kept, mut left_out) = (Vec::new(), vec![false; self.names.len()]);
        for chain in &self.chains {
            let mut goes_on = false;
            for (index, edge) in chain.segments.clone().zip(of_chain(chain)) {
                let [start, end] = edge;
                if is_inner(edge) {
                    (goes_on, left_out[chain.name as usize]) = (false, true);
                    continue;
                }
                match kept.last_mut() {
                    Some(MarkedChain { segments, end: last, .. }) if goes_on => {
                        (segments.end, *last) = (index + 1, end);
                    }
                    _ => {
                        kept.push(MarkedChain { segments: index..index + 1, start, end, ..*chain })
                    }
                }
                goes_on = true;
            }
        }
        self.chains = kept;
        let names = self.names.iter().zip(left_out);
        names.filter(|name| name.1).map(|name| name.0.clone()).collect()
    }

    /// The rings: chains that follow one another and close.
    pub(crate) fn rings(&self) -> Vec<Range<usize>> {
        let mut rings = Vec::new();
        let mut first = 0;
        for (index, chain) in self.chains.iter().enumerate() {
            if first < index && self.chains[index - 1].end != chain.start {
                first = index;
            }
            if chain.end == self.chains[first].start {
                rings.push(first..index + 1);
                first = index + 1;
            }
        }
        rings
    }

    /// The vertices of a ring in order, without the first once more.
    fn vertices<'b>(&'b self, ring: &'b [MarkedChain]) -> impl Iterator<Item = u32> + 'b {
        let blocks = ring.iter().flat_map(|chain| {
            let end = chain.segments.end;
            let starts = chain.segments.clone().step_by(BLOCK as usize);
            starts.map(move |start| start..start.saturating_add(BLOCK).min(end))
        });
        blocks.flat_map(|block| segments(self.mesh, block)).map(|[a, _]| a)
    }

    /// Whether a ring runs clockwise, seen along the z axis: the mesh lies around it.
    pub(crate) fn is_hole(&self, ring: &[MarkedChain]) -> bool {
        let mut corners = crate::corners::Corners::new(self.mesh);
        let mut points = self.vertices(ring).map(|vertex| corners.position(vertex).truncate());
        let Some(origin) = points.next() else { return false };
        let mut before = DVec2::ZERO;
        let mut doubled_area = 0.0;
        for point in points {
            doubled_area += before.perp_dot(point - origin);
            before = point - origin;
        }
        doubled_area < 0.0
    }

    /// A point inside a ring: the middle of the largest triangle that it can be cut into.
    pub(crate) fn point_inside(&self, ring: &[MarkedChain]) -> DVec2 {
        let mut corners = crate::corners::Corners::new(self.mesh);
        let points: Vec<DVec3> =
            self.vertices(ring).map(|vertex| corners.position(vertex)).collect();
        let mut triangles = Vec::new();
        cut_polygon(&Vec::from_iter(0..points.len() as u32), &points, &mut triangles);
        let placed = triangles.iter().map(|triangle| triangle.map(|i| points[i as usize]));
        let area = |[a, b, c]: &[DVec3; 3]| (b - a).cross(c - a).length_squared();
        let largest = placed.max_by(|a, b| area(a).total_cmp(&area(b)));
        largest.map_or(DVec2::ZERO, |[a, b, c]| (a / 3.0 + b / 3.0 + c / 3.0).truncate())
    }
}

/// The index of the name of each vertex: that of the last segment that begins there, or else ends.
fn listed(mesh: &dyn Mesh, chains: &[MarkedChain]) -> Vec<u32> {
    let mut names = vec![u32::MAX; mesh.vertex_count() as usize];
    for chain in chains {
        names[chain.end as usize] = chain.name;
    }
    for chain in chains {
        for [start, _] in segments(mesh, chain.segments.clone()) {
            names[start as usize] = chain.name;
        }
    }
    names
}

/// The vertices of a chain from one index to another; the last one has the index of the number of
/// segments.
pub(crate) fn chain_vertices(mesh: &dyn Mesh, chain: &MarkedChain, range: Range<u32>) -> Vec<u32> {
    let first = chain.segments.start;
    filled(range, 0, |start, out| {
        let mut out = out.iter_mut();
        let mut from = start;
        if from == 0 {
            out.next().into_iter().for_each(|vertex| *vertex = chain.start);
            from = 1;
        }
        let ends = first + from - 1..first + from - 1 + out.len() as u32;
        segments(mesh, ends).into_iter().zip(out).for_each(|([_, end], vertex)| *vertex = end);
    })
}
