//! Running the binary.

use serde_json::Value;
use std::io::Write;
use std::process::{Command, Stdio};

/// How a run ended and what it said.
#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) code: Option<i32>,
    pub(crate) output: Vec<u8>,
    pub(crate) errors: String,
}

impl Run {
    /// Standard output as text.
    pub(crate) fn text(&self) -> &str {
        std::str::from_utf8(&self.output).expect("the output is text")
    }

    /// Standard output as JSON, of a run that went well.
    #[track_caller]
    pub(crate) fn json(&self) -> Value {
        assert_eq!(self.code, Some(0), "{}", self.errors);
        serde_json::from_str(self.text()).expect("the output is JSON")
    }

    /// Fails unless the run refused its input with a message that holds all these words.
    #[track_caller]
    pub(crate) fn refuses(&self, words: &[&str]) {
        assert_eq!(self.code, Some(2), "{self:?}");
        assert!(self.output.is_empty(), "{self:?}");
        for word in words {
            assert!(self.errors.contains(word), "{word:?} is missing in: {}", self.errors);
        }
        assert!(!self.errors.contains("panicked"), "{}", self.errors);
    }
}

/// Runs `mindeg` with these arguments and nothing on standard input.
pub(crate) fn mindeg<S: AsRef<std::ffi::OsStr>>(arguments: impl IntoIterator<Item = S>) -> Run {
    mindeg_reading(arguments, b"")
}

/// Runs `mindeg` with these arguments and `input` on standard input.
pub(crate) fn mindeg_reading<S: AsRef<std::ffi::OsStr>>(
    arguments: impl IntoIterator<Item = S>,
    input: &[u8],
) -> Run {
    let mut child = Command::new(env!("CARGO_BIN_EXE_mindeg"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the binary starts");
    // A run that refuses its arguments never reads; that its pipe is closed is no failure.
    let _ = child.stdin.take().expect("standard input is piped").write_all(input);
    let output = child.wait_with_output().expect("the run ends");
    Run {
        code: output.status.code(),
        output: output.stdout,
        errors: String::from_utf8_lossy(&output.stderr).into_owned(),
    }
}

/// Runs `mindeg` with its standard output closed by whoever was to read it: a quiet success.
#[track_caller]
pub(crate) fn ends_quietly_when_nobody_reads<S: AsRef<std::ffi::OsStr>>(
    arguments: impl IntoIterator<Item = S>,
) {
    let mut child = Command::new(env!("CARGO_BIN_EXE_mindeg"))
        .args(arguments)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the binary starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("the run ends");
    assert_eq!((output.status.code(), output.stderr), (Some(0), Vec::new()));
}
