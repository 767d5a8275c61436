//! The least cost of each piece of a loop, whatever its degrees.

use super::problem::LoopProblem;
use crate::fronts::unfold;
use crate::space::{Cost, cost};
use glam::DVec3;
use mindeg_mesh::parallel::map_chunks;
use mindeg_mesh::{Cancelled, Progress};

/// The least cost of the piece between any two vertices.
pub(super) struct AnyDegree {
    n: usize,
    /// Entries (i, j) and (j, i) are the piece with the vertices from i to j.
    costs: Vec<Cost>,
}

/// Pieces that one thread takes at a time.
const CHUNK: usize = 16;

impl AnyDegree {
    /// Returns `None` if each triangulation has an excluded edge.
    pub(super) fn solve(
        problem: &LoopProblem,
        points: &[DVec3],
        progress: Progress<'_>,
    ) -> Result<Option<Self>, Cancelled> {
        let n = points.len();
        let mut all = Self { n, costs: vec![Cost::INFINITE; n * n] };
        for i in 0..n - 1 {
            all.set(i, i + 1, Cost::NONE);
        }
        for span in 2..n {
            progress.report("least area", span as u64, n as u64)?;
            let costs = map_chunks(0..n - span, CHUNK, |starts| {
                let of_piece = |i: usize| {
                    let j = i + span;
                    if problem.is_excluded(i, j) {
                        Cost::INFINITE
                    } else {
                        all.best(points, i, j).0
                    }
                };
                starts.map(of_piece).collect::<Vec<Cost>>()
            });
            for (i, cost) in costs.into_iter().flatten().enumerate() {
                all.set(i, i + span, cost);
            }
        }
        Ok((all.cost() < Cost::INFINITE).then_some(all))
    }

    /// The cost of the whole loop.
    pub(super) fn cost(&self) -> Cost {
        self.costs[self.n - 1]
    }

    /// A triangulation of least cost.
    pub(super) fn triangles(&self, points: &[DVec3]) -> Vec<[u32; 3]> {
        unfold(self.n, (), |[i, j], ()| Some((self.best(points, i, j).1, [(), ()])))
    }

    /// The least cost of the piece from i to j, and the third corner of its triangle at ij: the
    /// first of equals.
    fn best(&self, points: &[DVec3], i: usize, j: usize) -> (Cost, usize) {
        let mut best = (Cost::INFINITE, i + 1);
        let (from, to) = (&self.costs[i * self.n..], &self.costs[j * self.n..]);
        for k in i + 1..j {
            let (left, right) = (from[k], to[k]);
            if left == Cost::INFINITE || right == Cost::INFINITE {
                continue;
            }
            let sides = left.plus(right);
            if sides < best.0 {
                let whole = sides.plus(cost(points[i], points[k], points[j]));
                if whole < best.0 {
                    best = (whole, k);
                }
            }
        }
        best
    }

    fn set(&mut self, i: usize, j: usize, cost: Cost) {
        self.costs[i * self.n + j] = cost;
        self.costs[j * self.n + i] = cost;
    }
}
