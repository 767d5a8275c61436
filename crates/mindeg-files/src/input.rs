//! Where a file comes from.

use std::path::Path;

/// Where a file comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input<'a> {
    /// A path.
    File(&'a Path),
    /// Standard input, whose content alone tells the format.
    StandardInput,
    /// Bytes under a name, such as those that a page was given. No file is beside them.
    Bytes(&'a str, &'a [u8]),
}

impl<'a> Input<'a> {
    /// The file at a path, or standard input where the path is `-`.
    #[must_use]
    pub fn of(path: &'a Path) -> Self {
        if path == Path::new("-") { Self::StandardInput } else { Self::File(path) }
    }

    /// The name in messages.
    #[must_use]
    pub fn name(&self) -> String {
        match self {
            Self::File(path) => path.display().to_string(),
            Self::StandardInput => "standard input".to_owned(),
            Self::Bytes(name, _) => (*name).to_owned(),
        }
    }

    /// The name that can tell a format.
    pub(crate) fn path(&self) -> Option<&'a Path> {
        match self {
            Self::File(path) => Some(path),
            Self::StandardInput => None,
            Self::Bytes(name, _) => Some(Path::new(*name)),
        }
    }

    /// Why no file is beside it.
    pub(crate) fn alone(&self) -> &'static str {
        match self {
            Self::Bytes(..) => {
                "it came alone; give mindeg the path of the file, with the other beside it"
            }
            _ => "standard input has no folder where it could be",
        }
    }
}
