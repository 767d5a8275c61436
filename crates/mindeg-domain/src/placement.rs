//! The positions of the boundary vertices.
//!
//! For a convex domain with straight sides, points are closed forms, O(log k) each for k sides and
//! nothing stored, so a boundary of billions of vertices takes no more memory than its sides. For
//! any other domain the points are stored.
//!
//! Limits: the checks keep points apart. A triangle of three distinct points may still be so thin
//! that rounding inverts it; meshing refuses to return such a triangle.

use glam::{DVec2, DVec3};
use mindeg_mesh::planar::{InRing, PlanarBoundary, doubled_area};
use mindeg_mesh::{Bounds, Positions, number, place};

use crate::error::{DomainError, Place};
use crate::limits::{EXACT_COORDINATES, LEAST_ROUNDINGS};
use crate::rings::Rings;
use crate::side_points::SidePoints;
use crate::spacing_law::SpacingLaw;

/// The positions of all boundary vertices, ring by ring, from the first corner of each.
///
/// A [`Domain`](crate::Domain) has one, in [`Domain::placement`](crate::Domain::placement).
///
/// # Guarantees for the rounded points
///
/// Corners and points given one by one keep their exact positions, points of a straight side that
/// is parallel to an axis lie exactly on it, and no two points coincide:
///
/// - Along a straight side, the shortest interval is checked to be longer than what rounding at the
///   side's coordinates can move a point.
/// - If the domain is convex and its sides straight, points of two sides can come close at a corner
///   only. There the nearest point of either side is checked to be farther from the line of the
///   other side than rounding can move it. The other points of the sides are farther still, and in a
///   convex polygon so are all other sides.
/// - In any other domain all points are checked: rings are simple and apart, exactly.
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
    rings: Rings,
    /// The corners of all rings; side `s` starts at corner `s`.
    corners: Vec<DVec2>,
    points: Points,
}

#[derive(Clone, Debug, PartialEq)]
enum Points {
    /// On straight sides, by the law of each.
    Formula(Vec<SpacingLaw>),
    /// Points one by one, with the length of each side.
    Stored { boundary: PlanarBoundary, lengths: Vec<f64> },
}

impl Placement {
    /// Points on straight sides. `corners` and `laws` have one entry per side; each law has that
    /// side's intervals.
    pub(crate) fn straight(rings: Rings, corners: Vec<DVec2>, laws: Vec<SpacingLaw>) -> Self {
        Self { rings, corners, points: Points::Formula(laws) }
    }

    /// Points one by one, and the length of each side.
    pub(crate) fn stored(rings: Rings, boundary: PlanarBoundary, lengths: Vec<f64>) -> Self {
        let corners = (0..rings.side_count()).map(|side| boundary.point(rings.corner(side)));
        Self { corners: corners.collect(), rings, points: Points::Stored { boundary, lengths } }
    }

    /// Sets the straight run of each edge. Only stored points store their runs.
    pub(crate) fn with_runs(mut self, runs: Vec<u32>) -> Self {
        if let Points::Stored { boundary, lengths } = self.points {
            let boundary = boundary.with_sides(self.rings.corner_vertices().to_vec(), runs);
            self.points = Points::Stored { boundary, lengths };
        }
        self
    }

    /// The boundary, where its points are stored.
    pub(crate) fn boundary(&self) -> Option<&PlanarBoundary> {
        match &self.points {
            Points::Formula(_) => None,
            Points::Stored { boundary, .. } => Some(boundary),
        }
    }

    /// The rounded points of a straight side are in order along the coordinate in which it is
    /// longest, since rounding never swaps two numbers. This checks that they differ.
    pub(crate) fn check_intervals(
        start: DVec2,
        end: DVec2,
        law: &SpacingLaw,
        side: InRing,
    ) -> Result<(), DomainError> {
        let span = (end - start).abs();
        let axis = usize::from(span.y > span.x);
        let (_, share) = law.shortest();
        if share * span[axis] >= LEAST_ROUNDINGS * rounding(start, end)[axis] {
            return Ok(());
        }
        let length = share * start.distance(end);
        Err(Place::key("spacing")
            .error(format!(
                "its shortest interval is {} long, too short to be told from nothing at the \
                 size of the side's coordinates; use fewer intervals or a gentler law, or move the \
                 domain towards the origin",
                number(length)
            ))
            .of_side(side))
    }

    /// Checks that no points coincide next to the corners of a convex domain, either way round; at
    /// a straight corner no points can coincide.
    pub(crate) fn check_corners(
        &self,
        is_straight: impl Fn(usize) -> bool,
    ) -> Result<(), DomainError> {
        let Points::Formula(laws) = &self.points else { return Ok(()) };
        for side in (0..self.corners.len()).filter(|&side| !is_straight(side)) {
            let before = self.rings.previous_side(side);
            let law = &laws[before];
            let last = (1.0 - law.parameter(law.intervals() - 1)) * self.side_length(before);
            let first = laws[side].parameter(1) * self.side_length(side);
            let incoming = (self.corners[side] - self.corners[before]).normalize();
            let outgoing = (self.end(side) - self.corners[side]).normalize();
            let distance = last.min(first) * incoming.perp_dot(outgoing).abs();
            let rounding = |side| rounding(self.corners[side], self.end(side));
            let rounding = rounding(before).max(rounding(side)).max_element();
            if distance < LEAST_ROUNDINGS * rounding {
                let corner = self.rings.in_ring(side);
                return Err(Place::corner(corner).error(format!(
                    "{}: the points next to it are {} from the other side, too close \
                         to be told apart at the size of the coordinates; make the intervals there \
                         longer or the angle larger, or move the domain towards the origin",
                    corner.corner(),
                    number(distance)
                )));
            }
        }
        Ok(())
    }

    /// Checks that decisions on the points are exact; a boundary that is not convex needs exact ones.
    pub(crate) fn check_exactness(&self) -> Result<(), DomainError> {
        let is_exact = |x: f64| x == 0.0 || EXACT_COORDINATES.contains(&x.abs());
        let inexact = |point: &DVec2| !(is_exact(point.x) && is_exact(point.y));
        let Some(vertex) = self.points().position(|point| inexact(&point)) else { return Ok(()) };
        Err(Place::corners(self.rings.ring_of(vertex as u32)).error(format!(
            "vertex {vertex} is at {}; the coordinates of a domain that is not convex \
                 are 0 or of magnitude {} to {}: use another unit of length",
            place(self.point(vertex as u32)),
            number(*EXACT_COORDINATES.start()),
            number(*EXACT_COORDINATES.end())
        )))
    }

    /// The end of a side.
    fn end(&self, side: usize) -> DVec2 {
        self.corners[self.rings.next_side(side)]
    }

    /// The rings whose vertices these are the positions of.
    pub fn rings(&self) -> &Rings {
        &self.rings
    }

    /// The number of boundary vertices n.
    pub fn vertex_count(&self) -> u32 {
        self.rings.vertex_count()
    }

    /// The corners of all rings; side `s` starts at corner `s`.
    pub fn corners(&self) -> &[DVec2] {
        &self.corners
    }

    /// The length of a side, along its curve if it has one.
    ///
    /// # Panics
    ///
    /// If `side` is not below the number of sides.
    pub fn side_length(&self, side: usize) -> f64 {
        match &self.points {
            Points::Formula(_) => self.end(side).distance(self.corners[side]),
            Points::Stored { lengths, .. } => lengths[side],
        }
    }

    /// The position of a vertex. O(log k), O(1) if the points are stored.
    ///
    /// # Panics
    ///
    /// If `vertex` is not below [`vertex_count`](Self::vertex_count).
    pub fn point(&self, vertex: u32) -> DVec2 {
        match &self.points {
            Points::Stored { boundary, .. } => boundary.point(vertex),
            Points::Formula(laws) => {
                let side = self.points_on(self.rings.side_of(vertex), laws);
                side.point(vertex - side.first)
            }
        }
    }

    /// The positions of all vertices in order, ring by ring. O(1) each.
    pub fn points(&self) -> impl Iterator<Item = DVec2> + Clone + '_ {
        let (laws, points) = match &self.points {
            Points::Formula(laws) => (&laws[..], &[][..]),
            Points::Stored { boundary, .. } => (&[][..], boundary.points()),
        };
        let on_sides = laws.iter().enumerate().flat_map(move |(side, law)| {
            let side = self.points_on(side, laws);
            (0..law.intervals()).map(move |index| side.point(index))
        });
        on_sides.chain(points.iter().copied())
    }

    /// Fills `out` with the positions of the vertices from `first` on. Much faster than to ask for
    /// them one by one.
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

    /// [`fill_points`](Self::fill_points) with `of` applied to each point.
    fn fill<T>(&self, first: u32, mut out: &mut [T], of: impl Fn(DVec2) -> T) {
        if out.is_empty() {
            return;
        }
        let laws = match &self.points {
            Points::Formula(laws) => laws,
            Points::Stored { boundary, .. } => {
                let points = &boundary.points()[first as usize..][..out.len()];
                points.iter().zip(out).for_each(|(&point, out)| *out = of(point));
                return;
            }
        };
        let sides = (self.rings.side_of(first)..).map(|side| self.points_on(side, laws));
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

    /// The positions of single vertices. O(1) each while consecutive calls stay on the same two
    /// sides, as along a strip.
    pub fn walk(&self) -> Walk<'_> {
        let sides = match &self.points {
            Points::Formula(laws) => Some([0, 1].map(|side| self.points_on(side, laws))),
            Points::Stored { .. } => None,
        };
        Walk { placement: self, sides, last: 0 }
    }

    fn points_on<'a>(&self, side: usize, laws: &'a [SpacingLaw]) -> SidePoints<'a> {
        let start = self.corners[side];
        SidePoints {
            first: self.rings.corner(side),
            start,
            span: self.end(side) - start,
            law: &laws[side],
        }
    }

    /// The smallest box around the domain. O(k), O(n) if the points are stored.
    pub fn bounds(&self) -> Bounds {
        match &self.points {
            Points::Formula(_) => {
                Bounds::of(self.corners.iter().copied()).expect("a ring has corners")
            }
            Points::Stored { boundary, .. } => boundary.bounds(),
        }
    }

    /// The area inside the rings, in square units: of a [map](crate::Domain::area), with its holes. O(k), O(n) if the points
    /// are stored.
    pub fn area(&self) -> f64 {
        match &self.points {
            Points::Formula(_) => doubled_area(&self.corners) / 2.0,
            Points::Stored { boundary, .. } => boundary.area(),
        }
    }
}

/// A bound on the rounding of the coordinates of a side's points.
fn rounding(start: DVec2, end: DVec2) -> DVec2 {
    start.abs().max(end.abs()) * f64::EPSILON
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
        self.rings.ring_count() == 1
    }
}

/// Positions of vertices one by one; see [`Placement::walk`].
#[derive(Clone)]
pub struct Walk<'a> {
    placement: &'a Placement,
    /// The last two different sides that were asked for; `None` if the points are stored.
    sides: Option<[SidePoints<'a>; 2]>,
    /// The index of the last one in `sides`.
    last: usize,
}

impl Walk<'_> {
    /// The position of a vertex below the vertex count.
    pub fn point(&mut self, vertex: u32) -> DVec2 {
        let (Some(sides), Points::Formula(laws)) = (&mut self.sides, &self.placement.points) else {
            return self.placement.point(vertex);
        };
        for slot in [self.last, 1 - self.last] {
            if let Some(index) = sides[slot].index(vertex) {
                self.last = slot;
                return sides[slot].point(index);
            }
        }
        self.last = 1 - self.last;
        let side = self.placement.points_on(self.placement.rings.side_of(vertex), laws);
        sides[self.last] = side;
        side.point(vertex - side.first)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spacing::Spacing;

    fn place(corners: &[[f64; 2]], spacing: &Spacing, m: u32) -> Result<Placement, DomainError> {
        let corners: Vec<DVec2> = corners.iter().copied().map(DVec2::from).collect();
        let laws: Vec<SpacingLaw> = (0..corners.len())
            .map(|s| {
                let length = corners[(s + 1) % corners.len()].distance(corners[s]);
                SpacingLaw::solve(spacing, m, length).unwrap()
            })
            .collect();
        let rings = Rings::new(&[vec![u64::from(m); corners.len()]]).unwrap();
        for (index, law) in laws.iter().enumerate() {
            let (start, end) = (corners[index], corners[(index + 1) % corners.len()]);
            Placement::check_intervals(start, end, law, InRing { ring: 0, index })?;
        }
        let placement = Placement::straight(rings, corners, laws);
        placement.check_corners(|_| false)?;
        Ok(placement)
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
        assert_eq!(refused.place.to_string(), "sides[0].spacing");
        assert!(refused.message.contains("is 9.99e-10 long"), "{refused}");

        let needle = |width: f64| [[0.0, 0.0], [1.0, 0.0], [1.0, width]];
        assert!(place(&needle(1e-9), &Spacing::Uniform, 10).is_ok());
        let refused = place(&needle(1e-14), &Spacing::Uniform, 10).unwrap_err();
        assert_eq!(refused.place.to_string(), "polygon.corners[0]");
    }
}
