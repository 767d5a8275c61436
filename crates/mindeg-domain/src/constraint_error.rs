//! Why constraints do not fit a boundary.

use crate::limits::GREATEST_EXTERNAL_DEGREE;
use crate::rings::InRing;
use mindeg_mesh::planar::Turn;

/// The entry of [`Constraints`](crate::Constraints) that an error is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConstraintPlace {
    /// The entry of this side.
    Side(InRing),
    /// This entry of the list of [`VertexConstraint`](crate::VertexConstraint)s.
    Entry(usize),
}

/// Why constraints do not fit a boundary. Entries are counted from 0 here and from 1 in messages;
/// vertices always from 0.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ConstraintError {
    /// A number of side entries that is neither 0 nor that of the sides.
    #[error(
        "found constraints of {entries} sides, and the outline has {sides} sides; give one entry for each side, or none"
    )]
    SideCount {
        /// The entries.
        entries: usize,
        /// The sides of the outline.
        sides: usize,
    },
    /// A list of external degrees whose length does not fit the side.
    #[error(
        "{}: outside_degree lists {degrees} {}, and the side has {vertices} vertices, both \
         corners included; give one for each, or a single number for all that are not corners",
        side.side(), if *degrees == 1 { "number" } else { "numbers" }
    )]
    ExternalDegreeCount {
        /// The side.
        side: InRing,
        /// The length of the list.
        degrees: usize,
        /// The vertices of the side, both corners included.
        vertices: u64,
    },
    /// An external degree above [`GREATEST_EXTERNAL_DEGREE`](crate::GREATEST_EXTERNAL_DEGREE).
    #[error(
        "{}: outside_degree is {external_degree}; the maximum is {GREATEST_EXTERNAL_DEGREE}",
        match place {
            ConstraintPlace::Side(side) => side.side(),
            ConstraintPlace::Entry(entry) => format!("entry {}", entry + 1),
        }
    )]
    ExternalDegree {
        /// The entry.
        place: ConstraintPlace,
        /// The number.
        external_degree: u32,
    },
    /// A constraint on a vertex beyond the last.
    #[error(
        "vertex {vertex} does not exist; the {vertex_count} vertices are numbered from 0, \
         counter-clockwise from the first corner"
    )]
    NoSuchVertex {
        /// The entry.
        entry: usize,
        /// The vertex.
        vertex: u32,
        /// How many vertices there are.
        vertex_count: u32,
    },
    /// Two entries for one vertex.
    #[error("vertex {vertex} is listed twice; give it one entry")]
    RepeatedVertex {
        /// The one entry.
        first: usize,
        /// The other.
        second: usize,
        /// The vertex.
        vertex: u32,
    },
    /// A degree limit that no mesh keeps.
    #[error(
        "vertex {vertex} has a max_degree of {degree_limit} and needs {least_degree}: {}; raise \
         max_degree to {least_degree} or more",
        describe_edges(*bend, *external_degree)
    )]
    Capacity {
        /// The entry.
        place: ConstraintPlace,
        /// The vertex, as the mesh numbers it.
        vertex: u32,
        /// Its degree limit.
        degree_limit: u32,
        /// Its external degree.
        external_degree: u32,
        /// The least total degree that it has in any mesh.
        least_degree: u32,
        /// How the boundary bends at the vertex, which decides what it needs.
        bend: Bend,
    },
}

/// How the boundary bends at a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bend {
    /// Below 180° inside the domain: 2 edges are enough.
    Convex,
    /// Not at all. With 2 edges the vertex would be the tip of a triangle without area.
    Straight,
    /// Above 180° inside the domain: no triangle has its tip there.
    Reflex,
}

impl Bend {
    /// The least degree that a vertex has in any mesh.
    pub(crate) fn least_degree(self) -> u32 {
        if self == Self::Convex { 2 } else { 3 }
    }
}

impl From<Turn> for Bend {
    fn from(turn: Turn) -> Self {
        match turn {
            Turn::Straight => Self::Straight,
            Turn::By(angle) if angle > 0.0 => Self::Convex,
            Turn::By(_) => Self::Reflex,
            // A needle: its tip is convex, or its foot is reflex. The former needs less.
            Turn::Back => Self::Convex,
        }
    }
}

/// The edges that a vertex has in any mesh.
fn describe_edges(bend: Bend, outside: u32) -> String {
    let along = match bend {
        Bend::Straight => "2 edges along its straight side",
        Bend::Convex | Bend::Reflex => "2 edges along the boundary",
    };
    match (bend, outside) {
        (Bend::Convex, 0) => along.to_owned(),
        (Bend::Convex, _) => format!("{along} and {outside} outside"),
        (_, 0) => format!("{along} and 1 into the domain"),
        _ => format!("{along}, 1 into the domain and {outside} outside"),
    }
}

impl ConstraintError {
    /// The same error with another number for its side.
    pub(crate) fn with_side(mut self, number: impl Fn(InRing) -> InRing) -> Self {
        match &mut self {
            Self::ExternalDegreeCount { side, .. }
            | Self::ExternalDegree { place: ConstraintPlace::Side(side), .. }
            | Self::Capacity { place: ConstraintPlace::Side(side), .. } => *side = number(*side),
            _ => {}
        }
        self
    }
}
