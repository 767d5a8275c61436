//! Where a mesh has its triangles from: a formula, or a list.
//!
//! Limits: [`mindeg_core::verify`] has approved of a list, which takes memory for each triangle.

use std::ops::Range;

use either::Either;
use mindeg_core::{Boundary, Defect, Triangulation, verify};

/// The triangles of a mesh, by formula or in full.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Faces {
    Formula(Triangulation),
    List(TriangleList),
}

/// A triangulation in full.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct TriangleList {
    triangles: Vec<[u32; 3]>,
    degrees: Vec<u32>,
    max_degree: u32,
}

impl TriangleList {
    /// The list, if it triangulates the boundary. O(n log n).
    pub(super) fn new(boundary: &Boundary, triangles: Vec<[u32; 3]>) -> Result<Self, Defect> {
        let intervals: Vec<u64> = boundary.sides().map(u64::from).collect();
        let verified = verify(&intervals, triangles.iter().copied())?;
        Ok(Self { triangles, degrees: verified.degrees, max_degree: verified.max_degree })
    }
}

impl Faces {
    pub(super) fn vertex_count(&self) -> u32 {
        match self {
            Self::Formula(triangulation) => triangulation.vertex_count(),
            Self::List(list) => list.degrees.len() as u32,
        }
    }

    pub(super) fn triangle_count(&self) -> u32 {
        self.vertex_count() - 2
    }

    pub(super) fn triangle(&self, index: u32) -> [u32; 3] {
        match self {
            Self::Formula(triangulation) => triangulation.triangle(index),
            Self::List(list) => list.triangles[index as usize],
        }
    }

    /// The triangles of a range, in order.
    pub(super) fn triangles_of(
        &self,
        range: Range<u32>,
    ) -> impl ExactSizeIterator<Item = [u32; 3]> + '_ {
        let all = match self {
            Self::Formula(triangulation) => Either::Left(triangulation.triangles()),
            Self::List(list) => Either::Right(list.triangles.iter().copied()),
        };
        // A leap is O(1) in either.
        all.skip(range.start as usize).take(range.len())
    }

    /// Writes the triangles from index `first` on, as many as `out` holds; no fewer may remain.
    pub(super) fn fill(&self, first: u32, out: &mut [[u32; 3]]) {
        match self {
            Self::Formula(triangulation) => triangulation.fill_triangles(first, out),
            Self::List(list) => {
                let first = first as usize;
                out.copy_from_slice(&list.triangles[first..first + out.len()]);
            }
        }
    }

    pub(super) fn degree(&self, vertex: u32) -> u32 {
        match self {
            Self::Formula(triangulation) => triangulation.degree(vertex),
            Self::List(list) => list.degrees[vertex as usize],
        }
    }

    /// The neighbours of a vertex, counter-clockwise from the next boundary vertex.
    pub(super) fn neighbors(&self, vertex: u32) -> Vec<u32> {
        match self {
            Self::Formula(triangulation) => triangulation.neighbors(vertex).collect(),
            Self::List(list) => {
                let n = list.degrees.len() as u32;
                assert!(vertex < n, "vertex {vertex} does not exist; the mesh has {n} vertices");
                let around = list.triangles.iter().filter(|corners| corners.contains(&vertex));
                let mut neighbors: Vec<u32> =
                    around.flatten().copied().filter(|&other| other != vertex).collect();
                // Boundary vertices lie around a vertex in the order of the boundary.
                neighbors.sort_unstable_by_key(|&other| {
                    if other > vertex { other - vertex } else { other + (n - vertex) }
                });
                neighbors.dedup();
                neighbors
            }
        }
    }

    pub(super) fn max_degree(&self) -> u32 {
        match self {
            Self::Formula(triangulation) => triangulation.max_degree(),
            Self::List(list) => list.max_degree,
        }
    }
}
