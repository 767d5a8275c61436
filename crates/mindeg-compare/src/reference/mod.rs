//! Triangulations of the same boundary points by other methods.
//!
//! No mesh is repaired: check a mesh with [`mindeg_mesh::check`] before you show it.
//!
//! Limits: a method past its time limit is given up. Ear clipping is another crate's loop and
//! cannot be told to stop: its thread runs on unheeded until it is done or the program ends.

mod ear_clipping;
mod fan;

use crate::regions;
use mindeg::Domain;
use mindeg_delaunay::DelaunayError;
use mindeg_mesh::Progress;
use mindeg_mesh::planar::{Border, PlanarBoundary};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

/// A method to compare with.
///
/// # Example
///
/// ```
/// use mindeg::{BoundaryMesh, Domain, Side};
/// use mindeg_compare::Reference;
/// use std::time::Duration;
///
/// let domain = Domain::rectangle(2.0, 1.0, [2, 1, 1, 1].map(Side::count).to_vec())?;
/// let boundary = domain.boundary()?;
/// for reference in Reference::of(&domain) {
///     let timed = reference.triangulate(&domain, &boundary, Duration::from_secs(60))?;
///     assert!(BoundaryMesh::with_triangles(&domain, timed.triangles)?.max_degree() <= 4);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reference {
    /// A Delaunay triangulation: no triangulation of these points has a larger minimum angle.
    Delaunay,
    /// Ear clipping, as graphics programs fill polygons.
    EarClipping,
    /// All triangles round one vertex: the first vertex that gives no flat triangle.
    Fan,
}

/// A triangulation and what it took.
#[derive(Clone, Debug, PartialEq)]
pub struct Timed {
    /// The triangles, each starting with its smallest vertex, in ascending order: so a
    /// triangle's number depends on the triangulation alone.
    pub triangles: Vec<[u32; 3]>,
    /// From the points to the list of triangles, without sorting it.
    pub time: Duration,
}

/// Why a method gives no triangles.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NoTriangulation {
    /// It did not finish in time.
    #[error("it did not finish within the time limit of {} s", limit.as_secs_f64())]
    TimeLimit {
        /// The limit.
        limit: Duration,
    },
    /// The fan: only of a convex domain.
    #[error("a fan round one vertex covers convex domains only")]
    NotConvex,
    /// Ear clipping: lines or points inside a region.
    #[error(
        "ear clipping takes rings alone, and a region has a line that ends inside it, or a point inside"
    )]
    Inside,
    /// The fan: round every vertex some triangle is flat.
    #[error(
        "round every vertex some triangle would be flat; a fan needs a side of exactly 2 \
         intervals, or two neighboring sides of 1 interval each"
    )]
    EveryFanIsFlat,
    /// Delaunay: points without a triangulation.
    #[error(transparent)]
    Delaunay(DelaunayError),
    /// The crate behind the method failed.
    #[error("the {library} library failed on these points")]
    LibraryFailed {
        /// The name of the crate.
        library: &'static str,
    },
}

impl Reference {
    /// All of them, in the order of a report.
    pub const ALL: [Self; 3] = [Self::Delaunay, Self::EarClipping, Self::Fan];

    /// The methods that a domain is compared with, in the order of a report: the fan only if it is convex and no map.
    #[must_use]
    pub fn of(domain: &Domain) -> &'static [Self] {
        let is_convex = domain.convex().is_some() && !domain.is_map();
        if is_convex { &Self::ALL } else { &Self::ALL[..2] }
    }

    /// The name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Delaunay => "Delaunay",
            Self::EarClipping => "Ear clipping",
            Self::Fan => "Fan",
        }
    }

    /// The method's principle, in a sentence.
    #[must_use]
    pub fn description(self) -> &'static str {
        match self {
            Self::Delaunay => {
                "A Delaunay triangulation (crate spade): no triangulation of these points has a \
                 larger minimum angle."
            }
            Self::EarClipping => {
                "Ear clipping (crate earcut), the usual way to fill polygons in graphics."
            }
            Self::Fan => {
                "All triangles round one vertex, the first round which none is flat; often there is \
                 none."
            }
        }
    }

    /// The method's triangles on the given boundary points, unchecked; of a map, those of each region by itself, so that
    /// all methods keep the same lines.
    ///
    /// The work is done on a thread of its own, see the module's limits.
    ///
    /// # Errors
    ///
    /// [`NoTriangulation`], after `time_limit` at the latest.
    pub fn triangulate(
        self,
        domain: &Domain,
        boundary: &PlanarBoundary,
        time_limit: Duration,
    ) -> Result<Timed, NoTriangulation> {
        let (domain, boundary) = (domain.clone(), boundary.clone());
        let (sender, receiver) = mpsc::channel();
        let deadline = Deadline { at: Instant::now().checked_add(time_limit), time_limit };
        let started = thread::Builder::new().spawn(move || {
            let start = Instant::now();
            let triangles = self.run(&domain, &boundary, deadline);
            let time = start.elapsed();
            // Nobody listens any more once the time is up.
            let _ = sender.send(triangles.map(|triangles| Timed { triangles, time }));
        });
        let failed = NoTriangulation::LibraryFailed { library: self.library() };
        if started.is_err() {
            return Err(failed);
        }
        let mut timed = match receiver.recv_timeout(time_limit) {
            Ok(answer) => answer?,
            Err(RecvTimeoutError::Timeout) => {
                return Err(NoTriangulation::TimeLimit { limit: time_limit });
            }
            Err(RecvTimeoutError::Disconnected) => return Err(failed),
        };
        for triangle in &mut timed.triangles {
            let first = (0..3).min_by_key(|&corner| triangle[corner]).unwrap_or(0);
            triangle.rotate_left(first);
        }
        timed.triangles.sort_unstable();
        Ok(timed)
    }

    /// The method's triangles on the given boundary points, unchecked and in no particular order,
    /// however long it takes: for measuring the method and nothing else.
    ///
    /// # Errors
    ///
    /// [`NoTriangulation`], but for its time limit.
    ///
    /// # Panics
    ///
    /// When the library panics.
    pub fn triangulate_without_limit(
        self,
        domain: &Domain,
        boundary: &PlanarBoundary,
    ) -> Result<Vec<[u32; 3]>, NoTriangulation> {
        self.run(domain, boundary, Deadline { at: None, time_limit: Duration::MAX })
    }

    fn run(
        self,
        domain: &Domain,
        boundary: &PlanarBoundary,
        deadline: Deadline,
    ) -> Result<Vec<[u32; 3]>, NoTriangulation> {
        if domain.is_map() {
            return self.run_on_regions(domain, boundary, deadline);
        }
        self.run_on_rings(domain, boundary, deadline)
    }

    /// The triangles of each region of a map, by the vertices of the map.
    fn run_on_regions(
        self,
        domain: &Domain,
        boundary: &PlanarBoundary,
        deadline: Deadline,
    ) -> Result<Vec<[u32; 3]>, NoTriangulation> {
        let mut triangles = Vec::new();
        for Border { boundary, vertices, .. } in regions::borders(domain, boundary) {
            let own = self.run_on_rings(domain, &boundary, deadline)?;
            triangles
                .extend(own.iter().map(|triangle| triangle.map(|place| vertices[place as usize])));
        }
        Ok(triangles)
    }

    fn run_on_rings(
        self,
        domain: &Domain,
        boundary: &PlanarBoundary,
        deadline: Deadline,
    ) -> Result<Vec<[u32; 3]>, NoTriangulation> {
        match self {
            Self::Delaunay => delaunay(boundary, deadline),
            Self::EarClipping => {
                if !boundary.segments().is_empty() || !boundary.inner_points().is_empty() {
                    return Err(NoTriangulation::Inside);
                }
                let holes: Vec<u32> = boundary.rings().skip(1).map(|ring| ring.start).collect();
                Ok(ear_clipping::triangulate(boundary.points(), &holes))
            }
            Self::Fan => {
                let form = domain.convex().ok_or(NoTriangulation::NotConvex)?;
                fan::triangulate(form).ok_or(NoTriangulation::EveryFanIsFlat)
            }
        }
    }

    fn library(self) -> &'static str {
        match self {
            Self::Delaunay => "spade",
            Self::EarClipping => "earcut",
            Self::Fan => "mindeg-compare",
        }
    }
}

/// When to give up.
#[derive(Clone, Copy)]
struct Deadline {
    /// `None` is never.
    at: Option<Instant>,
    time_limit: Duration,
}

/// A Delaunay triangulation, unless the deadline comes first.
fn delaunay(
    boundary: &PlanarBoundary,
    deadline: Deadline,
) -> Result<Vec<[u32; 3]>, NoTriangulation> {
    let in_time = Progress::while_it(|| deadline.at.is_none_or(|at| Instant::now() < at));
    let triangles = mindeg_delaunay::triangles(
        boundary,
        boundary.inner_points(),
        boundary.segments(),
        Progress::new(&in_time),
    );
    triangles.map_err(|error| match error {
        DelaunayError::Cancelled(_) => NoTriangulation::TimeLimit { limit: deadline.time_limit },
        error => NoTriangulation::Delaunay(error),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg::Side;
    use mindeg_core::verify;

    fn triangulate(
        reference: Reference,
        sides: [u64; 4],
        milliseconds: u64,
    ) -> Result<Timed, NoTriangulation> {
        let domain = Domain::rectangle(4.0, 3.0, sides.map(Side::count).to_vec()).unwrap();
        let limit = Duration::from_millis(milliseconds);
        reference.triangulate(&domain, &domain.boundary().unwrap(), limit)
    }

    #[test]
    fn triangles_are_numbered_by_their_vertices() {
        for reference in Reference::ALL {
            let triangles = triangulate(reference, [7, 2, 5, 1], 60_000).unwrap().triangles;
            assert!(triangles.iter().all(|&[a, b, c]| a < b && a < c));
            assert!(triangles.is_sorted_by(|a, b| a < b));
            verify(&[7, 2, 5, 1], triangles).unwrap();
        }
    }

    #[test]
    fn what_takes_too_long_is_given_up() {
        for reference in [Reference::Delaunay, Reference::EarClipping] {
            let refusal = triangulate(reference, [20_000; 4], 5).unwrap_err();
            assert_eq!(refusal.to_string(), "it did not finish within the time limit of 0.005 s");
        }
    }

    /// In the order of the boundary this takes hundreds of times as long.
    #[test]
    fn a_dominant_side_is_no_trouble_for_delaunay() {
        let timed = triangulate(Reference::Delaunay, [100_000, 1, 1, 1], 5_000).unwrap();
        assert_eq!(timed.triangles.len(), 100_001);
    }
}
