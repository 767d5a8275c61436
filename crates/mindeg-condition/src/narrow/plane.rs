//! The triangles of the plane around a boundary: on which side of it each is, and whether it is narrow.

use super::pieces::{Piece, Pieces, to_segment};
use super::rules::{Narrows, Rules};
use crate::chains::NONE;
use crate::error::ConditionError;
use glam::DVec2;
use mindeg_mesh::planar::PlanarBoundary;
use mindeg_mesh::{Progress, sorted};

/// The corners of the box around all.
const BOX: u32 = 4;

/// A triangle; side i goes from corner i to the next.
pub(super) struct Triangle {
    /// Nodes; none at a corner of the box.
    pub(super) corners: [Option<u32>; 3],
    /// The triangles behind its sides.
    pub(super) beside: [u32; 3],
    /// The pieces on its sides.
    pub(super) pieces: [Option<Piece>; 3],
    pub(super) is_domain: bool,
    /// Whether shores are nearer to each other here than the width.
    pub(super) is_narrow: bool,
    pub(super) area: f64,
}

impl Triangle {
    /// Whether it is on the side that is asked for.
    pub(super) fn is_of(&self, kind: Narrows) -> bool {
        self.is_domain == (kind == Narrows::Domain)
    }

    /// Whether nothing of the boundary is on one of its sides.
    pub(super) fn is_open(&self, side: usize) -> bool {
        self.pieces[side].is_none()
    }
}

/// All triangles.
pub(super) struct Plane<'p> {
    pub(super) pieces: &'p Pieces,
    pub(super) triangles: Vec<Triangle>,
}

impl<'p> Plane<'p> {
    pub(super) fn new(pieces: &'p Pieces, rules: &Rules<'_>) -> Result<Self, ConditionError> {
        let points: Vec<DVec2> = pieces.nodes.iter().map(|node| node.at).collect();
        let min = points.iter().copied().fold(DVec2::INFINITY, DVec2::min);
        let max = points.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
        let margin = DVec2::splat((max - min).max_element() + 4.0 * rules.width);
        let (low, high) = (min - margin, max + margin);
        let around = [low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)];
        let around = PlanarBoundary::new(&[around]).map_err(ConditionError::Unsound)?;
        let segments: Vec<[u32; 2]> =
            pieces.all.iter().map(|piece| piece.ends.map(|node| node + BOX)).collect();
        let triangles = mindeg_delaunay::triangles(&around, &points, &segments, Progress::NONE);
        let triangles = triangles.map_err(|error| ConditionError::Narrow(error.to_string()))?;
        let mut plane = Self { pieces, triangles: linked(&triangles, pieces) };
        plane.tell_sides();
        for index in 0..plane.triangles.len() {
            plane.triangles[index].is_narrow = plane.is_narrow(index, rules.width);
        }
        Ok(plane)
    }

    pub(super) fn at(&self, node: u32) -> DVec2 {
        self.pieces.nodes[node as usize].at
    }

    /// The ends of a side of a triangle, unless the box has one of them.
    pub(super) fn ends(&self, triangle: u32, side: usize) -> Option<[u32; 2]> {
        let corners = self.triangles[triangle as usize].corners;
        Some([corners[side]?, corners[(side + 1) % 3]?])
    }

    pub(super) fn length(&self, triangle: u32, side: usize) -> f64 {
        self.ends(triangle, side).map_or(f64::INFINITY, |[a, b]| self.at(a).distance(self.at(b)))
    }

    /// Spreads from the pieces on which side each triangle is.
    fn tell_sides(&mut self) {
        let mut is_known = vec![false; self.triangles.len()];
        let mut stack = Vec::new();
        for (index, triangle) in (0..).zip(&mut self.triangles) {
            let side = triangle.pieces.iter().position(Option::is_some);
            let Some((side, piece)) = side.and_then(|side| Some((side, triangle.pieces[side]?)))
            else {
                continue;
            };
            let is_ahead = Some(piece.ends[0]) == triangle.corners[side];
            triangle.is_domain = piece.has_domain[usize::from(!is_ahead)];
            is_known[index as usize] = true;
            stack.push(index);
        }
        while let Some(index) = stack.pop() {
            for side in 0..3 {
                let own = &self.triangles[index as usize];
                let (is_domain, other) = (own.is_domain, own.beside[side]);
                if own.is_open(side) && other != NONE && !is_known[other as usize] {
                    self.triangles[other as usize].is_domain = is_domain;
                    is_known[other as usize] = true;
                    stack.push(other);
                }
            }
        }
    }

    /// Whether what a triangle lies in is narrower than the width there: between a shore and a point, between the shores that
    /// meet at one of its corners, or between three points.
    fn is_narrow(&self, index: usize, width: f64) -> bool {
        let triangle = &self.triangles[index];
        let [Some(a), Some(b), Some(c)] = triangle.corners else { return false };
        let at = [a, b, c].map(|node| self.at(node));
        let length = |side: usize| at[side].distance(at[(side + 1) % 3]);
        let shores: Vec<usize> = (0..3).filter(|side| !triangle.is_open(*side)).collect();
        match shores[..] {
            [shore] => to_segment(at[(shore + 2) % 3], [at[shore], at[(shore + 1) % 3]]) < width,
            [first, second] => length(3 - first - second) < width,
            _ => (0..3).all(|side| length(side) < width),
        }
    }
}

/// The triangles with what is on their sides.
fn linked(triangles: &[[u32; 3]], pieces: &Pieces) -> Vec<Triangle> {
    let node = |vertex: u32| vertex.checked_sub(BOX);
    let at = |vertex: u32| node(vertex).map_or(DVec2::ZERO, |node| pieces.nodes[node as usize].at);
    let single = |corners: &[u32; 3]| {
        let nodes = corners.map(node);
        let piece = |side: usize| {
            let ends = [nodes[side]?, nodes[(side + 1) % 3]?];
            pieces.between(ends).map(|(piece, _)| piece)
        };
        let [a, b, c] = corners.map(at);
        Triangle {
            corners: nodes,
            beside: [NONE; 3],
            pieces: [0, 1, 2].map(piece),
            is_domain: false,
            is_narrow: false,
            area: (b - a).perp_dot(c - a) / 2.0,
        }
    };
    let mut all: Vec<Triangle> = triangles.iter().map(single).collect();
    let side = |(index, corners): (u32, &[u32; 3])| {
        let corners = *corners;
        (0..3_u32).map(move |side| {
            let edge = [corners[side as usize], corners[(side as usize + 1) % 3]];
            (sorted(edge), index, side)
        })
    };
    let mut sides: Vec<([u32; 2], u32, u32)> = (0..).zip(triangles).flat_map(side).collect();
    sides.sort_unstable();
    for pair in sides.windows(2) {
        let [(ends, first, side), (others, second, other)] = [pair[0], pair[1]];
        if ends == others {
            all[first as usize].beside[side as usize] = second;
            all[second as usize].beside[other as usize] = first;
        }
    }
    all
}
