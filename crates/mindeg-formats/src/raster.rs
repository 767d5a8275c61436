//! The contents of grids.

use glam::DVec2;

/// Values on a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Raster {
    /// The position of the first value.
    pub origin: DVec2,
    /// The distance of columns and of rows.
    pub spacing: DVec2,
    /// The number of values in a row.
    pub columns: usize,
    /// The values, row by row from the lowest y on; NaN where there is none.
    pub values: Vec<f64>,
}
