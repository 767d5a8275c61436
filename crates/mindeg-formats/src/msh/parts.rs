//! The parts of a file, each from `$Name` to `$EndName`.

use crate::ReadError;
use crate::numbers::Numbers;
use crate::scanner::Scanner;
use crate::sections::Section;

/// The name of the next part; its contents follow in the next line.
pub(super) fn next_part<'a>(scanner: &mut Scanner<'a>) -> Option<&'a [u8]> {
    loop {
        let line = scanner.line()?.trim_ascii();
        if let Some(name) = line.strip_prefix(b"$")
            && !name.starts_with(b"End")
        {
            return Some(name);
        }
    }
}

/// Leaves out a part, whose contents begin at an offset.
pub(super) fn skip(scanner: &mut Scanner<'_>, name: &[u8], start: usize) -> Result<(), ReadError> {
    let end = [b"$End", name].concat();
    let found = memchr::memmem::find(scanner.rest(), &end);
    let shown = String::from_utf8_lossy(name);
    let found =
        found.ok_or_else(|| scanner.problem_at(start, format!("${shown} has no $End{shown}")))?;
    scanner.go_to(scanner.offset() + found);
    scanner.line();
    Ok(())
}

pub(super) fn end_part(scanner: &mut Scanner<'_>, name: &[u8]) -> Result<(), ReadError> {
    let start = scanner.offset();
    let word = scanner.word().unwrap_or_default();
    if word.strip_prefix(b"$End") == Some(name) {
        return Ok(());
    }
    let name = String::from_utf8_lossy(name);
    Err(scanner.problem_at(start, format!("$End{name} should follow here")))
}

/// The end of a part that is written.
pub(super) fn end_of<'a>(kind: &str, numbers: Numbers) -> Section<'a> {
    let line_end = if numbers == Numbers::Text { "" } else { "\n" };
    Section::bytes(format!("{line_end}$End{kind}\n"))
}
