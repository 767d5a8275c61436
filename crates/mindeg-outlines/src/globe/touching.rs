//! Points of degrees on edges of others, such as those of an island on the sides of a box.
//!
//! In the plane such an edge bends, and the point would lie beside it. So the edge gets the point before it is projected.

use std::collections::BTreeMap;

use glam::DVec2;

use super::box_sides::BoxSides;
use crate::outline::{DrawnRing, Piece};
use crate::overlay::edge::Edge;
use crate::overlay::near::near_vertices;
use crate::vertices::Vertices;

/// Points nearer to an edge, in degrees, are on it: rounding, a hundredth of a thousandth of a millimetre.
const ROUNDING: f64 = 1e-13;

/// The points that lie on edges of rings.
pub(super) struct Touching {
    /// By the edge, counted over all rings, in their order along it.
    on: BTreeMap<usize, Vec<DVec2>>,
    /// How many edges have been asked for.
    asked: usize,
}

impl Touching {
    pub(super) fn of<'a>(sides: &BoxSides, rings: impl Iterator<Item = &'a DrawnRing>) -> Self {
        let mut vertices = Vertices::new(DVec2::ZERO, ROUNDING);
        let mut degrees: Vec<DVec2> = Vec::new();
        let mut edges: Vec<Edge> = Vec::new();
        for ring in rings {
            let mut index = |piece: &Piece| {
                let index = vertices.index_near(sides.place(piece.start));
                if index as usize == degrees.len() {
                    degrees.push(piece.start);
                }
                index
            };
            let own: Vec<u32> = ring.pieces.iter().map(&mut index).collect();
            for (from, to) in own.iter().zip(own.iter().cycle().skip(1)) {
                edges.push(Edge { ends: [*from, *to], chord: 0 });
            }
        }
        for edge in &mut edges {
            let [from, to] = edge.ends.map(|end| vertices.points[end as usize]);
            // The short way round is past the end of the plane.
            if (from.x - to.x).abs() >= 180.0 {
                edge.ends[1] = edge.ends[0];
            }
        }
        let near = near_vertices(&edges, &vertices.points, ROUNDING);
        let in_order = |(edge, mut near): (usize, Vec<u32>)| {
            let start = vertices.points[edges[edge].ends[0] as usize];
            near.sort_by(|a, b| {
                let [a, b] = [a, b].map(|v| vertices.points[*v as usize].distance_squared(start));
                a.total_cmp(&b)
            });
            (edge, near.into_iter().map(|vertex| degrees[vertex as usize]).collect())
        };
        Self { on: near.into_iter().map(in_order).collect(), asked: 0 }
    }

    /// The next ring, with the points that lie on its edges.
    pub(super) fn noded(&mut self, pieces: &[Piece]) -> Vec<Piece> {
        let mut noded = Vec::with_capacity(pieces.len());
        for piece in pieces {
            noded.push(piece.clone());
            let on = self.on.get(&self.asked).into_iter().flatten();
            noded.extend(on.map(|at| Piece { side: piece.side.clone(), ..Piece::line(*at) }));
            self.asked += 1;
        }
        noded
    }
}
