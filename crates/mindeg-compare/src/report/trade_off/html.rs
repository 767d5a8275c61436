//! A trade-off as one HTML page that opens from disk, asks for nothing else and needs no script.
//!
//! Limits: two dozen meshes at most, evenly chosen.

use super::super::html::{escaped, facts, filled, head, html_table};
use super::super::tables::Table;
use super::{colored_degrees, only_io, plot, spread};
use crate::number_format::{count, percent, steady_angle};
use glam::DVec2;
use mindeg::Bounds;
use mindeg::exact::{ExactMesh, TradeOff};
use mindeg_formats::svg::Inset;
use std::io::{self, Write};

const PAGE: &str = include_str!("page.html");
const REPORT_STYLE: &str = include_str!("../page.css");
const STYLE: &str = include_str!("page.css");
pub(in crate::report) const PLOT_STYLE: &str = include_str!("plot.css");

/// The most meshes shown.
const MOST_MESHES: usize = 24;

/// The size of the plot, and of the room for a mesh, in the pictures' own pixels.
const PLOT: DVec2 = DVec2::new(900.0, 400.0);
const MESH: DVec2 = DVec2::new(480.0, 400.0);
/// Room for the dots on the outline.
const MARGIN: f64 = 9.0;

/// Writes a trade-off as one self-contained HTML page.
///
/// # Errors
///
/// Those of `out`.
///
/// # Example
///
/// ```
/// use mindeg_compare::write_trade_off_html;
/// use mindeg::{Domain, Progress, Side, exact};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?.named("plate")?;
/// let mut page = Vec::new();
/// write_trade_off_html(&exact::trade_off(&domain, Progress::NONE)?, &mut page)?;
/// let page = String::from_utf8(page)?;
/// assert!(page.contains("<h1>plate</h1>") && page.contains("id=\"degree-5\""));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_trade_off_html(trade_off: &TradeOff, mut out: impl Write) -> io::Result<()> {
    let domain = trade_off.domain();
    let meshes = trade_off.meshes();
    let shown: Vec<usize> = spread(meshes.len(), MOST_MESHES).collect();
    let chosen = if shown.len() < meshes.len() {
        format!("{} of {}, evenly chosen. ", shown.len(), meshes.len())
    } else {
        String::new()
    };
    let figures = shown
        .iter()
        .map(|&place| figure(trade_off, &meshes[place]))
        .collect::<io::Result<String>>()?;
    let marker = |place: usize, marker: String| match shown.binary_search(&place) {
        Ok(_) => format!("<a href=\"#degree-{}\">{marker}</a>", meshes[place].max_degree),
        Err(_) => marker,
    };
    let [headline, rest @ ..] = &verdict(trade_off)[..] else { return Ok(()) };
    let sentences: String = rest.iter().map(|sentence| format!("<p>{sentence}</p>\n")).collect();
    let intervals: Vec<u32> = domain.boundary().sides().collect();
    let title = escaped(domain.name().unwrap_or("Domain"));
    let page = filled(
        PAGE,
        &[
            ("head", &head(&title, "tradeoff", &[REPORT_STYLE, PLOT_STYLE, STYLE], false)),
            ("title", &title),
            ("facts", &facts(&intervals, meshes[0].max_degree)),
            ("headline", headline),
            ("sentences", &sentences),
            ("plot", &curve(trade_off, marker)),
            ("table", &html_table(&table(trade_off), 0)),
            ("chosen", &chosen),
            ("legend", &legend(trade_off)),
            ("figures", &figures),
            ("version", env!("CARGO_PKG_VERSION")),
        ],
    );
    out.write_all(page.as_bytes())
}

/// The curve as an SVG element; its looks are [`PLOT_STYLE`].
pub(in crate::report) fn curve(
    trade_off: &TradeOff,
    wrap: impl Fn(usize, String) -> String,
) -> String {
    let room = Bounds { min: DVec2::ZERO, max: PLOT };
    let plot = plot::plot(trade_off, room, wrap);
    format!(
        "<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"group\" \
         aria-labelledby=\"curve-title\">\n{plot}</svg>\n",
        PLOT.x, PLOT.y
    )
}

/// What the curve says, in sentences; the first is the headline.
fn verdict(trade_off: &TradeOff) -> Vec<String> {
    let describe = |exact: &ExactMesh| {
        format!(
            "{} ({} of Delaunay's)",
            steady_angle(exact.min_angle),
            percent(trade_off.share(exact))
        )
    };
    let meshes = trade_off.meshes();
    let delaunay = steady_angle(trade_off.delaunay_min_angle());
    let (Some(first), Some(last)) = (meshes.first(), meshes.last()) else { return Vec::new() };
    let has_all = last.min_angle >= trade_off.delaunay_min_angle();
    let (least, most) = (count(first.max_degree), count(last.max_degree));
    let mut sentences = vec![match (meshes.len(), has_all) {
        (1, true) => format!(
            "The least possible maximum degree, {least}, costs no angle: the smallest is {delaunay}, \
             as large as in any triangulation."
        ),
        (_, true) => format!(
            "Degree {least}, the least possible, has a smallest angle of at most {}; degree {most} \
             has Delaunay's {delaunay} in full.",
            describe(first)
        ),
        (1, false) => format!(
            "Degree {least}, the least possible, has a smallest angle of at most {}, and more \
             degrees do not help.",
            describe(first)
        ),
        (_, false) => format!(
            "Degree {least}, the least possible, has a smallest angle of at most {}; degree {most} \
             has {}, and more do not help.",
            describe(first),
            describe(last)
        ),
    }];
    if let [_, second, _, ..] = meshes {
        sentences.push(format!("One degree above the least buys {}.", describe(second)));
    }
    if !has_all {
        sentences.push(format!("Caps of single vertices stand against Delaunay's {delaunay}."));
    }
    sentences
}

fn table(trade_off: &TradeOff) -> Table {
    let row = |exact: &ExactMesh| {
        vec![
            count(exact.max_degree),
            steady_angle(exact.min_angle),
            percent(trade_off.share(exact)),
            steady_angle(exact.mesh.angle_range().max),
        ]
    };
    Table {
        title: "What each degree buys".to_owned(),
        note: String::new(),
        columns: ["Maximum degree", "Smallest angle", "Share of Delaunay's", "Largest angle"]
            .map(str::to_owned)
            .into(),
        rows: trade_off.meshes().iter().map(row).collect(),
    }
}

/// The degrees that occur, with their colors.
fn legend(trade_off: &TradeOff) -> String {
    let degree = |(color, name): (String, String)| {
        format!(
            "<span class=\"degree\"><span class=\"dot\" style=\"background:{color}\"></span>\
             {name}</span>"
        )
    };
    format!("degree {}", colored_degrees(trade_off).map(degree).collect::<String>())
}

fn figure(trade_off: &TradeOff, exact: &ExactMesh) -> io::Result<String> {
    let room = Bounds { min: DVec2::splat(MARGIN), max: MESH - MARGIN };
    let inset = Inset::new(trade_off.domain().placement().bounds(), room);
    let mut drawing = Vec::new();
    inset.write(&exact.mesh, &mut drawing).map_err(only_io)?;
    let stretched = inset
        .stretch()
        .map(|stretch| format!("<p class=\"stretched\">Not to scale: {stretch}.</p>"));
    let degree = exact.max_degree;
    Ok(format!(
        "<figure class=\"mesh\" id=\"degree-{degree}\"><figcaption><h3>Degree {}</h3><p>smallest angle \
         {} · {} of Delaunay's</p></figcaption>{}<svg viewBox=\"0 0 {} {:.0}\" role=\"img\" \
         aria-label=\"The mesh of degree {degree}\">\n{}</svg></figure>\n",
        count(degree),
        steady_angle(exact.min_angle),
        percent(trade_off.share(exact)),
        stretched.unwrap_or_default(),
        MESH.x,
        inset.size().y + 2.0 * MARGIN,
        String::from_utf8_lossy(&drawing),
    ))
}
