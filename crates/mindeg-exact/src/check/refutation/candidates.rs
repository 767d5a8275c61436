//! The chords and triangles that the triangulations of a face may have.

use super::super::CheckedOutline;
use crate::measure::min_angle_tangent;
use glam::DVec2;

/// A face as the checker takes it.
#[derive(Clone, Copy, Debug)]
pub struct CheckedFace<'a> {
    /// The outline, with the outer ring first.
    pub outline: CheckedOutline<'a>,
    /// For each vertex of the face that of the whole.
    pub vertices: &'a [u32],
    /// No triangle has a smaller [`min_angle_tangent`].
    pub least_tangent: f64,
}

/// Chords, triangles and directed sides, each ascending.
pub(super) struct Candidates {
    /// The smaller end first.
    pub(super) chords: Vec<[u32; 2]>,
    /// Counter-clockwise from the smallest vertex.
    pub(super) triangles: Vec<[u32; 3]>,
    /// The boundary edges, and each chord in both directions.
    pub(super) sides: Vec<[u32; 2]>,
}

impl Candidates {
    pub(super) fn of(face: &CheckedFace<'_>) -> Self {
        let outline = &face.outline;
        let n = outline.points.len() as u32;
        let mut chords = Vec::new();
        for low in 0..n {
            outline.add_chords(low, &mut chords);
        }
        let mut sides: Vec<[u32; 2]> = (0..n).map(|from| [from, outline.next(from)]).collect();
        // For each vertex the larger ones that it is joined to.
        let mut joined = vec![Vec::new(); n as usize];
        let edges = sides.iter().map(|&[from, to]| [from.min(to), from.max(to)]);
        for [low, high] in edges.chain(chords.iter().copied()) {
            joined[low as usize].push(high);
        }
        joined.iter_mut().for_each(|larger| larger.sort_unstable());
        sides.extend(chords.iter().flat_map(|&[low, high]| [[low, high], [high, low]]));
        sides.sort_unstable();
        let mut triangles = Vec::new();
        for a in 0..n {
            for (at, &b) in joined[a as usize].iter().enumerate() {
                let mut others = joined[b as usize].iter().copied().peekable();
                for &c in &joined[a as usize][at + 1..] {
                    while others.next_if(|&other| other < c).is_some() {}
                    if others.peek() != Some(&c) {
                        continue;
                    }
                    let turn = outline.turn(a, b, c);
                    let corners = if turn > 0.0 { [a, b, c] } else { [a, c, b] };
                    let [p, q, r] = corners;
                    let is_side = |side: &[u32; 2]| sides.binary_search(side).is_ok();
                    if turn != 0.0
                        && [[p, q], [q, r], [r, p]].iter().all(is_side)
                        && !outline.has_ring_in(corners)
                        && face.is_wide(corners)
                    {
                        triangles.push(corners);
                    }
                }
            }
        }
        triangles.sort_unstable();
        Self { chords, triangles, sides }
    }
}

impl CheckedFace<'_> {
    fn is_wide(&self, corners: [u32; 3]) -> bool {
        let points = corners.map(|corner| self.outline.points[corner as usize]);
        self.least_tangent <= 0.0 || min_angle_tangent(points) >= self.least_tangent
    }
}

impl CheckedOutline<'_> {
    /// Adds the admissible chords from a vertex to larger ones. Next to a chord that an edge is in the way of, there
    /// are others that it is in the way of.
    fn add_chords(&self, low: u32, chords: &mut Vec<[u32; 2]>) {
        let ends = [self.previous(low), self.next(low)];
        let mut in_the_way = None;
        for high in low + 1..self.points.len() as u32 {
            let chord = [low, high];
            if ends.contains(&high)
                || in_the_way.is_some_and(|edge| self.is_in_the_way(edge, chord))
                || !self.may_join(chord)
            {
                continue;
            }
            match self.edges().find(|&edge| self.is_in_the_way(edge, chord)) {
                Some(edge) => in_the_way = Some(edge),
                None => chords.push(chord),
            }
        }
    }

    /// Whether a hole lies in a triangle whose sides do not cross it.
    fn has_ring_in(&self, corners: [u32; 3]) -> bool {
        let [a, b, c] = corners;
        let [p, q, r] = corners.map(|corner| self.points[corner as usize]);
        let (low, high) = (p.min(q).min(r), p.max(q).max(r));
        let is_in = |vertex: u32| {
            let point: DVec2 = self.points[vertex as usize];
            point.cmpge(low).all()
                && point.cmple(high).all()
                && [[a, b], [b, c], [c, a]]
                    .iter()
                    .all(|&[from, to]| self.turn(from, to, vertex) > 0.0)
        };
        self.rings
            .iter()
            .skip(1)
            .any(|ring| ring.clone().find(|vertex| !corners.contains(vertex)).is_some_and(is_in))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square with a square hole, whose corners are on diagonals of the outer one.
    #[test]
    fn chords_are_the_admissible_pairs() {
        let at = |half: f64| [(-half, -half), (half, -half), (half, half), (-half, half)];
        let ([a, b, c, d], [p, q, r, s]) = (at(3.0), at(1.0));
        let points = [a, b, c, d, p, s, r, q].map(DVec2::from);
        let side_of = [0, 1, 2, 3, 4, 5, 6, 7];
        let outline = CheckedOutline {
            points: &points,
            rings: &[0..4, 4..8],
            side_of: &side_of,
            keeps_clear: true,
        };
        let face = CheckedFace { outline, vertices: &side_of, least_tangent: 0.0 };
        let candidates = Candidates::of(&face);
        let pairs = (0..8).flat_map(|low| (low + 1..8).map(move |high| [low, high]));
        let is_edge =
            |&[low, high]: &[u32; 2]| outline.next(low) == high || outline.next(high) == low;
        let expected: Vec<_> =
            pairs.filter(|pair| !is_edge(pair) && outline.is_admissible(*pair)).collect();
        assert_eq!(candidates.chords, expected);
        assert_eq!(expected.len(), 12);
        // Each outer edge has a triangle to either of two corners of the hole, and so has each inner one.
        assert_eq!(candidates.triangles.len(), 16);
        assert_eq!(candidates.sides.len(), 8 + 24);
    }
}
