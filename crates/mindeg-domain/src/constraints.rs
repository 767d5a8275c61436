//! Limits on the degrees of a domain's vertices: their edges on the other side of the boundary, and
//! degree limits.
//!
//! The *external degree* of a vertex counts its edges on the other side of the boundary, for example
//! in a neighbouring mesh, without the boundary edges. The *total degree* is the degree in the
//! domain's mesh plus the external degree. A *degree limit* is an upper limit on the total degree. A
//! corner belongs to two sides, and any vertex may also have its own entry: their external degrees
//! add up, and the least of their degree limits holds.
//!
//! Limits: formulas ignore constraints. A mesh that keeps constraints needs the exact solver, which
//! takes some thousand vertices.

use std::collections::BTreeSet;
use std::ops::Range;

use mindeg_mesh::planar::{InRing, Turn};

use crate::error::{DomainError, Place, counted};
use crate::limits::GREATEST_EXTERNAL_DEGREE;
use crate::rings::Rings;
use crate::turning::Turning;

/// The external degrees and degree limits of a domain's sides and vertices.
///
/// # Example
///
/// ```
/// use mindeg_domain::{
///     Constraints, Domain, ExternalDegree, Outline, Rectangle, Side, SideConstraint,
///     VertexConstraint,
/// };
///
/// let outline = Outline::Rectangle(Rectangle::new(4.0, 3.0));
/// let sides = [3, 2, 2, 2].map(Side::count).to_vec();
/// let mut constraints = Constraints {
///     sides: vec![SideConstraint::default(); 4],
///     vertices: vec![VertexConstraint { vertex: 1, external_degree: 1, degree_limit: Some(6) }],
/// };
/// constraints.sides[0].external_degree = ExternalDegree::Inside(2);
///
/// let domain = Domain::builder(outline, sides).constraints(constraints).build()?;
/// assert_eq!([0, 1, 2, 3].map(|vertex| domain.external_degree(vertex)), [0, 3, 2, 0]);
/// assert_eq!((domain.degree_limit(1), domain.degree_limit(2)), (Some(6), None));
/// assert!(domain.is_constrained());
/// # Ok::<(), mindeg_domain::DomainError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Constraints {
    /// One entry for each side, or no entry at all.
    pub sides: Vec<SideConstraint>,
    /// Entries for single vertices, each vertex at most once. In a [`Domain`](crate::Domain) they
    /// are sorted by vertex.
    pub vertices: Vec<VertexConstraint>,
}

/// The degree constraints of a side's vertices.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SideConstraint {
    /// The edges of its vertices on the other side of the boundary.
    pub external_degree: ExternalDegree,
    /// The degree limit of each of its vertices, both corners included.
    pub degree_limit: Option<u32>,
}

/// The external degrees of the vertices of a side.
///
/// Where another mesh shares the side, the external degree of a vertex is its degree there less 2
/// strictly inside the side, and less 1 at either end.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "json", derive(serde::Serialize, schemars::JsonSchema), serde(untagged))]
pub enum ExternalDegree {
    /// The same number at every vertex strictly inside the side, and 0 at its ends.
    Inside(u32),
    /// At each vertex from the side's first corner to its last, one more than its intervals.
    Each(Vec<u32>),
}

/// The degree constraints of a single vertex, in addition to those of its sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VertexConstraint {
    /// The index of the vertex in the domain's mesh.
    pub vertex: u32,
    /// The number of its edges on the other side of the boundary.
    pub external_degree: u32,
    /// Its degree limit.
    pub degree_limit: Option<u32>,
}

impl Default for ExternalDegree {
    fn default() -> Self {
        Self::Inside(0)
    }
}

impl ExternalDegree {
    /// The same constraint in the other direction of the side.
    fn reversed(self) -> Self {
        match self {
            Self::Inside(degree) => Self::Inside(degree),
            Self::Each(degrees) => Self::Each(degrees.into_iter().rev().collect()),
        }
    }

    fn greatest(&self) -> u32 {
        match self {
            Self::Inside(degree) => *degree,
            Self::Each(degrees) => degrees.iter().copied().max().unwrap_or(0),
        }
    }

    /// The external degree at vertex `i` of a side; `i == intervals` is its last vertex.
    fn at(&self, i: u32, intervals: u32) -> u32 {
        match self {
            Self::Inside(degree) if 0 < i && i < intervals => *degree,
            Self::Inside(_) => 0,
            Self::Each(degrees) => degrees[i as usize],
        }
    }
}

impl Constraints {
    /// Whether any vertex has a degree limit or an external degree above 0. O(k) for k sides, and
    /// linear in the entries and lists.
    pub fn constrain(&self) -> bool {
        let side = |side: &SideConstraint| {
            side.external_degree.greatest() > 0 || side.degree_limit.is_some()
        };
        let vertex = |constraint: &VertexConstraint| {
            constraint.external_degree > 0 || constraint.degree_limit.is_some()
        };
        self.sides.iter().any(side) || self.vertices.iter().any(vertex)
    }

    /// The external degree of a vertex of the boundary that checked these constraints. O(log n).
    pub(crate) fn external_degree(&self, rings: &Rings, vertex: u32) -> u32 {
        let sides = self.sides_at(rings, vertex);
        let of_sides =
            sides.map(|(side, i, intervals)| side.external_degree.at(i, intervals)).sum::<u32>();
        // The sum is at most three times the greatest external degree.
        of_sides + self.of_vertex(vertex).map_or(0, |constraint| constraint.external_degree)
    }

    /// The degree limit of a vertex, the least of all that apply. O(log n).
    pub(crate) fn degree_limit(&self, rings: &Rings, vertex: u32) -> Option<u32> {
        let sides = self.sides_at(rings, vertex).filter_map(|(side, ..)| side.degree_limit);
        let own = self.of_vertex(vertex).and_then(|constraint| constraint.degree_limit);
        sides.chain(own).min()
    }

    fn of_vertex(&self, vertex: u32) -> Option<&VertexConstraint> {
        let index = self.vertices.binary_search_by_key(&vertex, |constraint| constraint.vertex);
        index.ok().map(|index| &self.vertices[index])
    }

    /// The side or, at a corner, the two sides of a vertex, each with the index of the vertex on it
    /// and its intervals.
    fn sides_at(
        &self,
        rings: &Rings,
        vertex: u32,
    ) -> impl Iterator<Item = (&SideConstraint, u32, u32)> {
        let side = rings.side_of(vertex);
        let i = vertex - rings.corner(side);
        let here = [(side, i, rings.intervals(side))];
        let ends_here = (i == 0).then(|| {
            let before = rings.previous_side(side);
            let intervals = rings.intervals(before);
            (before, intervals, intervals)
        });
        here.into_iter().chain(ends_here).filter_map(|(side, i, intervals)| {
            self.sides.get(side).map(|constraint| (constraint, i, intervals))
        })
    }

    /// Reverses the constraints of a range of sides; vertices stay.
    pub(crate) fn turn_sides(&mut self, sides: Range<usize>) {
        let Some(sides) = self.sides.get_mut(sides) else { return };
        sides.reverse();
        for side in sides {
            side.external_degree = std::mem::take(&mut side.external_degree).reversed();
        }
    }

    /// Checks that each side has an entry, or that the list is empty.
    pub(crate) fn check_side_count(&self, sides: usize) -> Result<(), DomainError> {
        let entries = self.sides.len();
        if [0, sides].contains(&entries) {
            return Ok(());
        }
        Err(Place::key("sides").error(format!(
            "found constraints of {entries} sides, and the outline has {sides} sides; give one \
                 entry for each side, or none"
        )))
    }

    /// Checks these constraints on their boundary and sorts the vertices. `given` maps a side to the
    /// side of the description.
    ///
    /// O(k + m log m) for k straight sides and m vertices, and linear in lists and in the vertices
    /// of sides that are not straight.
    pub(crate) fn checked(
        mut self,
        turning: Turning<'_>,
        given: impl Fn(usize) -> InRing,
    ) -> Result<Self, DomainError> {
        let vertex_count = turning.placement.rings().vertex_count();
        let vertices = std::mem::take(&mut self.vertices);
        self.check_sides(turning, given)?;
        let entry_place = |entry: usize| Place::key("vertices").then(entry);
        let mut seen = BTreeSet::new();
        for (entry, &VertexConstraint { vertex, external_degree, .. }) in
            vertices.iter().enumerate()
        {
            let place = || entry_place(entry).then("vertex");
            if vertex >= vertex_count {
                return Err(place().error(format!(
                    "vertex {vertex} does not exist; the {vertex_count} vertices are numbered \
                         from 0, counter-clockwise from the first corner"
                )));
            }
            if !seen.insert(vertex) {
                let message = format!("vertex {vertex} is listed twice; give it one entry");
                return Err(place().error(message));
            }
            check_external_degree(external_degree).map_err(|error| {
                error.within(entry_place(entry), &format!("entry {}", entry + 1))
            })?;
        }
        self.vertices.clone_from(&vertices);
        self.vertices.sort_unstable_by_key(|constraint| constraint.vertex);
        for (entry, constraint) in vertices.iter().enumerate() {
            self.check_capacity(turning, constraint.vertex, || entry_place(entry))?;
        }
        Ok(self)
    }

    /// Checks the constraints of the sides, but not of single vertices.
    fn check_sides(
        &self,
        turning: Turning<'_>,
        given: impl Fn(usize) -> InRing,
    ) -> Result<(), DomainError> {
        let rings = turning.placement.rings();
        self.check_side_count(rings.side_count())?;
        for (side, SideConstraint { external_degree, .. }) in self.sides.iter().enumerate() {
            let vertices = u64::from(rings.intervals(side)) + 1;
            if let ExternalDegree::Each(degrees) = external_degree
                && degrees.len() as u64 != vertices
            {
                let message = format!(
                    "outside_degree lists {}, and the side has {vertices} vertices, both corners \
                     included; give one for each, or a single number for all that are not corners",
                    counted(degrees.len(), "number")
                );
                return Err(Place::key("outside_degree").error(message).of_side(given(side)));
            }
            check_external_degree(external_degree.greatest())
                .map_err(|error| error.of_side(given(side)))?;
        }
        for (side, constraint) in self.sides.iter().enumerate() {
            if constraint.degree_limit.is_none() {
                continue;
            }
            let intervals = rings.intervals(side);
            // All vertices inside a straight side are alike if one value holds for all of them.
            let last_inside = match constraint.external_degree {
                ExternalDegree::Inside(_) if turning.straight[side] => 1.min(intervals - 1),
                _ => intervals - 1,
            };
            let start = rings.corner(side);
            for vertex in (start..=start + last_inside).chain([rings.side_end(side)]) {
                self.check_capacity(turning, vertex, || Place::side(given(side)))?;
            }
        }
        Ok(())
    }

    /// Checks that the degree limit of a vertex allows the edges that it has in every mesh.
    fn check_capacity(
        &self,
        turning: Turning<'_>,
        vertex: u32,
        entry: impl Fn() -> Place,
    ) -> Result<(), DomainError> {
        let rings = turning.placement.rings();
        let Some(limit) = self.degree_limit(rings, vertex) else { return Ok(()) };
        let outside = self.external_degree(rings, vertex);
        // With 2 edges a straight vertex would be the tip of a flat triangle, and a reflex vertex is
        // never the tip of a triangle. A needle's tip is convex, or its foot reflex: the tip needs
        // less.
        let (own, along) = match turning.at(vertex) {
            Turn::Straight => (3, "2 edges along its straight side"),
            Turn::By(angle) if angle <= 0.0 => (3, "2 edges along the boundary"),
            Turn::By(_) | Turn::Back => (2, "2 edges along the boundary"),
        };
        let least = own + outside;
        if limit >= least {
            return Ok(());
        }
        let edges = match (own, outside) {
            (2, 0) => along.to_owned(),
            (2, _) => format!("{along} and {outside} outside"),
            (_, 0) => format!("{along} and 1 into the domain"),
            _ => format!("{along}, 1 into the domain and {outside} outside"),
        };
        Err(entry().then("max_degree").error(format!(
            "vertex {vertex} has a max_degree of {limit} and needs {least}: {edges}; raise \
                 max_degree to {least} or more"
        )))
    }
}

fn check_external_degree(degree: u32) -> Result<(), DomainError> {
    if degree <= GREATEST_EXTERNAL_DEGREE {
        return Ok(());
    }
    let message = format!("outside_degree is {degree}; the maximum is {GREATEST_EXTERNAL_DEGREE}");
    Err(Place::key("outside_degree").error(message))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Domain, DomainError, Outline, Side};
    use glam::DVec2;

    use ExternalDegree::{Each, Inside};

    fn at(
        vertex: u32,
        external_degree: u32,
        degree_limit: impl Into<Option<u32>>,
    ) -> VertexConstraint {
        VertexConstraint { vertex, external_degree, degree_limit: degree_limit.into() }
    }

    type Given = (u64, SideConstraint);

    fn side(
        intervals: u64,
        external_degree: ExternalDegree,
        degree_limit: impl Into<Option<u32>>,
    ) -> Given {
        (intervals, SideConstraint { external_degree, degree_limit: degree_limit.into() })
    }

    /// The sides 0 to 3 of a square with 3, 2, 1 and 2 intervals.
    fn sides() -> [Given; 4] {
        [
            side(3, Each(vec![1, 2, 3, 4]), 12),
            side(2, Inside(7), None),
            side(1, Each(vec![10, 20]), 35),
            side(2, Inside(0), 30),
        ]
    }

    fn square(
        corners: [[f64; 2]; 4],
        given: [Given; 4],
        vertices: &[VertexConstraint],
    ) -> Result<Domain, DomainError> {
        let outline = Outline::Polygon(corners.map(DVec2::from).into());
        let (sides, of_sides) =
            given.into_iter().map(|(count, constraint)| (Side::count(count), constraint)).unzip();
        let constraints = Constraints { sides: of_sides, vertices: vertices.to_vec() };
        Domain::builder(outline, sides).constraints(constraints).build()
    }

    const COUNTERCLOCKWISE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    const CLOCKWISE: [[f64; 2]; 4] = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]];

    #[track_caller]
    fn check(domain: &Domain, external_degrees: [u32; 8], limits: [u32; 8]) {
        let vertices = 0..8;
        assert_eq!(
            vertices.clone().map(|v| domain.external_degree(v)).collect::<Vec<_>>(),
            external_degrees
        );
        let limits_here = vertices.map(|v| domain.degree_limit(v).unwrap_or(0));
        assert_eq!(limits_here.collect::<Vec<_>>(), limits);
    }

    #[test]
    fn constraints_on_one_vertex_count_together() {
        let domain = square(COUNTERCLOCKWISE, sides(), &[]).unwrap();
        check(&domain, [1, 2, 3, 4, 7, 10, 20, 0], [12, 12, 12, 12, 0, 35, 30, 30]);
        let vertices = [at(4, 1, 40), at(0, 5, 13), at(6, 0, 29)];
        let domain = square(COUNTERCLOCKWISE, sides(), &vertices).unwrap();
        check(&domain, [6, 2, 3, 4, 8, 10, 20, 0], [12, 12, 12, 12, 40, 35, 29, 30]);
        assert_eq!(domain.constraints().vertices, [at(0, 5, 13), at(4, 1, 40), at(6, 0, 29)]);
    }

    #[test]
    fn clockwise_sides_keep_theirs() {
        // Counter-clockwise from the first corner: sides 4, 3, 2 and 1 as given, each turned
        // round, and single vertices as the mesh numbers them.
        let domain = square(CLOCKWISE, sides(), &[]).unwrap();
        check(&domain, [1, 0, 20, 10, 7, 4, 3, 2], [12, 30, 30, 35, 0, 12, 12, 12]);
        let domain = square(CLOCKWISE, sides(), &[at(1, 5, None)]).unwrap();
        check(&domain, [1, 5, 20, 10, 7, 4, 3, 2], [12, 30, 30, 35, 0, 12, 12, 12]);
        // The domain's own sides and constraints describe it again.
        let again = Domain::builder(domain.outline().clone(), domain.sides().to_vec())
            .constraints(domain.constraints().clone())
            .build();
        let again = again.unwrap();
        assert_eq!(again.constraints(), domain.constraints());
        assert_eq!(again.placement(), domain.placement());
    }

    fn with_first(first: Given, vertices: &[VertexConstraint]) -> Result<Domain, DomainError> {
        let one = || side(1, Inside(0), None);
        square(COUNTERCLOCKWISE, [first, one(), one(), one()], vertices)
    }

    #[test]
    fn tells_whether_there_are_any() {
        for (given, is_constrained) in [
            (side(2, Inside(0), None), false),
            (side(2, Each(vec![0, 0, 0]), None), false),
            (side(2, Each(vec![0, 0, 1]), None), true),
            (side(2, Inside(1), None), true),
            (side(2, Inside(0), 9), true),
        ] {
            let domain = with_first(given, &[]).unwrap();
            assert_eq!(domain.is_constrained(), is_constrained, "{:?}", domain.constraints());
        }
        for (vertex, is_constrained) in
            [(at(3, 0, None), false), (at(3, 1, None), true), (at(3, 0, 9), true)]
        {
            let domain = with_first(side(2, Inside(0), None), &[vertex]).unwrap();
            assert_eq!(domain.is_constrained(), is_constrained, "{vertex:?}");
        }
        assert!(!Domain::rectangle(1.0, 1.0, vec![Side::count(1); 4]).unwrap().is_constrained());
    }

    #[test]
    fn refuses_with_the_reason() {
        let of = |corners, number: usize, wanted: Given| {
            let mut sides = [0; 4].map(|_| side(1, Inside(0), None));
            sides[number] = wanted;
            square(corners, sides, &[])
        };
        let with = |vertices: &[VertexConstraint]| with_first(side(2, Inside(3), 9), vertices);
        #[rustfmt::skip]
        let table = [
            (of(COUNTERCLOCKWISE, 1, side(2, Each(vec![1, 1]), None)), "side 2: outside_degree lists 2 numbers, and the side has 3 vertices, both corners included; give one for each, or a single number for all that are not corners"),
            (of(CLOCKWISE, 1, side(2, Each(vec![1; 4]), None)), "side 2: outside_degree lists 4 numbers, and the side has 3 vertices, both corners included; give one for each, or a single number for all that are not corners"),
            (of(CLOCKWISE, 1, side(2, Each(vec![1]), None)), "side 2: outside_degree lists 1 number, and the side has 3 vertices, both corners included; give one for each, or a single number for all that are not corners"),
            (of(CLOCKWISE, 1, side(2, Inside(1_000_000_001), None)), "side 2: outside_degree is 1000000001; the maximum is 1000000000"),
            (of(COUNTERCLOCKWISE, 1, side(2, Each(vec![0, u32::MAX, 0]), None)), "side 2: outside_degree is 4294967295; the maximum is 1000000000"),
            (of(COUNTERCLOCKWISE, 1, side(1, Inside(0), 1)), "vertex 1 has a max_degree of 1 and needs 2: 2 edges along the boundary; raise max_degree to 2 or more"),
            (of(COUNTERCLOCKWISE, 1, side(2, Inside(0), 2)), "vertex 2 has a max_degree of 2 and needs 3: 2 edges along its straight side and 1 into the domain; raise max_degree to 3 or more"),
            (of(COUNTERCLOCKWISE, 1, side(2, Inside(3), 4)), "vertex 2 has a max_degree of 4 and needs 6: 2 edges along its straight side, 1 into the domain and 3 outside; raise max_degree to 6 or more"),
            (of(COUNTERCLOCKWISE, 1, side(3, Each(vec![0, 0, 7, 0]), 8)), "vertex 3 has a max_degree of 8 and needs 10: 2 edges along its straight side, 1 into the domain and 7 outside; raise max_degree to 10 or more"),
            (of(COUNTERCLOCKWISE, 3, side(3, Each(vec![0, 0, 0, 7]), 8)), "vertex 0 has a max_degree of 8 and needs 9: 2 edges along the boundary and 7 outside; raise max_degree to 9 or more"),
            (with(&[at(5, 0, None)]), "vertex 5 does not exist; the 5 vertices are numbered from 0, counter-clockwise from the first corner"),
            (with(&[at(2, 0, 5), at(1, 0, 7), at(2, 3, None)]), "vertex 2 is listed twice; give it one entry"),
            (with(&[at(2, 1_000_000_001, None)]), "entry 1: outside_degree is 1000000001; the maximum is 1000000000"),
            (with(&[at(1, 5, None)]), "vertex 1 has a max_degree of 9 and needs 11: 2 edges along its straight side, 1 into the domain and 8 outside; raise max_degree to 11 or more"),
        ];
        for (outcome, message) in table {
            assert_eq!(outcome.unwrap_err().to_string(), message);
        }
        let outline = Outline::Polygon(COUNTERCLOCKWISE.map(DVec2::from).into());
        let three = Constraints { sides: vec![SideConstraint::default(); 3], vertices: vec![] };
        let refused = Domain::builder(outline, vec![Side::count(1); 4])
            .constraints(three)
            .build()
            .unwrap_err();
        assert_eq!(
            refused.to_string(),
            "found constraints of 3 sides, and the outline has 4 sides; give one entry for each side, or none"
        );
    }

    /// The limits refused are those that no triangulation of a small boundary keeps.
    #[test]
    fn a_vertex_inside_a_side_needs_three_edges() {
        for limit in [2, 3] {
            let domain = with_first(side(2, Inside(0), None), &[at(1, 0, limit)]);
            assert_eq!(domain.is_ok(), limit == 3);
        }
        assert!(with_first(side(2, Inside(0), None), &[at(0, 0, 2)]).is_ok());
    }

    #[test]
    fn billions_of_vertices_are_checked_at_once() {
        let wall = side(1_000_000_000, Inside(2), 9);
        let walls = [wall.clone(), wall.clone(), wall.clone(), wall];
        let domain = square(COUNTERCLOCKWISE, walls, &[]).unwrap();
        assert_eq!(domain.external_degree(2_500_000_000), 2);
        assert_eq!(domain.external_degree(2_000_000_000), 0);
        assert_eq!(domain.degree_limit(2_000_000_000), Some(9));
    }
}
