//! The edges of a mesh beside the sizes that were wanted of them.

use crate::options::Options;
use crate::size::SizeField;
use glam::DVec2;
use mindeg_mesh::planar::PlanarBoundary;
use mindeg_mesh::{edges_of, sorted};
use std::collections::BTreeSet;
use std::ops::RangeInclusive;

/// An edge is near its size if it is so many times as long.
const NEAR: RangeInclusive<f64> = 0.7..=1.4;

/// The edges that a mesher chose beside the sizes wanted at their ends, and the edges that stay beside the sizes
/// asked for.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SizeReport {
    /// The number of edges that are compared: those that do not stay.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub edges: usize,
    /// The share of edges that are 0.7 to 1.4 times as long as wanted; 1 without edges.
    pub near: f64,
    /// The least ratio of an edge's length to its size.
    #[cfg_attr(feature = "serde", serde(rename = "least_ratio"))]
    pub least: f64,
    /// The greatest ratio.
    #[cfg_attr(feature = "serde", serde(rename = "greatest_ratio"))]
    pub greatest: f64,
    /// Edges that stay and are longer than was asked for there, in ascending order.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub coarse: Vec<CoarseEdge>,
}

/// An edge that stays and is more than 1.4 times as long as the size asked for there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoarseEdge {
    /// The index among the edges of the boundary: of its rings, then of its lines.
    pub edge: u32,
    /// The middle of the edge.
    pub at: DVec2,
    /// Its length.
    pub length: f64,
    /// The size asked for.
    pub size: f64,
}

impl SizeReport {
    /// Compares a mesh with the sizes that `options` ask for and the `field` made of them. O(n log n).
    pub(crate) fn new(
        outline: &PlanarBoundary,
        options: &Options,
        field: &SizeField,
        points: &[DVec2],
        triangles: &[[u32; 3]],
    ) -> Self {
        let sizes: Vec<f64> = points.iter().map(|point| field.at(*point)).collect();
        let frozen: BTreeSet<[u32; 2]> =
            frozen_edges(outline, options).map(|edge| sorted(outline.ends(edge))).collect();
        let given = (outline.points().len() + outline.inner_points().len()) as u32;
        let (mut near, mut count) = (0_usize, 0_usize);
        let (mut least, mut greatest) = (f64::INFINITY, 0.0_f64);
        for [a, b] in triangles.iter().copied().flat_map(edges_of) {
            // Each edge inside once.
            if a > b || b < given && frozen.contains(&[a, b]) {
                continue;
            }
            let [from, to] = [a, b].map(|vertex| vertex as usize);
            let ratio = 2.0 * points[from].distance(points[to]) / (sizes[from] + sizes[to]);
            near += usize::from(NEAR.contains(&ratio));
            count += 1;
            (least, greatest) = (least.min(ratio), greatest.max(ratio));
        }
        let edges = count;
        if count == 0 {
            (near, count, least, greatest) = (1, 1, 1.0, 1.0);
        }
        let middle = |[a, b, c]: [u32; 3]| {
            let [a, b, c] = [a, b, c].map(|vertex| points[vertex as usize]);
            (a + b + c) / 3.0
        };
        // A size far from the boundary is kept if it is reached anywhere.
        let is_reached = |inside: f64| {
            let is_near = |size: f64| size <= NEAR.end() * inside;
            sizes.iter().any(|size| is_near(*size))
                || triangles.iter().any(|triangle| is_near(field.at(middle(*triangle))))
        };
        let inside = options.wanted.size_inside.filter(|inside| !is_reached(*inside));
        let coarse = |edge: u32| {
            let [from, to] = outline.ends(edge).map(|vertex| outline.point(vertex));
            let (at, length) = (from.midpoint(to), from.distance(to));
            let size = field.asked().at(at).min(inside.unwrap_or(f64::INFINITY));
            (length > NEAR.end() * size).then_some(CoarseEdge { edge, at, length, size })
        };
        let coarse = frozen_edges(outline, options).filter_map(coarse).collect();
        Self { edges, near: near as f64 / count as f64, least, greatest, coarse }
    }

    /// This and another of a mesh beside it, without the edges that are too long.
    pub(crate) fn with(self, other: Self) -> Self {
        let edges = self.edges + other.edges;
        let near = |sizes: &Self| sizes.near * sizes.edges as f64;
        match (self.edges, other.edges) {
            (_, 0) => self,
            (0, _) => other,
            _ => Self {
                edges,
                near: (near(&self) + near(&other)) / edges as f64,
                least: self.least.min(other.least),
                greatest: self.greatest.max(other.greatest),
                coarse: Vec::new(),
            },
        }
    }
}

/// The edges of rings, and of lines that may not be divided.
fn frozen_edges<'a>(
    outline: &'a PlanarBoundary,
    options: &'a Options,
) -> impl Iterator<Item = u32> + 'a {
    let rings = outline.vertex_count();
    let stays = move |edge: &u32| match edge.checked_sub(rings) {
        Some(segment) => !options.is_divisible(segment as usize),
        None => true,
    };
    (0..outline.edge_count()).filter(stays)
}
