//! All faults of rings that bound no domain, with their rings and indices.

use std::fmt;
use std::ops::Range;

use glam::DVec2;

use super::boundary::PlanarBoundary;
use super::in_ring::{BoundaryPlace, InRing, ring_name};
use super::meetings::meetings;
use super::orientation;
use super::sweep::{Meeting, Swept};

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
    /// A line with fewer than two points.
    ShortLine {
        /// The line.
        line: usize,
    },
    /// A point with a coordinate that is infinite or not a number.
    NotFinite(BoundaryPlace),
    /// Two vertices at one point.
    SamePoint([BoundaryPlace; 2]),
    /// A vertex inside an edge.
    Touch {
        /// The vertex.
        vertex: BoundaryPlace,
        /// The edge.
        edge: BoundaryPlace,
    },
    /// Two edges that cross inside both.
    Crossing([BoundaryPlace; 2]),
    /// A vertex of a ring whose edges lie on each other.
    FoldsBack(InRing),
    /// An edge of a line that lies on another edge from the same vertex.
    Overlap([BoundaryPlace; 2]),
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
    /// An edge of a line, or an inner point, that is in a hole or outside the outline.
    Outside(BoundaryPlace),
}

impl fmt::Display for BoundaryFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [point, edge] = ["point", "edge"].map(|kind| move |at: &BoundaryPlace| at.named(kind));
        match self {
            Self::NoRing => write!(f, "a boundary needs an outer ring"),
            Self::TooManyPoints => write!(f, "a boundary has at most {} points", u32::MAX),
            Self::ShortRing { ring, points } => {
                write!(f, "{} has {points} points, and needs at least 3", ring_name(*ring))
            }
            Self::ShortLine { line } => {
                write!(f, "line {} has fewer than 2 points", line + 1)
            }
            Self::NotFinite(at) => write!(f, "{} is not finite", point(at)),
            Self::SamePoint([a, b]) => write!(f, "{} and {} coincide", point(a), point(b)),
            Self::Touch { vertex, edge: on } => write!(f, "{} lies on {}", point(vertex), edge(on)),
            Self::Crossing([a, b]) => write!(f, "{} and {} cross", edge(a), edge(b)),
            Self::FoldsBack(at) => write!(f, "the boundary folds back at {}", at.named("point")),
            Self::Overlap([a, b]) => write!(f, "{} and {} lie on each other", edge(a), edge(b)),
            Self::Outside(at) => write!(f, "{} lies outside the domain", edge(at)),
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
    pub(super) fn directions(rings: Vec<usize>) -> Self {
        Self(rings.into_iter().map(|ring| BoundaryFault::Direction { ring }).collect())
    }

    /// All points where rings and lines meet, starting with the first that the sweep found.
    pub(super) fn all(boundary: &PlanarBoundary, first: Meeting) -> Self {
        let mut found = vec![first];
        let new = meetings(boundary).filter(|meeting| *meeting != first);
        found.extend(new.take(MOST_FAULTS - 1));
        let vertex = |vertex| boundary.place_of_vertex(vertex);
        let edge = |edge| boundary.place_of_edge(edge);
        let placed = found.into_iter().map(|meeting| match meeting {
            Meeting::SamePoint(vertices) => BoundaryFault::SamePoint(vertices.map(vertex)),
            Meeting::Touch { vertex: at, edge: on } => {
                BoundaryFault::Touch { vertex: vertex(at), edge: edge(on) }
            }
            Meeting::Crossing(edges) => BoundaryFault::Crossing(edges.map(edge)),
            Meeting::FoldsBack(vertex) => BoundaryFault::FoldsBack(boundary.in_ring(vertex)),
            Meeting::Overlap(edges) => BoundaryFault::Overlap(edges.map(edge)),
        });
        let mut faults: Vec<BoundaryFault> = placed.collect();
        let outside = holes_outside(boundary, &faults);
        faults.extend(outside.into_iter().map(|hole| BoundaryFault::HoleOutside { hole }));
        faults.truncate(MOST_FAULTS);
        Self(faults)
    }
}

/// The holes that meet nothing and lie outside the outline. If the outline meets itself, nothing is known.
fn holes_outside(boundary: &PlanarBoundary, faults: &[BoundaryFault]) -> Vec<usize> {
    /// The most comparisons of a point with an edge.
    const MOST_COMPARISONS: usize = 100_000_000;
    let mut meets = vec![false; boundary.ring_count()];
    for fault in faults {
        let places = match *fault {
            BoundaryFault::SamePoint(places)
            | BoundaryFault::Crossing(places)
            | BoundaryFault::Overlap(places) => places,
            BoundaryFault::Touch { vertex, edge } => [vertex, edge],
            BoundaryFault::FoldsBack(at) => [BoundaryPlace::Ring(at); 2],
            _ => continue,
        };
        let rings = places.map(|place| match place {
            BoundaryPlace::Ring(at) => Some(at.ring),
            _ => None,
        });
        rings.into_iter().flatten().filter(|&ring| ring > 0).for_each(|ring| meets[ring] = true);
        if rings == [Some(0); 2] {
            return Vec::new();
        }
    }
    let points = |ring: usize| {
        let Range { start, end } = boundary.ring(ring);
        &boundary.points()[start as usize..end as usize]
    };
    let outline = points(0);
    let count = MOST_COMPARISONS / outline.len().max(1);
    let apart = (1..boundary.ring_count()).filter(|&ring| !meets[ring]).take(count);
    apart.filter(|&ring| points(ring).first().is_some_and(|&at| !surrounds(outline, at))).collect()
}

/// Whether a ring that does not cross itself surrounds a point that is not on it, exactly.
fn surrounds(ring: &[DVec2], point: DVec2) -> bool {
    let next = ring.iter().cycle().skip(1);
    let is_crossed = |(a, b): &(&DVec2, &DVec2)| {
        (a.y > point.y) != (b.y > point.y) && (orientation(**a, **b, point) > 0.0) == (b.y > a.y)
    };
    ring.iter().zip(next).filter(is_crossed).count() % 2 == 1
}

fn result(faults: Vec<BoundaryFault>) -> Result<(), BoundaryFaults> {
    if faults.is_empty() { Ok(()) } else { Err(BoundaryFaults(faults)) }
}

/// Checks each ring for itself.
pub(super) fn check_rings<R: AsRef<[DVec2]>>(rings: &[R]) -> Result<(), BoundaryFaults> {
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
        let place = |index| BoundaryPlace::Ring(InRing { ring, index });
        let bad = bad.map(|(index, _)| BoundaryFault::NotFinite(place(index)));
        faults.extend(bad.take(MOST_FAULTS - faults.len().min(MOST_FAULTS)));
    }
    result(faults)
}

/// Checks each line for itself, and that inner points are numbers.
pub(super) fn check_lines(
    boundary: &PlanarBoundary,
    lines: &[Vec<u32>],
) -> Result<(), BoundaryFaults> {
    let mut faults = Vec::new();
    let vertices = boundary.vertex_count()..boundary.points.len() as u32;
    let bad = vertices.filter(|&vertex| !boundary.point(vertex).is_finite());
    faults.extend(bad.map(|vertex| BoundaryFault::NotFinite(boundary.place_of_vertex(vertex))));
    for (line, vertices) in lines.iter().enumerate() {
        faults.extend((vertices.len() < 2).then_some(BoundaryFault::ShortLine { line }));
        let same = vertices.windows(2).enumerate().filter(|(_, pair)| pair[0] == pair[1]);
        faults.extend(same.map(|(index, _)| {
            BoundaryFault::SamePoint([0, 1].map(|i| BoundaryPlace::Line { line, index: index + i }))
        }));
    }
    faults.truncate(MOST_FAULTS);
    result(faults)
}

/// Checks that ring 0 contains all other rings, that no other ring contains one, and that lines and points are
/// inside ring 0 alone.
pub(super) fn check_nesting(
    boundary: &PlanarBoundary,
    swept: &Swept,
) -> Result<(), BoundaryFaults> {
    let nesting = &swept.nesting;
    if let Some(hole) = nesting.first().and_then(|outer| outer.parent) {
        return result(vec![BoundaryFault::HoleAround { hole }]);
    }
    let holes =
        nesting.iter().enumerate().skip(1).filter_map(|(hole, nested)| match nested.parent {
            Some(0) => None,
            None => Some(BoundaryFault::HoleOutside { hole }),
            Some(around) => Some(BoundaryFault::HoleInHole { hole, around }),
        });
    let is_outside = |around: &Option<usize>| *around != Some(0);
    let edges = (boundary.vertex_count()..).zip(&swept.around_segments);
    let edges = edges.filter(|(_, around)| is_outside(around));
    let edges = edges.map(|(edge, _)| BoundaryFault::Outside(boundary.place_of_edge(edge)));
    let points = swept.around_points.iter().filter(|(_, around)| is_outside(around));
    let points = points.map(|(point, _)| BoundaryFault::Outside(boundary.place_of_vertex(*point)));
    result(holes.chain(edges).chain(points).take(MOST_FAULTS).collect())
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
        let table: [(&[&[[f64; 2]]], &str); 12] = [
            (&[], "a boundary needs an outer ring"),
            (&[&SQUARE[..2], &[[nan, 0.0], [1.0, nan]]], "the outline has 2 points, and needs at least 3; hole 1 has 2 points, and needs at least 3; point 1 of hole 1 is not finite; point 2 of hole 1 is not finite"),
            // A zig-zag whose edge 7 crosses three others.
            (&[&[[0.0, 0.0], [8.0, 0.0], [8.0, 2.0], [2.0, 2.0], [2.0, 4.0], [8.0, 4.0], [8.0, 6.0], [4.0, -2.0]]], "edge 1 and edge 7 cross; edge 3 and edge 7 cross; edge 5 and edge 7 cross"),
            (&[&SQUARE, &[[7.0, 1.0], [9.0, 3.0], [7.0, 3.0]], &[[1.0, 9.0], [3.0, 7.0], [1.0, 7.0]]], "edge 3 and edge 3 of hole 2 cross; edge 2 and edge 1 of hole 1 cross; edge 2 and edge 2 of hole 1 cross; edge 3 and edge 1 of hole 2 cross"),
            // A hole that meets nothing is judged beside one that crosses itself, but not beside an outline that does.
            (&[&SQUARE, &[[1.0, 1.0], [3.0, 3.0], [3.0, 1.0], [1.0, 3.0]], &[[9.0, 1.0], [9.0, 2.0], [10.0, 1.0]], &[[5.0, 5.0], [5.0, 6.0], [6.0, 5.0]]], "edge 1 of hole 1 and edge 3 of hole 1 cross; hole 2 lies outside the outline"),
            (&[&[[0.0, 0.0], [8.0, 8.0], [8.0, 0.0], [0.0, 8.0]], &[[9.0, 1.0], [9.0, 2.0], [10.0, 1.0]]], "edge 1 and edge 3 cross"),
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
