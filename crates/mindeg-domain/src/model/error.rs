//! Why faces and edges are no model.

use crate::limits::MAX_STORED_VERTICES;
use crate::side::SideError;

/// Why corners, edges and faces are no [`Model`](super::Model). Corners, edges and faces count from
/// 0, here and in messages.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ModelError {
    /// No face at all.
    #[error("the model has no face; give each face as a loop of corners")]
    NoFaces,
    /// A corner that is not finite.
    #[error("corner {corner} has a coordinate that is not a finite number")]
    NotFinite {
        /// The corner.
        corner: u32,
    },
    /// A face or an edge names a corner that does not exist.
    #[error("{what} {index} names corner {corner}; the model has corners 0 to {}", corners.saturating_sub(1))]
    NoSuchCorner {
        /// "face" or "edge".
        what: &'static str,
        /// Its index.
        index: usize,
        /// The corner.
        corner: u32,
        /// The number of corners.
        corners: usize,
    },
    /// A loop of fewer than three corners.
    #[error("face {face} has a loop of {corners} corners; a loop needs at least 3")]
    TooFewCorners {
        /// The face.
        face: usize,
        /// The number of corners.
        corners: usize,
    },
    /// A face passes a corner twice.
    #[error(
        "face {face} passes corner {corner} twice; a face may not touch itself; cut it in two there"
    )]
    RepeatedCorner {
        /// The face.
        face: usize,
        /// The corner.
        corner: u32,
    },
    /// A face goes along an edge and straight back.
    #[error(
        "face {face} goes from corner {from} to corner {to} and straight back; remove the spike"
    )]
    Spike {
        /// The face.
        face: usize,
        /// The corner before the tip.
        from: u32,
        /// The tip.
        to: u32,
    },
    /// Two corners of an edge at one place.
    #[error(
        "corners {} and {} of an edge are at the same place; merge them or move one",
        corners[0],
        corners[1]
    )]
    CoincidentCorners {
        /// The corners.
        corners: [u32; 2],
    },
    /// A face without area.
    #[error("face {face} has no area; remove it or move its corners")]
    NoArea {
        /// The face.
        face: usize,
    },
    /// A face that is not planar.
    #[error(
        "face {face} is not planar: corner {corner} is {distance:.3e} off its plane, and the \
         tolerance is {tolerance:.3e}; cut the face in triangles, or raise the tolerance"
    )]
    NotPlanar {
        /// The face.
        face: usize,
        /// The corner farthest from the plane.
        corner: u32,
        /// Its distance.
        distance: f64,
        /// The largest distance allowed.
        tolerance: f64,
    },
    /// Two edges of one face meet other than at a common corner.
    #[error(
        "face {face} crosses itself: its edges {}-{} and {}-{} (by corners) meet",
        edges[0][0], edges[0][1], edges[1][0], edges[1][1]
    )]
    Crossing {
        /// The face.
        face: usize,
        /// The edges, by corners.
        edges: [[u32; 2]; 2],
    },
    /// A corner of a face lies on another edge of it.
    #[error(
        "face {face} touches itself: corner {corner} lies on its edge {}-{} (by corners)",
        edge[0], edge[1]
    )]
    Touch {
        /// The face.
        face: usize,
        /// The corner.
        corner: u32,
        /// The edge, by corners.
        edge: [u32; 2],
    },
    /// A hole that is not inside the outer loop.
    #[error("hole {hole} of face {face} is not inside the face's outer loop")]
    HoleOutside {
        /// The face.
        face: usize,
        /// The hole.
        hole: usize,
    },
    /// Two faces with the same corners.
    #[error("faces {first} and {second} have the same corners; remove one of them")]
    FaceTwice {
        /// The one.
        first: usize,
        /// The other.
        second: usize,
    },
    /// An edge with two interval counts.
    #[error(
        "the edge from corner {} to corner {} has {first} intervals in one place and {second} in \
         another; give it one count",
        corners[0],
        corners[1]
    )]
    TwoCounts {
        /// The edge, by corners.
        corners: [u32; 2],
        /// The one count.
        first: u64,
        /// The other.
        second: u64,
    },
    /// An edge that is given twice.
    #[error("the edge from corner {} to corner {} is given twice; give it once", corners[0], corners[1])]
    EdgeTwice {
        /// The edge, by corners.
        corners: [u32; 2],
    },
    /// An edge that no face has.
    #[error(
        "edge {index} joins corners {} and {}, but no face has such an edge",
        corners[0],
        corners[1]
    )]
    NoSuchEdge {
        /// Its index among the given edges.
        index: usize,
        /// Its corners.
        corners: [u32; 2],
    },
    /// An edge without a division.
    #[error(
        "the edge from corner {} to corner {} has no interval count; give \"size\" for all edges, \
         or an entry in \"edges\"",
        corners[0],
        corners[1]
    )]
    NoDivision {
        /// The edge, by corners.
        corners: [u32; 2],
    },
    /// An edge of no intervals.
    #[error("the edge from corner {} to corner {} has 0 intervals; the minimum is 1", corners[0], corners[1])]
    NoIntervals {
        /// The edge, by corners.
        corners: [u32; 2],
    },
    /// A division that does not fit the edge.
    #[error("the edge from corner {} to corner {}: {source}", corners[0], corners[1])]
    Edge {
        /// The edge, by corners.
        corners: [u32; 2],
        /// Why.
        source: SideError,
    },
    /// Intervals too short for the coordinates.
    #[error(
        "the edge from corner {} to corner {} has intervals of {length:.1e}, too short for its \
         coordinates; use fewer intervals, or an origin near the model",
        corners[0],
        corners[1]
    )]
    IntervalTooShort {
        /// The edge, by corners.
        corners: [u32; 2],
        /// The shortest interval.
        length: f64,
    },
    /// Too many vertices.
    #[error(
        "the model has {vertices} vertices on its edges; the maximum is {MAX_STORED_VERTICES}; give fewer intervals, or a larger size"
    )]
    TooManyVertices {
        /// How many vertices there are.
        vertices: u64,
    },
    /// A name without a visible character.
    #[error("the name of {what} is blank; give it a letter or leave it out")]
    BlankName {
        /// Such as "face 3".
        what: String,
    },
    /// A name with a character that mesh files or terminals do not take as text.
    #[error("the name of {what} contains the character U+{:04X}; remove it", *character as u32)]
    NameCharacter {
        /// Such as "face 3".
        what: String,
        /// The character.
        character: char,
    },
}
