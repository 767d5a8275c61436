//! The provenance of a page.

use mindeg_answers::advice::shell_word;
use mindeg_compare::Provenance;
use std::path::Path;

/// The provenance of a page: the file as it was given, and the command line.
pub(crate) fn provenance(input: Option<&Path>) -> Provenance {
    let words = std::env::args_os().skip(1).map(|word| shell_word(&word.to_string_lossy()));
    let command = [String::from("mindeg")].into_iter().chain(words).collect::<Vec<_>>().join(" ");
    let input = input.filter(|path| *path != Path::new("-"));
    Provenance {
        input: input.map(|path| path.display().to_string()),
        command: Some(command),
        ..Provenance::default()
    }
}
