//! A trade-off as one picture: the curve, and below it small pictures of its meshes.
//!
//! Limits: eight meshes at most, evenly chosen.

use super::super::html::escaped;
use super::{colored_degrees, only_io, plot, spread};
use crate::number_format::{count, percent, steady_angle};
use glam::DVec2;
use mindeg::Bounds;
use mindeg::exact::TradeOff;
use mindeg_formats::svg::{self, Inset};
use std::fmt::Write as _;
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

/// The colors of the plot, without variables: not every viewer knows them.
const STYLE: &str = "\
.axis{fill:none;stroke:#2b3440}.grid{fill:none;stroke:#e4e9ee}\
.curve{fill:none;stroke:#0a63c9;stroke-width:2.5;stroke-linejoin:round}\
.point{fill:#0a63c9}.ringed{stroke:#fff;stroke-width:1.5}\
.ceiling{fill:none;stroke:#c2410c;stroke-width:1.5;stroke-dasharray:6 5}\
.tick{font-size:13px;fill:#59636e}.value{font-size:13px;font-weight:600}\
.caption{font-size:15px;font-weight:600;text-anchor:middle}\
@media(prefers-color-scheme:dark){\
.axis{stroke:#c3ccd8}.grid{stroke:#262c34}.curve{stroke:#6cb0ff}\
.point{fill:#6cb0ff}.ringed{stroke:#0d1117}.ceiling{stroke:#ff9d5c}.tick{fill:#9198a1}}";

/// Writes a trade-off as one SVG picture, which fetches nothing.
///
/// # Errors
///
/// Those of `out`.
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
    // Every mesh gets a room of the same size, whose place is not yet known.
    let inset = |at: DVec2| {
        Inset::new(bounds, Bounds { min: at, max: at + DVec2::new(width, MOST_HEIGHT) })
    };
    let at_origin = inset(DVec2::ZERO);
    let drawn_height = at_origin.size().y;
    let first_row = PLOT_TOP + PLOT_HEIGHT + GAP;
    let rows = shown.len().div_ceil(columns);
    let height = first_row + rows as f64 * (drawn_height + CAPTION) + LEGEND;

    let name = escaped(trade_off.domain().name().unwrap_or("mesh"));
    let mut summary = format!(
        "{} boundary vertices · the largest smallest angle for each maximum degree",
        count(trade_off.domain().boundary().vertex_count())
    );
    if let Some(stretch) = at_origin.stretch() {
        summary += &format!(" · {stretch}");
    }
    write!(
        out,
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height:.0}" viewBox="0 0 {WIDTH} {height:.0}" role="img" aria-labelledby="title summary">
<title id="title">{name}: what each degree buys</title>
<desc id="summary">{summary}</desc>
<metadata>mindeg {}</metadata>
<style>{}{STYLE}</style>
<rect class="card" x="0.5" y="0.5" width="{}" height="{:.0}" rx="12"/>
<text class="title" x="{MARGIN}" y="46">{name}</text>
<text class="muted" x="{MARGIN}" y="70">{summary}</text>
"#,
        env!("CARGO_PKG_VERSION"),
        svg::STYLE,
        WIDTH - 1.0,
        height - 1.0,
    )?;
    let room = Bounds {
        min: DVec2::new(MARGIN, PLOT_TOP),
        max: DVec2::new(WIDTH - MARGIN, PLOT_TOP + PLOT_HEIGHT),
    };
    out.write_all(plot::plot(trade_off, room, |_, marker| marker).as_bytes())?;
    for (cell, place) in shown.into_iter().enumerate() {
        let exact = &meshes[place];
        let at = DVec2::new(
            MARGIN + (cell % columns) as f64 * (width + GAP),
            first_row + (cell / columns) as f64 * (drawn_height + CAPTION),
        );
        let middle = at.x + width / 2.0;
        inset(at).write(&exact.mesh, &mut out).map_err(only_io)?;
        writeln!(
            out,
            r#"<text class="caption" x="{middle:.1}" y="{:.1}">degree {} · {}</text><text class="tick" text-anchor="middle" x="{middle:.1}" y="{:.1}">{} of the Delaunay angle</text>"#,
            at.y + drawn_height + 22.0,
            count(exact.max_degree),
            steady_angle(exact.min_angle),
            at.y + drawn_height + 40.0,
            percent(trade_off.share(exact)),
        )?;
    }
    out.write_all(legend(trade_off, height - 26.0).as_bytes())?;
    out.write_all(b"</svg>\n")
}

/// What the colors of the meshes' vertices mean.
fn legend(trade_off: &TradeOff, y: f64) -> String {
    let mut svg = format!("<text class=\"tick\" x=\"{MARGIN}\" y=\"{y:.1}\">degree</text>\n");
    for (place, (color, name)) in colored_degrees(trade_off).enumerate() {
        let x = MARGIN + 62.0 + 44.0 * place as f64;
        // Writing to a string cannot fail.
        let _ = writeln!(
            svg,
            r#"<circle cx="{x:.1}" cy="{:.1}" r="5" fill="{color}"/><text class="value" x="{:.1}" y="{y:.1}">{name}</text>"#,
            y - 4.5,
            x + 10.0,
        );
    }
    svg
}
