//! Wavefront OBJ with lines: `v` and `l`, whose closed loops are rings.
//!
//! Objects and groups (`o`, `g`) name the sides of a ring that consists of several of them, or the
//! polygon if it lies in one. Loops inside others are holes. An OBJ with faces is a mesh.

use std::sync::Arc as Shared;

use glam::{DVec2, DVec3};

use super::curve::Curve;
use super::loops::{self, Link};
use super::outline::Outlines;
use super::plane;
use super::text::{at_line, lines, number_at, quoted, text_of};
use crate::error::ReadError;

/// Reads the lines of an OBJ.
///
/// # Errors
///
/// A line that is not as OBJ has it, with its number; faces; lines that close no ring.
pub(super) fn read(bytes: &[u8]) -> Result<Outlines, ReadError> {
    let mut points = Vec::new();
    let mut links = Vec::new();
    let mut group: Option<Shared<str>> = None;
    for (line, text) in lines(text_of(bytes)?) {
        let text = text.split('#').next().unwrap_or_default();
        let mut words = text.split_whitespace();
        match words.next() {
            Some("v") => {
                let mut next = |what| number_at(line, words.next(), what);
                points.push(DVec3::new(
                    next("x coordinate")?,
                    next("y coordinate")?,
                    next("z coordinate")?,
                ));
            }
            Some("l") => {
                let indices: Vec<u32> =
                    words.map(|word| index(word, points.len(), line)).collect::<Result<_, _>>()?;
                for pair in indices.windows(2) {
                    let ends = [pair[0], pair[1]];
                    let side = group.clone();
                    links.push((line, Link { ends, curve: Curve::Line, side, part_of: 0 }));
                }
            }
            Some("o" | "g") => {
                let name = text.trim_start()[1..].trim();
                group = (!name.is_empty()).then(|| name.into());
            }
            Some("f") => {
                return Err(at_line(
                    line,
                    "the file has faces, so it is a mesh; mindeg view, inspect and convert take \
                     meshes; keep only its v and l lines to mesh the outline",
                ));
            }
            _ => {}
        }
    }
    if let Some((line, link)) =
        links.iter().find(|(_, link)| link.ends.iter().any(|&end| end as usize >= points.len()))
    {
        let last = link.ends.iter().max().copied().unwrap_or_default() + 1;
        return Err(at_line(
            *line,
            format!("the line goes to vertex {last}, and the file has {}", points.len()),
        ));
    }
    if links.is_empty() {
        return Err(at_line(1, "the file has no lines; give a closed loop, such as l 1 2 3 1"));
    }
    let links: Vec<Link> = links.into_iter().map(|(_, link)| link).collect();
    let used = links.iter().flat_map(|link| link.ends).map(|end| points[end as usize].z);
    let mut notes: Vec<String> = plane::check(used)?.into_iter().collect();
    let points: Vec<DVec2> = points.iter().map(|point| point.truncate()).collect();
    let (rings, note) = loops::rings(&points, &links, |point| format!("vertex {}", point + 1))?;
    notes.extend(note);
    let mut outlines = Outlines::of_rings(rings, notes)?;
    outlines.features.iter_mut().for_each(|feature| feature.name_by_side());
    Ok(outlines)
}

/// The index of a vertex from 0; one that is not there yet is allowed.
fn index(word: &str, so_far: usize, line: u64) -> Result<u32, ReadError> {
    let number = word.split('/').next().unwrap_or_default();
    let index = match number.parse::<i64>() {
        Ok(number) if number > 0 => Some(number - 1),
        Ok(number) if number < 0 => Some(so_far as i64 + number).filter(|&index| index >= 0),
        _ => None,
    };
    index.and_then(|index| u32::try_from(index).ok()).filter(|&it| it < u32::MAX).ok_or_else(|| {
        at_line(line, format!("found {}, expected the number of a vertex", quoted(word)))
    })
}

#[cfg(test)]
mod tests {
    use super::super::outline::Ring;
    use super::*;

    const SQUARE: &str = "v 0 0 0\nv 0.1 0 0\nv 0.1 0.3 0\nv 0 0.3 0\n";

    fn read(text: &str) -> Result<Outlines, String> {
        super::read(text.as_bytes()).map_err(|error| error.to_string())
    }

    #[test]
    fn loops_become_rings_with_their_points_and_names() {
        let expected = [[0.0, 0.0], [0.1, 0.0], [0.1, 0.3], [0.0, 0.3]].map(DVec2::from);
        for (lines, name) in [
            ("l 1 2 3 4 1", None),
            ("l 1 2\nl 3 4 # c\nl 2/7 3/7\nl -1 -4", None),
            ("o plate\ng\no plate\nl 1 2 3\nl 3 4 1", Some("plate")),
        ] {
            let outlines = read(&format!("{SQUARE}{lines}")).unwrap();
            assert_eq!(outlines.features[0].rings, [Ring::of_points(expected)], "{lines}");
            assert_eq!(outlines.features[0].name.as_deref(), name);
        }
        let outlines = read(&format!("{SQUARE}o inlet\nl 4 1\no wall\nl 1 2 3 4")).unwrap();
        let sides = |piece: &super::super::Piece| piece.side.clone().unwrap().to_string();
        let sides: Vec<String> = outlines.features[0].rings[0].pieces.iter().map(sides).collect();
        assert_eq!(sides, ["inlet", "wall", "wall", "wall"]);
    }

    #[test]
    fn errors_say_where_and_what() {
        for (lines, message) in [
            ("f 1 2 3", "line 5: the file has faces, so it is a mesh;"),
            ("", "line 1: the file has no lines;"),
            ("l 1 2 0", "line 5: found \"0\", expected the number of a vertex"),
            ("l 1 2 -9", "line 5: found \"-9\", expected the number of a vertex"),
            ("l 1 2 3 5 1", "line 5: the line goes to vertex 5, and the file has 4"),
            ("l 1 4294967296", "line 5: found \"4294967296\", expected the number of a vertex"),
            ("v 1 2", "line 5: the z coordinate is missing"),
            ("v 1 2 x", "line 5: found \"x\", expected the z coordinate, a finite number"),
            ("v 1 1 1\nl 1 2 5 1", "the points do not lie in a plane of equal z"),
            ("l 1 2 3", "vertex 1: no line closes"),
        ] {
            let error = read(&format!("{SQUARE}{lines}")).unwrap_err();
            assert!(error.starts_with(message) || error.contains(message), "{error}");
        }
    }
}
