//! Meshes the faces of a box without a lid as one model, and closes its opening:
//!
//! ```text
//! cargo run -p mindeg --example close_a_box
//! ```

use std::error::Error;

use mindeg::fill::{FillOptions, fill};
use mindeg::model::mesh_model;
use mindeg::{Goal, Loops, Model, Progress};

fn main() -> Result<(), Box<dyn Error>> {
    let open_box = Model::from_json(
        r#"{"corners": [[0,0,0], [4,0,0], [4,3,0], [0,3,0], [0,0,2], [4,0,2], [4,3,2], [0,3,2]],
            "faces": [[0,3,2,1], [0,1,5,4], [1,2,6,5], [2,3,7,6], [3,0,4,7]],
            "size": 0.5}"#,
    )?;
    // Degrees are counted over all faces that meet at a vertex.
    let meshed = mesh_model(&open_box, Goal::LeastDegree, 1.0, Progress::NONE)?;
    println!("five faces: at most {} edges at a vertex", meshed.max_degree);
    println!("no mesh of these points has less than {}", meshed.lower_bound);

    let loops = Loops::of(&meshed.mesh);
    let closed = fill(meshed.mesh, &loops, &FillOptions::default(), Progress::NONE)?;
    for filled in &closed.filled {
        println!("the lid: {} triangles, area {:.3}", filled.triangles.len(), filled.area);
    }
    println!("all six: at most {} edges at a vertex", closed.max_degree);
    Ok(())
}
