//! The trade-off of degree and angle, as JSON, as one picture, as a page.
//!
//! Limits: a picture and a page show so many meshes, evenly chosen where there are more; figures
//! are of all.

mod html;
mod picture;

pub use html::write_trade_off_html;
pub use picture::write_trade_off_svg;

use mindeg_answers::trade_off::TradeOffAnswer;
use std::io::{self, Write};

/// Writes the figures of trade-offs as JSON.
///
/// # Errors
///
/// The errors of `out`.
pub fn write_trade_off_json(answer: &TradeOffAnswer, mut out: impl Write) -> io::Result<()> {
    serde_json::to_writer(&mut out, answer)?;
    out.write_all(b"\n")
}

/// The indices of `count` things, or of `most` of them spread evenly from the first to the last.
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
