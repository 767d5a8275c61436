//! Where a mesh has its triangles from: a formula, or a list.
//!
//! The formula's vertex 0 is where a straight run of the domain begins. Where the domain's first corner
//! is in the middle of a run, the two have other indices.
//!
//! Limits: a list has been checked, and takes memory for each triangle.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use either::Either;
use mindeg_core::Triangulation;

/// The triangles of a mesh, by formula or in full.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Faces {
    Formula(Formula),
    List(TriangleList),
}

/// A formula's triangulation of the vertices of a domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Formula {
    pub(super) triangulation: Triangulation,
    /// The domain's index of the formula's vertex 0.
    pub(super) first: u32,
}

/// A triangulation in full.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct TriangleList {
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) degrees: Vec<u32>,
    pub(super) max_degree: u32,
}

impl Formula {
    /// The domain's index of a vertex of the formula.
    pub(super) fn of_domain(&self, vertex: u32) -> u32 {
        turned(vertex, self.first, self.triangulation.vertex_count())
    }

    /// The formula's index of a vertex of the domain.
    fn of_formula(&self, vertex: u32) -> u32 {
        let count = self.triangulation.vertex_count();
        assert!(vertex < count, "vertex {vertex} does not exist; the mesh has {count} vertices");
        turned(vertex, count - self.first, count)
    }
}

/// A vertex `by` vertices farther on a ring of `count`.
pub(super) fn turned(vertex: u32, by: u32, count: u32) -> u32 {
    let left = count - by;
    if vertex < left { vertex + by } else { vertex - left }
}

impl Faces {
    pub(super) fn vertex_count(&self) -> u32 {
        match self {
            Self::Formula(formula) => formula.triangulation.vertex_count(),
            Self::List(list) => list.degrees.len() as u32,
        }
    }

    pub(super) fn triangle_count(&self) -> u32 {
        match self {
            Self::Formula(formula) => formula.triangulation.vertex_count() - 2,
            Self::List(list) => list.triangles.len() as u32,
        }
    }

    pub(super) fn triangle(&self, index: u32) -> [u32; 3] {
        match self {
            Self::Formula(formula) => {
                formula.triangulation.triangle(index).map(|vertex| formula.of_domain(vertex))
            }
            Self::List(list) => list.triangles[index as usize],
        }
    }

    /// The triangles of a range, in order.
    pub(super) fn triangles_of(
        &self,
        range: Range<u32>,
    ) -> impl ExactSizeIterator<Item = [u32; 3]> + '_ {
        // A leap is O(1) in either.
        let (skip, take) = (range.start as usize, range.len());
        match self {
            Self::Formula(formula) => {
                let triangles = formula.triangulation.triangles().skip(skip).take(take);
                Either::Left(triangles.map(|corners| corners.map(|v| formula.of_domain(v))))
            }
            Self::List(list) => Either::Right(list.triangles[skip..skip + take].iter().copied()),
        }
    }

    /// Writes the triangles from index `first` on, as many as `out` holds; no fewer may remain.
    pub(super) fn fill(&self, first: u32, out: &mut [[u32; 3]]) {
        match self {
            Self::Formula(formula) => {
                formula.triangulation.fill_triangles(first, out);
                if formula.first > 0 {
                    let vertices = out.as_flattened_mut().iter_mut();
                    vertices.for_each(|vertex| *vertex = formula.of_domain(*vertex));
                }
            }
            Self::List(list) => {
                let first = first as usize;
                out.copy_from_slice(&list.triangles[first..first + out.len()]);
            }
        }
    }

    pub(super) fn degree(&self, vertex: u32) -> u32 {
        match self {
            Self::Formula(formula) => formula.triangulation.degree(formula.of_formula(vertex)),
            Self::List(list) => list.degrees[vertex as usize],
        }
    }

    /// The neighbours of a vertex, counter-clockwise, fan by fan.
    pub(super) fn neighbors(&self, vertex: u32) -> Vec<u32> {
        match self {
            Self::Formula(formula) => {
                let neighbors = formula.triangulation.neighbors(formula.of_formula(vertex));
                neighbors.map(|neighbor| formula.of_domain(neighbor)).collect()
            }
            Self::List(list) => {
                let around = list.triangles.iter().filter_map(|corners| {
                    let at = corners.iter().position(|&corner| corner == vertex)?;
                    Some((corners[(at + 1) % 3], corners[(at + 2) % 3]))
                });
                let around: BTreeMap<u32, u32> = around.collect();
                let ends: BTreeSet<u32> = around.values().copied().collect();
                let mut starts: Vec<u32> =
                    around.keys().copied().filter(|from| !ends.contains(from)).collect();
                if starts.is_empty() {
                    starts.extend(around.keys().next());
                }
                let mut found = Vec::with_capacity(around.len() + 1);
                for start in starts {
                    let beyond = |from: &u32| around.get(from).copied().filter(|to| *to != start);
                    found.extend(std::iter::successors(Some(start), beyond));
                }
                found
            }
        }
    }

    pub(super) fn max_degree(&self) -> u32 {
        match self {
            Self::Formula(formula) => formula.triangulation.max_degree(),
            Self::List(list) => list.max_degree,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turning_wraps_and_does_not_overflow() {
        let most = u32::MAX - 1;
        for (vertex, by, count, expected) in [
            (0, 0, 5, 0),
            (4, 0, 5, 4),
            (0, 2, 5, 2),
            (3, 2, 5, 0),
            (0, 5, 5, 0),
            (4, 5, 5, 4),
            (most - 1, most - 1, most, most - 2),
        ] {
            assert_eq!(turned(vertex, by, count), expected);
        }
    }
}
