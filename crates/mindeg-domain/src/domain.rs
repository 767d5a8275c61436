//! A convex domain: its outline, and how each of its sides is divided.
//!
//! A [`Domain`] is checked as a whole when it is made, so that every later step (placing,
//! meshing, writing) can rely on it. Sides and corners are counted from 0 in the interface and
//! from 1 in messages, where they are those of the input even if it had to be reversed.
//!
//! Limits: convex outlines with straight sides in the plane, coordinates up to
//! [`GREATEST_COORDINATE`] and sides no shorter than [`LEAST_SIDE`], so that areas neither
//! overflow nor vanish. The unit of length is the user's.

use glam::DVec2;
use mindeg_core::Boundary;

use crate::constraint::{OutsideDegree, VertexConstraint};
use crate::domain_error::DomainError;
use crate::outline::{self, Orientation};
use crate::placement::{Placement, Unresolved};
use crate::rectangle::Rectangle;
use crate::spacing::Spacing;
use crate::spacing_law::SpacingLaw;

/// The greatest magnitude a coordinate may have.
pub const GREATEST_COORDINATE: f64 = 1e100;

/// The shortest side a domain may have.
pub const LEAST_SIDE: f64 = 1e-100;

/// A convex polygon with a number of intervals and a spacing law on every side.
///
/// # Example
///
/// ```
/// use mindeg_domain::{Domain, Side, Spacing};
///
/// let wall = Side::count(6).spaced(Spacing::Geometric { ratio: 1.3 }).named("wall");
/// let domain = Domain::polygon(
///     vec![[0.0, 0.0].into(), [4.0, 0.0].into(), [0.0, 3.0].into()],
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
    vertices: Vec<VertexConstraint>,
    placement: Placement,
    was_reversed: bool,
}

/// The shape of a domain.
#[derive(Clone, Debug, PartialEq)]
pub enum Outline {
    /// A rectangle; its sides are bottom, right, top and left.
    Rectangle(Rectangle),
    /// The corners of a convex polygon; side `s` runs from corner `s` to the next.
    Polygon(Vec<DVec2>),
}

/// How one side is divided.
#[derive(Clone, Debug, PartialEq)]
pub struct Side {
    /// How many intervals.
    pub intervals: Intervals,
    /// How the points are spread, in the direction of the side.
    pub spacing: Spacing,
    /// A name, for the groups of mesh files.
    pub name: Option<String>,
    /// How many edges its vertices have on the other side of the boundary.
    pub outside_degree: OutsideDegree,
    /// The most edges any of its vertices may have, those on the other side of the boundary and
    /// both corners included.
    pub max_degree: Option<u32>,
}

/// The number of intervals of a side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Intervals {
    /// So many, at least 1.
    Count(u64),
    /// As many as make intervals of about this length: the side's length divided by it,
    /// rounded, at least 1.
    Size(f64),
}

impl Side {
    /// A side of `intervals` even intervals.
    #[must_use]
    pub fn count(intervals: u64) -> Self {
        Self {
            intervals: Intervals::Count(intervals),
            spacing: Spacing::Uniform,
            name: None,
            outside_degree: OutsideDegree::default(),
            max_degree: None,
        }
    }

    /// A side of even intervals of about the length `size`.
    #[must_use]
    pub fn size(size: f64) -> Self {
        Self { intervals: Intervals::Size(size), ..Self::count(1) }
    }

    /// A side with points at the given parameters, strictly increasing in (0, 1).
    #[must_use]
    pub fn parameters(parameters: Vec<f64>) -> Self {
        Self::count(parameters.len() as u64 + 1).spaced(Spacing::Parameters(parameters))
    }

    /// The same side with another spacing law.
    #[must_use]
    pub fn spaced(self, spacing: Spacing) -> Self {
        Self { spacing, ..self }
    }

    /// The same side with a name.
    #[must_use]
    pub fn named(self, name: impl Into<String>) -> Self {
        Self { name: Some(name.into()), ..self }
    }
}

impl Domain {
    /// A domain from its outline and one [`Side`] for each of the outline's sides.
    ///
    /// Corners given clockwise are reversed, each side staying on its edge (with its spacing law
    /// [reversed](Spacing::reversed), and what it lists of its vertices): the first corner given stays the first, and the side that
    /// ended there now starts there. [`was_reversed`](Self::was_reversed) tells.
    ///
    /// O(k log k) for k sides, and linear in explicit parameters.
    ///
    /// # Errors
    ///
    /// Whatever is wrong first, in this order: a measure of the rectangle; the corners, in
    /// number, magnitude, order or convexity; the number of sides; their names; their intervals;
    /// their spacing laws; points so close that f64 cannot tell them apart; and constraints on
    /// degrees.
    pub fn new(mut outline: Outline, mut sides: Vec<Side>) -> Result<Self, DomainError> {
        let mut corners = match &outline {
            Outline::Rectangle(rectangle) => rectangle.corners()?,
            Outline::Polygon(corners) => corners.clone(),
        };
        let was_reversed = outline::check(&corners)? == Orientation::Clockwise;
        if sides.len() != corners.len() {
            let (corners, sides) = (corners.len(), sides.len());
            return Err(DomainError::SideCount { corners, sides });
        }
        check_names(&sides)?;

        let count = corners.len();
        let length = |side: usize| corners[(side + 1) % count].distance(corners[side]);
        let mut intervals = Vec::with_capacity(count);
        for (side, Side { intervals: wanted, .. }) in sides.iter().enumerate() {
            intervals.push(match *wanted {
                Intervals::Count(count) => count,
                Intervals::Size(size) if size > 0.0 && size.is_finite() => {
                    // The cast saturates, and the boundary refuses what is too large.
                    (length(side) / size).round().max(1.0) as u64
                }
                Intervals::Size(size) => return Err(DomainError::Size { side, size }),
            });
        }
        let mut boundary = Boundary::new(&intervals)?;
        let solve = |side: usize, spacing: &Spacing| {
            SpacingLaw::solve(spacing, boundary.intervals(side), length(side))
                .map_err(|source| DomainError::Spacing { side, source })
        };
        let mut laws = Vec::with_capacity(count);
        for (side, Side { spacing, .. }) in sides.iter_mut().enumerate() {
            // Solved as given first, so that an error speaks of what was given.
            let mut law = solve(side, spacing)?;
            if was_reversed {
                *spacing = spacing.reversed();
                law = solve(side, spacing)?;
            }
            laws.push(law);
        }

        if was_reversed {
            intervals.reverse();
            boundary = Boundary::new(&intervals)?;
            sides.reverse();
            laws.reverse();
            for Side { outside_degree, .. } in &mut sides {
                *outside_degree = outside_degree.reversed();
            }
            corners[1..].reverse();
            outline = Outline::Polygon(corners.clone());
        }
        let placement = Placement::new(boundary, corners, laws)
            .map_err(|unresolved| unresolved_as_given(unresolved, count, was_reversed))?;
        let domain =
            Self { name: None, outline, sides, vertices: Vec::new(), placement, was_reversed };
        domain.check_side_constraints()?;
        Ok(domain)
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
    pub fn polygon(corners: Vec<DVec2>, sides: Vec<Side>) -> Result<Self, DomainError> {
        Self::new(Outline::Polygon(corners), sides)
    }

    /// The same domain with a name.
    ///
    /// # Errors
    ///
    /// A name that is empty or has control characters.
    pub fn named(self, name: impl Into<String>) -> Result<Self, DomainError> {
        let name = name.into();
        if is_name(&name) {
            Ok(Self { name: Some(name), ..self })
        } else {
            Err(DomainError::Name { side: None, name })
        }
    }

    /// The same domain with constraints that have been checked and are sorted by vertex.
    pub(crate) fn with_sorted_constraints(self, vertices: Vec<VertexConstraint>) -> Self {
        Self { vertices, ..self }
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

    /// What is said of single vertices, sorted by vertex.
    #[must_use]
    pub fn vertex_constraints(&self) -> &[VertexConstraint] {
        &self.vertices
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

/// Names end up in line-oriented files, where a line break would end them.
fn is_name(name: &str) -> bool {
    !name.trim().is_empty() && !name.chars().any(char::is_control)
}

fn check_names(sides: &[Side]) -> Result<(), DomainError> {
    let mut names = std::collections::BTreeMap::new();
    for (side, name) in
        sides.iter().enumerate().filter_map(|(s, side)| Some((s, side.name.as_ref()?)))
    {
        if !is_name(name) {
            return Err(DomainError::Name { side: Some(side), name: name.clone() });
        }
        if let Some(first) = names.insert(name, side) {
            return Err(DomainError::RepeatedName { first, second: side, name: name.clone() });
        }
    }
    Ok(())
}

/// The error for points that cannot be told apart, in the numbers of the input.
fn unresolved_as_given(unresolved: Unresolved, count: usize, was_reversed: bool) -> DomainError {
    match unresolved {
        Unresolved::Interval { side, length, .. } => DomainError::UnresolvedInterval {
            side: if was_reversed { count - 1 - side } else { side },
            length,
        },
        Unresolved::Corner { corner, distance } => DomainError::UnresolvedCorner {
            corner: if was_reversed { (count - corner) % count } else { corner },
            distance,
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [[f64; 2]; 4] = [[1.0, 2.0], [5.0, 2.0], [4.0, 5.0], [1.0, 4.0]];

    fn polygon(corners: &[[f64; 2]], sides: Vec<Side>) -> Result<Domain, DomainError> {
        Domain::polygon(corners.iter().copied().map(DVec2::from).collect(), sides)
    }

    #[test]
    fn a_size_gives_the_nearest_count() {
        for (size, count) in [(1.0, 4), (1.1, 4), (1.2, 3), (100.0, 1), (0.5, 8)] {
            let domain = Domain::rectangle(4.0, 4.0, vec![Side::size(size); 4]).unwrap();
            assert!(domain.boundary().sides().eq([count; 4]), "{size}");
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
                Domain::rectangle(1.0, f64::INFINITY, one()),
                "the rectangle's height is inf; it must be a finite number above 0",
            ),
            (
                Domain::rectangle(1.0, 1.0, vec![]),
                "0 sides are described and the outline has 4; describe each side once",
            ),
            (
                Domain::rectangle(1.0, 1.0, one()).unwrap().named("a\nb"),
                "the domain's name \"a\\nb\" cannot be used; names must not be blank and have no line breaks or other control characters",
            ),
            (
                polygon(&CORNERS, with(2, Side::count(1).named(" "))),
                "side 3's name \" \" cannot be used; names must not be blank and have no line breaks or other control characters",
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
                "side 1 has 18446744073709551615 intervals, with which the boundary exceeds the maximum of 4294967294 vertices; use fewer intervals",
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
