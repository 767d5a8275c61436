//! `mindeg convert`: a mesh of any program into other formats.

use crate::args::ConvertArguments;
use crate::bar::Bar;
use crate::failure::Failure;
use crate::interrupt::clean_up_on_interrupt;
use crate::mesh_file;
use crate::output::Outputs;
use crate::targets::Targets;
use mindeg_mesh::Triangles;

pub(crate) fn run(arguments: &ConvertArguments) -> Result<(), Failure> {
    let options = arguments.surface.options();
    let mut targets = Targets::new(&arguments.output, arguments.format, options, false)?;
    let bar = Bar::new(arguments.quiet);
    clean_up_on_interrupt()?;
    let mesh = mesh_file::read(&arguments.file, &bar)?;
    targets.check(&mesh, mesh.triangle_count())?;
    let mut outputs = Outputs::default();
    targets.open(&mut outputs)?;
    let all_taken = targets.write(&mesh, &bar)?;
    outputs.finish()?;
    if all_taken { Ok(()) } else { Err(Failure::ClosedPipe) }
}
