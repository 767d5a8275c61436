//! A report as Markdown, for a wiki or a pull request.
//!
//! Limits: tables need a reader that knows GitHub's extension. No pictures.

use super::html::{commands, vertex_words};
use super::tables::{self, Table};
use super::titles::{self, title};
use crate::Comparison;
use crate::verdict::verdict;
use mindeg_answers::numbers::count;
use std::io::{self, Write};

/// Writes a comparison as Markdown.
///
/// # Errors
///
/// The errors of `out`.
///
/// # Example
///
/// ```
/// use mindeg_compare::{CompareOptions, compare, write_markdown};
/// use mindeg::{Domain, Side};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?;
/// let mut markdown = Vec::new();
/// write_markdown(&compare(&domain, &CompareOptions::default())?, &mut markdown)?;
/// assert!(String::from_utf8(markdown)?.contains("| Least degree, largest angle | 4 |"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_markdown(comparison: &Comparison, mut out: impl Write) -> io::Result<()> {
    let report = comparison.report();
    let domain = &report.domain;
    writeln!(out, "# Comparison: {}\n", escaped(domain.name.as_deref().unwrap_or("domain")))?;
    writeln!(
        out,
        "{} {}, {} triangles, {} interior edges. The least maximum degree that \
         any triangulation of this domain can have is {}{}.\n",
        count(domain.vertices),
        vertex_words(domain.regions),
        count(domain.triangles),
        count(domain.interior_edges),
        count(domain.at_least),
        if domain.least_max_degree.is_some() { "" } else { " or more" }
    )?;
    for sentence in verdict(report).sentences() {
        writeln!(out, "{}\n", escaped(sentence))?;
    }
    writeln!(out, "```sh\n{}\n```\n", commands(report).join("\n"))?;
    write_table(&mut out, 2, &tables::choice(report))?;
    write_table(&mut out, 2, &tables::overview(report))?;
    if let Some(table) = tables::interior(report) {
        write_table(&mut out, 2, &table)?;
    }
    write_table(&mut out, 2, &tables::degrees(report))?;
    write_table(&mut out, 2, &tables::shares(report))?;
    writeln!(
        out,
        "## Quality of triangles\n\n\
         The columns 1% and 99% are quantiles: one triangle in a hundred is below the one, one \
         above the other.\n"
    )?;
    for table in tables::metrics(report) {
        write_table(&mut out, 3, &table)?;
    }
    for table in tables::worst(&titles::named(report)) {
        write_table(&mut out, 2, &table)?;
    }
    writeln!(out, "## Methods\n")?;
    for method in &report.methods {
        writeln!(
            out,
            "- **{}**: {}",
            escaped(&title(report, method.method)),
            escaped(&method.description)
        )?;
    }
    Ok(())
}

fn write_table(out: &mut impl Write, level: usize, table: &Table) -> io::Result<()> {
    writeln!(out, "{} {}\n", "#".repeat(level), escaped(&table.title))?;
    if !table.note.is_empty() {
        writeln!(out, "{}\n", escaped(&table.note))?;
    }
    let row = |cells: &[String]| {
        let cells: Vec<String> = cells.iter().map(|cell| escaped(cell)).collect();
        format!("| {} |", cells.join(" | "))
    };
    writeln!(out, "{}", row(&table.columns))?;
    writeln!(out, "|---|{}", "---:|".repeat(table.columns.len() - 1))?;
    for cells in &table.rows {
        writeln!(out, "{}", row(cells))?;
    }
    writeln!(out)
}

/// Text in which nothing is markup.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        if "\\`*_[]<>|#~".contains(character) {
            escaped.push('\\');
        }
        escaped.push(character);
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_no_markup() {
        assert_eq!(escaped("a|b <script> *c* d_e"), r"a\|b \<script\> \*c\* d\_e");
    }
}
