//! How a run ends when it does not succeed.

use std::io::{self, Write};
use std::process::ExitCode;

/// Why a run stopped. Each kind has its exit code, listed in `--help`.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Something could not be read or written: exit code 1.
    Io(String),
    /// The input is not what it must be: exit code 2, as for wrong usage.
    Input(String),
    /// The mesh is not as good as asked for: exit code 3.
    Gate(String),
    /// Whoever read our standard output has seen enough: exit code 0, in silence.
    ClosedPipe,
}

impl Failure {
    /// A failure from writing to standard output.
    pub(crate) fn from_standard_output(error: &io::Error) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe {
            Self::ClosedPipe
        } else {
            Self::Io(format!("cannot write to standard output: {error}"))
        }
    }

    /// What went wrong, in words; none for a closed pipe.
    pub(crate) fn message(&self) -> Option<&str> {
        match self {
            Self::Io(message) | Self::Input(message) | Self::Gate(message) => Some(message),
            Self::ClosedPipe => None,
        }
    }

    /// Says what went wrong on standard error and gives the exit code.
    pub(crate) fn report(&self) -> ExitCode {
        let (message, code) = match self {
            Self::Io(message) => (message, 1),
            Self::Input(message) => (message, 2),
            Self::Gate(message) => (message, 3),
            Self::ClosedPipe => return ExitCode::SUCCESS,
        };
        // With standard error closed too there is nobody left to tell.
        let _ = writeln!(io::stderr(), "error: {message}");
        ExitCode::from(code)
    }
}
