//! The failures of a run, and its exit code.

use crate::terminal::say_error;
use mindeg::DomainJsonError;
use mindeg_files::{FileError, plainly};
use std::fmt::Display;
use std::io;
use std::process::ExitCode;

/// Why a run stopped. Each kind has its exit code, listed in `--help`.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Something could not be read or written: exit code 1.
    Io(String),
    /// The input is not what it must be: exit code 2, as for wrong usage.
    Input(String),
    /// The same, for a domain in JSON, with all its faults.
    Domain { message: String, error: Box<DomainJsonError> },
    /// The mesh is not as good as asked for: exit code 3.
    Gate(String),
    /// Whoever read our standard output has seen enough: exit code 0, in silence.
    ClosedPipe,
}

impl Failure {
    /// Input that is refused, in these words.
    pub(crate) fn input(words: impl Display) -> Self {
        Self::Input(words.to_string())
    }

    /// A failure from writing to standard output.
    pub(crate) fn from_standard_output(error: &io::Error) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe {
            Self::ClosedPipe
        } else {
            Self::Io(format!("cannot write to standard output: {}", plainly(error)))
        }
    }

    /// The error in words; `None` for a closed pipe.
    pub(crate) fn message(&self) -> Option<&str> {
        match self {
            Self::Io(message)
            | Self::Input(message)
            | Self::Domain { message, .. }
            | Self::Gate(message) => Some(message),
            Self::ClosedPipe => None,
        }
    }

    /// The same failure of something with a name.
    pub(crate) fn of(self, name: &str) -> Self {
        match self {
            Self::Io(message) => Self::Io(format!("{name}: {message}")),
            Self::Input(message) => Self::Input(format!("{name}: {message}")),
            Self::Domain { message, error } => {
                Self::Domain { message: format!("{name}: {message}"), error }
            }
            Self::Gate(message) => Self::Gate(format!("{name}: {message}")),
            Self::ClosedPipe => Self::ClosedPipe,
        }
    }

    /// Says what went wrong on standard error and gives the exit code.
    pub(crate) fn report(&self) -> ExitCode {
        if let Some(message) = self.message() {
            say_error(message);
        }
        ExitCode::from(match self {
            Self::ClosedPipe => 0,
            Self::Io(_) => 1,
            Self::Input(_) | Self::Domain { .. } => 2,
            Self::Gate(_) => 3,
        })
    }
}

impl From<FileError> for Failure {
    fn from(error: FileError) -> Self {
        match error.kind() {
            Some(io::ErrorKind::BrokenPipe) => Self::ClosedPipe,
            Some(_) => Self::Io(error.to_string()),
            None => Self::Input(error.to_string()),
        }
    }
}
