//! A domain: its rings, the division of their sides, and the limits on its degrees.
//!
//! A [`Domain`] is checked as a whole when it is made ([`build`](crate::DomainBuilder)), so that every
//! later step (placing, meshing, writing) can rely on it. The interface counts sides and corners from 0.
//! Messages count them from 1, in the order of the input even if a ring was reversed.
//!
//! Limits: the plane; coordinates up to [`GREATEST_COORDINATE`](crate::GREATEST_COORDINATE) and sides
//! no shorter than [`LEAST_SIDE`](crate::LEAST_SIDE), so that areas neither overflow nor vanish. The
//! unit of length is the user's.

use std::borrow::Cow;
use std::sync::Arc;

use glam::DVec2;
use mindeg_mesh::planar::{BoundaryFaults, Faces, InRing, PlanarBoundary, ring_name};

use crate::constraints::Constraints;
use crate::error::{DomainError, Place};
use crate::inside::Inside;
use crate::interior::Interior;
use crate::name;
use crate::outline::Outline;
use crate::periodic::Periodic;
use crate::placement::Placement;
use crate::projection::Projection;
use crate::rings::Rings;
use crate::side::Side;
use crate::turning::{ConvexForm, Turning};

/// A polygon, with or without holes, with a number of intervals and a spacing law on every side.
///
/// # Example
///
/// ```
/// use mindeg_domain::{Domain, Side, Spacing};
///
/// let wall = Side::count(6).spaced(Spacing::Geometric { ratio: 1.3 }).named("wall");
/// let domain = Domain::polygon(
///     [[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]],
///     vec![Side::count(8), Side::size(0.5), wall],
/// )?;
/// assert_eq!(domain.rings().sides().collect::<Vec<_>>(), [8, 10, 6]);
/// assert_eq!(domain.sides()[2].name.as_deref(), Some("wall"));
/// # Ok::<(), mindeg_domain::DomainError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Domain {
    pub(crate) name: Option<String>,
    pub(crate) outline: Outline,
    /// The sides of all rings.
    pub(crate) sides: Arc<[Side]>,
    pub(crate) placement: Arc<Placement>,
    /// Whether each side is straight.
    pub(crate) straight: Vec<bool>,
    pub(crate) convex: Option<ConvexForm>,
    pub(crate) constraints: Constraints,
    pub(crate) interior: Option<Interior>,
    pub(crate) projection: Option<Projection>,
    /// The rings that were given the wrong way round.
    pub(crate) turned: Vec<usize>,
    pub(crate) inside: Inside,
    /// The first segment of each side of each line, then the number of segments.
    pub(crate) line_starts: Vec<u32>,
    /// The vertex of each point of [`Inside::points`].
    pub(crate) point_vertices: Vec<u32>,
    pub(crate) faces: Option<Arc<Faces>>,
    pub(crate) periodic: Option<Arc<Periodic>>,
    /// The sides that were split where lines end, a sentence each.
    pub(crate) splits: Vec<String>,
}

impl Domain {
    /// The same domain with a name.
    ///
    /// # Errors
    ///
    /// A name that is blank, or has a character that ends a line, steers a terminal or turns the
    /// direction of writing.
    pub fn named(self, name: impl Into<String>) -> Result<Self, DomainError> {
        let name = name.into();
        name::check(&name, Place::key("name"), "the domain")?;
        Ok(Self { name: Some(name), ..self })
    }

    /// The same domain with settings for a mesh with interior points.
    #[must_use]
    pub fn with_interior(self, interior: Interior) -> Self {
        Self { interior: Some(interior), ..self }
    }

    /// The settings for a mesh with interior points, if the domain has any.
    pub fn interior(&self) -> Option<&Interior> {
        self.interior.as_ref()
    }

    /// The same domain with the projection that its points come from, or without one.
    #[must_use]
    pub fn with_projection(self, projection: Option<Projection>) -> Self {
        Self { projection, ..self }
    }

    /// The projection of degrees that gave its points, if they come from degrees: they are metres then.
    pub fn projection(&self) -> Option<&Projection> {
        self.projection.as_ref()
    }

    /// The name, if the domain has one.
    pub fn name(&self) -> Option<&str> {
        self.name.as_deref()
    }

    /// The shape of the outer ring, counter-clockwise.
    pub fn outline(&self) -> &Outline {
        &self.outline
    }

    /// The sides of all rings, in the order of [`rings`](Self::rings); side `s` runs from corner
    /// `s` to the next corner of its ring.
    pub fn sides(&self) -> &[Side] {
        &self.sides
    }

    /// The name of a side; a side without a name is called by its index from 1, such as "side 2" or
    /// "hole 1 side 2", and the only side of a hole by the name of the hole.
    ///
    /// # Panics
    ///
    /// If the domain has no such side.
    pub fn side_name(&self, side: usize) -> String {
        let InRing { ring, index } = self.rings().in_ring(side);
        match &self.sides[side].name {
            Some(name) => name.clone(),
            None if ring == 0 => format!("side {}", index + 1),
            None if self.rings().ring_sides(ring).len() == 1 => ring_name(ring),
            None => format!("{} side {}", ring_name(ring), index + 1),
        }
    }

    /// The name of a side within a sentence: with its index from 1, through all rings, where others have that name too,
    /// such as "side 8 (coast)".
    ///
    /// # Panics
    ///
    /// If the domain has no such side.
    pub fn side_in_text(&self, side: usize) -> String {
        let name = self.side_name(side);
        let is_same = |other: &&Side| other.name.as_deref() == Some(&name);
        match self.sides.iter().filter(is_same).nth(1) {
            Some(_) => format!("side {} ({name})", side + 1),
            None => name,
        }
    }

    /// The periodic sides, and the vertices that they make one; none without periodic sides.
    pub fn periodic(&self) -> Option<&Periodic> {
        self.periodic.as_deref()
    }

    /// Whether a side is straight: all its points are on the line between its ends.
    ///
    /// # Panics
    ///
    /// If the domain has no such side.
    pub fn is_straight(&self, side: usize) -> bool {
        self.straight[side]
    }

    /// The limits on the degrees of sides and vertices, with the indices of [`rings`](Self::rings).
    pub fn constraints(&self) -> &Constraints {
        &self.constraints
    }

    /// Whether any vertex has a degree limit or an external degree above 0.
    pub fn is_constrained(&self) -> bool {
        self.constraints.constrain()
    }

    /// The number of edges of a vertex on the other side of the boundary. O(log n).
    ///
    /// # Panics
    ///
    /// If the domain has no such vertex.
    pub fn external_degree(&self, vertex: u32) -> u32 {
        self.constraints.external_degree(self.rings(), vertex)
    }

    /// The most edges that a vertex may have, its external degree included; `None` if it has no
    /// limit. O(log n).
    ///
    /// # Panics
    ///
    /// If the domain has no such vertex.
    pub fn degree_limit(&self, vertex: u32) -> Option<u32> {
        self.constraints.degree_limit(self.rings(), vertex)
    }

    /// The rings, sides and vertices of the boundary without their positions.
    pub fn rings(&self) -> &Rings {
        self.placement.rings()
    }

    /// The positions of the boundary vertices.
    pub fn placement(&self) -> &Placement {
        &self.placement
    }

    /// The form of the domain for the formulas of `mindeg-core`, if it is convex and has no holes.
    pub fn convex(&self) -> Option<&ConvexForm> {
        self.convex.as_ref()
    }

    /// For each vertex, the straight run of the boundary edge that begins there. Consecutive
    /// straight sides, and edges of other sides, are in one run if they join without a turn. No
    /// edge of a mesh joins two vertices of a run that are not neighbours. O(n log k).
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::{Domain, Side};
    ///
    /// let corners = [[0.0, 0.0], [1.0, 0.0], [3.0, 0.0], [0.0, 3.0]];
    /// let domain = Domain::polygon(corners, [1, 2, 1, 2].map(Side::count).into())?;
    /// assert_eq!(domain.straight_runs(), [0, 0, 0, 1, 2, 2]);
    /// # Ok::<(), mindeg_domain::DomainError>(())
    /// ```
    pub fn straight_runs(&self) -> Vec<u32> {
        match self.placement.boundary() {
            Some(boundary) => boundary.runs().to_vec(),
            None => Turning { placement: &self.placement, straight: &self.straight }.runs(),
        }
    }

    /// The boundary with all its points. Stored points were proven when the domain was made; the
    /// points of a convex outline with straight sides are made and proven here. O(n log n).
    ///
    /// # Errors
    ///
    /// Points of a convex outline that rounding has moved onto or past each other.
    pub fn boundary(&self) -> Result<Cow<'_, PlanarBoundary>, BoundaryFaults> {
        if let Some(boundary) = self.placement.boundary() {
            return Ok(Cow::Borrowed(boundary));
        }
        let points: Vec<DVec2> = self.placement.points().collect();
        let corners = self.rings().corner_vertices().to_vec();
        let boundary = PlanarBoundary::new(&[points])?;
        Ok(Cow::Owned(boundary.with_sides(corners, self.straight_runs())))
    }

    /// Whether the corners of the outer ring were given clockwise, and were therefore reversed.
    pub fn was_reversed(&self) -> bool {
        self.turned.contains(&0)
    }

    /// The changes to the description that the user should know, one sentence each.
    pub fn notes(&self) -> Vec<String> {
        let outer = self.was_reversed().then(|| {
            "The corners of the outline ran clockwise and were reversed (an outline runs counter-clockwise, with the \
             domain on its left); each side kept its edge, and sides count from the last one as given."
                .to_owned()
        });
        let holes: Vec<String> =
            self.turned.iter().filter(|&&ring| ring > 0).map(|&ring| ring_name(ring)).collect();
        let holes = (!holes.is_empty()).then(|| {
            let names = match &holes[..] {
                [one] => one.clone(),
                [one, other] => format!("{one} and {other}"),
                [one, other, ..] => {
                    format!("{} holes, among them {one} and {other},", holes.len())
                }
                [] => String::new(),
            };
            format!(
                "The corners of {names} ran counter-clockwise and were reversed (a hole runs clockwise, with the \
                 domain on its left); each side kept its edge, and sides count from the last one as given."
            )
        });
        outer.into_iter().chain(holes).chain(self.splits.iter().cloned()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spacing::Spacing;

    const CORNERS: [[f64; 2]; 4] = [[1.0, 2.0], [5.0, 2.0], [4.0, 5.0], [1.0, 4.0]];

    fn polygon(corners: &[[f64; 2]], sides: Vec<Side>) -> Result<Domain, DomainError> {
        Domain::polygon(corners.iter().copied(), sides)
    }

    /// So that each mesh of a curve can have its domain.
    #[test]
    fn clones_share_their_points() {
        let domain = polygon(&CORNERS, vec![Side::count(2); 4]).unwrap();
        let clone = domain.clone().named("plate").unwrap();
        assert!(std::ptr::eq(clone.placement(), domain.placement()));
        assert!(std::ptr::eq(clone.sides(), domain.sides()));
    }

    #[test]
    fn the_boundary_has_the_points_runs_and_corners_of_the_domain() {
        let reflex = [[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0], [0.0, 2.0]];
        for corners in [&CORNERS[..], &reflex] {
            let domain = polygon(corners, vec![Side::count(3); corners.len()]).unwrap();
            let boundary = domain.boundary().unwrap();
            let points: Vec<DVec2> = domain.placement().points().collect();
            assert_eq!(boundary.points(), points);
            assert_eq!(boundary.runs(), domain.straight_runs());
            assert_eq!(boundary.corners(), domain.rings().corner_vertices());
        }
    }

    #[test]
    fn billions_of_vertices_take_no_memory() {
        let side = Side::count(1_000_000_000).spaced(Spacing::Beta { beta: 1.5 });
        let domain = Domain::rectangle(4.0, 3.0, vec![side; 4]).unwrap();
        assert_eq!(domain.placement().vertex_count(), 4_000_000_000);
        let middle_of_left = 1.0 - 1.5 * libm::tanh(libm::atanh(1.0 / 1.5) / 2.0);
        let y = domain.placement().point(3_500_000_000).y;
        assert!((y - 3.0 * (1.0 - middle_of_left)).abs() < 1e-15);
    }

    #[test]
    fn clockwise_corners_are_reversed_with_their_sides() {
        let sides = vec![
            Side::count(3).spaced(Spacing::Geometric { ratio: 2.0 }).named("bottom"),
            Side::count(4).spaced(Spacing::FirstLength(0.5)).named("right"),
            Side::parameters(vec![0.25, 0.5]).named("top"),
            Side::count(2).spaced(Spacing::Beta { beta: 1.5 }).named("left"),
        ];
        let forth = polygon(&CORNERS, sides.clone()).unwrap();
        assert!(!forth.was_reversed());

        // The same polygon listed the other way round from the same corner, with each side reversed
        // too.
        let mut corners = CORNERS;
        corners[1..].reverse();
        let turned = |side: &Side| Side { spacing: side.spacing.reversed(), ..side.clone() };
        let back = polygon(&corners, sides.iter().rev().map(turned).collect()).unwrap();
        assert!(back.was_reversed());
        assert_eq!(back.sides(), forth.sides());
        assert_eq!(back.outline(), forth.outline());
        assert!(back.placement().points().eq(forth.placement().points()));
    }

    #[test]
    fn refuses_with_the_reason() {
        let one = || vec![Side::count(1); 4];
        let with = |side: usize, wanted: Side| {
            let mut sides = one();
            sides[side] = wanted;
            sides
        };
        let mut clockwise = CORNERS;
        clockwise.reverse();
        for (outcome, message) in [
            (
                Domain::rectangle(-1.0, 1.0, one()),
                "the rectangle's width is -1.0; it must be a finite number above 0",
            ),
            (
                Domain::rectangle(1.0, 1.0, vec![]),
                "0 sides are described and the outline has 4; describe each side once",
            ),
            (
                Domain::rectangle(1.0, 1.0, one()).unwrap().named("a\nb"),
                "the name of the domain contains the line break U+000A; remove this character",
            ),
            (
                polygon(&CORNERS, with(2, Side::count(1).named(" "))),
                "the name of side 3 is blank; give it a letter or leave it out",
            ),
            (
                polygon(&CORNERS, with(3, Side::size(0.0))),
                "side 4: the size is 0.0; it must be a finite number above 0",
            ),
            (
                polygon(&CORNERS, with(3, Side::count(0))),
                "side 4 has 0 intervals; every side needs at least 1",
            ),
            (
                polygon(&CORNERS, with(0, Side::size(1e-300))),
                "side 1: the size 1e-300 makes 4e300 intervals, and a boundary has at most 4294967294 vertices; give a larger size",
            ),
            (
                polygon(&CORNERS, with(1, Side::count(2).spaced(Spacing::Bump { ratio: 0.0 }))),
                "side 2: the ratio is 0.0; it must be a finite number above 0",
            ),
            // An error of a reversed side names the side as given.
            (
                polygon(&clockwise, with(1, Side::count(2).spaced(Spacing::FirstLength(-1.0)))),
                "side 2: the first length is -1.0; it must be a finite number above 0",
            ),
            (
                polygon(
                    &clockwise.map(|[x, y]| [x + 1e8, y + 1e8]),
                    with(1, Side::count(36).spaced(Spacing::Geometric { ratio: 2.0 })),
                ),
                "side 2: its shortest interval is 4.602e-11 long, too short to be told from nothing at the size of the side's coordinates; use fewer intervals or a gentler law, or move the domain towards the origin",
            ),
            (
                polygon(
                    &[[0.0, 1.0], [1.0, 1.0], [1.0, 1.000_000_002]],
                    vec![Side::count(2_000_000), Side::count(1), Side::count(1)],
                ),
                "corner 1: the points next to it are 1e-15 from the other side, too close to be told apart at the size of the coordinates; make the intervals there longer or the angle larger, or move the domain towards the origin",
            ),
            (
                polygon(
                    &[[1.0, 1.0], [0.0, 1.0], [1.0, 1.000_000_002]],
                    vec![Side::count(2_000_000), Side::count(1), Side::count(1)],
                ),
                "corner 2: the points next to it are 1e-15 from the other side, too close to be told apart at the size of the coordinates; make the intervals there longer or the angle larger, or move the domain towards the origin",
            ),
        ] {
            assert_eq!(outcome.unwrap_err().to_string(), message);
        }
    }
}
