//! The boundary in pieces that are short where something else is near.

use super::rules::Rules;
use crate::changes::Point;
use crate::demands::Hold;
use crate::error::ConditionError;
use glam::{DVec2, DVec3};
use mindeg_mesh::planar::PlanarBoundary;
use mindeg_mesh::{Bounds, BoxTree};
use std::collections::BTreeMap;

/// The most nodes.
const MOST_NODES: usize = 10_000_000;
/// Two edges that meet at an angle with at most this cosine are not near each other there.
const BLUNT: f64 = 0.5;

/// A place of the boundary.
pub(super) struct Node {
    pub(super) at: DVec2,
    /// As a point of the ring that it is on; the edge is that which goes on from it.
    pub(super) point: Option<Point>,
    pub(super) hold: Hold,
    /// Whether more than one vertex is here.
    pub(super) is_shared: bool,
}

/// A piece of an edge.
#[derive(Clone, Copy)]
pub(super) struct Piece {
    pub(super) ends: [u32; 2],
    /// Where the edge that it is a piece of begins, counted over all points of rings; none for lines.
    pub(super) of: Option<u32>,
    /// The point of a ring at which it begins.
    pub(super) from: Option<Point>,
    pub(super) has_domain: [bool; 2],
    /// Whether its edge stays.
    pub(super) is_held: bool,
}

/// All pieces of rings and lines, sorted by their ends.
pub(super) struct Pieces {
    pub(super) nodes: Vec<Node>,
    pub(super) all: Vec<Piece>,
}

impl Pieces {
    /// The pieces of rings, and of the lines of the old boundary, which stay.
    pub(super) fn new(
        boundary: &PlanarBoundary,
        rings: &[Vec<Point>],
        rules: &Rules<'_>,
    ) -> Result<Self, ConditionError> {
        let around = |ring: &Vec<Point>| -> Vec<[DVec2; 2]> {
            (0..ring.len()).map(|i| [ring[i].at, ring[(i + 1) % ring.len()].at]).collect()
        };
        let segments = boundary.segments().iter();
        let of_lines = segments.map(|ends| ends.map(|vertex| boundary.point(vertex)));
        let edges: Vec<[DVec2; 2]> = rings.iter().flat_map(around).chain(of_lines).collect();
        let near = Near::new(edges, rules.width);
        let mut known: BTreeMap<[u64; 2], u32> = BTreeMap::new();
        let mut pieces = Self { nodes: Vec::new(), all: Vec::new() };
        let mut edge = 0;
        for ring in rings {
            let mut around: Vec<(u32, Piece)> = Vec::with_capacity(ring.len());
            for point in ring {
                let hold = (rules.hold)(point.edge);
                let is_held = hold == Hold::Edge;
                let hold = if point.of.is_some() { hold } else { Hold::Free };
                let mut inner = Vec::new();
                near.divide(edge as usize, &mut inner)?;
                let piece = Piece {
                    ends: [0; 2],
                    of: Some(edge),
                    from: Some(*point),
                    has_domain: (rules.has_domain)(point.edge),
                    is_held,
                };
                around.push((pieces.node(&mut known, *point, hold), piece));
                for at in inner {
                    let point = Point { at, of: None, edge: point.edge };
                    let piece = Piece { from: Some(point), ..piece };
                    around.push((pieces.node(&mut known, point, Hold::Free), piece));
                }
                edge += 1;
            }
            for (index, (from, piece)) in around.iter().enumerate() {
                let to = around[(index + 1) % around.len()].0;
                pieces.all.push(Piece { ends: [*from, to], ..*piece });
            }
        }
        for (line, ends) in (boundary.vertex_count()..).zip(boundary.segments()) {
            let has_domain = (rules.has_domain)(line);
            let mut places = vec![boundary.point(ends[0])];
            near.divide(edge as usize, &mut places)?;
            places.push(boundary.point(ends[1]));
            let nodes: Vec<u32> = places
                .into_iter()
                .map(|at| {
                    let node = pieces.place(&mut known, at);
                    pieces.nodes[node as usize].hold = Hold::Edge;
                    node
                })
                .collect();
            pieces.all.extend(nodes.windows(2).map(|pair| {
                let ends = [pair[0], pair[1]];
                Piece { ends, of: None, from: None, has_domain, is_held: true }
            }));
            edge += 1;
        }
        pieces.all.sort_unstable_by_key(|piece| piece.ends);
        if pieces.nodes.len() > MOST_NODES {
            return Err(ConditionError::Points(MOST_NODES));
        }
        Ok(pieces)
    }

    /// The node at a place.
    fn place(&mut self, known: &mut BTreeMap<[u64; 2], u32>, at: DVec2) -> u32 {
        let new = self.nodes.len() as u32;
        // Adding 0 makes 0 of -0.
        let node = *known.entry(at.to_array().map(|it| (it + 0.0).to_bits())).or_insert(new);
        if node == new {
            self.nodes.push(Node { at, point: None, hold: Hold::Free, is_shared: false });
        }
        node
    }

    /// The node of a point of a ring.
    fn node(&mut self, known: &mut BTreeMap<[u64; 2], u32>, point: Point, hold: Hold) -> u32 {
        let index = self.place(known, point.at);
        let node = &mut self.nodes[index as usize];
        node.is_shared |= node.point.is_some();
        node.point = Some(point);
        node.hold = node.hold.max(hold);
        index
    }

    /// The piece between two nodes, and whether it runs that way.
    pub(super) fn between(&self, [from, to]: [u32; 2]) -> Option<(Piece, bool)> {
        let find = |ends: [u32; 2]| self.all.binary_search_by_key(&ends, |piece| piece.ends).ok();
        let there = find([from, to]).map(|index| (self.all[index], true));
        there.or_else(|| find([to, from]).map(|index| (self.all[index], false)))
    }
}

/// Which edges are nearer to a part of another than the width.
struct Near {
    edges: Vec<[DVec2; 2]>,
    tree: BoxTree,
    width: f64,
}

impl Near {
    fn new(edges: Vec<[DVec2; 2]>, width: f64) -> Self {
        let around = |[a, b]: &[DVec2; 2]| bounds([*a, *b], 0.0);
        let tree = BoxTree::new(edges.iter().map(around).collect());
        Self { edges, tree, width }
    }

    /// Points on an edge that part it to half the width where another one is near, in their order.
    fn divide(&self, edge: usize, inner: &mut Vec<DVec2>) -> Result<(), ConditionError> {
        let mut stack = vec![self.edges[edge]];
        while let Some([from, to]) = stack.pop() {
            let middle = from.midpoint(to);
            let is_long = from.distance(to) > self.width / 2.0 && middle != from && middle != to;
            if is_long && self.is_near(edge, [from, to]) {
                stack.extend([[middle, to], [from, middle]]);
            } else if to != self.edges[edge][1] {
                inner.push(to);
            }
            if inner.len() > MOST_NODES {
                return Err(ConditionError::Points(MOST_NODES));
            }
        }
        Ok(())
    }

    /// Whether another edge is near a part of one.
    fn is_near(&self, edge: usize, part: [DVec2; 2]) -> bool {
        let mut others = Vec::new();
        self.tree.meet(bounds(part, self.width), &mut others);
        let own = self.edges[edge];
        others.into_iter().any(|other| {
            let is_own = other as usize == edge;
            let other = self.edges[other as usize];
            !is_own && !are_blunt(own, other) && apart(part, other) < self.width
        })
    }
}

fn bounds([a, b]: [DVec2; 2], margin: f64) -> Bounds<DVec3> {
    let margin = DVec2::splat(margin);
    Bounds { min: (a.min(b) - margin).extend(0.0), max: (a.max(b) + margin).extend(0.0) }
}

/// Whether two edges share an end, at an angle that is not sharp.
fn are_blunt(a: [DVec2; 2], b: [DVec2; 2]) -> bool {
    let cosine = |[at, to]: [DVec2; 2], [other_at, other]: [DVec2; 2]| {
        (at == other_at)
            .then(|| (to - at).normalize_or_zero().dot((other - at).normalize_or_zero()))
    };
    let turned = |[from, to]: [DVec2; 2]| [to, from];
    let pairs = [(a, b), (turned(a), b), (a, turned(b)), (turned(a), turned(b))];
    pairs.into_iter().any(|(a, b)| cosine(a, b).is_some_and(|cosine| cosine <= BLUNT))
}

/// The distance of two segments that do not cross.
fn apart(a: [DVec2; 2], b: [DVec2; 2]) -> f64 {
    let of = |points: [DVec2; 2], segment| {
        points.into_iter().map(|point| to_segment(point, segment)).fold(f64::INFINITY, f64::min)
    };
    of(a, b).min(of(b, a))
}

/// The distance of a point from a segment.
pub(super) fn to_segment(point: DVec2, ends: [DVec2; 2]) -> f64 {
    crate::chains::farthest(&[point], ends)
}
