//! What the search for points inside says where it ends without.

use mindeg_mesh::Cancelled;

/// Why a filling has no points inside.
pub(super) enum NoPoints {
    Cancelled,
    Because(String),
}

impl From<Cancelled> for NoPoints {
    fn from(_: Cancelled) -> Self {
        Self::Cancelled
    }
}
