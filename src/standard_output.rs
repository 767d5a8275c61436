//! Text on standard output, for people and for programs.

use crate::failure::Failure;
use crate::terminal::safe;
use serde::Serialize;
use std::io::{self, Write};

/// Prints a text, in which nothing steers a terminal.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    print_raw(&safe(text))
}

fn print_raw(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes())
        .and_then(|()| out.flush())
        .map_err(|error| Failure::from_standard_output(&error))
}

/// Prints `value` as JSON on one line.
pub(crate) fn print_json(value: &impl Serialize) -> Result<(), Failure> {
    let mut text = serde_json::to_string(value)
        .map_err(|error| Failure::Io(format!("cannot write JSON: {error}")))?;
    text.push('\n');
    print_raw(&text)
}
