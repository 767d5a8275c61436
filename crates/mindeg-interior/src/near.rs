//! The nearest of a growing set of points, at any mixture of spacings: a quadtree.

use glam::DVec2;
use mindeg_mesh::Bounds;

const NONE: u32 = u32::MAX;
/// A cell with more points is divided.
const FULL: u32 = 8;
/// Cells of this depth are not divided: their points are (nearly) one.
const DEEPEST: u32 = 50;

#[derive(Debug, Clone, Copy)]
struct Cell {
    /// The first of four children, 0 for a leaf.
    children: u32,
    /// The first point of a leaf's list.
    head: u32,
    count: u32,
}

/// Points that can be asked for the nearest one; insertion and query take O(log n) for points with spacing.
#[derive(Debug, Clone)]
pub(crate) struct Near {
    points: Vec<DVec2>,
    /// The next point in the list of a leaf.
    next: Vec<u32>,
    cells: Vec<Cell>,
    middle: DVec2,
    half: f64,
}

impl Near {
    /// An empty set for points of a box.
    pub(crate) fn new(bounds: Bounds) -> Self {
        Self {
            points: Vec::new(),
            next: Vec::new(),
            cells: vec![Cell { children: 0, head: NONE, count: 0 }],
            middle: bounds.min.midpoint(bounds.max),
            half: bounds.size().max_element() / 2.0,
        }
    }

    pub(crate) fn points(&self) -> &[DVec2] {
        &self.points
    }

    pub(crate) fn insert(&mut self, point: DVec2) {
        let index = self.points.len() as u32;
        self.points.push(point);
        self.next.push(NONE);
        let (mut at, mut middle, mut half) = (0, self.middle, self.half);
        let mut depth = 0;
        while self.cells[at].children != 0 {
            half /= 2.0;
            let quadrant = quadrant(point, middle);
            at = self.cells[at].children as usize + quadrant;
            middle += offset(quadrant) * half;
            depth += 1;
        }
        let cell = &mut self.cells[at];
        self.next[index as usize] = cell.head;
        cell.head = index;
        cell.count += 1;
        if cell.count > FULL && depth < DEEPEST {
            self.divide(at, middle);
        }
    }

    fn divide(&mut self, at: usize, middle: DVec2) {
        let children = self.cells.len();
        self.cells.extend([Cell { children: 0, head: NONE, count: 0 }; 4]);
        let mut point = self.cells[at].head;
        self.cells[at] = Cell { children: children as u32, head: NONE, count: 0 };
        while point != NONE {
            let next = self.next[point as usize];
            let cell = &mut self.cells[children + quadrant(self.points[point as usize], middle)];
            self.next[point as usize] = cell.head;
            cell.head = point;
            cell.count += 1;
            point = next;
        }
    }

    /// The nearest point and its distance, if any is nearer than `within`.
    pub(crate) fn nearest(&self, x: DVec2, within: f64) -> Option<(u32, f64)> {
        let mut best = (NONE, within * within);
        self.search(0, self.middle, self.half, x, &mut best);
        (best.0 != NONE).then(|| (best.0, best.1.sqrt()))
    }

    /// Whether any point is nearer than `within`: as [`Self::nearest`], and ends at the first.
    pub(crate) fn has(&self, x: DVec2, within: f64) -> bool {
        self.meets(0, self.middle, self.half, x, within * within)
    }

    fn meets(&self, at: usize, middle: DVec2, half: f64, x: DVec2, squared: f64) -> bool {
        let cell = self.cells[at];
        if cell.children == 0 {
            return self.list(cell).any(|(_, point)| point.distance_squared(x) < squared);
        }
        nearest_first(middle, half, x).into_iter().any(|(child, middle, half, beyond)| {
            beyond < squared && self.meets(cell.children as usize + child, middle, half, x, squared)
        })
    }

    /// The points of a leaf.
    fn list(&self, leaf: Cell) -> impl Iterator<Item = (u32, DVec2)> {
        let mut next = leaf.head;
        std::iter::from_fn(move || {
            let point = next;
            next = *self.next.get(point as usize)?;
            Some((point, self.points[point as usize]))
        })
    }

    fn search(&self, at: usize, middle: DVec2, half: f64, x: DVec2, best: &mut (u32, f64)) {
        let cell = self.cells[at];
        if cell.children == 0 {
            for (index, point) in self.list(cell) {
                let squared = point.distance_squared(x);
                if squared < best.1 {
                    *best = (index, squared);
                }
            }
            return;
        }
        for (child, middle, half, beyond) in nearest_first(middle, half, x) {
            if beyond < best.1 {
                self.search(cell.children as usize + child, middle, half, x, best);
            }
        }
    }
}

/// The quarters of a cell, that of `x` first: their number, middle and half side, and how far they are at least from `x`, squared, as
/// the lines through the middle tell.
fn nearest_first(middle: DVec2, half: f64, x: DVec2) -> [(usize, DVec2, f64, f64); 4] {
    let (first, half, away) = (quadrant(x, middle), half / 2.0, x - middle);
    let [across, up] = [away.x * away.x, away.y * away.y];
    [(0, 0.0), (1, across), (2, up), (3, across + up)].map(|(bits, beyond)| {
        let quadrant = first ^ bits;
        (quadrant, middle + offset(quadrant) * half, half, beyond)
    })
}

fn quadrant(point: DVec2, middle: DVec2) -> usize {
    usize::from(point.x > middle.x) + 2 * usize::from(point.y > middle.y)
}

fn offset(quadrant: usize) -> DVec2 {
    let sign = |bit: usize| if quadrant & bit == 0 { -1.0 } else { 1.0 };
    DVec2::new(sign(1), sign(2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_nearest_is_that_of_a_full_search(
            points in prop::collection::vec((0.0..8.0_f64, 0.0..5.0_f64, 0..4), 1..200),
            queries in prop::collection::vec((-1.0..9.0_f64, -1.0..6.0_f64), 20),
        ) {
            let mut near = Near::new(Bounds { min: DVec2::ZERO, max: DVec2::new(8.0, 5.0) });
            for (x, y, power) in points {
                // Many points in a corner, and some twice.
                let scale = 10_f64.powi(-4 * power);
                near.insert(DVec2::new((x * scale * 8.0).round() / 8.0 , y * scale));
            }
            for x in queries.into_iter().map(DVec2::from) {
                let brute = near.points().iter().map(|p| p.distance(x)).fold(f64::INFINITY, f64::min);
                let found = near.nearest(x, f64::INFINITY).unwrap();
                prop_assert!((found.1 - brute).abs() <= 1e-12 * brute);
                prop_assert!(near.nearest(x, brute * 0.999).is_none());
                let both = [0.999, 1.001].map(|share| near.has(x, brute * share));
                prop_assert_eq!(both, [false, brute > 0.0]);
            }
        }

        #[test]
        fn many_equal_points_are_no_trouble(count in 1..100_usize) {
            let mut near = Near::new(Bounds { min: DVec2::ZERO, max: DVec2::ONE });
            (0..count).for_each(|_| near.insert(DVec2::splat(0.3)));
            prop_assert_eq!(near.nearest(DVec2::splat(0.3), 1.0).unwrap().1, 0.0);
        }
    }
}
