//! A report as one HTML page that opens from disk and asks for nothing else.
//!
//! What is read (verdict, tables) is plain HTML and stands without the script; the script draws
//! the meshes and the charts. A content security policy in the page forbids any request. The
//! templates in `templates/` escape what they are given; style, script, data and pictures made here
//! are put in as they are.
//!
//! Limits: pictures are thinned above 20,000 triangles a method; the page says so where it
//! happens.

use super::picture::{self, MAX_DRAWN};
use super::svg::{self, CURVE_STYLE, Curve};
use super::tables::{self, Table};
use super::{MethodDefect, MethodFigures};
use crate::Comparison;
use crate::exact::TradeOff;
use crate::number_format::{angle, count};
use askama::Template;
use glam::DVec2;
use std::io::{self, Write};

/// The style of every page.
pub(super) const STYLE: &str = include_str!("page.css");

/// One script in parts; later parts use earlier ones.
const SCRIPT: &str = concat!(
    include_str!("shared.js"),
    include_str!("picture.js"),
    include_str!("charts.js"),
    include_str!("page.js")
);

/// The version on every page.
pub(super) const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The intervals of so many sides are listed under the title.
const MAX_SIDES_LISTED: usize = 12;

/// The size of the curve, in its own pixels.
const CURVE: DVec2 = DVec2::new(900.0, 400.0);

#[derive(Template)]
#[template(path = "comparison.html")]
struct Page<'a> {
    title: &'a str,
    version: &'static str,
    style: String,
    facts: String,
    headline: &'a str,
    sentences: &'a [String],
    overview: Table,
    figures: Vec<Figure<'a>>,
    curve: Option<String>,
    all_figures: Vec<Table>,
    worst: Vec<Table>,
    methods: &'a [MethodFigures],
    data: String,
    script: &'static str,
}

/// A place for a method's picture, or why there is none.
struct Figure<'a> {
    place: usize,
    name: String,
    described: String,
    defects: &'a [MethodDefect],
    thinned: Option<String>,
    has_triangles: bool,
}

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
/// use mindeg_geometry::{Domain, Side};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?.named("plate")?;
/// let mut page = Vec::new();
/// write_html(&compare(&domain, &Options::default())?, &mut page)?;
/// assert!(String::from_utf8(page)?.contains("<h1>plate</h1>"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_html(comparison: &Comparison, mut out: impl Write) -> io::Result<()> {
    let report = comparison.report();
    let data = serde_json::to_string(&picture::picture(comparison))?;
    let verdict = comparison.verdict();
    let (headline, sentences) = verdict.split_first().map_or(("", &[][..]), |(h, s)| (h, s));
    let mut all_figures = vec![tables::degrees(report), tables::shares(report)];
    all_figures.extend(tables::metrics(report));
    let page = Page {
        title: report.domain.name.as_deref().unwrap_or("Domain"),
        version: VERSION,
        style: svg::page_style(&[STYLE, CURVE_STYLE]),
        facts: facts(&report.domain.intervals, report.domain.optimal_max_degree),
        headline,
        sentences,
        overview: tables::overview(report),
        figures: figures(comparison),
        curve: comparison.trade_off().map(|curve| curve_picture(curve, |_| false)).transpose()?,
        all_figures,
        worst: tables::worst(report),
        methods: &report.methods,
        data: script_safe(&data),
        script: SCRIPT,
    };
    out.write_all(rendered(&page)?.as_bytes())
}

/// What a template writes.
pub(super) fn rendered(template: &impl Template) -> io::Result<String> {
    template.render().map_err(io::Error::other)
}

/// The curve of a trade-off as an SVG element of a page that has its style.
pub(super) fn curve_picture(
    trade_off: &TradeOff,
    is_linked: impl Fn(u32) -> bool,
) -> io::Result<String> {
    let curve = rendered(&Curve::new(trade_off, svg::space(CURVE), is_linked))?;
    Ok(format!(
        "<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"group\" \
         aria-labelledby=\"curve-title\">\n{curve}</svg>\n",
        CURVE.x, CURVE.y
    ))
}

/// JSON in which no string can end the script element or start a comment.
fn script_safe(json: &str) -> String {
    json.replace('<', "\\u003c")
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

fn figures(comparison: &Comparison) -> Vec<Figure<'_>> {
    let mut figures = Vec::new();
    for (place, (method, triangles)) in comparison.methods().enumerate() {
        let described = match method.max_degree.zip(method.min_angle) {
            Some((degree, smallest)) => {
                format!("maximum degree {} · smallest angle {}", count(degree), angle(smallest))
            }
            None => "no triangulation".to_owned(),
        };
        let thinned = (triangles.len() > MAX_DRAWN).then(|| {
            format!(
                "Thinned out: {} of {} triangles are drawn, the largest and others evenly. Figures \
                 and charts count all.",
                count(MAX_DRAWN as u32),
                count(triangles.len() as u32)
            )
        });
        figures.push(Figure {
            place,
            name: method.method.to_string(),
            described,
            defects: &method.defects,
            thinned,
            has_triangles: !triangles.is_empty(),
        });
    }
    figures
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Options, compare};
    use mindeg_geometry::{Domain, Side};

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
