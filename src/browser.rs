//! The user's browser.

use crate::bar::Bar;
use crate::failure::Failure;
use crate::interrupt::SESSION;
use crate::provenance::provenance;
use crate::terminal::say;
use mindeg::glam::DVec3;
use mindeg_compare::write_view;
use mindeg_files::{Outputs, write_to};
use mindeg_mesh::{Mesh, TriMesh, filled};
use std::env;
use std::path::Path;
use std::process::{Command, Stdio};

/// Shows a mesh as a page in the folder for temporary files, named after the file that the mesh was written to.
pub(crate) fn show(mesh: &dyn Mesh, file: &str, bar: &Bar) -> Result<(), Failure> {
    let stem = Path::new(file).file_stem().and_then(|stem| stem.to_str());
    let stem = stem.filter(|stem| *stem != "-").unwrap_or("mesh");
    let page = env::temp_dir().join(format!("mindeg-{stem}.html"));
    let mut outputs = Outputs::new(&SESSION);
    let out = outputs.open(&page)?;
    let listed = listed(mesh)?;
    let made_by = provenance(None);
    bar.waiting(format!("making a view of {stem}"), || {
        write_to(&page, out, |out| write_view(&listed, &made_by, out))
    })?;
    outputs.finish()?;
    let is_open = open(&page.display().to_string());
    let problem = if is_open { "" } else { "; no browser was found, open it yourself" };
    say(&format!("view: {}{problem}", page.display()));
    Ok(())
}

/// A mesh as a list.
pub(crate) fn listed(mesh: &dyn Mesh) -> Result<TriMesh, Failure> {
    let positions = filled(0..mesh.vertex_count(), DVec3::ZERO, |first, out| {
        mesh.fill_positions(first, out);
    });
    let triangles = filled(0..mesh.triangle_count(), [0; 3], |first, out| {
        mesh.fill_triangles(first, out);
    });
    let listed = TriMesh::new(positions, triangles).map_err(Failure::input)?;
    Ok(listed.called(mesh.name()))
}

/// Opens an address or a file in the user's browser; false if no program can do it.
pub(crate) fn open(address: &str) -> bool {
    let mut command = if cfg!(target_os = "macos") {
        Command::new("open")
    } else if cfg!(windows) {
        // `start` takes its first argument in quotes for a title.
        let mut command = Command::new("cmd");
        command.args(["/C", "start", ""]);
        command
    } else {
        Command::new("xdg-open")
    };
    command.arg(address).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.spawn().is_ok()
}
