//! Fills the buffers that a graphics card takes: positions as 32-bit floats and indices.
//!
//! ```text
//! cargo run -p mindeg --example gpu_buffers
//! ```

use std::error::Error;

use mindeg::glam::DVec2;
use mindeg::{BoundaryMesh, Domain, Side};

fn main() -> Result<(), Box<dyn Error>> {
    // Survey coordinates, in metres.
    let corners = [[500_000.0, 4_650_000.0], [500_080.0, 4_650_010.0], [500_030.0, 4_650_070.0]];
    let domain = Domain::polygon(corners, vec![Side::size(0.01); 3])?;
    let mesh = BoundaryMesh::least_degree(&domain)?;

    let mut points = vec![DVec2::ZERO; mesh.vertex_count() as usize];
    mesh.fill_points(0, &mut points);
    // 32-bit floats have seven digits: they are for offsets from a point nearby.
    let origin = domain.placement().bounds().center();
    let positions: Vec<[f32; 3]> =
        points.iter().map(|&point| (point - origin).as_vec2().extend(0.0).to_array()).collect();

    let mut indices = vec![[0_u32; 3]; mesh.triangle_count() as usize];
    mesh.fill_triangles(0, &mut indices);

    println!("origin {origin}");
    println!("vertex buffer: {} positions, {} bytes", positions.len(), size_of_val(&positions[..]));
    println!("index buffer: {} triangles, {} bytes", indices.len(), size_of_val(&indices[..]));
    println!("first triangle: {:?}", indices[0].map(|vertex| positions[vertex as usize]));
    for side in 0..domain.sides().len() {
        let vertices: Vec<u32> = mesh.side_vertices(side).collect();
        let (first, last) = (vertices[0], vertices[vertices.len() - 1]);
        println!("{}: {} vertices from {first} to {last}", domain.side_name(side), vertices.len());
    }
    Ok(())
}
