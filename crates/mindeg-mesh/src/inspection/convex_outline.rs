//! The sides and corners of a convex outline, found from the points along it.

use glam::{DVec2, DVec3};

/// The convex outline of a mesh whose only vertices are on that outline.
///
/// # Example
///
/// ```
/// use glam::DVec3;
/// use mindeg_mesh::TriMesh;
/// use mindeg_mesh::inspection::{Inspection, InspectionOptions};
///
/// // A square with a vertex in the middle of its first side.
/// let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
/// let points = points.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
/// let mesh = TriMesh::new(points, vec![[0, 1, 4], [1, 3, 4], [1, 2, 3]])?;
/// let outline = Inspection::of(&mesh, &InspectionOptions::default()).outline?;
/// assert_eq!(outline.corners, [0, 2, 3, 4]);
/// assert_eq!(outline.intervals, [2, 1, 1, 1]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FoundOutline {
    /// The corners, by their vertices. Side i runs from corner i to the next.
    pub corners: Vec<u32>,
    /// The intervals of each side: its number of edges.
    pub intervals: Vec<u32>,
}

impl FoundOutline {
    /// The same outline, with indices of vertices instead of indices in a loop.
    pub(super) fn named(self, vertices: &[u32]) -> Self {
        let corners = self.corners.iter().map(|&corner| vertices[corner as usize]).collect();
        Self { corners, ..self }
    }
}

/// Why a mesh has no [`FoundOutline`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NoConvexOutline {
    /// More than one piece, a hole, no boundary, or an edge or vertex that is not manifold.
    #[error("the mesh is not one piece with one boundary loop and no hole")]
    NotADisk,
    /// A vertex that is not on the boundary.
    #[error("the mesh has interior vertices")]
    InteriorVertices,
    /// Vertices on the boundary too far from a plane.
    #[error("the boundary is not in a plane")]
    NotPlanar,
    /// Corners that turn inwards, fewer than three, or a boundary that winds round twice.
    #[error("the boundary is not a convex polygon")]
    NotConvex,
    /// Vertices too far from the straight line between corners.
    #[error("the boundary is curved between its corners")]
    Curved,
    /// The boundary is no wider than the rounding of its coordinates.
    #[error(
        "the boundary is too thin to tell: rounding of its coordinates can move a vertex from one \
         side to the other"
    )]
    TooThin,
    /// The coordinates are too coarse to tell corners from other vertices.
    #[error(
        "the boundary is too fine to tell: with coordinates rounded as these are, a vertex that \
         close to the next may be a corner or not"
    )]
    TooFine,
}

/// A loop of boundary points as a convex polygon, with corners by their indices in the loop.
/// `rounding` is the largest error of each coordinate.
///
/// The exact loop is some convex polygon. A vertex is one of its corners if the sides that meet
/// there turn by more than `corner_angle` degrees; a side may bend as far as an arc that leaves its
/// chord by that angle, and the loop may leave a plane as far as the middle of such an arc. The
/// result holds for every possible exact loop: if another loop within `rounding` may have other
/// corners, this is an error. O(n log n) for n points.
pub(super) fn convex_outline(
    points: &[DVec3],
    rounding: f64,
    corner_angle: f64,
) -> Result<FoundOutline, NoConvexOutline> {
    // The turn that comes from rounding alone is never exactly 0.
    let corner_angle = corner_angle.max(1e-3);
    let outline = Outline::in_plane(points, rounding, corner_angle)?;
    let corners = outline.corners(corner_angle)?;
    outline.check_corners(&corners, corner_angle)?;
    let mut intervals = Vec::with_capacity(corners.len());
    for (start, end) in sides(&corners, points.len()) {
        outline.check_side(start, end, corner_angle)?;
        // Vertices have indices of 32 bits.
        intervals.push((end - start) as u32);
    }
    Ok(FoundOutline { corners: corners.iter().map(|&corner| corner as u32).collect(), intervals })
}

/// The start and end of each side in a loop of `count` points; the last side ends past `count`.
fn sides(corners: &[usize], count: usize) -> impl Iterator<Item = (usize, usize)> {
    let ends = corners.iter().copied().skip(1).chain([corners[0] + count]);
    corners.iter().copied().zip(ends)
}

/// How far the middle of an arc is from its chord, for a chord of length 1 and an arc that
/// leaves it by `angle` degrees.
fn sagitta(angle: f64) -> f64 {
    libm::tan(angle.to_radians() / 2.0) / 2.0
}

/// The angle in degrees by which a line turns at `b` on its way from `a` to `c`, positive to the
/// left.
fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    libm::atan2((b - a).perp_dot(c - b), (b - a).dot(c - b)).to_degrees()
}

/// The distance of `b` from the segment between `a` and `c`.
fn height(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    let chord = c - a;
    let along = (chord.dot(b - a) / chord.length_squared()).clamp(0.0, 1.0);
    (b - if along.is_nan() { a } else { a + along * chord }).length()
}

/// A loop of points in the plane.
struct Outline {
    /// Counter-clockwise, at a size of about 1.
    points: Vec<DVec2>,
    /// The largest distance of a point from its exact position.
    error: f64,
}

impl Outline {
    /// The points in coordinates of their plane.
    fn in_plane(
        points: &[DVec3],
        rounding: f64,
        corner_angle: f64,
    ) -> Result<Self, NoConvexOutline> {
        /// More than all rounding errors of the computation, at a size of 1.
        const ARITHMETIC: f64 = 8.0 * f64::EPSILON;
        // A quarter, so that no difference overflows.
        let points: Vec<DVec3> = points.iter().map(|&point| point / 4.0).collect();
        let corner = points.iter().copied().reduce(DVec3::min).unwrap_or_default();
        let size = points.iter().map(|&p| (p - corner).max_element()).fold(0.0, f64::max);
        let error = 3.0_f64.sqrt() * (rounding / 4.0 / size) + ARITHMETIC;
        // Also refuses NaN.
        if !(size > 0.0 && error < 1.0) {
            return Err(NoConvexOutline::TooThin);
        }
        let points: Vec<DVec3> = points.iter().map(|&point| (point - corner) / size).collect();
        // Twice the area of the loop, as a vector.
        let next = || points.iter().cycle().skip(1);
        let area: DVec3 =
            points.iter().zip(next()).map(|(&a, &b)| (a - points[0]).cross(b - points[0])).sum();
        let perimeter: f64 = points.iter().zip(next()).map(|(&a, &b)| (b - a).length()).sum();
        if area.length() <= 2.0 * error * perimeter {
            // A convex loop has no larger triangle, except for rounding.
            let is_thin = large_triangle(&points) <= 6.0 * error * perimeter;
            return Err(if is_thin {
                NoConvexOutline::TooThin
            } else {
                NoConvexOutline::NotConvex
            });
        }
        let normal = area.normalize();
        let heights = || points.iter().map(|point| point.dot(normal));
        let mean = heights().sum::<f64>() / points.len() as f64;
        let limit = sagitta(corner_angle) + 2.0 * error;
        if heights().any(|height| (height - mean).abs() > limit) {
            return Err(NoConvexOutline::NotPlanar);
        }
        let (x, y) = normal.any_orthonormal_pair();
        let points = points.iter().map(|point| DVec2::new(point.dot(x), point.dot(y))).collect();
        Ok(Self { points, error })
    }

    /// How far rounding can move a point from the segment that contains it.
    fn tolerance(&self) -> f64 {
        2.0 * self.error
    }

    /// The largest error of the turn at `b`, in degrees.
    fn turn_error(&self, a: DVec2, b: DVec2, c: DVec2) -> f64 {
        let leg = |end: DVec2| libm::asin((self.tolerance() / (end - b).length()).min(1.0));
        (leg(a) + leg(c)).to_degrees()
    }

    /// The likely corners, by their positions in the loop.
    fn corners(&self, corner_angle: f64) -> Result<Vec<usize>, NoConvexOutline> {
        let mut line = ClosedLine::new(&self.points);
        line.drop_rounding(self.tolerance());
        if line.kept().count() < 3 {
            return Err(NoConvexOutline::TooThin);
        }
        let is_unsure = line.kept().any(|i| {
            let [a, b, c] = line.around(i);
            (turn(a, b, c) - corner_angle).abs() <= self.turn_error(a, b, c)
        });
        line.drop_straight(corner_angle);
        let corners: Vec<usize> = line.kept().collect();
        if corners.len() < 3 {
            return Err(if is_unsure {
                NoConvexOutline::TooFine
            } else {
                NoConvexOutline::NotConvex
            });
        }
        for &corner in &corners {
            let [a, b, c] = line.around(corner);
            let double_area = (b - a).perp_dot(c - b);
            let error = self.tolerance() * ((b - a).length() + (c - b).length() + (a - c).length());
            if double_area < -error {
                return Err(NoConvexOutline::NotConvex);
            }
            if double_area <= error {
                return Err(NoConvexOutline::TooThin);
            }
        }
        // The turns of a closed line add up to a multiple of 360 degrees.
        let turns: f64 = corners.iter().map(|&corner| line.turn(corner)).sum();
        if turns < 540.0 { Ok(corners) } else { Err(NoConvexOutline::NotConvex) }
    }

    /// Refuses corners that may not be corners.
    fn check_corners(&self, corners: &[usize], corner_angle: f64) -> Result<(), NoConvexOutline> {
        let count = self.points.len();
        let at = |i: usize| self.points[i % count];
        for (i, &corner) in corners.iter().enumerate() {
            // A vertex inside a side is within the tolerance of the segment between its two
            // neighbours, however close they are.
            let is_corner =
                height(at(corner + count - 1), at(corner), at(corner + 1)) > self.tolerance();
            let [a, b, c] =
                [i + corners.len() - 1, i, i + 1].map(|i| at(corners[i % corners.len()]));
            if !is_corner || turn(a, b, c) - self.turn_error(a, b, c) <= corner_angle {
                return Err(NoConvexOutline::TooFine);
            }
        }
        Ok(())
    }

    /// Refuses a side between two corners that is not straight, or that may have another corner.
    ///
    /// In a convex loop, a vertex between two corners turns by no more than the line from one
    /// corner to it and on to the other corner.
    fn check_side(&self, start: usize, end: usize, angle: f64) -> Result<(), NoConvexOutline> {
        let at = |i: usize| self.points[i % self.points.len()];
        let [a, c] = [at(start), at(end)];
        let mut result = Ok(());
        for b in (start + 1..end).map(at) {
            let (turn, error) = (turn(a, b, c).abs(), self.turn_error(a, b, c));
            if turn - error > angle {
                return Err(NoConvexOutline::Curved);
            }
            if turn + error > angle {
                result = Err(NoConvexOutline::TooFine);
            }
        }
        result
    }
}

/// Twice the area of the largest triangle of three points that include the first point and the
/// farthest point from it.
fn large_triangle(points: &[DVec3]) -> f64 {
    let from_first = |point: &DVec3| *point - points[0];
    let length = |a: &DVec3, b: &DVec3| a.length_squared().total_cmp(&b.length_squared());
    let farthest = points.iter().map(from_first).max_by(length).unwrap_or_default();
    points.iter().map(|point| from_first(point).cross(farthest).length()).fold(0.0, f64::max)
}

/// A closed line through some of a list of points.
struct ClosedLine<'a> {
    points: &'a [DVec2],
    /// The point before and after each that is kept.
    before: Vec<usize>,
    after: Vec<usize>,
    is_kept: Vec<bool>,
}

impl<'a> ClosedLine<'a> {
    /// The line through all points in order.
    fn new(points: &'a [DVec2]) -> Self {
        let count = points.len();
        let before = (0..count).map(|i| (i + count - 1) % count).collect();
        let after = (0..count).map(|i| (i + 1) % count).collect();
        Self { points, before, after, is_kept: vec![true; count] }
    }

    fn kept(&self) -> impl Iterator<Item = usize> {
        (0..self.points.len()).filter(|&i| self.is_kept[i])
    }

    fn drop(&mut self, i: usize) {
        let [before, after] = [self.before[i], self.after[i]];
        self.is_kept[i] = false;
        self.after[before] = after;
        self.before[after] = before;
    }

    /// The points before, at and after a position.
    fn around(&self, i: usize) -> [DVec2; 3] {
        [self.before[i], i, self.after[i]].map(|i| self.points[i])
    }

    /// The angle in degrees by which the line turns at a point, positive to the left.
    fn turn(&self, i: usize) -> f64 {
        let [a, b, c] = self.around(i);
        turn(a, b, c)
    }

    /// The distance of a point from the line without it.
    fn height(&self, i: usize) -> f64 {
        let [a, b, c] = self.around(i);
        height(a, b, c)
    }

    /// Drops points while one is nearer than `tolerance` to the line without it. Points that are
    /// much nearer than others go first: so next to a corner, however short the intervals are, the
    /// corner stays.
    fn drop_rounding(&mut self, tolerance: f64) {
        // Heights of the same power of two are on one level. Heights far below the resolution of
        // f64 are on the lowest.
        const LEVELS: usize = 64;
        let exponent = |height: f64| (height.to_bits() >> 52) as usize;
        let level = |height: f64| (exponent(height) + LEVELS).saturating_sub(exponent(tolerance));
        // The points of each level; a point is there again whenever its height has changed.
        let mut waiting = vec![Vec::new(); LEVELS];
        let mut lowest = 0;
        let mut changed: Vec<usize> = self.kept().collect();
        loop {
            for i in changed.drain(..) {
                let at = level(self.height(i));
                if let Some(points) = waiting.get_mut(at) {
                    points.push(i);
                    lowest = lowest.min(at);
                }
            }
            while waiting.get(lowest).is_some_and(Vec::is_empty) {
                lowest += 1;
            }
            let Some(point) = waiting.get_mut(lowest).and_then(Vec::pop) else { return };
            if self.is_kept[point] && level(self.height(point)) == lowest {
                self.drop(point);
                changed.extend([self.before[point], self.after[point]]);
            }
        }
    }

    /// Drops all points at which the line turns by at most an angle, all at once, and repeats this
    /// while such points remain. All at once, so that nothing remains of a smooth curve rather than
    /// a polygon that depends on the starting point.
    fn drop_straight(&mut self, angle: f64) {
        let mut changed: Vec<usize> = self.kept().collect();
        while !changed.is_empty() {
            changed.retain(|&i| self.is_kept[i] && self.turn(i).abs() <= angle);
            for i in std::mem::take(&mut changed) {
                if self.is_kept[i] {
                    self.drop(i);
                    changed.extend([self.before[i], self.after[i]]);
                }
            }
        }
    }
}
