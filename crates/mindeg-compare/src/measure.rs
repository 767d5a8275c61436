//! From points and a list of triangles to the figures of a report.
//!
//! Limits: takes any list whose vertices exist, valid or not. For invalid meshes
//! the figures describe the triangles given.

use crate::figures::{DefectKind, MethodDefect, MethodFigures};
use crate::regions::points;
use glam::DVec2;
use mindeg::quality::{DegreeHistogram, QualitySummary, TriangleQuality, WorstTriangles};
use mindeg::{BoundaryMesh, Domain};
use mindeg_answers::inspected::ThinTriangle;
use mindeg_mesh::check;
use mindeg_mesh::planar::PlanarBoundary;
use std::borrow::Cow;

/// How many of the worst triangles are listed.
const WORST: usize = 5;

/// The reference that triangles of a domain are checked against.
pub(crate) struct Checker<'a> {
    domain: &'a Domain,
    boundary: &'a PlanarBoundary,
    points: Cow<'a, [DVec2]>,
    /// For each vertex of a ring the straight runs that end and begin there.
    runs: Vec<[u32; 2]>,
    /// The number of triangles of a triangulation.
    triangles: u32,
}

impl<'a> Checker<'a> {
    /// `triangles` is the number of triangles of a triangulation.
    pub(crate) fn new(domain: &'a Domain, boundary: &'a PlanarBoundary, triangles: u32) -> Self {
        let after = boundary.runs();
        let runs = (0..).zip(after).map(|(v, &run)| [after[boundary.previous(v) as usize], run]);
        Self { domain, boundary, points: points(boundary), runs: runs.collect(), triangles }
    }

    /// Checks that triangles are a triangulation; of a map with all its lines.
    fn check(&self, triangles: &[[u32; 3]]) -> Result<(), String> {
        if self.domain.is_map() {
            let mesh = BoundaryMesh::with_triangles(self.domain, triangles.to_vec());
            return mesh.map(drop).map_err(|error| error.to_string());
        }
        let checked = check::triangulation(self.boundary, &[], triangles);
        checked.map(drop).map_err(|error| error.to_string())
    }

    /// Whether all vertices of a triangle are on one straight run of the rings.
    fn is_flat(&self, triangle: [u32; 3]) -> bool {
        let runs = triangle.map(|vertex| self.runs.get(vertex as usize));
        let [Some(a), Some(b), Some(c)] = runs else { return false };
        a.iter().any(|run| b.contains(run) && c.contains(run))
    }
}

/// The figures of one method's triangles. O(n log n).
pub(crate) fn figures(
    checker: &Checker<'_>,
    triangles: &[[u32; 3]],
    at_least: u32,
) -> MethodFigures {
    let defects = defects(checker, triangles);
    let degrees = degrees(checker.boundary, triangles);
    let qualities: Vec<TriangleQuality> =
        triangles.iter().map(|&triangle| quality(&checker.points, triangle)).collect();
    let measured = measured(degrees, &qualities, triangles);
    MethodFigures {
        vertices_above_least: measured
            .degree_histogram
            .iter()
            .filter(|&(&degree, _)| degree > at_least)
            .map(|(&degree, &vertices)| (degree, vertices))
            .collect(),
        valid: defects.is_empty(),
        defects,
        ..measured
    }
}

/// The figures of a mesh with points inside: `points` are those of the boundary, and then those inside. O(n log n).
pub(crate) fn figures_inside(
    domain: &Domain,
    boundary: &PlanarBoundary,
    points: &[DVec2],
    triangles: &[[u32; 3]],
) -> MethodFigures {
    let degrees = degrees_of(boundary, points.len(), triangles);
    let qualities: Vec<TriangleQuality> =
        triangles.iter().map(|&triangle| quality(points, triangle)).collect();
    // The lines of a map are looked at by those who made it.
    let checked = if domain.is_map() {
        Ok(())
    } else {
        let inner = &points[boundary.points().len()..];
        check::triangulation(boundary, inner, triangles).map(drop)
    };
    let defects = checked.err().map(|error| MethodDefect {
        kind: DefectKind::NotATriangulation,
        count: None,
        message: error.to_string(),
    });
    let defects: Vec<MethodDefect> = defects.into_iter().collect();
    MethodFigures { valid: defects.is_empty(), defects, ..measured(degrees, &qualities, triangles) }
}

/// The figures of triangles with these measures, whose vertices have these degrees: what can be
/// counted without knowing what a valid mesh is.
pub(crate) fn measured(
    degrees: impl IntoIterator<Item = u32>,
    qualities: &[TriangleQuality],
    triangles: &[[u32; 3]],
) -> MethodFigures {
    let histogram: DegreeHistogram = degrees.into_iter().collect();
    let summary = QualitySummary::of(qualities.iter().copied());
    let metrics = summary.as_ref().map(QualitySummary::by_name);
    let mut worst = WorstTriangles::new(WORST);
    (0..).zip(qualities).for_each(|(index, &quality)| worst.add(index, quality));
    MethodFigures {
        max_degree: histogram.max_degree(),
        degree_histogram: histogram.iter().collect(),
        min_angle: metrics.as_ref().map(|metrics| metrics["min_angle"].min),
        max_angle: metrics.as_ref().map(|metrics| metrics["max_angle"].max),
        metrics,
        share_below_degrees: summary.map(|it| it.shares_by_angle()).unwrap_or_default(),
        worst_triangles: ThinTriangle::listed(&worst, triangles),
        ..MethodFigures::default()
    }
}

/// The measures of one triangle of a mesh.
pub(crate) fn quality(points: &[DVec2], triangle: [u32; 3]) -> TriangleQuality {
    let [a, b, c] = triangle.map(|vertex| points[vertex as usize]);
    TriangleQuality::of(a, b, c)
}

/// The number of neighbours of every vertex of a boundary and inside it, those along edges of the boundary and of lines
/// included, in a list that need not be a triangulation.
pub(crate) fn degrees(boundary: &PlanarBoundary, triangles: &[[u32; 3]]) -> Vec<u32> {
    let vertices = boundary.points().len() + boundary.inner_points().len();
    degrees_of(boundary, vertices, triangles)
}

/// The same where there are so many vertices.
pub(crate) fn degrees_of(
    boundary: &PlanarBoundary,
    vertices: usize,
    triangles: &[[u32; 3]],
) -> Vec<u32> {
    let edges = (0..boundary.edge_count()).map(|edge| boundary.ends(edge));
    let sides = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let mut edges: Vec<[u32; 2]> =
        edges.chain(sides).map(|[a, b]| [a.min(b), a.max(b)]).filter(|[a, b]| a != b).collect();
    edges.sort_unstable();
    edges.dedup();
    let mut degrees = vec![0; vertices];
    for vertex in edges.into_iter().flatten() {
        degrees[vertex as usize] += 1;
    }
    degrees
}

/// The defects of a list, counted where possible.
fn defects(checker: &Checker<'_>, triangles: &[[u32; 3]]) -> Vec<MethodDefect> {
    let flat = triangles.iter().filter(|&&triangle| checker.is_flat(triangle)).count() as u64;
    let first = match checker.check(triangles) {
        Ok(()) if flat == 0 => return Vec::new(),
        Ok(()) => String::new(),
        Err(error) => error,
    };
    let expected = u64::from(checker.triangles);
    let found = triangles.len() as u64;
    let missing = expected.saturating_sub(found);
    let surplus = found.saturating_sub(expected);
    let s = |count: u64| if count == 1 { "" } else { "s" };
    let counted = [
        (
            DefectKind::FlatTriangles,
            flat,
            format!("{flat} flat triangle{}, with all vertices on one side", s(flat)),
        ),
        (
            DefectKind::MissingTriangles,
            missing,
            format!("{missing} of {expected} triangles missing"),
        ),
        (
            DefectKind::SurplusTriangles,
            surplus,
            format!("{surplus} triangle{} more than {expected}", s(surplus)),
        ),
    ];
    let counted = counted
        .into_iter()
        .filter(|&(_, count, _)| count > 0)
        .map(|(kind, count, message)| MethodDefect { kind, count: Some(count), message });
    let counted: Vec<MethodDefect> = counted.collect();
    if counted.is_empty() {
        let kind = DefectKind::NotATriangulation;
        vec![MethodDefect { kind, count: None, message: first }]
    } else {
        counted
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg::Side;
    use mindeg_core::verify;

    /// The figures of some triangles on a square of two intervals a side.
    fn square(triangles: &[[u32; 3]]) -> MethodFigures {
        let domain = Domain::rectangle(2.0, 2.0, vec![Side::count(2); 4]).unwrap();
        figures(&Checker::new(&domain, &domain.boundary().unwrap(), 6), triangles, 3)
    }

    /// A fan from vertex 1, the middle of the bottom.
    const FAN: [[u32; 3]; 6] = [[1, 2, 3], [1, 3, 4], [1, 4, 5], [1, 5, 6], [1, 6, 7], [1, 7, 0]];

    #[test]
    fn measures_a_triangulation() {
        let figures = square(&FAN);
        assert!(figures.valid && figures.defects.is_empty());
        assert_eq!(figures.max_degree, Some(7));
        assert_eq!(figures.degree_histogram, [(2, 2), (3, 5), (7, 1)].into());
        assert_eq!(figures.vertices_above_least, [(7, 1)].into());
        let smallest = 18.434_948_822_922_01;
        assert!((figures.min_angle.unwrap() - smallest).abs() < 1e-13);
        assert_eq!(figures.max_angle, Some(135.0));
        assert_eq!(figures.share_below_degrees[&10], 0.0);
        assert_eq!(figures.share_below_degrees[&20], 2.0 / 6.0);
        let worst: Vec<u32> = figures.worst_triangles.iter().map(|worst| worst.triangle).collect();
        assert_eq!(worst, [1, 4, 2, 3, 0]);
        assert_eq!(figures.worst_triangles[1].vertices, [1, 6, 7]);
    }

    #[test]
    fn counts_what_is_wrong() {
        let flat_instead = |count: usize| {
            let mut triangles = FAN;
            triangles[..count].fill([0, 1, 2]);
            triangles
        };
        for (triangles, defects) in [
            (&flat_instead(1)[..], &["1 flat triangle, with all vertices on one side"][..]),
            (&flat_instead(2), &["2 flat triangles, with all vertices on one side"]),
            (&FAN[1..], &["1 of 6 triangles missing"]),
            (
                &flat_instead(1)[..4],
                &["1 flat triangle, with all vertices on one side", "2 of 6 triangles missing"],
            ),
            (&[FAN, FAN].concat(), &["6 triangles more than 6"]),
            (&[FAN[0]; 6], &["two triangles lie on the same side of edge 1-2"]),
            (&[], &["6 of 6 triangles missing"]),
        ] {
            let figures = square(triangles);
            assert!(!figures.valid);
            let messages: Vec<&str> = figures.defects.iter().map(|d| &*d.message).collect();
            assert_eq!(messages, defects);
        }
    }

    #[test]
    fn degrees_of_what_is_no_triangulation_count_neighbors_once() {
        let ring = PlanarBoundary::of_mesh(&[[DVec2::ZERO; 8]]);
        let twice = [FAN[1], FAN[1], FAN[2]];
        assert_eq!(degrees(&ring, &twice), [2, 5, 2, 3, 3, 3, 2, 2]);
        let fan = degrees(&ring, &FAN);
        assert_eq!(fan, verify(&[2, 2, 2, 2], FAN).unwrap().degrees);
    }
}
