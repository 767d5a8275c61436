//! Lines that cross each other get a corner there.
//!
//! Limits: curved sides of lines meet others as they are divided, and must be given by their points to cross.

use std::collections::{HashMap, HashSet};

use glam::DVec2;
use mindeg_mesh::place;
use mindeg_mesh::planar::orientation;

use crate::curve::Curve;
use crate::error::DomainError;
use crate::inside::Inside;
use crate::joined::Chain;
use crate::outline::Ring;
use crate::side::{Intervals, Side};
use crate::spacing::Spacing;
use crate::split::{Cut, apply, cut_of};

/// Crossings that rounding makes are looked for so often.
const ROUNDS: usize = 8;

/// Gives all lines corners where they cross others or themselves. Says so in a sentence each. O(n log n) where few edges lie above
/// each other.
pub(crate) fn node(inside: &mut Inside, reach: f64) -> Result<Vec<String>, DomainError> {
    let mut notes = Vec::new();
    for _ in 0..ROUNDS {
        let found = crossings(inside)?;
        if found.is_empty() {
            break;
        }
        for ([one, other], at) in found {
            let mut is_new = false;
            for line in [one, other] {
                is_new |= give_corners(&mut inside.lines[line], at, reach, line)?;
            }
            if is_new {
                let crossed = match one == other {
                    true => "itself".to_owned(),
                    false => format!("line {}", other + 1),
                };
                notes.push(format!(
                    "Line {} crosses {crossed} at {} and has a corner there; a number of intervals was shared out by length.",
                    one + 1,
                    place(at)
                ));
            }
        }
    }
    Ok(notes)
}

/// An edge of a line.
#[derive(Clone, Copy)]
struct LineEdge {
    line: usize,
    ends: [DVec2; 2],
    /// Whether each end is an end of the line, which may lie on another line.
    is_last: [bool; 2],
}

impl LineEdge {
    fn low(&self) -> DVec2 {
        self.ends[0].min(self.ends[1])
    }

    fn high(&self) -> DVec2 {
        self.ends[0].max(self.ends[1])
    }
}

/// The places where two edges cross, or one passes a vertex of another, each with its lines.
fn crossings(inside: &Inside) -> Result<Vec<([usize; 2], DVec2)>, DomainError> {
    let mut edges: Vec<LineEdge> = Vec::new();
    for (line, given) in inside.lines.iter().enumerate() {
        let points = Chain::new(line, given)?.points;
        let (is_open, last) = (given.is_open(), points.len().saturating_sub(2));
        edges.extend(points.windows(2).enumerate().map(|(index, pair)| LineEdge {
            line,
            ends: [pair[0], pair[1]],
            is_last: [is_open && index == 0, is_open && index == last],
        }));
        if let (false, [first, .., last]) = (is_open, &points[..]) {
            edges.push(LineEdge { line, ends: [*last, *first], is_last: [false; 2] });
        }
    }
    edges.sort_by(|a, b| a.low().x.total_cmp(&b.low().x));
    let mut found = Vec::new();
    for (index, own) in edges.iter().enumerate() {
        let right = own.high().x;
        for other in edges[index + 1..].iter().take_while(|edge| edge.low().x <= right) {
            if other.low().y <= own.high().y && other.high().y >= own.low().y {
                let lines = [own.line.min(other.line), own.line.max(other.line)];
                found.extend(crossing(own, other).map(|at| (lines, at)));
            }
        }
    }
    found.extend(shared(inside)?);
    found.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.x.total_cmp(&b.1.x)).then(a.1.y.total_cmp(&b.1.y)));
    found.dedup();
    Ok(found)
}

/// Points that lines have in common, or one line several times, which are a corner nowhere.
fn shared(inside: &Inside) -> Result<Vec<([usize; 2], DVec2)>, DomainError> {
    let key = |at: DVec2| at.to_array().map(|it| (it + 0.0).to_bits());
    let corners = inside.lines.iter().flat_map(|line| &line.corners);
    let corners: HashSet<_> = corners.map(|&at| key(at)).collect();
    let mut first = HashMap::new();
    let mut found = Vec::new();
    for (line, given) in inside.lines.iter().enumerate() {
        for at in Chain::new(line, given)?.points {
            let before = first.insert(key(at), line).filter(|_| !corners.contains(&key(at)));
            found.extend(before.map(|other| ([other, line], at)));
        }
    }
    Ok(found)
}

/// Where two edges cross, or one passes an end of the other that is no end of its line.
fn crossing(one: &LineEdge, other: &LineEdge) -> Option<DVec2> {
    let beside = |edge: &LineEdge, of: &LineEdge| {
        of.ends.map(|end| orientation(edge.ends[0], edge.ends[1], end))
    };
    let (of_one, of_other) = (beside(other, one), beside(one, other));
    let is_between = |[a, b]: [f64; 2]| a > 0.0 && b < 0.0 || a < 0.0 && b > 0.0;
    if is_between(of_one) && is_between(of_other) {
        let share = of_one[0] / (of_one[0] - of_one[1]);
        let at = one.ends[0] + (one.ends[1] - one.ends[0]) * share;
        return (!one.ends.contains(&at) && !other.ends.contains(&at)).then_some(at);
    }
    let passed = |edge: &LineEdge, sides: [f64; 2], of: &LineEdge| {
        let is_passed = |end: usize| {
            let at = of.ends[end];
            let is_within = at.cmpge(edge.low()).all() && at.cmple(edge.high()).all();
            sides[end] == 0.0 && !of.is_last[end] && is_within && !edge.ends.contains(&at)
        };
        (0..2).find(|end| is_passed(*end)).map(|end| of.ends[end])
    };
    passed(other, of_one, one).or_else(|| passed(one, of_other, other))
}

/// Gives a line a corner wherever it passes a place; whether one is new.
fn give_corners(line: &mut Ring, at: DVec2, reach: f64, index: usize) -> Result<bool, DomainError> {
    let mut is_new = false;
    loop {
        let before = line.corners.len();
        if let Some((side, cut)) = cut_of(0, line, at, reach) {
            match (cut, &line.sides[side.index].curve) {
                (Cut::Point(piece), Curve::Polyline(_)) => {
                    split(line, side.index, at, [piece; 2]);
                }
                (cut, _) => apply(line, side.index, cut, at, &format!("line {}", index + 1))?,
            }
        } else if let Some((side, point)) = point_at(line, at) {
            split(line, side, at, [point, point + 1]);
        }
        // None is left, or a curve keeps its shape.
        if line.corners.len() == before {
            break;
        }
        is_new = true;
    }
    // A side from a corner back to it gets one between.
    let is_loop = |line: &Ring, side: usize| line.corners.get(side) == line.corners.get(side + 1);
    while let Some(side) = (0..line.sides.len()).find(|&side| is_loop(line, side)) {
        let Curve::Polyline(points) = &line.sides[side].curve else { break };
        let Some(&first) = points.first() else { break };
        split(line, side, first, [0, 1]);
    }
    Ok(is_new)
}

/// The side of a line that has a place among its points between corners, and the index of the point.
fn point_at(line: &Ring, at: DVec2) -> Option<(usize, usize)> {
    let of_side = |(index, side): (usize, &Side)| match &side.curve {
        Curve::Polyline(points) => Some((index, points.iter().position(|&point| point == at)?)),
        _ => None,
    };
    line.sides.iter().enumerate().find_map(of_side)
}

/// Makes two sides of one with points: the first ends before one of its points, the second begins at another.
fn split(line: &mut Ring, index: usize, corner: DVec2, [end, start]: [usize; 2]) {
    let own = line.sides[index].clone();
    let Curve::Polyline(points) = &own.curve else { return };
    let part = |points: &[DVec2]| Side {
        curve: Curve::Polyline(points.to_vec()),
        intervals: Intervals::Points,
        spacing: Spacing::Uniform,
        ..own.clone()
    };
    let parts = [part(&points[..end]), part(&points[start..])];
    line.sides.splice(index..=index, parts);
    line.corners.insert(index + 1, corner);
}

#[cfg(test)]
mod tests {
    use crate::domain::Domain;

    const CROSSING: &str = r#"{"rectangle": {"width": 4, "height": 2}, "size": 0.5, "lines": [
        {"corners": [[1, 1], [3, 1]], "intervals": 4, "name": "a"},
        {"points": [[2, 0.5], [2.25, 0.875], [2.25, 1.5]], "name": "b"},
        {"corners": [[1.5, 0.5], [1.5, 1.5]], "size": 0.3},
        {"corners": [[3.5, 0.5], [3.5, 1.5]], "intervals": 2}, {"corners": [[3.2, 1], [3.8, 1]], "intervals": 1}]}"#;

    /// Lines in a square of side 4, which `--repair` gives corners.
    fn noded(lines: &str) -> Domain {
        let given = format!(
            r#"{{"rectangle": {{"width": 4, "height": 4}}, "size": 1, "lines": [{lines}]}}"#
        );
        assert!(Domain::from_json(&given).is_err(), "{lines}");
        let noded = Domain::from_json_noded(&given).unwrap();
        assert_eq!(Domain::from_json(&noded.to_json()).unwrap().inside(), noded.inside());
        noded
    }

    #[test]
    fn a_curve_that_a_line_crosses_gets_no_corner() {
        let arc = r#"{"rectangle": {"width": 4, "height": 4}, "size": 1, "lines": [
            {"corners": [[1, 2], [3, 2]], "sides": [{"arc": {"center": [2, 2]}, "intervals": 7}]},
            {"points": [[2, 0.5], [2, 3.5]]}]}"#;
        let error = Domain::from_json_noded(arc).unwrap_err();
        assert!(error.to_string().contains("line 1"), "{error}");
    }

    #[test]
    fn lines_that_share_a_point_or_cross_themselves_get_corners() {
        for (lines, corners) in [
            (
                r#"{"points": [[1, 1], [2, 2], [3, 3]]}, {"points": [[1, 3], [2, 2], [3, 1]]}"#,
                [3, 3],
            ),
            (
                r#"{"points": [[1, 1], [3, 3], [3, 1], [1, 3]]}, {"points": [[1, 3.5], [3, 3.5]]}"#,
                [5, 2],
            ),
            (
                r#"{"points": [[1, 1], [2, 2], [3, 3], [3, 1], [2, 2], [1, 3]]}, {"points": [[1, 3.5], [3, 3.5]]}"#,
                [5, 2],
            ),
        ] {
            let domain = noded(lines);
            let found = domain.inside().lines.iter().map(|line| line.corners.len());
            assert!(found.eq(corners), "{lines}");
            assert!(domain.notes().iter().all(|note| note.contains("(2, 2)")), "{lines}");
        }
    }

    #[test]
    fn lines_that_cross_get_a_vertex_there_if_asked() {
        let error = Domain::from_json(CROSSING).unwrap_err().to_string();
        assert!(error.contains("line 1") && error.contains("(1.5, 1)"), "{error}");
        let domain = Domain::from_json_noded(CROSSING).unwrap();
        let notes = domain.notes();
        assert_eq!(notes.len(), 3, "{notes:?}");
        assert!(notes[0].starts_with("Line 1 crosses line 2 at (2.25, 1)"), "{notes:?}");
        // The last two have a vertex and an edge there.
        for at in [[2.25, 1.0], [1.5, 1.0], [3.5, 1.0]] {
            let count = domain.inner_points().iter().filter(|point| point.to_array() == at).count();
            assert_eq!(count, 1, "{at:?}");
        }
        // Four edges meet at each.
        let first = domain.rings().vertex_count();
        let at = domain.inner_points().iter().position(|point| point.to_array() == [2.25, 1.0]);
        let vertex = first + at.unwrap() as u32;
        let meets = domain.inner_segments().iter().filter(|ends| ends.contains(&vertex)).count();
        assert_eq!(meets, 4);
        // The name of a line stays that of both parts.
        assert_eq!(domain.inner_lines().iter().filter(|(line, _)| line.name == "b").count(), 1);
        // A domain without crossings is as it was.
        let plain = r#"{"rectangle": {"width": 4, "height": 2}, "size": 0.5, "lines": [{"corners": [[2, 0], [2, 2]]}]}"#;
        assert_eq!(Domain::from_json_noded(plain).unwrap(), Domain::from_json(plain).unwrap());
    }
}
