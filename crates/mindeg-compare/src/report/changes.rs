//! The changes of a conditioned boundary as one picture: both boundaries with a mark at each change, and below them the places where
//! the boundary moved most, magnified.
//!
//! A change has the number of its place in the list of [`ConditionAnswer`], counted from 1. Every mark tells it where the pointer rests; it is
//! written beside those that have room.

mod lines;
mod marks;
mod panes;

use self::lines::{chains, mean_edge, path};
use self::marks::{Drawn, KINDS, Mark, Number, drawn, marks, numbers};
use self::panes::{Pane, pane, parts};
use super::html::rendered;
use super::svg::{self, pixel};
use askama::Template;
use glam::DVec2;
use mindeg::{Bounds, Domain};
use mindeg_answers::condition::ConditionAnswer;
use mindeg_answers::numbers::{count, number, steady_angle};
use mindeg_formats::one_line;
use mindeg_formats::svg::{Inset, STYLE};
use std::fmt::Write as _;
use std::io::{self, Write};

/// The size of the picture's parts, in pixels.
const WIDTH: f64 = 960.0;
const MARGIN: f64 = 56.0;
const TOP: f64 = 96.0;
const MOST_HEIGHT: f64 = 760.0;
const LEGEND_ROW: f64 = 26.0;
const COLUMNS: usize = 4;
const GAP: f64 = 16.0;
const CAPTION: f64 = 50.0;

const LOOKS: &str = "\
.water { fill: var(--good); stroke: none; }
.old { fill: none; stroke: var(--mark); stroke-linejoin: round; }
.new { fill: none; stroke: var(--outline); stroke-linejoin: round; }
.number { font-size: 11px; fill: var(--text); stroke: var(--card); stroke-width: 2.5; paint-order: stroke; }
.part { fill: none; stroke: var(--accent); stroke-width: 1.2; }
.pane { fill: var(--card); stroke: var(--line); }
.tick { font-size: 13px; fill: var(--muted); }
.value { font-size: 13px; font-weight: 600; fill: var(--text); }
";

#[derive(Template)]
#[template(path = "changes.svg")]
struct Picture {
    version: &'static str,
    name: String,
    summary: String,
    style: String,
    size: DVec2,
    margin: f64,
    new: String,
    old: String,
    marks: Vec<Drawn>,
    numbers: Vec<Number>,
    legend: Vec<Entry>,
    panes: Vec<Pane>,
}

/// A line of the legend.
struct Entry {
    at: DVec2,
    /// None for the boundaries.
    color: Option<&'static str>,
    line: &'static str,
    words: String,
}

/// Writes the changes of conditioned domains as one SVG picture, which fetches nothing.
///
/// # Errors
///
/// The errors of `out`.
///
/// # Example
///
/// ```
/// use mindeg::{Domain, Interior};
/// use mindeg::interior::{BoundaryDemands, condition};
/// use mindeg_answers::condition::ConditionAnswer;
/// use mindeg_compare::write_changes_svg;
///
/// let strait = Domain::from_rings([[[0.0, 0.0], [10.0, 0.0], [10.0, 0.5], [0.0, 0.5]]])?;
/// let (domain, conditioned) = condition(&strait, &Interior::default(), &BoundaryDemands::default(), &[])?;
/// let (before, after) = ([strait], [domain]);
/// let answer = ConditionAnswer::of(&before, &after, &[conditioned]);
/// let mut picture = Vec::new();
/// write_changes_svg("strait", &answer, [&before, &after], &mut picture)?;
/// let picture = String::from_utf8(picture)?;
/// assert!(picture.contains(&format!("put on an edge × {}", answer.inserted)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_changes_svg(
    name: &str,
    answer: &ConditionAnswer,
    [before, after]: [&[Domain]; 2],
    mut out: impl Write,
) -> io::Result<()> {
    let boxes = before.iter().chain(after).map(|domain| domain.placement().bounds());
    let bounds = boxes.reduce(|a, b| Bounds { min: a.min.min(b.min), max: a.max.max(b.max) });
    let bounds = bounds.unwrap_or(Bounds { min: DVec2::ZERO, max: DVec2::ONE });
    let room = DVec2::new(WIDTH - 2.0 * MARGIN, MOST_HEIGHT);
    let at = DVec2::new(MARGIN, TOP);
    let inset = Inset::new(bounds, Bounds { min: at, max: at + room });
    let [old, new] = [before, after].map(chains);
    let place = |chains: &[lines::Chain]| -> Vec<lines::Chain> {
        let placed = |chain: &lines::Chain| chain.iter().map(|at| inset.place(*at)).collect();
        chains.iter().map(placed).collect()
    };
    let [placed_old, placed_new] = [place(&old), place(&new)];
    let marks = marks(answer, &inset, &new, &placed_new);

    let all: Vec<&Mark> = marks.iter().collect();
    let edge = mean_edge(&placed_new);
    let mut legend_end = at.y + inset.size().y + 16.0;
    let legend = legend(&marks, &mut legend_end);
    let columns = COLUMNS as f64;
    let side = (room.x + GAP) / columns - GAP;
    let top = legend_end + 8.0;
    let parts = parts(&marks, edge, Bounds { min: at, max: at + room }, side);
    let panes: Vec<Pane> = (0..)
        .zip(parts)
        .map(|(index, (mark, part))| {
            let cell =
                DVec2::new(f64::from(index % COLUMNS as u32), f64::from(index / COLUMNS as u32));
            let at = DVec2::new(MARGIN, top) + cell * DVec2::new(side + GAP, side + CAPTION);
            pane(mark, part, at, side, &marks)
        })
        .collect();
    let rows = panes.len().div_ceil(COLUMNS) as f64;
    let height = top + rows * (side + CAPTION) + 20.0;

    let mut summary = format!(
        "{} boundary points become {}, moved by {}{} at most · a mesh can have {}, {} before",
        count(answer.points_before),
        count(answer.points),
        number(answer.moved),
        if after.iter().any(|domain| domain.projection().is_some()) { " m" } else { "" },
        steady_angle(answer.angle_limit),
        steady_angle(answer.angle_limit_before),
    );
    if let Some(stretch) = inset.stretch() {
        let _ = write!(summary, " · {stretch}");
    }
    let picture = Picture {
        version: env!("CARGO_PKG_VERSION"),
        name: one_line(name),
        summary,
        style: STYLE.to_owned() + &svg::standalone_style(LOOKS),
        size: DVec2::new(WIDTH, height).round(),
        margin: MARGIN,
        new: path(&placed_new),
        old: path(&placed_old),
        numbers: numbers(
            &all,
            |at| at,
            Bounds { min: DVec2::ZERO, max: DVec2::new(WIDTH, legend_end) },
        ),
        marks: drawn(&all, 0.0, |at| at),
        legend,
        panes,
    };
    out.write_all(rendered(&picture)?.as_bytes())
}

/// Both boundaries and the kinds that there are, in rows from a height on, which becomes that of their end.
fn legend(marks: &[Mark], y: &mut f64) -> Vec<Entry> {
    let mut rows = vec![(None, "old", "before".to_owned()), (None, "new", "after".to_owned())];
    for (index, (_, color, words)) in KINDS.iter().enumerate() {
        let times = marks.iter().filter(|mark| mark.kind == index).count();
        if times > 0 {
            rows.push((Some(*color), "", format!("{words} × {}", count(times as u64))));
        }
    }
    let mut x = MARGIN;
    *y += LEGEND_ROW / 2.0;
    let mut entries = Vec::new();
    for (color, line, words) in rows {
        let wide = 34.0 + 7.4 * words.chars().count() as f64;
        if x + wide > WIDTH - MARGIN {
            (x, *y) = (MARGIN, *y + LEGEND_ROW);
        }
        entries.push(Entry { at: DVec2::new(x, *y).map(pixel), color, line, words });
        x += wide + 10.0;
    }
    *y += LEGEND_ROW / 2.0;
    entries
}
