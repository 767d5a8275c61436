//! Why a file cannot be read or written.

use mindeg_formats::Format;
use std::error::Error;
use std::fmt;
use std::io;
use std::path::Path;

/// Why a file cannot be read or written: a sentence that names it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileError {
    message: String,
    kind: Option<io::ErrorKind>,
}

impl FileError {
    /// A name or a content that is wrong.
    #[must_use]
    pub fn wrong(message: impl Into<String>) -> Self {
        Self { message: message.into(), kind: None }
    }

    /// A file that the system does not give.
    pub(crate) fn system(message: impl Into<String>, kind: io::ErrorKind) -> Self {
        Self { message: message.into(), kind: Some(kind) }
    }

    pub(crate) fn cannot_read(name: &str, error: &io::Error) -> Self {
        Self::system(format!("cannot read {name}: {}", plainly(error)), error.kind())
    }

    /// The system's error; `None` if the name or the content of the file is wrong.
    #[must_use]
    pub fn kind(&self) -> Option<io::ErrorKind> {
        self.kind
    }

    /// The same error where the content alone told the format.
    pub(crate) fn guessed(self, format: Format, option: &str) -> Self {
        let Self { message, kind } = self;
        let (name, other) = (format.name(), "if it is another format");
        Self {
            message: format!("{message}; the content looks like {name}: {other}, give {option}"),
            kind,
        }
    }

    /// The same error of something with a name.
    pub(crate) fn of(self, name: &str) -> Self {
        Self { message: format!("{name}: {}", self.message), ..self }
    }
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl Error for FileError {}

/// An error of the system in its words: without its number, and without the name of a temporary
/// file, which the user never gave.
#[must_use]
pub fn plainly(error: &io::Error) -> String {
    let source = error.get_ref().and_then(|wrapper| wrapper.source());
    let cause = source.and_then(|source| source.downcast_ref::<io::Error>()).unwrap_or(error);
    let text = cause.to_string();
    match text.split_once(" (os error ") {
        Some((words, _)) => words.to_owned(),
        None => text,
    }
}

/// An error of the same kind in these words.
pub(crate) fn plain(error: io::Error) -> io::Error {
    io::Error::new(error.kind(), plainly(&error))
}

/// The extension of a name in lower case; empty if it has none.
pub(crate) fn extension(path: &Path) -> String {
    path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase()
}
