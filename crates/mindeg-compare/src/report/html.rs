//! A report as one HTML page that opens from disk and asks for nothing else.
//!
//! What is read (verdict, tables) is plain HTML and stands without the script; the script draws
//! the meshes and the charts. A content security policy in the page forbids any request.
//!
//! Limits: pictures are thinned above 20,000 triangles a method; the page says so where it
//! happens.

use super::picture::{self, MAX_DRAWN};
use super::tables::{self, Table};
use super::trade_off::{PLOT_STYLE, curve};
use crate::Comparison;
use crate::number_format::{angle, count};
use std::io::{self, Write};

const HEAD: &str = include_str!("head.html");
const PAGE: &str = include_str!("page.html");
const STYLE: &str = include_str!("page.css");
/// One script in parts; later parts use earlier ones.
const SCRIPT: &str = concat!(
    include_str!("shared.js"),
    include_str!("picture.js"),
    include_str!("charts.js"),
    include_str!("page.js")
);

/// The intervals of so many sides are listed under the title.
const MAX_SIDES_LISTED: usize = 12;

/// Writes a comparison as one self-contained HTML page.
///
/// # Errors
///
/// Those of `out`.
///
/// # Example
///
/// ```
/// use mindeg_compare::{Options, compare, write_html};
/// use mindeg::{Domain, Side};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?.named("plate")?;
/// let mut page = Vec::new();
/// write_html(&compare(&domain, &Options::default())?, &mut page)?;
/// assert!(String::from_utf8(page)?.contains("<h1>plate</h1>"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_html(comparison: &Comparison, mut out: impl Write) -> io::Result<()> {
    let report = comparison.report();
    let name = report.domain.name.as_deref().unwrap_or("Domain");
    let data = serde_json::to_string(&picture::picture(comparison))?;
    let verdict = comparison.verdict();
    let (headline, sentences) = verdict.split_first().map_or(("", &[][..]), |(h, s)| (h, s));
    let sentences: String =
        sentences.iter().map(|sentence| format!("<p>{}</p>\n", escaped(sentence))).collect();
    let page = filled(
        PAGE,
        &[
            ("head", &head(&escaped(name), "compare", &[STYLE, PLOT_STYLE], true)),
            ("title", &escaped(name)),
            ("facts", &facts(&report.domain.intervals, report.domain.optimal_max_degree)),
            ("headline", &escaped(headline)),
            ("sentences", &sentences),
            ("overview", &html_table(&tables::overview(report), 0)),
            ("figures", &figures(comparison)),
            ("trade_off", &trade_off(comparison)),
            ("degrees", &html_table(&tables::degrees(report), 3)),
            ("shares", &html_table(&tables::shares(report), 3)),
            ("metrics", &html_tables(&tables::metrics(report))),
            ("worst", &html_tables(&tables::worst(report))),
            ("methods", &methods(comparison)),
            ("version", env!("CARGO_PKG_VERSION")),
            ("data", &script_safe(&data)),
            ("script", SCRIPT),
        ],
    );
    out.write_all(page.as_bytes())
}

/// The curve of the exact trade-off, or why there is none.
fn trade_off(comparison: &Comparison) -> String {
    match comparison.trade_off() {
        Some(trade_off) => curve(trade_off, |_, marker| marker),
        None => "<p class=\"note\">Not worked out here: the domain is large for that. \
                 <code>mindeg tradeoff</code> can do it up to 4096 boundary vertices.</p>\n"
            .to_owned(),
    }
}

/// JSON in which no string can end the script element or start a comment.
fn script_safe(json: &str) -> String {
    json.replace('<', "\\u003c")
}

/// What every page begins with, from the first line to the command that made it. No page may fetch
/// anything, and only one that has a script may run any.
pub(super) fn head(title: &str, command: &str, styles: &[&str], has_script: bool) -> String {
    filled(
        HEAD,
        &[
            ("scripts", if has_script { "script-src 'unsafe-inline'; " } else { "" }),
            ("title", title),
            ("command", command),
            ("style", &styles.concat()),
        ],
    )
}

/// The template with each `{{name}}` replaced; what is put in is not looked at again.
pub(super) fn filled(template: &str, parts: &[(&str, &str)]) -> String {
    let mut pieces = template.split("{{");
    let mut page = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let (name, rest) = piece.split_once("}}").expect("every {{ of a template is closed");
        let part = parts.iter().find(|(known, _)| *known == name);
        let (_, part) = part.expect("every name of a template has its part");
        page.push_str(part);
        page.push_str(rest);
    }
    page
}

/// Text in which nothing is markup.
pub(super) fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            other => escaped.push(other),
        }
    }
    escaped
}

/// The domain in a line.
pub(super) fn facts(intervals: &[u32], optimal_max_degree: u32) -> String {
    let sides = intervals.len();
    let listed: Vec<String> =
        intervals.iter().take(MAX_SIDES_LISTED).map(|&intervals| count(intervals)).collect();
    let more = if sides > MAX_SIDES_LISTED { ", …" } else { "" };
    let vertices = intervals.iter().sum::<u32>();
    format!(
        "{sides} sides with {}{more} intervals · {} boundary vertices · {} triangles · least possible \
         maximum degree {}",
        listed.join(", "),
        count(vertices),
        count(vertices - 2),
        count(optimal_max_degree)
    )
}

/// A place for each method's picture, or why there is none.
fn figures(comparison: &Comparison) -> String {
    let mut html = String::new();
    for (place, (method, triangles)) in comparison.methods().enumerate() {
        let name = escaped(&method.name);
        let described = method.max_degree.zip(method.min_angle);
        let described = described.map(|(degree, smallest)| {
            format!("maximum degree {} · smallest angle {}", count(degree), angle(smallest))
        });
        let defects: String = method
            .defects
            .iter()
            .map(|defect| format!("<p class=\"defect\">{}</p>", escaped(&defect.message)))
            .collect();
        let thinned = if triangles.len() > MAX_DRAWN {
            format!(
                "<p class=\"thinned\">Thinned out: {} of {} triangles are drawn, the largest and \
                 others evenly. Figures and charts count all.</p>",
                count(MAX_DRAWN as u32),
                count(triangles.len() as u32)
            )
        } else {
            String::new()
        };
        let picture = if triangles.is_empty() {
            String::new()
        } else {
            format!(
                "<div class=\"stage\" tabindex=\"0\" role=\"application\" \
                 aria-label=\"Mesh by {name}\" aria-describedby=\"keys\" data-method=\"{place}\">\
                 <canvas></canvas><canvas></canvas></div>\n\
                 <p class=\"readout\"></p>\n\
                 <p class=\"jumps\"><button type=\"button\" data-jump=\"busiest\">Busiest \
                 vertex</button> <button type=\"button\" data-jump=\"worst\">Smallest angle\
                 </button></p>"
            )
        };
        html += &format!(
            "<figure class=\"mesh\"><figcaption><h3>{name}</h3><p>{}</p></figcaption>\
             {defects}{thinned}{picture}</figure>\n",
            described.unwrap_or_else(|| "no triangulation".to_owned())
        );
    }
    html
}

fn methods(comparison: &Comparison) -> String {
    let items = comparison.report().methods.iter().map(|method| {
        format!("<dt>{}</dt><dd>{}</dd>", escaped(&method.name), escaped(&method.description))
    });
    items.collect()
}

fn html_tables(tables: &[Table]) -> String {
    tables.iter().map(|table| html_table(table, 3)).collect()
}

/// A table with its title as a heading of the given level, without one for level 0.
pub(super) fn html_table(table: &Table, level: u8) -> String {
    let mut html = String::from("<section class=\"table\">");
    if level > 0 {
        html += &format!("<h{level}>{}</h{level}>", escaped(&table.title));
    }
    if !table.note.is_empty() {
        html += &format!("<p class=\"note\">{}</p>", escaped(&table.note));
    }
    html += &format!(
        "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{}\"><table><thead><tr>",
        escaped(&table.title)
    );
    for column in &table.columns {
        html += &format!("<th scope=\"col\">{}</th>", escaped(column));
    }
    html += "</tr></thead><tbody>";
    for row in &table.rows {
        html += "<tr>";
        for (place, cell) in row.iter().enumerate() {
            let cell = escaped(cell);
            html += &match place {
                0 => format!("<th scope=\"row\">{cell}</th>"),
                _ => format!("<td>{cell}</td>"),
            };
        }
        html += "</tr>";
    }
    html + "</tbody></table></div></section>\n"
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Options, compare};
    use mindeg::{Domain, Side};

    #[test]
    fn parts_are_put_in_once() {
        let page = filled("<{{a}}|{{b}}|{{a}}>", &[("a", "{{b}}"), ("b", "2")]);
        assert_eq!(page, "<{{b}}|2|{{b}}>");
    }

    #[test]
    fn data_cannot_break_out() {
        assert_eq!(script_safe(r#"["</script>", 1]"#), r#"["\u003c/script>", 1]"#);
    }

    #[test]
    fn names_cannot_break_out() {
        let name = "</script><script>alert(1)</script><!-- & \"'";
        let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(2); 4]).unwrap();
        let comparison = compare(&domain.named(name).unwrap(), &Options::default()).unwrap();
        let mut page = Vec::new();
        write_html(&comparison, &mut page).unwrap();
        let page = String::from_utf8(page).unwrap();
        assert!(!page.contains("alert(1)</script>") && !page.contains("<!-- &"));
        assert_eq!(page.matches("</script>").count(), 2);
    }
}
