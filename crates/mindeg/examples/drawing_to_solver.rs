//! Meshes a drawing with points inside and writes it for Gmsh and solvers to standard output:
//!
//! ```text
//! cargo run -p mindeg --example drawing_to_solver > plate.msh
//! ```

use std::error::Error;
use std::io::{self, stdout};

use mindeg::{Interior, Progress, interior};
use mindeg_formats::{Format, WriteOptions, write};
use mindeg_outlines::{Division, OutlineFormat, read};

/// A plate with a bore.
const DRAWING: &[u8] = b"<svg>
    <path id='plate' d='M 0 0 H 80 V 30 Q 60 50 40 50 H 0 Z M 20 25 a 10 10 0 0 0 20 0 a 10 10 0 0 0 -20 0'/>
</svg>";

fn main() -> Result<(), Box<dyn Error>> {
    // Files that a drawing refers to; this one has none.
    let beside = |_: &str| Err(io::ErrorKind::NotFound.into());
    let drawing = read(DRAWING, OutlineFormat::Svg, beside)?;
    let division = Division { size: Some(4.0), ..Division::default() };
    let domain = drawing.features[0].domain(&division)?;

    // Longer edges inside: each may be 0.2 longer for each unit of distance from the boundary.
    let wanted = Interior { growth: Some(0.2), ..Interior::default() };
    let found = interior::mesh(&domain, &wanted, Progress::NONE)?;
    let report = &found.report;
    eprintln!(
        "{} boundary points, {} inside, degrees {:?} there; minimum angle {:.3}°, no mesh of this boundary has more than {:.3}°",
        domain.rings().vertex_count(),
        report.interior_points,
        report.interior_degree,
        report.min_angle,
        found.limit.min_angle,
    );
    write(Format::Msh, &found.mesh, &WriteOptions::default(), stdout())?;
    Ok(())
}
