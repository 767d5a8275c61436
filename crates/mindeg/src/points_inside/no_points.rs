//! The words of the search for points inside where it ends without.

use mindeg_mesh::Cancelled;

/// Why a surface has no points inside.
pub(crate) enum NoPoints {
    Cancelled,
    Because(String),
}

impl From<Cancelled> for NoPoints {
    fn from(_: Cancelled) -> Self {
        Self::Cancelled
    }
}
