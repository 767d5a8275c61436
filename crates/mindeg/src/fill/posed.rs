//! A loop of a mesh as the solver takes it.

use crate::loops::{Loops, MeshLoop};
use mindeg_exact::{LoopProblem, Unsolved};
use mindeg_mesh::TriMesh;

/// A loop as the solver takes it, by its vertices backward: so the filling faces as the mesh does. `degrees` count
/// instead of those of the mesh; edges between the vertices of `without` are not made.
pub(super) fn posed(
    mesh: &TriMesh,
    found: &MeshLoop,
    loops: &Loops,
    degrees: Option<&[u32]>,
    without: &[[u32; 2]],
) -> Result<LoopProblem, Unsolved> {
    let backward = || found.vertices.iter().rev().copied();
    let points: Vec<_> = backward().map(|vertex| mesh.positions()[vertex as usize]).collect();
    let own: Vec<u32> = backward().map(|vertex| loops.degrees[vertex as usize]).collect();
    let mut places: Vec<(u32, u32)> = backward().zip(0..).collect();
    places.sort_unstable();
    let place = |vertex: u32| {
        places.binary_search_by_key(&vertex, |&(vertex, _)| vertex).ok().map(|at| places[at].1)
    };
    let there = backward().zip(0..).flat_map(|(vertex, own)| {
        loops.neighbors(vertex).filter_map(place).map(move |other| [own, other])
    });
    let of_others = without.iter().filter_map(|&[a, b]| Some([place(a)?, place(b)?]));
    LoopProblem::new(&points, degrees.unwrap_or(&own), there.chain(of_others))
}
