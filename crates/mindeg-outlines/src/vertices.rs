//! Points by index, found again by where they are.

use std::collections::BTreeMap;

use glam::DVec2;

use super::outline::key;

/// Points in the order of their indices.
pub(super) struct Vertices {
    pub(super) points: Vec<DVec2>,
    tolerance: f64,
    origin: DVec2,
    /// The indices of the points in each square cell.
    cells: BTreeMap<(u64, u64), Vec<u32>>,
}

impl Vertices {
    /// No points yet; those to come lie between two corners and count as near within the tolerance.
    pub(super) fn new(origin: DVec2, tolerance: f64) -> Self {
        Self { points: Vec::new(), tolerance, origin, cells: BTreeMap::new() }
    }

    /// The index of this very point, which is added if it is new.
    pub(super) fn index(&mut self, point: DVec2) -> u32 {
        let cell = self.cell(point);
        let mut here = self.cells.get(&cell).into_iter().flatten().copied();
        let found = here.find(|&index| self.points[index as usize] == point);
        found.unwrap_or_else(|| self.add(point, cell))
    }

    /// The lowest index of a point within the tolerance, or that of this point, which is added then.
    pub(super) fn index_near(&mut self, point: DVec2) -> u32 {
        let reach = DVec2::splat(self.tolerance);
        let (low, high) = (point - reach, point + reach);
        let corners = [low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)];
        let is_near = |&index: &u32| {
            (self.points[index as usize] - point).abs().max_element() <= self.tolerance
        };
        let cells = corners.into_iter().filter_map(|corner| self.cells.get(&self.cell(corner)));
        let found = cells.flatten().copied().filter(is_near).min();
        found.unwrap_or_else(|| self.add(point, self.cell(point)))
    }

    fn cell(&self, point: DVec2) -> (u64, u64) {
        // Four times the tolerance: twice could skip the middle one of three cells by rounding.
        let size = if self.tolerance > 0.0 { 4.0 * self.tolerance } else { 1.0 };
        key(((point - self.origin) / size).floor())
    }

    fn add(&mut self, point: DVec2, cell: (u64, u64)) -> u32 {
        let index = self.points.len() as u32;
        self.cells.entry(cell).or_default().push(index);
        self.points.push(point);
        index
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_within_the_tolerance_are_one() {
        let points = [
            [0.0, 0.0],
            [100.0, 0.0],
            [100.00005, 0.00009],
            [0.0, 1.0],
            [0.00005, -0.0],
            [-0.0, 0.0],
            [50.0, 0.0002],
        ];
        let mut vertices = Vertices::new(DVec2::ZERO, 1e-4);
        let indices = points.map(|point| vertices.index_near(point.into()));
        assert_eq!(indices, [0, 1, 1, 2, 0, 0, 3]);
        let indices = points.map(|point| vertices.index(point.into()));
        assert_eq!(indices, [0, 1, 4, 2, 5, 0, 3]);
    }
}
