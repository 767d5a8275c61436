//! The search over all triangulations, once more: from the definition of a chord, with no thought for
//! speed. A mesh that it does not find does not exist.
//!
//! A piece is the part of the polygon beyond a chord or boundary edge. To the rest it matters only by its
//! chords at the two ends of that edge, so of each piece the least such pairs are kept.
//!
//! Limits: one ring; O(n³) time for the chords alone.

use super::CheckedOutline;

/// The least numbers of chords at the two ends of a piece: no pair has both as large as another's.
type Ends = Vec<[u32; 2]>;

impl CheckedOutline<'_> {
    /// Whether some triangulation of a polygon of one ring gives no vertex more chords than
    /// `most_chords` says; boundary edges are no chords. None beyond `max_work` steps, and for
    /// several rings. O(n³) steps for n vertices, and more where many chords meet.
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
        if self.rings.len() != 1 || n < 3 || most_chords.len() != n || work > max_work {
            return None;
        }
        let mut left = max_work - work;
        let is_edge = |i: usize, j: usize| i + 1 == j || (i == 0 && j + 1 == n);
        let mut pieces: Vec<Ends> = vec![Vec::new(); n * n];
        for span in 1..n {
            for i in 0..n - span {
                let j = i + span;
                let is_chord = !is_edge(i, j);
                if is_chord && !self.is_admissible([i as u32, j as u32]) {
                    continue;
                }
                if span == 1 {
                    pieces[i * n + j] = vec![[0, 0]];
                    continue;
                }
                let mut ends = Ends::new();
                for k in i + 1..j {
                    let [before, after] = [&pieces[i * n + k], &pieces[k * n + j]];
                    left = left.checked_sub(1 + (before.len() * after.len()) as u64)?;
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
