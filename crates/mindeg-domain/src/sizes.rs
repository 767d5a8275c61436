//! The sizes that a mesh is asked to have somewhere.

use glam::DVec2;

use crate::error::{DomainError, Place};

/// A size somewhere: `[x, y, h]` at a point, or an object: near sides and lines, or between points
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "json", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "json", serde(untagged))]
pub enum Size {
    /// At a point.
    At(SizeAt),
    /// Near sides and lines.
    From(SizeFrom),
    /// Between points.
    Between(SizeBetween),
    /// In a file beside the domain's.
    File(SizeFile),
}

/// A wanted edge length at a place, `[x, y, h]`
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "json", derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "json", serde(from = "[f64; 3]", into = "[f64; 3]"))]
pub struct SizeAt {
    /// The place.
    #[cfg_attr(feature = "json", schemars(with = "[f64; 2]"))]
    pub at: DVec2,
    /// The greatest edge length there; it grows from here as from the boundary.
    pub size: f64,
}

/// A size near sides and lines, which grows with the distance from them
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "json", derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "json", serde(deny_unknown_fields))]
pub struct SizeFrom {
    /// The names of sides and lines, such as "wall" or "side 1"
    pub from: Vec<String>,
    /// The size on them
    #[cfg_attr(feature = "json", schemars(extend("exclusiveMinimum" = 0)))]
    pub size: f64,
    /// The change of size per distance from them [default: the growth of all sizes]
    #[cfg_attr(feature = "json", schemars(range(min = 0)))]
    pub growth: Option<f64>,
    /// The distance up to which that growth holds; the growth of all sizes holds beyond [default: everywhere]
    #[cfg_attr(feature = "json", schemars(extend("exclusiveMinimum" = 0)))]
    pub until: Option<f64>,
}

/// Sizes at points and, between them, on triangles: a background mesh or a grid. It may cover a part of the domain
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "json", derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "json", serde(deny_unknown_fields))]
pub struct SizeBetween {
    /// Rows `[x, y, h]`
    pub points: Vec<SizeAt>,
    /// Three indices of points a row; on each triangle the size is linear
    pub triangles: Vec<[u32; 3]>,
}

/// Sizes in a file: an ESRI grid (.asc), classic NetCDF, an NPZ with `values`, `origin` and `spacing`, an MSH with node data, or a VTU with
/// point data
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "json", derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "json", serde(deny_unknown_fields))]
pub struct SizeFile {
    /// Its name; it is in the folder of the domain's file
    pub file: String,
}

/// Whether a number is a size.
pub(crate) fn is_size(size: f64) -> bool {
    size.is_finite() && size > 0.0
}

impl Size {
    /// Checks all values that need no domain; `index` is that in the list.
    pub(crate) fn check(&self, index: usize) -> Result<(), DomainError> {
        let place = || Place::key("sizes").then(index);
        let wrong =
            |what: &str, size: f64| format!("{what} is {size}; a size is a finite number above 0");
        match self {
            Self::At(SizeAt { size, .. }) if !is_size(*size) => {
                Err(place().error(wrong(&format!("size {index}"), *size)))
            }
            Self::At(_) | Self::File(_) => Ok(()),
            Self::From(SizeFrom { from, size, growth, until }) => {
                if from.is_empty() {
                    let message = "give the names of sides and lines, such as [\"wall\"]";
                    return Err(place().then("from").error(message));
                }
                if !is_size(*size) {
                    return Err(place().then("size").error(wrong("the size", *size)));
                }
                if let Some(growth) =
                    growth.filter(|growth| !(growth.is_finite() && *growth >= 0.0))
                {
                    let message = format!("growth is {growth}; it is a finite number of 0 or more");
                    return Err(place().then("growth").error(message));
                }
                match until.filter(|until| !is_size(*until)) {
                    Some(until) => Err(place()
                        .then("until")
                        .error(format!("the distance is {until}; it is a finite number above 0"))),
                    None => Ok(()),
                }
            }
            Self::Between(between) => between.check().map_err(|error| error.inside(place())),
        }
    }
}

impl SizeBetween {
    /// The sizes of a grid: values row by row from the lowest y on, `columns` a row. Between four values that are
    /// sizes, it is two triangles; other values, such as NaN, are left out. `None` if the number of values is no
    /// multiple of `columns`.
    pub fn grid(origin: DVec2, spacing: DVec2, columns: usize, values: &[f64]) -> Option<Self> {
        let rows =
            values.len().checked_div(columns).filter(|rows| rows * columns == values.len())?;
        let mut between = Self::default();
        let mut indices = vec![None; values.len()];
        for (at, &size) in values.iter().enumerate().filter(|(_, size)| is_size(**size)) {
            let step = DVec2::new((at % columns) as f64, (at / columns) as f64);
            indices[at] = Some(u32::try_from(between.points.len()).ok()?);
            between.points.push(SizeAt { at: origin + step * spacing, size });
        }
        for (row, column) in (1..rows).flat_map(|row| (1..columns).map(move |column| (row, column)))
        {
            let above = row * columns + column;
            let below = above - columns;
            if let [Some(a), Some(b), Some(c), Some(d)] =
                [below - 1, below, above, above - 1].map(|at| indices[at])
            {
                between.triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
        Some(between)
    }

    /// The sizes at the vertices of a mesh; values that are no sizes are left out with their triangles.
    pub fn of_mesh(points: Vec<SizeAt>, triangles: &[[u32; 3]]) -> Self {
        let mut between = Self::default();
        let indices: Vec<Option<u32>> = points
            .into_iter()
            .map(|point| {
                let is_valid = is_size(point.size) && point.at.is_finite();
                is_valid.then(|| {
                    between.points.push(point);
                    between.points.len() as u32 - 1
                })
            })
            .collect();
        between.triangles = triangles
            .iter()
            .filter_map(|triangle| match triangle.map(|point| indices[point as usize]) {
                [Some(a), Some(b), Some(c)] => Some([a, b, c]),
                _ => None,
            })
            .collect();
        between
    }

    fn check(&self) -> Result<(), DomainError> {
        for (index, SizeAt { at, size }) in self.points.iter().enumerate() {
            if !(is_size(*size) && at.is_finite()) {
                let message = format!(
                    "the size at ({}, {}) is {size}; all three are finite, and a size is above 0",
                    at.x, at.y
                );
                return Err(Place::key("points").then(index).error(message));
            }
        }
        let count = self.points.len();
        for (index, triangle) in self.triangles.iter().enumerate() {
            if let Some(point) = triangle.iter().find(|point| **point as usize >= count) {
                let message = format!("found point {point}; there are {count} points, from 0");
                return Err(Place::key("triangles").then(index).error(message));
            }
        }
        match count {
            0 => Err(Place::key("points").error("give at least one row [x, y, h]")),
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_is_triangles_where_all_four_values_are_sizes() {
        let [origin, spacing] = [[1.0, 2.0], [0.5, 0.25]].map(DVec2::from);
        let values = [1.0, 2.0, 3.0, 4.0, f64::NAN, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0];
        let grid = SizeBetween::grid(origin, spacing, 3, &values).unwrap();
        assert_eq!((grid.points.len(), grid.triangles.len()), (11, 4));
        assert_eq!(grid.points[4], SizeAt { at: DVec2::new(2.0, 2.25), size: 6.0 });
        // The four cells beside the missing value are left out.
        assert_eq!(grid.triangles[0], [5, 6, 9]);
        grid.check().unwrap();
        assert_eq!(SizeBetween::grid(origin, spacing, 5, &values), None);
        assert_eq!(SizeBetween::grid(origin, spacing, 0, &[]), None);
    }
}
