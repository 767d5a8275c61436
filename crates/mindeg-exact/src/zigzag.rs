//! Degree 4: a polygon of seven or more vertices has it if and only if one of its n zig-zags is
//! admissible.
//!
//! The degrees of n vertices add up to 4n - 6, so the vertices lack 6 edges to 4 each. An ear's tip
//! lacks 2. Four ears lack too much. With three ears every other vertex has two chords, so that
//! behind each ear the vertex next to its tip would have one chord too few unless n is 6. With two
//! ears the triangles form a strip, each ear has one neighbour that lacks 1, and all others have
//! two chords: then the strip can only alternate, as drawn here from the tip r.
//!
//! ```text
//!         r-1  r-2  r-3
//!        / | \ | \ | \
//!       r  |  \|  \|  ...
//!        \ |   |   | /
//!         r+1  r+2  r+3
//! ```

use crate::linked::{Corners, Linked};
use crate::problem::Problem;
use crate::visibility::sees;

/// A triangulation of maximum degree 4, as a strip of alternating chords between two ears.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ZigZag {
    /// The number of vertices, 5 or more.
    pub vertices: u32,
    /// The tip of an ear, where it begins.
    pub tip: u32,
    /// Whether its second chord has moved on towards larger indices, from (tip-1, tip+1) to
    /// (tip-1, tip+2), and not to (tip-2, tip+1).
    pub is_upward: bool,
}

/// The result of the test of all zig-zags.
pub(crate) enum Found {
    /// One zig-zag is admissible.
    ZigZag(ZigZag),
    /// No zig-zag is admissible: for each, a chord that is not admissible.
    Blocked(Vec<[u32; 2]>),
    /// The test took too many steps.
    Unknown,
}

impl ZigZag {
    /// The n zig-zags of a polygon of n vertices.
    pub fn all(vertices: u32) -> impl Iterator<Item = Self> {
        // Each begins at either of its ends. With an even number of vertices the ends are opposite,
        // and it goes the same way from both; else it goes the other way from the other end.
        let is_even = vertices.is_multiple_of(2);
        let last = if is_even { vertices / 2 } else { vertices };
        let ways = [true, false].into_iter().take(if is_even { 2 } else { 1 });
        ways.flat_map(move |is_upward| (0..last).map(move |tip| Self { vertices, tip, is_upward }))
    }

    /// Its n-3 chords from the tip on.
    pub fn chords(self) -> impl Iterator<Item = [u32; 2]> {
        let n = u64::from(self.vertices);
        (0..n.saturating_sub(3)).map(move |step| {
            let (less, more) = (step / 2, step.div_ceil(2));
            let (down, up) = if self.is_upward { (less, more) } else { (more, less) };
            let low = (u64::from(self.tip) + 2 * n - 1 - down) % n;
            let high = (u64::from(self.tip) + 1 + up) % n;
            [low as u32, high as u32]
        })
    }

    /// Its n-2 triangles, counter-clockwise, from the tip on.
    pub fn triangles(self) -> impl Iterator<Item = [u32; 3]> {
        let n = self.vertices;
        let first = [(self.tip + n - 1) % n, self.tip, (self.tip + 1) % n];
        let beyond = self.chords().enumerate().map(move |(step, [low, high])| {
            let moves_up = (step % 2 == 0) == self.is_upward;
            if moves_up { [low, high, (high + 1) % n] } else { [(low + n - 1) % n, low, high] }
        });
        std::iter::once(first).chain(beyond)
    }
}

/// Looks for an admissible zig-zag of a polygon, in at most `most_steps` steps.
pub(crate) fn find(problem: &Problem, mesh: &Linked, mut most_steps: u64) -> Found {
    let vertices = problem.points().len();
    let corners = Corners::new(vertices, &mesh.triangles);
    let mut blocked = Vec::with_capacity(vertices);
    for zigzag in ZigZag::all(vertices as u32) {
        let mut first_blocked = None;
        for [low, high] in zigzag.chords() {
            let mut steps = 1;
            let sides = problem.sides();
            let is_clear = sides.clear.is_some();
            let is_admissible = !sides.has_both(low, high)
                && sees(mesh, problem.points(), &corners, [low, high], is_clear, &mut steps);
            if !is_admissible {
                first_blocked = Some([low.min(high), low.max(high)]);
                break;
            }
            match most_steps.checked_sub(steps) {
                Some(left) => most_steps = left,
                None => return Found::Unknown,
            }
        }
        match first_blocked {
            Some(chord) => blocked.push(chord),
            None => return Found::ZigZag(zigzag),
        }
    }
    Found::Blocked(blocked)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn the_zigzags_are_n_triangulations_of_degree_4() {
        for n in 5..20 {
            let mut distinct = BTreeSet::new();
            for zigzag in ZigZag::all(n) {
                let mut chords: Vec<_> =
                    zigzag.chords().map(|[a, b]| [a.min(b), a.max(b)]).collect();
                let mut edges: Vec<_> = zigzag
                    .triangles()
                    .flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]])
                    .filter(|[a, b]| (a + 1) % n != *b)
                    .map(|[a, b]| [a.min(b), a.max(b)])
                    .collect();
                chords.sort_unstable();
                edges.sort_unstable();
                // Every chord has two triangles, and nothing else has any.
                assert!(edges.chunks(2).all(|pair| pair[0] == pair[1]), "{zigzag:?}");
                edges.dedup();
                assert_eq!(chords, edges, "{zigzag:?}");
                assert_eq!(zigzag.triangles().count(), n as usize - 2);
                let mut degrees = vec![2; n as usize];
                chords.as_flattened().iter().for_each(|&v| degrees[v as usize] += 1);
                assert_eq!(degrees.iter().max(), Some(&4), "{zigzag:?}");
                distinct.insert(chords);
            }
            assert_eq!(distinct.len(), n as usize, "{n}");
        }
    }
}
