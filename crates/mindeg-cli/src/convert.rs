//! `mindeg convert`: a mesh of any program into other formats.

use crate::args::ConvertArguments;
use crate::bar::Bar;
use crate::failure::Failure;
use crate::interrupt::clean_up_on_interrupt;
use crate::mesh_file;
use crate::output::Outputs;
use crate::targets::Targets;
use crate::terminal::say;
use mindeg_formats::with_boundary_lines;
use mindeg_mesh::Triangles;

pub(crate) fn run(arguments: &ConvertArguments) -> Result<(), Failure> {
    let surface = &arguments.surface;
    let mut targets = Targets::new(&surface.output, surface.format, surface.options(), false)?;
    let bar = Bar::new(arguments.quiet);
    clean_up_on_interrupt()?;
    let mesh = mesh_file::read(&arguments.file, &bar)?;
    targets.expect_materials(mesh.has_materials());
    targets.check(&mesh, mesh.triangle_count())?;
    let mut outputs = Outputs::default();
    targets.open(&mut outputs)?;
    let files = targets.files();
    // Where the file does not tell the boundary, solvers still need it.
    let bounded = targets.need_boundary().then(|| with_boundary_lines(mesh.clone()));
    targets.write_each(
        |format| match &bounded {
            Some(bounded) if format.has_boundary() => bounded,
            _ => &mesh,
        },
        outputs,
        &bar,
    )?;
    drop(bar);
    let files: Vec<_> = files.into_iter().filter(|file| file != "-").collect();
    if !arguments.quiet && !files.is_empty() {
        say(&format!("wrote {}", files.join(", ")));
    }
    Ok(())
}
