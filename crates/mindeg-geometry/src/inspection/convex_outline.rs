//! The sides and corners of a convex outline, from the points along it.

use glam::{DVec2, DVec3};
use mindeg_core::{Boundary, least_max_degree};

/// The convex outline of a mesh that uses the vertices along it alone, and what the least
/// possible maximum degree is for it.
///
/// # Example
///
/// ```
/// use mindeg_geometry::import::obj;
/// use mindeg_geometry::inspection::{Inspection, InspectionOptions};
///
/// // A square with a vertex in the middle of its first side.
/// let file = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 5\nf 2 4 5\nf 2 3 4\n";
/// let mesh = obj::read(file.as_bytes())?;
/// let outline = Inspection::of(&mesh, &InspectionOptions::default()).outline?;
/// assert_eq!(outline.corners, [0, 2, 3, 4]);
/// assert_eq!(outline.intervals, [2, 1, 1, 1]);
/// assert_eq!(outline.optimal_max_degree, 4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConvexOutline {
    /// The corners, by their vertices. Side i runs from corner i to the next.
    pub corners: Vec<u32>,
    /// The intervals of each side: how many edges it has.
    pub intervals: Vec<u32>,
    /// The least maximum degree of all triangulations of the outline without other vertices
    /// ([`least_max_degree`]).
    pub optimal_max_degree: u32,
}

/// Why there is no [`ConvexOutline`].
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
}

/// What is nearer together than this share of an outline's size is taken for one: the rounding
/// of 32-bit floats at some distance from the origin. A power of two.
const ROUNDING: f64 = 1.0 / (1 << 20) as f64;

/// A loop of boundary vertices as a convex polygon.
///
/// A vertex is a corner if the sides that meet there, as straight lines, turn by more than
/// `corner_angle` degrees. A side is straight, and the loop is in a plane, as long as no
/// vertex is farther away than the middle of an arc would be that leaves its chord by that
/// angle, or rounding explains. O(n) for n vertices.
pub(super) fn convex_outline(
    vertices: &[u32],
    positions: &[DVec3],
    corner_angle: f64,
) -> Result<ConvexOutline, NoConvexOutline> {
    let points: Vec<DVec3> = vertices.iter().map(|&v| positions[v as usize]).collect();
    let points = in_plane(&points, corner_angle)?;
    let corners = corners(&points, corner_angle)?;
    let mut intervals = Vec::with_capacity(corners.len());
    for (corner, &start) in corners.iter().enumerate() {
        let end = corners.get(corner + 1).map_or(corners[0] + points.len(), |&end| end);
        let side = (start..=end).map(|i| points[i % points.len()]);
        if !is_straight(side, points[start], points[end % points.len()], corner_angle) {
            return Err(NoConvexOutline::Curved);
        }
        intervals.push(end - start);
    }
    let counts: Vec<u64> = intervals.iter().map(|&count| count as u64).collect();
    let boundary = Boundary::new(&counts).map_err(|_| NoConvexOutline::NotConvex)?;
    Ok(ConvexOutline {
        corners: corners.iter().map(|&corner| vertices[corner]).collect(),
        intervals: boundary.sides().collect(),
        optimal_max_degree: least_max_degree(&boundary),
    })
}

/// How far the middle of an arc is from its chord, for a chord of length 1 and an arc that
/// leaves it by `angle` degrees.
fn sagitta(angle: f64) -> f64 {
    libm::tan(angle.to_radians() / 2.0) / 2.0
}

/// The points in coordinates of the plane they lie in, counter-clockwise and at a size of 1.
fn in_plane(points: &[DVec3], corner_angle: f64) -> Result<Vec<DVec2>, NoConvexOutline> {
    let [min, max] = points
        .iter()
        .fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[min, max], &p| [min.min(p), max.max(p)]);
    let size = (max - min).max_element();
    if !(size > 0.0 && size.is_finite()) {
        return Err(NoConvexOutline::NotConvex);
    }
    let points: Vec<DVec3> = points.iter().map(|&point| (point - min) / size).collect();
    // Twice the area of the loop, as a vector.
    let around = points.iter().zip(points.iter().cycle().skip(1));
    let area: DVec3 = around.map(|(&a, &b)| (a - points[0]).cross(b - points[0])).sum();
    let normal = area.try_normalize().ok_or(NoConvexOutline::NotConvex)?;
    let heights = || points.iter().map(|point| point.dot(normal));
    let mean = heights().sum::<f64>() / points.len() as f64;
    let limit = sagitta(corner_angle).max(ROUNDING);
    if heights().any(|height| (height - mean).abs() > limit) {
        return Err(NoConvexOutline::NotPlanar);
    }
    let (x, y) = normal.any_orthonormal_pair();
    Ok(points.iter().map(|point| DVec2::new(point.dot(x), point.dot(y))).collect())
}

/// The corners of a closed line, by their places in it.
fn corners(points: &[DVec2], corner_angle: f64) -> Result<Vec<usize>, NoConvexOutline> {
    let mut line = ClosedLine::new(points);
    line.drop_rounding();
    line.drop_straight(corner_angle);
    let corners: Vec<usize> = line.kept().collect();
    let turns = || corners.iter().map(|&corner| line.turn(corner));
    // The turns of a closed line add up to a multiple of 360 degrees.
    let is_convex = corners.len() >= 3 && turns().all(|t| t > 0.0) && turns().sum::<f64>() < 540.0;
    if is_convex { Ok(corners) } else { Err(NoConvexOutline::NotConvex) }
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

    /// The angle in degrees by which the line turns at a point, to the left where positive.
    fn turn(&self, i: usize) -> f64 {
        let [start, point, end] = [self.before[i], i, self.after[i]].map(|i| self.points[i]);
        let [a, b] = [point - start, end - point];
        libm::atan2(a.perp_dot(b), a.dot(b)).to_degrees()
    }

    /// How far a point is from the line without it.
    fn height(&self, i: usize) -> f64 {
        let [start, point, end] = [self.before[i], i, self.after[i]].map(|i| self.points[i]);
        let chord = end - start;
        // Between points that are one, the line goes there and back.
        let along = (chord.dot(point - start) / chord.length_squared()).clamp(0.0, 1.0);
        (point - if along.is_nan() { start } else { start + along * chord }).length()
    }

    /// Drops points as long as one is nearer to the line without it than rounding explains,
    /// those that are much nearer than others first: so next to a corner, however short the
    /// intervals are, the corner stays.
    fn drop_rounding(&mut self) {
        // Heights of the same power of two are on one level. What is smaller by far than f64
        // tells apart is on the lowest.
        const LEVELS: usize = 64;
        let exponent = |height: f64| (height.to_bits() >> 52) as usize;
        let level = |height: f64| (exponent(height) + LEVELS).saturating_sub(exponent(ROUNDING));
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

    /// Drops all points at which the line turns no more than by an angle, all at once, and
    /// again where the line then turns no more. All at once, so that of a smooth curve there is
    /// nothing left rather than a polygon that depends on where one starts.
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

/// Whether all points are close to the line from `start` to `end`.
fn is_straight(
    mut points: impl Iterator<Item = DVec2>,
    start: DVec2,
    end: DVec2,
    corner_angle: f64,
) -> bool {
    let side = end - start;
    let limit = (sagitta(corner_angle) * side.length()).max(ROUNDING);
    points.all(|point| side.perp_dot(point - start).abs() <= limit * side.length())
}
