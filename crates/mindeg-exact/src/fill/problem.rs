//! A loop in space.

use crate::unsolved::Unsolved;
use glam::DVec3;

/// The most vertices of a loop: n³/6 triangles are weighed, at this number 1.3 thousand million.
pub const MAX_LOOP: usize = 2000;

/// The most triangulations of pieces that are kept at a time, of 16 bytes each.
pub const MAX_STATES: usize = 1 << 24;

/// A closed loop in space, and what is around it.
#[derive(Clone, Debug)]
pub struct LoopProblem {
    pub(super) points: Vec<DVec3>,
    pub(super) external: Vec<u32>,
    /// For each pair of vertices, whether no edge of the filling may join them.
    pub(super) excluded: Vec<bool>,
}

impl LoopProblem {
    /// A loop of three vertices or more. `external` are the edges at each vertex without those of
    /// the filling: its two loop edges and all others. `excluded` are pairs of vertices
    /// that may not be joined; neighbours among them do not matter. O(n²) memory.
    ///
    /// # Errors
    ///
    /// More vertices than [`MAX_LOOP`].
    ///
    /// # Panics
    ///
    /// If there are fewer than three points, one is not finite, there are not as many external
    /// degrees as points, or an excluded pair is out of range.
    pub fn new(
        points: &[DVec3],
        external: &[u32],
        excluded: impl IntoIterator<Item = [u32; 2]>,
    ) -> Result<Self, Unsolved> {
        let n = points.len();
        assert!(n >= 3 && external.len() == n, "three points and as many degrees");
        assert!(points.iter().all(|point| point.is_finite()), "points are finite");
        if n > MAX_LOOP {
            return Err(Unsolved::Refused(format!(
                "the loop has {n} vertices; the maximum is {MAX_LOOP}"
            )));
        }
        let mut pairs = vec![false; n * n];
        for [a, b] in excluded {
            let [a, b] = [a as usize, b as usize];
            let are_neighbours = a.abs_diff(b) == 1 || a.abs_diff(b) == n - 1;
            pairs[a * n + b] = !are_neighbours;
            pairs[b * n + a] = !are_neighbours;
        }
        Ok(Self { points: points.to_vec(), external: external.to_vec(), excluded: pairs })
    }

    pub(crate) fn is_excluded(&self, i: usize, j: usize) -> bool {
        self.excluded[i * self.points.len() + j]
    }

    /// The most chords at each vertex under a limit.
    pub(super) fn capacities(&self, limit: u32) -> Vec<u16> {
        // A vertex has fewer chords than the loop has vertices.
        let most = self.points.len() as u32;
        self.external.iter().map(|&own| limit.saturating_sub(own).min(most) as u16).collect()
    }
}
