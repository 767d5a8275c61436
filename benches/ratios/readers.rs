//! Reading and inspecting a mesh, next to the libraries that read the same file.
//!
//! A library's time is for all it makes of the file: tobj's vectors of a model, and vectors filled
//! from the iterators of gltf.

use crate::clock::rounds;
use crate::{even, table};
use mindeg::inspection::{Inspection, InspectionOptions};
use mindeg_formats::{ReadError, SurfaceOptions, glb, obj};
use mindeg_mesh::TriMesh;
use std::hint::black_box;

pub(crate) fn print() {
    let columns =
        ["2 × 10⁶ triangles", "library", "mindeg reads", "inspects", "both / library (aim 2)"];
    table::head("Readers, ms", &columns);
    let mesh = even(2_000_000);
    let options = SurfaceOptions::default();
    let mut file = Vec::new();
    obj::write(&mesh, &options, &mut file).unwrap();
    print_row("OBJ, tobj", || drop(with_tobj(&file)), || obj::read(&file[..]));
    file.clear();
    glb::write(&mesh, &options, &mut file).unwrap();
    let no_files = |_: &str| Err(std::io::ErrorKind::Unsupported.into());
    print_row("GLB, gltf", || drop(with_gltf(&file)), || glb::read(&file[..], no_files));
}

fn print_row(name: &str, library: impl Fn(), read: impl Fn() -> Result<TriMesh, ReadError>) {
    let mesh = read().unwrap();
    let options = InspectionOptions::default();
    let [library, reads, inspects] = rounds(
        5,
        [&mut || library(), &mut || drop(black_box(read())), &mut || {
            drop(black_box(Inspection::of(&mesh, &options)))
        }],
    );
    let ms = |seconds: f64| format!("{:.0}", seconds * 1e3);
    table::row(&[
        name.to_owned(),
        ms(library),
        ms(reads),
        ms(inspects),
        table::at_most((reads + inspects) / library, 2.0),
    ]);
}

fn with_tobj(mut file: &[u8]) -> Vec<tobj::Model> {
    let options = tobj::LoadOptions::default();
    black_box(tobj::load_obj_buf(&mut file, &options, |_| Err(tobj::LoadError::GenericFailure)))
        .unwrap()
        .0
}

fn with_gltf(file: &[u8]) -> (Vec<[f32; 3]>, Vec<u32>) {
    let file = ::gltf::Gltf::from_slice(file).unwrap();
    let (mut positions, mut indices) = (Vec::new(), Vec::new());
    for primitive in file.meshes().flat_map(|mesh| mesh.primitives()) {
        let reader = primitive.reader(|_| file.blob.as_deref());
        positions.extend(reader.read_positions().unwrap());
        indices.extend(reader.read_indices().unwrap().into_u32());
    }
    black_box((positions, indices))
}
