//! From the body of a request to the lines of its answer, the fast ones first.

use std::time::{Duration, Instant};

use mindeg::exact::ExactError;
use mindeg::{BoundaryMesh, Domain, Meshed};
use mindeg_delaunay::of_rings;
use mindeg_mesh::{Cancelled, Progress};

use crate::api::{Goal, Line, Part, Request, View};
use crate::shown::{self, Figure};

/// The most boundary vertices of a domain.
pub const MAX_VERTICES: u32 = 20_000;

type Out<'a> = &'a mut dyn FnMut(&Line);

/// Answers a request: its lines go to `out` one by one, the last of them [`Line::Done`], unless the request
/// or its domain is refused.
///
/// # Errors
///
/// [`Cancelled`], if the `progress` callback breaks.
///
/// # Example
///
/// ```
/// use mindeg_explore::{Line, answer};
/// use mindeg_mesh::Progress;
///
/// let body = br#"{"domain": {"rectangle": {"width": 4, "height": 3}, "size": 0.5}, "show": ["wanted"]}"#;
/// let mut degree = None;
/// answer(body, Progress::NONE, &mut |line| {
///     if let Line::Mesh(mesh) = line {
///         degree = Some(mesh.max_degree);
///     }
/// })?;
/// assert_eq!(degree, Some(4));
/// # Ok::<(), mindeg_mesh::Cancelled>(())
/// ```
pub fn answer(body: &[u8], progress: Progress<'_>, out: Out<'_>) -> Result<(), Cancelled> {
    let start = Instant::now();
    let request = match read(body) {
        Ok(request) => request,
        Err(line) => {
            out(&line);
            return Ok(());
        }
    };
    let domain = match domain(&request) {
        Ok(domain) => domain,
        Err(line) => {
            out(&line);
            return Ok(());
        }
    };
    out(&Line::Domain(shown::domain(&domain)));
    let shows = |part| request.show.contains(&part);
    if (shows(Part::Wanted) || shows(Part::Least))
        && let Ok(mesh) = BoundaryMesh::least_degree(&domain)
    {
        let figure = Figure::of(&mesh);
        for (view, part) in [(View::Wanted, Part::Wanted), (View::Least, Part::Least)] {
            if shows(part) {
                out(&Line::Mesh(Box::new(figure.shown(view, false, &request))));
            }
        }
    }
    if shows(Part::Delaunay) {
        delaunay(&domain, &request, progress, out)?;
    }
    for (part, view, goal) in
        [(Part::Wanted, View::Wanted, request.goal), (Part::Least, View::Least, Goal::LeastDegree)]
    {
        if shows(part) {
            match meshed(&domain, goal, progress) {
                Ok(meshed) => {
                    let figure = Figure::of(&meshed.mesh);
                    out(&Line::Mesh(Box::new(figure.shown(view, true, &request))));
                }
                Err(error) => {
                    unless_cancelled(progress)?;
                    out(&refused(Some(part), error.to_string()));
                }
            }
        }
    }
    out(&Line::Done { milliseconds: 1e3 * start.elapsed().as_secs_f64() });
    Ok(())
}

/// What is said when the time of an answer is over.
pub(crate) fn late(limit: Duration) -> Line {
    refused(
        None,
        format!(
            "it took more than {} s and was ended; the command line has no limit",
            limit.as_secs()
        ),
    )
}

fn refused(part: Option<Part>, message: String) -> Line {
    Line::Refused { part, message, path: None }
}

fn read(body: &[u8]) -> Result<Request, Box<Line>> {
    serde_json::from_slice(body)
        .map_err(|error| format!("the request is not what the page sends: {error}"))
        .map_err(|message| Box::new(refused(None, message)))
}

fn domain(request: &Request) -> Result<Domain, Box<Line>> {
    let domain = Domain::from_json(request.domain.get()).map_err(|error| {
        let message = error.to_string();
        Box::new(Line::Refused { part: None, message, path: Some(error.path) })
    })?;
    let vertices = domain.rings().vertex_count();
    if vertices > MAX_VERTICES {
        let message = format!(
            "the domain has {vertices} boundary vertices; the page takes up to {MAX_VERTICES}, the \
             command line any number"
        );
        return Err(Box::new(refused(None, message)));
    }
    Ok(domain)
}

/// Whether the work was cancelled, which is one of the errors of each step.
fn unless_cancelled(progress: Progress<'_>) -> Result<(), Cancelled> {
    progress.report("answering", 0, 1)
}

fn meshed(domain: &Domain, goal: Goal, progress: Progress<'_>) -> Result<Meshed, ExactError> {
    mindeg::mesh(domain, goal.into(), progress)
}

fn delaunay(
    domain: &Domain,
    request: &Request,
    progress: Progress<'_>,
    out: Out<'_>,
) -> Result<(), Cancelled> {
    let points: Vec<_> = domain.placement().points().collect();
    let rings: Vec<_> = domain.rings().rings().collect();
    let mesh = of_rings(&points, &rings, &[], &[], progress);
    unless_cancelled(progress)?;
    let mesh = mesh
        .map_err(|error| error.to_string())
        .and_then(|list| BoundaryMesh::with_triangles(domain, list).map_err(|e| e.to_string()));
    match mesh {
        Ok(mesh) => {
            out(&Line::Mesh(Box::new(Figure::of(&mesh).shown(View::Delaunay, true, request))));
        }
        Err(message) => out(&refused(Some(Part::Delaunay), message)),
    }
    Ok(())
}
