//! Why boundary vertices cannot be placed.

use crate::rings::InRing;

/// Why boundary vertices cannot be placed: 64-bit floats do not tell two of them apart.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlacementError {
    /// The shortest interval of a side is too short for the coordinates at which it lies.
    #[error(
        "{}: its shortest interval is {length:.1e} long, too short to be told from nothing at \
         the size of the side's coordinates; use fewer intervals or a gentler law, or move the \
         domain towards the origin",
        side.side()
    )]
    Interval {
        /// The side.
        side: InRing,
        /// The length of the interval.
        length: f64,
    },
    /// Two sides are so close next to a corner that their points coincide.
    #[error(
        "{}: the points next to it are {distance:.1e} from the other side, too close to be \
         told apart at the size of the coordinates; make the intervals there longer or the angle \
         larger, or move the domain towards the origin",
        corner.corner()
    )]
    Corner {
        /// The corner.
        corner: InRing,
        /// The distance.
        distance: f64,
    },
}
