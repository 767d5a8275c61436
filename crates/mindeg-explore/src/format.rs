//! The formats that the page downloads.

use mindeg_files::{Format, WriteOptions, Writer};

/// All formats that this program writes.
pub(crate) fn formats() -> impl Iterator<Item = Format> {
    let is_built =
        |format: &Format| Writer::check_size(*format, &WriteOptions::default(), 3, 1).is_ok();
    Format::WRITTEN.into_iter().filter(is_built)
}

/// A format by its name.
///
/// # Errors
///
/// A format that is not written, in a sentence.
pub(crate) fn format_named(name: &str) -> Result<Format, String> {
    let named = formats().find(|format| format.name() == name);
    named.ok_or_else(|| format!("no format {name:?} is written here"))
}
