//! A convex domain: its outline, how each of its sides is divided, and what limits its degrees.
//!
//! A [`Domain`] is checked as a whole when it is made, so that every later step (placing,
//! meshing, writing) can rely on it. Sides and corners are counted from 0 in the interface and
//! from 1 in messages, where they are those of the input even if it had to be reversed.
//!
//! Limits: convex outlines with straight sides in the plane, coordinates up to
//! [`GREATEST_COORDINATE`](crate::GREATEST_COORDINATE) and sides no shorter than
//! [`LEAST_SIDE`](crate::LEAST_SIDE), so that areas neither overflow nor vanish. The unit of length
//! is the user's.

use glam::DVec2;
use mindeg_core::Boundary;

use crate::constraints::Constraints;
use crate::domain_error::DomainError;
use crate::interior::Interior;
use crate::name;
use crate::outline::{self, Orientation, Outline};
use crate::placement::{Placement, PlacementError};
use crate::rectangle::Rectangle;
use crate::side::{Side, SideError};
use crate::spacing_law::SpacingLaw;

/// A convex polygon with a number of intervals and a spacing law on every side.
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
/// assert_eq!(domain.boundary().sides().collect::<Vec<_>>(), [8, 10, 6]);
/// assert_eq!(domain.sides()[2].name.as_deref(), Some("wall"));
/// # Ok::<(), mindeg_domain::DomainError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Domain {
    name: Option<String>,
    outline: Outline,
    sides: Vec<Side>,
    placement: Placement,
    constraints: Constraints,
    interior: Option<Interior>,
    was_reversed: bool,
}

impl Domain {
    /// A domain from its outline and one [`Side`] for each of the outline's sides.
    ///
    /// Corners given clockwise are reversed, each side staying on its edge (with its spacing law
    /// [reversed](crate::Spacing::reversed)): the first corner given stays the first, and the side
    /// that ended there now starts there. [`was_reversed`](Self::was_reversed) tells.
    ///
    /// O(k log k) for k sides, and linear in explicit parameters.
    ///
    /// # Errors
    ///
    /// The first fault, in this order: a measure of the rectangle; the corners, in number,
    /// magnitude, order or convexity; the number of sides; their names; their intervals; their
    /// spacing laws; points so close that f64 cannot tell them apart.
    pub fn new(outline: Outline, sides: Vec<Side>) -> Result<Self, DomainError> {
        Self::constrained(outline, sides, Constraints::default())
    }

    /// [`Domain::new`] with constraints on degrees.
    ///
    /// Where the corners run clockwise, the constraints of each side stay on their edge too. Single
    /// vertices are always those of the mesh, counter-clockwise from the first corner.
    ///
    /// # Errors
    ///
    /// As [`Domain::new`], and then constraints that do not fit the boundary or that no mesh keeps.
    pub fn constrained(
        outline: Outline,
        sides: Vec<Side>,
        constraints: Constraints,
    ) -> Result<Self, DomainError> {
        let corners = outline.corners().map_err(outline::OutlineError::from)?;
        let orientation = outline::orientation(&corners)?;
        // Checked as given, so that errors name what was given.
        let intervals = check_sides(&corners, &sides)?;
        if orientation == Orientation::CounterClockwise {
            return Self::counter_clockwise(outline, corners, sides, &intervals, constraints);
        }
        let reversed = Self::counter_clockwise(
            Outline::Polygon(from_the_same_corner(&corners)),
            from_the_same_corner(&corners),
            sides.into_iter().rev().map(Side::reversed).collect(),
            &intervals.into_iter().rev().collect::<Vec<_>>(),
            constraints.with_sides_reversed(),
        );
        match reversed {
            Ok(domain) => Ok(Self { was_reversed: true, ..domain }),
            Err(error) => Err(as_given(error, corners.len())),
        }
    }

    /// The domain of corners and sides that run counter-clockwise and have been checked.
    fn counter_clockwise(
        outline: Outline,
        corners: Vec<DVec2>,
        sides: Vec<Side>,
        intervals: &[u64],
        constraints: Constraints,
    ) -> Result<Self, DomainError> {
        let boundary = Boundary::new(intervals)?;
        let laws = laws(&corners, &sides, &boundary)?;
        let placement = Placement::new(boundary, corners, laws)?;
        let constraints = constraints.checked(placement.boundary())?;
        let (name, interior, was_reversed) = (None, None, false);
        Ok(Self { name, outline, sides, placement, constraints, interior, was_reversed })
    }

    /// [`Domain::new`] for an upright rectangle with its first corner at the origin. Its sides
    /// are bottom, right, top and left.
    ///
    /// # Errors
    ///
    /// As [`Domain::new`].
    pub fn rectangle(width: f64, height: f64, sides: Vec<Side>) -> Result<Self, DomainError> {
        Self::new(Outline::Rectangle(Rectangle::new(width, height)), sides)
    }

    /// [`Domain::new`] for the polygon with the given corners.
    ///
    /// # Errors
    ///
    /// As [`Domain::new`].
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::{Domain, Side};
    ///
    /// let domain = Domain::polygon([[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]], vec![Side::count(2); 3])?;
    /// assert_eq!(domain.placement().area(), 6.0);
    /// # Ok::<(), mindeg_domain::DomainError>(())
    /// ```
    pub fn polygon(
        corners: impl IntoIterator<Item = impl Into<DVec2>>,
        sides: Vec<Side>,
    ) -> Result<Self, DomainError> {
        let corners = corners.into_iter().map(Into::into).collect();
        Self::new(Outline::Polygon(corners), sides)
    }

    /// The same domain with a name.
    ///
    /// # Errors
    ///
    /// A name that is blank, or has a character that ends a line, steers a terminal or turns the
    /// direction of writing.
    pub fn named(self, name: impl Into<String>) -> Result<Self, DomainError> {
        let name = name.into();
        name::check(&name, None)?;
        Ok(Self { name: Some(name), ..self })
    }

    /// The same domain with what is wanted of a mesh with interior points.
    #[must_use]
    pub fn with_interior(self, interior: Interior) -> Self {
        Self { interior: Some(interior), ..self }
    }

    /// What is wanted of a mesh with interior points, if the domain tells.
    #[must_use]
    pub fn interior(&self) -> Option<&Interior> {
        self.interior.as_ref()
    }

    /// The name, if there is one.
    #[must_use]
    pub fn name(&self) -> Option<&str> {
        self.name.as_deref()
    }

    /// The outline, counter-clockwise.
    #[must_use]
    pub fn outline(&self) -> &Outline {
        &self.outline
    }

    /// The sides, counter-clockwise; each runs from the corner of its number to the next.
    #[must_use]
    pub fn sides(&self) -> &[Side] {
        &self.sides
    }

    /// The name of a side; one without a name is called by its number from 1, such as "side 2".
    ///
    /// # Panics
    ///
    /// If the domain has no such side.
    #[must_use]
    pub fn side_name(&self, side: usize) -> String {
        match &self.sides[side].name {
            Some(name) => name.clone(),
            None => format!("side {}", side + 1),
        }
    }

    /// What limits the degrees of sides and vertices, counter-clockwise as the sides are.
    #[must_use]
    pub fn constraints(&self) -> &Constraints {
        &self.constraints
    }

    /// Whether any vertex has a degree limit or an external degree above 0.
    #[must_use]
    pub fn is_constrained(&self) -> bool {
        self.constraints.constrain()
    }

    /// The number of edges that a vertex has on the other side of the boundary. O(log n).
    ///
    /// # Panics
    ///
    /// If the domain has no such vertex.
    #[must_use]
    pub fn external_degree(&self, vertex: u32) -> u32 {
        self.constraints.external_degree(self.boundary(), vertex)
    }

    /// The most edges that a vertex may have, its external degree included; `None` where nothing
    /// limits them. O(log n).
    ///
    /// # Panics
    ///
    /// If the domain has no such vertex.
    #[must_use]
    pub fn degree_limit(&self, vertex: u32) -> Option<u32> {
        self.constraints.degree_limit(self.boundary(), vertex)
    }

    /// The boundary vertices without their positions.
    #[must_use]
    pub fn boundary(&self) -> &Boundary {
        self.placement.boundary()
    }

    /// The positions of the boundary vertices.
    #[must_use]
    pub fn placement(&self) -> &Placement {
        &self.placement
    }

    /// Whether the corners were given clockwise, and so were reversed.
    #[must_use]
    pub fn was_reversed(&self) -> bool {
        self.was_reversed
    }
}

/// Checks the sides of an outline one by one, and gives their intervals.
fn check_sides(corners: &[DVec2], sides: &[Side]) -> Result<Vec<u64>, DomainError> {
    if sides.len() != corners.len() {
        let (corners, sides) = (corners.len(), sides.len());
        return Err(DomainError::SideCount { corners, sides });
    }
    name::check_all(sides.iter().map(|side| side.name.as_deref()))?;
    let on = |(side, wanted): (usize, &Side)| {
        wanted.intervals.on(length(corners, side)).map_err(|source| (side, source).into())
    };
    let intervals = sides.iter().enumerate().map(on).collect::<Result<Vec<_>, DomainError>>()?;
    laws(corners, sides, &Boundary::new(&intervals)?)?;
    Ok(intervals)
}

/// The spacing laws of all sides, solved.
fn laws(
    corners: &[DVec2],
    sides: &[Side],
    boundary: &Boundary,
) -> Result<Vec<SpacingLaw>, DomainError> {
    let solve = |(side, wanted): (usize, &Side)| {
        SpacingLaw::solve(&wanted.spacing, boundary.intervals(side), length(corners, side))
            .map_err(|source| (side, SideError::from(source)).into())
    };
    sides.iter().enumerate().map(solve).collect()
}

fn length(corners: &[DVec2], side: usize) -> f64 {
    corners[(side + 1) % corners.len()].distance(corners[side])
}

/// The corners the other way round, from the same first corner.
fn from_the_same_corner(corners: &[DVec2]) -> Vec<DVec2> {
    let mut corners = corners.to_vec();
    corners[1..].reverse();
    corners
}

/// The error of a domain whose `count` corners were reversed, with the numbers as given.
fn as_given(error: DomainError, count: usize) -> DomainError {
    let side_as_given = |side| count - 1 - side;
    match error {
        DomainError::Side { side, source } => {
            DomainError::Side { side: side_as_given(side), source }
        }
        DomainError::Placement(PlacementError::Interval { side, length }) => {
            PlacementError::Interval { side: side_as_given(side), length }.into()
        }
        DomainError::Placement(PlacementError::Corner { corner, distance }) => {
            PlacementError::Corner { corner: (count - corner) % count, distance }.into()
        }
        DomainError::Constraint(error) => error.with_side(side_as_given).into(),
        error => error,
    }
}

impl From<(usize, SideError)> for DomainError {
    fn from((side, source): (usize, SideError)) -> Self {
        Self::Side { side, source }
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

        // The same polygon listed the other way round from the same corner, and each side the
        // other way round too.
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
                "the domain's name contains the line break U+000A; remove this character",
            ),
            (
                polygon(&CORNERS, with(2, Side::count(1).named(" "))),
                "the name of side 3 is blank; give it a letter or leave it out",
            ),
            (
                polygon(&CORNERS, vec![Side::count(1).named("wall"); 4]),
                "sides 1 and 2 are both named \"wall\"; names become groups in mesh files and must differ",
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
                "side 1: the size 1e-300 makes 4.0e300 intervals, and a boundary has at most 4294967294 vertices; give a larger size",
            ),
            (
                polygon(&CORNERS, with(1, Side::count(2).spaced(Spacing::Bump { ratio: 0.0 }))),
                "side 2: the ratio is 0.0; it must be a finite number above 0",
            ),
            // An error of a reversed side speaks of what was given.
            (
                polygon(&clockwise, with(1, Side::count(2).spaced(Spacing::FirstLength(-1.0)))),
                "side 2: the first length is -1.0; it must be a finite number above 0",
            ),
            (
                polygon(
                    &clockwise.map(|[x, y]| [x + 1e8, y + 1e8]),
                    with(1, Side::count(36).spaced(Spacing::Geometric { ratio: 2.0 })),
                ),
                "side 2: its shortest interval is 4.6e-11 long, too short to be told from nothing at the size of the side's coordinates; use fewer intervals or a gentler law, or move the domain towards the origin",
            ),
            (
                polygon(
                    &[[0.0, 1.0], [1.0, 1.0], [1.0, 1.000_000_002]],
                    vec![Side::count(2_000_000), Side::count(1), Side::count(1)],
                ),
                "corner 1: the points next to it are 1.0e-15 from the other side, too close to be told apart at the size of the coordinates; make the intervals there longer or the angle larger, or move the domain towards the origin",
            ),
            (
                polygon(
                    &[[1.0, 1.0], [0.0, 1.0], [1.0, 1.000_000_002]],
                    vec![Side::count(2_000_000), Side::count(1), Side::count(1)],
                ),
                "corner 2: the points next to it are 1.0e-15 from the other side, too close to be told apart at the size of the coordinates; make the intervals there longer or the angle larger, or move the domain towards the origin",
            ),
        ] {
            assert_eq!(outcome.unwrap_err().to_string(), message);
        }
    }
}
