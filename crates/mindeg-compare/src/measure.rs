//! From points and a list of triangles to the figures of a report.
//!
//! Limits: takes any list whose vertices exist, valid or not. For invalid meshes
//! the figures describe the triangles given.

use crate::figures::{DefectKind, MethodDefect, MethodFigures};
use glam::DVec2;
use mindeg::quality::{DegreeHistogram, QualitySummary, TriangleQuality, WorstTriangles};
use mindeg_answers::inspected::ThinTriangle;
use mindeg_mesh::check;
use mindeg_mesh::planar::PlanarBoundary;

/// How many of the worst triangles are listed.
const WORST: usize = 5;

/// The reference that triangles of a domain are checked against.
pub(crate) struct Checker<'a> {
    boundary: &'a PlanarBoundary,
    /// For each vertex the straight runs that end and begin there.
    runs: Vec<[u32; 2]>,
}

impl<'a> Checker<'a> {
    pub(crate) fn new(boundary: &'a PlanarBoundary) -> Self {
        let after = boundary.runs();
        let runs = (0..).zip(after).map(|(v, &run)| [after[boundary.previous(v) as usize], run]);
        Self { boundary, runs: runs.collect() }
    }

    /// Whether all vertices of a triangle are on one straight run.
    fn is_flat(&self, triangle: [u32; 3]) -> bool {
        let [a, b, c] = triangle.map(|vertex| self.runs[vertex as usize]);
        a.iter().any(|run| b.contains(run) && c.contains(run))
    }

    /// The number of triangles of a triangulation.
    fn triangle_count(&self) -> u64 {
        (self.boundary.points().len() + 2 * self.boundary.ring_count() - 4) as u64
    }
}

/// The figures of one method's triangles. O(n log n).
pub(crate) fn figures(
    checker: &Checker<'_>,
    triangles: &[[u32; 3]],
    at_least: u32,
) -> MethodFigures {
    let points = checker.boundary.points();
    let defects = defects(checker, triangles);
    let degrees = degrees(checker.boundary, triangles);
    let qualities: Vec<TriangleQuality> =
        triangles.iter().map(|&triangle| quality(points, triangle)).collect();
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

/// The number of neighbours of every vertex of a boundary, its two on the boundary included, in a list
/// that need not be a triangulation.
pub(crate) fn degrees(boundary: &PlanarBoundary, triangles: &[[u32; 3]]) -> Vec<u32> {
    let edges = boundary.edges();
    let sides = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let mut edges: Vec<[u32; 2]> =
        edges.chain(sides).map(|[a, b]| [a.min(b), a.max(b)]).filter(|[a, b]| a != b).collect();
    edges.sort_unstable();
    edges.dedup();
    let mut degrees = vec![0; boundary.points().len()];
    for vertex in edges.into_iter().flatten() {
        degrees[vertex as usize] += 1;
    }
    degrees
}

/// The defects of a list, counted where possible.
fn defects(checker: &Checker<'_>, triangles: &[[u32; 3]]) -> Vec<MethodDefect> {
    let checked = check::triangulation(checker.boundary, &[], triangles);
    let flat = triangles.iter().filter(|&&triangle| checker.is_flat(triangle)).count() as u64;
    let first = match checked {
        Ok(_) if flat == 0 => return Vec::new(),
        Ok(_) => String::new(),
        Err(error) => error.to_string(),
    };
    let expected = checker.triangle_count();
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
    use mindeg::{Domain, Side};
    use mindeg_core::verify;

    /// The figures of some triangles on a square of two intervals a side.
    fn square(triangles: &[[u32; 3]]) -> MethodFigures {
        let domain = Domain::rectangle(2.0, 2.0, vec![Side::count(2); 4]).unwrap();
        figures(&Checker::new(&domain.boundary().unwrap()), triangles, 3)
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
