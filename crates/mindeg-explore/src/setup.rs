//! The domains and options that a server starts with.

use mindeg_answers::advice::Purpose;

use crate::api::Source;
use crate::command::KnownFiles;

/// The settings that a server starts with.
#[derive(Clone, Debug, Default)]
pub struct Setup {
    /// The port; 0 for any that is free.
    pub port: u16,
    /// The domain or the surface to show first; the first preset otherwise.
    pub start: Option<Source>,
    /// All domains of its file, where there are several.
    pub choices: Vec<Source>,
    /// The bytes of the file of that surface.
    pub surface: Vec<u8>,
    /// Files that the page's commands may name.
    pub known: KnownFiles,
    /// The purpose of the mesh, if that is known.
    pub purpose: Option<Purpose>,
}
