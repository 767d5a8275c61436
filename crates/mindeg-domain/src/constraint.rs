//! What a domain's vertices have or may have beyond its own mesh: edges on the other side of the
//! boundary, and caps on their degrees.
//!
//! The *total degree* of a vertex is its degree in the domain's mesh and its edges outside
//! together; caps are caps on it. Where several things are said of one vertex, by the two sides
//! at a corner or by a side and an entry of its own, edges outside add up, and of caps the smallest
//! counts.
//!
//! Limits: formulas do not look at constraints. A mesh that honours them takes exact work, which
//! is offered for some thousand vertices.

use std::collections::BTreeMap;

use crate::domain::{Domain, Side};
use crate::domain_error::DomainError;

/// The most edges outside that may be said of a vertex in one place.
pub const GREATEST_OUTSIDE_DEGREE: u32 = 1_000_000_000;

/// How many edges the vertices of a side have on the other side of the boundary, the edges of the
/// boundary itself not among them.
///
/// Where another mesh shares the side, that is a vertex's degree there less 2 strictly inside the
/// side, and less 1 at either end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum OutsideDegree {
    /// So many at every vertex strictly inside the side, and none at its ends.
    Inside(u32),
    /// At each vertex from the side's first corner to its last, one more than its intervals.
    Each(Vec<u32>),
}

impl Default for OutsideDegree {
    fn default() -> Self {
        Self::Inside(0)
    }
}

impl OutsideDegree {
    /// The same of the side in the other direction.
    #[must_use]
    pub(crate) fn reversed(&self) -> Self {
        match self {
            Self::Inside(edges) => Self::Inside(*edges),
            Self::Each(edges) => Self::Each(edges.iter().rev().copied().collect()),
        }
    }

    fn greatest(&self) -> u32 {
        match self {
            Self::Inside(edges) => *edges,
            Self::Each(edges) => edges.iter().copied().max().unwrap_or(0),
        }
    }

    /// At vertex `i` of a side of so many intervals, which is its last for `i == intervals`.
    fn at(&self, i: u32, intervals: u32) -> u32 {
        match self {
            Self::Inside(edges) if 0 < i && i < intervals => *edges,
            Self::Inside(_) => 0,
            Self::Each(edges) => edges[i as usize],
        }
    }
}

/// What is said of a single vertex, besides what is said of its side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VertexConstraint {
    /// The vertex, as numbered in the domain's mesh.
    pub vertex: u32,
    /// How many edges it has on the other side of the boundary.
    pub outside_degree: u32,
    /// The most edges it may have, those on the other side included.
    pub max_degree: Option<u32>,
}

/// Where a constraint stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConstraintPlace {
    /// With the side of this number.
    Side(usize),
    /// In this place of the list of [`VertexConstraint`]s.
    Entry(usize),
}

impl Domain {
    /// The same domain with constraints on single vertices, in place of those it had.
    ///
    /// O(m log m) for m vertices.
    ///
    /// # Errors
    ///
    /// A vertex that does not exist or comes twice, more than [`GREATEST_OUTSIDE_DEGREE`] edges
    /// outside, or a cap below what a vertex has outside and along the boundary.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::{Domain, OutsideDegree, Side, VertexConstraint};
    ///
    /// let shared = Side { outside_degree: OutsideDegree::Inside(2), ..Side::count(3) };
    /// let others = [2, 2, 2].map(Side::count);
    /// let domain = Domain::rectangle(4.0, 3.0, [vec![shared], others.into()].concat())?
    ///     .with_vertex_constraints(vec![
    ///         VertexConstraint { vertex: 1, outside_degree: 1, max_degree: Some(6) },
    ///     ])?;
    /// assert_eq!([0, 1, 2, 3].map(|vertex| domain.outside_degree(vertex)), [0, 3, 2, 0]);
    /// assert_eq!((domain.max_degree(1), domain.max_degree(2)), (Some(6), None));
    /// assert!(domain.is_constrained());
    /// # Ok::<(), mindeg_domain::DomainError>(())
    /// ```
    pub fn with_vertex_constraints(
        self,
        given: Vec<VertexConstraint>,
    ) -> Result<Self, DomainError> {
        let vertex_count = self.boundary().vertex_count();
        let mut first_entries = BTreeMap::new();
        for (entry, &VertexConstraint { vertex, outside_degree, .. }) in given.iter().enumerate() {
            if vertex >= vertex_count {
                return Err(DomainError::NoSuchVertex { entry, vertex, vertex_count });
            }
            if let Some(first) = first_entries.insert(vertex, entry) {
                return Err(DomainError::RepeatedVertex { first, second: entry, vertex });
            }
            check_outside_degree(ConstraintPlace::Entry(entry), outside_degree)?;
        }
        let mut sorted = given.clone();
        sorted.sort_unstable_by_key(|constraint| constraint.vertex);
        let domain = self.with_sorted_constraints(sorted);
        for (entry, constraint) in given.iter().enumerate() {
            domain.check_room(constraint.vertex, ConstraintPlace::Entry(entry))?;
        }
        Ok(domain)
    }

    /// Checks what is said of sides, before anything is said of single vertices. Sides are
    /// numbered as given in errors.
    pub(crate) fn check_side_constraints(&self) -> Result<(), DomainError> {
        let boundary = self.boundary();
        let count = self.sides().len();
        let as_given = |side| if self.was_reversed() { count - 1 - side } else { side };
        for (side, Side { outside_degree, .. }) in self.sides().iter().enumerate() {
            let vertices = u64::from(boundary.intervals(side)) + 1;
            match outside_degree {
                OutsideDegree::Each(edges) if edges.len() as u64 != vertices => {
                    let (side, numbers) = (as_given(side), edges.len());
                    return Err(DomainError::OutsideDegreeCount { side, numbers, vertices });
                }
                _ => {}
            }
            check_outside_degree(ConstraintPlace::Side(as_given(side)), outside_degree.greatest())?;
        }
        for (side, Side { outside_degree, max_degree, .. }) in self.sides().iter().enumerate() {
            if max_degree.is_none() {
                continue;
            }
            let intervals = boundary.intervals(side);
            // All vertices inside the side are alike where one number stands for them.
            let last_inside = match outside_degree {
                OutsideDegree::Inside(_) => 1.min(intervals - 1),
                OutsideDegree::Each(_) => intervals - 1,
            };
            let start = boundary.corner(side);
            let end = boundary.corner(side + 1);
            for vertex in (start..=start + last_inside).chain([end]) {
                self.check_room(vertex, ConstraintPlace::Side(as_given(side)))?;
            }
        }
        Ok(())
    }

    fn check_room(&self, vertex: u32, place: ConstraintPlace) -> Result<(), DomainError> {
        let outside_degree = self.outside_degree(vertex);
        match self.max_degree(vertex) {
            Some(max_degree) if max_degree < 2 + outside_degree => {
                Err(DomainError::NoRoom { place, vertex, max_degree, outside_degree })
            }
            _ => Ok(()),
        }
    }

    /// How many edges a vertex has on the other side of the boundary. O(log n).
    ///
    /// # Panics
    ///
    /// When the domain has no such vertex.
    #[must_use]
    pub fn outside_degree(&self, vertex: u32) -> u32 {
        let of_sides = self.sides_at(vertex).map(|(side, i)| {
            self.sides()[side].outside_degree.at(i, self.boundary().intervals(side))
        });
        let own = self.constraint_on(vertex).map_or(0, |constraint| constraint.outside_degree);
        // Three times the greatest number at most.
        of_sides.sum::<u32>() + own
    }

    /// The most edges a vertex may have, those on the other side of the boundary included; `None`
    /// where nothing says so. O(log n).
    ///
    /// # Panics
    ///
    /// When the domain has no such vertex.
    #[must_use]
    pub fn max_degree(&self, vertex: u32) -> Option<u32> {
        let of_sides = self.sides_at(vertex).filter_map(|(side, _)| self.sides()[side].max_degree);
        let own = self.constraint_on(vertex).and_then(|constraint| constraint.max_degree);
        of_sides.chain(own).min()
    }

    /// Whether any vertex has edges outside or a cap. O(k) for k sides, and linear in what is
    /// said of single vertices.
    #[must_use]
    pub fn is_constrained(&self) -> bool {
        let side = |side: &Side| side.outside_degree.greatest() > 0 || side.max_degree.is_some();
        let vertex = |constraint: &VertexConstraint| {
            constraint.outside_degree > 0 || constraint.max_degree.is_some()
        };
        self.sides().iter().any(side) || self.vertex_constraints().iter().any(vertex)
    }

    fn constraint_on(&self, vertex: u32) -> Option<&VertexConstraint> {
        let constraints = self.vertex_constraints();
        let place = constraints.binary_search_by_key(&vertex, |constraint| constraint.vertex);
        place.ok().map(|place| &constraints[place])
    }

    /// The side or, at a corner, the two sides of a vertex, each with the vertex's place on it.
    fn sides_at(&self, vertex: u32) -> impl Iterator<Item = (usize, u32)> {
        let boundary = self.boundary();
        let side = boundary.side_of(vertex);
        let i = vertex - boundary.corner(side);
        let before = (side + boundary.side_count() - 1) % boundary.side_count();
        let ends_here = (i == 0).then(|| (before, boundary.intervals(before)));
        std::iter::once((side, i)).chain(ends_here)
    }
}

fn check_outside_degree(place: ConstraintPlace, edges: u32) -> Result<(), DomainError> {
    if edges > GREATEST_OUTSIDE_DEGREE {
        return Err(DomainError::OutsideDegree { place, edges });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    fn at(
        vertex: u32,
        outside_degree: u32,
        max_degree: impl Into<Option<u32>>,
    ) -> VertexConstraint {
        VertexConstraint { vertex, outside_degree, max_degree: max_degree.into() }
    }

    fn side(
        intervals: u64,
        outside_degree: OutsideDegree,
        max_degree: impl Into<Option<u32>>,
    ) -> Side {
        Side { outside_degree, max_degree: max_degree.into(), ..Side::count(intervals) }
    }

    use OutsideDegree::{Each, Inside};

    /// The sides 0 to 3 of a square with 3, 2, 1 and 2 intervals.
    fn sides() -> Vec<Side> {
        vec![
            side(3, Each(vec![1, 2, 3, 4]), 12),
            side(2, Inside(7), None),
            side(1, Each(vec![10, 20]), 35),
            side(2, Inside(0), 30),
        ]
    }

    fn square(corners: [[f64; 2]; 4], sides: Vec<Side>) -> Result<Domain, DomainError> {
        Domain::polygon(corners.map(DVec2::from).into(), sides)
    }

    const COUNTERCLOCKWISE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    const CLOCKWISE: [[f64; 2]; 4] = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]];

    #[track_caller]
    fn check(domain: &Domain, outside: [u32; 8], caps: [u32; 8]) {
        let vertices = 0..8;
        assert_eq!(vertices.clone().map(|v| domain.outside_degree(v)).collect::<Vec<_>>(), outside);
        let caps_here = vertices.map(|v| domain.max_degree(v).unwrap_or(0));
        assert_eq!(caps_here.collect::<Vec<_>>(), caps);
    }

    #[test]
    fn what_is_said_of_a_vertex_adds_up() {
        let domain = square(COUNTERCLOCKWISE, sides()).unwrap();
        check(&domain, [1, 2, 3, 4, 7, 10, 20, 0], [12, 12, 12, 12, 0, 35, 30, 30]);
        let domain =
            domain.with_vertex_constraints(vec![at(4, 1, 40), at(0, 5, 13), at(6, 0, 29)]).unwrap();
        check(&domain, [6, 2, 3, 4, 8, 10, 20, 0], [12, 12, 12, 12, 40, 35, 29, 30]);
        // A new list stands in place of the old one.
        let domain = domain.with_vertex_constraints(vec![at(7, 1, None)]).unwrap();
        check(&domain, [1, 2, 3, 4, 7, 10, 20, 1], [12, 12, 12, 12, 0, 35, 30, 30]);
    }

    #[test]
    fn clockwise_sides_keep_theirs() {
        let domain = square(CLOCKWISE, sides()).unwrap();
        // Counter-clockwise from the first corner: sides 4, 3, 2 and 1 as given, each turned
        // round, and single vertices as the mesh numbers them.
        check(&domain, [1, 0, 20, 10, 7, 4, 3, 2], [12, 30, 30, 35, 0, 12, 12, 12]);
        let domain = domain.with_vertex_constraints(vec![at(1, 5, None)]).unwrap();
        check(&domain, [1, 5, 20, 10, 7, 4, 3, 2], [12, 30, 30, 35, 0, 12, 12, 12]);
    }

    #[test]
    fn tells_whether_there_are_any() {
        let of = |first: Side| {
            let sides = vec![first, Side::count(1), Side::count(1), Side::count(1)];
            square(COUNTERCLOCKWISE, sides).unwrap()
        };
        assert!(!of(Side::count(2)).is_constrained());
        assert!(!of(side(2, Each(vec![0, 0, 0]), None)).is_constrained());
        assert!(of(side(2, Each(vec![0, 0, 1]), None)).is_constrained());
        assert!(of(side(2, Inside(1), None)).is_constrained());
        assert!(of(side(2, Inside(0), 9)).is_constrained());
        let with =
            |constraint| of(Side::count(2)).with_vertex_constraints(vec![constraint]).unwrap();
        assert!(!with(at(3, 0, None)).is_constrained());
        assert!(with(at(3, 1, None)).is_constrained());
        assert!(with(at(3, 0, 9)).is_constrained());
    }

    #[test]
    fn refuses_with_the_reason() {
        let of = |corners, number: usize, wanted: Side| {
            let mut sides = vec![Side::count(1); 4];
            sides[number] = wanted;
            square(corners, sides)
        };
        let with = |constraints: &[VertexConstraint]| {
            of(COUNTERCLOCKWISE, 0, side(2, Inside(3), 9))?
                .with_vertex_constraints(constraints.to_vec())
        };
        for (outcome, message) in [
            (
                of(COUNTERCLOCKWISE, 1, side(2, Each(vec![1, 1]), None)),
                "side 2: outside_degree lists 2 numbers, and the side has 3 vertices, both corners included; give one for each, or a single number for all that are not corners",
            ),
            (
                of(CLOCKWISE, 1, side(2, Each(vec![1; 4]), None)),
                "side 2: outside_degree lists 4 numbers, and the side has 3 vertices, both corners included; give one for each, or a single number for all that are not corners",
            ),
            (
                of(CLOCKWISE, 1, side(2, Inside(1_000_000_001), None)),
                "side 2: an outside_degree of 1000000001 is more than the 1000000000 that are served",
            ),
            (
                of(COUNTERCLOCKWISE, 1, side(2, Each(vec![0, u32::MAX, 0]), None)),
                "side 2: an outside_degree of 4294967295 is more than the 1000000000 that are served",
            ),
            (
                of(COUNTERCLOCKWISE, 1, side(1, Inside(0), 1)),
                "vertex 1 has a max_degree of 1, less than its 2 edges along the boundary; raise it to 2 or more",
            ),
            (
                of(COUNTERCLOCKWISE, 1, side(2, Inside(3), 4)),
                "vertex 2 has a max_degree of 4, less than its 2 edges along the boundary and 3 outside; raise it to 5 or more",
            ),
            (
                of(COUNTERCLOCKWISE, 1, side(3, Each(vec![0, 0, 7, 0]), 8)),
                "vertex 3 has a max_degree of 8, less than its 2 edges along the boundary and 7 outside; raise it to 9 or more",
            ),
            (
                of(COUNTERCLOCKWISE, 3, side(3, Each(vec![0, 0, 0, 7]), 8)),
                "vertex 0 has a max_degree of 8, less than its 2 edges along the boundary and 7 outside; raise it to 9 or more",
            ),
            (
                with(&[at(5, 0, None)]),
                "vertex 5 does not exist; the 5 vertices are numbered from 0, counter-clockwise from the first corner",
            ),
            (
                with(&[at(2, 0, 5), at(1, 0, 7), at(2, 3, None)]),
                "vertex 2 is listed twice; say all of it in one place",
            ),
            (
                with(&[at(2, 1_000_000_001, None)]),
                "entry 1: an outside_degree of 1000000001 is more than the 1000000000 that are served",
            ),
            (
                with(&[at(1, 5, None)]),
                "vertex 1 has a max_degree of 9, less than its 2 edges along the boundary and 8 outside; raise it to 10 or more",
            ),
        ] {
            assert_eq!(outcome.unwrap_err().to_string(), message);
        }
    }

    #[test]
    fn billions_of_vertices_are_checked_at_once() {
        let wall = side(1_000_000_000, Inside(2), 9);
        let domain = square(COUNTERCLOCKWISE, vec![wall; 4]).unwrap();
        assert_eq!(domain.outside_degree(2_500_000_000), 2);
        assert_eq!(domain.outside_degree(2_000_000_000), 0);
        assert_eq!(domain.max_degree(2_000_000_000), Some(9));
    }
}
