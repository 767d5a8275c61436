//! A lower bound on joint degrees: the least weight of a face's chords.

use crate::chords::Lists;
use crate::fronts::unfold;
use crate::linked::chord_counts;
use crate::measure::min_angle_tangent;
use crate::problem::Problem;
use crate::unsolved::Unsolved;
use mindeg_mesh::Progress;

/// The least weight of all triangulations of a polygon without holes, where a chord weighs what its
/// two ends weigh: a lower bound for joint degrees.
///
/// The average of the degrees of any vertices, weighted, is at most the largest degree. So with
/// weights w, the maximum degree of a model is at least the sum over its faces of the least
/// weights, and over its vertices of w times their edges of the model, divided by the sum of w.
#[derive(Clone, Debug)]
pub struct LeastWeight {
    up: Lists<u32>,
    vertices: usize,
    /// For each chord from i upwards, in the order of the lists, the apexes of allowed triangles.
    apexes: Vec<Vec<Vec<u32>>>,
}

impl LeastWeight {
    /// The polygon of a problem; only triangles with no [`min_angle_tangent`] below `min_tangent`
    /// count. O(triples of vertices that see each other), in time and memory.
    ///
    /// # Errors
    ///
    /// A domain with holes or of too many triples.
    pub fn new(problem: &Problem, min_tangent: f64) -> Result<Self, Unsolved> {
        let chords = problem.chords(Progress::NONE)?;
        let vertices = chords.vertex_count();
        let [counts, _] = chords.end_counts();
        let mut up = Lists::new(&counts);
        chords.ends().for_each(|[i, j]| up.push(i, j));
        let points = problem.points();
        let apexes = (0..vertices as u32).map(|i| {
            let of = |&j: &u32| {
                let is_apex = |apex: &&u32| {
                    let corners = [i, **apex, j].map(|vertex| points[vertex as usize]);
                    up.of(**apex).binary_search(&j).is_ok()
                        && (min_tangent <= 0.0 || min_angle_tangent(corners) >= min_tangent)
                };
                up.of(i).iter().take_while(|&&apex| apex < j).filter(is_apex).copied().collect()
            };
            up.of(i).iter().map(of).collect()
        });
        let apexes = apexes.collect();
        Ok(Self { up, vertices, apexes })
    }

    /// The number of triples, the work of one call of [`of`](Self::of).
    #[must_use]
    pub fn triples(&self) -> u64 {
        self.apexes.iter().flatten().map(|apexes| apexes.len() as u64).sum()
    }

    /// The least weight, and the chords at every vertex of a triangulation that has it; none if no
    /// triangulation is allowed.
    ///
    /// # Panics
    ///
    /// If there are fewer weights than vertices.
    #[must_use]
    pub fn of(&self, weights: &[u64]) -> Option<(u64, Vec<u32>)> {
        let n = self.vertices;
        let last = n as u32 - 1;
        // For each chord from i upwards the weight of its piece, with the chord, and the apex.
        let mut best: Vec<Vec<(u64, u32)>> = vec![Vec::new(); n];
        for i in (0..last).rev() {
            let mut own: Vec<(u64, u32)> = Vec::with_capacity(self.up.of(i).len());
            for (at, &j) in self.up.of(i).iter().enumerate() {
                if j == i + 1 {
                    own.push((0, i));
                    continue;
                }
                let is_chord = j - i < last;
                let chord = if is_chord { weights[i as usize] + weights[j as usize] } else { 0 };
                let mut least = (u64::MAX, i);
                for &apex in &self.apexes[i as usize][at] {
                    let left = own[self.place(i, apex)].0;
                    let right = best[apex as usize][self.place(apex, j)].0;
                    let weight = left.saturating_add(right);
                    if weight < least.0 {
                        least = (weight, apex);
                    }
                }
                own.push((least.0.saturating_add(chord), least.1));
            }
            best[i as usize] = own;
        }
        let weight = best[0][self.place(0, last)].0;
        if weight == u64::MAX {
            return None;
        }
        let triangles = unfold(n, (), |[i, j], ()| {
            Some((best[i][self.place(i as u32, j as u32)].1 as usize, [(), ()]))
        });
        Some((weight, chord_counts(n, &triangles)))
    }

    /// The place of the chord (i, j) among those from i upwards.
    fn place(&self, i: u32, j: u32) -> usize {
        self.up.of(i).partition_point(|&other| other < j)
    }
}
