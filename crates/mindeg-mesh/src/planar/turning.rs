//! Whether a boundary is straight at a point.

use std::f64::consts::PI;
use std::ops::Range;

use glam::DVec2;

/// A boundary that turns by less, in radians, is straight: 0.2 mm in 200 km.
pub const LEAST_TURN: f64 = 1e-9;

/// The largest turn, in radians, that rounding may explain.
const MOST_ROUNDED: f64 = 1e-3;

/// The turn of the boundary at a vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Turn {
    /// By nothing that counts.
    Straight,
    /// By this angle in radians, above 0 to the left, strictly between -π and π.
    By(f64),
    /// All the way back.
    Back,
}

/// The turn from one straight piece of a boundary to the next, each given by its start and end.
///
/// The turn is straight if it is less than [`LEAST_TURN`], or less than the rounding of the
/// coordinates can produce.
pub fn turn(incoming: [DVec2; 2], outgoing: [DVec2; 2]) -> Turn {
    let [before, after] = [incoming, outgoing].map(|[start, end]| end - start);
    let angle = libm::atan2(before.perp_dot(after), before.dot(after));
    // Each end of a piece may be off by half a unit in the last place in either coordinate.
    let coordinate = [incoming[0], outgoing[0], outgoing[1]]
        .map(|point| point.abs().max_element())
        .into_iter()
        .fold(0.0, f64::max);
    let rounding = f64::EPSILON * coordinate * (1.0 / before.length() + 1.0 / after.length());
    // Beside a tiny edge, rounding could explain any turn; a corner must not count as straight.
    if angle.abs() < LEAST_TURN.max(rounding.min(MOST_ROUNDED)) {
        Turn::Straight
    } else if angle.abs() > PI - LEAST_TURN {
        Turn::Back
    } else {
        Turn::By(angle)
    }
}

/// For each vertex, the straight run of the edge that begins there; consecutive straight pieces
/// without a turn are one run.
///
/// `pieces` gives the first vertices of the straight pieces of a ring, from the start of the ring, and the
/// turn at each.
pub fn straight_runs(
    rings: impl Iterator<Item = Range<u32>>,
    pieces: impl Fn(usize) -> Vec<(u32, Turn)>,
) -> Vec<u32> {
    let mut runs: Vec<u32> = Vec::new();
    let mut run = 0;
    for (ring, vertices) in rings.enumerate() {
        let pieces = pieces(ring);
        let first_run = run;
        let ends = pieces.iter().skip(1).map(|&(first, _)| first).chain([vertices.end]);
        for (&(first, turn), end) in pieces.iter().zip(ends) {
            run += u32::from(turn != Turn::Straight && first != vertices.start);
            runs.resize(end as usize, run);
        }
        if pieces.first().is_some_and(|&(_, turn)| turn == Turn::Straight) {
            // The rest of the last run is the start of the first one.
            let own = &mut runs[vertices.start as usize..];
            own.iter_mut().filter(|of| **of == run).for_each(|of| *of = first_run);
        }
        run += 1;
    }
    runs
}

/// Whether the segment between two points passes a third point: whether a boundary from one end by that
/// point to the other would be [straight](Turn::Straight).
///
/// So chords and sides use the same tolerance: a chord passes a vertex as three vertices of one side
/// lie on a line, and a rotated domain has the same chords as the original.
///
/// ```
/// use glam::DVec2;
/// use mindeg_mesh::planar::passes;
///
/// let chord = [DVec2::ZERO, DVec2::new(3.0, 1.0)];
/// assert!(passes(chord, DVec2::new(0.3, 0.1))); // which rounding has moved off the line
/// assert!(!passes(chord, DVec2::new(0.3, 0.1001)));
/// assert!(!passes(chord, DVec2::new(6.0, 2.0)));
/// ```
pub fn passes([from, to]: [DVec2; 2], point: DVec2) -> bool {
    let (before, after) = (point - from, to - point);
    // Far more than any turn that counts as straight; most points end here.
    before.perp_dot(after).abs() <= 2.0 * MOST_ROUNDED * before.dot(after)
        && turn([from, point], [point, to]) == Turn::Straight
}
