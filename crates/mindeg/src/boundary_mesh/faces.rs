//! Where a mesh has its triangles from: a formula, or a list.
//!
//! Limits: a list is what [`mindeg_core::verify`] has approved of, and takes memory by the
//! triangle.

use std::ops::Range;

use either::Either;
use mindeg_core::{Boundary, Defect, Triangulation, verify};

/// The triangles of a mesh, whatever they are kept as.
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

    pub(super) fn triangle(&self, number: u32) -> [u32; 3] {
        match self {
            Self::Formula(triangulation) => triangulation.triangle(number),
            Self::List(list) => list.triangles[number as usize],
        }
    }

    /// The triangles with the given numbers, in order.
    pub(super) fn triangles_of(
        &self,
        numbers: Range<u32>,
    ) -> impl ExactSizeIterator<Item = [u32; 3]> + '_ {
        let all = match self {
            Self::Formula(triangulation) => Either::Left(triangulation.triangles()),
            Self::List(list) => Either::Right(list.triangles.iter().copied()),
        };
        // A leap is O(1) in either.
        all.skip(numbers.start as usize).take(numbers.len())
    }

    /// Writes the triangles from number `first` on, as many as `out` holds. There must be so many.
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

    pub(super) fn max_degree(&self) -> u32 {
        match self {
            Self::Formula(triangulation) => triangulation.max_degree(),
            Self::List(list) => list.max_degree,
        }
    }
}
