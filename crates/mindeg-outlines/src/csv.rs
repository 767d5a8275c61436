//! Points as text: one in a line, blank lines between rings.
//!
//! Columns are parted by commas, semicolons, tabs or blanks. A first line of names is passed over;
//! it tells which columns hold the points if it names x and y, lon and lat, or easting and
//! northing. With semicolons or tabs a comma may be the decimal mark. Lines that start with `#`
//! are comments. Rings inside others are holes.

use glam::DVec2;

use super::outline::{DrawnRing, Outlines};
use super::text::{at_line, lines, number, quoted, text_of};
use crate::error::OutlineError;

/// Names of the columns that hold the points.
const COLUMNS: [[&str; 2]; 7] = [
    ["x", "y"],
    ["lon", "lat"],
    ["lng", "lat"],
    ["long", "lat"],
    ["longitude", "latitude"],
    ["easting", "northing"],
    ["e", "n"],
];

/// Reads points, line by line.
///
/// # Errors
///
/// A line that does not hold a point, with its number.
pub(super) fn read(bytes: &[u8]) -> Result<Outlines, OutlineError> {
    let mut rings = Vec::new();
    let mut points = Vec::new();
    let mut columns: Option<[usize; 2]> = None;
    let mut others = false;
    for (line, text) in lines(text_of(bytes)?) {
        let text = text.trim();
        if text.starts_with('#') {
            continue;
        }
        if text.is_empty() {
            rings.push(std::mem::take(&mut points));
            continue;
        }
        let words = words(text);
        let Some([x, y]) = columns else {
            if let Some(found) = named_columns(&words) {
                columns = Some(found);
                continue;
            }
            // The first line decides: numbers, or names that tell nothing.
            columns = Some([0, 1]);
            if coordinate(words.first().copied(), text).is_some() {
                points.push(point(&words, [0, 1], line, text)?);
                others |= words.len() > 2;
            }
            continue;
        };
        others |= words.len() > 2;
        points.push(point(&words, [x, y], line, text)?);
    }
    rings.push(points);
    let rings: Vec<DrawnRing> =
        rings.into_iter().filter(|ring| !ring.is_empty()).map(DrawnRing::of_points).collect();
    if rings.is_empty() {
        return Err(at_line(1, "the file holds no points; give one in a line, such as 4.0, 2.5"));
    }
    let [x, y] = columns.unwrap_or([0, 1]).map(|column| column + 1);
    let note = others.then(|| format!("took the points from columns {x} and {y}"));
    Outlines::of_rings(rings, note.into_iter().collect())
}

/// Whether these first lines are points, or names of columns.
pub(super) fn begins<'a>(mut rows: impl Iterator<Item = &'a str>) -> bool {
    rows.any(|row| {
        let words = words(row);
        named_columns(&words).is_some() || point(&words, [0, 1], 0, row).is_ok()
    })
}

/// The cells of a line.
fn words(text: &str) -> Vec<&str> {
    match [';', '\t', ','].into_iter().find(|&mark| text.contains(mark)) {
        Some(mark) => text.split(mark).map(|word| word.trim().trim_matches('"')).collect(),
        None => text.split_whitespace().collect(),
    }
}

fn named_columns(words: &[&str]) -> Option<[usize; 2]> {
    let position = |name: &str| words.iter().position(|word| word.eq_ignore_ascii_case(name));
    COLUMNS.into_iter().find_map(|[x, y]| Some([position(x)?, position(y)?]))
}

fn coordinate(word: Option<&str>, text: &str) -> Option<f64> {
    let word = word?;
    if text.contains([';', '\t']) && word.contains(',') {
        return number(&word.replace(',', "."));
    }
    number(word)
}

fn point(
    words: &[&str],
    columns: [usize; 2],
    line: u64,
    text: &str,
) -> Result<DVec2, OutlineError> {
    let [x, y] = columns.map(|column| coordinate(words.get(column).copied(), text));
    match (x, y) {
        (Some(x), Some(y)) => Ok(DVec2::new(x, y)),
        _ => Err(at_line(
            line,
            format!(
                "found {}, expected a point such as 4.0, 2.5; blank lines part rings, and # \
                 starts a comment",
                quoted(text)
            ),
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Outlines, String> {
        super::read(text.as_bytes()).map_err(|error| error.to_string())
    }

    #[test]
    fn reads_points_however_they_are_parted() {
        let expected = DrawnRing::of_points([[0.0, 0.0], [4.5, 0.0], [0.0, 3.0]].map(DVec2::from));
        for text in [
            "0,0\n4.5,0\n0,3\n",
            "0 0\n4.5 0\n0 3\n0 0\n",
            "x,y\r\n0,0\r\n4.5, 0\r\n0,3",
            "# a wedge\n0;0\n4,5;0\n0;3\n\n\n",
            "id,lat,lon\n1,0,0\n2,0,4.5\n3,3,0",
            "\u{feff}\"Y\"\t\"X\"\n0\t0\n0\t4,5\n3\t0",
            "points of a wedge\n0\t0\n4.5\t0\n0\t3",
        ] {
            let outlines = read(text).unwrap();
            assert_eq!(outlines.features.len(), 1, "{text:?}");
            assert_eq!(outlines.features[0].rings, std::slice::from_ref(&expected), "{text:?}");
            let has_others = text.contains("id");
            let notes: &[&str] =
                if has_others { &["took the points from columns 3 and 2"] } else { &[] };
            assert_eq!(outlines.notes, notes, "{text:?}");
        }
    }

    #[test]
    fn blank_lines_part_rings_and_inner_rings_are_holes() {
        let outlines = read("1 1\n2 1\n1 2\n\n0 0\n9 0\n0 9\n\n10 0\n11 0\n10 1 7\n").unwrap();
        let counts: Vec<usize> = outlines.features.iter().map(|it| it.rings.len()).collect();
        assert_eq!(counts, [2, 1]);
        assert_eq!(outlines.notes, ["took the points from columns 1 and 2"]);
    }

    #[test]
    fn errors_say_where_and_what() {
        for (text, message) in [
            ("", "line 1: the file holds no points; give one in a line, such as 4.0, 2.5"),
            (
                "0 0\n\n4 a\n",
                "line 3: found \"4 a\", expected a point such as 4.0, 2.5; blank lines part rings, and # starts a comment",
            ),
            (
                "0 0\n4",
                "line 2: found \"4\", expected a point such as 4.0, 2.5; blank lines part rings, and # starts a comment",
            ),
            (
                "0,0\n4,inf",
                "line 2: found \"4,inf\", expected a point such as 4.0, 2.5; blank lines part rings, and # starts a comment",
            ),
        ] {
            assert_eq!(read(text).unwrap_err(), message);
        }
    }
}
