//! Every reader of meshes: the first byte tells the format, the rest is the file, and after each "%%%" one
//! beside it. What is read is a mesh: it can be inspected and written in every format that takes it.

use mindeg_formats::{Format, WriteOptions, Writer, read, read_as, with_boundary_lines};
use mindeg_mesh::inspection::{Inspection, InspectionOptions};
use mindeg_mesh::{Progress, TriMesh, Triangles};
use std::io;
use std::path::Path;

/// The file, and those beside it.
fn parted(mut bytes: &[u8]) -> Vec<&[u8]> {
    let mut parts = Vec::new();
    while let Some(at) = bytes.windows(3).position(|three| three == b"%%%") {
        parts.push(&bytes[..at]);
        bytes = &bytes[at + 3..];
    }
    parts.push(bytes);
    parts
}

pub(crate) fn run(file: &[u8]) {
    let Some((&first, bytes)) = file.split_first() else { return };
    let format = Format::READ[usize::from(first) % Format::READ.len()];
    let name = format!("a.{}", format.extension());
    let _ = read(Path::new("a"), bytes, |_| Err(io::ErrorKind::NotFound.into()));
    let parts = parted(bytes);
    let beside = |name: &str| {
        let index = if name.ends_with(".poly") { 2 } else { 1 };
        parts.get(index).map(|part| part.to_vec()).ok_or(io::ErrorKind::NotFound.into())
    };
    let Ok(mesh) = read_as(format, Path::new(&name), parts[0], beside) else { return };
    assert!(mesh.positions().iter().all(|position| position.is_finite()));
    let _ = Inspection::of(&mesh, &InspectionOptions::default());
    let bounded = with_boundary_lines(mesh.clone());
    for target in Format::WRITTEN {
        written(target, &bounded);
    }
    // OBJ keeps all data of the triangles.
    let obj = &written(Format::Obj, &mesh).expect("OBJ takes any mesh")[0];
    let again = mindeg_formats::obj::read(&obj[..]).expect("what is written can be read");
    assert_eq!(again.triangles(), mesh.triangles());
    assert_eq!(again.positions(), mesh.positions());
}

fn written(format: Format, mesh: &TriMesh) -> Option<Vec<Vec<u8>>> {
    let writer = Writer::new(format, WriteOptions::default(), mesh, mesh.triangle_count()).ok()?;
    let mut files: Vec<(&str, Vec<u8>)> =
        vec![("a", Vec::new()); format.files(Path::new("a")).len()];
    writer.write(mesh, &mut files, Progress::NONE).ok()?;
    Some(files.into_iter().map(|(_, bytes)| bytes).collect())
}
