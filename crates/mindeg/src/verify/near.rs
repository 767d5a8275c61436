//! The nearest of some points, within a distance.

use glam::DVec2;

/// Points in the squares of a grid.
pub(super) struct Near<'a> {
    points: &'a [DVec2],
    origin: DVec2,
    tolerance: f64,
    /// The width of a square: as wide as a search, or there would be too many.
    width: f64,
    /// Each point with its square, sorted.
    squares: Vec<([i64; 2], u32)>,
}

impl<'a> Near<'a> {
    /// Points to be found within `tolerance`; `extent` is that of all. O(n log n).
    pub(super) fn new(points: &'a [DVec2], tolerance: f64, extent: f64) -> Self {
        let origin = points.iter().copied().reduce(DVec2::min).unwrap_or(DVec2::ZERO);
        let width = (2.0 * tolerance).max(1e-12 * extent);
        let mut near = Self { points, origin, tolerance, width, squares: Vec::new() };
        near.squares = (0..).zip(points).map(|(i, &point)| (near.square(point), i)).collect();
        near.squares.sort_unstable();
        near
    }

    /// The square of a point; beyond what integers hold, the last one.
    fn square(&self, point: DVec2) -> [i64; 2] {
        let scaled = ((point - self.origin) / self.width).floor();
        [scaled.x as i64, scaled.y as i64]
    }

    /// The nearest point within the tolerance, the first of several, and how far it is. O(log n) where
    /// few points are so near.
    pub(super) fn nearest(&self, to: DVec2) -> Option<(u32, f64)> {
        let reach = DVec2::splat(self.tolerance);
        let ([left, low], [right, high]) = (self.square(to - reach), self.square(to + reach));
        let column = |x: i64| {
            let start = self.squares.partition_point(|&(square, _)| square < [x, low]);
            self.squares[start..].iter().take_while(move |&&(square, _)| square <= [x, high])
        };
        let candidates = (left..=right).flat_map(column).map(|&(_, index)| {
            let distance = self.points[index as usize].distance(to);
            (index, distance)
        });
        candidates
            .filter(|&(_, distance)| distance <= self.tolerance)
            .min_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_point_is_found_across_squares() {
        let points: Vec<DVec2> = (0..10)
            .flat_map(|x| (0..10).map(move |y| DVec2::new(f64::from(x), f64::from(y))))
            .collect();
        for tolerance in [0.0, 1e-9, 0.3, 0.49] {
            let near = Near::new(&points, tolerance, 9.0);
            for (index, &point) in (0..).zip(&points) {
                for (x, y) in [(0.0, 0.0), (0.9, 0.0), (-0.9, 0.0), (0.6, -0.7), (-0.7, 0.6)] {
                    let offset = DVec2::new(x, y) * tolerance;
                    let (found, distance) = near.nearest(point + offset).expect("it is near");
                    assert_eq!(found, index);
                    assert!((distance - offset.length()).abs() < 1e-15);
                }
                assert_eq!(near.nearest(point + DVec2::splat(0.5)), None);
            }
            assert_eq!(near.nearest(DVec2::splat(1e300)), None);
        }
    }
}
