//! A trade-off as one picture: the curve, and below it small pictures of its meshes.
//!
//! Limits: eight meshes at most, evenly chosen.

use super::super::html::{rendered, vertex_words};
use super::super::svg::{self, CURVE_STYLE, Curve, Marks};
use super::spread;
use crate::regions::regions;
use askama::Template;
use glam::DVec2;
use mindeg::Bounds;
use mindeg::exact::TradeOff;
use mindeg_answers::numbers::{count, percent, steady_angle};
use mindeg_formats::one_line;
use mindeg_formats::svg::{Inset, STYLE};
use std::io::{self, Write};

/// The most meshes shown, and how many of them side by side.
const MOST_MESHES: usize = 8;
const MOST_COLUMNS: usize = 4;

/// The size of the picture's parts, in pixels.
const WIDTH: f64 = 960.0;
const MARGIN: f64 = 56.0;
const PLOT_TOP: f64 = 100.0;
const PLOT_HEIGHT: f64 = 380.0;
const GAP: f64 = 28.0;
const MOST_HEIGHT: f64 = 240.0;
const CAPTION: f64 = 56.0;
const LEGEND: f64 = 44.0;

/// The looks of the captions.
const CAPTION_STYLE: &str =
    ".caption { font-size: 15px; font-weight: 600; text-anchor: middle; }\n";

#[derive(Template)]
#[template(path = "trade_off.svg")]
struct Picture {
    version: &'static str,
    name: String,
    summary: String,
    style: String,
    size: DVec2,
    margin: f64,
    curve: String,
    meshes: Vec<SmallMesh>,
    legend: Vec<LegendEntry>,
    legend_y: f64,
}

/// A mesh and what is written below it.
struct SmallMesh {
    drawing: String,
    middle: f64,
    caption_y: f64,
    share_y: f64,
    degree: String,
    angle: String,
    share: String,
}

/// The color of a degree, and where it is named.
struct LegendEntry {
    x: f64,
    color: String,
    name: String,
}

/// Writes a trade-off as one SVG picture, which fetches nothing.
///
/// # Errors
///
/// The errors of `out`.
///
/// # Example
///
/// ```
/// use mindeg_compare::write_trade_off_svg;
/// use mindeg::{Domain, Progress, Side, exact};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?.named("plate")?;
/// let mut picture = Vec::new();
/// write_trade_off_svg(&exact::trade_off(&domain, Progress::NONE)?, &mut picture)?;
/// let picture = String::from_utf8(picture)?;
/// assert!(picture.contains(">plate</text>") && picture.contains("degree 5 · 6.340°"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_trade_off_svg(trade_off: &TradeOff, mut out: impl Write) -> io::Result<()> {
    let meshes = trade_off.meshes();
    let shown: Vec<usize> = spread(meshes.len(), MOST_MESHES).collect();
    let columns = shown.len().min(MOST_COLUMNS);
    let width = (WIDTH - 2.0 * MARGIN + GAP) / columns as f64 - GAP;
    let bounds = trade_off.domain().placement().bounds();
    // Every mesh gets a space of the same size, whose position is not yet known.
    let at_origin = Inset::new(bounds, svg::space(DVec2::new(width, MOST_HEIGHT)));
    let drawn_height = at_origin.size().y;
    // A single point makes no curve.
    let has_curve = meshes.len() > 1;
    let first_row = PLOT_TOP + if has_curve { PLOT_HEIGHT + GAP } else { 0.0 };
    let rows = shown.len().div_ceil(columns);
    let height = first_row + rows as f64 * (drawn_height + CAPTION) + LEGEND;

    let mut summary = format!(
        "{} {} · the largest minimum angle {}for each maximum degree",
        count(meshes[0].mesh.vertex_count()),
        vertex_words(regions(trade_off.domain())),
        if trade_off.is_exact() { "" } else { "that windows reach " }
    );
    if let Some(stretch) = at_origin.stretch() {
        summary += &format!(" · {stretch}");
    }
    let small_mesh = |(cell, place): (usize, usize)| {
        let exact = &meshes[place];
        let at = DVec2::new(
            MARGIN + (cell % columns) as f64 * (width + GAP),
            first_row + (cell / columns) as f64 * (drawn_height + CAPTION),
        );
        let space = Bounds { min: at, max: at + DVec2::new(width, MOST_HEIGHT) };
        Ok(SmallMesh {
            drawing: svg::mesh(&exact.mesh, bounds, space)?,
            middle: svg::pixel(at.x + width / 2.0),
            caption_y: svg::pixel(at.y + drawn_height + 22.0),
            share_y: svg::pixel(at.y + drawn_height + 40.0),
            degree: count(exact.max_degree),
            angle: steady_angle(exact.min_angle),
            share: percent(trade_off.share(exact)),
        })
    };
    let legend =
        svg::degree_legend(trade_off, None).into_iter().enumerate().map(|(place, degree)| {
            LegendEntry {
                x: MARGIN + 62.0 + 44.0 * place as f64,
                color: degree.color,
                name: degree.name,
            }
        });
    let curve_space = Bounds {
        min: DVec2::new(MARGIN, PLOT_TOP),
        max: DVec2::new(WIDTH - MARGIN, PLOT_TOP + PLOT_HEIGHT),
    };
    let picture = Picture {
        version: env!("CARGO_PKG_VERSION"),
        name: one_line(trade_off.domain().name().unwrap_or("mesh")),
        summary,
        style: STYLE.to_owned() + &svg::standalone_style(CURVE_STYLE) + CAPTION_STYLE,
        size: DVec2::new(WIDTH, height).round(),
        margin: MARGIN,
        curve: match has_curve {
            true => rendered(&Curve::new(trade_off, curve_space, Marks::default(), |_| false))?,
            false => String::new(),
        },
        meshes: shown.into_iter().enumerate().map(small_mesh).collect::<io::Result<_>>()?,
        legend: legend.collect(),
        legend_y: svg::pixel(height - 26.0),
    };
    out.write_all(rendered(&picture)?.as_bytes())
}
