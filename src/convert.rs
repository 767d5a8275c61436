//! `mindeg convert`: a mesh of any program into other formats.

use crate::args::ConvertArguments;
use crate::failure::Failure;
use crate::making::Making;
use mindeg_answers::mesh::ListedMesh;
use mindeg_files::with_boundary_lines;
use mindeg_mesh::Triangles;

pub(crate) fn run(arguments: &ConvertArguments) -> Result<(), Failure> {
    let mut making = Making::new(&arguments.surface, arguments.quiet, arguments.json)?;
    let mesh = making.read(&arguments.file)?;
    making.tell_dropped([&mesh]);
    making.check(&mesh, mesh.triangle_count())?;
    making.open()?;
    // If the file does not give the boundary, solvers still need it.
    let bounded = making.need_boundary().then(|| with_boundary_lines(mesh.clone()));
    let made = making.write_each(|format| match &bounded {
        Some(bounded) if format.has_boundary() => bounded,
        _ => &mesh,
    })?;
    let file = arguments.file.display().to_string();
    made.say(String::new, || ListedMesh::of(Some(file), &mesh))
}
