//! The points of a boundary in square cells: which lie in a triangle.

use glam::DVec2;
use mindeg_mesh::planar::orientation;

/// Indices of points by cells.
pub(crate) struct Grid {
    min: DVec2,
    cell: f64,
    columns: usize,
    cells: Vec<Vec<u32>>,
    /// All points with their indices.
    points: Vec<(u32, DVec2)>,
    /// With more points than this, cells become smaller.
    most: usize,
}

/// Cells become smaller where there are so many times the points.
const GROWN: usize = 4;

impl Grid {
    /// About two points to a cell.
    pub(crate) fn new(points: &[DVec2]) -> Self {
        Self::of((0..).zip(points.iter().copied()).collect())
    }

    fn of(points: Vec<(u32, DVec2)>) -> Self {
        let at = || points.iter().map(|point| point.1);
        let min = at().fold(DVec2::INFINITY, DVec2::min);
        let max = at().fold(DVec2::NEG_INFINITY, DVec2::max);
        let extent = (max - min).max(DVec2::splat(f64::MIN_POSITIVE));
        let across = (points.len() as f64 / 2.0).sqrt().max(1.0);
        let cell = extent.max_element() / across;
        let count = |length: f64| ((length / cell) as usize + 1).min(2 * across as usize + 2);
        let (columns, rows) = (count(extent.x), count(extent.y));
        let cells = vec![Vec::new(); columns * rows];
        let most = GROWN * points.len().max(1);
        let mut grid = Self { min, cell, columns, cells, points, most };
        for place in 0..grid.points.len() {
            grid.put(place);
        }
        grid
    }

    /// Puts one of the points into its cell.
    fn put(&mut self, place: usize) {
        let (index, point) = self.points[place];
        let [column, row] = self.column_and_row(point);
        self.cells[row * self.columns + column].push(index);
    }

    fn column_and_row(&self, point: DVec2) -> [usize; 2] {
        let at = ((point - self.min) / self.cell).max(DVec2::ZERO);
        let rows = self.cells.len() / self.columns;
        [(at.x as usize).min(self.columns - 1), (at.y as usize).min(rows - 1)]
    }

    /// Constant time in the mean.
    pub(crate) fn insert(&mut self, index: u32, point: DVec2) {
        self.points.push((index, point));
        if self.points.len() > self.most {
            *self = Self::of(std::mem::take(&mut self.points));
        } else {
            self.put(self.points.len() - 1);
        }
    }

    /// True if `is_wanted` holds for an index in the cells of a box.
    pub(crate) fn any_near(
        &self,
        [least, most]: [DVec2; 2],
        is_wanted: impl Fn(u32) -> bool,
    ) -> bool {
        let [low, high] = [least, most].map(|point| self.column_and_row(point));
        (low[1]..=high[1]).any(|row| {
            let row = row * self.columns;
            (low[0]..=high[0])
                .any(|column| self.cells[row + column].iter().any(|&own| is_wanted(own)))
        })
    }

    /// True if `is_in_the_way` holds for a point in the closed triangle that `at` gives for its index.
    pub(crate) fn any_within(
        &self,
        corners: [DVec2; 3],
        at: impl Fn(u32) -> DVec2,
        is_in_the_way: impl Fn(u32) -> bool,
    ) -> bool {
        let [a, b, c] = corners;
        let (least, most) = (a.min(b).min(c), a.max(b).max(c));
        let sense = if orientation(a, b, c) < 0.0 { -1.0 } else { 1.0 };
        let is_left = |[from, to]: [DVec2; 2], point| sense * orientation(from, to, point) >= 0.0;
        let is_within = |point: DVec2| {
            // Of a flat triangle every point of its line is on the left.
            point.cmpge(least).all()
                && point.cmple(most).all()
                && [[a, b], [b, c], [c, a]].into_iter().all(|side| is_left(side, point))
        };
        self.any_near([least, most], |index| is_in_the_way(index) && is_within(at(index)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A grid that grows knows the points that one made of all of them knows, in cells as small.
    #[test]
    fn cells_shrink_as_points_are_added() {
        let at = |i: u32| DVec2::new(f64::from(i % 100), f64::from(i / 100));
        let corners = [[0.0, 0.0], [99.0, 0.0], [99.0, 99.0], [0.0, 99.0]].map(DVec2::from);
        let mut grid = Grid::new(&corners);
        for i in 0..10_000 {
            grid.insert(4 + i, at(i));
        }
        assert!(grid.cells.iter().all(|cell| cell.len() <= 16), "{}", grid.cells.len());
        for i in 0..10_000 {
            assert!(grid.any_near([at(i); 2], |index| index == 4 + i), "{i}");
        }
    }
}
