//! The defects that keep a mesh from being a triangulation of a domain, in words.

use std::fmt;

use glam::DVec2;
use mindeg_mesh::check::CheckError;
use mindeg_mesh::planar::BoundaryFaults;

/// A triangle of a mesh: its index, and its vertices by the mesh's indices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaultyTriangle {
    /// The index of the triangle, from 0.
    pub index: usize,
    /// The indices of its vertices, from 0.
    pub vertices: [u32; 3],
    /// Its center in the domain's plane.
    pub center: DVec2,
}

/// An edge of a mesh by the mesh's indices of its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaultyEdge {
    /// The indices of its ends, from 0.
    pub ends: [u32; 2],
    /// Its middle in the domain's plane.
    pub middle: DVec2,
    /// A vertex that lies on the edge between its ends.
    pub vertex_on_it: Option<u32>,
}

/// A change of a whole mesh, guessed from its bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MeshChange {
    /// Its size was multiplied by this.
    Scaled(f64),
    /// It was moved by this.
    Moved(DVec2),
}

/// Why a mesh is not a triangulation of a domain. Vertices and triangles have the indices of the mesh, from
/// 0; boundary points those of the domain, from 0.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum MeshDefect {
    /// A tolerance so large that a vertex could belong to several boundary points.
    ToleranceTooLarge {
        /// The tolerance.
        tolerance: f64,
        /// The shortest interval.
        shortest: f64,
    },
    /// Rounding has moved points of the domain's boundary onto or past each other.
    Boundary(BoundaryFaults),
    /// Faces with more than three corners.
    LargerFaces {
        /// How many.
        count: usize,
    },
    /// A vertex off the plane of the others.
    NotPlanar {
        /// The vertex.
        vertex: u32,
        /// How far off it is.
        off: f64,
    },
    /// A boundary point without a vertex.
    NoVertex {
        /// The boundary point.
        point: u32,
        /// The name of its side.
        side: String,
        /// Where it is.
        at: DVec2,
        /// The vertex that is nearest to it.
        nearest: u32,
        /// How far that is.
        distance: f64,
        /// How far it may be.
        tolerance: f64,
        /// The likely change of the whole mesh.
        change: Option<MeshChange>,
    },
    /// A triangle with two corners at one position.
    RepeatedVertex(FaultyTriangle),
    /// A triangle with the vertices of an earlier one.
    RepeatedTriangle {
        /// The later one.
        triangle: FaultyTriangle,
        /// The index of the earlier one.
        first: usize,
    },
    /// A triangle without area.
    NoArea {
        /// The triangle.
        triangle: FaultyTriangle,
        /// The side that all its vertices are on, if they are.
        side: Option<String>,
    },
    /// A triangle with a chord that passes its third vertex by less than what counts as straight.
    Passes {
        /// The triangle.
        triangle: FaultyTriangle,
        /// The ends of the chord.
        chord: [u32; 2],
        /// The vertex.
        vertex: u32,
    },
    /// A triangle that runs the other way round than the others.
    TurnedOver(FaultyTriangle),
    /// Two triangles on the same side of an edge.
    Overlap {
        /// Their indices.
        triangles: [usize; 2],
        /// The edge.
        edge: FaultyEdge,
    },
    /// A triangle outside a boundary edge.
    Outside {
        /// The triangle.
        triangle: FaultyTriangle,
        /// The name of the side.
        side: String,
    },
    /// A boundary edge that no triangle has.
    OpenBoundary {
        /// The edge.
        edge: FaultyEdge,
        /// The name of its side.
        side: String,
    },
    /// An edge inside with a triangle on one side only.
    Open {
        /// The triangle.
        triangle: usize,
        /// The edge.
        edge: FaultyEdge,
    },
    /// The checker's message, where no variant above fits.
    Check(CheckError),
}

impl MeshDefect {
    /// A name of the kind, which stays the same over versions.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::ToleranceTooLarge { .. } => "tolerance_too_large",
            Self::Boundary(_) => "boundary",
            Self::LargerFaces { .. } => "larger_faces",
            Self::NotPlanar { .. } => "not_planar",
            Self::NoVertex { .. } => "no_vertex",
            Self::RepeatedVertex(_) => "repeated_vertex",
            Self::RepeatedTriangle { .. } => "repeated_triangle",
            Self::NoArea { .. } | Self::Passes { .. } => "no_area",
            Self::TurnedOver(_) => "turned_over",
            Self::Overlap { .. } => "overlap",
            Self::Outside { .. } => "outside",
            Self::OpenBoundary { .. } => "open_boundary",
            Self::Open { .. } => "open_edge",
            Self::Check(_) => "check",
        }
    }

    /// How far the check came: in a plane where it comes farther, the mesh is nearer to the domain.
    pub(super) fn step(&self) -> u32 {
        match self {
            Self::NotPlanar { .. } => 0,
            Self::NoVertex { .. } => 1,
            _ => 2,
        }
    }
}

/// Why a triangle has no area whose points are not on a line.
const STRAIGHT: &str = "a turn of less than 1e-9 radians counts as straight";

/// A number with four digits, for a place or a length.
struct Short(f64);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(value) = *self;
        let size = value.abs();
        if size != 0.0 && !(1e-3..1e6).contains(&size) {
            return write!(f, "{value:.3e}");
        }
        let places = if (1e-3..1.0).contains(&size) { 5 } else { 3 };
        let text = format!("{value:.places$}");
        let text = text.trim_end_matches('0').trim_end_matches('.');
        f.write_str(if text == "-0" { "0" } else { text })
    }
}

struct Place(DVec2);

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({}, {})", Short(self.0.x), Short(self.0.y))
    }
}

impl fmt::Display for FaultyTriangle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, b, c] = self.vertices;
        write!(f, "triangle {} (vertices {a}, {b}, {c}) near {}", self.index, Place(self.center))
    }
}

impl fmt::Display for FaultyEdge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, b] = self.ends;
        write!(f, "the edge from vertex {a} to vertex {b} near {}", Place(self.middle))
    }
}

/// The message about a vertex on an open edge.
fn vertex_on_it(edge: &FaultyEdge) -> String {
    edge.vertex_on_it.map_or_else(String::new, |vertex| format!("; vertex {vertex} lies on it"))
}

impl fmt::Display for MeshDefect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ToleranceTooLarge { tolerance, shortest } => write!(
                f,
                "a tolerance of {} is too large: the shortest interval is {} long; give less than half \
                 of that",
                Short(*tolerance),
                Short(*shortest)
            ),
            Self::Boundary(faults) => {
                write!(f, "the domain's boundary is not simple once it is rounded: {faults}")
            }
            Self::LargerFaces { count: 1 } => {
                f.write_str("1 face has more than three corners; cut it into triangles first")
            }
            Self::LargerFaces { count } => {
                write!(
                    f,
                    "{count} faces have more than three corners; cut them into triangles first"
                )
            }
            Self::NotPlanar { vertex, off } => write!(
                f,
                "vertex {vertex} is {} off the plane of the others; a domain is planar, in x and y or in \
                 x and z",
                Short(*off)
            ),
            Self::NoVertex { point, side, at, nearest, distance, tolerance, change } => {
                write!(
                    f,
                    "no vertex is at boundary point {point} on {side}, {}: the nearest, vertex {nearest}, \
                     is {} away, and {} is the tolerance",
                    Place(*at),
                    Short(*distance),
                    Short(*tolerance)
                )?;
                match change {
                    Some(MeshChange::Scaled(by)) => write!(
                        f,
                        "; the mesh is {} times as large as the domain: is its unit another one?",
                        Short(*by)
                    ),
                    Some(MeshChange::Moved(by)) => {
                        write!(f, "; the mesh seems to be moved by {}", Place(*by))
                    }
                    None if *distance <= 1000.0 * tolerance => {
                        f.write_str("; if the mesh was rounded, give a larger --tolerance")
                    }
                    None => Ok(()),
                }
            }
            Self::RepeatedVertex(triangle) => write!(f, "{triangle} has two corners in one place"),
            Self::RepeatedTriangle { triangle, first } => {
                write!(f, "{triangle} has the same vertices as triangle {first}")
            }
            Self::NoArea { triangle, side: Some(side) } => {
                write!(
                    f,
                    "{triangle} has no area: all its vertices are on {side}, where {STRAIGHT}"
                )
            }
            Self::Passes { triangle, chord: [from, to], vertex } => write!(
                f,
                "{triangle} has no area: vertex {vertex} is on its edge from {from} to {to}, where \
                 {STRAIGHT}"
            ),
            Self::NoArea { triangle, side: None } => write!(f, "{triangle} has no area"),
            Self::TurnedOver(triangle) => {
                write!(f, "{triangle} is turned over: it runs the other way round than the others")
            }
            Self::Overlap { triangles: [a, b], edge } => {
                write!(f, "triangles {a} and {b} overlap: both are on the same side of {edge}")
            }
            Self::Outside { triangle, side } => {
                write!(f, "{triangle} is outside the domain, beyond {side}")
            }
            Self::OpenBoundary { edge, side } => {
                write!(f, "no triangle has {edge}, on {side} of the boundary{}", vertex_on_it(edge))
            }
            Self::Open { triangle, edge } => {
                let on_it = vertex_on_it(edge);
                write!(
                    f,
                    "triangle {triangle} has no neighbour at {edge}, inside the domain{on_it}"
                )
            }
            Self::Check(error) => write!(f, "{error} (vertices by boundary points)"),
        }
    }
}

impl std::error::Error for MeshDefect {}
