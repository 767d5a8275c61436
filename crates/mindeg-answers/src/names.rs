//! Names from files, which may hold anything, in a text for a terminal.

use mindeg::Domain;
use std::borrow::Cow;

/// A text of several lines in which nothing steers a terminal; what would, is an escape.
#[must_use]
pub fn safe_lines(text: &str) -> Cow<'_, str> {
    escaped(text, |c| c != '\n' && steers(c))
}

/// A name within a line: as [`safe_lines`], and line breaks are escapes, too.
#[must_use]
pub fn shown(name: &str) -> Cow<'_, str> {
    escaped(name, steers)
}

/// One of several domains beside each other, by its index and the first of its regions: `part 2 (Nevada, …)`.
#[must_use]
pub fn part_name(index: usize, domain: &Domain) -> String {
    let mut regions = domain.inside().regions.iter().filter_map(|region| region.name.as_deref());
    match (regions.next().or(domain.name()), regions.next()) {
        (None, _) => format!("part {}", index + 1),
        (Some(name), None) => format!("part {} ({})", index + 1, shown(name)),
        (Some(name), Some(_)) => format!("part {} ({}, …)", index + 1, shown(name)),
    }
}

/// How many places a text names.
pub(crate) const NAMED: usize = 5;

/// The first of some places, and an ellipsis for the others.
pub(crate) fn listed(places: impl IntoIterator<Item = String>, between: &str) -> String {
    mindeg_mesh::listed(places, NAMED, between)
}

/// Whether a character moves, colors, ends or turns round what a terminal shows.
fn steers(c: char) -> bool {
    c.is_control() && c != '\t'
        || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}')
        || matches!(c, '\u{2066}'..='\u{2069}')
}

fn escaped(text: &str, is_escaped: impl Fn(char) -> bool) -> Cow<'_, str> {
    if !text.contains(&is_escaped) {
        return Cow::Borrowed(text);
    }
    let mut safe = String::with_capacity(text.len() + 8);
    for c in text.chars() {
        if is_escaped(c) { safe.extend(c.escape_default()) } else { safe.push(c) }
    }
    Cow::Owned(safe)
}
