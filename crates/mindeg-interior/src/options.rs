//! What is wanted, and why it cannot be done.

use crate::limits::degree_limit;
use glam::DVec2;
use mindeg_delaunay::DelaunayError;
use mindeg_domain::{Prefer, SizeAt};
use mindeg_mesh::Cancelled;
use mindeg_mesh::planar::{BoundaryFaults, PlanarBoundary};
use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use thiserror::Error;

/// The greatest number of points of a mesh.
pub(crate) const MAX_POINTS: usize = 1 << 30;

/// True for coordinates whose squares, and areas made of them, neither overflow nor vanish.
pub(crate) fn is_usable(point: DVec2) -> bool {
    point.to_array().iter().all(|x| *x == 0.0 || (1e-70..=1e70).contains(&x.abs()))
}

/// Checks that limits and meshes of a boundary can be computed: squares of its coordinates neither
/// overflow nor vanish.
///
/// # Errors
///
/// [`InteriorError::Coordinate`].
pub fn check_coordinates(boundary: &PlanarBoundary) -> Result<(), InteriorError> {
    match (0..).zip(boundary.points()).find(|(_, point)| !is_usable(**point)) {
        Some((vertex, at)) => Err(InteriorError::Coordinate { vertex, at: at.to_array() }),
        None => Ok(()),
    }
}

/// What the mesh is to be like.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// How fast the size grows from the boundary: change of size per distance. Above 0; 0.5 by default.
    pub growth: f64,
    /// The size far from the boundary; by default a mean of the boundary edges' lengths.
    pub size_inside: Option<f64>,
    /// Places with a size of their own: up to the default growth no edge at the vertex nearest to a place is
    /// longer. They make the mesh finer, never coarser.
    pub sizes: Vec<SizeAt>,
    /// The degrees wanted inside; 5..=7 by default. Contains 6, as the mean degree is near 6.
    pub interior_degree: RangeInclusive<u32>,
    /// The greatest degree wanted at the boundary, 5 by default;
    /// see [`degree_limit`](crate::limits::degree_limit) for reflex corners.
    pub boundary_degree: u32,
    /// Boundary vertices with a degree limit of their own, in edges, which holds instead.
    pub degree_limits: BTreeMap<u32, u32>,
    /// The minimum angle wanted in degrees; by default as much as the limits allow, up to about 35.
    pub target_angle: Option<f64>,
    /// Which aim wins.
    pub prefer: Prefer,
    /// The mesh is refused where it would have more points than this; 20 million by default.
    pub max_points: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            growth: 0.5,
            size_inside: None,
            sizes: Vec::new(),
            interior_degree: 5..=7,
            boundary_degree: 5,
            degree_limits: BTreeMap::new(),
            target_angle: None,
            prefer: Prefer::default(),
            max_points: 20_000_000,
        }
    }
}

/// Points and segments inside the domain that the mesh must have.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Fixed {
    /// Points inside the domain.
    pub points: Vec<DVec2>,
    /// Segments between vertices: the outline's, then these points. The mesh
    /// may divide a segment, but keeps its line.
    pub segments: Vec<[u32; 2]>,
}

/// Why there is no mesh.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum InteriorError {
    /// The rings do not bound a domain.
    #[error(transparent)]
    Boundary(#[from] BoundaryFaults),
    /// A coordinate that is too great or small to square.
    #[error("boundary vertex {vertex} is at ({}, {}); coordinates are 0 or of magnitude 1e-70 to 1e70", at[0], at[1])]
    Coordinate {
        /// The vertex.
        vertex: u32,
        /// Its position.
        at: [f64; 2],
    },
    /// A size that is not above 0.
    #[error("{what} is {value}; a size is a finite number above 0")]
    Size {
        /// Which one.
        what: String,
        /// Its value.
        value: f64,
    },
    /// A growth that is not above 0.
    #[error("growth is {0}; it is a finite number above 0 (0.5 is usual, less grows slower)")]
    Growth(f64),
    /// A range of degrees that no mesh can keep to.
    #[error(
        "interior degrees {start} to {end} are out of reach: the range must contain 6 and start at 3 or more"
    )]
    InteriorDegree {
        /// The least.
        start: u32,
        /// The greatest.
        end: u32,
    },
    /// A limit at the boundary that is too low to mesh with.
    #[error("a boundary degree of {0} is too low; use 4 or more (5 is usual)")]
    BoundaryDegree(u32),
    /// A limit at a vertex that no mesh can keep.
    #[error("vertex {vertex} has a degree limit of {limit}; its two boundary edges alone are 2")]
    DegreeLimit {
        /// The vertex.
        vertex: u32,
        /// Its limit.
        limit: u32,
    },
    /// A target that is no angle.
    #[error("target angle {0} is out of range; give degrees above 0 and below 60")]
    TargetAngle(f64),
    /// A target that is proven impossible.
    #[error(
        "a minimum angle of {target} degrees is impossible: the boundary at vertex {vertex} allows at most {limit:.3} degrees; lower the target, or make the interval lengths at this vertex more alike"
    )]
    TargetAboveLimit {
        /// The angle wanted.
        target: f64,
        /// The proven limit.
        limit: f64,
        /// The boundary vertex that decides.
        vertex: u32,
    },
    /// A place outside the domain.
    #[error("{what} at ({}, {}) is not inside the domain", at[0], at[1])]
    Outside {
        /// What is there.
        what: String,
        /// Where it is.
        at: [f64; 2],
    },
    /// A line that ends on the boundary, but at none of its vertices.
    #[error(
        "fixed line {line} ends on the boundary at ({}, {}), between its points; the nearest is vertex {vertex} at ({}, {}): end the line there, or put a boundary point here",
        at[0], at[1], nearest[0], nearest[1]
    )]
    EndOffVertex {
        /// The line's index.
        line: usize,
        /// Where it ends.
        at: [f64; 2],
        /// The boundary vertex nearest to it.
        vertex: u32,
        /// Where that is.
        nearest: [f64; 2],
    },
    /// A line that names a fixed point that is not there.
    #[error("fixed line {line} names fixed point {index} (counted from 0); fixed points: {points}")]
    NoSuchPoint {
        /// The line's index.
        line: usize,
        /// The fixed point's index.
        index: usize,
        /// How many there are.
        points: usize,
    },
    /// A fixed segment that names a vertex that is not there, or one vertex twice.
    #[error("fixed segment {segment} joins vertices {} and {}; give two different ones of the {vertices} boundary and fixed points", ends[0], ends[1])]
    Segment {
        /// The segment's index.
        segment: usize,
        /// Its ends.
        ends: [u32; 2],
        /// The number of vertices it may name.
        vertices: usize,
    },
    /// A fixed segment that touches something it may not touch.
    #[error(
        "fixed segment {segment} touches or crosses {what}; segments may only meet at their ends, which are vertices of both"
    )]
    SegmentCrosses {
        /// The segment's index.
        segment: usize,
        /// What it touches.
        what: String,
    },
    /// Coordinates that cannot hold a point and its neighbours apart.
    #[error(
        "no point fits at ({}, {}): edges there would be {size:.3e} long, and the largest coordinate of \
         the boundary is rounded to {rounding:.1e}; move the domain towards the origin, or mesh it \
         without interior points",
        at[0], at[1]
    )]
    NoRoom {
        /// The place.
        at: [f64; 2],
        /// The size that the mesh should have there.
        size: f64,
        /// The rounding of the largest coordinate.
        rounding: f64,
    },
    /// More points than allowed.
    #[error("the mesh needs more than {max} points; raise the size inside or the sizes at places")]
    TooManyPoints {
        /// How many are allowed.
        max: usize,
    },
    /// The triangulation failed.
    #[error("the triangulation of boundary and interior points failed: {0}")]
    Triangulation(#[source] DelaunayError),
    /// The triangulation has too many or too few triangles.
    #[error("the triangulation does not fill the outline: {0}")]
    NotFilled(String),
    /// A mesh that cannot be improved because it is not a planar triangle mesh.
    #[error("the mesh cannot be improved: {0}")]
    BadMesh(String),
    /// The [`Progress`](mindeg_mesh::Progress) callback has cancelled the work.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl From<DelaunayError> for InteriorError {
    fn from(error: DelaunayError) -> Self {
        match error {
            DelaunayError::Cancelled(cancelled) => Self::Cancelled(cancelled),
            error => Self::Triangulation(error),
        }
    }
}

impl Options {
    /// The greatest degree wanted of a boundary vertex, in edges.
    #[must_use]
    pub fn degree_limit(&self, outline: &PlanarBoundary, vertex: u32) -> u32 {
        match self.degree_limits.get(&vertex) {
            Some(limit) => *limit,
            None => degree_limit(outline.angle(vertex), self.boundary_degree),
        }
    }

    /// Checks all values that need no outline to check.
    pub(crate) fn check(&self) -> Result<(), InteriorError> {
        let positive = |x: f64| x.is_finite() && x > 0.0;
        if !positive(self.growth) {
            return Err(InteriorError::Growth(self.growth));
        }
        if let Some(value) = self.size_inside.filter(|size| !positive(*size)) {
            return Err(InteriorError::Size { what: "the size inside".into(), value });
        }
        for (index, place) in self.sizes.iter().enumerate() {
            if !positive(place.size) {
                let what = format!("size {index}");
                return Err(InteriorError::Size { what, value: place.size });
            }
            if !is_usable(place.at) {
                let what = format!("size {index}");
                return Err(InteriorError::Outside { what, at: place.at.to_array() });
            }
        }
        let (start, end) = (*self.interior_degree.start(), *self.interior_degree.end());
        if !(3..=6).contains(&start) || end < 6 {
            return Err(InteriorError::InteriorDegree { start, end });
        }
        if self.boundary_degree < 4 {
            return Err(InteriorError::BoundaryDegree(self.boundary_degree));
        }
        if let Some((vertex, limit)) = self.degree_limits.iter().find(|(_, limit)| **limit < 2) {
            return Err(InteriorError::DegreeLimit { vertex: *vertex, limit: *limit });
        }
        match self.target_angle {
            Some(angle) if !(angle > 0.0 && angle < 60.0) => Err(InteriorError::TargetAngle(angle)),
            _ => Ok(()),
        }
    }
}
