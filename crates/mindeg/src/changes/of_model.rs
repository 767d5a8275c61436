//! Models with other counts of their edges.

use mindeg_core::Change;
use mindeg_domain::Model;
use mindeg_mesh::Progress;

use super::{CountChanges, Divided, found};
use crate::error::MeshError;
use crate::goal::Goal;
use crate::model::mesh_model;

/// The smallest changes of the counts of a model's edges, as [`count_changes`](super::count_changes) finds those of a domain.
///
/// An edge whose points are given keeps them.
///
/// # Errors
///
/// The errors of [`mesh_model`].
///
/// # Example
///
/// ```
/// use mindeg::{Model, Progress, changes::model_count_changes};
///
/// let tetrahedron = Model::from_json(
///     r#"{"corners": [[0,0,0], [1,0,0], [0,1,0], [0,0,1]],
///         "faces": [[0,2,1], [0,1,3], [1,2,3], [2,0,3]], "size": 0.75}"#,
/// )?;
/// let changes = model_count_changes(&tetrahedron, Some(5), 1.0, Progress::NONE)?;
/// assert_eq!((changes.at_least, changes.reached), (6, 6));
/// // One point less, on the edge between corners 2 and 3, is enough.
/// let after = &changes.found[0];
/// assert_eq!((after.suggestion.max_degree, after.at_least), (5, 1));
/// assert_eq!(after.after.vertex_count(), 6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn model_count_changes(
    model: &Model,
    wanted: Option<u32>,
    effort: f64,
    progress: Progress<'_>,
) -> Result<CountChanges<Model>, MeshError> {
    found(model, wanted, effort, progress)
}

/// The sum of all degrees, which every mesh of a model has: its edges and the chords of its faces, twice.
fn sum(model: &Model) -> i64 {
    let chords =
        |face| i64::from(model.face_size(face)) + 3 * model.face_loops(face).count() as i64 - 6;
    let edges: i64 = model.edge_degrees().into_iter().map(i64::from).sum();
    edges + 2 * (0..model.face_count()).map(chords).sum::<i64>()
}

/// The sum of all degrees grows by this with one interval more on an edge: an edge, and a chord in each face there.
fn growth(model: &Model, edge: usize) -> i64 {
    2 + 2 * i64::from(model.faces_at(edge))
}

impl Divided for Model {
    const TRY: usize = 8;

    fn counts(&self) -> Vec<u64> {
        (0..self.edge_count()).map(|edge| u64::from(self.intervals(edge))).collect()
    }

    fn vertex_count(&self) -> u32 {
        Model::vertex_count(self)
    }

    fn length(&self, edge: usize) -> f64 {
        self.edge_length(edge)
    }

    fn keeps_points(&self, edge: usize) -> bool {
        self.has_own_points(edge)
    }

    fn together(&self) -> Vec<Vec<usize>> {
        Vec::new()
    }

    /// The edges at a corner stay, and so does the sum of the degrees but for what changed counts add to it.
    fn floor(&self) -> u32 {
        let edges = self.edge_degrees().into_iter().max().unwrap_or(0);
        let is_possible = |degree: u32| {
            let degree = i64::from(degree);
            let mut excess = sum(self) - degree * i64::from(Divided::vertex_count(self));
            for edge in (0..self.edge_count()).filter(|&edge| !self.keeps_points(edge)) {
                match growth(self, edge) - degree {
                    ..0 => return true,
                    more => excess -= more * (i64::from(self.intervals(edge)) - 1),
                }
            }
            excess <= 0
        };
        // With a degree as large as what an interval adds, more intervals never help, and with a larger one they do.
        (edges.max(3)..).find(|&degree| is_possible(degree)).unwrap_or(u32::MAX)
    }

    /// Enough intervals for the sum of the degrees.
    fn least_size(&self, target: u32) -> u64 {
        let excess = sum(self) - i64::from(target) * i64::from(Divided::vertex_count(self));
        let by_one = |edge| (growth(self, edge) - i64::from(target)).unsigned_abs();
        let most = (0..self.edge_count()).map(by_one).max().unwrap_or(0);
        u64::try_from(excess).map_or(0, |excess| excess.div_ceil(most.max(1)))
    }

    fn is_excluded(&self, target: u32, by: &[Change]) -> bool {
        let target = i64::from(target);
        let more: i64 = by.iter().map(|one| one.by * (growth(self, one.side) - target)).sum();
        sum(self) - target * i64::from(Divided::vertex_count(self)) + more > 0
    }

    fn with_counts(&self, counts: &[u64]) -> Option<Self> {
        self.clone().with_intervals(counts).ok()
    }

    fn degree(
        &self,
        wanted: Option<u32>,
        effort: f64,
        progress: Progress<'_>,
    ) -> Result<[u32; 2], MeshError> {
        let goal = wanted.map_or(Goal::LeastDegree, Goal::MaxDegree);
        let meshed = mesh_model(self, goal, effort, progress)?;
        Ok([meshed.lower_bound, meshed.max_degree])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sum_of_degrees_is_that_of_a_mesh_before_and_after_a_change() {
        // Open at the top, and with a hole in the bottom.
        let model = Model::from_json(
            r#"{"corners": [[0,0,0], [3,0,0], [3,3,0], [0,3,0], [0,0,1], [3,0,1], [3,3,1], [0,3,1],
                            [1,1,0], [2,1,0], [1,2,0]],
                "faces": [{"corners": [0,3,2,1], "holes": [[8,9,10]]}, [0,1,5,4], [1,2,6,5], [2,3,7,6], [3,0,4,7]], "size": 1.5}"#,
        )
        .unwrap();
        for edge in 0..model.edge_count() {
            let mut counts = model.counts();
            counts[edge] += 1;
            let after = model.with_counts(&counts).unwrap();
            assert_eq!(sum(&after), sum(&model) + growth(&model, edge), "edge {edge}");
            let mesh = mesh_model(&after, Goal::LeastDegree, 0.0, Progress::NONE).unwrap().mesh;
            let edges: std::collections::BTreeSet<[u32; 2]> = mesh
                .triangles()
                .iter()
                .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
                .map(|[a, b]| [a.min(b), a.max(b)])
                .collect();
            assert_eq!(sum(&after), 2 * edges.len() as i64, "edge {edge}");
        }
    }
}
