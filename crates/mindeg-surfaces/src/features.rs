//! The edges of a surface that a remesher keeps: its boundary, borders between groups, and sharp edges.

use glam::DVec3;
use mindeg_mesh::sorted;

use crate::NONE;
use crate::links::{Links, by_vertex, edge_of};

/// The angles that make an edge, or a vertex, a feature of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FeatureRules {
    /// An edge is sharp where the normals of its two triangles differ by more than this angle, in degrees, 0 to 180.
    /// At 180 no edge is sharp, and no tip but a needle's, whose angles sum to less than 105°.
    pub angle_deg: f64,
    /// Edges that turn by more than this angle, in degrees, continue a line of sharp edges up to the next feature: a
    /// gap no longer than `shortest` is closed.
    pub weak_angle_deg: f64,
    /// Lines of sharp edges that end somewhere and are shorter than this are no features, in units of length.
    pub shortest: f64,
    /// A line of features has a corner where it turns by more than this angle, in degrees.
    pub corner_angle_deg: f64,
    /// A vertex off all features is a corner, a tip, where its angles are less than a full turn by more than this, in
    /// radians.
    pub tip_defect: f64,
}

impl Default for FeatureRules {
    /// Sharp edges from 40°, gaps up to 24°, corners from 40°, tips from 1.2; no line is too short.
    fn default() -> Self {
        Self {
            angle_deg: 40.0,
            weak_angle_deg: 24.0,
            shortest: 0.0,
            corner_angle_deg: 40.0,
            tip_defect: 1.2,
        }
    }
}

/// The edges and points that a surface keeps whatever its shape, by the points and triangles of the input.
#[derive(Clone, Copy, Debug, Default)]
pub struct Given<'a> {
    /// The group of each triangle; empty for one group.
    pub groups: &'a [u32],
    /// Edges that are features; those that no triangle has do not count.
    pub edges: &'a [[u32; 2]],
    /// Points that are corners.
    pub corners: &'a [u32],
}

/// Why an edge is a feature.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mark {
    Plain,
    /// Sharp enough to continue a line of sharp edges.
    Weak,
    Sharp,
    /// On the boundary, between groups, or given.
    Given,
}

impl Mark {
    fn is_feature(self) -> bool {
        matches!(self, Self::Sharp | Self::Given)
    }
}

struct Edge {
    ends: [u32; 2],
    /// Its triangle and edge; the neighbour's are found from them.
    half: (u32, usize),
    mark: Mark,
}

/// Bit i of a triangle: the edge opposite its corner i is a feature.
pub(crate) fn features(links: &Links, given: &Given<'_>, rules: &FeatureRules) -> Vec<u8> {
    let mut lines = FeatureLines::new(links, given, rules);
    lines.close_gaps(links, rules);
    lines.drop_short(links, rules.shortest);
    let mut bits = vec![0; links.triangles.len()];
    for edge in lines.edges.iter().filter(|edge| edge.mark.is_feature()) {
        let (t, i) = edge.half;
        bits[t as usize] |= 1 << i;
        let u = links.neighbours[t as usize][i];
        if u != NONE {
            let j = edge_of(links.triangles[u as usize], links.triangles[t as usize], i);
            bits[u as usize] |= 1 << j;
        }
    }
    bits
}

/// The edges that are features or may become features.
struct FeatureLines {
    edges: Vec<Edge>,
    /// The edges at each vertex: those of vertex v are `at[starts[v]..starts[v + 1]]`.
    starts: Vec<usize>,
    at: Vec<u32>,
}

impl FeatureLines {
    fn new(links: &Links, given: &Given<'_>, rules: &FeatureRules) -> Self {
        let mut kept: Vec<[u32; 2]> = given.edges.iter().copied().map(sorted).collect();
        kept.sort_unstable();
        let is_kept = |corners: [u32; 3], i: usize| {
            let ends = [1, 2].map(|j| links.inputs[corners[(i + j) % 3] as usize]);
            !kept.is_empty() && kept.binary_search(&sorted(ends)).is_ok()
        };
        let normals: Vec<DVec3> = links.triangles.iter().map(|t| normal(links, *t)).collect();
        let cosine = |degrees: f64| match degrees {
            d if d >= 180.0 => f64::NEG_INFINITY,
            d => libm::cos(d.max(0.0).to_radians()),
        };
        let (sharp, weak) = (cosine(rules.angle_deg), cosine(rules.weak_angle_deg));
        let is_off = rules.angle_deg >= 180.0;
        let mut edges = Vec::new();
        for (t, around) in (0_u32..).zip(&links.neighbours) {
            for (i, &u) in around.iter().enumerate() {
                if u < t {
                    continue;
                }
                let mark = if u == NONE {
                    Mark::Given
                } else {
                    let turn = normals[t as usize].dot(normals[u as usize]);
                    let group = |t: u32| given.groups.get(t as usize).copied();
                    match () {
                        () if group(t) != group(u) => Mark::Given,
                        () if is_kept(links.triangles[t as usize], i) => Mark::Given,
                        () if turn < sharp => Mark::Sharp,
                        () if turn < weak && !is_off => Mark::Weak,
                        () => Mark::Plain,
                    }
                };
                if mark != Mark::Plain {
                    let corners = links.triangles[t as usize];
                    let ends = [corners[(i + 1) % 3], corners[(i + 2) % 3]];
                    edges.push(Edge { ends, half: (t, i), mark });
                }
            }
        }
        let (starts, at) = by_vertex(links.points.len(), edges.iter().map(|edge: &Edge| edge.ends));
        Self { edges, starts, at }
    }

    /// The edges at a vertex that are features or may become features.
    fn around(&self, vertex: u32) -> &[u32] {
        &self.at[self.starts[vertex as usize]..self.starts[vertex as usize + 1]]
    }

    fn features_at(&self, vertex: u32) -> impl Iterator<Item = u32> + '_ {
        let around = self.around(vertex).iter().copied();
        around.filter(|&e| self.edges[e as usize].mark.is_feature())
    }

    fn is_end(&self, vertex: u32) -> bool {
        self.features_at(vertex).take(2).count() == 1
    }

    fn other_end(&self, edge: u32, vertex: u32) -> u32 {
        let [a, b] = self.edges[edge as usize].ends;
        if a == vertex { b } else { a }
    }

    /// From each end of a line, follows the weak edges that turn least; a walk that meets a feature becomes one.
    fn close_gaps(&mut self, links: &Links, rules: &FeatureRules) {
        let most = libm::cos(rules.corner_angle_deg.clamp(0.0, 180.0).to_radians());
        let ends: Vec<u32> = (0..links.points.len() as u32).filter(|&v| self.is_end(v)).collect();
        for start in ends {
            // An earlier walk may have ended here.
            let Some(last) = self.features_at(start).next().filter(|_| self.is_end(start)) else {
                continue;
            };
            let at = |v: u32| links.points[v as usize];
            let (mut vertex, mut from) = (start, self.other_end(last, start));
            let (mut walk, mut length) = (Vec::new(), 0.0);
            let closed = loop {
                let ahead = (at(vertex) - at(from)).normalize_or_zero();
                let turn = |e: u32| {
                    (at(self.other_end(e, vertex)) - at(vertex)).normalize_or_zero().dot(ahead)
                };
                let weak =
                    self.around(vertex).iter().copied().filter(|e| {
                        self.edges[*e as usize].mark == Mark::Weak && !walk.contains(e)
                    });
                let best = weak.map(|e| (turn(e), e)).filter(|(turn, _)| *turn > most);
                let Some((_, edge)) = best.max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)))
                else {
                    break false;
                };
                walk.push(edge);
                (from, vertex) = (vertex, self.other_end(edge, vertex));
                length += at(from).distance(at(vertex));
                if length > rules.shortest {
                    break false;
                }
                if self.features_at(vertex).next().is_some() {
                    break vertex != start;
                }
            };
            if closed {
                walk.iter().for_each(|&e| self.edges[e as usize].mark = Mark::Sharp);
            }
        }
    }

    /// Drops the sharp lines that end somewhere and are short, until none is left.
    fn drop_short(&mut self, links: &Links, shortest: f64) {
        let mut ends: Vec<u32> =
            (0..links.points.len() as u32).filter(|&v| self.is_end(v)).collect();
        let mut line = Vec::new();
        while let Some(start) = ends.pop() {
            if !self.is_end(start) {
                continue;
            }
            line.clear();
            let (mut vertex, mut length) = (start, 0.0);
            let mut next = self.features_at(start).next();
            let is_given = loop {
                let Some(edge) = next else { break false };
                if self.edges[edge as usize].mark == Mark::Given {
                    break line.is_empty();
                }
                line.push(edge);
                let to = self.other_end(edge, vertex);
                length += links.points[vertex as usize].distance(links.points[to as usize]);
                vertex = to;
                let mut others = self.features_at(vertex).filter(|&e| e != edge);
                // A line goes on where two edges meet.
                next = others.next().filter(|_| others.next().is_none());
            };
            if !is_given && length < shortest {
                line.iter().for_each(|&e| self.edges[e as usize].mark = Mark::Plain);
                ends.push(vertex);
            }
        }
    }
}

/// The unit normal of a triangle.
pub(crate) fn normal(links: &Links, triangle: [u32; 3]) -> DVec3 {
    let [a, b, c] = triangle.map(|v| links.points[v as usize]);
    (b - a).cross(c - a).normalize_or_zero()
}
