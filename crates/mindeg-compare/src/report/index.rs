//! A page that lists many comparisons in a table that sorts.
//!
//! Limits: the table has what decides between mindeg and Delaunay; the rest is in the reports.

use super::html::{STYLE, VERSION, rendered};
use super::{Report, svg};
use crate::Method;
use crate::number_format::{angle, count, significant};
use askama::Template;
use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};
use std::io::{self, Write};

const SCRIPT: &str = include_str!("index.js");

/// What is escaped in a link: everything but letters, digits and these.
const PLAIN: &AsciiSet = &NON_ALPHANUMERIC.remove(b'-').remove(b'.').remove(b'_').remove(b'/');

const COLUMNS: [(&str, &str); 8] = [
    ("Domain", "text"),
    ("Boundary vertices", "number"),
    ("Maximum degree, mindeg", "number"),
    ("Maximum degree, Delaunay", "number"),
    ("Delaunay’s as a multiple", "number"),
    ("Smallest angle, mindeg", "number"),
    ("Smallest angle, Delaunay", "number"),
    ("Delaunay’s as a multiple", "number"),
];

/// One line of the index: a comparison, or why there is none.
///
/// # Example
///
/// ```
/// use mindeg_compare::{IndexEntry, Options, compare, write_index};
/// use mindeg_geometry::{Domain, Side};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?;
/// let comparison = compare(&domain, &Options::default())?;
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
            method.max_degree.zip(method.min_angle).filter(|_| method.valid)
        };
        let line = Line {
            link: link(path),
            vertices: report.domain.vertices,
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
    version: &'static str,
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
    value: String,
    text: String,
}

impl Cell {
    fn new(value: Option<f64>, text: impl FnOnce(f64) -> String) -> Self {
        Self {
            value: value.map(|value| value.to_string()).unwrap_or_default(),
            text: value.map_or("–".into(), text),
        }
    }
}

/// Writes the index as one self-contained HTML page.
///
/// # Errors
///
/// Those of `out`.
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
        version: VERSION,
        style: svg::page_style(&[STYLE]),
        columns: &COLUMNS,
        rows,
        failures,
        script: SCRIPT,
    };
    out.write_all(rendered(&page)?.as_bytes())
}

fn cells(line: &Line) -> Vec<Cell> {
    let whole = |value: Option<u32>| Cell::new(value.map(f64::from), |value| count(value as u32));
    let degrees = |value| Cell::new(value, angle);
    let ratio = |value| Cell::new(value, |value| format!("{}×", significant(value, 3)));
    let pair = line.mindeg.zip(line.delaunay);
    vec![
        whole(Some(line.vertices)),
        whole(line.mindeg.map(|(degree, _)| degree)),
        whole(line.delaunay.map(|(degree, _)| degree)),
        ratio(pair.map(|(mindeg, delaunay)| f64::from(delaunay.0) / f64::from(mindeg.0))),
        degrees(line.mindeg.map(|(_, smallest)| smallest)),
        degrees(line.delaunay.map(|(_, smallest)| smallest)),
        ratio(pair.map(|(mindeg, delaunay)| delaunay.1 / mindeg.1)),
    ]
}

/// A relative path as a link, in which nothing has a meaning of its own: neither `?` nor `#`, and
/// a colon makes no scheme.
fn link(path: &str) -> String {
    utf8_percent_encode(path, PLAIN).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_hold_any_name() {
        for (path, expected) in [
            ("out/plate.html", "out/plate.html"),
            ("a b#1?.html", "a%20b%231%3F.html"),
            ("javascript:x", "javascript%3Ax"),
            ("é.html", "%C3%A9.html"),
        ] {
            assert_eq!(link(path), expected);
        }
    }
}
