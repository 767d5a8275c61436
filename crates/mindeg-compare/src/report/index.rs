//! A page that lists many comparisons in a table that sorts.
//!
//! Limits: the table has what decides between mindeg and Delaunay; the rest is in the reports.

use super::html::{escaped, filled, head};
use super::{MethodFigures, Report};
use crate::number_format::{angle, count, significant};
use crate::{MINDEG, Reference};
use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};
use std::io::{self, Write};

const PAGE: &str = include_str!("index.html");
const STYLE: &str = include_str!("page.css");
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
/// use mindeg::{Domain, Side};
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
        let outcome = |name: &str| {
            let method: &MethodFigures = report.methods.iter().find(|m| m.name == name)?;
            method.max_degree.zip(method.min_angle).filter(|_| method.valid)
        };
        let line = Line {
            link: link(path),
            vertices: report.domain.vertices,
            mindeg: outcome(MINDEG),
            delaunay: outcome(Reference::Delaunay.name()),
        };
        Self { name: name.into(), outcome: Ok(line) }
    }

    /// A domain that could not be compared, and why.
    #[must_use]
    pub fn failed(name: impl Into<String>, reason: impl Into<String>) -> Self {
        Self { name: name.into(), outcome: Err(reason.into()) }
    }
}

/// Writes the index as one self-contained HTML page.
///
/// # Errors
///
/// Those of `out`.
pub fn write_index(entries: &[IndexEntry], mut out: impl Write) -> io::Result<()> {
    let columns: String = COLUMNS
        .iter()
        .map(|(title, kind)| {
            format!("<th scope=\"col\" data-kind=\"{kind}\"><button type=\"button\">{title}</button></th>")
        })
        .collect();
    let mut rows = String::new();
    let mut failures = String::new();
    for entry in entries {
        let name = escaped(&entry.name);
        match &entry.outcome {
            Ok(line) => rows += &row(&name, line),
            Err(reason) => {
                failures +=
                    &format!("<dt>{name}</dt><dd class=\"defect\">{}</dd>", escaped(reason));
            }
        }
    }
    let failed = entries.iter().filter(|entry| entry.outcome.is_err()).count() as u32;
    if failed > 0 {
        failures = format!(
            "<section><h2>Not compared: {}</h2><dl>{failures}</dl></section>\n",
            count(failed)
        );
    }
    let title = match entries.len() as u32 {
        1 => "1 domain".to_owned(),
        domains => format!("{} domains", count(domains)),
    };
    let page = filled(
        PAGE,
        &[
            ("head", &head("Comparisons", "compare", &[STYLE], true)),
            ("title", &title),
            ("columns", &columns),
            ("rows", &rows),
            ("failures", &failures),
            ("version", env!("CARGO_PKG_VERSION")),
            ("script", SCRIPT),
        ],
    );
    out.write_all(page.as_bytes())
}

fn row(name: &str, line: &Line) -> String {
    let cell = |value: Option<f64>, text: String| {
        let value = value.map(|value| value.to_string()).unwrap_or_default();
        format!("<td data-value=\"{value}\">{text}</td>")
    };
    let whole = |value: Option<u32>| cell(value.map(f64::from), value.map_or("–".into(), count));
    let degrees = |value: Option<f64>| cell(value, value.map_or("–".into(), angle));
    let ratio = |value: Option<f64>| {
        cell(value, value.map_or("–".into(), |value| format!("{}×", significant(value, 3))))
    };
    let pair = line.mindeg.zip(line.delaunay);
    let cells = [
        whole(Some(line.vertices)),
        whole(line.mindeg.map(|(degree, _)| degree)),
        whole(line.delaunay.map(|(degree, _)| degree)),
        ratio(pair.map(|(mindeg, delaunay)| f64::from(delaunay.0) / f64::from(mindeg.0))),
        degrees(line.mindeg.map(|(_, smallest)| smallest)),
        degrees(line.delaunay.map(|(_, smallest)| smallest)),
        ratio(pair.map(|(mindeg, delaunay)| delaunay.1 / mindeg.1)),
    ];
    format!(
        "<tr><th scope=\"row\" data-value=\"{name}\"><a href=\"{}\">{name}</a></th>{}</tr>\n",
        escaped(&line.link),
        cells.concat()
    )
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
