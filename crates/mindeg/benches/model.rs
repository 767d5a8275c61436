//! Models of many faces: columns of unit cubes on a square floor, as one surface.

use std::collections::BTreeMap;

use mindeg::glam::DVec3;
use mindeg::model::mesh_model;
use mindeg::{Goal, Model, ModelFace, ModelParts, Progress, Side};

fn main() {
    divan::main();
}

/// The surface of `across` by `across` columns, 1 to 3 high: about 4 faces a column.
fn columns(across: i32, intervals: u64) -> Model {
    let height = |x: i32, y: i32| {
        let is_inside = (0..across).contains(&x) && (0..across).contains(&y);
        if is_inside { 1 + (7 * x + 13 * y + x * y % 5) % 3 } else { 0 }
    };
    let mut corners = BTreeMap::new();
    let mut positions = Vec::new();
    let mut faces = Vec::new();
    let mut add = |quad: [[i32; 3]; 4]| {
        let corner = |at: [i32; 3]| {
            *corners.entry(at).or_insert_with(|| {
                positions.push(DVec3::from(at.map(f64::from)));
                positions.len() as u32 - 1
            })
        };
        faces.push(ModelFace { loops: vec![quad.map(corner).to_vec()], ..ModelFace::default() });
    };
    for (x, y) in (0..across).flat_map(|x| (0..across).map(move |y| (x, y))) {
        let top = height(x, y);
        let (u, v) = (x + 1, y + 1);
        add([[x, y, top], [u, y, top], [u, v, top], [x, v, top]]);
        add([[x, y, 0], [x, v, 0], [u, v, 0], [u, y, 0]]);
        for (neighbour, [a, b]) in [
            (height(u, y), [[u, y], [u, v]]),
            (height(x - 1, y), [[x, v], [x, y]]),
            (height(x, v), [[u, v], [x, v]]),
            (height(x, y - 1), [[x, y], [u, y]]),
        ] {
            for z in neighbour..top {
                let at = |[x, y]: [i32; 2], z| [x, y, z];
                add([at(a, z), at(b, z), at(b, z + 1), at(a, z + 1)]);
            }
        }
    }
    Model::new(ModelParts {
        corners: positions,
        faces,
        edges: Vec::new(),
        other_edges: Some(Side::count(intervals)),
        planar_tolerance: None,
    })
    .expect("a surface of squares")
}

#[divan::bench(args = [(16, 5), (54, 5), (54, 8)], sample_count = 3)]
fn columns_of_cubes(bencher: divan::Bencher<'_, '_>, (across, intervals): (i32, u64)) {
    let model = columns(across, intervals);
    bencher.bench(|| {
        mesh_model(&model, Goal::LeastDegree, 1.0, Progress::NONE).expect("every face is square")
    });
}
