//! The formats that the page downloads.

use mindeg_files::{Format, WriteOptions, Writer};

/// All formats that this program writes.
pub(crate) fn formats() -> impl Iterator<Item = Format> {
    let is_built =
        |format: &Format| Writer::check_size(*format, &WriteOptions::default(), 3, 1).is_ok();
    Format::WRITTEN.into_iter().filter(is_built)
}

/// A format by its name.
pub(crate) fn format_named(name: &str) -> Option<Format> {
    formats().find(|format| format.name() == name)
}
