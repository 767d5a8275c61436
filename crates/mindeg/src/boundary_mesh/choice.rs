//! Which of the optimal plans looks best on actual points.
//!
//! Limits: that a plan is dropped shows in any of its triangles, so how many are looked at before
//! depends on the threads. What is chosen does not.

use std::ops::Range;

use glam::DVec2;
use mindeg_core::{Boundary, Candidates, Triangulation};

use super::MeshError;
use super::angles::{cotangents, placed};
use mindeg_domain::Placement;
use mindeg_mesh::parallel::{block, fill_blocks, first_of_blocks, try_blocks};
use mindeg_mesh::{Cancelled, Counter, Progress};

/// The most plans tried.
const MOST_PLANS: u32 = 64;

/// The most triangles visited in choosing a plan, two plans' worth aside.
const MOST_TRIANGLES: u32 = 1 << 25;

/// Up to so many vertices points are computed once and kept while plans are compared (16 MiB);
/// beyond, they are computed anew for every plan.
const MOST_KEPT: u32 = 1 << 20;

/// How much better the least angle's cotangent must be for a later plan to be taken.
const MARGIN: f64 = 1e-9;

/// The plan that [`Mesh::least_degree`](super::BoundaryMesh::least_degree) takes.
pub(super) fn best_plan(
    placement: &Placement,
    progress: Progress<'_>,
) -> Result<Triangulation, MeshError> {
    let boundary = placement.boundary();
    let plans = Candidates::new(boundary);
    let limit = plans_to_try(boundary);
    let triangles = u64::from(boundary.vertex_count()) - 2;
    let total = plans.count().min(limit.into()) * triangles;
    let counter = progress.counter("choosing the mesh", total);
    let points = Points::new(placement);
    let mut best: Option<(f64, Triangulation)> = None;
    let mut dropped = None;
    // Candidates are mostly bad in the same places: where one is worst is where to look at others.
    let mut suspects = Vec::new();
    for (tried, plan) in (1..).zip(plans.sample(limit)) {
        let limit = best.map_or(f64::INFINITY, |(worst, _)| worst * (1.0 - MARGIN));
        match points.worst(&plan, limit, &suspects, &counter)? {
            Some(Worst { cotangent, place }) => {
                best = Some((cotangent, plan));
                suspects.push(place);
            }
            None => dropped = Some(plan),
        }
        counter.reach(tried * triangles)?;
    }
    best.map(|(_, plan)| plan).ok_or_else(|| {
        // Some plan was tried, and if none is left then all of them have such a triangle.
        let triangle = dropped.and_then(|plan| points.first_without_area(&plan));
        MeshError::NoArea { triangle: triangle.unwrap_or_default() }
    })
}

/// The least angle of a plan.
#[derive(Clone, Copy)]
struct Worst {
    cotangent: f64,
    /// The block of triangles it is in.
    place: usize,
}

/// Why no more of a plan is looked at.
enum Dropped {
    NoBetter,
    Cancelled,
}

/// How many plans are worth their time.
fn plans_to_try(boundary: &Boundary) -> u32 {
    (MOST_TRIANGLES / (boundary.vertex_count() - 2)).clamp(2, MOST_PLANS)
}

/// The points that plans are compared on.
struct Points<'a> {
    placement: &'a Placement,
    /// All of them, or none where they are too many.
    kept: Vec<DVec2>,
}

impl<'a> Points<'a> {
    fn new(placement: &'a Placement) -> Self {
        let count = placement.vertex_count();
        let mut kept = Vec::new();
        if count <= MOST_KEPT {
            kept.resize(count as usize, DVec2::ZERO);
            fill_blocks(&mut kept, |first, points| placement.fill_points(first, points));
        }
        Self { placement, kept }
    }

    /// The points of some triangles of a plan.
    fn placed<'p>(
        &'p self,
        plan: &'p Triangulation,
        range: Range<u32>,
    ) -> impl ExactSizeIterator<Item = [DVec2; 3]> + 'p {
        let mut walk = self.placement.walk();
        let triangles = plan.triangles().skip(range.start as usize).take(range.len());
        placed(triangles, move |vertex| match self.kept.get(vertex as usize) {
            Some(&point) => point,
            None => walk.point(vertex),
        })
    }

    /// The least angle of a plan, if its cotangent is below `limit`; `suspects` are the blocks to
    /// look at first.
    fn worst(
        &self,
        plan: &Triangulation,
        limit: f64,
        suspects: &[usize],
        counter: &Counter<'_>,
    ) -> Result<Option<Worst>, Cancelled> {
        let count = plan.triangle_count();
        let greatest_cotangent = |range| {
            let mut greatest = f64::NEG_INFINITY;
            for points in self.placed(plan, range) {
                greatest = greatest.max(cotangents(points)[0]);
                if greatest >= limit {
                    return Err(Dropped::NoBetter);
                }
            }
            Ok(greatest)
        };
        if suspects.iter().any(|&place| greatest_cotangent(block(place, count)).is_err()) {
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
        let worsts = worsts.map(|(place, cotangent)| Worst { cotangent, place });
        let worst = |a: Worst, b: Worst| if b.cotangent > a.cotangent { b } else { a };
        Ok(worsts.reduce(worst))
    }

    fn first_without_area(&self, plan: &Triangulation) -> Option<[u32; 3]> {
        first_of_blocks(plan.triangle_count(), |range| {
            let start = range.start;
            let mut cotangents = self.placed(plan, range).map(cotangents);
            let place = cotangents.position(|[of_least, _]| of_least == f64::INFINITY);
            place.map(|place| plan.triangle(start + place as u32))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_plans_are_tried_on_many_vertices() {
        for (intervals, plans) in [(1, 64), (100_000, 64), (1_000_000, 8), (1_000_000_000, 2)] {
            let boundary = Boundary::new(&[intervals; 4]).unwrap();
            assert_eq!(plans_to_try(&boundary), plans, "{intervals}");
        }
    }
}
