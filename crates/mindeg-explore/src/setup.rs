//! The domains and options that a server starts with.

use std::fmt;
use std::sync::Arc;

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
    /// Reads its file anew, for edges of a length.
    pub divide: Option<Divide>,
    /// The bytes of the file of that surface.
    pub surface: Vec<u8>,
    /// Files that the page's commands may name.
    pub known: KnownFiles,
    /// The purpose of the mesh, if that is known.
    pub purpose: Option<Purpose>,
}

type Reading = dyn Fn(f64) -> Result<Vec<Source>, String> + Send + Sync;

/// Reads what a server starts with anew, its curves divided into edges of a length: the domains in the same order.
#[derive(Clone)]
pub struct Divide(Arc<Reading>);

impl Divide {
    /// By a function of the length.
    pub fn new(read: impl Fn(f64) -> Result<Vec<Source>, String> + Send + Sync + 'static) -> Self {
        Self(Arc::new(read))
    }

    pub(crate) fn by(&self, size: f64) -> Result<Vec<Source>, String> {
        self.0(size)
    }
}

impl fmt::Debug for Divide {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("Divide")
    }
}
