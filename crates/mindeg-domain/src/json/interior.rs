//! The key `interior`: what is wanted inside the domain.

use serde_json::{Map, json};

use super::error::DomainJsonError;
use super::point::pair;
use super::value::{ABOVE_0, Value};
use crate::interior::{FixedLines, Interior, LineEnd, Prefer, SizeAt};

const CORNERS: &str = "a list of [x, y] pairs of numbers";
const INTERIOR: &str = "an object, which may be empty, such as {\"growth\": 0.3}";
const DEGREES: &str = "a pair [least, greatest] of whole numbers, such as [5, 7]";
const FIXED: &str = "{\"points\": [[x, y], …], \"segments\": [[end, end], …]}";
const SIZE: &str = "[x, y, h], a place and the size there";
const SEGMENTS: &str = "a list of lines, each a list of two ends or more";
const END: &str = "[x, y], or the index of a fixed point, from 0";

pub(super) fn interior(given: &Value<'_>) -> Result<Interior, DomainJsonError> {
    let allowed = [
        "growth",
        "size_inside",
        "sizes",
        "interior_degree",
        "boundary_degree",
        "target_angle",
        "prefer",
        "fixed",
    ];
    let keys = given.object(&allowed, INTERIOR)?;
    let positive = |key| keys.get(key).map(above_0).transpose();
    Ok(Interior {
        growth: positive("growth")?,
        size_inside: positive("size_inside")?,
        sizes: match keys.get("sizes") {
            Some(sizes) => {
                let sizes = sizes.items("a list of [x, y, h]")?;
                sizes.iter().map(size).collect::<Result<_, _>>()?
            }
            None => Vec::new(),
        },
        interior_degree: keys.get("interior_degree").map(degrees).transpose()?,
        boundary_degree: keys
            .get("boundary_degree")
            .map(|degree| degree.whole("a whole number, at least 4"))
            .transpose()?,
        target_angle: positive("target_angle")?,
        prefer: keys.get("prefer").map(prefer).transpose()?,
        fixed: keys.get("fixed").map_or_else(|| Ok(FixedLines::default()), fixed)?,
        max_points: None,
    })
}

fn above_0(given: &Value<'_>) -> Result<f64, DomainJsonError> {
    let number = given.number(ABOVE_0)?;
    if number > 0.0 { Ok(number) } else { Err(given.unexpected(ABOVE_0)) }
}

fn size(given: &Value<'_>) -> Result<SizeAt, DomainJsonError> {
    match &given.items(SIZE)?[..] {
        [x, y, size] => Ok(SizeAt {
            at: [x.number("a number")?, y.number("a number")?].into(),
            size: above_0(size)?,
        }),
        _ => Err(given.unexpected(SIZE)),
    }
}

fn degrees(given: &Value<'_>) -> Result<std::ops::RangeInclusive<u32>, DomainJsonError> {
    match &given.items(DEGREES)?[..] {
        [least, greatest] => Ok(least.whole(DEGREES)?..=greatest.whole(DEGREES)?),
        _ => Err(given.unexpected(DEGREES)),
    }
}

fn prefer(given: &Value<'_>) -> Result<Prefer, DomainJsonError> {
    const WANTED: &str = "\"degree\" or \"angle\"";
    match given.text(WANTED)?.as_str() {
        "degree" => Ok(Prefer::Degree),
        "angle" => Ok(Prefer::Angle),
        _ => Err(given.unexpected(WANTED)),
    }
}

fn fixed(given: &Value<'_>) -> Result<FixedLines, DomainJsonError> {
    let keys = given.object(&["points", "segments"], FIXED)?;
    let points = match keys.get("points") {
        Some(points) => points.items(CORNERS)?.iter().map(pair).collect::<Result<Vec<_>, _>>()?,
        None => Vec::new(),
    };
    let end = |end: &Value<'_>| {
        if end.is_list() {
            return pair(end).map(LineEnd::At);
        }
        let index: usize = end.whole(END)?;
        match index {
            _ if index < points.len() => Ok(LineEnd::Point(index)),
            _ => Err(end.error(format!(
                "there is no fixed point {index}; \"points\" has {} (counted from 0)",
                points.len()
            ))),
        }
    };
    let line = |line: &Value<'_>| {
        let ends = line.items(SEGMENTS)?.iter().map(end).collect::<Result<Vec<_>, _>>()?;
        if ends.len() < 2 { Err(line.unexpected("a list of two ends or more")) } else { Ok(ends) }
    };
    let lines = match keys.get("segments") {
        Some(lines) => lines.items(SEGMENTS)?.iter().map(line).collect::<Result<_, _>>()?,
        None => Vec::new(),
    };
    Ok(FixedLines { points, lines })
}

/// The value of the key `interior`.
pub(super) fn to_json(interior: &Interior) -> serde_json::Value {
    let mut keys = Map::new();
    let mut add = |key: &str, value: Option<serde_json::Value>| {
        keys.extend(value.map(|value| (key.to_owned(), value)));
    };
    add("growth", interior.growth.map(|growth| json!(growth)));
    add("size_inside", interior.size_inside.map(|size| json!(size)));
    let sizes = interior.sizes.iter().map(|SizeAt { at, size }| json!([at.x, at.y, size]));
    add("sizes", (!interior.sizes.is_empty()).then(|| sizes.collect()));
    let degrees = interior.interior_degree.as_ref();
    add("interior_degree", degrees.map(|range| json!([range.start(), range.end()])));
    add("boundary_degree", interior.boundary_degree.map(|degree| json!(degree)));
    add("target_angle", interior.target_angle.map(|angle| json!(angle)));
    let prefer = |prefer| match prefer {
        Prefer::Degree => json!("degree"),
        Prefer::Angle => json!("angle"),
    };
    add("prefer", interior.prefer.map(prefer));
    let FixedLines { points, lines } = &interior.fixed;
    if !points.is_empty() || !lines.is_empty() {
        let end = |end: &LineEnd| match end {
            LineEnd::Point(index) => json!(index),
            LineEnd::At(place) => json!([place.x, place.y]),
        };
        let points: Vec<_> = points.iter().map(|point| json!([point.x, point.y])).collect();
        let lines: Vec<Vec<_>> = lines.iter().map(|line| line.iter().map(end).collect()).collect();
        add("fixed", Some(json!({"points": points, "segments": lines})));
    }
    serde_json::Value::Object(keys)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use glam::DVec2;

    fn domain(interior: &str) -> Result<Domain, String> {
        let text = format!(
            r#"{{"rectangle": {{"width": 4, "height": 3}}, "size": 1, "interior": {interior}}}"#
        );
        Domain::from_json(&text).map_err(|error| error.to_string())
    }

    #[test]
    fn reads_every_key() {
        let found = domain(
            r#"{"growth": 0.3, "size_inside": 2, "sizes": [[1, 1, 0.1], [3, 2, 0.2]],
                "interior_degree": [4, 8], "boundary_degree": 6, "target_angle": 25,
                "prefer": "angle", "fixed": {"points": [[1, 2], [2, 2]],
                "segments": [[0, 1], [[0, 1], 1, [4, 1]]]}}"#,
        );
        let at = DVec2::new;
        let expected = Interior {
            growth: Some(0.3),
            size_inside: Some(2.0),
            sizes: vec![
                SizeAt { at: at(1.0, 1.0), size: 0.1 },
                SizeAt { at: at(3.0, 2.0), size: 0.2 },
            ],
            interior_degree: Some(4..=8),
            boundary_degree: Some(6),
            target_angle: Some(25.0),
            prefer: Some(Prefer::Angle),
            fixed: FixedLines {
                points: vec![at(1.0, 2.0), at(2.0, 2.0)],
                lines: vec![
                    vec![LineEnd::Point(0), LineEnd::Point(1)],
                    vec![LineEnd::At(at(0.0, 1.0)), LineEnd::Point(1), LineEnd::At(at(4.0, 1.0))],
                ],
            },
            max_points: None,
        };
        assert_eq!(found.unwrap().interior(), Some(&expected));
        assert_eq!(domain("{}").unwrap().interior(), Some(&Interior::default()));
        assert_eq!(domain("null").unwrap().interior(), None);
    }

    #[test]
    fn refuses_with_the_place() {
        for (interior, message) in [
            (
                "true",
                "interior: found true, expected an object, which may be empty, such as {\"growth\": 0.3}",
            ),
            (r#"{"growth": 0}"#, "interior.growth: found the number 0, expected a number above 0"),
            (
                r#"{"size_inside": -1}"#,
                "interior.size_inside: found the number -1, expected a number above 0",
            ),
            (
                r#"{"sizes": [[1, 2]]}"#,
                "interior.sizes[0]: found a list, expected [x, y, h], a place and the size there",
            ),
            (
                r#"{"sizes": [[1, 2, 0]]}"#,
                "interior.sizes[0][2]: found the number 0, expected a number above 0",
            ),
            (
                r#"{"interior_degree": 6}"#,
                "interior.interior_degree: found the number 6, expected a pair [least, greatest] of whole numbers, such as [5, 7]",
            ),
            (
                r#"{"prefer": "speed"}"#,
                "interior.prefer: found the text \"speed\", expected \"degree\" or \"angle\"",
            ),
            (
                r#"{"fixed": {"segments": [[0, 1]]}}"#,
                "interior.fixed.segments[0][0]: there is no fixed point 0; \"points\" has 0 (counted from 0)",
            ),
            (
                r#"{"fixed": {"segments": [[[0, 1]]]}}"#,
                "interior.fixed.segments[0]: found a list, expected a list of two ends or more",
            ),
            (
                r#"{"grow": 1}"#,
                "interior.grow: unknown key \"grow\"; allowed: \"growth\", \"size_inside\", \"sizes\", \"interior_degree\", \"boundary_degree\", \"target_angle\", \"prefer\", \"fixed\"",
            ),
        ] {
            let error = domain(interior).unwrap_err();
            let (place, error) = error.split_once(", interior").unwrap();
            assert_eq!(format!("interior{error}"), message);
            // Each error is within the value.
            let column: usize = place.trim_start_matches("line 1, column ").parse().unwrap();
            assert!((65..65 + interior.len()).contains(&column), "{place}");
        }
    }

    #[test]
    fn what_is_wanted_inside_survives_writing() {
        let given = domain(
            r#"{"growth": 0.3, "size_inside": 0.7, "sizes": [[1, 1, 0.1]], "interior_degree": [5, 8],
                "boundary_degree": 6, "target_angle": 20, "prefer": "angle",
                "fixed": {"points": [[1, 1]], "segments": [[0, [0.5, 0.25]]]}}"#,
        )
        .unwrap();
        let again = Domain::from_json(&given.to_json()).unwrap();
        assert!(given.interior().is_some());
        assert_eq!(again.interior(), given.interior());
    }
}
