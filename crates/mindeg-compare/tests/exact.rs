//! The exact trade-off beside Delaunay: two computations that share nothing.

use mindeg::Domain;
use mindeg_compare::{CompareOptions, Method, compare};
use std::fs;
use std::path::Path;

/// The solver compares angles to 36 bits, 1.5e-11; spade's angles carry the rounding of the
/// coordinates, which on a survey grid leaves about nine digits of an angle.
const SAME: f64 = 1e-7;

#[test]
fn the_curve_ends_at_the_delaunay_angle() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/domains");
    let mut compared = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let domain = Domain::from_json(&fs::read_to_string(&path).unwrap()).unwrap();
        // Comparisons take convex domains with straight sides.
        if domain.convex().is_none_or(|form| form.boundary().side_count() != domain.sides().len()) {
            continue;
        }
        let comparison = compare(&domain, &CompareOptions::default()).unwrap();
        let report = comparison.report();
        let Some(trade_off) = &report.trade_off else {
            assert!(report.domain.vertices > CompareOptions::default().exact_vertices, "{path:?}");
            continue;
        };
        let delaunay =
            report.methods.iter().find(|method| method.method == Method::DELAUNAY).unwrap();
        let last = trade_off.points.last().unwrap();
        let delaunay_angle = delaunay.min_angle.unwrap();
        assert!(
            (last.min_angle - delaunay_angle).abs() <= SAME * delaunay_angle,
            "{path:?}: {} against {delaunay_angle}",
            last.min_angle
        );
        assert!(last.max_degree <= delaunay.max_degree.unwrap(), "{path:?}");
        assert_eq!(
            Some(trade_off.points[0].max_degree),
            report.domain.least_max_degree,
            "{path:?}"
        );
        // The meshes of the report keep the promises of the curve.
        for point in &trade_off.points {
            let exact = Method::Exact { max_degree: point.max_degree };
            let Some(method) = report.methods.iter().find(|method| method.method == exact) else {
                continue;
            };
            assert!(method.valid && method.max_degree.unwrap() <= point.max_degree, "{path:?}");
            let angle = method.min_angle.unwrap();
            assert!((angle - point.min_angle).abs() <= SAME * angle, "{path:?}: {exact}");
        }
        compared += 1;
    }
    assert_eq!(compared, 7);
}
