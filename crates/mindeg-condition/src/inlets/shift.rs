//! Points that are moved, as far as the boundary may move.

use crate::chains::{Chains, NONE, farthest};
use crate::changes::{BoundaryChange, ChangeKind, Why};
use crate::demands::{BoundaryDemands, Hold};
use glam::DVec2;
use mindeg_mesh::planar::orientation;

/// An edge is long that has so many times the mean length.
const LONG: f64 = 4.0;

impl Chains<'_> {
    /// Where a point was before it was moved, and how far it may be from there; none if it may not be moved.
    pub(crate) fn reach(&self, vertex: u32, demands: &BoundaryDemands) -> Option<(DVec2, f64)> {
        let own = &self.vertices[vertex as usize];
        if own.hold > Hold::Free || own.previous == NONE || own.next == NONE {
            return None;
        }
        if self.is_on_straight(vertex) {
            return None;
        }
        // A point that was put on an edge is as far from the old boundary as that edge. A hair less, so that no rounding takes it
        // farther.
        let reach = (demands.within - own.off) * (1.0 - 1e-9);
        (reach > 0.0).then_some((own.home.unwrap_or(own.point.at), reach))
    }

    /// How far the boundary is moved if a vertex goes somewhere; none if that is too far.
    pub(crate) fn shifted_by(
        &self,
        vertex: u32,
        to: DVec2,
        demands: &BoundaryDemands,
    ) -> Option<f64> {
        let (home, _) = self.reach(vertex, demands)?;
        let own = &self.vertices[vertex as usize];
        let [before, after] = [self.previous(vertex), self.next(vertex)];
        let dropped = |v: u32, ends| farthest(&self.vertices[v as usize].dropped, ends);
        let moved = home
            .distance(to)
            .max(dropped(before, [self.at(before), to]))
            .max(dropped(vertex, [to, self.at(after)]));
        (home.distance(to) <= demands.within - own.off && moved <= demands.within).then_some(moved)
    }

    /// From here on the grid finds edges where they pass, not only at their first points.
    pub(crate) fn put_edges(&mut self) {
        if self.spacing.is_finite() {
            return;
        }
        let edges: Vec<u32> = self.edges().collect();
        let mean = edges.iter().map(|edge| self.length(*edge)).sum::<f64>() / edges.len() as f64;
        self.spacing = LONG * mean;
        edges.into_iter().for_each(|edge| self.put_along(edge));
    }

    /// Puts a long edge into the grid where it passes.
    pub(crate) fn put_along(&mut self, edge: u32) {
        let ends = [edge, self.next(edge)].map(|v| self.at(v));
        let parts = (ends[0].distance(ends[1]) / self.spacing).ceil();
        for part in 1..parts as u32 {
            self.grid.insert(edge, ends[0].lerp(ends[1], f64::from(part) / parts));
        }
    }

    /// Whether nothing lies between a vertex with its edges and where it is to go.
    pub(crate) fn is_shift_free(&self, vertex: u32, to: DVec2) -> bool {
        let around = [self.previous(vertex), self.next(vertex)];
        let at = self.at(vertex);
        let places = [around[0], vertex, around[1]].map(|v| self.place(v));
        let corners = around.map(|v| [self.at(v), at, to]);
        if corners.iter().any(|corners| !self.is_free(*corners, places)) {
            return false;
        }
        // An edge may pass through without a point there.
        let all = [at, to, corners[0][0], corners[1][0]];
        let low = all.into_iter().fold(DVec2::INFINITY, DVec2::min) - self.spacing;
        let high = all.into_iter().fold(DVec2::NEG_INFINITY, DVec2::max) + self.spacing;
        !self.grid.any_near([low, high], |edge| {
            self.is_edge(edge)
                && edge != vertex
                && edge != around[0]
                && corners.iter().any(|corners| self.is_in_the_way(edge, *corners, places))
        })
    }

    /// Whether an edge meets a triangle elsewhere than at its first corner, which it may begin or end at.
    fn is_in_the_way(&self, edge: u32, [first, at, to]: [DVec2; 3], places: [u32; 3]) -> bool {
        let ends = [edge, self.next(edge)];
        let points = ends.map(|v| self.at(v));
        // Edges of one line cross only where they are.
        let (low, high) = (first.min(at).min(to), first.max(at).max(to));
        let [a, b] = points;
        if (a.max(b).cmplt(low) | a.min(b).cmpgt(high)).any() {
            return false;
        }
        let touching = ends.iter().position(|v| places.contains(&self.place(*v)));
        if let Some(own) = touching.filter(|own| points[*own] == first) {
            // Towards the far side of the triangle.
            let other = points[1 - own];
            let sense = orientation(first, at, to);
            if sense == 0.0 {
                return orientation(first, at, other) == 0.0;
            }
            return orientation(first, at, other) * sense >= 0.0
                && orientation(first, to, other) * sense <= 0.0;
        }
        let crosses = |[a, b]: [DVec2; 2]| {
            let sides = [orientation(a, b, points[0]), orientation(a, b, points[1])];
            let own = [orientation(points[0], points[1], a), orientation(points[0], points[1], b)];
            sides[0] * sides[1] <= 0.0 && own[0] * own[1] <= 0.0
        };
        [[first, at], [at, to], [to, first]].into_iter().any(crosses)
    }

    /// Moves a vertex.
    pub(crate) fn shift(&mut self, vertex: u32, to: DVec2, why: Why, demands: &BoundaryDemands) {
        let Some((home, _)) = self.reach(vertex, demands) else { return };
        let before = self.previous(vertex);
        let off = self.vertices[vertex as usize].off;
        self.shifted = self.shifted.max(home.distance(to) + off);
        let own = &mut self.vertices[vertex as usize];
        if own.home.is_none() {
            own.home = Some(home);
            let (kind, edge) = (ChangeKind::Shifted, own.point.edge);
            self.changes.push(BoundaryChange::of_edge(kind, home, why, edge));
        }
        own.point.at = to;
        own.point.of = None;
        self.grid.insert(vertex, to);
        [before, vertex].into_iter().for_each(|edge| self.put_along(edge));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::demands::Given;
    use mindeg_mesh::planar::PlanarBoundary;

    /// A box, 1,000 long, with a fine island near the middle of its lower side, and another one far away on the line of one of its edges.
    #[test]
    fn a_long_edge_is_in_the_way_where_it_passes_and_one_far_away_is_not() {
        let fine = |x: f64, y: f64| -> Vec<DVec2> {
            let up = [[0.0, 0.0], [0.0, 1.0], [0.0, 2.0], [1.0, 2.0], [1.0, 1.0], [1.0, 0.0]];
            up.map(|[i, j]| DVec2::new(x + i, y + j)).to_vec()
        };
        let sea = [[0.0, 0.0], [1000.0, 0.0], [1000.0, 1000.0], [0.0, 1000.0]].map(DVec2::from);
        let mut rings = vec![sea.to_vec(), fine(500.0, 2.0), fine(900.0, 2.0)];
        rings.extend((0..200).map(|i| fine(8.0 + 4.0 * f64::from(i), 900.0)));
        let boundary = PlanarBoundary::new(&rings).unwrap();
        let given = Given {
            hold: |_| Hold::Free,
            has_domain: |_| [true, false],
            is_straight: |_| false,
            size_at: &|_| f64::INFINITY,
            marks: &[],
        };
        let mut chains = Chains::new(&boundary, &given, 1);
        chains.put_edges();
        let corner = 4;
        assert_eq!(chains.at(corner), DVec2::new(500.0, 2.0));
        assert!(chains.is_shift_free(corner, DVec2::new(499.5, 1.0)));
        assert!(!chains.is_shift_free(corner, DVec2::new(499.5, -1.0)));
        // An edge of another island lies on the line along which the corner moves, far away.
        let far = chains.edges().find(|edge| chains.at(*edge) == DVec2::new(901.0, 2.0)).unwrap();
        let to = DVec2::new(499.5, 2.0);
        let places = [9, 4, 5].map(|vertex| chains.place(vertex));
        let corners = [chains.at(9), chains.at(corner), to];
        assert!(!chains.is_in_the_way(far, corners, places));
        assert!(chains.is_shift_free(corner, to));
    }
}
