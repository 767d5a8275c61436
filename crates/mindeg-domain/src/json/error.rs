//! Errors in a domain's JSON text, with their position.

use crate::error::also;

/// An error in a domain's JSON text, with its position.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}, column {column}{}{}", if path.is_empty() { ": " } else { ", " }, self.without_position())]
pub struct DomainJsonError {
    /// The keys that lead to the value, such as `sides[2].spacing`; empty for the whole text.
    pub path: String,
    /// The line, from 1.
    pub line: usize,
    /// The column, from 1, in bytes: where the wrong value starts, or where the text stops being
    /// JSON.
    pub column: usize,
    /// The error and the allowed values.
    pub message: String,
    /// The other faults of the rings, lines and points.
    pub more: Vec<DomainJsonError>,
}

impl DomainJsonError {
    /// The error with its keys, for who has not written the text.
    pub fn without_position(&self) -> String {
        let Self { path, message, more, .. } = self;
        let at = if path.is_empty() { String::new() } else { format!("{path}: ") };
        format!("{at}{message}{}", also(more.iter().map(|it| &*it.message)))
    }
}
