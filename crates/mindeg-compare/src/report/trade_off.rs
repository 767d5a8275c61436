//! What every degree buys, to read and to look at: as JSON, as one picture, as a page.
//!
//! Limits: a picture and a page show so many meshes, evenly chosen where there are more; figures
//! are of all.

mod html;
mod picture;

pub use html::write_trade_off_html;
pub use picture::write_trade_off_svg;

use mindeg::exact::TradeOff;
use schemars::JsonSchema;
use serde::Serialize;
use std::io::{self, Write};

/// The figures of a trade-off, as JSON holds them.
///
/// # Example
///
/// ```
/// use mindeg_compare::TradeOffFigures;
/// use mindeg::{Domain, Progress, Side, exact};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?;
/// let figures = TradeOffFigures::of(&exact::trade_off(&domain, Progress::NONE)?);
/// assert_eq!(figures.points[0].max_degree, 4);
/// assert!(figures.points[0].min_angle < figures.delaunay_min_angle);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(description = "What every degree buys.")]
pub struct TradeOffFigures {
    /// A point for every maximum degree, in ascending order.
    pub points: Vec<TradeOffPoint>,
    /// The minimum angle of a Delaunay triangulation, in degrees.
    pub delaunay_min_angle: f64,
}

/// What one maximum degree buys.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TradeOffPoint {
    /// The most edges that a vertex may have.
    pub max_degree: u32,
    /// The largest minimum angle there is then, in degrees.
    pub min_angle: f64,
    /// Whether that is proven; if not, windows reached it.
    pub exact: bool,
}

impl TradeOffFigures {
    /// The figures of a trade-off.
    #[must_use]
    pub fn of(trade_off: &TradeOff) -> Self {
        let point = |exact: &mindeg::exact::ExactMesh| TradeOffPoint {
            max_degree: exact.max_degree,
            min_angle: exact.min_angle,
            exact: trade_off.is_exact(),
        };
        Self {
            points: trade_off.meshes().iter().map(point).collect(),
            delaunay_min_angle: trade_off.delaunay_min_angle(),
        }
    }
}

/// Writes the figures of a trade-off as JSON.
///
/// # Errors
///
/// Those of `out`.
pub fn write_trade_off_json(trade_off: &TradeOff, mut out: impl Write) -> io::Result<()> {
    serde_json::to_writer_pretty(&mut out, &TradeOffFigures::of(trade_off))?;
    out.write_all(b"\n")
}

/// `count` things by their places, or `most` of them spread evenly from the first to the last.
fn spread(count: usize, most: usize) -> impl Iterator<Item = usize> {
    let shown = count.min(most);
    (0..shown).map(move |i| if shown < 2 { 0 } else { i * (count - 1) / (shown - 1) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_and_the_last_are_among_those_spread() {
        let places = |count, most| spread(count, most).collect::<Vec<_>>();
        assert_eq!(places(1, 4), [0]);
        assert_eq!(places(3, 4), [0, 1, 2]);
        assert_eq!(places(4, 4), [0, 1, 2, 3]);
        assert_eq!(places(90, 4), [0, 29, 59, 89]);
        assert_eq!(places(5, 1), [0]);
    }
}
