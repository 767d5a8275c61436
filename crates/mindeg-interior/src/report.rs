//! The report of a mesh: its figures, and those of meshes beside each other.

use crate::lengths::SizeReport;
use crate::limits::Limits;
use glam::DVec2;
use std::ops::RangeInclusive;

/// Up to this angle a greater share of the limit is worth a search, in degrees.
pub(crate) const ENOUGH: f64 = LocalShares::MOST;

/// A vertex whose degree is out of its range.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Violation {
    /// The vertex.
    pub vertex: u32,
    /// Where it is.
    #[cfg_attr(feature = "serde", serde(rename = "position"))]
    pub at: DVec2,
    /// Its degree.
    pub degree: u32,
    /// True for a boundary vertex.
    #[cfg_attr(feature = "serde", serde(rename = "on_boundary"))]
    pub is_boundary: bool,
}

/// The angles of all triangles beside the limits of their places.
///
/// A triangle's share is its minimum angle over the least limit at its vertices ([fan, tent](crate::limits)), which is
/// the one of the degree that the vertex has where that is above its limit; at most 35°, or a
/// greater target angle up to 40°, count, and a share of 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocalShares {
    /// The least share.
    pub worst: f64,
    /// The vertex with the limit of the triangle with the least share.
    pub vertex: u32,
    /// Where that is.
    pub at: DVec2,
    /// The limit there, in degrees.
    pub limit: f64,
    /// True if edges near it decide it: two that face each other, or an edge and the fans at both of its ends; not the fan at the vertex.
    pub is_tent: bool,
    /// No limit counts for more than this, in degrees: [`LocalShares::MOST`], or a greater target angle up to 40.
    pub most: f64,
    /// The 1st percentile of the shares.
    pub percentile: f64,
    /// The number of triangles below 0.9.
    pub below: usize,
}

impl LocalShares {
    /// No limit counts for more than this unasked, in degrees.
    pub const MOST: f64 = 35.0;
}

/// A vertex on the boundary or a line whose degree limit costs angle: either the degree or the angle is out of reach.
#[derive(Debug, Clone, PartialEq)]
pub struct CornerTradeOff {
    /// The vertex.
    pub vertex: u32,
    /// Where it is.
    pub at: DVec2,
    /// The degree that it has.
    pub degree: u32,
    /// Its degree limit.
    pub degree_limit: u32,
    /// Degrees from the limit on, with the greatest angle in degrees that triangles at the vertex can have.
    pub angles: Vec<(u32, f64)>,
}

/// A vertex at which so many edges meet that stay, of the boundary and of lines, that no mesh keeps its degree limit.
///
/// The edges divide the mesh round the vertex into sectors. Each takes a triangle, two if its angle is 180° or more,
/// three if it is a full turn; on the boundary there is one edge more than triangles.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct CertifiedVertex {
    /// The vertex.
    pub vertex: u32,
    /// Where it is.
    #[cfg_attr(feature = "serde", serde(rename = "position"))]
    pub at: DVec2,
    /// The other ends of the edges, counter-clockwise.
    pub edges: Vec<u32>,
    /// Its degree limit.
    pub degree_limit: u32,
    /// The least degree that it has in any mesh.
    pub least_degree: u32,
}

/// Vertices on the boundary and on lines that are above their degree limits by as many edges, in all, as in every mesh whose angles
/// there are no smaller.
#[derive(Debug, Clone, PartialEq)]
pub struct TogetherBound {
    /// The vertices, in ascending order.
    pub vertices: Vec<u32>,
    /// Where the first one is.
    pub at: DVec2,
    /// So many edges more than their limits they have in all, at least.
    pub more: u32,
    /// The share of the angles here that other meshes must have for that.
    pub share: f64,
    /// The vertices and the other ends of the edges there that stay, each with the angle in degrees that all triangles at it must have.
    pub angles: Vec<(u32, f64)>,
}

impl TogetherBound {
    fn names(&mut self) -> impl Iterator<Item = &mut u32> {
        self.vertices.iter_mut().chain(self.angles.iter_mut().map(|own| &mut own.0))
    }
}

/// The figures that a mesh reached. Angles are in degrees.
#[derive(Debug, Clone, PartialEq)]
pub struct InteriorReport {
    /// The proven limits of the minimum angle for this boundary.
    pub limits: Limits,
    /// The minimum angle.
    pub min_angle: f64,
    /// The vertex with the minimum angle.
    pub min_angle_vertex: u32,
    /// The proven limit of the minimum angle for boundary vertices with their degree limits, or with the
    /// degree that they have where that is more; less than [`limits`](Self::limits) tell where the fans at both ends of an edge allow less.
    pub angle_limit: f64,
    /// The least limit of edges that stay, whatever the degrees, in degrees; infinite where it is above all that counts.
    pub(crate) least_of_edges: f64,
    /// The minimum angle over [`angle_limit`](Self::angle_limit), never above 1 but for rounding.
    pub share_of_limit: f64,
    /// The angles beside the limits of their places.
    pub local: LocalShares,
    /// The vertices on the boundary and on lines whose degree limits cost angle, in ascending order.
    pub corners: Vec<CornerTradeOff>,
    /// The maximum angle.
    pub max_angle: f64,
    /// The least and greatest degree inside; `None` without interior vertices.
    pub interior_degree: Option<RangeInclusive<u32>>,
    /// The least and greatest degree at the boundary.
    pub boundary_degree: RangeInclusive<u32>,
    /// Vertices whose degree is out of its range, in ascending order.
    pub violations: Vec<Violation>,
    /// So many triangles have all corners at the boundary, where each is to have one inside.
    pub outside: usize,
    /// Vertices whose degree no mesh brings into its range, in ascending order: all of them are violations.
    pub certified: Vec<CertifiedVertex>,
    /// Groups of vertices above their degree limits, which no mesh with such angles brings nearer to them.
    pub together: Vec<TogetherBound>,
    /// No mesh of this boundary and these lines has a smaller maximum degree, whatever points are inside: so many edges does
    /// a vertex have at least, or else all edges have too many ends.
    pub at_least: u32,
    /// The greatest ratio of the areas of two triangles with a common edge.
    pub area_ratio: f64,
    /// The 99th percentile of the square root of that ratio: how fast edge lengths change.
    pub grading_p99: f64,
    /// The edges beside the sizes wanted; `None` where none were, as in a mesh that was improved.
    pub sizes: Option<SizeReport>,
    /// The number of triangles.
    pub triangles: usize,
    /// The number of vertices that are not on the boundary.
    pub interior_points: usize,
    /// The shares of local limits and the ratios of areas that percentiles are made of.
    pub(crate) samples: [Vec<f64>; 2],
}

impl InteriorReport {
    /// The report of meshes beside each other, which becomes one mesh: of each the index that its first vertex has
    /// there. `None` without meshes. O(n) for n triangles.
    #[must_use]
    pub fn of_all(reports: impl IntoIterator<Item = (u32, Self)>) -> Option<Self> {
        let mut all = reports.into_iter().map(|(first, mut report)| {
            report.names().for_each(|vertex| *vertex += first);
            report
        });
        let mut sum = all.next()?;
        for report in all {
            sum = sum.with(report);
        }
        let [shares, ratios] = &mut sum.samples;
        (sum.local.percentile, sum.grading_p99) = (first_percentile(shares), grading(ratios));
        sum.share_of_limit = (sum.min_angle / sum.angle_limit).min(1.0);
        Some(sum)
    }

    /// The names of all vertices that the report tells of.
    fn names(&mut self) -> impl Iterator<Item = &mut u32> {
        let Limits { any_degree, with_degree_limit, tent } = &mut self.limits;
        let tents = tent.iter_mut().flat_map(|tent| &mut tent.edges);
        let own = [&mut self.min_angle_vertex, &mut self.local.vertex];
        let limits = [&mut any_degree.vertex, &mut with_degree_limit.vertex];
        let violations = self.violations.iter_mut().map(|violation| &mut violation.vertex);
        let corners = self.corners.iter_mut().map(|corner| &mut corner.vertex);
        let certified = self.certified.iter_mut();
        let certified = certified.flat_map(|it| [&mut it.vertex].into_iter().chain(&mut it.edges));
        let vertices = own.into_iter().chain(limits).chain(tents).chain(violations);
        let together = self.together.iter_mut().flat_map(TogetherBound::names);
        vertices.chain(corners).chain(certified).chain(together)
    }

    /// This and another, but for the percentiles.
    fn with(mut self, other: Self) -> Self {
        if other.min_angle < self.min_angle {
            (self.min_angle, self.min_angle_vertex) = (other.min_angle, other.min_angle_vertex);
        }
        if other.angle_limit < self.angle_limit {
            (self.angle_limit, self.limits) = (other.angle_limit, other.limits);
        }
        self.least_of_edges = self.least_of_edges.min(other.least_of_edges);
        self.outside += other.outside;
        let below = self.local.below + other.local.below;
        if other.local.worst < self.local.worst {
            self.local = other.local;
        }
        self.local.below = below;
        self.max_angle = self.max_angle.max(other.max_angle);
        self.interior_degree = match (self.interior_degree, other.interior_degree) {
            (Some(one), Some(other)) => Some(around(&one, &other)),
            (one, other) => one.or(other),
        };
        self.boundary_degree = around(&self.boundary_degree, &other.boundary_degree);
        self.corners.extend(other.corners);
        self.violations.extend(other.violations);
        self.certified.extend(other.certified);
        self.together.extend(other.together);
        self.at_least = self.at_least.max(other.at_least);
        self.area_ratio = self.area_ratio.max(other.area_ratio);
        self.sizes = match (self.sizes, other.sizes) {
            (Some(one), Some(other)) => Some(one.with(other)),
            (one, other) => one.or(other),
        };
        self.triangles += other.triangles;
        self.interior_points += other.interior_points;
        for (own, others) in self.samples.iter_mut().zip(other.samples) {
            own.extend(others);
        }
        self
    }
}

/// The range around two.
pub(crate) fn around(
    one: &RangeInclusive<u32>,
    other: &RangeInclusive<u32>,
) -> RangeInclusive<u32> {
    *one.start().min(other.start())..=*one.end().max(other.end())
}

/// The 99th percentile of the square root of ratios of areas.
pub(crate) fn grading(ratios: &mut [f64]) -> f64 {
    let index = ratios.len().saturating_sub(1) * 99 / 100;
    match ratios.is_empty() {
        true => 1.0,
        false => ratios.select_nth_unstable_by(index, f64::total_cmp).1.sqrt(),
    }
}

/// The 1st percentile of shares.
pub(crate) fn first_percentile(shares: &mut [f64]) -> f64 {
    let index = shares.len().saturating_sub(1) / 100;
    match shares.is_empty() {
        true => 1.0,
        false => *shares.select_nth_unstable_by(index, f64::total_cmp).1,
    }
}

impl InteriorReport {
    /// The same report with other names of the vertices, and of the edges of the boundary and its lines.
    #[must_use]
    pub fn renamed(mut self, name: impl Fn(u32) -> u32, edge: impl Fn(u32) -> u32) -> Self {
        self.names().for_each(|vertex| *vertex = name(*vertex));
        for coarse in self.sizes.iter_mut().flat_map(|sizes| &mut sizes.coarse) {
            coarse.edge = edge(coarse.edge);
        }
        self.corners.sort_by_key(|corner| corner.vertex);
        self.violations.sort_by_key(|violation| violation.vertex);
        self.certified.sort_by_key(|certified| certified.vertex);
        for bound in &mut self.together {
            bound.vertices.sort_unstable();
            bound.angles.sort_unstable_by_key(|own| own.0);
        }
        self.together.sort_by(|a, b| a.vertices.cmp(&b.vertices));
        self
    }
}
