//! Values of options: how they are read, and what to say to one that cannot be.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use mindeg_files::{Format, is_eastward};
use std::str::FromStr;

/// Width and height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RectangleSize {
    pub(crate) width: f64,
    pub(crate) height: f64,
}

impl FromStr for RectangleSize {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let sizes = text.split_once(['x', 'X', '×']).and_then(|(width, height)| {
            Some(Self { width: width.trim().parse().ok()?, height: height.trim().parse().ok()? })
        });
        sizes.ok_or_else(|| {
            let example = "give a width and a height with an x between, such as 4x3";
            if text.contains(['x', 'X', '×']) {
                with_decimal_hint(text, example)
            } else {
                example.to_owned()
            }
        })
    }
}

/// A list of points.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Corners(pub(crate) Vec<[f64; 2]>);

impl FromStr for Corners {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let corner = |(number, corner): (usize, &str)| {
            point(corner).ok_or_else(|| {
                let problem = if text.contains(['(', ')', '[', ']']) {
                    "leave out the brackets"
                } else if corner.split(',').count() > 2 {
                    "a corner has two coordinates"
                } else if text.contains(';') {
                    "use commas and spaces, no semicolons"
                } else {
                    "put a comma between x and y, and spaces between corners"
                };
                format!("corner {}: {problem}, such as \"0,0 4,0 3,2\"", number + 1)
            })
        };
        text.split_whitespace().enumerate().map(corner).collect::<Result<_, _>>().map(Self)
    }
}

/// A point such as `4,0`.
pub(crate) fn point(text: &str) -> Option<[f64; 2]> {
    let (x, y) = text.split_once(',')?;
    Some([x.trim().parse().ok()?, y.trim().parse().ok()?])
}

/// The lower left and the upper right corner of a box, such as `22.5,35.5,28,40.5`.
pub(super) fn box_corners(text: &str) -> Result<[f64; 4], String> {
    let numbers = text.split(',').map(|word| word.trim().parse().ok());
    let numbers: Option<Vec<f64>> = numbers.collect();
    let corners = numbers.and_then(|numbers| <[f64; 4]>::try_from(numbers).ok());
    let corners = corners.filter(|[x, y, right, top]| is_eastward(*x, *right) && y < top);
    corners.ok_or_else(|| {
        "give west,south,east,north, such as 22.5,35.5,28,40.5, or 170,-25,-170,-10 across 180°"
            .to_owned()
    })
}

/// A list of interval counts, one for each side.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct IntervalCounts(pub(crate) Vec<u64>);

impl FromStr for IntervalCounts {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let count = |(side, count): (usize, &str)| {
            let count = count.trim();
            count.parse().map_err(|_| {
                let is_number = !count.is_empty() && count.bytes().all(|c| c.is_ascii_digit());
                let problem = if is_number {
                    // More than the 64 bits that the others are checked in.
                    "the maximum is 4294967294 intervals"
                } else {
                    "give a whole number of intervals for each side, such as 3,3,2,2"
                };
                format!("side {}: {problem}", side + 1)
            })
        };
        text.split(',').enumerate().map(count).collect::<Result<_, _>>().map(Self)
    }
}

/// A number of edges, rows or the like.
pub(crate) fn whole_number(text: &str) -> Result<u32, String> {
    let number = text.trim().parse();
    number.map_err(|_| "give a whole number of 0 or more, such as 5".to_owned())
}

/// A port to listen on.
pub(crate) fn port(text: &str) -> Result<u16, String> {
    let number = text.trim().parse().ok().filter(|&port| port > 0);
    number.ok_or_else(|| "give a whole number from 1 to 65535".to_owned())
}

/// The right spelling, and that decimals have a point, if digits round a comma look like one.
fn with_decimal_hint(text: &str, example: &str) -> String {
    let bytes = text.as_bytes();
    let is_decimal =
        |three: &[u8]| three[0].is_ascii_digit() && three[1] == b',' && three[2].is_ascii_digit();
    let hint = if bytes.windows(3).any(is_decimal) { "; decimals have a point" } else { "" };
    format!("{example}{hint}")
}

/// A length, or an area, in the units of the coordinates, or in metres where it has a unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Length {
    pub(crate) value: f64,
    /// Whether it has a unit: then the coordinates must be metres.
    pub(crate) is_metric: bool,
}

/// Units of lengths in metres; those of areas are their squares.
const UNITS: [(&str, f64); 4] = [("km", 1e3), ("cm", 1e-2), ("mm", 1e-3), ("m", 1.0)];

/// A length above 0 in the unit of the coordinates.
pub(crate) fn length(text: &str) -> Result<f64, String> {
    match in_units(text, 1) {
        Some(Length { value, is_metric: false }) => Ok(value),
        Some(_) => {
            Err("give a length in the unit of the coordinates, without its name, such as 0.5"
                .to_owned())
        }
        None => Err(with_decimal_hint(text, "give a length above 0, such as 0.5")),
    }
}

/// A length such as `0.5` or `2km`.
pub(crate) fn length_with_unit(text: &str) -> Result<Length, String> {
    in_units(text, 1)
        .ok_or_else(|| with_decimal_hint(text, "give a length above 0, such as 0.5 or 2km"))
}

/// A length for a name, such as `river=200m`.
pub(crate) fn named_length(text: &str) -> Result<(String, Length), String> {
    let (name, length) = text
        .rsplit_once('=')
        .filter(|(name, _)| !name.is_empty())
        .ok_or("give a name and a size, such as river=200m")?;
    Ok((name.to_owned(), length_with_unit(length)?))
}

/// A distance such as `0` or `500m`.
pub(crate) fn distance(text: &str) -> Result<Length, String> {
    let zero = (text.trim() == "0").then_some(Length { value: 0.0, is_metric: false });
    zero.map_or_else(|| length_with_unit(text), Ok)
}

/// An area such as `4e6` or `4km2`.
pub(crate) fn area(text: &str) -> Result<Length, String> {
    in_units(text, 2)
        .ok_or_else(|| with_decimal_hint(text, "give an area above 0, such as 0.5 or 2km2"))
}

/// A number above 0 with a unit to a power, or without one.
fn in_units(text: &str, power: i32) -> Option<Length> {
    let text = text.trim();
    let of_unit = |(unit, metres): (&str, f64)| {
        let squared = if power == 2 { text.strip_suffix(['2', '²']) } else { Some(text) };
        Some((squared?.strip_suffix(unit)?, if power == 2 { metres * metres } else { metres }))
    };
    let told = UNITS.into_iter().find_map(of_unit);
    let (number, factor) = told.unwrap_or((text, 1.0));
    let value = number.trim().parse::<f64>().ok()? * factor;
    (value.is_finite() && value > 0.0).then_some(Length { value, is_metric: told.is_some() })
}

/// A time such as `2s` or `0.5`, in seconds.
pub(crate) fn seconds(text: &str) -> Result<f64, String> {
    let number = text.trim().strip_suffix('s').unwrap_or(text).trim();
    let value = number.parse().ok().filter(|value: &f64| value.is_finite() && *value > 0.0);
    value.ok_or_else(|| with_decimal_hint(text, "give seconds above 0, such as 2s"))
}

/// Two coordinates such as `24.5,38`.
pub(crate) fn place(text: &str) -> Result<[f64; 2], String> {
    let place = point(text).filter(|point| point.iter().all(|it| it.is_finite()));
    place.ok_or_else(|| "give two numbers with a comma between, such as 24.5,38".to_owned())
}

/// An angle from 0 to 180 degrees.
pub(super) fn angle(text: &str) -> Result<f64, String> {
    let angle = text.trim().trim_end_matches('°').parse().ok();
    angle
        .filter(|angle| (0.0..=180.0).contains(angle))
        .ok_or_else(|| "give an angle from 0 to 180 degrees, such as 30".to_owned())
}

/// A minimum angle.
pub(super) fn target_angle(text: &str) -> Result<f64, String> {
    let number = text.trim().trim_end_matches('°');
    let angle = number.parse().ok().filter(|angle| (0.0..=60.0).contains(angle));
    angle.ok_or_else(|| "give degrees from 0 to 60; no triangle has only larger angles".to_owned())
}

/// The help of an argument that is a mesh, and what it may be besides.
pub(super) fn mesh_help(more: &str) -> String {
    format!(
        "The mesh, in any format that mindeg formats lists; files that it needs are in its folder{more}"
    )
}

/// One of some formats, by name.
pub(super) fn format_parser<const N: usize>(
    formats: [Format; N],
) -> impl TypedValueParser<Value = Format> {
    PossibleValuesParser::new(formats.map(Format::name)).map(move |name| {
        let is_named = |format: &Format| format.name() == name;
        formats.into_iter().find(is_named).expect("one of the possible values")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn interval_counts_are_read_side_by_side() {
        assert_eq!("3, 3,2,2".parse(), Ok(IntervalCounts(vec![3, 3, 2, 2])));
        for (text, side) in
            [("", "side 1"), ("3,,2", "side 2"), ("3,-1,2", "side 2"), ("1,2,2.5", "side 3")]
        {
            let error = text.parse::<IntervalCounts>().unwrap_err();
            assert!(error.starts_with(side), "{text:?}: {error}");
        }
        let error = "3,18446744073709551616,1".parse::<IntervalCounts>().unwrap_err();
        assert_eq!(error, "side 2: the maximum is 4294967294 intervals");
    }

    #[test]
    fn lengths_and_areas_may_have_units() {
        let of = |value, is_metric| Ok(Length { value, is_metric });
        assert_eq!(length_with_unit("2km"), of(2000.0, true));
        assert_eq!(length_with_unit(" 0.5 m"), of(0.5, true));
        assert_eq!(
            [length_with_unit("25 mm"), length_with_unit("3")],
            [of(0.025, true), of(3.0, false)]
        );
        assert_eq!([distance("0"), distance("500m")], [of(0.0, false), of(500.0, true)]);
        assert_eq!(
            [area("4km2"), area("4 m²"), area("7")],
            [of(4e6, true), of(4.0, true), of(7.0, false)]
        );
        for text in ["", "km", "-1km", "0", "2 miles", "nan", "1e999"] {
            assert!(length_with_unit(text).is_err(), "{text}");
        }
        assert!(area("4km").is_err() && distance("-1").is_err());
        assert_eq!([seconds("2s"), seconds("0.5")], [Ok(2.0), Ok(0.5)]);
        assert!(seconds("-2s").is_err() && place("1,inf").is_err());
        assert_eq!(place("24.5, -38"), Ok([24.5, -38.0]));
    }

    #[test]
    fn target_angles_are_read() {
        assert_eq!(target_angle("25.5°"), Ok(25.5));
        assert_eq!([target_angle("0"), target_angle("60")], [Ok(0.0), Ok(60.0)]);
        for text in ["60.1", "-1", "nan", "inf", "x"] {
            assert!(target_angle(text).is_err(), "{text}");
        }
    }

    #[test]
    fn sizes_and_corners_are_read() {
        let size = RectangleSize { width: 4.0, height: 0.5 };
        assert_eq!("4x.5".parse(), Ok(size));
        assert_eq!("4 x 5e-1".parse(), Ok(size));
        for text in ["", "4", "4x", "4x3x2", "ax3"] {
            assert!(text.parse::<RectangleSize>().is_err(), "{text:?}");
        }
        let corners = Corners(vec![[0.0, 0.0], [-4.0, 1e3], [3.5, 2.0]]);
        assert_eq!(" 0,0  -4,1e3\n3.5,2".parse(), Ok(corners));
        for (text, corner) in
            [("0,0 4", "corner 2"), ("0;0", "corner 1"), ("0,0 1,1 1,2,3", "corner 3")]
        {
            let error = text.parse::<Corners>().unwrap_err();
            assert!(error.starts_with(corner), "{text:?}: {error}");
        }
    }
}
