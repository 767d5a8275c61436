//! The aims of a mesh, and why they cannot be met.

use crate::breaklines::Breaklines;
use crate::limits::{Limits, degree_limit, limits};
use crate::star::Stars;
use glam::DVec2;
use mindeg_delaunay::DelaunayError;
use mindeg_domain::{DomainError, Interior, Size, SizeAt, SizeFile, SizeFrom};
use mindeg_mesh::Cancelled;
use mindeg_mesh::planar::{BoundaryFaults, PlanarBoundary};
use mindeg_mesh::{number, place};
use std::collections::BTreeMap;
use std::ops::{Range, RangeInclusive};
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
    let points = boundary.points().iter().chain(boundary.inner_points());
    match (0..).zip(points).find(|(_, point)| !is_usable(**point)) {
        Some((vertex, at)) => Err(InteriorError::Coordinate { vertex, at: at.to_array() }),
        None => Ok(()),
    }
}

/// The rounding of the largest coordinate.
pub(crate) fn rounding(boundary: &PlanarBoundary) -> f64 {
    let bounds = boundary.bounds();
    f64::EPSILON * bounds.min.abs().max(bounds.max.abs()).max_element()
}

/// Refuses a size at a place where distances, which are as exact as the coordinates of the boundary, do not tell
/// a neighbour from another, or inside from outside: there a packing finds no end.
pub(crate) fn check_room(at: DVec2, size: f64, rounding: f64) -> Result<(), InteriorError> {
    /// A size of fewer roundings is too small.
    const LEAST_ROUNDINGS: f64 = 64.0;
    // A size that is not a number is too small, too.
    if size > LEAST_ROUNDINGS * rounding {
        return Ok(());
    }
    Err(InteriorError::NoRoom { at: at.to_array(), size, rounding })
}

/// How many names a message lists.
const MOST_NAMES: usize = 20;

/// The aims of the mesh.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Options {
    /// The aims.
    pub wanted: Interior,
    /// Boundary vertices with a degree limit of their own, in edges, which holds instead of
    /// [`Interior::boundary_degree`]; see [`degree_limit`](crate::limits::degree_limit) for reflex corners.
    pub degree_limits: BTreeMap<u32, u32>,
    /// Boundary vertices that are one in the mesh joined at periodic sides; [`join`](Self::join) sets them.
    pub joined: Vec<JoinedVertices>,
    /// For each segment of the boundary's lines, whether it may be divided; those beyond the end may not.
    pub divisible: Vec<bool>,
    /// The names of edges of the boundary: of its rings, then of its lines. Several runs may share one.
    pub names: Vec<(String, Range<u32>)>,
    /// The faces on the left and right of each edge.
    pub beside: Vec<[Option<u32>; 2]>,
    /// The size of each face, infinite where none is wanted; those beyond the end have none.
    pub region_sizes: Vec<f64>,
}

/// Vertices of a boundary that periodic sides make one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct JoinedVertices {
    /// The vertices.
    pub vertices: Vec<u32>,
    /// Whether the one is inside the joined mesh, where it has as many edges as triangles.
    pub is_inside: bool,
    /// A degree limit of its own, in edges.
    pub limit: Option<u32>,
}

impl From<Interior> for Options {
    fn from(wanted: Interior) -> Self {
        Self { wanted, ..Self::default() }
    }
}

/// Why meshing failed.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum InteriorError {
    /// The rings do not bound a domain.
    #[error(transparent)]
    Boundary(#[from] BoundaryFaults),
    /// A coordinate that is too great or small to square.
    #[error("boundary vertex {vertex} is at {}; coordinates are 0 or of magnitude 1e-70 to 1e70", place(*at))]
    Coordinate {
        /// The vertex.
        vertex: u32,
        /// Its position.
        at: [f64; 2],
    },
    /// A value without a meaning.
    #[error(transparent)]
    Wanted(#[from] DomainError),
    /// A size near a side or line that does not exist.
    #[error(
        "interior.sizes[{index}].from: no side or line has the name \"{name}\"; there are {known}"
    )]
    NoName {
        /// The index in the list of sizes.
        index: usize,
        /// The name.
        name: String,
        /// The names that exist.
        known: String,
    },
    /// Sizes in a file that was not read.
    #[error(
        "interior.sizes[{index}]: {file:?} is read where the domain comes from a file in its folder; give the sizes \
         themselves"
    )]
    UnreadSizes {
        /// The index in the list of sizes.
        index: usize,
        /// The file.
        file: String,
    },
    /// A limit at a vertex that no mesh can keep.
    #[error("vertex {vertex} has a degree limit of {limit}; its boundary edges alone are {edges}")]
    DegreeLimit {
        /// The vertex.
        vertex: u32,
        /// Its limit.
        limit: u32,
        /// Its boundary edges.
        edges: u32,
    },
    /// A target that is proven impossible.
    #[error(
        "a minimum angle of {target}° is impossible: the boundary at vertex {vertex} allows at most {angle}; lower the target, or make the interval lengths at this vertex more alike",
        angle = mindeg_mesh::steady_angle(*limit)
    )]
    TargetAboveLimit {
        /// The angle wanted.
        target: f64,
        /// The proven limit.
        limit: f64,
        /// The boundary vertex that decides.
        vertex: u32,
    },
    /// A position outside the domain.
    #[error("{what} at {} is not inside the domain", place(*at))]
    Outside {
        /// The feature at that position.
        what: String,
        /// The position.
        at: [f64; 2],
    },
    /// Coordinates that cannot hold a point and its neighbours apart.
    #[error(
        "no point fits at {}: edges there would be {} long, and the largest coordinate of \
         the boundary is rounded to {}; move the domain towards the origin, or mesh it \
         without interior points",
        place(*at), number(*size), number(*rounding)
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
    #[error(
        "the mesh needs more than {max} points; raise the size inside or the sizes at places, or allow more points"
    )]
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
    /// Sets the vertices of a boundary that are one, and the degree limit of each: that of the one, if the others
    /// have a triangle each.
    pub fn join(&mut self, outline: &PlanarBoundary, joined: Vec<JoinedVertices>) {
        for one in &joined {
            let most = *self.triangles_of(outline, one).end();
            let own = (most + 2).saturating_sub(one.vertices.len() as u32).max(2);
            self.degree_limits.extend(one.vertices.iter().map(|&vertex| (vertex, own)));
        }
        self.joined = joined;
    }

    /// The numbers of triangles that are wanted at vertices that are one.
    pub(crate) fn triangles_of(
        &self,
        outline: &PlanarBoundary,
        one: &JoinedVertices,
    ) -> RangeInclusive<u32> {
        let (low, high) = match one.is_inside {
            true => self.wanted.interior_degree().into_inner(),
            false => {
                let angle = one.vertices.iter().map(|&vertex| outline.angle(vertex)).sum();
                (1, degree_limit(angle, self.wanted.boundary_degree()) - 1)
            }
        };
        let more = u32::from(!one.is_inside);
        low..=one.limit.map_or(high, |limit| limit.saturating_sub(more).min(high))
    }

    /// The greatest degree wanted of a boundary vertex, in edges.
    #[must_use]
    pub fn degree_limit(&self, outline: &PlanarBoundary, vertex: u32) -> u32 {
        match self.degree_limits.get(&vertex) {
            Some(limit) => *limit,
            None => degree_limit(outline.angle(vertex), self.wanted.boundary_degree()),
        }
    }

    /// The limits of an outline whose vertices have the degrees wanted, or up to those of `beyond`.
    #[must_use]
    pub fn limits(&self, outline: &PlanarBoundary, beyond: impl Fn(u32) -> u32) -> Limits {
        let degree_limit = |vertex| self.degree_limit(outline, vertex).max(beyond(vertex));
        limits(outline, self.wanted.least_triangles(), degree_limit)
    }

    /// The stars of an outline's vertices.
    pub(crate) fn stars(&self, outline: &PlanarBoundary, lines: &Breaklines) -> Stars {
        let stars = Stars::new(outline, lines);
        if self.wanted.has_corners_inside() { stars.with_corners_inside(outline) } else { stars }
    }

    /// Whether a segment of the boundary's lines may be divided.
    pub(crate) fn is_divisible(&self, segment: usize) -> bool {
        self.divisible.get(segment) == Some(&true)
    }

    /// The edges of the boundary with one of these names, in ascending order.
    pub(crate) fn edges_named(&self, names: &[String]) -> impl Iterator<Item = u32> {
        let runs = self.names.iter().filter(|(name, _)| names.contains(name));
        runs.flat_map(|(_, edges)| edges.clone())
    }

    /// Checks that sides and lines have the names that size `index` names.
    fn check_names(&self, index: usize, wanted: &[String]) -> Result<(), InteriorError> {
        let is_known = |name: &String| self.names.iter().any(|(known, _)| known == name);
        let Some(unknown) = wanted.iter().find(|name| !is_known(name)) else { return Ok(()) };
        let mut known: Vec<String> = Vec::new();
        for (name, _) in &self.names {
            let name = format!("\"{name}\"");
            if !known.contains(&name) {
                known.push(name);
            }
        }
        if known.len() > MOST_NAMES {
            known.truncate(MOST_NAMES);
            known.push("…".to_owned());
        }
        Err(InteriorError::NoName { index, name: unknown.clone(), known: known.join(", ") })
    }

    /// Checks all values that need no outline to check.
    pub(crate) fn check(&self) -> Result<(), InteriorError> {
        self.wanted.check()?;
        for (index, size) in self.wanted.sizes.iter().enumerate() {
            let places: &[SizeAt] = match size {
                Size::At(place) => std::slice::from_ref(place),
                Size::Between(between) => &between.points,
                Size::From(SizeFrom { from, .. }) => {
                    self.check_names(index, from)?;
                    &[]
                }
                Size::File(SizeFile { file }) => {
                    return Err(InteriorError::UnreadSizes { index, file: file.clone() });
                }
            };
            if let Some(place) = places.iter().find(|place| !is_usable(place.at)) {
                let what = format!("entry {} of sizes", index + 1);
                return Err(InteriorError::Outside { what, at: place.at.to_array() });
            }
        }
        if let Some((vertex, limit)) = self.degree_limits.iter().find(|(_, limit)| **limit < 2) {
            return Err(InteriorError::DegreeLimit { vertex: *vertex, limit: *limit, edges: 2 });
        }
        Ok(())
    }
}
