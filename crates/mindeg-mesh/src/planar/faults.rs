//! All faults of rings that bound no domain, with their rings and indices.

use std::fmt;
use std::ops::Range;

use glam::{DVec2, DVec3};

use super::boundary::PlanarBoundary;
use super::in_ring::{InRing, ring_name};
use super::orientation;
use super::sweep::{self, Meeting, Nesting};
use crate::Bounds;
use crate::crossing::tree::Tree;

/// The maximum number of listed faults: a scribble can have one for each pair of edges.
pub const MOST_FAULTS: usize = 1000;

/// A fault of rings that should bound a domain. An edge is named by the vertex where it begins.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum BoundaryFault {
    /// No ring at all.
    NoRing,
    /// More than 2³² - 1 points.
    TooManyPoints,
    /// A ring with fewer than three points.
    ShortRing {
        /// The ring.
        ring: usize,
        /// Its points.
        points: usize,
    },
    /// A point with a coordinate that is infinite or not a number.
    NotFinite(InRing),
    /// Two vertices at one point.
    SamePoint([InRing; 2]),
    /// A vertex inside an edge.
    Touch {
        /// The vertex.
        vertex: InRing,
        /// The edge.
        edge: InRing,
    },
    /// Two edges that cross inside both.
    Crossing([InRing; 2]),
    /// A vertex whose edges lie on each other.
    FoldsBack(InRing),
    /// A ring that runs the wrong way round.
    Direction {
        /// The ring.
        ring: usize,
    },
    /// A hole outside the outer ring.
    HoleOutside {
        /// The hole.
        hole: usize,
    },
    /// A hole inside another.
    HoleInHole {
        /// The hole.
        hole: usize,
        /// The innermost hole around it.
        around: usize,
    },
    /// The outer ring inside a hole.
    HoleAround {
        /// The hole.
        hole: usize,
    },
}

impl fmt::Display for BoundaryFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [point, edge] = ["point", "edge"].map(|kind| move |at: &InRing| at.named(kind));
        match self {
            Self::NoRing => write!(f, "a boundary needs an outer ring"),
            Self::TooManyPoints => write!(f, "a boundary has at most {} points", u32::MAX),
            Self::ShortRing { ring, points } => {
                write!(f, "{} has {points} points, and needs at least 3", ring_name(*ring))
            }
            Self::NotFinite(at) => write!(f, "{} is not finite", point(at)),
            Self::SamePoint([a, b]) => write!(f, "{} and {} coincide", point(a), point(b)),
            Self::Touch { vertex, edge: on } => write!(f, "{} lies on {}", point(vertex), edge(on)),
            Self::Crossing([a, b]) => write!(f, "{} and {} cross", edge(a), edge(b)),
            Self::FoldsBack(at) => write!(f, "the boundary folds back at {}", point(at)),
            Self::Direction { ring: 0 } => {
                write!(f, "the outline runs clockwise, and should run counter-clockwise")
            }
            Self::Direction { ring } => {
                write!(f, "hole {ring} runs counter-clockwise, and should run clockwise")
            }
            Self::HoleOutside { hole } => write!(f, "hole {hole} lies outside the outline"),
            Self::HoleInHole { hole, around } => {
                write!(f, "hole {hole} lies inside hole {around}")
            }
            Self::HoleAround { hole } => write!(f, "the outline lies inside hole {hole}"),
        }
    }
}

/// The faults of rings that bound no domain: at least one, up to [`MOST_FAULTS`].
#[derive(Clone, Debug, PartialEq)]
pub struct BoundaryFaults(Vec<BoundaryFault>);

impl std::error::Error for BoundaryFaults {}

impl fmt::Display for BoundaryFaults {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        /// The maximum number of faults in a message.
        const SHOWN: usize = 5;
        for (index, fault) in self.0.iter().take(SHOWN).enumerate() {
            write!(f, "{}{fault}", if index > 0 { "; " } else { "" })?;
        }
        let more = self.0.len().saturating_sub(SHOWN);
        if more > 0 { write!(f, "; and {more} more") } else { Ok(()) }
    }
}

impl BoundaryFaults {
    /// The faults. The first is the one that the sweep from the left finds first.
    pub fn list(&self) -> &[BoundaryFault] {
        &self.0
    }

    /// The first fault.
    pub fn first(&self) -> BoundaryFault {
        self.0.first().copied().unwrap_or(BoundaryFault::NoRing)
    }

    /// Rings that run the wrong way round.
    fn directions(rings: Vec<usize>) -> Self {
        Self(rings.into_iter().map(|ring| BoundaryFault::Direction { ring }).collect())
    }

    /// All points where rings meet, starting with the first that the sweep found.
    fn all(boundary: &PlanarBoundary, first: Meeting) -> Self {
        let mut found = vec![first];
        let new = meetings(boundary).filter(|meeting| *meeting != first);
        found.extend(new.take(MOST_FAULTS - 1));
        let at = |vertex| boundary.in_ring(vertex);
        let placed = found.into_iter().map(|meeting| match meeting {
            Meeting::SamePoint(vertices) => BoundaryFault::SamePoint(vertices.map(at)),
            Meeting::Touch { vertex, edge } => {
                BoundaryFault::Touch { vertex: at(vertex), edge: at(edge) }
            }
            Meeting::Crossing(edges) => BoundaryFault::Crossing(edges.map(at)),
            Meeting::FoldsBack(vertex) => BoundaryFault::FoldsBack(at(vertex)),
        });
        Self(placed.collect())
    }
}

impl PlanarBoundary {
    /// A boundary of rings that run the right way round: the outer one first. O(n log n).
    ///
    /// # Errors
    ///
    /// All faults of the rings.
    pub fn new<R: AsRef<[DVec2]>>(rings: &[R]) -> Result<Self, BoundaryFaults> {
        let (boundary, turned) = Self::oriented(rings)?;
        if turned.is_empty() { Ok(boundary) } else { Err(BoundaryFaults::directions(turned)) }
    }

    /// A boundary of rings that run either way round, and the indices of the reversed rings, which
    /// keep their first points. O(n log n).
    ///
    /// # Errors
    ///
    /// All faults of the rings.
    pub fn oriented<R: AsRef<[DVec2]>>(rings: &[R]) -> Result<(Self, Vec<usize>), BoundaryFaults> {
        check_rings(rings)?;
        let mut boundary = Self::of_mesh(rings);
        let nesting =
            sweep::nesting(&boundary).map_err(|first| BoundaryFaults::all(&boundary, first))?;
        check_nesting(&nesting)?;
        let is_turned = |&ring: &usize| nesting[ring].is_counter_clockwise != (ring == 0);
        let turned: Vec<usize> = (0..nesting.len()).filter(is_turned).collect();
        for &ring in &turned {
            let Range { start, end } = boundary.ring(ring);
            boundary.points[start as usize + 1..end as usize].reverse();
        }
        Ok((boundary, turned))
    }
}

fn result(faults: Vec<BoundaryFault>) -> Result<(), BoundaryFaults> {
    if faults.is_empty() { Ok(()) } else { Err(BoundaryFaults(faults)) }
}

/// Checks each ring for itself.
fn check_rings<R: AsRef<[DVec2]>>(rings: &[R]) -> Result<(), BoundaryFaults> {
    let count = rings.iter().map(|ring| ring.as_ref().len()).sum::<usize>();
    if rings.is_empty() {
        return result(vec![BoundaryFault::NoRing]);
    }
    if u32::try_from(count).is_err() {
        return result(vec![BoundaryFault::TooManyPoints]);
    }
    let mut faults = Vec::new();
    for (ring, points) in rings.iter().map(AsRef::as_ref).enumerate() {
        if points.len() < 3 {
            faults.push(BoundaryFault::ShortRing { ring, points: points.len() });
        }
        let bad = points.iter().enumerate().filter(|(_, point)| !point.is_finite());
        let bad = bad.map(|(index, _)| BoundaryFault::NotFinite(InRing { ring, index }));
        faults.extend(bad.take(MOST_FAULTS - faults.len().min(MOST_FAULTS)));
    }
    result(faults)
}

/// Checks that ring 0 contains all other rings, and that no other ring contains one.
fn check_nesting(nesting: &[Nesting]) -> Result<(), BoundaryFaults> {
    if let Some(hole) = nesting.first().and_then(|outer| outer.parent) {
        return result(vec![BoundaryFault::HoleAround { hole }]);
    }
    let wrong = |(hole, nested): (usize, &Nesting)| match nested.parent {
        Some(0) => None,
        None => Some(BoundaryFault::HoleOutside { hole }),
        Some(around) => Some(BoundaryFault::HoleInHole { hole, around }),
    };
    result(nesting.iter().enumerate().skip(1).filter_map(wrong).take(MOST_FAULTS).collect())
}

/// All points where rings meet themselves or each other, by the first vertex of each.
fn meetings(boundary: &PlanarBoundary) -> impl Iterator<Item = Meeting> + '_ {
    let ends = move |edge: u32| [edge, boundary.next(edge)];
    let at = move |vertex: u32| boundary.point(vertex);
    let around = |[from, to]: [u32; 2]| {
        let [a, b] = [from, to].map(|vertex| boundary.point(vertex).extend(0.0));
        Bounds::<DVec3> { min: a.min(b), max: a.max(b) }
    };
    let tree = Tree::new(boundary.edges().map(around).collect());
    (0..boundary.vertex_count()).flat_map(move |edge| {
        let [a, b] = ends(edge);
        let [p, q] = [a, b].map(at);
        let mut found = Vec::new();
        let before = boundary.previous(edge);
        if p != q && p != at(before) && orientation(at(before), p, q) == 0.0 {
            let folds = (at(before) - p).dot(q - p) > 0.0;
            found.extend(folds.then_some(Meeting::FoldsBack(edge)));
        }
        let mut near = Vec::new();
        tree.meet(edge, &mut near);
        near.sort_unstable();
        for other in near {
            let [c, d] = ends(other);
            if c > a && at(c) == p {
                found.push(Meeting::SamePoint([a, c]));
            }
            let on_line = |vertex: u32| orientation(p, q, at(vertex)) == 0.0;
            let is_inside =
                |point: DVec2| (point - p).dot(q - p) > 0.0 && (point - q).dot(p - q) > 0.0;
            if c != a && c != b && on_line(c) && is_inside(at(c)) {
                found.push(Meeting::Touch { vertex: c, edge });
            }
            let sides = |[from, to]: [u32; 2], [c, d]: [u32; 2]| {
                let [from, to, c, d] = [from, to, c, d].map(at);
                [orientation(from, to, c), orientation(from, to, d)]
            };
            let are_opposite = |[x, y]: [f64; 2]| x > 0.0 && y < 0.0 || x < 0.0 && y > 0.0;
            if c > a && are_opposite(sides([a, b], [c, d])) && are_opposite(sides([c, d], [a, b])) {
                found.push(Meeting::Crossing([a, c]));
            }
        }
        found
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn faults(rings: &[&[[f64; 2]]]) -> String {
        let points = |ring: &&[[f64; 2]]| ring.iter().copied().map(DVec2::from).collect();
        let rings: Vec<Vec<DVec2>> = rings.iter().map(points).collect();
        PlanarBoundary::new(&rings).map_err(|faults| faults.to_string()).unwrap_err()
    }

    const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]];

    #[test]
    fn every_fault_is_listed_with_its_ring_and_index() {
        let nan = f64::NAN;
        #[rustfmt::skip]
        let table: [(&[&[[f64; 2]]], &str); 10] = [
            (&[], "a boundary needs an outer ring"),
            (&[&SQUARE[..2], &[[nan, 0.0], [1.0, nan]]], "the outline has 2 points, and needs at least 3; hole 1 has 2 points, and needs at least 3; point 1 of hole 1 is not finite; point 2 of hole 1 is not finite"),
            // A zig-zag whose edge 7 crosses three others.
            (&[&[[0.0, 0.0], [8.0, 0.0], [8.0, 2.0], [2.0, 2.0], [2.0, 4.0], [8.0, 4.0], [8.0, 6.0], [4.0, -2.0]]], "edge 1 and edge 7 cross; edge 3 and edge 7 cross; edge 5 and edge 7 cross"),
            (&[&SQUARE, &[[7.0, 1.0], [9.0, 3.0], [7.0, 3.0]], &[[1.0, 9.0], [3.0, 7.0], [1.0, 7.0]]], "edge 3 and edge 3 of hole 2 cross; edge 2 and edge 1 of hole 1 cross; edge 2 and edge 2 of hole 1 cross; edge 3 and edge 1 of hole 2 cross"),
            (&[&[[0.0, 0.0], [4.0, 0.0], [8.0, 0.0], [6.0, 0.0], [4.0, 4.0]]], "the boundary folds back at point 3; point 4 lies on edge 2"),
            (&[&[[0.0, 0.0], [4.0, 0.0], [4.0, 0.0], [0.0, 4.0]]], "point 2 and point 3 coincide"),
            (&[&SQUARE, &[[2.0, 0.0], [3.0, 2.0], [4.0, 0.0]]], "point 3 of hole 1 lies on edge 1; point 1 of hole 1 lies on edge 1"),
            (&[&SQUARE, &[[1.0, 1.0], [2.0, 1.0], [2.0, 2.0]], &[[3.0, 1.0], [4.0, 1.0], [4.0, 2.0]]], "hole 1 runs counter-clockwise, and should run clockwise; hole 2 runs counter-clockwise, and should run clockwise"),
            (&[&SQUARE, &[[9.0, 1.0], [9.0, 2.0], [10.0, 1.0]], &[[1.0, 1.0], [1.0, 5.0], [6.0, 1.0]], &[[2.0, 2.0], [2.0, 2.5], [2.5, 2.0]]], "hole 1 lies outside the outline; hole 3 lies inside hole 2"),
            (&[&[[2.0, 2.0], [3.0, 2.0], [3.0, 3.0]], &SQUARE], "the outline lies inside hole 1"),
        ];
        for (rings, expected) in table {
            assert_eq!(faults(rings), expected);
        }
    }

    #[test]
    fn a_scribble_has_only_so_many_faults() {
        let at = |i: i32| DVec2::new(f64::from(i * 7919 % 1009), f64::from(i * 104_729 % 997));
        let ring: Vec<DVec2> = (1..900).map(at).collect();
        let faults = PlanarBoundary::new(&[ring]).unwrap_err();
        assert_eq!(faults.list().len(), MOST_FAULTS);
        assert!(faults.to_string().ends_with("; and 995 more"), "{faults}");
    }
}
