//! Values that have several forms in JSON, or another form than in Rust.

use std::fmt;

use glam::DVec2;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserialize, Deserializer, Error, MapAccess, SeqAccess, Unexpected, Visitor};

use crate::constraints::ExternalDegree;
use crate::sizes::{Size, SizeAt, SizeBetween, SizeFile, SizeFrom};

impl From<[f64; 3]> for SizeAt {
    fn from([x, y, size]: [f64; 3]) -> Self {
        Self { at: [x, y].into(), size }
    }
}

impl From<SizeAt> for [f64; 3] {
    fn from(SizeAt { at, size }: SizeAt) -> Self {
        [at.x, at.y, size]
    }
}

/// A whole number, or a list instead.
struct NumberOr<T, L> {
    expected: &'static str,
    number: fn(u32) -> T,
    list: fn(L) -> T,
}

impl<'de, T, L: Deserialize<'de>> Visitor<'de> for NumberOr<T, L> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.expected)
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<T, E> {
        match u32::try_from(number) {
            Ok(number) => Ok((self.number)(number)),
            Err(_) => Err(E::invalid_value(Unexpected::Unsigned(number), &self)),
        }
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<T, A::Error> {
        L::deserialize(SeqAccessDeserializer::new(list)).map(self.list)
    }
}

impl<'de> Deserialize<'de> for ExternalDegree {
    fn deserialize<D: Deserializer<'de>>(given: D) -> Result<Self, D::Error> {
        given.deserialize_any(NumberOr {
            expected: "a whole number, or for a side a list of one whole number for each vertex from \
                       its first corner to its last",
            number: Self::Inside,
            list: Self::Each,
        })
    }
}

/// The keys of a size that is no list.
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct SizeKeys {
    from: Option<Vec<String>>,
    size: Option<f64>,
    growth: Option<f64>,
    until: Option<f64>,
    points: Option<Vec<SizeAt>>,
    triangles: Option<Vec<[u32; 3]>>,
    origin: Option<DVec2>,
    spacing: Option<DVec2>,
    rows: Option<Vec<Vec<Option<f64>>>>,
    file: Option<String>,
}

impl SizeKeys {
    fn size(self) -> Result<Size, &'static str> {
        let Self { from, size, growth, until, points, triangles, origin, spacing, rows, file } =
            self;
        let is_near = from.is_some() || size.is_some() || growth.is_some() || until.is_some();
        let is_mesh = points.is_some() || triangles.is_some();
        let is_grid = origin.is_some() || spacing.is_some() || rows.is_some();
        if let Some(file) = file.filter(|_| !is_near && !is_mesh && !is_grid) {
            return Ok(Size::File(SizeFile { file }));
        }
        match (from, size, points, (origin, spacing, rows)) {
            (Some(from), Some(size), None, _) if !is_mesh && !is_grid => {
                Ok(Size::From(SizeFrom { from, size, growth, until }))
            }
            (None, None, Some(points), _) if !is_near && !is_grid => {
                let triangles = triangles.unwrap_or_default();
                Ok(Size::Between(SizeBetween { points, triangles }))
            }
            (.., (Some(origin), Some(spacing), Some(rows))) if !is_near && !is_mesh => {
                let columns = rows.first().map_or(0, Vec::len);
                let is_even = rows.iter().all(|row| row.len() == columns);
                let values = rows.iter().flatten().map(|value| value.unwrap_or(f64::NAN));
                let grid = SizeBetween::grid(origin, spacing, columns, &values.collect::<Vec<_>>());
                grid.filter(|_| is_even).map(Size::Between).ok_or(
                    "the rows of a grid have the same number of values, at least one; null leaves one out",
                )
            }
            _ => Err(
                "a size is [x, y, h], {\"from\": [\"wall\"], \"size\": h}, which may have \"growth\" and \"until\", \
                 {\"points\": [[x, y, h], …], \"triangles\": [[a, b, c], …]}, {\"origin\": [x, y], \"spacing\": \
                 [dx, dy], \"rows\": [[h, …], …]}, or {\"file\": \"sizes.asc\"}",
            ),
        }
    }
}

impl<'de> Deserialize<'de> for Size {
    fn deserialize<D: Deserializer<'de>>(given: D) -> Result<Self, D::Error> {
        given.deserialize_any(SizeForms)
    }
}

/// A point with a size, or an object.
struct SizeForms;

impl<'de> Visitor<'de> for SizeForms {
    type Value = Size;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(
            "a size [x, y, h], or an object with \"from\", \"points\", \"rows\" or \"file\"",
        )
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Size, A::Error> {
        SizeAt::deserialize(SeqAccessDeserializer::new(list)).map(Size::At)
    }

    fn visit_map<A: MapAccess<'de>>(self, object: A) -> Result<Size, A::Error> {
        SizeKeys::deserialize(MapAccessDeserializer::new(object))?.size().map_err(A::Error::custom)
    }
}
