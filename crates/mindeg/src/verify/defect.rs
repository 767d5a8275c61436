//! The defects that keep a mesh from being a triangulation of a domain, in words.

use glam::{DVec2, DVec3};

/// Why a mesh is not a triangulation of a domain. Vertices and triangles have the indices of the mesh, from
/// 0; boundary points those of the domain, from 0.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[cfg_attr(feature = "json", derive(serde::Serialize))]
#[error("{message}")]
#[non_exhaustive]
pub struct MeshDefect {
    /// The kind of defect, in lower case with underscores, such as "no_vertex"; `docs/verify.md` lists them.
    pub kind: &'static str,
    /// The defect in a sentence.
    pub message: String,
}

impl MeshDefect {
    pub(crate) fn new(kind: &'static str, message: impl Into<String>) -> Self {
        Self { kind, message: message.into() }
    }

    /// How far the check of the mesh came before the defect, by steps.
    pub(super) fn step(&self) -> u32 {
        match self.kind {
            "not_planar" => 0,
            "no_vertex" => 1,
            _ => 2,
        }
    }
}

/// The turn that counts as straight, in words.
pub(super) const STRAIGHT: &str = "a turn of less than 1e-9 radians counts as straight";

/// A point of the domain's plane.
pub(super) fn at(point: DVec2) -> String {
    mindeg_mesh::place(point)
}

/// A point in space.
pub(super) fn in_space(place: DVec3) -> String {
    mindeg_mesh::place(place)
}
