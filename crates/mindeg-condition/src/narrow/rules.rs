//! The rules for narrow places, and for those that stay.

use crate::demands::Hold;
use glam::DVec2;

/// The rules for the old boundary, by its edges.
pub(crate) struct Rules<'a> {
    pub(crate) width: f64,
    pub(crate) hold: &'a dyn Fn(u32) -> Hold,
    pub(crate) has_domain: &'a dyn Fn(u32) -> [bool; 2],
    /// Points that no change may take to the other side.
    pub(crate) marks: &'a [DVec2],
}

/// Whether the domain or what is outside is narrow.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Narrows {
    Domain,
    Outside,
}
