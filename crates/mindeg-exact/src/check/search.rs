//! The search over all triangulations, once more: from the definition of a chord, with no thought for
//! speed. A mesh that it does not find does not exist.
//!
//! A piece is the part of the polygon beyond a chord or boundary edge. To the rest it matters only by its
//! chords at the two ends of that edge, so of each piece the least such pairs are kept.
//!
//! Round holes it is made for each way to cut the domain open.
//!
//! Limits: O(n³) time for the chords alone, and again for each cut; with several holes for each combination of cuts.

use super::CheckedOutline;
use std::ops::Range;

/// The least numbers of chords at the two ends of a piece: no pair has both as large as another's.
type Ends = Vec<[u32; 2]>;

impl CheckedOutline<'_> {
    /// Whether some triangulation of a polygon with holes gives no vertex more chords than `most_chords` says; boundary
    /// edges are no chords. None beyond `max_work` steps. O(n³) steps for n vertices, more where many chords
    /// meet, and with each hole for each of up to n cuts.
    ///
    /// # Example
    ///
    /// ```
    /// use glam::DVec2;
    /// use mindeg_exact::check::CheckedOutline;
    ///
    /// let points = [(0, 0), (1, 0), (1, 1), (0, 1)];
    /// let points = points.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
    /// let side_of = [0, 1, 2, 3];
    /// let square = CheckedOutline { points: &points, rings: &[0..4], side_of: &side_of, keeps_clear: true };
    /// assert_eq!(square.has_triangulation(&[1, 0, 1, 0], 1000), Some(true));
    /// assert_eq!(square.has_triangulation(&[1, 0, 0, 1], 1000), Some(false));
    /// assert_eq!(square.has_triangulation(&[1, 0, 0, 1], 10), None);
    /// ```
    #[must_use]
    pub fn has_triangulation(&self, most_chords: &[u32], max_work: u64) -> Option<bool> {
        let n = self.points.len();
        let work = (n as u64).saturating_pow(3);
        if n < 3 || most_chords.len() != n || work > max_work {
            return None;
        }
        let mut left = max_work - work;
        let joins = self.joins();
        let [outer, holes @ ..] = self.rings else { return None };
        let polygon = outer.clone().map(|v| (v, most_chords[v as usize])).collect();
        self.is_divided_around(polygon, holes, most_chords, &joins, &mut left)
    }

    /// For each pair of vertices whether it is an admissible chord.
    fn joins(&self) -> Vec<bool> {
        let n = self.points.len() as u32;
        let pairs = (0..n).flat_map(|a| (0..n).map(move |b| [a.min(b), a.max(b)]));
        let mut joins = vec![false; (n * n) as usize];
        for [a, b] in pairs.filter(|[a, b]| a < b && self.next(*a) != *b && self.next(*b) != *a) {
            let (at, back) = ((a * n + b) as usize, (b * n + a) as usize);
            joins[at] = joins[at] || self.is_admissible([a, b]);
            joins[back] = joins[at];
        }
        joins
    }

    /// Whether a polygon with holes has a triangulation: cut at a chord from the leftmost vertex of all holes to the polygon, of which
    /// each has one, it has a hole less, and both ends are in it once more.
    fn is_divided_around(
        &self,
        polygon: Vec<(u32, u32)>,
        holes: &[Range<u32>],
        most_chords: &[u32],
        joins: &[bool],
        left: &mut u64,
    ) -> Option<bool> {
        let n = self.points.len() as u32;
        let x = |v: u32| self.points[v as usize].x;
        let starts = holes.iter().map(|hole| hole.clone().min_by(|&a, &b| x(a).total_cmp(&x(b))));
        let starts = starts.collect::<Option<Vec<u32>>>()?;
        let Some(cut) = (0..holes.len()).min_by(|&a, &b| x(starts[a]).total_cmp(&x(starts[b])))
        else {
            return self.is_divided(&polygon, joins, left);
        };
        let start = starts[cut];
        let rest = [&holes[..cut], &holes[cut + 1..]].concat();
        let after = |v: &u32| Some(self.next(*v)).filter(|v| *v != start);
        let hole = std::iter::successors(Some(start), after).chain([start]);
        let hole: Vec<(u32, u32)> = hole.map(|v| (v, most_chords[v as usize])).collect();
        for (place, &(end, most_end)) in polygon.iter().enumerate() {
            if !joins[(start * n + end) as usize] {
                continue;
            }
            let whole = [&polygon[..=place], &hole, &polygon[place..]].concat();
            let last = place + hole.len();
            let most = most_chords[start as usize];
            // The cut is a chord at each.
            for (own, own_end) in (0..most).flat_map(|a| (0..most_end).map(move |b| (a, b))) {
                let mut polygon = whole.clone();
                (polygon[place + 1].1, polygon[last].1) = (own, most - 1 - own);
                (polygon[place].1, polygon[last + 1].1) = (own_end, most_end - 1 - own_end);
                if self.is_divided_around(polygon, &rest, most_chords, joins, left)? {
                    return Some(true);
                }
            }
        }
        Some(false)
    }

    /// Whether chords divide a polygon into triangles that turn left, at most so many at each corner. Where it passes a vertex twice, they
    /// cover it all the same: they all turn as it does, and it goes once round each point inside.
    fn is_divided(&self, polygon: &[(u32, u32)], joins: &[bool], left: &mut u64) -> Option<bool> {
        let n = polygon.len();
        let (polygon, most_chords): (Vec<u32>, Vec<u32>) = polygon.iter().copied().unzip();
        let is_edge = |i: usize, j: usize| i + 1 == j || (i == 0 && j + 1 == n);
        let mut pieces: Vec<Ends> = vec![Vec::new(); n * n];
        for span in 1..n {
            for i in 0..n - span {
                let j = i + span;
                let is_chord = !is_edge(i, j);
                if is_chord && !joins[polygon[i] as usize * self.points.len() + polygon[j] as usize]
                {
                    continue;
                }
                if span == 1 {
                    pieces[i * n + j] = vec![[0, 0]];
                    continue;
                }
                let mut ends = Ends::new();
                for k in i + 1..j {
                    let [before, after] = [&pieces[i * n + k], &pieces[k * n + j]];
                    *left = left.checked_sub(1 + (before.len() * after.len()) as u64)?;
                    let is_flat = |[i, k, j]: [usize; 3]| {
                        self.turn(polygon[i], polygon[k], polygon[j]) <= 0.0
                    };
                    if before.is_empty() || after.is_empty() || is_flat([i, k, j]) {
                        continue;
                    }
                    let [ik, kj, ij] = [!is_edge(i, k), !is_edge(k, j), is_chord].map(u32::from);
                    for [at_i, at_k] in before {
                        for [more_at_k, at_j] in after {
                            let both = [at_i + ik, at_j + kj];
                            let fits = at_k + more_at_k + ik + kj <= most_chords[k]
                                && both[0] + ij <= most_chords[i]
                                && both[1] + ij <= most_chords[j];
                            if fits {
                                keep(&mut ends, both);
                            }
                        }
                    }
                }
                pieces[i * n + j] = ends;
            }
        }
        Some(!pieces[n - 1].is_empty())
    }
}

/// Inserts a pair into the Pareto front: skips it if dominated, removes what it dominates.
fn keep(ends: &mut Ends, pair: [u32; 2]) {
    if ends.iter().any(|other| other[0] <= pair[0] && other[1] <= pair[1]) {
        return;
    }
    ends.retain(|other| other[0] < pair[0] || other[1] < pair[1]);
    ends.push(pair);
}
