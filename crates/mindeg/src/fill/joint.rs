//! Loops that share vertices, under one limit of degrees: which loop gets how many chords at a shared vertex.
//!
//! One loop after the other, the first takes what it likes, and the next may find too little left. Together they are
//! decided by the rows of [`Cover`], where the row of a vertex counts the chords of all loops. The mesh that is found
//! gives each loop its share at the shared vertices; within it every loop has its least area.
//!
//! Loops that share two vertices or more may both want the edge between them, which only one may make: then the search
//! branches on the loop that goes without it.

use super::posed::posed;
use crate::error::MeshError;
use crate::loops::{Loops, MeshLoop};
use mindeg_exact::{
    COVER_STEPS, Cover, Decision, LoopLimit, LoopProblem, LoopTriangulation, Unsolved, fill_loop,
};
use mindeg_mesh::{Progress, TriMesh, edges_of};
use std::collections::BTreeMap;

/// The shares of loops, by their indices.
pub(super) type Shares = BTreeMap<usize, Share>;

/// A loop's share of the edges and degrees that it has in common with others.
#[derive(Debug, Clone)]
pub(super) struct Share {
    /// The limit, if one is given, and the degrees that count at the loop's vertices, backward: those that leave its part.
    degrees: Option<(u32, Vec<u32>)>,
    /// The edges that other loops make.
    without: Vec<[u32; 2]>,
}

impl Share {
    /// True if it was decided under a limit.
    pub(super) fn is_limited(&self) -> bool {
        self.degrees.is_some()
    }
}

/// More branches than this are not tried.
const MOST_BRANCHES: usize = 64;

/// Decides about the loops that are joined with this one by shared vertices, and keeps their shares; whether it did.
/// Without a limit only edges that two loops want are decided about.
///
/// # Errors
///
/// A proof that no filling of these loops keeps the limit.
pub(super) fn share(
    mesh: &TriMesh,
    loops: &Loops,
    tasks: &[usize],
    index: usize,
    limit: Option<u32>,
    shares: &mut Shares,
    progress: Progress<'_>,
) -> Result<bool, MeshError> {
    let all = loops.list();
    let joined = joined(tasks, all, index);
    if joined.len() < 2 {
        return Ok(false);
    }
    let mut vertices: Vec<u32> =
        joined.iter().flat_map(|&found| &all[found].vertices).copied().collect();
    vertices.sort_unstable();
    vertices.dedup();
    let place = |vertex: &u32| vertices.binary_search(vertex).map_or(0, |at| at as u32);
    let places: Vec<Vec<u32>> =
        joined.iter().map(|&found| all[found].vertices.iter().rev().map(place).collect()).collect();
    let left = |vertex: &u32| {
        limit.map_or(vertices.len() as u32, |it| it.saturating_sub(loops.degrees[*vertex as usize]))
    };
    let most: Vec<u32> = vertices.iter().map(left).collect();
    let tangents = vec![0.0; joined.len()];
    // Each branch: edges that a loop goes without, by its position among those that are joined.
    let mut branches: Vec<Vec<(usize, [u32; 2])>> = vec![Vec::new()];
    let mut clauses = 0;
    for _ in 0..MOST_BRANCHES {
        let Some(branch) = branches.pop() else {
            let Some(limit) = limit else { return Ok(false) };
            let numbers: Vec<String> = joined.iter().map(|found| (found + 1).to_string()).collect();
            let numbers = numbers.join(", ");
            return Err(MeshError::Refused(format!(
                "loops {numbers} share vertices, and no fillings of them together have maximum degree {limit} \
                 (clauses that refute it: {clauses})"
            )));
        };
        let without = |at: usize| -> Vec<[u32; 2]> {
            branch.iter().filter(|(own, _)| *own == at).map(|&(_, edge)| edge).collect()
        };
        let problems = (0..).zip(&joined);
        let problems =
            problems.map(|(at, &found)| posed(mesh, &all[found], loops, None, &without(at)));
        let problems = problems.collect::<Result<Vec<LoopProblem>, Unsolved>>()?;
        let faces: Vec<_> = problems.iter().zip(&places).map(|(it, own)| (it, &own[..])).collect();
        let Some(cover) = Cover::of_loops(&faces) else { return Ok(false) };
        let fillings = match cover.decide(&most, &tangents, &[], COVER_STEPS, progress)? {
            Decision::Unknown => return Ok(false),
            Decision::Refuted(refutation) => {
                clauses += refutation.clauses.len();
                continue;
            }
            Decision::Mesh(fillings) => fillings,
        };
        let made: Vec<Vec<[u32; 2]>> =
            joined.iter().zip(&fillings).map(|(&found, it)| chords(&all[found], it)).collect();
        let twice = (0..made.len()).flat_map(|b| (0..b).map(move |a| [a, b])).find_map(|pair| {
            let edge = made[pair[0]].iter().find(|edge| made[pair[1]].contains(edge))?;
            Some((pair, *edge))
        });
        if let Some((pair, edge)) = twice {
            branches.extend(pair.map(|at| [&branch[..], &[(at, edge)]].concat()));
            continue;
        }
        for (at, ((&found, filling), own)) in joined.iter().zip(&fillings).zip(&places).enumerate()
        {
            let degree = |(&place, corners): (&u32, u32)| {
                let is_shared = places.iter().filter(|all| all.contains(&place)).count() > 1;
                let before = loops.degrees[vertices[place as usize] as usize];
                // One triangle more than chords.
                limit.filter(|_| is_shared).map_or(before, |limit| limit + 1 - corners)
            };
            let degrees = own.iter().zip(corner_counts(filling, own.len())).map(degree).collect();
            let others = made.iter().enumerate().filter(|(other, _)| *other != at);
            let without = others.flat_map(|(_, edges)| edges).copied().collect();
            let degrees = limit.map(|limit| (limit, degrees));
            shares.insert(found, Share { degrees, without });
        }
        return Ok(true);
    }
    Ok(false)
}

/// The filling of least area within a loop's share. Area and degree without a limit are those of the loop alone.
pub(super) fn solve(
    mesh: &TriMesh,
    found: &MeshLoop,
    loops: &Loops,
    share: &Share,
    wanted: LoopLimit,
    progress: Progress<'_>,
) -> Result<LoopTriangulation, Unsolved> {
    let Some((limit, degrees)) = &share.degrees else {
        return fill_loop(&posed(mesh, found, loops, None, &share.without)?, wanted, progress);
    };
    let any = LoopLimit::LeastWithin { from: *limit, extra_area: f64::INFINITY };
    let alone = fill_loop(&posed(mesh, found, loops, None, &[])?, any, progress)?;
    let problem = posed(mesh, found, loops, Some(degrees), &share.without)?;
    let within = fill_loop(&problem, LoopLimit::AtMost(*limit), progress)?;
    let counts = corner_counts(&within.triangles, degrees.len());
    let total = |(vertex, corners): (&u32, u32)| loops.degrees[*vertex as usize] + corners - 1;
    let max_degree = found.vertices.iter().rev().zip(counts).map(total).max().unwrap_or(0);
    Ok(LoopTriangulation { max_degree, without_limit: alone.without_limit, ..within })
}

/// The triangles at each of some vertices.
fn corner_counts(triangles: &[[u32; 3]], vertices: usize) -> Vec<u32> {
    let mut counts = vec![0; vertices];
    triangles.as_flattened().iter().for_each(|&corner| counts[corner as usize] += 1);
    counts
}

/// The edges of a loop's filling that are not the loop's own, as vertices of the mesh, each ascending.
fn chords(found: &MeshLoop, filling: &[[u32; 3]]) -> Vec<[u32; 2]> {
    let count = found.vertices.len();
    let edges = filling.iter().copied().flat_map(edges_of);
    let is_chord = |[a, b]: [u32; 2]| ![1, count as u32 - 1].contains(&a.abs_diff(b));
    let vertex = |place: u32| found.vertices[count - 1 - place as usize];
    edges
        .filter(|&edge| edge[0] < edge[1] && is_chord(edge))
        .map(|[a, b]| [vertex(a).min(vertex(b)), vertex(a).max(vertex(b))])
        .collect()
}

/// The loops to fill that are joined with one by shared vertices, from loop to loop.
fn joined(tasks: &[usize], all: &[MeshLoop], index: usize) -> Vec<usize> {
    let mut joined = vec![index];
    let mut next = 0;
    while let Some(&from) = joined.get(next) {
        next += 1;
        let meets = |&&other: &&usize| meet(&all[from], &all[other]);
        let others: Vec<usize> =
            tasks.iter().filter(|other| !joined.contains(other)).filter(meets).copied().collect();
        joined.extend(others);
    }
    joined.sort_unstable();
    joined
}

fn meet(a: &MeshLoop, b: &MeshLoop) -> bool {
    a.vertices.iter().any(|vertex| b.vertices.contains(vertex))
}
