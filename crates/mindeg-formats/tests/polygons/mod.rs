//! Meshes of random polygons.

use mindeg::{BoundaryMesh, Domain};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// Least-degree meshes of polygons on an ellipse, some far from the origin, with all kinds of counts.
pub(crate) fn meshes() -> impl Strategy<Value = BoundaryMesh> {
    let side = (0.1..0.9, 1_u32..20);
    let place = prop_oneof![Just(0.0), Just(-3.7), Just(480_000.0), Just(4_650_000.3)];
    (prop::collection::vec(side, 3..9), 0.2..5.0, place.clone(), place).prop_map(
        |(sides, width, x, y)| {
            let k = sides.len() as f64;
            let corner = |(i, &(shift, _)): (usize, &(f64, u32))| {
                let angle = TAU * (i as f64 + shift) / k;
                format!("[{}, {}]", x + width * angle.cos(), y + angle.sin())
            };
            let corners: Vec<_> = sides.iter().enumerate().map(corner).collect();
            let counts: Vec<_> =
                sides.iter().map(|(_, count)| format!(r#"{{"intervals": {count}}}"#)).collect();
            let json = format!(
                r#"{{"polygon": {{"corners": [{}]}}, "sides": [{}]}}"#,
                corners.join(","),
                counts.join(",")
            );
            BoundaryMesh::least_degree(&Domain::from_json(&json).unwrap()).unwrap()
        },
    )
}
