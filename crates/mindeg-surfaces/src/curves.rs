//! The features of a surface as curves between corners.

use glam::DVec3;

use crate::NONE;
use crate::features::FeatureRules;
use crate::links::{Links, by_vertex, edge_of};

/// A line of feature edges: from corner to corner, or closed.
#[derive(Clone, Debug, PartialEq)]
pub struct FeatureCurve {
    points: Vec<DVec3>,
    /// The length of the curve up to each of its points.
    lengths: Vec<f64>,
    is_closed: bool,
    is_boundary: bool,
    ends: [u32; 2],
}

impl FeatureCurve {
    /// Its points in order; a closed curve ends with its first point.
    pub fn points(&self) -> &[DVec3] {
        &self.points
    }

    /// Its length, in units of length.
    pub fn length(&self) -> f64 {
        self.lengths.last().copied().unwrap_or(0.0)
    }

    /// Whether it is closed without a corner. A curve that leaves a corner and comes back to it is open.
    pub fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// Whether its edges have a triangle on one side only.
    pub fn is_boundary(&self) -> bool {
        self.is_boundary
    }

    /// The corners at its ends; `None` for a closed curve.
    pub fn ends(&self) -> Option<[u32; 2]> {
        (!self.is_closed).then_some(self.ends)
    }

    /// The parameter in the curve's range: a closed curve repeats itself, an open one ends at its corners.
    pub fn wrapped(&self, t: f64) -> f64 {
        let length = self.length();
        match self.is_closed {
            // Rounding may give the length itself.
            true => Some(t.rem_euclid(length)).filter(|t| *t < length).unwrap_or(0.0),
            false => t.clamp(0.0, length),
        }
    }

    /// The point at a distance `t` along the curve, [wrapped](Self::wrapped). O(log n).
    pub fn at(&self, t: f64) -> DVec3 {
        let t = self.wrapped(t);
        let after = self.lengths.partition_point(|length| *length <= t);
        let (low, high) = (after.saturating_sub(1), after.min(self.points.len() - 1));
        let [start, end] = [low, high].map(|i| self.lengths[i]);
        match end > start {
            true => self.points[low].lerp(self.points[high], (t - start) / (end - start)),
            false => self.points[low],
        }
    }

    /// The unit direction of the curve at a distance `t` along it; at one of its points, the direction after it. O(log n).
    pub fn direction(&self, t: f64) -> DVec3 {
        let after = self.lengths.partition_point(|length| *length <= self.wrapped(t));
        let high = after.clamp(1, self.points.len() - 1);
        (self.points[high] - self.points[high - 1]).normalize_or_zero()
    }

    /// How far it is from `t` to `to` along the curve, with a sign; round a closed curve the shorter way.
    pub fn way(&self, t: f64, to: f64) -> f64 {
        let way = to - t;
        match self.is_closed {
            true => {
                let way = self.wrapped(way);
                if way > 0.5 * self.length() { way - self.length() } else { way }
            }
            false => way,
        }
    }
}

/// An edge of a surface that is part of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveSpan {
    /// The curve.
    pub curve: u32,
    /// The vertices of the edge, in the direction of the curve.
    pub vertices: [u32; 2],
    /// The parameters at these vertices; the second is the greater, also where a closed curve ends.
    pub range: [f64; 2],
}

/// The curves of a surface.
#[derive(Clone, Debug, Default)]
pub(crate) struct Curves {
    pub(crate) curves: Vec<FeatureCurve>,
    pub(crate) spans: Vec<CurveSpan>,
    /// The span of the edge opposite each corner of each triangle, or [`NONE`].
    pub(crate) span_of: Vec<[u32; 3]>,
    /// Whether each vertex is a corner.
    pub(crate) is_corner: Vec<bool>,
}

impl Curves {
    /// The curves along the edges that `bits` marks; see [`crate::features::features`]. `kept` are corners, too, ascending
    /// points of the input. O(n).
    pub(crate) fn new(links: &Links, bits: &[u8], kept: &[u32], rules: &FeatureRules) -> Self {
        let graph = Graph::new(links, bits);
        let mut is_corner = corners(links, &graph, rules);
        if !kept.is_empty() {
            for (is_corner, input) in is_corner.iter_mut().zip(&links.inputs) {
                *is_corner |= kept.binary_search(input).is_ok();
            }
        }
        let mut curves =
            Self { is_corner, span_of: vec![[NONE; 3]; links.triangles.len()], ..Self::default() };
        let mut is_traced = vec![false; graph.edges.len()];
        let mut span_of_edge = vec![NONE; graph.edges.len()];
        for of_corners in [true, false] {
            for vertex in 0..links.points.len() as u32 {
                if of_corners && !curves.is_corner[vertex as usize] {
                    continue;
                }
                for &edge in graph.around(vertex) {
                    if !is_traced[edge as usize] {
                        curves.trace(
                            links,
                            &graph,
                            [vertex, edge],
                            &mut is_traced,
                            &mut span_of_edge,
                        );
                    }
                }
            }
        }
        for (edge, span) in graph.edges.iter().zip(&span_of_edge) {
            for (t, i) in edge.halves.into_iter().filter(|half| half.0 != NONE) {
                curves.span_of[t as usize][i] = *span;
            }
        }
        curves
    }

    /// Follows a curve from a vertex along an edge, up to the next corner or back to the vertex.
    fn trace(
        &mut self,
        links: &Links,
        graph: &Graph,
        [start, first]: [u32; 2],
        is_traced: &mut [bool],
        span_of_edge: &mut [u32],
    ) {
        let at = |v: u32| links.points[v as usize];
        let curve = self.curves.len() as u32;
        let (mut points, mut lengths) = (vec![at(start)], vec![0.0]);
        let (mut vertex, mut edge, mut length) = (start, first, 0.0);
        loop {
            is_traced[edge as usize] = true;
            let [a, b] = graph.edges[edge as usize].ends;
            let to = if a == vertex { b } else { a };
            let before = length;
            length += at(vertex).distance(at(to));
            points.push(at(to));
            lengths.push(length);
            span_of_edge[edge as usize] = self.spans.len() as u32;
            self.spans.push(CurveSpan { curve, vertices: [vertex, to], range: [before, length] });
            vertex = to;
            let ahead = graph.around(vertex).iter().find(|&&e| !is_traced[e as usize]);
            match ahead {
                Some(&next) if !self.is_corner[vertex as usize] && vertex != start => edge = next,
                _ => break,
            }
        }
        let is_closed = !self.is_corner[start as usize];
        let is_boundary = graph.edges[first as usize].halves[1].0 == NONE;
        let ends = [start, vertex];
        self.curves.push(FeatureCurve { points, lengths, is_closed, is_boundary, ends });
    }
}

/// A feature edge with its two halves; the second is [`NONE`] on the boundary.
struct GraphEdge {
    ends: [u32; 2],
    halves: [(u32, usize); 2],
}

/// The feature edges, and those at each vertex.
struct Graph {
    edges: Vec<GraphEdge>,
    starts: Vec<usize>,
    at: Vec<u32>,
}

impl Graph {
    fn new(links: &Links, bits: &[u8]) -> Self {
        let mut edges = Vec::new();
        for (t, &corners) in (0_u32..).zip(&links.triangles) {
            for i in (0..3).filter(|i| bits[t as usize] & 1 << i != 0) {
                let u = links.neighbours[t as usize][i];
                let other = match u {
                    NONE => (NONE, 0),
                    u if u < t => continue,
                    u => (u, edge_of(links.triangles[u as usize], corners, i)),
                };
                let ends = [corners[(i + 1) % 3], corners[(i + 2) % 3]];
                edges.push(GraphEdge { ends, halves: [(t, i), other] });
            }
        }
        let (starts, at) = by_vertex(links.points.len(), edges.iter().map(|edge| edge.ends));
        Self { edges, starts, at }
    }

    fn around(&self, vertex: u32) -> &[u32] {
        &self.at[self.starts[vertex as usize]..self.starts[vertex as usize + 1]]
    }
}

/// A tip is a needle's where its angles are less than a full turn by more than this, in radians: three triangles of 35°
/// do not fit there. No operation gets past it without turning triangles over, so it stays at any angle.
const NEEDLE: f64 = std::f64::consts::TAU - 105.0 * std::f64::consts::PI / 180.0;

/// The vertices where curves end, turn, or where the surface has a tip.
fn corners(links: &Links, graph: &Graph, rules: &FeatureRules) -> Vec<bool> {
    let at = |v: u32| links.points[v as usize];
    let straight = libm::cos(rules.corner_angle_deg.clamp(0.0, 180.0).to_radians());
    let mut angles = vec![0.0; links.points.len()];
    for &triangle in &links.triangles {
        for i in 0..3 {
            angles[triangle[i] as usize] += corner_angle(links, triangle, i);
        }
    }
    let is_corner = |v: u32| match graph.around(v) {
        [] => {
            let defect = std::f64::consts::TAU - angles[v as usize];
            let least = if rules.angle_deg < 180.0 { rules.tip_defect } else { NEEDLE };
            defect > least
        }
        &[one, other] => {
            let away = |edge: u32| {
                let [a, b] = graph.edges[edge as usize].ends;
                (at(if a == v { b } else { a }) - at(v)).normalize_or_zero()
            };
            -away(one).dot(away(other)) < straight
        }
        _ => true,
    };
    (0..links.points.len() as u32).map(is_corner).collect()
}

/// The angle of a triangle at its corner i, in radians.
pub(crate) fn corner_angle(links: &Links, triangle: [u32; 3], i: usize) -> f64 {
    let [a, b, c] = [0, 1, 2].map(|k| links.points[triangle[(i + k) % 3] as usize]);
    let [to_b, to_c] = [b - a, c - a];
    libm::atan2(to_b.cross(to_c).length(), to_b.dot(to_c))
}
