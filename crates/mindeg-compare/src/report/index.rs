//! A page that lists many comparisons in a table that sorts.
//!
//! Limits: the table has what decides between mindeg and Delaunay; the rest is in the reports.

use super::html::{link, rendered};
use super::viewer::STYLE;
use super::{Provenance, Report, svg};
use crate::Method;
use askama::Template;
use mindeg_answers::advice::Advice;
use mindeg_answers::numbers::{count, steady_angle};
use std::io::{self, Write};

const SCRIPT: &str = include_str!("index.js");

/// The headings, and how a column is sorted.
const COLUMNS: [(&str, &str); 9] = [
    ("Domain", "text"),
    ("Boundary vertices", "number"),
    ("Angle for a solver", "number"),
    ("Degree for a patch", "number"),
    ("Angle for a patch", "number"),
    ("Least degree", "number"),
    ("Its minimum angle", "number"),
    ("Delaunay degree", "number"),
    ("Delaunay minimum angle", "number"),
];

/// One line of the index: a comparison, or the reason why it is missing.
///
/// # Example
///
/// ```
/// use mindeg_compare::{IndexEntry, CompareOptions, compare, write_index};
/// use mindeg::{Domain, Side};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?;
/// let comparison = compare(&domain, &CompareOptions::default())?;
/// let entries = [
///     IndexEntry::compared("plate", "plate.html", comparison.report()),
///     IndexEntry::failed("wing.json", "side 2 has 0 intervals"),
/// ];
/// let mut page = Vec::new();
/// write_index(&entries, &mut page)?;
/// let page = String::from_utf8(page)?;
/// assert!(page.contains(r#"<a href="plate.html">plate</a>"#));
/// assert!(page.contains("side 2 has 0 intervals"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct IndexEntry {
    name: String,
    outcome: Result<Line, String>,
}

/// The figures of a comparison that the index shows.
#[derive(Clone, Debug, PartialEq)]
struct Line {
    link: String,
    vertices: u32,
    advice: Advice,
    mindeg: Option<(u32, f64)>,
    delaunay: Option<(u32, f64)>,
}

impl IndexEntry {
    /// A comparison, and where its own page is: a path relative to the index, with `/` between
    /// its parts.
    #[must_use]
    pub fn compared(name: impl Into<String>, path: &str, report: &Report) -> Self {
        let outcome = |wanted| {
            let method = report.methods.iter().find(|method| method.method == wanted)?;
            method.outcome()
        };
        let line = Line {
            link: link(path),
            vertices: report.domain.vertices,
            advice: report.advice.clone(),
            mindeg: outcome(Method::LeastDegree),
            delaunay: outcome(Method::DELAUNAY),
        };
        Self { name: name.into(), outcome: Ok(line) }
    }

    /// A domain that could not be compared, and why.
    #[must_use]
    pub fn failed(name: impl Into<String>, reason: impl Into<String>) -> Self {
        Self { name: name.into(), outcome: Err(reason.into()) }
    }
}

#[derive(Template)]
#[template(path = "index.html")]
struct Page<'a> {
    title: String,
    provenance: Provenance,
    style: String,
    columns: &'static [(&'static str, &'static str)],
    rows: Vec<Row<'a>>,
    /// Names, each with a reason.
    failures: Vec<(&'a str, &'a str)>,
    script: &'static str,
}

/// A comparison in the table.
struct Row<'a> {
    name: &'a str,
    link: &'a str,
    cells: Vec<Cell>,
}

/// A figure: what is sorted by, and what is read.
struct Cell {
    heading: &'static str,
    value: String,
    text: String,
    /// Whether it is the better of the two figures of its kind.
    is_better: bool,
}

/// Writes the index as one self-contained HTML page.
///
/// # Errors
///
/// The errors of `out`.
pub fn write_index(entries: &[IndexEntry], mut out: impl Write) -> io::Result<()> {
    let mut rows = Vec::new();
    let mut failures = Vec::new();
    for IndexEntry { name, outcome } in entries {
        match outcome {
            Ok(line) => rows.push(Row { name, link: &line.link, cells: cells(line) }),
            Err(reason) => failures.push((name.as_str(), reason.as_str())),
        }
    }
    let page = Page {
        title: match entries.len() as u32 {
            1 => "1 domain".to_owned(),
            domains => format!("{} domains", count(domains)),
        },
        provenance: Provenance::default(),
        style: svg::page_style(&[STYLE]),
        columns: &COLUMNS,
        rows,
        failures,
        script: SCRIPT,
    };
    out.write_all(rendered(&page)?.as_bytes())
}

fn cells(line: &Line) -> Vec<Cell> {
    let whole = |value: u32| (f64::from(value), count(value));
    let lower = line.mindeg.zip(line.delaunay).is_some_and(|(own, there)| own.0 < there.0);
    let larger = line.mindeg.zip(line.delaunay).is_some_and(|(own, there)| own.1 < 0.999 * there.1);
    let figures = [
        (Some(whole(line.vertices)), false),
        (line.advice.solver.map(|it| (it.min_angle, steady_angle(it.min_angle))), false),
        (line.advice.patch.map(|it| whole(it.max_degree)), false),
        (line.advice.patch.map(|it| (it.min_angle, steady_angle(it.min_angle))), false),
        (line.mindeg.map(|(degree, _)| whole(degree)), lower),
        (line.mindeg.map(|(_, angle)| (angle, steady_angle(angle))), false),
        (line.delaunay.map(|(degree, _)| whole(degree)), false),
        (line.delaunay.map(|(_, angle)| (angle, steady_angle(angle))), larger),
    ];
    let headings = COLUMNS.iter().skip(1).map(|(heading, _)| *heading);
    let cells = headings.zip(figures).map(|(heading, (figure, is_better))| {
        let (value, text) = match figure {
            Some((value, text)) => (value.to_string(), text),
            None => (String::new(), "–".to_owned()),
        };
        Cell { heading, value, text, is_better }
    });
    cells.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_headings_are_the_same() {
        let mut headings = COLUMNS.map(|(heading, _)| heading);
        headings.sort_unstable();
        assert!(headings.windows(2).all(|pair| pair[0] != pair[1]));
    }
}
