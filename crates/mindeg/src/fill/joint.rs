//! Loops that share vertices, under one limit of degrees: which loop gets how many chords at a shared vertex.
//!
//! One loop after the other, the first takes what it likes, and the next may find too little left. Together they are
//! decided by the rows of [`Cover`], where the row of a vertex counts the chords of all loops. The mesh that is found
//! gives each loop its share at the shared vertices; within it every loop has its least area.
//!
//! Limits: loops that share two vertices or more, of which both might make the same edge, are not decided together.

use super::posed::posed;
use crate::error::MeshError;
use crate::loops::{Loops, MeshLoop};
use mindeg_exact::{
    COVER_STEPS, Cover, Decision, LoopLimit, LoopProblem, LoopTriangulation, Unsolved, fill_loop,
};
use mindeg_mesh::{Progress, TriMesh};
use std::collections::BTreeMap;

/// For the index of a loop the limit, and the degrees that count at its vertices, backward: those that leave its share.
pub(super) type Shares = BTreeMap<usize, (u32, Vec<u32>)>;

/// Decides about the loops that are joined with this one by shared vertices, and keeps their shares; whether it did.
///
/// # Errors
///
/// A proof that no filling of these loops keeps the limit.
pub(super) fn share(
    mesh: &TriMesh,
    loops: &Loops,
    tasks: &[usize],
    index: usize,
    limit: u32,
    shares: &mut Shares,
    progress: Progress<'_>,
) -> Result<bool, MeshError> {
    let all = loops.list();
    let joined = joined(tasks, all, index);
    if joined.len() < 2 || share_edges(&joined, all) {
        return Ok(false);
    }
    let mut vertices: Vec<u32> =
        joined.iter().flat_map(|&found| &all[found].vertices).copied().collect();
    vertices.sort_unstable();
    vertices.dedup();
    let place = |vertex: &u32| vertices.binary_search(vertex).map_or(0, |at| at as u32);
    let places: Vec<Vec<u32>> =
        joined.iter().map(|&found| all[found].vertices.iter().rev().map(place).collect()).collect();
    let problems = joined.iter().map(|&found| posed(mesh, &all[found], loops, None));
    let problems = problems.collect::<Result<Vec<LoopProblem>, Unsolved>>()?;
    let faces: Vec<_> = problems.iter().zip(&places).map(|(it, own)| (it, &own[..])).collect();
    let Some(cover) = Cover::of_loops(&faces) else { return Ok(false) };
    let left = |vertex: &u32| limit.saturating_sub(loops.degrees[*vertex as usize]);
    let most: Vec<u32> = vertices.iter().map(left).collect();
    let tangents = vec![0.0; joined.len()];
    match cover.decide(&most, &tangents, &[], COVER_STEPS, progress)? {
        Decision::Unknown => Ok(false),
        Decision::Refuted(refutation) => {
            let numbers: Vec<String> = joined.iter().map(|found| (found + 1).to_string()).collect();
            let (clauses, numbers) = (refutation.clauses.len(), numbers.join(", "));
            Err(MeshError::Refused(format!(
                "loops {numbers} share vertices, and no fillings of them together have maximum degree {limit} \
                 (clauses that refute it: {clauses})"
            )))
        }
        Decision::Mesh(fillings) => {
            for ((&found, filling), own) in joined.iter().zip(&fillings).zip(&places) {
                let mut chords: Vec<u32> = vec![0; own.len()];
                filling.as_flattened().iter().for_each(|&corner| chords[corner as usize] += 1);
                let degree = |(&place, corners): (&u32, u32)| {
                    let is_shared = places.iter().filter(|all| all.contains(&place)).count() > 1;
                    let before = loops.degrees[vertices[place as usize] as usize];
                    // One triangle more than chords.
                    if is_shared { limit + 1 - corners } else { before }
                };
                let degrees = own.iter().zip(chords).map(degree).collect();
                shares.insert(found, (limit, degrees));
            }
            Ok(true)
        }
    }
}

/// The filling of least area within a loop's share. What is told without a limit is that of the loop alone.
pub(super) fn solve(
    mesh: &TriMesh,
    found: &MeshLoop,
    loops: &Loops,
    (limit, degrees): &(u32, Vec<u32>),
    progress: Progress<'_>,
) -> Result<LoopTriangulation, Unsolved> {
    let any = LoopLimit::LeastWithin { from: *limit, extra_area: f64::INFINITY };
    let alone = fill_loop(&posed(mesh, found, loops, None)?, any, progress)?;
    let problem = posed(mesh, found, loops, Some(degrees))?;
    let within = fill_loop(&problem, LoopLimit::AtMost(*limit), progress)?;
    let mut max_degree = 0;
    let mut chords: Vec<u32> = vec![0; degrees.len()];
    within.triangles.as_flattened().iter().for_each(|&corner| chords[corner as usize] += 1);
    for (vertex, chords) in found.vertices.iter().rev().zip(chords) {
        max_degree = (loops.degrees[*vertex as usize] + chords - 1).max(max_degree);
    }
    Ok(LoopTriangulation { max_degree, without_limit: alone.without_limit, ..within })
}

/// The loops to fill that are joined with one by shared vertices, from loop to loop.
fn joined(tasks: &[usize], all: &[MeshLoop], index: usize) -> Vec<usize> {
    let mut joined = vec![index];
    let mut next = 0;
    while let Some(&from) = joined.get(next) {
        next += 1;
        let meets = |&&other: &&usize| shared(&all[from], &all[other]) > 0;
        let others: Vec<usize> =
            tasks.iter().filter(|other| !joined.contains(other)).filter(meets).copied().collect();
        joined.extend(others);
    }
    joined.sort_unstable();
    joined
}

fn shared(a: &MeshLoop, b: &MeshLoop) -> usize {
    a.vertices.iter().filter(|vertex| b.vertices.contains(vertex)).count()
}

fn share_edges(joined: &[usize], all: &[MeshLoop]) -> bool {
    let pairs = (0..joined.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    pairs.into_iter().any(|(i, j)| shared(&all[joined[i]], &all[joined[j]]) > 1)
}
