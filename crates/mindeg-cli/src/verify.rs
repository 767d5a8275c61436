//! `mindeg verify`: whether a mesh is a triangulation of a domain, and how good it is.

mod report;

use crate::args::VerifyArguments;
use crate::bar::Bar;
use crate::demands::met;
use crate::domain::{from_file, from_options, name_in_text};
use crate::failure::Failure;
use crate::interrupt::clean_up_on_interrupt;
use crate::making::read_mesh;
use crate::mesh::unsolved;
use crate::standard_output::{print, print_json};
use mindeg::quality::TriangleQuality;
use mindeg::verify::{self, Optimality, VerifiedMesh};
use mindeg::{Domain, Interior, Progress, exact, interior};
use mindeg_answers::demands::WorstPlaces;
use mindeg_answers::numbers::{percent, steady_angle};
use mindeg_files::is_domain_name;
use mindeg_mesh::TriMesh;
use report::{Angles, Report};

/// Up to this many boundary points the largest possible angle is worked out.
const MOST_VERTICES: u32 = 1_000_000;

pub(crate) fn run(arguments: &VerifyArguments) -> Result<(), Failure> {
    clean_up_on_interrupt()?;
    check_order(arguments)?;
    let domain = match &arguments.domain {
        Some(path) => from_file(path, &arguments.options)?,
        None => from_options(&arguments.options)?,
    };
    let bar = Bar::new(arguments.quiet);
    let mesh = read_mesh(&arguments.file, None, &bar)?;
    let file = arguments.file.display().to_string();
    let checked = bar.waiting("matching the mesh to the domain", || {
        verify::triangulation(&mesh, &domain, arguments.tolerance)
    });
    let verified = match checked {
        Ok(verified) => verified,
        Err(defect) if defect.kind == "tolerance_too_large" => {
            return Err(Failure::Input(defect.message));
        }
        Err(defect) => {
            drop(bar);
            let message =
                format!("{file} is no triangulation of {}: {defect}", name_in_text(&domain));
            if arguments.json {
                print_json(&Report::invalid(&file, &domain, &defect))?;
            }
            return Err(Failure::Gate(message));
        }
    };
    let (optimality, angles) = bar.work(|progress| {
        let optimality = verify::optimality(&verified, &domain, progress)
            .map_err(|error| unsolved(&error, "leave out --optimal"))?;
        Ok::<_, Failure>((optimality, angles(&verified, &domain, progress)))
    })?;
    drop(bar);

    let mut failed = failed(arguments, &verified, &optimality, &angles);
    let preset = arguments.demands.preset.preset;
    failed.extend(preset.and_then(|preset| preset.broken_by(&unified(&mesh, &verified))));
    let report = Report::of(&file, &domain, &verified, &optimality, angles, &failed);
    if arguments.json { print_json(&report) } else { print(&report.text()) }?;
    met(&failed)
}

/// Refuses a domain where the mesh is expected.
fn check_order(arguments: &VerifyArguments) -> Result<(), Failure> {
    if !is_domain_name(&arguments.file) {
        return Ok(());
    }
    let file = arguments.file.display();
    Err(Failure::Input(match &arguments.domain {
        Some(mesh) => {
            let mesh = mesh.display();
            format!("{file} is a domain; swap the two: mindeg verify {mesh} {file}")
        }
        None => {
            format!("{file} is a domain; give the mesh before it: mindeg verify mesh.obj {file}")
        }
    }))
}

/// The angles of a mesh, and the largest minimum angle that one could have.
fn angles(verified: &VerifiedMesh, domain: &Domain, progress: Progress<'_>) -> Angles {
    let quality = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(|v| verified.points[v as usize]);
        TriangleQuality::of(a, b, c)
    };
    let mut found = Angles { min: f64::INFINITY, triangle: 0, max: 0.0, limit: None };
    for (index, quality) in verified.triangles.iter().map(quality).enumerate() {
        if quality.min_angle < found.min {
            (found.min, found.triangle) = (quality.min_angle, index);
        }
        found.max = found.max.max(quality.max_angle);
    }
    let boundary_points = domain.rings().vertex_count();
    if boundary_points > MOST_VERTICES {
        return found;
    }
    found.limit = if verified.interior_points == 0 {
        exact::delaunay_min_angle(domain, progress).ok()
    } else {
        // Meshes of its kind have at most the boundary degree of this mesh.
        let inside = |vertex: u32| {
            verified.degrees[vertex as usize].saturating_sub(domain.external_degree(vertex))
        };
        let boundary_degree = (0..boundary_points).map(inside).max();
        let wanted = Interior { boundary_degree, ..Interior::default() };
        interior::angle_limit(domain, &wanted).ok().map(|limit| limit.min_angle)
    };
    found
}

/// The limits that the mesh fails, in words.
fn failed(
    arguments: &VerifyArguments,
    verified: &VerifiedMesh,
    optimality: &Optimality,
    angles: &Angles,
) -> Vec<String> {
    let mut failed = Vec::new();
    let vertex_of = |point: u32| verified.vertex_of[point as usize];
    if let Some(&point) = verified.above_limit.first() {
        let (vertex, degree) = (vertex_of(point), verified.degrees[point as usize]);
        let more = match verified.above_limit.len() - 1 {
            0 => String::new(),
            1 => ", and 1 vertex more does".to_owned(),
            more => format!(", and {more} vertices more do"),
        };
        failed.push(format!(
            "vertex {vertex} has {degree} edges, more than the domain allows at boundary point \
             {point}{more}"
        ));
    }
    let triangle = angles.triangle;
    failed.extend(arguments.demands.demands().unmet(verified.max_degree, angles.min, || {
        let corners = verified.triangles.get(triangle).copied().unwrap_or_default();
        WorstPlaces {
            vertex: Some(report::highest_vertex(verified)),
            triangle: Some((triangle as u32, corners.map(vertex_of))),
        }
    }));
    if let Some(share) = arguments.keep_angle {
        match angles.share() {
            Some(found) if found >= share => {}
            Some(found) => failed.push(format!(
                "triangle {triangle} has an angle of {}, {} of the largest possible minimum; \
                 --keep-angle asks for {}",
                steady_angle(angles.min),
                percent(found),
                percent(share)
            )),
            None => failed.push(
                "the largest possible minimum angle is not known, which --keep-angle asks for"
                    .to_owned(),
            ),
        }
    }
    if arguments.optimal {
        match optimality {
            Optimality::Optimal { .. } => {}
            Optimality::Improvable { reached, .. } => failed.push(format!(
                "its maximum degree is {}, and a mesh with {reached} exists; --optimal asks for the \
                 least",
                verified.max_degree
            )),
            Optimality::Unknown { reason } => failed
                .push(format!("--optimal asks for a proof, and whether it is optimal is unknown: {reason}")),
        }
    }
    failed
}

/// The mesh with one vertex at each point, under the mesh's own indices.
fn unified(mesh: &TriMesh, verified: &VerifiedMesh) -> TriMesh {
    let triangles =
        verified.triangles.iter().map(|corners| corners.map(|v| verified.vertex_of[v as usize]));
    TriMesh::new(mesh.positions().to_vec(), triangles.collect())
        .expect("positions and triangles are those of a mesh")
}
