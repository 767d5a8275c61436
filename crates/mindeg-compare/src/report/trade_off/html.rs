//! A trade-off as one HTML page that opens from disk, asks for nothing else and needs no script.
//!
//! Limits: two dozen meshes at most, evenly chosen.

use super::super::html::{STYLE, VERSION, curve_picture, facts, rendered};
use super::super::svg::{self, CURVE_STYLE, DegreeColor};
use super::super::tables::Table;
use super::spread;
use crate::exact::{ExactMesh, TradeOff};
use crate::number_format::{count, percent, steady_angle};
use askama::Template;
use glam::DVec2;
use mindeg_geometry::Bounds;
use mindeg_geometry::export::svg::Inset;
use std::io::{self, Write};

const MESHES_STYLE: &str = include_str!("page.css");

/// The most meshes shown.
const MOST_MESHES: usize = 24;

/// The space for a mesh, in the picture's own pixels.
const MESH: DVec2 = DVec2::new(480.0, 400.0);
/// Space for the dots on the outline.
const MARGIN: f64 = 9.0;

#[derive(Template)]
#[template(path = "trade_off.html")]
struct Page<'a> {
    title: &'a str,
    version: &'static str,
    style: String,
    facts: String,
    headline: &'a str,
    sentences: &'a [String],
    curve: String,
    chosen: String,
    legend: Vec<DegreeColor>,
    /// The size of every mesh's picture.
    size: DVec2,
    /// How the pictures are not to scale, if they are not.
    stretch: Option<String>,
    figures: Vec<Figure>,
    table: Table,
}

/// A mesh with its figures.
struct Figure {
    max_degree: u32,
    degree: String,
    angle: String,
    share: String,
    drawing: String,
}

/// Writes a trade-off as one self-contained HTML page.
///
/// # Errors
///
/// Those of `out`.
///
/// # Example
///
/// ```
/// use mindeg_compare::{exact, write_trade_off_html};
/// use mindeg_geometry::{Domain, Side};
/// use mindeg_exact::unwatched;
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?.named("plate")?;
/// let mut page = Vec::new();
/// write_trade_off_html(&exact::trade_off(&domain, &mut unwatched)?, &mut page)?;
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
    let bounds = domain.placement().bounds();
    let space = Bounds { min: DVec2::splat(MARGIN), max: MESH - MARGIN };
    let figure = |&place: &usize| {
        let exact = &meshes[place];
        Ok(Figure {
            max_degree: exact.max_degree,
            degree: count(exact.max_degree),
            angle: steady_angle(exact.min_angle),
            share: percent(trade_off.share(exact)),
            drawing: svg::mesh(&exact.mesh, bounds, space)?,
        })
    };
    let is_shown = |degree| shown.iter().any(|&place| meshes[place].max_degree == degree);
    let [headline, sentences @ ..] = &verdict(trade_off)[..] else { return Ok(()) };
    let intervals: Vec<u32> = domain.boundary().sides().collect();
    let inset = Inset::new(bounds, space);
    let page = Page {
        title: domain.name().unwrap_or("Domain"),
        version: VERSION,
        style: svg::page_style(&[STYLE, CURVE_STYLE, MESHES_STYLE]),
        facts: facts(&intervals, meshes[0].max_degree),
        headline,
        sentences,
        curve: curve_picture(trade_off, is_shown)?,
        chosen,
        legend: svg::degree_legend(trade_off),
        size: DVec2::new(MESH.x, inset.size().y + 2.0 * MARGIN).round(),
        stretch: inset.stretch(),
        figures: shown.iter().map(figure).collect::<io::Result<_>>()?,
        table: table(trade_off),
    };
    out.write_all(rendered(&page)?.as_bytes())
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
