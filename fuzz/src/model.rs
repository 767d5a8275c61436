//! Models: in JSON as any text, and of any mesh. A valid model is meshed, and its triangles meet edge to
//! edge.

use arbitrary::Arbitrary;
use glam::DVec3;
use mindeg::model::mesh_model;
use mindeg::{FromMesh, Goal, Model, Progress, Side, TriMesh};

#[derive(Arbitrary, Debug)]
pub(crate) enum Input<'a> {
    Json(&'a str),
    Mesh { points: Vec<[i8; 3]>, triangles: Vec<[u8; 3]>, merge: bool, intervals: u8 },
}

pub(crate) fn run(input: Input<'_>) {
    let model = match input {
        Input::Json(text) => match Model::from_json(text) {
            Ok(model) => model,
            Err(error) => return assert!(!error.to_string().is_empty()),
        },
        Input::Mesh { points, triangles, merge, intervals } => {
            let count = points.len().min(30) as u8;
            if count == 0 {
                return;
            }
            let place = |at: &[i8; 3]| DVec3::from(at.map(|x| f64::from(x % 8)));
            let points = points.iter().take(30).map(place).collect();
            let triangles = triangles.iter().take(40).map(|t| t.map(|v| u32::from(v % count)));
            let Ok(mesh) = TriMesh::new(points, triangles.collect()) else { return };
            let with = FromMesh {
                edges: Side::count(u64::from(intervals % 4) + 1),
                merge_coplanar: merge,
                planar_tolerance: None,
            };
            match Model::of_mesh(&mesh, &with) {
                Ok(model) => model,
                Err(error) => return assert!(!error.to_string().is_empty()),
            }
        }
    };
    let n = model.vertex_count();
    assert!(model.face_count() > 0 && n > 2);
    let largest = (0..model.face_count()).map(|face| model.face_size(face)).max().unwrap_or(0);
    if n > 300 || largest > 60 {
        return;
    }
    assert_eq!(model.positions().len(), n as usize);
    assert!(model.positions().iter().all(|position| position.is_finite()));
    match mesh_model(&model, Goal::LeastDegree, 1.0, Progress::NONE) {
        Ok(meshed) => {
            assert!(meshed.mesh.triangles().iter().flatten().all(|&v| v < n));
            let degrees = meshed.mesh.degrees();
            assert_eq!(degrees.iter().copied().max(), Some(meshed.max_degree));
            assert!(meshed.max_degree >= meshed.lower_bound);
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}
