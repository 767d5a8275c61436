//! Surfaces in space: a mesh with degrees 5 to 7 that stays near a given surface and keeps its features.

mod chains;
mod guard;
mod kept;
mod mend;
#[cfg(test)]
#[path = "../../examples/surfaces/models.rs"]
mod models;
mod motion;
mod passes;
mod reference;
mod remeshed;
mod sectors;
mod walk;
mod work;

pub use remeshed::{
    CornerLimit, OffDegree, RemeshError, RemeshOptions, RemeshReport, Remeshed, RemeshedCurve,
    improve_surface, remesh,
};
#[cfg(test)]
pub(crate) use {reference::OnSurface, reference::Reference, work::work_mesh};
