//! Statistics of many triangles or vertices: distributions, shares, histograms.
//!
//! Results do not depend on how the work is divided: quantiles are values that occur, and sums
//! are taken in blocks of fixed size, in order.
//!
//! Limits: quantiles need all values at once, 72 bytes a triangle for all measures, and 8 more for
//! each thread.

use std::collections::BTreeMap;

use crate::parallel::map_all;
use crate::quality::{METRICS, TriangleQuality};

/// The minimum angles in degrees below which [`QualitySummary::shares_below`] counts triangles.
pub const ANGLES: [f64; 5] = [1.0, 5.0, 10.0, 15.0, 20.0];

/// The number of values in a block of a sum.
const BLOCK: usize = 1024;

/// How the values of a measure are spread.
///
/// The quantile at p is the least value that at least the share p of all values does not exceed:
/// the value of rank ⌈p n⌉ of n in ascending order (nearest rank).
///
/// # Example
///
/// ```
/// use mindeg_mesh::quality::Distribution;
///
/// let spread = Distribution::of(vec![4.0, 1.0, 3.0, 2.0]).unwrap();
/// assert_eq!((spread.min, spread.median, spread.mean, spread.max), (1.0, 2.0, 2.5, 4.0));
/// assert_eq!(Distribution::of(vec![]), None);
/// ```
///
/// With the feature `serde`, what is infinite, as ratios of a flat triangle are, is null in JSON.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(
    feature = "serde",
    schemars(description = "How the values of a measure are spread; what is infinite is null.")
)]
pub struct Distribution {
    /// The least value.
    #[cfg_attr(feature = "serde", schemars(with = "Option<f64>"))]
    pub min: f64,
    /// The quantile at 0.01.
    #[cfg_attr(feature = "serde", schemars(with = "Option<f64>"))]
    pub p01: f64,
    /// The quantile at 0.5.
    #[cfg_attr(feature = "serde", schemars(with = "Option<f64>"))]
    pub median: f64,
    /// The arithmetic mean; infinite where a value is.
    #[cfg_attr(feature = "serde", schemars(with = "Option<f64>"))]
    pub mean: f64,
    /// The quantile at 0.99.
    #[cfg_attr(feature = "serde", schemars(with = "Option<f64>"))]
    pub p99: f64,
    /// The greatest value.
    #[cfg_attr(feature = "serde", schemars(with = "Option<f64>"))]
    pub max: f64,
}

impl Distribution {
    /// The distribution of some values without NaN; `None` if the list is empty. O(n).
    pub fn of(mut values: Vec<f64>) -> Option<Self> {
        let count = values.len();
        if count == 0 {
            return None;
        }
        let mean = sum(&values) / count as f64;
        let min = values.iter().copied().min_by(f64::total_cmp)?;
        let max = values.iter().copied().max_by(f64::total_cmp)?;
        // Indices in ascending order, which are ranks minus one. The median separates the lower
        // values from the higher ones.
        let [first, middle, last] =
            [count.div_ceil(100) - 1, count.div_ceil(2) - 1, count - count / 100 - 1];
        let select =
            |values: &mut [f64], index| *values.select_nth_unstable_by(index, f64::total_cmp).1;
        let (lower, &mut median, higher) = values.select_nth_unstable_by(middle, f64::total_cmp);
        let p01 = if first < middle { select(lower, first) } else { median };
        let p99 = if last > middle { select(higher, last - middle - 1) } else { median };
        Some(Self { min, p01, median, mean, p99, max })
    }
}

/// The sum of sums of blocks, which rounds less than a sum from front to back and can run in
/// parallel.
fn sum(values: &[f64]) -> f64 {
    values.chunks(BLOCK).map(|block| block.iter().sum::<f64>()).sum()
}

/// The measures of some triangles, each in a list of its own.
#[derive(Default)]
pub(crate) struct Columns {
    values: [Vec<f64>; METRICS.len()],
    below: [usize; ANGLES.len()],
}

impl FromIterator<TriangleQuality> for Columns {
    fn from_iter<T: IntoIterator<Item = TriangleQuality>>(qualities: T) -> Self {
        let qualities = qualities.into_iter();
        let mut columns = Self::default();
        columns.values.iter_mut().for_each(|column| column.reserve(qualities.size_hint().0));
        for quality in qualities {
            for (column, metric) in columns.values.iter_mut().zip(METRICS) {
                column.push((metric.of)(&quality));
            }
            for (count, angle) in columns.below.iter_mut().zip(ANGLES) {
                *count += usize::from(quality.min_angle < angle);
            }
        }
        columns
    }
}

/// The measures of all triangles of a mesh.
///
/// # Example
///
/// ```
/// use mindeg_mesh::quality::{QualitySummary, TriangleQuality};
///
/// let right = TriangleQuality::of([0.0, 0.0].into(), [4.0, 0.0].into(), [0.0, 3.0].into());
/// let summary = QualitySummary::of([right; 4]).unwrap();
/// assert_eq!((summary.triangle_count, summary.area), (4, 24.0));
/// assert_eq!(summary.metric("max_angle").unwrap().max, 90.0);
/// assert_eq!(summary.shares_below, [0.0; 5]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct QualitySummary {
    /// The number of triangles.
    pub triangle_count: usize,
    /// The sum of their areas.
    pub area: f64,
    /// The distribution of each measure, in the order of [`METRICS`].
    pub metrics: [Distribution; METRICS.len()],
    /// For each of [`ANGLES`], the share of triangles with a smaller minimum angle, in [0, 1].
    pub shares_below: [f64; ANGLES.len()],
}

impl QualitySummary {
    /// Summarizes triangles; `None` if the list is empty. O(n) time and memory.
    pub fn of(qualities: impl IntoIterator<Item = TriangleQuality>) -> Option<Self> {
        Self::of_blocks(vec![qualities.into_iter().collect()])
    }

    /// Summarizes triangles block after block; `None` if all blocks are empty.
    pub(crate) fn of_blocks(blocks: Vec<Columns>) -> Option<Self> {
        let triangle_count = blocks.iter().map(|block| block.values[0].len()).sum();
        let mut below = [0_usize; ANGLES.len()];
        let mut columns: [Vec<Vec<f64>>; METRICS.len()] = Default::default();
        for block in blocks {
            below.iter_mut().zip(block.below).for_each(|(sum, count)| *sum += count);
            columns.iter_mut().zip(block.values).for_each(|(column, part)| column.push(part));
        }
        let summed_up = map_all(Vec::from(columns), |parts| {
            let values = parts.concat();
            // Else the values would be kept twice.
            drop(parts);
            Some((sum(&values), Distribution::of(values)?))
        });
        let (sums, distributions): (Vec<_>, Vec<_>) =
            summed_up.into_iter().collect::<Option<Vec<_>>>()?.into_iter().unzip();
        Some(Self {
            triangle_count,
            area: sums[0],
            metrics: distributions.try_into().ok()?,
            shares_below: below.map(|count| count as f64 / triangle_count as f64),
        })
    }

    /// The distribution of the measure of the given name.
    pub fn metric(&self, name: &str) -> Option<&Distribution> {
        METRICS.iter().zip(&self.metrics).find(|(metric, _)| metric.name == name).map(|(_, d)| d)
    }

    /// The distribution of each measure by its name.
    #[must_use]
    pub fn by_name(&self) -> BTreeMap<&'static str, Distribution> {
        METRICS.iter().zip(&self.metrics).map(|(metric, spread)| (metric.name, *spread)).collect()
    }

    /// The share of triangles below each of [`ANGLES`].
    #[must_use]
    pub fn shares_by_angle(&self) -> BTreeMap<u32, f64> {
        ANGLES.iter().zip(self.shares_below).map(|(&angle, share)| (angle as u32, share)).collect()
    }
}

/// The number of vertices of each degree. Memory grows only with the number of different degrees.
///
/// # Example
///
/// ```
/// use mindeg_mesh::quality::DegreeHistogram;
///
/// let histogram: DegreeHistogram = [4, 2, 4, 3, 4].into_iter().collect();
/// assert_eq!(histogram.max_degree(), Some(4));
/// assert_eq!(histogram.iter().collect::<Vec<_>>(), [(2, 1), (3, 1), (4, 3)]);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct DegreeHistogram {
    counts: BTreeMap<u32, u64>,
}

impl DegreeHistogram {
    /// Each degree that occurs and its number of vertices, in ascending order.
    pub fn iter(&self) -> impl Iterator<Item = (u32, u64)> + '_ {
        self.counts.iter().map(|(&degree, &count)| (degree, count))
    }

    /// The number of vertices of a degree.
    pub fn count(&self, degree: u32) -> u64 {
        self.counts.get(&degree).copied().unwrap_or(0)
    }

    /// The largest degree; `None` if the histogram is empty.
    pub fn max_degree(&self) -> Option<u32> {
        self.counts.keys().next_back().copied()
    }
}

impl FromIterator<u32> for DegreeHistogram {
    fn from_iter<T: IntoIterator<Item = u32>>(degrees: T) -> Self {
        let mut counts = BTreeMap::new();
        for degree in degrees {
            *counts.entry(degree).or_insert(0) += 1;
        }
        Self { counts }
    }
}

impl<'a> std::iter::Sum<&'a DegreeHistogram> for DegreeHistogram {
    fn sum<I: Iterator<Item = &'a DegreeHistogram>>(histograms: I) -> Self {
        let mut counts = BTreeMap::new();
        for (degree, count) in histograms.flat_map(DegreeHistogram::iter) {
            *counts.entry(degree).or_insert(0) += count;
        }
        Self { counts }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    #[test]
    fn the_largest_degree_is_that_of_some_vertex() {
        assert_eq!([3, 7, 4, 3].into_iter().collect::<DegreeHistogram>().max_degree(), Some(7));
        assert_eq!([0; 0].into_iter().collect::<DegreeHistogram>().max_degree(), None);
    }

    #[test]
    fn quantiles_are_of_the_nearest_rank() {
        for (count, [min, p01, median, p99, max]) in [
            (1_u32, [1.0, 1.0, 1.0, 1.0, 1.0]),
            (2, [1.0, 1.0, 1.0, 2.0, 2.0]),
            (100, [1.0, 1.0, 50.0, 99.0, 100.0]),
            (101, [1.0, 2.0, 51.0, 100.0, 101.0]),
            (1000, [1.0, 10.0, 500.0, 990.0, 1000.0]),
        ] {
            // In some order: 7 has no divisor in common with the counts.
            let values = (0..count).map(|i| f64::from(i * 7 % count + 1)).collect();
            let mean = f64::from(count + 1) / 2.0;
            let expected = Distribution { min, p01, median, mean, p99, max };
            assert_eq!(Distribution::of(values), Some(expected), "{count}");
        }
        let infinite = Distribution::of(vec![1.0, f64::INFINITY, 2.0]).unwrap();
        assert_eq!((infinite.median, infinite.mean), (2.0, f64::INFINITY));
    }

    #[test]
    fn sums_up_triangles() {
        let right = |height: f64| {
            TriangleQuality::of(DVec2::ZERO, DVec2::new(1.0, 0.0), DVec2::new(0.0, height))
        };
        // The minimum angles are 45, some 11, 5.7 and 0.6 degrees.
        let summary = QualitySummary::of([1.0, 0.2, 0.1, 0.01].map(right)).unwrap();
        assert_eq!(summary.triangle_count, 4);
        assert!((summary.area - 0.655).abs() < 1e-15);
        assert_eq!(summary.shares_below, [0.25, 0.25, 0.5, 0.75, 0.75]);
        assert_eq!(summary.metric("max_angle").unwrap().min, 90.0);
        assert_eq!(summary.metric("minimum_height").unwrap().max, right(1.0).minimum_height);
        assert_eq!(summary.metric("skew"), None);
        assert_eq!(QualitySummary::of([]), None);
    }
}
