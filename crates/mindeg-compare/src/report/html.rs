//! A report as one HTML page that opens from disk and asks for nothing else.
//!
//! The text (verdict, tables) is plain HTML and needs no script; the script draws
//! the meshes and the charts. A content security policy in the page forbids any request. The
//! templates in `templates/` escape what they are given; style, script, data and pictures made here
//! are put in as they are.
//!
//! Limits: pictures are thinned above 20,000 triangles a method; the page says so where it
//! happens.

use super::picture;
use super::scene::{MAX_DRAWN, thinned};
use super::svg::{self, CURVE_STYLE, Curve, Marks};
use super::tables::{self, Table};
use super::titles::{self, title};
use super::viewer::{SCRIPT, STYLE};
use super::{Provenance, Report};
use crate::advised::advised;
use crate::figures::MethodFigures;
use crate::verdict::{Verdict, left_out, verdict};
use crate::{Comparison, Method};
use askama::Template;
use glam::DVec2;
use mindeg::exact::TradeOff;
use mindeg_answers::advice::Purpose;
use mindeg_answers::command::MeshCommand;
use mindeg_answers::numbers::{count, steady_angle};
use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};
use std::io::{self, Write};

/// The characters to escape in a link: all but letters, digits and these.
const PLAIN: &AsciiSet = &NON_ALPHANUMERIC.remove(b'-').remove(b'.').remove(b'_').remove(b'/');

/// The intervals of so many sides are listed under the title.
const MAX_SIDES_LISTED: usize = 12;

/// The size of a curve beside text or on a phone, in its own pixels.
pub(super) const SMALL_CURVE: DVec2 = DVec2::new(380.0, 290.0);

/// Where a page's neighbors are: relative paths, with `/` between their parts.
///
/// # Example
///
/// ```
/// use mindeg_compare::PageLinks;
///
/// let links = PageLinks { index: Some("index.html".to_owned()), ..PageLinks::default() };
/// assert_eq!(links.next, None);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PageLinks {
    /// The page that lists all.
    pub index: Option<String>,
    /// The name of the page before this in the list, and its path.
    pub previous: Option<(String, String)>,
    /// The name of the page after this in the list, and its path.
    pub next: Option<(String, String)>,
}

#[derive(Template)]
#[template(path = "comparison.html")]
struct Page<'a> {
    title: &'a str,
    provenance: &'a Provenance,
    links: Links<'a>,
    style: String,
    facts: String,
    verdict: Verdict,
    choice: Table,
    commands: Vec<String>,
    is_map: bool,
    is_in_space: bool,
    curve: Option<String>,
    main_figures: Vec<Figure<'a>>,
    other_figures: Vec<Figure<'a>>,
    overview: Table,
    interior: Option<Table>,
    sides: Table,
    all_figures: Vec<Table>,
    worst: Vec<Table>,
    methods: Vec<Explained<'a>>,
    data: String,
    script: &'static str,
}

/// A method: the title of its mesh, that of the same mesh before it, and what it does.
struct Explained<'a> {
    title: String,
    same: Option<String>,
    description: &'a str,
}

impl<'a> Explained<'a> {
    fn of(report: &Report, method: &'a MethodFigures) -> Self {
        Self {
            title: title(report, method.method),
            same: method.same_mesh_as.map(|other| title(report, other)),
            description: &method.description,
        }
    }
}

/// [`PageLinks`] as they stand in a page.
struct Links<'a> {
    index: Option<String>,
    previous: Option<(&'a str, String)>,
    next: Option<(&'a str, String)>,
}

/// An element for a mesh's picture, or the reason why it is missing.
pub(super) struct Figure<'a> {
    pub(super) place: usize,
    pub(super) name: String,
    /// The purposes that it is advised for.
    pub(super) advised: Option<&'static str>,
    pub(super) described: String,
    /// Its defects.
    pub(super) defects: Vec<&'a str>,
    pub(super) thinned: Option<String>,
    pub(super) has_triangles: bool,
    /// The commands that make it, if it is advised.
    pub(super) commands: Vec<String>,
}

/// Writes a comparison as one self-contained HTML page.
///
/// # Errors
///
/// The errors of `out`.
///
/// # Example
///
/// ```
/// use mindeg_compare::{CompareOptions, compare, write_html};
/// use mindeg::{Domain, Side};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?.named("plate")?;
/// let mut page = Vec::new();
/// write_html(&compare(&domain, &CompareOptions::default())?, &mut page)?;
/// assert!(String::from_utf8(page)?.contains("<h1>plate</h1>"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_html(comparison: &Comparison, out: impl Write) -> io::Result<()> {
    write_linked_html(comparison, &PageLinks::default(), out)
}

/// Writes a comparison as one self-contained HTML page that leads to others.
///
/// # Errors
///
/// The errors of `out`.
///
/// # Example
///
/// ```
/// use mindeg_compare::{CompareOptions, PageLinks, compare, write_linked_html};
/// use mindeg::{Domain, Side};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?;
/// let links = PageLinks {
///     index: Some("index.html".to_owned()),
///     next: Some(("wing".to_owned(), "wing.html".to_owned())),
///     ..PageLinks::default()
/// };
/// let mut page = Vec::new();
/// write_linked_html(&compare(&domain, &CompareOptions::default())?, &links, &mut page)?;
/// assert!(String::from_utf8(page)?.contains(r#"<a href="wing.html""#));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_linked_html(
    comparison: &Comparison,
    links: &PageLinks,
    mut out: impl Write,
) -> io::Result<()> {
    let report = comparison.report();
    let data = serde_json::to_string(&picture::of_comparison(comparison))?;
    let mut all_figures = vec![tables::degrees(report), tables::shares(report)];
    all_figures.extend(tables::metrics(report));
    let command = &report.provenance.mesh;
    let (main_figures, other_figures) = figures(comparison, command);
    let page = Page {
        title: report.domain.name.as_deref().or(report.provenance.title()).unwrap_or("Domain"),
        provenance: &report.provenance,
        links: Links {
            index: links.index.as_deref().map(link),
            previous: links.previous.as_ref().map(|(name, path)| (name.as_str(), link(path))),
            next: links.next.as_ref().map(|(name, path)| (name.as_str(), link(path))),
        },
        style: svg::page_style(&[STYLE, CURVE_STYLE]),
        facts: facts(
            &report.domain.intervals,
            report.domain.holes,
            report.domain.regions,
            [report.domain.vertices, report.domain.triangles],
            report.domain.at_least,
            report.domain.least_max_degree.is_some(),
        ),
        verdict: verdict(report),
        choice: tables::choice(report),
        commands: commands_without_mesh(report),
        is_in_space: false,
        is_map: report.domain.regions.is_some(),
        curve: comparison.trade_off().map(|curve| small_curve(report, curve)).transpose()?,
        main_figures,
        other_figures,
        overview: tables::overview(report),
        interior: tables::interior(report),
        sides: tables::sides(report),
        all_figures,
        worst: tables::worst(&titles::named(report)),
        methods: report.methods.iter().map(|method| Explained::of(report, method)).collect(),
        data: script_safe(&data),
        script: SCRIPT,
    };
    out.write_all(rendered(&page)?.as_bytes())
}

/// The curve of a comparison, with marks on the meshes that the verdict compares; empty for a single point.
fn small_curve(report: &Report, trade_off: &TradeOff) -> io::Result<String> {
    let delaunay = report.methods.iter().find(|figures| figures.method == Method::DELAUNAY);
    let marks = Marks {
        advised: report.advice.patch.map(|patch| patch.max_degree),
        delaunay: delaunay.and_then(|figures| figures.max_degree),
        inside: report.advice.solver,
        ..Marks::default()
    };
    curve_picture(trade_off, SMALL_CURVE, "small", marks, |_| false)
}

/// A relative path as a link, in which nothing has a meaning of its own: neither `?` nor `#`, and
/// a colon makes no scheme.
pub(super) fn link(path: &str) -> String {
    utf8_percent_encode(path, PLAIN).to_string()
}

/// The output of a template.
pub(super) fn rendered(template: &impl Template) -> io::Result<String> {
    template.render().map_err(io::Error::other)
}

/// The curve of a trade-off as an SVG element of a page that has its style; nothing where it is a
/// single point.
pub(super) fn curve_picture(
    trade_off: &TradeOff,
    size: DVec2,
    class: &str,
    marks: Marks,
    is_linked: impl Fn(u32) -> bool,
) -> io::Result<String> {
    let [first, .., last] = trade_off.meshes() else { return Ok(String::new()) };
    let curve = rendered(&Curve::new(trade_off, svg::space(size), marks, is_linked))?;
    Ok(format!(
        "<svg class=\"plot {class}\" viewBox=\"0 0 {} {}\" role=\"group\" aria-label=\"The curve: a minimum \
         angle of {} at degree {} up to {} at degree {}; Delaunay has {}.\">\n{curve}</svg>\n",
        size.x,
        size.y,
        steady_angle(first.min_angle),
        count(first.max_degree),
        steady_angle(last.min_angle),
        count(last.max_degree),
        steady_angle(trade_off.delaunay_min_angle()),
    ))
}

/// JSON in which no string can end the script element or start a comment.
pub(super) fn script_safe(json: &str) -> String {
    json.replace('<', "\\u003c")
}

/// The domain in a line; its least maximum degree is that, or a bound.
pub(super) fn facts(
    intervals: &[u32],
    holes: u32,
    regions: Option<u32>,
    [vertices, triangles]: [u32; 2],
    least: u32,
    is_proven: bool,
) -> String {
    let sides = intervals.len();
    let listed: Vec<String> =
        intervals.iter().take(MAX_SIDES_LISTED).map(|&intervals| count(intervals)).collect();
    let more = if sides > MAX_SIDES_LISTED { ", …" } else { "" };
    let holes_in_words = match holes {
        0 => String::new(),
        1 => " · 1 hole".to_owned(),
        holes => format!(" · {} holes", count(holes)),
    };
    let regions_in_words = match regions {
        None => String::new(),
        Some(1) => " · 1 region".to_owned(),
        Some(regions) => format!(" · {} regions", count(regions)),
    };
    format!(
        "{sides} {} with {}{more} intervals{holes_in_words}{regions_in_words} · {} {} · {} triangles · \
         least possible maximum degree {}{}",
        if sides == 1 { "side" } else { "sides" },
        listed.join(", "),
        count(vertices),
        vertex_words(regions),
        count(triangles),
        count(least),
        if is_proven { "" } else { " or more" }
    )
}

/// The commands that make the advised meshes, the one to take first.
pub(super) fn commands(report: &Report) -> Vec<String> {
    let purposes = report.advice.purposes(report.purpose);
    let possible = purposes.into_iter().filter(|&purpose| report.advice.is_possible(purpose));
    let commands = possible.map(|purpose| report.provenance.mesh.advised(purpose));
    commands.chain(conditioned_command(report)).collect()
}

/// The command of the mesh with points on edges, if the verdict names it: no method has that mesh.
fn conditioned_command(report: &Report) -> Option<String> {
    let on_edges = report.advice.on_edges(&report.advice.purposes(report.purpose));
    on_edges.map(|_| report.provenance.mesh.conditioned())
}

fn advised_for(purpose: Purpose) -> &'static str {
    match purpose {
        Purpose::Solver => "for a solver",
        Purpose::Patch => "for a patch that keeps its points",
        Purpose::Fewest => "for the fewest edges at a vertex",
    }
}

/// Vertices: a map has some inside.
pub(super) fn vertex_words(regions: Option<u32>) -> &'static str {
    if regions.is_some() { "vertices" } else { "boundary vertices" }
}

/// The commands whose mesh the comparison does not have.
fn commands_without_mesh(report: &Report) -> Vec<String> {
    let shown: Vec<Purpose> = advised(report).into_iter().map(|(purpose, _)| purpose).collect();
    let purposes = report.advice.purposes(report.purpose);
    let is_missing =
        |purpose: &Purpose| !shown.contains(purpose) && report.advice.is_possible(*purpose);
    let missing = purposes.into_iter().filter(is_missing);
    let commands = missing.map(|purpose| report.provenance.mesh.advised(purpose));
    commands.chain(conditioned_command(report)).collect()
}

/// The meshes that the verdict compares, the advised one first, and the others.
fn figures<'a>(
    comparison: &'a Comparison,
    command: &MeshCommand,
) -> (Vec<Figure<'a>>, Vec<Figure<'a>>) {
    let report = comparison.report();
    let advised = advised(report);
    let mut main = Vec::new();
    let mut others = Vec::new();
    for (place, named) in titles::named(report).into_iter().enumerate() {
        let method = named.figures;
        let triangles = comparison.triangles(named.place).len();
        let described = match method.max_degree.zip(method.min_angle) {
            Some((degree, least)) => {
                format!("maximum degree {} · minimum angle {}", count(degree), steady_angle(least))
            }
            None => "no triangulation".to_owned(),
        };
        let messages = method.defects.iter().map(|defect| &*defect.message);
        let place_advised = advised.iter().position(|(_, other)| *other == method.method);
        let figure = Figure {
            place,
            name: named.name,
            advised: place_advised.map(|place| advised_for(advised[place].0)),
            described,
            defects: left_out(method).into_iter().chain(messages).collect(),
            thinned: thinned(triangles, MAX_DRAWN),
            has_triangles: triangles > 0,
            commands: advised
                .iter()
                .filter(|(_, other)| *other == method.method)
                .map(|&(purpose, _)| command.advised(purpose))
                .collect(),
        };
        match method.method {
            _ if place_advised.is_some() => main.push(figure),
            Method::LeastDegree | Method::DELAUNAY => main.push(figure),
            _ => others.push(figure),
        }
    }
    // The one to take comes first.
    let order = |figure: &Figure<'_>| {
        let found =
            advised.iter().position(|(purpose, _)| figure.advised == Some(advised_for(*purpose)));
        found.unwrap_or(usize::MAX)
    };
    main.sort_by_key(order);
    (main, others)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CompareOptions, compare};
    use mindeg::{Domain, Side};

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

    #[test]
    fn the_page_says_what_made_it_and_how_to_make_the_mesh() {
        let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(4); 4]).unwrap();
        let command = "mindeg compare 'a b.json' -o <x>".to_owned();
        let made_by = Provenance {
            input: Some("out/of here/a b.json".to_owned()),
            command: Some(command),
            mesh: MeshCommand::of(&["out/of here/a b.json".to_owned()], &domain),
            ..Provenance::default()
        };
        let comparison = compare(&domain, &CompareOptions::default()).unwrap().made_by(made_by);
        let mut page = Vec::new();
        write_html(&comparison, &mut page).unwrap();
        let page = String::from_utf8(page).unwrap();
        assert!(page.contains("<h1>a b</h1>"));
        assert!(page.contains(
            "mindeg mesh &#39;out/of here/a b.json&#39; --keep-angle 95% -o mesh-keep-angle-95.obj"
        ));
        assert!(page.contains("<code>mindeg compare &#39;a b.json&#39; -o &#60;x&#62;</code>"));
    }

    #[test]
    fn data_cannot_break_out() {
        assert_eq!(script_safe(r#"["</script>", 1]"#), r#"["\u003c/script>", 1]"#);
    }

    #[test]
    fn names_cannot_break_out() {
        let name = "</script><script>alert(1)</script><!-- & \"'";
        let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(2); 4]).unwrap();
        let comparison = compare(&domain.named(name).unwrap(), &CompareOptions::default()).unwrap();
        let mut page = Vec::new();
        write_html(&comparison, &mut page).unwrap();
        let page = String::from_utf8(page).unwrap();
        assert!(!page.contains("alert(1)</script>") && !page.contains("<!-- &"));
        assert_eq!(page.matches("</script>").count(), 2);
    }

    #[test]
    fn only_methods_with_a_mesh_have_a_picture() {
        // No side of 2, so that every fan has a flat triangle.
        let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(4); 4]).unwrap();
        let comparison = compare(&domain, &CompareOptions::default()).unwrap();
        let (main, others) =
            figures(&comparison, &MeshCommand::of(&["plate.json".to_owned()], &domain));
        let without = |figures: &[Figure<'_>]| -> Vec<String> {
            let missing = figures.iter().filter(|figure| !figure.has_triangles);
            missing.map(|figure| figure.name.clone()).collect()
        };
        assert!(main.len() >= 2 && without(&main).is_empty());
        assert_eq!(without(&others), ["Fan"]);
    }
}
