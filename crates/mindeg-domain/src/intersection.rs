//! Rings that are not simple, not apart, or not holes of the outer ring: the place, and a remedy.

use glam::DVec2;
use mindeg_mesh::planar::BoundaryPlace::Ring;
use mindeg_mesh::planar::{BoundaryFault, BoundaryFaults, BoundaryPlace, InRing};

use crate::error::{DomainError, Place};
use crate::joined::Joined;
use crate::rings::Rings;

/// The error for the faults of the rings of points, by the sides that they are on: the first, with all others.
pub(crate) fn errors(
    faults: &BoundaryFaults,
    points: &[DVec2],
    rings: &Rings,
    joined: &Joined,
) -> DomainError {
    let error = |&fault: &BoundaryFault| error(fault, points, rings, joined);
    let more = faults.list().iter().skip(1).map(error).collect();
    DomainError { more, ..error(&faults.first()) }
}

fn error(fault: BoundaryFault, points: &[DVec2], rings: &Rings, joined: &Joined) -> DomainError {
    if let Some(error) = of_line(fault, points, rings, joined) {
        return error;
    }
    let names = Names(rings);
    let vertex = |at: InRing| rings.ring(at.ring).start + at.index as u32;
    let name = |at| names.point_name(vertex(at));
    let edge_name = |at| names.edge_name(vertex(at));
    let point = |at| points[vertex(at) as usize];
    let position = |at| format!("at {}", mindeg_mesh::place(point(at)));
    let start = |ring| InRing { ring, index: 0 };
    let first = |ring| format!("with its first corner {}", position(start(ring)));
    let (place, message, told) = match fault {
        BoundaryFault::SamePoint([Ring(first), Ring(second)]) => {
            let told = point(second);
            let (first, name, at) = (name(first), name(second), position(second));
            let message = format!(
                "{name} is {at}, where {first} is too; a boundary passes each point once: move one of \
                 them, or split the ring there"
            );
            (names.point_place(vertex(second)), message, Some(told))
        }
        BoundaryFault::Touch { vertex: Ring(at), edge: Ring(edge) } => {
            let message = format!(
                "{} {} lies on {}; a point may not lie on an edge: move it off, or split the ring there",
                name(at),
                position(at),
                edge_name(edge)
            );
            (names.point_place(vertex(at)), message, Some(point(at)))
        }
        BoundaryFault::FoldsBack(at) => {
            let message = format!(
                "the boundary folds back on itself at {} {} (0°); drop the point or move it",
                name(at),
                position(at)
            );
            (names.point_place(vertex(at)), message, Some(point(at)))
        }
        BoundaryFault::Crossing([Ring(first), Ring(second)]) => {
            let edges = [first, second];
            let ends = |at| [vertex(at), rings.next(vertex(at))].map(|v| points[v as usize]);
            let told = crossing(edges.map(ends));
            let near = mindeg_mesh::place(told);
            let [first, second] = edges.map(edge_name);
            let message = format!(
                "{first} and {second} cross near {near}; list the points in the order in \
                 which they lie around the domain, and keep rings apart"
            );
            let (side, index) = names.on_side(vertex(edges[1]));
            let place = match index {
                0 => Place::side(side),
                _ => names.point_place(vertex(edges[1])),
            };
            (place, message, Some(told))
        }
        BoundaryFault::HoleInHole { hole, around } => {
            let first = first(hole);
            let message =
                format!("hole {hole} lies inside hole {around}, {first}; drop one of them");
            (Place::ring(hole), message, Some(point(start(hole))))
        }
        BoundaryFault::HoleOutside { hole } => {
            let first = first(hole);
            let message = format!(
                "hole {hole} lies outside the outline, {first}; move it inside, or drop it"
            );
            (Place::ring(hole), message, Some(point(start(hole))))
        }
        BoundaryFault::HoleAround { hole } => {
            let message = format!(
                "the outline lies inside hole {hole}; give the outer ring first, and the holes inside \
                 it"
            );
            (Place::ring(hole), message, None)
        }
        // Rings are long enough, their points finite, and either way round is taken.
        fault => (Place::default(), format!("{fault}; move the point"), None),
    };
    place.touch(message).telling(told)
}

/// The error for a fault of a line or a point; `None` if it is of rings alone.
fn of_line(
    fault: BoundaryFault,
    points: &[DVec2],
    rings: &Rings,
    joined: &Joined,
) -> Option<DomainError> {
    let names = Names(rings);
    let vertex = |at: BoundaryPlace, step: usize| match at {
        Ring(at) if step == 0 => rings.ring(at.ring).start + at.index as u32,
        Ring(at) => rings.next(rings.ring(at.ring).start + at.index as u32),
        BoundaryPlace::Line { line, index } => joined.lines[line][index + step],
        BoundaryPlace::Point(index) => (points.len() + index) as u32,
    };
    let position = |vertex: u32| match (vertex as usize).checked_sub(points.len()) {
        None => points[vertex as usize],
        Some(inner) => joined.points[inner],
    };
    let name = |at: BoundaryPlace| match at {
        Ring(at) => names.edge_name(rings.ring(at.ring).start + at.index as u32),
        BoundaryPlace::Line { line, .. } => format!("line {}", line + 1),
        BoundaryPlace::Point(index) => format!("point {}", joined.given[index] + 1),
    };
    let point_name = |at: BoundaryPlace| match at {
        Ring(_) => names.point_name(vertex(at, 0)),
        _ => name(at),
    };
    let place = |at: &BoundaryPlace| match *at {
        Ring(_) => None,
        BoundaryPlace::Line { line, .. } => Some(Place::key("lines").then(line)),
        BoundaryPlace::Point(index) => Some(Place::key("points").then(joined.given[index])),
    };
    let (places, message, told) = match fault {
        BoundaryFault::Crossing(edges) => {
            let told = crossing(edges.map(|edge| [0, 1].map(|step| position(vertex(edge, step)))));
            let [first, second] = edges.map(name);
            let near = mindeg_mesh::place(told);
            let message = match edges.map(|edge| matches!(edge, Ring(_))) {
                [true, _] | [_, true] => format!(
                    "{first} and {second} cross near {near}, where the line leaves the domain; end it there, or keep it inside"
                ),
                _ => format!(
                    "{first} and {second} cross near {near}; end the line there, or move it"
                ),
            };
            (edges, message, told)
        }
        BoundaryFault::Overlap(edges) => {
            let [first, second] = edges.map(name);
            let told = position(vertex(edges[1], 0));
            let near = mindeg_mesh::place(told);
            let message =
                format!("{first} and {second} lie on each other near {near}; drop one of them");
            (edges, message, told)
        }
        BoundaryFault::Touch { vertex: touching, edge } => {
            let told = position(vertex(touching, 0));
            let message = format!(
                "{} touches {} at {}; end a line there, or give the point to both",
                point_name(touching),
                name(edge),
                mindeg_mesh::place(told)
            );
            ([edge, touching], message, told)
        }
        BoundaryFault::SamePoint(both) => {
            let [first, second] = both.map(point_name);
            let told = position(vertex(both[1], 0));
            let near = mindeg_mesh::place(told);
            let message = format!(
                "{first} and {second} have the same point {near}; end a line there, or move one of them"
            );
            (both, message, told)
        }
        BoundaryFault::Outside(place) => {
            let told = position(vertex(place, 0));
            let near = mindeg_mesh::place(told);
            let message =
                format!("{} leaves the domain near {near}; keep it inside, off holes", name(place));
            ([place; 2], message, told)
        }
        _ => return None,
    };
    let place = places.iter().rev().find_map(place)?;
    Some(place.touch(message).telling([told]))
}

/// Names the vertices and edges of a boundary by their sides.
#[derive(Clone, Copy)]
struct Names<'a>(&'a Rings);

impl Names<'_> {
    /// The side that starts at a vertex or contains it, and the vertex's index on it.
    fn on_side(self, vertex: u32) -> (InRing, u32) {
        let side = self.0.side_of(vertex);
        (self.0.in_ring(side), vertex - self.0.corner(side))
    }

    /// A vertex as a point of a ring with a single side.
    fn in_lone_side(self, vertex: u32) -> Option<InRing> {
        let (InRing { ring, .. }, index) = self.on_side(vertex);
        let is_alone = self.0.ring_sides(ring).len() == 1;
        is_alone.then_some(InRing { ring, index: index as usize })
    }

    fn point_place(self, vertex: u32) -> Place {
        match self.on_side(vertex) {
            (corner, 0) => Place::corner(corner),
            (side, index) => Place::side(side).then("points").then(index as usize - 1),
        }
    }

    /// "corner 3", "point 4 of side 2 of hole 1", or "point 12" of a ring with a single side.
    fn point_name(self, vertex: u32) -> String {
        match (self.in_lone_side(vertex), self.on_side(vertex)) {
            (Some(point), _) => point.named("point"),
            (None, (corner, 0)) => corner.corner(),
            (None, (side, index)) => format!("point {index} of {}", side.side()),
        }
    }

    /// "side 3", "interval 5 of side 3 of hole 1", or "edge 12" of a ring with a single side.
    fn edge_name(self, begin: u32) -> String {
        if let Some(edge) = self.in_lone_side(begin) {
            return edge.named("edge");
        }
        let (side, index) = self.on_side(begin);
        match self.0.intervals(self.0.side_of(begin)) {
            1 => side.side(),
            _ => format!("interval {} of {}", index + 1, side.side()),
        }
    }
}

/// The crossing point of two edges, for a message.
fn crossing([[a, b], [c, d]]: [[DVec2; 2]; 2]) -> DVec2 {
    let (first, second) = (b - a, d - c);
    let share = (c - a).perp_dot(second) / first.perp_dot(second);
    let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.5 };
    a + share * first
}

#[cfg(test)]
mod tests {
    use crate::{Domain, DomainError, Ring, Side};

    fn ring(corners: &[[f64; 2]], intervals: u64) -> Ring {
        Ring::new(corners.iter().copied(), vec![Side::count(intervals); corners.len()])
    }

    const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]];

    fn holes(holes: &[Ring]) -> Result<Domain, DomainError> {
        Domain::of_rings([&[ring(&SQUARE, 2)], holes].concat())
    }

    #[test]
    fn names_the_place() {
        let of = |corners: &[[f64; 2]], intervals| Domain::of_rings(vec![ring(corners, intervals)]);
        let triangle = |x: f64, y: f64| ring(&[[x, y], [x + 1.0, y], [x, y + 1.0]], 1);
        #[rustfmt::skip]
        let table = [
            (of(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]], 1), "side 1 and side 3 cross near (0.5, 0.5); list the points in the order in which they lie around the domain, and keep rings apart"),
            (of(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]], 3), "interval 2 of side 1 and interval 2 of side 3 cross near (0.5, 0.5); list the points in the order in which they lie around the domain, and keep rings apart"),
            (of(&[[0.0, 0.0], [2.0, 0.0], [1.0, 0.0]], 1), "the boundary folds back on itself at corner 1 at (0, 0) (0°); drop the point or move it"),
            (of(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 2.0]], 1), "corner 4 at (2, 0) lies on side 1; a point may not lie on an edge: move it off, or split the ring there"),
            (of(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 2.0]], 2), "corner 4 is at (2, 0), where point 1 of side 1 is too; a boundary passes each point once: move one of them, or split the ring there"),
            (holes(&[triangle(2.0, 2.0), triangle(9.0, 2.0)]), "hole 2 lies outside the outline, with its first corner at (9, 2); move it inside, or drop it"),
            (holes(&[ring(&[[1.0, 1.0], [7.0, 1.0], [1.0, 7.0]], 1), triangle(2.0, 2.0)]), "hole 2 lies inside hole 1, with its first corner at (2, 2); drop one of them"),
            (holes(&[triangle(2.0, 2.0), ring(&SQUARE.map(|[x, y]| [2.0 * x - 4.0, 2.0 * y - 4.0]), 1)]), "the outline lies inside hole 2; give the outer ring first, and the holes inside it"),
            (holes(&[triangle(2.0, 2.0), triangle(1.0, 2.0)]), "corner 2 of hole 2 is at (2, 2), where corner 1 of hole 1 is too; a boundary passes each point once: move one of them, or split the ring there"),
            (holes(&[triangle(2.0, 0.0)]), "corner 1 of hole 1 at (2, 0) lies on interval 1 of side 1; a point may not lie on an edge: move it off, or split the ring there"),
            (holes(&[triangle(7.5, 2.0)]), "interval 1 of side 2 and side 1 of hole 1 cross near (8, 2); list the points in the order in which they lie around the domain, and keep rings apart"),
        ];
        for (outcome, message) in table {
            assert_eq!(outcome.unwrap_err().message, message);
        }
    }
}
