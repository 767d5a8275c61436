//! Points of degrees on edges along meridians and parallels, such as those of an island on the sides of a box.
//!
//! In the plane such an edge bends, and the point would lie beside it. So the edge gets the point before it is projected.

use std::collections::BTreeMap;

use glam::DVec2;

use super::box_sides::BoxSides;
use crate::outline::Piece;

/// All points by their meridians and by their parallels, in order.
pub(super) struct Touching {
    /// For the axis along which they are told apart: by the other coordinate.
    along: [BTreeMap<u64, Vec<DVec2>>; 2],
}

/// The bits of a coordinate; 0 has one sign.
fn bits(coordinate: f64) -> u64 {
    (coordinate + 0.0).to_bits()
}

impl Touching {
    pub(super) fn of(sides: &BoxSides, points: impl Iterator<Item = DVec2>) -> Self {
        let mut along: [BTreeMap<u64, Vec<DVec2>>; 2] = Default::default();
        for point in points {
            let at = sides.place(point);
            for (axis, lines) in along.iter_mut().enumerate() {
                lines.entry(bits(at[1 - axis])).or_default().push(point);
            }
        }
        for (axis, lines) in along.iter_mut().enumerate() {
            for points in lines.values_mut() {
                let place = |point: &DVec2| sides.place(*point)[axis];
                points.sort_by(|a, b| place(a).total_cmp(&place(b)));
                points.dedup_by(|a, b| place(a) == place(b));
            }
        }
        Self { along }
    }

    /// A ring whose edges along meridians and parallels have the points that lie on them.
    pub(super) fn noded(&self, sides: &BoxSides, pieces: &[Piece]) -> Vec<Piece> {
        let mut noded = Vec::with_capacity(pieces.len());
        for (index, piece) in pieces.iter().enumerate() {
            noded.push(piece.clone());
            let ends = [piece.start, pieces[(index + 1) % pieces.len()].start];
            let [from, to] = ends.map(|end| sides.place(end));
            for axis in [0, 1] {
                // The short way round.
                let is_along =
                    from[1 - axis] == to[1 - axis] && (from[axis] - to[axis]).abs() < 180.0;
                let line = self.along[axis].get(&bits(from[1 - axis])).filter(|_| is_along);
                let Some(line) = line else { continue };
                let [low, high] = [from[axis].min(to[axis]), from[axis].max(to[axis])];
                let place = |point: &DVec2| sides.place(*point)[axis];
                let first = line.partition_point(|point| place(point) <= low);
                let last = line.partition_point(|point| place(point) < high).max(first);
                let mut between = line[first..last].to_vec();
                if from[axis] > to[axis] {
                    between.reverse();
                }
                let side = &piece.side;
                noded.extend(
                    between.into_iter().map(|at| Piece { side: side.clone(), ..Piece::line(at) }),
                );
            }
        }
        noded
    }
}
