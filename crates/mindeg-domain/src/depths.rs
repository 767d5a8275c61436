//! Depths of water on a grid: at any point, and the sizes of edges that they ask for.

use std::collections::VecDeque;
use std::f64::consts::TAU;

use glam::DVec2;

use crate::projection::Projection;
use crate::sizes::SizeBetween;

/// Gravity, in m/s².
const GRAVITY: f64 = 9.81;
/// The period of the M2 tide, in seconds.
const M2_PERIOD: f64 = 12.42 * 3600.0;
/// Water is taken to be at least so deep for a size, in metres.
const SHALLOWEST: f64 = 1.0;
/// The Courant number that a time step is to keep.
const COURANT: f64 = 0.5;
/// A greater size than this is none, in metres.
const LARGEST: f64 = 1e7;
/// The mean radius of the globe, in metres.
const GLOBE: f64 = 6_371_008.8;
/// Sizes are taken at no more points than these: of a finer grid, the least of each block.
const MOST_SIZES: usize = 250_000;

/// Depths on a grid, positive down, in metres.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_domain::Depths;
///
/// // Ten metres deep in the west, twenty in the east; nothing is known of one place.
/// let values = [10.0, 20.0, 10.0, f64::NAN];
/// let depths = Depths::grid(DVec2::ZERO, DVec2::ONE, 2, &values).expect("two rows of two");
/// assert_eq!(depths.at(DVec2::new(0.5, 0.0)), 15.0);
/// // Beyond the grid and where nothing is known, the nearest depth holds.
/// assert_eq!(depths.at(DVec2::new(-3.0, 0.0)), 10.0);
/// assert!([10.0, 20.0].contains(&depths.at(DVec2::new(1.0, 1.0))));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Depths {
    origin: DVec2,
    spacing: DVec2,
    columns: usize,
    rows: usize,
    /// Each is known, or that of the nearest place where it is.
    values: Vec<f64>,
    is_known: Vec<bool>,
    /// The grid is in degrees, of which this makes the plane.
    projection: Option<Projection>,
}

/// Rules for sizes of edges by the depth; the least size holds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DepthRules {
    /// So many edges on the wave of the M2 tide, whose length is its period times the root of gravity times depth.
    pub wavelength: Option<f64>,
    /// 2 pi over this number times the depth over its gradient: smaller edges where the bottom is steep.
    pub slope: Option<f64>,
    /// No size is so small that a wave, at a Courant number of 0.5, passes it in less than this time, in seconds.
    pub time_step: Option<f64>,
}

impl Depths {
    /// Depths row by row from the lowest y on, `columns` a row; values that are not finite are not known. `None` if they
    /// are no rectangle of at least two rows and columns, or none is known. O(n).
    #[must_use]
    pub fn grid(origin: DVec2, spacing: DVec2, columns: usize, values: &[f64]) -> Option<Self> {
        let rows = values.len().checked_div(columns)?;
        let is_known: Vec<bool> = values.iter().map(|value| value.is_finite()).collect();
        let is_grid = rows >= 2 && columns >= 2 && rows * columns == values.len();
        let is_placed = origin.is_finite() && spacing.cmpgt(DVec2::ZERO).all();
        if !(is_grid && is_placed && is_known.contains(&true)) {
            return None;
        }
        let mut values = values.to_vec();
        fill(&mut values, &is_known, columns);
        Some(Self { origin, spacing, columns, rows, values, is_known, projection: None })
    }

    /// The same depths with the other sign: heights become depths.
    #[must_use]
    pub fn negated(mut self) -> Self {
        self.values.iter_mut().for_each(|value| *value = -*value + 0.0);
        self
    }

    /// The depths in the plane of a domain: a grid within degrees is projected as a projected domain is.
    #[must_use]
    pub fn in_plane_of(self, projection: Option<&Projection>) -> Self {
        let end = self.origin + self.spacing * DVec2::new(self.columns as f64, self.rows as f64);
        let is_degrees =
            self.origin.x >= -361.0 && end.x <= 722.0 && self.origin.y >= -91.0 && end.y <= 92.0;
        Self { projection: projection.copied().filter(|_| is_degrees), ..self }
    }

    /// Whether the grid is in degrees.
    #[must_use]
    pub fn is_in_degrees(&self) -> bool {
        self.projection.is_some()
    }

    /// A point of the plane in columns and rows of the grid.
    fn place(&self, point: DVec2) -> DVec2 {
        let Some(projection) = &self.projection else {
            return (point - self.origin) / self.spacing;
        };
        let mut at = projection.to_degrees(point);
        // Grids begin at -180° or at 0°, and longitudes go on across the antimeridian.
        if at.x < self.origin.x - self.spacing.x {
            at.x += 360.0;
        } else if at.x - 360.0 >= self.origin.x - self.spacing.x {
            at.x -= 360.0;
        }
        (at - self.origin) / self.spacing
    }

    /// Whether a point is beyond the grid, by more than half of a cell.
    #[must_use]
    pub fn is_beyond(&self, point: DVec2) -> bool {
        let at = self.place(point);
        let last = DVec2::new(self.columns as f64, self.rows as f64) - 0.5;
        !(at.cmpge(DVec2::splat(-0.5)).all() && at.cmple(last).all())
    }

    /// Whether a point lies in a gap of the grid: none of the four values around it is known. Beyond the grid, those nearest to it
    /// are asked.
    #[must_use]
    pub fn is_in_gap(&self, point: DVec2) -> bool {
        let ([column, row], _) = self.cell(point);
        let around = [row, row + 1].map(|row| row * self.columns + column);
        !around.into_iter().any(|index| self.is_known[index] || self.is_known[index + 1])
    }

    /// The cell that a point is in, or the nearest one: its column and row, and where in it the point is.
    fn cell(&self, point: DVec2) -> ([usize; 2], DVec2) {
        let last = DVec2::new((self.columns - 1) as f64, (self.rows - 1) as f64);
        let at = self.place(point).clamp(DVec2::ZERO, last);
        let cell = [(at.x as usize).min(self.columns - 2), (at.y as usize).min(self.rows - 2)];
        (cell, at - DVec2::new(cell[0] as f64, cell[1] as f64))
    }

    /// The depth at a point: bilinear between four values; the nearest where none is known.
    #[must_use]
    pub fn at(&self, point: DVec2) -> f64 {
        let ([column, row], share) = self.cell(point);
        let value = |row: usize, column: usize| self.values[row * self.columns + column];
        let along =
            |row: usize| value(row, column) * (1.0 - share.x) + value(row, column + 1) * share.x;
        along(row) * (1.0 - share.y) + along(row + 1) * share.y
    }

    /// The sizes that the depths ask for, where they are known and in the box around some points of the plane.
    ///
    /// O(n) for n values of the grid.
    #[must_use]
    pub fn sizes(
        &self,
        rules: &DepthRules,
        around: impl IntoIterator<Item = DVec2>,
    ) -> SizeBetween {
        let last = DVec2::new((self.columns - 1) as f64, (self.rows - 1) as f64);
        let (mut least, mut most) = (last, DVec2::ZERO);
        for point in around {
            let at = self.place(point);
            (least, most) = (least.min(at), most.max(at));
        }
        let whole = |at: DVec2, margin: f64| (at + margin).clamp(DVec2::ZERO, last);
        let (low, high) = (whole(least, -2.0), whole(most, 3.0));
        let columns = low.x as usize..high.x as usize + 1;
        let rows = low.y as usize..high.y as usize + 1;
        let count = columns.len() * rows.len();
        let block = (libm::ceil(libm::sqrt(count as f64 / MOST_SIZES as f64)) as usize).max(1);
        let starts =
            |range: &std::ops::Range<usize>| range.clone().step_by(block).collect::<Vec<_>>();
        let (column_starts, row_starts) = (starts(&columns), starts(&rows));
        let mut values = Vec::with_capacity(column_starts.len() * row_starts.len());
        for &row in &row_starts {
            for &column in &column_starts {
                let cells = (row..(row + block).min(rows.end)).flat_map(|row| {
                    (column..(column + block).min(columns.end)).map(move |column| (row, column))
                });
                values.push(
                    cells
                        .map(|(row, column)| self.size(rules, row, column))
                        .fold(f64::NAN, f64::min),
                );
            }
        }
        let middle = DVec2::splat((block - 1) as f64 / 2.0);
        let first = DVec2::new(columns.start as f64, rows.start as f64) + middle;
        let origin = self.origin + first * self.spacing;
        let sizes =
            SizeBetween::grid(origin, self.spacing * block as f64, column_starts.len(), &values);
        let mut sizes = sizes.unwrap_or_default();
        if let Some(projection) = &self.projection {
            sizes.points.iter_mut().for_each(|point| point.at = projection.to_plane(point.at));
        }
        sizes
    }

    /// The size at a place of the grid; NaN if none is asked for.
    fn size(&self, rules: &DepthRules, row: usize, column: usize) -> f64 {
        let index = row * self.columns + column;
        let depth = self.values[index];
        if !self.is_known[index] || depth <= 0.0 {
            return f64::NAN;
        }
        let depth = depth.max(SHALLOWEST);
        let speed = libm::sqrt(GRAVITY * depth);
        let by_wave = rules.wavelength.map(|count| M2_PERIOD * speed / count);
        let by_slope = rules.slope.map(|count| TAU / count * depth / self.gradient(row, column));
        let size = by_wave.into_iter().chain(by_slope).fold(f64::NAN, f64::min);
        let least = rules.time_step.map_or(0.0, |time| speed * time / COURANT);
        if size.is_nan() { size } else { size.max(least).min(LARGEST) }
    }

    /// The gradient of the depth in metres a metre.
    fn gradient(&self, row: usize, column: usize) -> f64 {
        let cell = match self.projection {
            None => self.spacing,
            Some(_) => {
                let latitude = (self.origin.y + row as f64 * self.spacing.y).to_radians();
                let metres = GLOBE * self.spacing * 1_f64.to_radians();
                DVec2::new(metres.x * libm::cos(latitude).max(1e-3), metres.y)
            }
        };
        let across = |at: usize, count: usize| [at.saturating_sub(1), (at + 1).min(count - 1)];
        let value = |row: usize, column: usize| self.values[row * self.columns + column];
        let [west, east] = across(column, self.columns);
        let [south, north] = across(row, self.rows);
        let x = (value(row, east) - value(row, west)) / ((east - west) as f64 * cell.x);
        let y = (value(north, column) - value(south, column)) / ((north - south) as f64 * cell.y);
        libm::hypot(x, y)
    }
}

/// Gives values that are not known that of the nearest known one, in steps along rows and columns.
fn fill(values: &mut [f64], is_known: &[bool], columns: usize) {
    let mut is_reached = is_known.to_vec();
    let mut open: VecDeque<usize> = (0..values.len()).filter(|index| is_known[*index]).collect();
    while let Some(index) = open.pop_front() {
        let column = index % columns;
        let near = [
            (column > 0).then(|| index - 1),
            (column + 1 < columns).then_some(index + 1),
            index.checked_sub(columns),
            Some(index + columns).filter(|next| *next < values.len()),
        ];
        for next in near.into_iter().flatten() {
            if !std::mem::replace(&mut is_reached[next], true) {
                values[next] = values[index];
                open.push_back(next);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A beach: ten metres deep, one more with each kilometre to the east.
    fn beach() -> Depths {
        let values: Vec<f64> = (0..30).map(|index| 10.0 + f64::from(index % 6)).collect();
        Depths::grid(DVec2::ZERO, DVec2::splat(1000.0), 6, &values).unwrap()
    }

    #[test]
    fn sizes_follow_the_rules() {
        let around = [DVec2::ZERO, DVec2::new(5000.0, 4000.0)];
        let size = |rules: DepthRules| beach().sizes(&rules, around).points[2];
        let rules = DepthRules::default();
        let by_wave = size(DepthRules { wavelength: Some(30.0), ..rules });
        // The third column: 12 m deep.
        assert_eq!(by_wave.at, DVec2::new(2000.0, 0.0));
        let wave = M2_PERIOD * libm::sqrt(GRAVITY * 12.0) / 30.0;
        assert!((by_wave.size - wave).abs() < 1e-9 * wave);
        let by_slope = size(DepthRules { slope: Some(15.0), ..rules });
        assert!((by_slope.size - TAU / 15.0 * 12.0 / 0.001).abs() < 1e-6);
        let both = DepthRules { wavelength: Some(30.0), slope: Some(15.0), time_step: None };
        assert_eq!(size(both).size, by_slope.size.min(by_wave.size));
        let stepped = size(DepthRules { time_step: Some(1000.0), ..both });
        assert!((stepped.size - 2000.0 * libm::sqrt(GRAVITY * 12.0)).abs() < 1e-6);
        assert!(beach().sizes(&rules, around).points.is_empty());
    }

    #[test]
    fn a_gap_is_where_none_of_four_values_is_known() {
        let value = |index| if [1, 2, 3].contains(&(index / 5)) { f64::NAN } else { 7.0 };
        let values: Vec<f64> = (0..25).map(value).collect();
        let depths = Depths::grid(DVec2::ZERO, DVec2::ONE, 5, &values).unwrap();
        let is_in_gap = |y: f64| depths.is_in_gap(DVec2::new(2.5, y));
        assert_eq!([0.5, 1.5, 2.5, 3.5].map(is_in_gap), [false, true, true, false]);
        assert_eq!(depths.at(DVec2::new(2.5, 2.0)), 7.0);
    }

    #[test]
    fn a_grid_in_degrees_is_projected_with_its_domain() {
        let projection: Projection = "EPSG:32635".parse().unwrap();
        let values: Vec<f64> = (0..12).map(f64::from).collect();
        let depths = Depths::grid(DVec2::new(24.0, 38.0), DVec2::splat(0.5), 4, &values).unwrap();
        let depths = depths.in_plane_of(Some(&projection));
        assert!(depths.is_in_degrees());
        let at = |degrees: [f64; 2]| depths.at(projection.to_plane(degrees.into()));
        assert!((at([24.25, 38.5]) - 4.5).abs() < 1e-9);
        assert!((at([25.5, 39.0]) - 11.0).abs() < 1e-9);
        assert!(depths.is_beyond(projection.to_plane(DVec2::new(23.0, 38.0))));
        assert!(!depths.is_beyond(projection.to_plane(DVec2::new(24.6, 38.3))));
        let around = [[24.0, 38.0], [25.5, 39.0]].map(|it| projection.to_plane(it.into()));
        let sizes =
            depths.sizes(&DepthRules { wavelength: Some(30.0), ..DepthRules::default() }, around);
        assert_eq!((sizes.points.len(), sizes.triangles.len()), (11, 10));
        assert_eq!(sizes.points[0].at, projection.to_plane(DVec2::new(24.5, 38.0)));
        // A grid in metres stays as it is.
        assert!(!beach().in_plane_of(Some(&projection)).is_in_degrees());
    }

    #[test]
    fn what_is_no_grid_is_none_and_heights_are_negated() {
        let grid = |columns, values: &[f64]| Depths::grid(DVec2::ZERO, DVec2::ONE, columns, values);
        assert!(
            grid(2, &[1.0, 2.0, 3.0]).is_none()
                && grid(0, &[]).is_none()
                && grid(2, &[1.0, 2.0]).is_none()
        );
        assert!(grid(2, &[f64::NAN; 4]).is_none());
        let heights = grid(2, &[-5.0, 3.0, f64::NAN, f64::NAN]).unwrap().negated();
        assert_eq!([heights.at(DVec2::ZERO), heights.at(DVec2::new(1.0, 1.0))], [5.0, -3.0]);
    }
}
