//! Points of degrees on edges of others, such as those of an island on the sides of a box.
//!
//! In the plane such an edge bends, and the point would lie beside it. So the edge gets the point before it is projected.

use glam::DVec2;

use super::box_sides::BoxSides;
use crate::outline::{Feature, Piece};
use crate::overlay::edge::Edge;
use crate::overlay::near::near_vertices;
use crate::vertices::Vertices;

/// Points nearer to an edge, in degrees, are on it: rounding, a hundredth of a thousandth of a millimetre.
const ROUNDING: f64 = 1e-13;

/// Gives the edges of all rings the points of others that lie on them.
pub(super) fn node_touching(sides: &BoxSides, features: &mut [Feature]) {
    let mut vertices = Vertices::new(DVec2::ZERO, ROUNDING);
    let mut degrees: Vec<DVec2> = Vec::new();
    let mut edges: Vec<Edge> = Vec::new();
    for ring in features.iter().flat_map(|feature| &feature.rings) {
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
    let at = |vertex: u32| vertices.points[vertex as usize];
    for edge in &mut edges {
        // The short way round is past the end of the plane.
        if (at(edge.ends[0]).x - at(edge.ends[1]).x).abs() >= 180.0 {
            edge.ends[1] = edge.ends[0];
        }
    }
    let mut near = near_vertices(&edges, &vertices.points, ROUNDING);
    let mut edges = edges.iter().enumerate();
    for ring in features.iter_mut().flat_map(|feature| &mut feature.rings) {
        let mut noded = Vec::with_capacity(ring.pieces.len());
        for (piece, (index, edge)) in ring.pieces.drain(..).zip(edges.by_ref()) {
            let mut on = near.remove(&index).unwrap_or_default();
            let along = |vertex: u32| at(vertex).distance_squared(at(edge.ends[0]));
            on.sort_by(|a, b| along(*a).total_cmp(&along(*b)));
            let side = piece.side.clone();
            noded.push(piece);
            noded.extend(on.into_iter().map(|vertex| Piece {
                side: side.clone(),
                ..Piece::line(degrees[vertex as usize])
            }));
        }
        ring.pieces = noded;
    }
}
