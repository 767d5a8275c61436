//! Chooses the candidate for a mesh of least degree that is best on the actual points.
//!
//! Limits: any bad triangle drops a candidate, so the number of triangles visited depends on the
//! threads. The choice does not.

use std::ops::Range;

use glam::DVec2;
use mindeg_core::{Boundary, Candidates, Triangulation};

use mindeg_domain::{ConvexForm, Placement};
use mindeg_mesh::parallel::{block, fill_blocks, first_of_blocks, try_blocks};
use mindeg_mesh::{Cancelled, Counter, Progress};

use super::angles::{cotangents, placed};
use super::faces::{Formula, turned};
use crate::error::MeshError;

/// The most candidates tried.
const MOST_CANDIDATES: u32 = 64;

/// The most triangles visited in all, unless two candidates have more.
const MOST_TRIANGLES: u32 = 1 << 25;

/// Up to this many vertices, points are computed once and kept while candidates are compared
/// (16 MiB); beyond, they are computed anew for every candidate.
const MOST_KEPT: u32 = 1 << 20;

/// The relative difference of cotangents at which a later candidate is better.
const MARGIN: f64 = 1e-9;

/// The candidate with the largest minimum angle.
pub(super) fn best_candidate(
    form: &ConvexForm,
    placement: &Placement,
    progress: Progress<'_>,
) -> Result<Formula, MeshError> {
    let boundary = form.boundary();
    let candidates = Candidates::new(boundary);
    let limit = candidates_to_try(boundary);
    let triangles = u64::from(boundary.vertex_count()) - 2;
    let total = candidates.count().min(limit.into()) * triangles;
    let counter = progress.counter("choosing the mesh", total);
    let points = Points::new(placement, form.first());
    let mut best: Option<(f64, Triangulation)> = None;
    let mut dropped = None;
    // Candidates are mostly bad in the same region: where one is worst, others are tested first.
    let mut suspects = Vec::new();
    for (tried, candidate) in (1..).zip(candidates.sample(limit)) {
        let limit = best.map_or(f64::INFINITY, |(worst, _)| worst * (1.0 - MARGIN));
        match points.worst(&candidate, limit, &suspects, &counter)? {
            Some(Worst { cotangent, block }) => {
                best = Some((cotangent, candidate));
                suspects.push(block);
            }
            None => dropped = Some(candidate),
        }
        counter.reach(tried * triangles)?;
    }
    let formula = |(_, triangulation)| Formula { triangulation, first: form.first() };
    best.map(formula).ok_or_else(|| {
        // Some candidate was tried, and if none is left then all of them have such a triangle.
        let triangle = dropped.and_then(|candidate| points.first_without_area(&candidate));
        MeshError::no_area(triangle.unwrap_or_default())
    })
}

/// The minimum angle of a candidate.
#[derive(Clone, Copy)]
struct Worst {
    cotangent: f64,
    /// The block of triangles it is in.
    block: usize,
}

/// Why a candidate is not visited to its end.
enum Dropped {
    NoBetter,
    Cancelled,
}

/// The number of candidates to try.
fn candidates_to_try(boundary: &Boundary) -> u32 {
    (MOST_TRIANGLES / (boundary.vertex_count() - 2)).clamp(2, MOST_CANDIDATES)
}

/// The points that candidates are compared on.
struct Points<'a> {
    placement: &'a Placement,
    /// The domain's index of the candidates' vertex 0.
    first: u32,
    /// All points; empty if they are too many.
    kept: Vec<DVec2>,
}

impl<'a> Points<'a> {
    fn new(placement: &'a Placement, first: u32) -> Self {
        let count = placement.vertex_count();
        let mut kept = Vec::new();
        if count <= MOST_KEPT {
            kept.resize(count as usize, DVec2::ZERO);
            fill_blocks(&mut kept, |first, points| placement.fill_points(first, points));
        }
        Self { placement, first, kept }
    }

    /// The points of some triangles of a candidate.
    fn placed<'p>(
        &'p self,
        candidate: &'p Triangulation,
        range: Range<u32>,
    ) -> impl ExactSizeIterator<Item = [DVec2; 3]> + 'p {
        let mut walk = self.placement.walk();
        let triangles = candidate.triangles().skip(range.start as usize).take(range.len());
        let (first, count) = (self.first, self.placement.vertex_count());
        placed(triangles, move |vertex| {
            let vertex = turned(vertex, first, count);
            match self.kept.get(vertex as usize) {
                Some(&point) => point,
                None => walk.point(vertex),
            }
        })
    }

    /// The minimum angle of a candidate, if its cotangent is below `limit`; `suspects` are the
    /// blocks to visit first.
    fn worst(
        &self,
        candidate: &Triangulation,
        limit: f64,
        suspects: &[usize],
        counter: &Counter<'_>,
    ) -> Result<Option<Worst>, Cancelled> {
        let count = candidate.triangle_count();
        let greatest_cotangent = |range| {
            let mut greatest = f64::NEG_INFINITY;
            for points in self.placed(candidate, range) {
                greatest = greatest.max(cotangents(points)[0]);
                if greatest >= limit {
                    return Err(Dropped::NoBetter);
                }
            }
            Ok(greatest)
        };
        if suspects.iter().any(|&index| greatest_cotangent(block(index, count)).is_err()) {
            return Ok(None);
        }
        let in_blocks = try_blocks(count, |range| {
            let greatest = greatest_cotangent(range.clone())?;
            counter.add(range.len()).map_err(|Cancelled| Dropped::Cancelled)?;
            Ok(greatest)
        });
        let in_blocks = match in_blocks {
            Ok(in_blocks) => in_blocks,
            Err(Dropped::NoBetter) => return Ok(None),
            Err(Dropped::Cancelled) => return Err(Cancelled),
        };
        let worsts = in_blocks.into_iter().enumerate();
        let worsts = worsts.map(|(block, cotangent)| Worst { cotangent, block });
        let worst = |a: Worst, b: Worst| if b.cotangent > a.cotangent { b } else { a };
        Ok(worsts.reduce(worst))
    }

    fn first_without_area(&self, candidate: &Triangulation) -> Option<[u32; 3]> {
        first_of_blocks(candidate.triangle_count(), |range| {
            let start = range.start;
            let mut cotangents = self.placed(candidate, range).map(cotangents);
            let index = cotangents.position(|[of_least, _]| of_least == f64::INFINITY);
            let count = self.placement.vertex_count();
            let in_domain = |vertex| turned(vertex, self.first, count);
            index.map(|index| candidate.triangle(start + index as u32).map(in_domain))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_candidates_are_tried_on_many_vertices() {
        for (intervals, candidates) in [(1, 64), (100_000, 64), (1_000_000, 8), (1_000_000_000, 2)]
        {
            let boundary = Boundary::new(&[intervals; 4]).unwrap();
            assert_eq!(candidates_to_try(&boundary), candidates, "{intervals}");
        }
    }
}
