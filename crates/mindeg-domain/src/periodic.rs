//! Periodic sides: a side that is another one, moved. Both have the same points but for the move, and a mesh joined
//! there has one edge where they have two.
//!
//! Limits: both sides are of one ring, and the domain's left of both, so that the joined mesh is orientable.

use std::ops::Range;

use glam::DVec2;
use mindeg_mesh::planar::{InRing, ring_name};
use mindeg_mesh::{Bounds, number};

use crate::curve::Curve;
use crate::error::{DomainError, Place};
use crate::given::sides_of;
use crate::matching::{Move, SideMatch};
use crate::outline::Ring;
use crate::rings::Rings;
use crate::side::{Intervals, Side};
use crate::spacing::Spacing;

/// The ends of two sides fit if they are within this share of the ring's extent.
const FIT: f64 = 1e-9;

/// A periodic side of a domain.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodicSide {
    /// The index of the side.
    pub side: usize,
    /// The sides that it is, moved: one, or the parts of one, in their order.
    pub of: Vec<usize>,
    /// The rows of the matrix that moves a point (x, y, 1) of the other side here.
    pub matrix: [[f64; 3]; 2],
    /// Each vertex of the side from its first corner to its last, with the vertex that is moved there.
    pub vertices: Vec<[u32; 2]>,
}

/// The periodic sides of a domain, and the vertices and edges that they make one.
///
/// # Example
///
/// ```
/// use mindeg_domain::{Domain, Move, Side, SideMatch};
///
/// let right = Side::count(1).matching(SideMatch { of: "left".into(), by: Move::Translation });
/// let sides = vec![Side::count(4), right, Side::count(4), Side::count(3).named("left")];
/// let domain = Domain::rectangle(4.0, 3.0, sides)?;
/// let periodic = domain.periodic().expect("a periodic side");
/// assert_eq!(periodic.sides()[0].vertices, [[4, 0], [5, 13], [6, 12], [7, 11]]);
/// assert_eq!((periodic.vertex(4), periodic.vertex(6)), (0, 6));
/// assert_eq!(domain.placement().point(5).to_array(), [4.0, 1.0]);
/// # Ok::<(), mindeg_domain::DomainError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Periodic {
    sides: Vec<PeriodicSide>,
    /// For each vertex of the rings the least of those that are one with it.
    vertices: Vec<u32>,
    /// For the least vertex of each class how many vertices are one there, and the ends of edges there that count twice in
    /// a sum over the class.
    counts: Vec<[u32; 2]>,
}

impl Periodic {
    /// The periodic sides, in their order.
    pub fn sides(&self) -> &[PeriodicSide] {
        &self.sides
    }

    /// The least of the vertices that are one with a vertex in the joined mesh; a vertex inside is itself.
    pub fn vertex(&self, vertex: u32) -> u32 {
        self.vertices.get(vertex as usize).copied().unwrap_or(vertex)
    }

    /// The ends of edges that count twice if the degrees of all vertices that are one with a vertex are added up.
    pub fn doubled(&self, vertex: u32) -> u32 {
        self.counts.get(self.vertex(vertex) as usize).map_or(0, |counts| counts[1])
    }

    /// Whether a vertex of a ring is inside the joined mesh: both edges of every vertex that is one with it are of periodic
    /// sides.
    pub fn is_inside(&self, vertex: u32) -> bool {
        let counts = self.counts.get(self.vertex(vertex) as usize);
        counts.is_some_and(|[vertices, doubled]| vertices == doubled)
    }

    /// The vertices of the rings that are one with others, in lists of those that are one, each ascending. O(n).
    pub fn joined(&self) -> Vec<Vec<u32>> {
        let mut lists = vec![Vec::new(); self.vertices.len()];
        for (vertex, &least) in (0..).zip(&self.vertices) {
            lists[least as usize].push(vertex);
        }
        lists.retain(|list| list.len() > 1);
        lists
    }

    /// Replaces the degree of each vertex by that in the joined mesh. O(n).
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::{Domain, Move, Side, SideMatch};
    ///
    /// let matched = |of: &str| Side::count(1).matching(SideMatch { of: of.into(), by: Move::Translation });
    /// let [bottom, left] = ["bottom", "left"].map(|name| Side::count(1).named(name));
    /// let torus = Domain::rectangle(1.0, 1.0, vec![bottom, matched("left"), matched("bottom"), left])?;
    /// // Two triangles. Joined, they have one vertex and three edges.
    /// let mut degrees = [3, 2, 3, 2];
    /// torus.periodic().expect("periodic sides").join(&mut degrees);
    /// assert_eq!(degrees, [6; 4]);
    /// # Ok::<(), mindeg_domain::DomainError>(())
    /// ```
    pub fn join(&self, degrees: &mut [u32]) {
        let mut totals = vec![0_u32; self.vertices.len()];
        for (&least, &degree) in self.vertices.iter().zip(&*degrees) {
            totals[least as usize] = totals[least as usize].saturating_add(degree);
        }
        for (&least, degree) in self.vertices.iter().zip(degrees) {
            *degree = totals[least as usize].saturating_sub(self.counts[least as usize][1]);
        }
    }

    /// The periodic sides of placed rings; none if there are none.
    pub(crate) fn new(given: &[Ring], rings: &Rings) -> Result<Option<Self>, DomainError> {
        let found = matched(given)?;
        if found.is_empty() {
            return Ok(None);
        }
        let first = |ring: usize| rings.ring_sides(ring).start;
        let mut sides = Vec::with_capacity(found.len());
        for Found { at, of, matrix } in found {
            let side = first(at.ring) + at.index;
            let own: Vec<usize> = of.iter().map(|index| first(at.ring) + index).collect();
            let mut other: Vec<u32> = own
                .iter()
                .flat_map(|&side| rings.corner(side)..rings.corner(side) + rings.intervals(side))
                .collect();
            other.extend(own.last().map(|&last| rings.side_end(last)));
            let start = rings.corner(side);
            let here = (start..start + rings.intervals(side)).chain([rings.side_end(side)]);
            if other.len() as u64 != u64::from(rings.intervals(side)) + 1 {
                return Err(Place::side(at).then("match").error(format!(
                    "{} and the side that it matches have different numbers of points; end no line within either",
                    at.side()
                )));
            }
            let vertices = here.zip(other.into_iter().rev()).map(|(own, of)| [own, of]).collect();
            sides.push(PeriodicSide { side, of: own, matrix, vertices });
        }
        let mut vertices = Vec::from_iter(0..rings.vertex_count());
        for &[one, other] in sides.iter().flat_map(|side| &side.vertices) {
            let [one, other] = [one, other].map(|vertex| root(&mut vertices, vertex));
            vertices[one.max(other) as usize] = one.min(other);
        }
        let vertices: Vec<u32> =
            (0..rings.vertex_count()).map(|vertex| root(&mut vertices, vertex)).collect();
        let mut counts = vec![[0; 2]; vertices.len()];
        vertices.iter().for_each(|&least| counts[least as usize][0] += 1);
        for pair in sides.iter().flat_map(|side| side.vertices.windows(2)) {
            pair.iter().for_each(|[end, _]| counts[vertices[*end as usize] as usize][1] += 1);
        }
        Ok(Some(Self { sides, vertices, counts }))
    }
}

/// The least vertex that a vertex leads to.
fn root(least: &mut [u32], mut vertex: u32) -> u32 {
    while least[vertex as usize] != vertex {
        let above = least[least[vertex as usize] as usize];
        least[vertex as usize] = above;
        vertex = above;
    }
    vertex
}

/// A side that matches others of its ring.
struct Found {
    at: InRing,
    /// The indices of these in the ring.
    of: Vec<usize>,
    matrix: [[f64; 3]; 2],
}

/// Gives matched sides the points of the sides that they match.
pub(crate) fn divide(given: &mut [Ring]) -> Result<(), DomainError> {
    for Found { at, of, matrix } in matched(given)? {
        let ring = &given[at.ring];
        let mut points = Vec::new();
        for index in of {
            let other = sides_of(at.ring, ring).nth(index);
            points.extend(other.map(|side| side.points()).transpose()?.into_iter().flatten());
        }
        let own = points[1..].iter().rev().map(|&point| moved(&matrix, point)).collect();
        let side = &mut given[at.ring].sides[at.index];
        *side = Side {
            curve: Curve::Polyline(own),
            intervals: Intervals::Points,
            spacing: Spacing::Uniform,
            ..side.clone()
        };
    }
    Ok(())
}

fn moved(matrix: &[[f64; 3]; 2], point: DVec2) -> DVec2 {
    let coordinate = |[a, b, c]: [f64; 3]| match [a, b] {
        // One rounding.
        [1.0, 0.0] => point.x + c,
        [0.0, 1.0] => point.y + c,
        _ => a * point.x + b * point.y + c,
    };
    DVec2::new(coordinate(matrix[0]), coordinate(matrix[1]))
}

/// The point that is moved to a point of a matched side.
pub(crate) fn moved_back(at: InRing, given: &[Ring], point: DVec2) -> Result<DVec2, DomainError> {
    let Some(wanted) = &given[at.ring].sides[at.index].matches else { return Ok(point) };
    let [[a, b, x], [c, d, y]] = found_match(at, wanted, given)?.matrix;
    let from = point - DVec2::new(x, y);
    // The inverse of a rotation is its transpose.
    Ok(DVec2::new(a * from.x + c * from.y, b * from.x + d * from.y))
}

/// Refuses to divide a side of a ring whose sides are matched by their indices, which would change.
pub(crate) fn check_names(at: InRing, given: &[Ring], line: &str) -> Result<(), DomainError> {
    let sides = &given[at.ring].sides;
    let is_named = |of: &String| sides.iter().any(|side| side.name.as_ref() == Some(of));
    let unnamed = sides.iter().enumerate().find_map(|(index, side)| {
        let of = &side.matches.as_ref()?.of;
        (!is_named(of)).then_some((index, of))
    });
    let Some((index, of)) = unnamed else { return Ok(()) };
    let place = Place::key("match").then("of");
    let error = place.error(format!(
        "{line} ends within {}, which is divided there, so that indices of sides change; give {of} a name, and match that",
        at.side()
    ));
    Err(error.of_side(InRing { index, ..at }))
}

/// All matched sides.
fn matched(given: &[Ring]) -> Result<Vec<Found>, DomainError> {
    let mut found = Vec::new();
    for (ring, whole) in given.iter().enumerate() {
        if whole.corners.len() != whole.sides.len() {
            continue;
        }
        for (index, side) in whole.sides.iter().enumerate() {
            if let Some(wanted) = &side.matches {
                found.push(found_match(InRing { ring, index }, wanted, given)?);
            }
        }
    }
    Ok(found)
}

fn found_match(at: InRing, wanted: &SideMatch, given: &[Ring]) -> Result<Found, DomainError> {
    let Ring { corners, sides } = &given[at.ring];
    let error = |key: &str, message: String| {
        let place = Place::key("match").then(key);
        Err(place.error(message).of_side(at))
    };
    let is_called = |&index: &usize| sides[index].name.as_ref() == Some(&wanted.of);
    let mut named: Vec<usize> = (0..sides.len()).filter(is_called).collect();
    if named.is_empty() {
        named.extend((0..sides.len()).find(|&index| InRing { index, ..at }.side() == wanted.of));
    }
    let name = &wanted.of;
    let Some(run) = one_run(&named, sides.len()) else {
        let count = named.len();
        let message = match count {
            0 => format!(
                "no side of {} is called {name:?}; give the name of one",
                ring_name(at.ring)
            ),
            _ => format!(
                "{count} sides are called {name:?} and do not follow one another; give one a name of its own"
            ),
        };
        return error("of", message);
    };
    if run.contains(&at.index) {
        return error("of", format!("{name:?} is the side itself; name the other one"));
    }
    if run.iter().any(|&index| sides[index].matches.is_some()) {
        let message = format!("{name:?} itself matches another side; match that one");
        return error("of", message);
    }
    let corner = |index: usize| corners[index % corners.len()];
    let [start, end] = [corner(at.index), corner(at.index + 1)];
    let [from, to] = [corner(run[0]), corner(run[run.len() - 1] + 1)];
    let extent =
        Bounds::of(corners.iter().copied()).map_or(0.0, |bounds| bounds.size().max_element());
    let matrix = match wanted.by {
        Move::Translation => {
            let by = start - to;
            [[1.0, 0.0, by.x], [0.0, 1.0, by.y]]
        }
        Move::Rotation => rotation([to, from], [start, end]),
    };
    let off = [(to, start), (from, end)].map(|(other, own)| moved(&matrix, other).distance(own));
    let off = off[0].max(off[1]);
    let fits = off <= FIT * extent;
    if !fits {
        let hint = match wanted.by {
            Move::Translation => {
                "; the sides must be of one length and run opposite ways, or give \"by\": \"rotation\""
            }
            Move::Rotation => "; the sides must be of one length and not parallel",
        };
        return error(
            "by",
            format!(
                "the corners of {name:?}, moved, are {} away from those of this side{hint}",
                number(off)
            ),
        );
    }
    Ok(Found { at, of: run, matrix })
}

/// Indices of a ring that follow one another, in that order.
fn one_run(indices: &[usize], count: usize) -> Option<Vec<usize>> {
    let is_first = |&&index: &&usize| !indices.contains(&((index + count - 1) % count));
    let first = *indices.iter().find(is_first)?;
    let run: Range<usize> = first..first + indices.len();
    let run: Vec<usize> = run.map(|index| index % count).collect();
    run.iter().all(|index| indices.contains(index)).then_some(run)
}

/// The rotation that brings two points to two others; no number if none does.
fn rotation([from, to]: [DVec2; 2], [start, end]: [DVec2; 2]) -> [[f64; 3]; 2] {
    let (before, after) = (to - from, end - start);
    let turn = DVec2::new(before.dot(after), before.perp_dot(after)) / before.length_squared();
    let turn = turn / turn.length();
    let DVec2 { x: cosine, y: sine } = turn;
    if cosine == 1.0 {
        return [[f64::NAN; 3]; 2];
    }
    let by = start - DVec2::new(cosine * from.x - sine * from.y, sine * from.x + cosine * from.y);
    [[cosine, -sine, by.x], [sine, cosine, by.y]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;

    fn json(sides: &str) -> Result<Domain, String> {
        let text = format!(
            r#"{{"polygon": {{"corners": [[0, 0], [4, 0], [4.1, 3], [0.1, 3]]}}, "sides": [{sides}]}}"#
        );
        Domain::from_json(&text).map_err(|error| error.to_string())
    }

    #[test]
    fn a_matched_side_has_the_moved_points() {
        let domain = json(
            r#"{"intervals": 4, "name": "bottom"}, {"name": "right", "match": {"of": "left"}},
               {"match": {"of": "bottom", "by": "translation"}},
               {"intervals": 5, "spacing": {"geometric": {"ratio": 1.3}}, "name": "left"}"#,
        )
        .unwrap();
        let periodic = domain.periodic().unwrap();
        let points: Vec<DVec2> = domain.placement().points().collect();
        assert_eq!(domain.rings().sides().collect::<Vec<_>>(), [4, 5, 4, 5]);
        for side in periodic.sides() {
            let inside = &side.vertices[1..side.vertices.len() - 1];
            for [here, there] in inside.iter().map(|pair| pair.map(|v| points[v as usize])) {
                assert_eq!(here, moved(&side.matrix, there));
            }
        }
        // All corners are one vertex, and every edge is there twice: nothing is left of the boundary.
        assert!([0, 1, 12].iter().all(|&vertex| periodic.is_inside(vertex)));
        assert_eq!([0, 4, 9, 13].map(|corner| periodic.vertex(corner)), [0; 4]);
        assert_eq!((periodic.doubled(9), periodic.doubled(1), periodic.doubled(12)), (4, 2, 2));
        // Written text reads back bit for bit.
        let again = Domain::from_json(&domain.to_json()).unwrap();
        assert!(again.placement().points().eq(points.iter().copied()));
        assert_eq!(again.periodic(), domain.periodic());
    }

    #[test]
    fn a_sector_is_periodic_by_rotation() {
        let domain = Domain::from_json(
            r#"{"polygon": {"corners": [[1, 0], [4, 0], [0, 4], [0, 1]]}, "sides": [
                {"intervals": 6, "name": "cut", "spacing": {"geometric": {"ratio": 1.2}}},
                {"intervals": 8, "arc": {"center": [0, 0]}},
                {"match": {"of": "cut", "by": "rotation"}},
                {"intervals": 4, "arc": {"center": [0, 0], "clockwise": true}}]}"#,
        )
        .unwrap();
        let periodic = domain.periodic().unwrap();
        assert_eq!(periodic.sides()[0].matrix, [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0]]);
        let point = |vertex: u32| domain.placement().point(vertex);
        for [here, there] in &periodic.sides()[0].vertices {
            assert_eq!(point(*here).to_array(), [0.0, point(*there).x]);
        }
    }

    #[test]
    fn what_does_not_match_is_refused_with_the_place() {
        let right = |keys: &str| {
            let sides = r#"{"intervals": 4, "name": "bottom"}, RIGHT, {"intervals": 4}, {"intervals": 5, "name": "left"}"#;
            json(&sides.replace("RIGHT", keys)).unwrap_err()
        };
        for (keys, place, message) in [
            (
                r#"{"match": {"of": "lift"}}"#,
                "sides[1].match.of",
                "no side of the outline is called \"lift\"",
            ),
            (r#"{"match": {"of": "left", "by": "rotation"}}"#, "sides[1].match.by", "not parallel"),
            (r#"{"match": {"of": "bottom"}}"#, "sides[1].match", "give \"by\": \"rotation\""),
            (r#"{"match": {"of": "side 2"}}"#, "sides[1].match.of", "is the side itself"),
            (r#"{"match": {"of": "left"}, "intervals": 3}"#, "sides[1]", "drop \"intervals\""),
        ] {
            let found = right(keys);
            assert!(found.contains(place) && found.contains(message), "{keys}: {found}");
        }
    }

    #[test]
    fn lines_end_at_points_of_periodic_sides() {
        let domain = Domain::from_json(
            r#"{"rectangle": {"width": 4, "height": 3}, "size": 1,
                "sides": [{}, {"match": {"of": "left"}}, {}, {"name": "left"}],
                "lines": [{"corners": [[0, 1], [4, 1]], "intervals": 4}]}"#,
        )
        .unwrap();
        let side = &domain.periodic().unwrap().sides()[0];
        assert_eq!((side.of.len(), side.vertices.len()), (1, 4));
    }

    /// A line that ends within a matched side was refused.
    #[test]
    fn lines_end_within_periodic_sides_which_both_get_the_point() {
        let domain = |of: &str, lines: &str| {
            let text = format!(
                r#"{{"rectangle": {{"width": 4, "height": 3}}, "size": 1,
                "sides": [{{}}, {{"match": {{"of": "{of}"}}}}, {{}}, {{"name": "left"}}], "lines": [{lines}]}}"#
            );
            Domain::from_json(&text).map_err(|error| error.to_string())
        };
        let one = r#"{"corners": [[2, 1.2], [4, 1.2]], "intervals": 4}"#;
        let across = r#"{"corners": [[0, 1.2], [4, 1.2]], "intervals": 4}"#;
        let two = r#"{"corners": [[2, 1.2], [4, 1.2]], "intervals": 4}, {"corners": [[0, 0.3], [1, 1]], "intervals": 2}"#;
        for (lines, heights) in
            [(one, &[1.2][..]), (across, &[1.2]), (two, &[1.2, 0.3]), (two, &[0.3, 1.2])]
        {
            let domain = domain("left", lines).unwrap();
            let point = |vertex: u32| domain.placement().point(vertex);
            let side = &domain.periodic().unwrap().sides()[0];
            for pair in &side.vertices {
                assert_eq!(point(pair[0]), point(pair[1]) + DVec2::new(4.0, 0.0));
            }
            for height in heights {
                let has = |[own, _]: &&[u32; 2]| (point(*own).y - height).abs() < 1e-12;
                assert_eq!(side.vertices.iter().filter(has).count(), 1, "{lines}: {height}");
            }
            // The line's end is the side's vertex, not one beside it.
            let again = Domain::from_json(&domain.to_json()).unwrap();
            assert_eq!(again.periodic(), domain.periodic());
        }
        let message = domain("side 4", one).unwrap_err();
        assert!(
            message.contains("sides[1].match.of") && message.contains("give side 4 a name"),
            "{message}"
        );
        // By a rotation, too.
        let sector = Domain::from_json(
            r#"{"polygon": {"corners": [[1, 0], [4, 0], [0, 4], [0, 1]]}, "sides": [
                {"intervals": 3, "name": "cut"}, {"intervals": 8, "arc": {"center": [0, 0]}},
                {"match": {"of": "cut", "by": "rotation"}},
                {"intervals": 4, "arc": {"center": [0, 0], "clockwise": true}}],
                "lines": [{"corners": [[0, 2.3], [1, 2.3]], "intervals": 2}]}"#,
        )
        .unwrap();
        let side = &sector.periodic().unwrap().sides()[0];
        let heights = side.vertices.iter().map(|pair| sector.placement().point(pair[0]).y);
        assert!(
            heights.clone().any(|y| (y - 2.3).abs() < 1e-12),
            "{:?}",
            heights.collect::<Vec<_>>()
        );
    }
}
