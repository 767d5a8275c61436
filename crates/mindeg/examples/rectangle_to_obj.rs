//! Meshes a rectangle and writes it as an OBJ to standard output:
//!
//! ```text
//! cargo run -p mindeg --example rectangle_to_obj > rectangle.obj
//! ```

use std::error::Error;
use std::io::stdout;

use mindeg::{BoundaryMesh, Domain, Side, Spacing};
use mindeg_formats::{SurfaceOptions, obj};

fn main() -> Result<(), Box<dyn Error>> {
    // Bottom, right, top and left. The bottom is dense at both ends.
    let bottom = Side::count(12).spaced(Spacing::Bump { ratio: 0.2 }).named("bottom");
    let sides = vec![bottom, Side::count(9), Side::count(4), Side::count(4)];
    let domain = Domain::rectangle(4.0, 3.0, sides)?.named("rectangle")?;

    let mesh = BoundaryMesh::least_degree(&domain)?;
    let angles = mesh.angle_range();
    eprintln!(
        "{} vertices, {} triangles, maximum degree {}, angles {:.3}° to {:.3}°",
        mesh.vertex_count(),
        mesh.triangle_count(),
        mesh.max_degree(),
        angles.min,
        angles.max,
    );
    obj::write(&mesh, &SurfaceOptions::default(), stdout())?;
    Ok(())
}
