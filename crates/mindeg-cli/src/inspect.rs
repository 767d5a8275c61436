//! `mindeg inspect`: what there is to say of a mesh file, whatever program wrote it.

mod report;
mod text;

use crate::args::InspectArguments;
use crate::bar::{Bar, Counting, Unit};
use crate::failure::Failure;
use crate::gates::NamedTriangle;
use crate::standard_output::{print, print_json};
use mindeg_geometry::import::{self, ImportError, TriMesh};
use mindeg_geometry::inspection::{Inspection, InspectionOptions};
use report::Report;
use std::fs::{self, File};
use std::io::{self, BufReader};
use std::path::{Component, Path};

pub(crate) fn run(arguments: &InspectArguments) -> Result<(), Failure> {
    let bar = Bar::new(false);
    let mesh = read(&arguments.file, &bar)?;
    let options = InspectionOptions {
        weld: !arguments.no_weld,
        pole_degree: arguments.poles_above,
        corner_angle: arguments.corner_angle,
    };
    let inspection = bar.waiting("inspecting", || Inspection::of(&mesh, &options));
    drop(bar);
    let name = arguments.file.display().to_string();
    let report = Report::new(name, &mesh, &inspection);
    let printed = if arguments.json {
        print_json(&report)
    } else {
        print(&text::text(&report, &inspection, &options))
    };
    // A gate holds whether somebody reads the report or not.
    let highest_vertex = || inspection.highest_degree.map_or(0, |highest| highest.vertex);
    let worst_triangle = || {
        let number = inspection.worst_triangles.first().map_or(0, |worst| worst.triangle);
        NamedTriangle { number, vertices: mesh.triangles()[number as usize] }
    };
    let passed =
        arguments.gates.check(report.max_degree, report.min_angle, highest_vertex, worst_triangle);
    passed.and(printed)
}

/// Reads a mesh by the extension of its file, and lets the bar count the bytes.
fn read(path: &Path, bar: &Bar) -> Result<TriMesh, Failure> {
    let extension = path.extension().map(|extension| extension.to_string_lossy().to_lowercase());
    let open = || -> Result<Counting<'_, File>, ImportError> {
        let file = File::open(path)?;
        let len = file.metadata()?.len();
        bar.stage("reading", len, Unit::Bytes);
        Ok(bar.counting(file, len))
    };
    let mesh = match extension.as_deref() {
        Some("obj") => {
            open().and_then(|file| import::obj::read(BufReader::with_capacity(1 << 16, file)))
        }
        Some("glb" | "gltf") => {
            open().and_then(|file| import::gltf::read(file, |name| read_beside(path, name)))
        }
        _ => {
            return Err(Failure::Input(format!(
                "{}: the name tells no format that can be read; it must end in .obj, .glb or \
                 .gltf",
                path.display()
            )));
        }
    };
    mesh.map_err(|error| match error {
        ImportError::Io(error) => Failure::Io(format!("cannot read {}: {error}", path.display())),
        ImportError::External { ref source, .. }
            if source.kind() != io::ErrorKind::InvalidInput =>
        {
            Failure::Io(format!("{}: {error}", path.display()))
        }
        error => Failure::Input(format!("{}: {error}", path.display())),
    })
}

/// Reads a file that a .gltf names, relative to it. A mesh has no business elsewhere, and it
/// may come from anywhere.
fn read_beside(path: &Path, name: &str) -> io::Result<Vec<u8>> {
    let name = Path::new(name);
    let stays = |part: Component<'_>| matches!(part, Component::Normal(_) | Component::CurDir);
    if !name.components().all(stays) {
        let problem = "it is not in the folder of the .gltf, and no other is looked into";
        return Err(io::Error::new(io::ErrorKind::InvalidInput, problem));
    }
    fs::read(path.with_file_name("").join(name))
}
