//! What can be wrong with a domain.

use mindeg_core::BoundaryError;

use crate::constraint::{ConstraintPlace, GREATEST_OUTSIDE_DEGREE};
use crate::domain::GREATEST_COORDINATE;
use crate::spacing::SpacingError;

/// Why an outline and its sides are not a domain. Sides and corners are counted from 0 here and
/// from 1 in messages.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DomainError {
    /// A measure of a rectangle outside its range.
    #[error(
        "the rectangle's {key} is {value:?}; it must be a finite number{}",
        if *key == "rotation" { "" } else { " above 0" }
    )]
    Rectangle {
        /// `width`, `height` or `rotation`.
        key: &'static str,
        /// The number.
        value: f64,
    },
    /// Fewer than three corners.
    #[error("an outline needs at least 3 corners, and {corners} {} given", if *corners == 1 { "is" } else { "are" })]
    TooFewCorners {
        /// How many there are.
        corners: usize,
    },
    /// A coordinate that is not finite or larger than [`GREATEST_COORDINATE`].
    #[error(
        "corner {} is at ({x:?}, {y:?}); coordinates must be finite and at most \
         {GREATEST_COORDINATE:e} in size",
        corner + 1
    )]
    Coordinate {
        /// Which corner.
        corner: usize,
        /// Its x coordinate.
        x: f64,
        /// Its y coordinate.
        y: f64,
    },
    /// Two neighbouring corners nearer than [`LEAST_SIDE`](crate::LEAST_SIDE), or the same.
    #[error(
        "corners {} and {} are the same point ({x:?}, {y:?}), or as good as; give each corner once \
         (the outline closes by itself)",
        first + 1, second + 1
    )]
    RepeatedCorner {
        /// The one.
        first: usize,
        /// The next.
        second: usize,
        /// The x coordinate.
        x: f64,
        /// The y coordinate.
        y: f64,
    },
    /// A corner that is straight or reflex, or where the outline folds back on itself.
    #[error(
        "corner {} at ({x:?}, {y:?}) {}; every corner must turn the same way",
        corner + 1, describe_angle(*angle)
    )]
    NotConvex {
        /// Which corner.
        corner: usize,
        /// Its x coordinate.
        x: f64,
        /// Its y coordinate.
        y: f64,
        /// Its inside angle in degrees: 0 where the outline folds back, 180 where it is
        /// straight, to within 1e-9 radians; otherwise between 180 and 360.
        angle: f64,
    },
    /// All corners turn the same way, but more than once around.
    #[error(
        "the outline goes around {turns} times, so its sides cross; list the corners in the order \
         in which they lie around the domain"
    )]
    NotSimple {
        /// How many times.
        turns: u32,
    },
    /// Another number of sides than corners.
    #[error("{sides} sides are described and the outline has {corners}; describe each side once")]
    SideCount {
        /// The corners of the outline.
        corners: usize,
        /// The sides described.
        sides: usize,
    },
    /// A name that is blank or has a control character.
    #[error(
        "{} name {name:?} cannot be used; names must not be blank and have no line breaks or \
         other control characters",
        side.map_or("the domain's".to_owned(), |side| format!("side {}'s", side + 1))
    )]
    Name {
        /// The side with that name; the domain itself if there is none.
        side: Option<usize>,
        /// The name.
        name: String,
    },
    /// Two sides of the same name.
    #[error(
        "sides {} and {} are both named {name:?}; names become groups in mesh files and must differ",
        first + 1, second + 1
    )]
    RepeatedName {
        /// The one.
        first: usize,
        /// The other.
        second: usize,
        /// Their name.
        name: String,
    },
    /// A target size that is zero, negative or not finite.
    #[error("side {}: the size is {size:?}; it must be a finite number above 0", side + 1)]
    Size {
        /// The side.
        side: usize,
        /// The number.
        size: f64,
    },
    /// Interval counts that are no boundary.
    #[error(transparent)]
    Boundary(#[from] BoundaryError),
    /// A spacing law that cannot be had.
    #[error("side {}: {source}", side + 1)]
    Spacing {
        /// The side.
        side: usize,
        /// Why.
        source: SpacingError,
    },
    /// An interval too short for the coordinates at which it lies.
    #[error(
        "side {}: its shortest interval is {length:.1e} long, too short to be told from nothing at \
         the size of the side's coordinates; use fewer intervals or a gentler law, or move the \
         domain towards the origin",
        side + 1
    )]
    UnresolvedInterval {
        /// The side.
        side: usize,
        /// The length of the interval.
        length: f64,
    },
    /// Two sides so close next to a corner that their points run together.
    #[error(
        "corner {}: the points next to it are {distance:.1e} from the other side, too close to be \
         told apart at the size of the coordinates; make the intervals there longer or the angle \
         larger, or move the domain towards the origin",
        corner + 1
    )]
    UnresolvedCorner {
        /// The corner.
        corner: usize,
        /// The distance.
        distance: f64,
    },
    /// A list of edges outside that is not one for each of the side's vertices.
    #[error(
        "side {}: outside_degree lists {numbers} numbers, and the side has {vertices} vertices, \
         both corners included; give one for each, or a single number for all that are not corners",
        side + 1
    )]
    OutsideDegreeCount {
        /// The side.
        side: usize,
        /// How many numbers are listed.
        numbers: usize,
        /// How many vertices the side has, both corners included.
        vertices: u64,
    },
    /// More edges outside than [`GREATEST_OUTSIDE_DEGREE`].
    #[error(
        "{}: an outside_degree of {edges} is more than the {GREATEST_OUTSIDE_DEGREE} that are \
         served",
        match place {
            ConstraintPlace::Side(side) => format!("side {}", side + 1),
            ConstraintPlace::Entry(entry) => format!("entry {}", entry + 1),
        }
    )]
    OutsideDegree {
        /// Where it is said.
        place: ConstraintPlace,
        /// The number.
        edges: u32,
    },
    /// A constraint on a vertex beyond the last.
    #[error(
        "vertex {vertex} does not exist; the {vertex_count} vertices are numbered from 0, \
         counter-clockwise from the first corner"
    )]
    NoSuchVertex {
        /// Its place in the list.
        entry: usize,
        /// The vertex.
        vertex: u32,
        /// How many vertices there are.
        vertex_count: u32,
    },
    /// Two constraints on one vertex.
    #[error("vertex {vertex} is listed twice; say all of it in one place")]
    RepeatedVertex {
        /// The place of the one in the list.
        first: usize,
        /// The place of the other.
        second: usize,
        /// The vertex.
        vertex: u32,
    },
    /// A cap that is exceeded whatever the mesh.
    #[error(
        "vertex {vertex} has a max_degree of {max_degree}, less than its 2 edges along the \
         boundary{}; raise it to {} or more",
        if *outside_degree == 0 { String::new() } else { format!(" and {outside_degree} outside") },
        outside_degree + 2
    )]
    NoRoom {
        /// Where the cap is, or what is said last of the vertex.
        place: ConstraintPlace,
        /// The vertex, as numbered in the mesh.
        vertex: u32,
        /// The most edges it may have.
        max_degree: u32,
        /// The edges it has outside.
        outside_degree: u32,
    },
}

fn describe_angle(angle: f64) -> String {
    if angle == 0.0 {
        "folds back on itself (0°)".to_owned()
    } else if angle == 180.0 {
        "is straight (180°)".to_owned()
    } else {
        format!("is reflex ({angle:.6}°)")
    }
}
