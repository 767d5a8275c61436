//! The meshes of a domain that the page shows and downloads.

use std::time::Duration;

use mindeg::MeshError;
use mindeg::interior::{self, InteriorError, InteriorMesh};
use mindeg::{Domain, Goal, Mesh, Meshed, TriMesh};
use mindeg_answers::advice::{MOST_POINTS, advised_interior};
use mindeg_compare::Reference;
use mindeg_mesh::{Bounds, Progress, significant};

use crate::api::{Request, View};

/// How long a Delaunay triangulation may take.
const DELAUNAY_TIME: Duration = Duration::from_secs(20);

/// A mesh that follows a corner while it moves has about so many points at most: what is more, a browser without a graphics card draws too
/// slowly.
const DRAFT_POINTS: usize = 1200;

/// A mesh, and how it was found.
pub(crate) enum Made {
    /// A mesh of boundary points alone, for a goal.
    Boundary(Box<Meshed>, Goal),
    /// A Delaunay triangulation.
    Delaunay(Box<TriMesh>),
    /// With interior points.
    Interior(Box<InteriorMesh>),
}

impl Made {
    /// The mesh of a view.
    ///
    /// # Errors
    ///
    /// The reason why the mesh is missing, in a sentence; also if `progress` cancels.
    pub(crate) fn new(
        domain: &Domain,
        request: &Request,
        view: View,
        progress: Progress<'_>,
    ) -> Result<Self, String> {
        let boundary = |goal: Goal| {
            mindeg::mesh(domain, goal, progress)
                .map(|meshed| Self::Boundary(Box::new(meshed), goal))
                .map_err(|error: MeshError| error.to_string())
        };
        match view {
            View::Wanted => boundary(request.goal),
            View::Least => boundary(Goal::LeastDegree),
            View::Delaunay => delaunay(domain).map(|mesh| Self::Delaunay(Box::new(mesh))),
            View::Interior => {
                Self::interior(domain, None, progress).map_err(|error| no_interior(&error))
            }
        }
    }

    /// The mesh with points inside; `show` gets a draft of it, soon.
    ///
    /// # Errors
    ///
    /// The errors of [`interior::mesh_showing`].
    pub(crate) fn interior(
        domain: &Domain,
        show: Option<&mut dyn FnMut(TriMesh)>,
        progress: Progress<'_>,
    ) -> Result<Self, InteriorError> {
        let found = interior::mesh_showing(domain, &advised_interior(domain), show, progress)?;
        Ok(Self::Interior(Box::new(found)))
    }

    /// A mesh with points inside that takes milliseconds.
    ///
    /// # Errors
    ///
    /// The errors of [`interior::draft`].
    pub(crate) fn draft(domain: &Domain, progress: Progress<'_>) -> Result<TriMesh, InteriorError> {
        interior::draft(domain, &advised_interior(domain), DRAFT_POINTS, progress)
    }

    /// For writers.
    pub(crate) fn mesh(&self) -> &dyn Mesh {
        match self {
            Self::Boundary(meshed, _) => &meshed.mesh,
            Self::Delaunay(mesh) => &**mesh,
            Self::Interior(found) => &found.mesh,
        }
    }
}

/// Why there is no mesh with points inside, in a sentence.
pub(crate) fn no_interior(error: &InteriorError) -> String {
    match error {
        InteriorError::TooManyPoints { max: MOST_POINTS } => format!(
            "It has more than {MOST_POINTS} points, more than the page shows. The command on this page \
             makes it; a larger size inside, with a larger growth, gives fewer points."
        ),
        error => error.to_string(),
    }
}

/// A size inside that gives fewer points, if there are too many for the page and it is not that large already: ten edges go across
/// the domain.
pub(crate) fn coarser(domain: &Domain, error: &InteriorError) -> Option<f64> {
    let InteriorError::TooManyPoints { max: MOST_POINTS } = error else { return None };
    let count = domain.rings().vertex_count();
    let points = (0..count).map(|vertex| domain.placement().point(vertex).extend(0.0));
    let size = Bounds::of_space(points)?.size().truncate().min_element() / 10.0;
    let size = significant(size, 1).parse().ok()?;
    let now = domain.interior().and_then(|wanted| wanted.size_inside);
    now.is_none_or(|now| now < size).then_some(size)
}

/// A Delaunay triangulation as `mindeg compare --save-meshes` writes it.
fn delaunay(domain: &Domain) -> Result<TriMesh, String> {
    if domain.inside().regions.iter().any(|region| region.hole) {
        return Err("there is no Delaunay triangulation of regions that are holes".to_owned());
    }
    let boundary = domain.boundary().map_err(|faults| faults.to_string())?;
    let triangles = Reference::Delaunay
        .triangulate(domain, &boundary, DELAUNAY_TIME)
        .map_err(|error| error.to_string())?
        .triangles;
    let points = boundary.points().iter().chain(boundary.inner_points());
    let points = points.map(|point| point.extend(0.0)).collect();
    let mesh = TriMesh::new(points, triangles).map_err(|error| error.to_string())?;
    Ok(mesh.named(Reference::Delaunay.name()))
}
