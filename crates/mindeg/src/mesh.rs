//! `mindeg mesh`: from a domain to files.

use crate::args::{Format, MeshArguments, Optimize};
use crate::domain::domain;
use crate::failure::Failure;
use crate::output::{Outputs, cannot_write, clean_up_on_interrupt};
use crate::standard_output::print_json;
use crate::watched::watched;
use mindeg_compare::exact;
use mindeg_core::optimal_max_degree;
use mindeg_geometry::export::{ExportError, Plane, SurfaceOptions, gltf, obj, svg};
use mindeg_geometry::{Domain, Mesh};
use serde::Serialize;
use std::io::{self, Write};
use std::path::Path;

/// What `--json` prints; angles in degrees, an output for each `-o`. Degrees are total: edges
/// outside the domain count.
#[derive(Serialize)]
struct Summary {
    vertices: u32,
    triangles: u32,
    max_degree: u32,
    optimal_max_degree: u32,
    min_angle: f64,
    max_angle: f64,
    outputs: Vec<String>,
}

/// One `-o`, understood.
enum Target<'a> {
    StandardOutput(Stream),
    File(&'a Path, Stream),
    /// A .gltf and the .bin beside it.
    Gltf(&'a Path),
}

/// A format that is a single stream of bytes.
#[derive(Clone, Copy)]
enum Stream {
    Obj,
    Glb,
    Svg,
}

pub(crate) fn run(arguments: &MeshArguments) -> Result<(), Failure> {
    let targets = targets(arguments)?;
    let domain = domain(&arguments.domain)?;
    clean_up_on_interrupt()?;
    let (mesh, optimal_max_degree) = mesh(arguments, &domain)?;
    let angles = mesh.angle_range();
    arguments.gates.check_mesh(&mesh, angles.min)?;
    let options = SurfaceOptions {
        degree_colors: arguments.degree_colors,
        boundary_lines: arguments.boundary_lines,
        plane: if arguments.floor { Plane::Floor } else { Plane::Xy },
        ..SurfaceOptions::default()
    };

    let mut outputs = Outputs::default();
    for target in &targets {
        write(&mesh, &options, target, &mut outputs)?;
    }
    outputs.finish()?;

    let summary = Summary {
        vertices: mesh.vertex_count(),
        triangles: mesh.triangle_count(),
        max_degree: mesh.max_total_degree(),
        optimal_max_degree,
        min_angle: angles.min,
        max_angle: angles.max,
        outputs: arguments.output.iter().map(|path| path.display().to_string()).collect(),
    };
    if !arguments.quiet {
        // A summary that cannot be shown is no reason to fail: the files are there.
        let _ = io::stderr().write_all(text(&mesh, &summary).as_bytes());
    }
    if arguments.json { print_json(&summary) } else { Ok(()) }
}

/// The mesh that is asked for, and the least maximum degree that there is.
fn mesh(arguments: &MeshArguments, domain: &Domain) -> Result<(Mesh, u32), Failure> {
    let for_angle = arguments.optimize == Some(Optimize::Angle);
    if !for_angle && !domain.is_constrained() {
        let mesh = Mesh::least_degree(domain).map_err(|error| Failure::Input(error.to_string()))?;
        return Ok((mesh, optimal_max_degree(domain.boundary())));
    }
    let dispensable = if for_angle { "--optimize" } else { "outside_degree and max_degree" };
    let way_out = format!(
        "leave out {dispensable} for the mesh of least degree, which can be had at any size"
    );
    watched(arguments.quiet, &way_out, |watch| {
        let least = exact::optimal_max_degree(domain, watch)?;
        let allowed = arguments.gates.max_degree.filter(|_| for_angle);
        let exact = exact::mesh(domain, allowed.unwrap_or(least), watch)?;
        Ok((exact.mesh, least))
    })
}

fn text(mesh: &Mesh, summary: &Summary) -> String {
    let reversed = if mesh.domain().was_reversed() {
        "The corners ran clockwise and were reversed; each side kept its edge.\n"
    } else {
        ""
    };
    format!(
        "{}: {} vertices, {} triangles, maximum {}degree {} (least possible {}), angles {} to {}\n\
         {reversed}",
        mesh.domain().name().unwrap_or("mesh"),
        summary.vertices,
        summary.triangles,
        if mesh.domain().is_constrained() { "total " } else { "" },
        summary.max_degree,
        summary.optimal_max_degree,
        degrees(summary.min_angle),
        degrees(summary.max_angle),
    )
}

/// An angle as people read it; one too small for three decimals as a power of ten.
pub(crate) fn degrees(angle: f64) -> String {
    if angle < 0.01 { format!("{angle:.1e}°") } else { format!("{angle:.3}°") }
}

fn targets(arguments: &MeshArguments) -> Result<Vec<Target<'_>>, Failure> {
    let targets: Vec<Target<'_>> = arguments
        .output
        .iter()
        .map(|path| target(path, arguments.format))
        .collect::<Result<_, _>>()?;
    let to_standard_output =
        targets.iter().filter(|target| matches!(target, Target::StandardOutput(_))).count();
    if to_standard_output + usize::from(arguments.json) > 1 {
        let message = "standard output can take one mesh, or the summary of --json, not both";
        return Err(Failure::Input(message.to_owned()));
    }
    for (number, path) in arguments.output.iter().enumerate() {
        if arguments.output[..number].contains(path) {
            return Err(Failure::Input(format!("-o {} is given twice", path.display())));
        }
    }
    Ok(targets)
}

fn target(path: &Path, format: Option<Format>) -> Result<Target<'_>, Failure> {
    let is_standard_output = path == Path::new("-");
    let extension = path.extension().map(|extension| extension.to_string_lossy().to_lowercase());
    let by_extension = match extension.as_deref() {
        Some("obj") => Some(Format::Obj),
        Some("glb") => Some(Format::Glb),
        Some("gltf") => Some(Format::Gltf),
        Some("svg") => Some(Format::Svg),
        _ => None,
    };
    let stream = match by_extension.or(format) {
        Some(Format::Obj) => Stream::Obj,
        Some(Format::Glb) => Stream::Glb,
        Some(Format::Svg) => Stream::Svg,
        Some(Format::Gltf) if is_standard_output => {
            let message = "a .gltf has its .bin beside it, so it cannot go to standard output; \
                           use --format glb";
            return Err(Failure::Input(message.to_owned()));
        }
        Some(Format::Gltf) => return Ok(Target::Gltf(path)),
        None => {
            return Err(Failure::Input(format!(
                "-o {}: the name tells no format; end it in .obj, .glb, .gltf or .svg, or say \
                 --format",
                path.display()
            )));
        }
    };
    Ok(if is_standard_output { Target::StandardOutput(stream) } else { Target::File(path, stream) })
}

/// Writes one output.
fn write(
    mesh: &Mesh,
    options: &SurfaceOptions,
    target: &Target<'_>,
    outputs: &mut Outputs,
) -> Result<(), Failure> {
    let (path, written) = match *target {
        Target::StandardOutput(stream) => {
            let mut out = io::stdout().lock();
            let written = write_stream(mesh, options, stream, &mut out);
            return written.and_then(|()| Ok(out.flush()?)).map_err(|error| match error {
                ExportError::Io(error) => Failure::from_standard_output(&error),
                refusal => Failure::Input(refusal.to_string()),
            });
        }
        Target::File(path, stream) => {
            (path, write_stream(mesh, options, stream, outputs.create(path)?))
        }
        Target::Gltf(path) => {
            let binary = path.with_extension("bin");
            let name = binary.file_name().unwrap_or_default().to_string_lossy().into_owned();
            let (file, binary) = (outputs.create(path)?, outputs.create(&binary)?);
            (path, gltf::write_gltf(mesh, options, &name, file, binary))
        }
    };
    written.map_err(|error| match error {
        ExportError::Io(error) => cannot_write(path, &error),
        refusal => Failure::Input(format!("{}: {refusal}", path.display())),
    })
}

fn write_stream(
    mesh: &Mesh,
    options: &SurfaceOptions,
    stream: Stream,
    out: impl Write,
) -> Result<(), ExportError> {
    match stream {
        Stream::Obj => Ok(obj::write(mesh, options, out)?),
        Stream::Glb => gltf::write_glb(mesh, options, out),
        Stream::Svg => svg::write(mesh, out),
    }
}
