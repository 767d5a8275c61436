//! From a surface to its mesh, and what was reached.

use crate::array_mesh::{Kind, NONE};
use crate::goal::Weights;
use crate::optimise::{Pairs, is_done, optimise};
use crate::options::Options;
use crate::stage::Stage;
use crate::surface::guard::is_far;
use crate::surface::mend::mend;
use crate::surface::passes::passes;
use crate::surface::reference::Reference;
use crate::surface::sectors::Sectors;
use crate::surface::work::{SurfaceMesh, compacted, work_mesh};
use crate::triangle::min_angle;
use crate::verdict::floor as floor_of;
use glam::DVec3;
use mindeg_mesh::{Cancelled, Progress, edges_of};
use mindeg_surfaces::{SizeRules, Surface};

/// The wishes for a mesh of a surface.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RemeshOptions {
    /// The edge length where neither curvature nor features ask for less, in units of length. `None`: the mean edge of
    /// the surface.
    pub size: Option<f64>,
    /// How far the mesh and the surface may be from each other, in units of length: the aim of the search, which samples
    /// distances and proves no bound. `None`: a fifth of the size.
    pub tolerance: Option<f64>,
    /// How far the middle of an edge may be from a bent surface, in units of length: the search wants edges that short.
    /// `None`: the tolerance, and at most 0.15 sizes.
    pub chord: Option<f64>,
    /// True if edges become up to three times as long where the surface is flat.
    pub curvature: bool,
    /// The minimum angle aimed at, in degrees. `None`: 35.
    pub target_angle: Option<f64>,
    /// True if the points of the boundary stay bit for bit, and no others come between them.
    pub keep_boundary: bool,
    /// The same for the curves that are not on the boundary.
    pub keep_features: bool,
}

/// A curve of a surface in its mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct RemeshedCurve {
    /// The curve of the surface.
    pub curve: u32,
    /// The edges of the mesh that it consists of, by their vertices.
    pub edges: Vec<[u32; 2]>,
}

/// A corner that allows no greater minimum angle.
#[derive(Debug, Clone, PartialEq)]
pub struct CornerLimit {
    /// The vertex of the mesh.
    pub vertex: u32,
    /// Where it is.
    pub at: DVec3,
    /// The angles between its curves, in degrees.
    pub sectors: Vec<f64>,
    /// No triangle at the least sector can have a greater minimum angle, in degrees.
    pub limit: f64,
}

/// A vertex whose degree is not as wanted.
#[derive(Debug, Clone, PartialEq)]
pub struct OffDegree {
    /// The vertex of the mesh.
    pub vertex: u32,
    /// Where it is.
    pub at: DVec3,
    /// Its edges.
    pub degree: u32,
    /// True if it lies on the boundary.
    pub is_boundary: bool,
    /// The number of curve edges that meet there.
    pub curves: u32,
    /// The least and the greatest number of triangles that its sectors between curves allow, as they are in the mesh, with no
    /// angle below the one aimed at. If the first is greater, or no wanted degree is between them, no search finds one.
    pub allowed: [u32; 2],
}

/// The figures that were reached.
#[derive(Debug, Clone, PartialEq)]
pub struct RemeshReport {
    /// The vertices with fewer than 5 or more than 7 edges, and those on the boundary with more than 5.
    pub off_degree: Vec<OffDegree>,
    /// The minimum angle, in degrees, and where it is.
    pub min_angle: f64,
    /// The centroid of the triangle with the minimum angle.
    pub min_angle_at: DVec3,
    /// The corners whose sectors allow less than the angle aimed at.
    pub corner_limits: Vec<CornerLimit>,
    /// The triangles of which a sample is farther from the surface than the tolerance, or that do not face it there.
    pub far_triangles: usize,
    /// The edge length and the tolerance that were used, in units of length.
    pub size: f64,
    /// The tolerance.
    pub tolerance: f64,
}

/// A mesh of a surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Remeshed {
    /// The points.
    pub points: Vec<DVec3>,
    /// Triangles that face as those of the surface do.
    pub triangles: Vec<[u32; 3]>,
    /// The patch of the surface that each triangle lies on.
    pub patches: Vec<u32>,
    /// For each point, a triangle of the surface that is near.
    pub sources: Vec<u32>,
    /// The curves of the surface, in order.
    pub curves: Vec<RemeshedCurve>,
    /// The figures that were reached.
    pub report: RemeshReport,
}

/// Why a surface was not meshed anew.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RemeshError {
    /// An option has no meaning.
    #[error("{0}")]
    BadOption(String),
    /// A mesh came out that is none. This is a defect of mindeg.
    #[error("the mesh fell apart: {0}; please report this surface")]
    BadMesh(String),
    /// The callback broke.
    #[error("cancelled")]
    Cancelled,
}

impl From<Cancelled> for RemeshError {
    fn from(_: Cancelled) -> Self {
        Self::Cancelled
    }
}

/// The tolerance without another wish, as a share of the size.
const TOLERANCE: f64 = 0.2;
/// How often degrees are mended by chains at most.
const MENDED: usize = 6;
/// The minimum angle aimed at without another wish, in degrees.
const FLOOR: f64 = 35.0;

/// Meshes a surface anew: every vertex off the boundary should have 5 to 7 edges, and angles be near 60 degrees.
///
/// Vertices on curves stay on them, corners stay where they are. What is wanted is sought, not guaranteed: the report says
/// what was reached. Equal input gives equal bytes.
///
/// ```
/// use glam::DVec3;
/// use mindeg_interior::{RemeshOptions, remesh};
/// use mindeg_mesh::Progress;
/// use mindeg_surfaces::{FeatureRules, Surface};
///
/// // A cube: bits 0 to 2 of a vertex are its x, y and z.
/// let at = |v: u32| DVec3::from([v & 1, v >> 1 & 1, v >> 2].map(f64::from));
/// let points: Vec<DVec3> = (0..8).map(at).collect();
/// let sides = [[0, 2, 1, 3], [4, 5, 6, 7], [0, 1, 4, 5], [2, 6, 3, 7], [0, 4, 2, 6], [1, 3, 5, 7]];
/// let triangles: Vec<[u32; 3]> = sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [b, d, c]]).collect();
/// let surface = Surface::new(&points, &triangles, &[], &FeatureRules::default())?;
/// let options = RemeshOptions { size: Some(0.2), ..RemeshOptions::default() };
/// let mesh = remesh(&surface, &options, Progress::NONE)?;
/// assert!(mesh.report.off_degree.is_empty() && mesh.report.min_angle > 30.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// If an option has no meaning, or `progress` breaks.
pub fn remesh(
    surface: &Surface,
    options: &RemeshOptions,
    progress: Progress<'_>,
) -> Result<Remeshed, RemeshError> {
    let size = options.size.unwrap_or_else(|| mean_edge(surface));
    let tolerance = options.tolerance.unwrap_or(TOLERANCE * size);
    let floor = options.target_angle.unwrap_or(FLOOR);
    let is_length = |x: f64| x.is_finite() && x > 0.0;
    let chord = options.chord.unwrap_or(tolerance);
    let are_lengths = [size, tolerance, chord].into_iter().all(is_length);
    if !(are_lengths && floor > 0.0 && floor < 60.0) {
        return Err(RemeshError::BadOption(format!(
            "size {size}, tolerance {tolerance} and chord {chord} must be positive lengths, and the target angle {floor} between 0 and 60"
        )));
    }
    let mut rules = match options.curvature {
        true => SizeRules::by_curvature(size),
        false => SizeRules::of_size(size),
    };
    rules.tolerance = rules.tolerance.min(chord);
    let mut stage = Stage::new(progress, "meshing the surface");
    stage.section(0.1);
    let fine = stage.through(1.0, |progress| surface.refined(&rules, progress))?;
    let curves = surface.curves().iter();
    let is_kept: Vec<bool> = curves
        .map(|c| if c.is_boundary() { options.keep_boundary } else { options.keep_features })
        .collect();
    let keeps = is_kept.contains(&true);
    let reference = Reference::new(fine, size, tolerance, is_kept);
    let wanted = Options::default();
    let single = Weights::single(&wanted, floor);
    // Refining divides curves, too.
    let start = if keeps { surface } else { &reference.surface };
    let mesh = work_mesh(&reference, start, &single).map_err(RemeshError::BadMesh)?;
    stage.section(0.5);
    let mesh = passes(mesh, &single, &mut stage)?.map_err(RemeshError::BadMesh)?;
    stage.section(0.8);
    searched(mesh, &wanted, floor, &mut stage)
}

/// Improves a mesh whose edges have their lengths already: degrees count over all patches, and angles. No edge of a curve
/// changes, and what is a corner or on a curve stays.
///
/// # Errors
///
/// If `progress` breaks.
///
/// # Example
///
/// ```
/// use glam::DVec3;
/// use mindeg_interior::{Options, improve_surface};
/// use mindeg_mesh::Progress;
/// use mindeg_surfaces::{FeatureRules, Surface};
///
/// // A square with a point in the middle, which has too few edges; the boundary does not allow more.
/// let points = [(0., 0.), (1., 0.), (1., 1.), (0., 1.), (0.4, 0.4)].map(|(x, y)| DVec3::new(x, y, 0.0));
/// let triangles = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
/// let surface = Surface::new(&points, &triangles, &[], &FeatureRules::default())?;
/// let found = improve_surface(&surface, &Options::default(), Progress::NONE)?;
/// assert!(points[..4].iter().all(|corner| found.points.contains(corner)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn improve_surface(
    surface: &Surface,
    options: &Options,
    progress: Progress<'_>,
) -> Result<Remeshed, RemeshError> {
    let (size, floor) = (mean_edge(surface), floor_of(options));
    let is_kept = vec![true; surface.curves().len()];
    let reference = Reference::new(surface.clone(), size, TOLERANCE * size, is_kept);
    let single = Weights::single(options, floor);
    let mesh = work_mesh(&reference, surface, &single).map_err(RemeshError::BadMesh)?;
    let mut stage = Stage::new(progress, "joining faces");
    stage.section(0.7);
    searched(mesh, options, floor, &mut stage)
}

/// The search for degrees and angles by single operations, then by pairs.
fn searched(
    mut mesh: SurfaceMesh<'_>,
    wanted: &Options,
    floor: f64,
    stage: &mut Stage<'_>,
) -> Result<Remeshed, RemeshError> {
    optimise(&mut mesh, &Weights::single(wanted, floor), None, stage)?;
    mesh = compacted(&mesh).map_err(RemeshError::BadMesh)?;
    stage.section(1.0);
    let angles = Weights::pairs(wanted, floor);
    let pairs = Pairs { vertices: 150, firsts: 6, trials: 0, most: 30_000 };
    if !is_done(&mesh, &angles) {
        for round in 0..MENDED {
            // Chains mend degrees and cost angles.
            if mend(&mut mesh, &angles, stage)? == 0 && round > 0 {
                break;
            }
            optimise(&mut mesh, &angles, Some(pairs), stage)?;
        }
        mesh = compacted(&mesh).map_err(RemeshError::BadMesh)?;
    }
    mesh.check().map_err(RemeshError::BadMesh)?;
    stage.reach(1.0)?;
    Ok(remeshed(&mesh, floor))
}

fn mean_edge(surface: &Surface) -> f64 {
    let at = |v: u32| surface.points()[v as usize];
    let edges = surface.triangles().iter().copied().flat_map(edges_of);
    let sum: f64 = edges.map(|[a, b]| at(a).distance(at(b))).sum();
    sum / (3 * surface.triangles().len()).max(1) as f64
}

/// The mesh, whose vertices and triangles are all alive, and its measures.
fn remeshed(mesh: &SurfaceMesh<'_>, floor: f64) -> Remeshed {
    let reference = mesh.space.0;
    let count = mesh.triangles.len() as u32;
    let angles = (0..count).map(|t| (min_angle(mesh.corners(t)), t));
    let (least, worst) = angles.fold((60.0, 0), |a, b| if b.0 < a.0 { b } else { a });
    let mut report = RemeshReport {
        off_degree: Vec::new(),
        min_angle: least,
        min_angle_at: mesh.corners(worst).iter().sum::<DVec3>() / 3.0,
        corner_limits: Vec::new(),
        far_triangles: (0..count).filter(|t| is_far(mesh, *t)).count(),
        size: reference.size,
        tolerance: reference.tolerance,
    };
    for (v, vertex) in (0..).zip(&mesh.vertices) {
        let sectors = Sectors::of(mesh, v);
        let is_boundary = !sectors.is_closed;
        let degree = vertex.triangles + u32::from(is_boundary);
        let [least, most] = if is_boundary { [2, 5] } else { [5, 7] };
        let at = vertex.at.at;
        if degree > most || degree < least {
            let edges = sectors.sectors.len() as u32 + u32::from(is_boundary);
            let curves = if vertex.kind == Kind::Free { 0 } else { edges };
            let allowed = sectors.allowed(floor);
            report.off_degree.push(OffDegree {
                vertex: v,
                at,
                degree,
                is_boundary,
                curves,
                allowed,
            });
        }
        if vertex.kind == Kind::Fixed && sectors.limit() < floor {
            let limit = sectors.limit();
            let sectors = sectors.sectors.iter().map(|sector| sector.angle).collect();
            report.corner_limits.push(CornerLimit { vertex: v, at, sectors, limit });
        }
    }
    let curves = reference.surface.curves().len() as u32;
    let mut curves: Vec<RemeshedCurve> =
        (0..curves).map(|curve| RemeshedCurve { curve, edges: Vec::new() }).collect();
    for (t, triangle) in (0..).zip(&mesh.triangles) {
        for i in (0..3).filter(|i| triangle.is_locked(*i)) {
            if triangle.neighbours[i] == NONE || triangle.neighbours[i] > t {
                let ends = [1, 2].map(|j| triangle.vertices[(i + j) % 3]);
                curves[triangle.labels[i].0 as usize].edges.push(ends);
            }
        }
    }
    Remeshed {
        points: mesh.vertices.iter().map(|vertex| vertex.at.at).collect(),
        triangles: mesh.triangles.iter().map(|t| t.vertices).collect(),
        patches: mesh.triangles.iter().map(|t| t.patch).collect(),
        sources: mesh.vertices.iter().map(|v| reference.surface.origin(v.at.near)).collect(),
        curves,
        report,
    }
}
