//! Where the boundary vertices are: straight sides between corners, and a law on each.
//!
//! Points are closed forms, O(log k) each for k sides and nothing stored, so a boundary of
//! billions of vertices takes no more memory than its sides.
//!
//! Limits: the checks keep points apart. A triangle of three distinct points may yet be so thin
//! that rounding turns it over; meshing refuses to give one.

use glam::{DVec2, DVec3};
use mindeg_core::Boundary;
use mindeg_mesh::{Bounds, Positions};

use crate::limits::LEAST_ROUNDINGS;
use crate::spacing_law::SpacingLaw;

/// The positions of all boundary vertices, counter-clockwise from the first corner.
///
/// A [`Domain`](crate::Domain) has one, in [`Domain::placement`](crate::Domain::placement).
///
/// # What is promised of the rounded points
///
/// Corners are exactly where they were put, points of a side that is parallel to an axis lie
/// exactly on it, and no two points coincide:
///
/// - Along a side, the shortest interval is checked to be longer than what rounding at the
///   side's coordinates can move a point.
/// - Points of two sides can come close at a corner only. There the nearest point of either side
///   is checked to be farther from the line of the other side than rounding can move it. The
///   other points of the sides are farther still, and in a convex polygon so are all other sides.
///
/// # Example
///
/// ```
/// use mindeg_domain::{Domain, Side};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(2); 4])?;
/// let placement = domain.placement();
/// assert_eq!(placement.vertex_count(), 8);
/// assert_eq!(placement.point(1).to_array(), [2.0, 0.0]); // the middle of the bottom
/// assert_eq!(placement.points().last(), Some(placement.point(7)));
/// assert_eq!(placement.area(), 12.0);
/// assert_eq!(placement.bounds().max.to_array(), [4.0, 3.0]);
/// # Ok::<(), mindeg_domain::DomainError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Placement {
    boundary: Boundary,
    corners: Vec<DVec2>,
    laws: Vec<SpacingLaw>,
}

/// Why boundary vertices cannot be placed: 64-bit floats do not tell two of them apart. Sides and
/// corners are counted from 0 here and from 1 in messages.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlacementError {
    /// The shortest interval of a side is too short for the coordinates at which it lies.
    #[error(
        "side {}: its shortest interval is {length:.1e} long, too short to be told from nothing at \
         the size of the side's coordinates; use fewer intervals or a gentler law, or move the \
         domain towards the origin",
        side + 1
    )]
    Interval {
        /// The side.
        side: usize,
        /// The length of the interval.
        length: f64,
    },
    /// Two sides are so close next to a corner that their points coincide.
    #[error(
        "corner {}: the points next to it are {distance:.1e} from the other side, too close to be \
         told apart at the size of the coordinates; make the intervals there longer or the angle \
         larger, or move the domain towards the origin",
        corner + 1
    )]
    Corner {
        /// The corner.
        corner: usize,
        /// The distance.
        distance: f64,
    },
}

impl Placement {
    /// Corner `s` is where side `s` starts. As many `corners` as `laws`, as many as the
    /// boundary has sides and with its intervals; the corners are those of a convex polygon,
    /// counter-clockwise.
    pub(crate) fn new(
        boundary: Boundary,
        corners: Vec<DVec2>,
        laws: Vec<SpacingLaw>,
    ) -> Result<Self, PlacementError> {
        let placement = Self { boundary, corners, laws };
        for side in 0..placement.corners.len() {
            placement.check_intervals(side)?;
            placement.check_corner(side)?;
        }
        Ok(placement)
    }

    /// The rounded points of a side are in order along the coordinate in which it is longest,
    /// since rounding never swaps two numbers. That they differ is what is checked.
    fn check_intervals(&self, side: usize) -> Result<(), PlacementError> {
        let span = (self.side_end(side) - self.corners[side]).abs();
        let axis = usize::from(span.y > span.x);
        let (_, share) = self.laws[side].shortest();
        if share * span[axis] >= LEAST_ROUNDINGS * self.rounding(side)[axis] {
            return Ok(());
        }
        Err(PlacementError::Interval { side, length: share * self.side_length(side) })
    }

    /// At corner `side`, where `side` starts and the one before it ends.
    fn check_corner(&self, side: usize) -> Result<(), PlacementError> {
        let before = (side + self.corners.len() - 1) % self.corners.len();
        let law = &self.laws[before];
        let last = (1.0 - law.parameter(law.intervals() - 1)) * self.side_length(before);
        let first = self.laws[side].parameter(1) * self.side_length(side);
        let incoming = (self.corners[side] - self.corners[before]).normalize();
        let outgoing = (self.side_end(side) - self.corners[side]).normalize();
        let distance = last.min(first) * incoming.perp_dot(outgoing);
        let rounding = self.rounding(before).max(self.rounding(side)).max_element();
        if distance >= LEAST_ROUNDINGS * rounding {
            return Ok(());
        }
        Err(PlacementError::Corner { corner: side, distance })
    }

    /// A bound on the rounding of the coordinates of a side's points.
    fn rounding(&self, side: usize) -> DVec2 {
        self.corners[side].abs().max(self.side_end(side).abs()) * f64::EPSILON
    }

    fn side_end(&self, side: usize) -> DVec2 {
        self.corners[(side + 1) % self.corners.len()]
    }

    /// The boundary whose vertices these are the positions of.
    #[must_use]
    pub fn boundary(&self) -> &Boundary {
        &self.boundary
    }

    /// The number of boundary vertices n.
    #[must_use]
    pub fn vertex_count(&self) -> u32 {
        self.boundary.vertex_count()
    }

    /// The corners, counter-clockwise; corner `s` is where side `s` starts.
    #[must_use]
    pub fn corners(&self) -> &[DVec2] {
        &self.corners
    }

    /// The length of a side.
    ///
    /// # Panics
    ///
    /// When `side` is not below the number of sides.
    #[must_use]
    pub fn side_length(&self, side: usize) -> f64 {
        self.side_end(side).distance(self.corners[side])
    }

    /// The position of a vertex. O(log k).
    ///
    /// # Panics
    ///
    /// When `vertex` is not below [`vertex_count`](Self::vertex_count).
    #[must_use]
    pub fn point(&self, vertex: u32) -> DVec2 {
        let side = self.points_on(self.boundary.side_of(vertex));
        side.point(vertex - side.first)
    }

    /// The positions of all vertices in order, side by side. O(1) each.
    pub fn points(&self) -> impl Iterator<Item = DVec2> + Clone + '_ {
        (0..self.corners.len()).flat_map(move |side| {
            let side = self.points_on(side);
            (0..side.law.intervals()).map(move |index| side.point(index))
        })
    }

    /// Writes the positions of the vertices from `first` on into `out`, as many as it holds. Much
    /// faster than to ask for them one by one.
    ///
    /// # Panics
    ///
    /// If fewer than `out.len()` vertices remain from `first` on.
    ///
    /// # Example
    ///
    /// ```
    /// use glam::{DVec2, DVec3};
    /// use mindeg_domain::{Domain, Side};
    ///
    /// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(2); 4])?;
    /// let mut points = [DVec2::ZERO; 3];
    /// domain.placement().fill_points(1, &mut points);
    /// assert_eq!(points, [[2.0, 0.0], [4.0, 0.0], [4.0, 1.5]].map(DVec2::from));
    /// # Ok::<(), mindeg_domain::DomainError>(())
    /// ```
    pub fn fill_points(&self, first: u32, out: &mut [DVec2]) {
        self.fill(first, out, |point| point);
    }

    /// [`fill_points`](Self::fill_points), of what is made of each point.
    fn fill<T>(&self, first: u32, mut out: &mut [T], of: impl Fn(DVec2) -> T) {
        if out.is_empty() {
            return;
        }
        let sides = (self.boundary.side_of(first)..).map(|side| self.points_on(side));
        let mut vertex = first;
        for side in sides {
            let index = vertex - side.first;
            let count = out.len().min((side.law.intervals() - index) as usize);
            let (here, later) = out.split_at_mut(count);
            side.fill(index, here, &of);
            if later.is_empty() {
                return;
            }
            (out, vertex) = (later, side.first + side.law.intervals());
        }
    }

    /// The positions of vertices asked one by one. O(1) each as long as they keep to two sides
    /// at a time, as those of a strip do.
    #[must_use]
    pub fn walk(&self) -> Walk<'_> {
        Walk { placement: self, sides: [0, 1].map(|side| self.points_on(side)), last: 0 }
    }

    fn points_on(&self, side: usize) -> SidePoints<'_> {
        let start = self.corners[side];
        SidePoints {
            first: self.boundary.corner(side),
            start,
            span: self.side_end(side) - start,
            law: &self.laws[side],
        }
    }

    /// The smallest box around the domain. O(k).
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        Bounds::of(self.corners.iter().copied()).expect("a polygon has corners")
    }

    /// The area of the domain, in square units. O(k).
    #[must_use]
    pub fn area(&self) -> f64 {
        // Relative to a corner, so that nothing cancels far from the origin.
        let origin = self.corners[0];
        let fan = self.corners[1..].windows(2);
        fan.map(|pair| (pair[0] - origin).perp_dot(pair[1] - origin)).sum::<f64>() / 2.0
    }
}

/// In the plane z = 0.
impl Positions for Placement {
    fn vertex_count(&self) -> u32 {
        self.vertex_count()
    }

    fn fill_positions(&self, first: u32, out: &mut [DVec3]) {
        self.fill(first, out, |point| point.extend(0.0));
    }

    fn bounds(&self) -> Bounds<DVec3> {
        self.bounds().in_space()
    }

    fn is_ring(&self) -> bool {
        true
    }
}

/// The points of one side.
#[derive(Clone, Copy)]
struct SidePoints<'a> {
    /// The vertex where the side starts.
    first: u32,
    start: DVec2,
    span: DVec2,
    law: &'a SpacingLaw,
}

impl SidePoints<'_> {
    /// Point `i`, below the number of intervals.
    fn point(&self, i: u32) -> DVec2 {
        self.start + self.law.parameter(i) * self.span
    }

    /// Points from index `first` on, as many as `out` holds.
    fn fill<T>(&self, first: u32, out: &mut [T], of: impl Fn(DVec2) -> T) {
        let indexed = (first..).zip(out);
        if self.law.is_uniform() {
            // The same formula, without a call: the compiler makes several points at a time.
            let intervals = f64::from(self.law.intervals());
            indexed.for_each(|(i, out)| {
                *out = of(self.start + f64::from(i) / intervals * self.span);
            });
        } else {
            indexed.for_each(|(i, out)| *out = of(self.point(i)));
        }
    }

    /// The index of a vertex on the side, if it is there and not where the side ends.
    fn index(&self, vertex: u32) -> Option<u32> {
        vertex.checked_sub(self.first).filter(|&index| index < self.law.intervals())
    }
}

/// Positions of vertices one by one; see [`Placement::walk`].
#[derive(Clone)]
pub struct Walk<'a> {
    placement: &'a Placement,
    /// The last two different sides that were asked for.
    sides: [SidePoints<'a>; 2],
    /// Which of them was the last.
    last: usize,
}

impl Walk<'_> {
    /// The position of a vertex below the vertex count.
    pub fn point(&mut self, vertex: u32) -> DVec2 {
        for slot in [self.last, 1 - self.last] {
            if let Some(index) = self.sides[slot].index(vertex) {
                self.last = slot;
                return self.sides[slot].point(index);
            }
        }
        self.last = 1 - self.last;
        let side = self.placement.points_on(self.placement.boundary.side_of(vertex));
        self.sides[self.last] = side;
        side.point(vertex - side.first)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spacing::Spacing;

    fn place(corners: &[[f64; 2]], spacing: &Spacing, m: u32) -> Result<Placement, PlacementError> {
        let corners: Vec<DVec2> = corners.iter().copied().map(DVec2::from).collect();
        let laws = (0..corners.len())
            .map(|s| {
                let length = corners[(s + 1) % corners.len()].distance(corners[s]);
                SpacingLaw::solve(spacing, m, length).unwrap()
            })
            .collect();
        let boundary = Boundary::new(&vec![u64::from(m); corners.len()]).unwrap();
        Placement::new(boundary, corners, laws)
    }

    const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

    #[test]
    fn puts_points_between_exact_corners() {
        let corners = [[0.1, 0.2], [0.7, 0.2], [0.4, 0.9]];
        let placement = place(&corners, &Spacing::Geometric { ratio: 1.7 }, 5).unwrap();
        for (s, corner) in corners.into_iter().enumerate() {
            assert_eq!(placement.point(5 * s as u32).to_array(), corner);
        }
        assert!((0..5).all(|v| placement.point(v).y == 0.2));
        assert!((0..15).map(|v| placement.point(v)).eq(placement.points()));
        let [start, first, second] = [0, 1, 2].map(|v| placement.point(v).x);
        assert!(((second - first) / (first - start) - 1.7).abs() < 1e-12);
    }

    #[test]
    fn points_are_the_same_however_asked_for() {
        // Where the second side ends, its formula is off by a rounding.
        let corners = [[0.1, 0.2], [0.7, 0.2], [0.9, 0.9], [0.4, 0.9]];
        for spacing in [Spacing::Uniform, Spacing::Geometric { ratio: 1.7 }] {
            let placement = place(&corners, &spacing, 3).unwrap();
            for start in 0..=12 {
                for end in start..=12 {
                    let expected: Vec<_> = (start..end).map(|v| placement.point(v)).collect();
                    let mut points = vec![DVec2::ZERO; expected.len()];
                    placement.fill_points(start, &mut points);
                    assert_eq!(points, expected, "{start}..{end}");
                }
            }
            let mut walk = placement.walk();
            for vertex in [11, 0, 10, 1, 2, 9, 8, 3, 4, 7, 5, 6, 0, 11, 11] {
                assert_eq!(walk.point(vertex), placement.point(vertex), "{vertex}");
            }
        }
    }

    #[test]
    fn measures_the_outline() {
        let far = SQUARE.map(|[x, y]| [x + 5e6, y + 4e6]);
        let placement = place(&far, &Spacing::Uniform, 3).unwrap();
        assert_eq!(placement.area(), 1.0);
        assert_eq!(placement.side_length(2), 1.0);
        assert_eq!(placement.bounds().size(), DVec2::ONE);
        assert_eq!(placement.bounds().center(), DVec2::new(5e6 + 0.5, 4e6 + 0.5));
    }

    #[test]
    fn refuses_points_that_rounding_would_merge() {
        let far = |offset: f64| SQUARE.map(|[x, y]| [x + offset, y]);
        let dense = Spacing::Geometric { ratio: 1e3 };
        assert!(place(&far(0.0), &dense, 4).is_ok());
        assert!(place(&far(1e5), &dense, 4).is_ok());
        let refused = place(&far(1e7), &dense, 4).unwrap_err();
        let PlacementError::Interval { side: 0, length } = refused else {
            panic!("{refused:?}");
        };
        assert!((length - 1e-9).abs() < 1e-11);

        let needle = |width: f64| [[0.0, 0.0], [1.0, 0.0], [1.0, width]];
        assert!(place(&needle(1e-9), &Spacing::Uniform, 10).is_ok());
        let refused = place(&needle(1e-14), &Spacing::Uniform, 10).unwrap_err();
        assert!(matches!(refused, PlacementError::Corner { corner: 0, .. }), "{refused:?}");
    }
}
