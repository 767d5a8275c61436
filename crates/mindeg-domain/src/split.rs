//! Sides that get a corner where a line ends within them.

use glam::DVec2;
use mindeg_mesh::planar::InRing;

use crate::constraints::{Constraints, ExternalDegree};
use crate::curve::Curve;
use crate::error::{DomainError, Place};
use crate::given::{Given, sides_of};
use crate::inside::Inside;
use crate::joined::{Chain, Lookup, place, reach};
use crate::outline::Ring;
use crate::periodic::{check_names, moved_back};
use crate::side::{Intervals, Side};
use crate::spacing::Spacing;

/// Where a side is split.
#[derive(Clone, Copy)]
pub(crate) enum Cut {
    /// At this share of a straight side.
    Share(f64),
    /// Before the side's own point with this index.
    Point(usize),
}

/// Gives straight sides of rings and lines a corner where a line ends within them, or a point if they have points of
/// their own. Says so in a sentence each.
pub(crate) fn split_sides(
    ring_points: &[DVec2],
    rings: &mut [Ring],
    inside: &mut Inside,
    constraints: &mut Constraints,
) -> Result<Vec<String>, DomainError> {
    let reach = reach(ring_points);
    let mut notes = Vec::new();
    let mut ends = loose_ends(ring_points, inside, reach)?;
    retain_within(&mut ends, rings.iter().chain(&inside.lines), reach);
    for (line, at) in ends {
        let which = format!("line {}", line + 1);
        let mut first = 0;
        let mut split = None;
        for index in 0..rings.len() {
            let Some((side, _)) = cut_of(index, &rings[index], at, reach) else {
                first += rings[index].sides.len();
                continue;
            };
            // Within a matched side: the side that it matches gets the point.
            let there = moved_back(side, rings, at)?;
            let Some((of, cut)) = cut_of(index, &rings[index], there, reach) else { break };
            if let Cut::Share(_) = cut {
                check_names(of, rings, &which)?;
                if !constraints.sides.is_empty() {
                    split_constraint(constraints, first + of.index, &which)
                        .map_err(|error| error.of_side(of))?;
                }
            }
            apply(&mut rings[index], of.index, cut, there, &which)
                .map_err(|error| error.of_side(of))?;
            let which = match of.index == side.index {
                true => side.side(),
                false => format!("{}, which is {} moved", side.side(), of.side()),
            };
            split = Some((which, there));
            break;
        }
        for (index, other) in inside.lines.iter_mut().enumerate() {
            if split.is_none()
                && let Some((side, cut)) = cut_of(0, other, at, reach)
            {
                let name = format!("line {}", index + 1);
                apply(other, side.index, cut, at, &which)
                    .map_err(|error| error.within(place(index), &name))?;
                split = Some((name, at));
            }
        }
        notes.extend(split.map(|(side, at)| {
            format!(
                "Line {} ends within {side}, which was split there, at {}; a number of intervals \
                 was shared out by length.",
                line + 1,
                mindeg_mesh::place(at)
            )
        }));
    }
    Ok(notes)
}

/// The ends of open lines that are near no vertex, each with its line.
fn loose_ends(
    ring_points: &[DVec2],
    inside: &Inside,
    reach: f64,
) -> Result<Vec<(usize, DVec2)>, DomainError> {
    let mut points = ring_points.to_vec();
    points.extend(inside.points.iter().map(|point| point.at));
    let mut ends = Vec::new();
    for (line, given) in inside.lines.iter().enumerate() {
        let chain = Chain::new(line, given)?.points;
        match &chain[..] {
            [first, between @ .., last] if given.is_open() => {
                points.extend_from_slice(between);
                ends.extend([(line, *first), (line, *last)]);
            }
            _ => points.extend(chain),
        }
    }
    let lookup = Lookup::new(points.into_iter(), reach);
    ends.retain(|(_, at)| lookup.near(*at, |_| true).is_none());
    Ok(ends)
}

/// Keeps the ends that lie within straight pieces of sides: each piece looks at the ends beside it, in the order of x.
fn retain_within<'a>(
    ends: &mut Vec<(usize, DVec2)>,
    rings: impl Iterator<Item = &'a Ring>,
    reach: f64,
) {
    let mut order: Vec<usize> = (0..ends.len()).collect();
    order.sort_by(|&a, &b| ends[a].1.x.total_cmp(&ends[b].1.x));
    let mut is_within = vec![false; ends.len()];
    for [start, end] in rings.flat_map(|ring| sides_of(0, ring)).flat_map(pieces) {
        let (low, high) = (start.min(end) - reach, start.max(end) + reach);
        let from = order.partition_point(|&index| ends[index].1.x < low.x);
        let beside = order[from..].iter().take_while(|&&index| ends[index].1.x <= high.x);
        for &index in beside {
            let at = ends[index].1;
            is_within[index] |=
                at.y >= low.y && at.y <= high.y && share([start, end], at, reach).is_some();
        }
    }
    let mut is_within = is_within.into_iter();
    ends.retain(|_| is_within.next() == Some(true));
}

/// The straight pieces of a side; none of a curve.
fn pieces(Given { start, end, side, .. }: Given<'_>) -> impl Iterator<Item = [DVec2; 2]> {
    let own = match &side.curve {
        Curve::Line => Some(&[][..]),
        Curve::Polyline(own) if side.intervals == Intervals::Points => Some(&own[..]),
        _ => None,
    };
    own.into_iter().flat_map(move |own| {
        let from = [start].into_iter().chain(own.iter().copied());
        from.zip(own.iter().copied().chain([end])).map(|(from, to)| [from, to])
    })
}

/// The share of the length of a piece at which a point lies, if it is within.
fn share([start, end]: [DVec2; 2], at: DVec2, reach: f64) -> Option<f64> {
    let (span, from) = (end - start, at - start);
    let length = span.length();
    let along = from.dot(span) / length;
    let is_within =
        (span.perp_dot(from) / length).abs() <= reach && along > reach && length - along > reach;
    is_within.then_some(along / length)
}

/// The side of a ring or line that a point lies within, and where.
pub(crate) fn cut_of(ring: usize, given: &Ring, at: DVec2, reach: f64) -> Option<(InRing, Cut)> {
    sides_of(ring, given).find_map(|given| {
        let (index, is_straight) = (given.at, given.side.curve == Curve::Line);
        let mut shares = pieces(given).map(|piece| share(piece, at, reach)).enumerate();
        let (piece, share) = shares.find_map(|(piece, share)| Some((piece, share?)))?;
        Some((index, if is_straight { Cut::Share(share) } else { Cut::Point(piece) }))
    })
}

pub(crate) fn apply(
    ring: &mut Ring,
    index: usize,
    cut: Cut,
    at: DVec2,
    line: &str,
) -> Result<(), DomainError> {
    let side = &mut ring.sides[index];
    let share = match (cut, &mut side.curve) {
        (Cut::Point(piece), Curve::Polyline(points)) => {
            points.insert(piece, at);
            return Ok(());
        }
        (Cut::Share(share), _) => share,
        (Cut::Point(_), _) => return Ok(()),
    };
    if side.spacing != Spacing::Uniform {
        return Err(Place::key("spacing").error(format!(
            "{line} ends within the side, and a spacing law is for a whole side; give the side a corner there"
        )));
    }
    let parts = match side.intervals {
        Intervals::Count(count) if count > 1 => {
            let first = (count as f64 * share).round().clamp(1.0, (count - 1) as f64) as u64;
            [Intervals::Count(first), Intervals::Count(count - first)]
        }
        same => [same; 2],
    };
    let parts = parts.map(|intervals| Side { intervals, ..side.clone() });
    ring.sides.splice(index..=index, parts);
    ring.corners.insert(index + 1, at);
    Ok(())
}

/// Both parts of a side have its constraint.
fn split_constraint(
    constraints: &mut Constraints,
    side: usize,
    line: &str,
) -> Result<(), DomainError> {
    let Some(constraint) = constraints.sides.get(side).cloned() else { return Ok(()) };
    if matches!(constraint.external_degree, ExternalDegree::Each(_)) {
        return Err(Place::key("outside_degree").error(format!(
            "{line} ends within the side, which lists a degree for each vertex; give the side a corner there"
        )));
    }
    constraints.sides.insert(side + 1, constraint);
    Ok(())
}
