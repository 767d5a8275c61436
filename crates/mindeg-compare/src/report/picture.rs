//! What the pictures and charts of an HTML report are drawn from, packed small.
//!
//! Arrays go as base64 of little-endian numbers. Coordinates are relative to the center of the
//! domain, so that they are exact as far from the origin as they are near it. Measures go as
//! f32: they choose a color and are read off to four digits.
//!
//! Limits: of a method with more than [`MAX_DRAWN`] triangles at most so many go into the
//! picture. Charts and tables always count all.

use super::metric::{SHOWN, Scale, ShownMetric};
use super::tables;
use super::{MethodFigures, Report};
use crate::{Comparison, MINDEG, Reference, measure};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use glam::DVec2;
use mindeg_geometry::export::degree_color;
use serde::Serialize;

/// The most triangles of one method in a picture.
pub(crate) const MAX_DRAWN: usize = 20_000;

/// The number of bars in the chart of a measure.
const BARS: usize = 30;

/// Everything the script of the page reads.
#[derive(Serialize)]
pub(crate) struct Picture {
    /// The center of the domain, which all coordinates are relative to.
    center: [f64; 2],
    corners: Vec<[f64; 2]>,
    /// x and y of each drawn vertex, f64.
    points: String,
    /// The numbers of the drawn vertices, u32; empty where all are drawn.
    vertices: String,
    optimal_max_degree: u32,
    /// The colors of degrees, the first for the lowest; the last is for all above, too.
    degree_colors: Vec<String>,
    lowest_colored_degree: u32,
    /// The rows of the degree chart: a name and the lowest degree in it.
    degrees: Vec<(String, u32)>,
    metrics: Vec<Measure>,
    methods: Vec<Drawing>,
}

/// One measure, and the axis on which all methods show it.
#[derive(Serialize)]
struct Measure {
    name: &'static str,
    title: String,
    unit: &'static str,
    explanation: String,
    higher_is_better: bool,
    logarithmic: bool,
    range: [f64; 2],
    /// Whether there are values below and above the range.
    goes_beyond: [bool; 2],
}

/// One method's mesh.
#[derive(Serialize)]
struct Drawing {
    name: String,
    /// Three indices into the drawn vertices each, u32.
    triangles: String,
    /// The numbers of the drawn triangles, u32; empty where all are drawn.
    numbers: String,
    /// The degree of each drawn vertex, u32.
    degrees: String,
    /// For each measure, its value for each drawn triangle, f32.
    values: Vec<String>,
    /// For each measure, the number of triangles in each bar.
    bars: Vec<Vec<u32>>,
    /// The number of vertices in each row of the degree chart.
    degree_bars: Vec<u64>,
    /// The index of the worst triangle among the drawn.
    worst: usize,
    /// The index of a vertex of the largest degree among the drawn.
    busiest: usize,
}

/// The names of the rows of the degree chart are those of the table.
pub(crate) fn picture(comparison: &Comparison) -> Picture {
    let report = comparison.report();
    let points = comparison.points();
    let corners = report.domain.corners.iter().copied().map(DVec2::from);
    let (low, high) = corners
        .clone()
        .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), c| (low.min(c), high.max(c)));
    let center = low + (high - low) / 2.0;

    let drawn: Vec<Vec<usize>> = comparison
        .methods()
        .map(|(method, triangles)| drawn_triangles(method, points, triangles))
        .collect();
    let shown = shown_vertices(comparison, &drawn);
    let place_of = |vertex: u32| match &shown {
        Some(shown) => shown.partition_point(|&other| other < vertex) as u32,
        None => vertex,
    };
    let placed = |vertex: u32| (points[vertex as usize] - center).to_array();
    let all = 0..report.domain.vertices;
    let coordinates: Vec<f64> = match &shown {
        Some(shown) => shown.iter().flat_map(|&vertex| placed(vertex)).collect(),
        None => all.clone().flat_map(placed).collect(),
    };

    let axes: Vec<[f64; 2]> = SHOWN.iter().map(|metric| axis(report, metric)).collect();
    let ranges = tables::degree_ranges(report);
    let drawing = |((method, triangles), drawn): ((&MethodFigures, &[[u32; 3]]), &Vec<usize>)| {
        let degrees = measure::degrees(report.domain.vertices, triangles);
        let degrees: Vec<u32> = match &shown {
            Some(shown) => shown.iter().map(|&vertex| degrees[vertex as usize]).collect(),
            None => degrees,
        };
        let values = |number: usize| {
            let quality = measure::quality(points, triangles[number]);
            SHOWN.iter().map(move |shown| (shown.metric().of)(&quality))
        };
        let mut bars = vec![vec![0; BARS]; SHOWN.len()];
        for number in 0..triangles.len() {
            for ((bars, value), (shown, axis)) in
                bars.iter_mut().zip(values(number)).zip(SHOWN.iter().zip(&axes))
            {
                let place = position(value, *axis, shown.scale) * BARS as f64;
                bars[(place as usize).min(BARS - 1)] += 1;
            }
        }
        let mut columns = vec![Vec::with_capacity(drawn.len()); SHOWN.len()];
        for &number in drawn {
            for (column, value) in columns.iter_mut().zip(values(number)) {
                column.push(value as f32);
            }
        }
        let worst = method.worst_triangles.first().map_or(0, |worst| worst.triangle as usize);
        let is_thinned = drawn.len() < triangles.len();
        let busiest = (0..degrees.len()).rev().max_by_key(|&vertex| degrees[vertex]).unwrap_or(0);
        Drawing {
            name: method.name.clone(),
            triangles: packed(
                drawn.iter().flat_map(|&n| triangles[n]).map(|v| place_of(v).to_le_bytes()),
            ),
            numbers: packed(drawn.iter().filter(|_| is_thinned).map(|&n| (n as u32).to_le_bytes())),
            degrees: packed(degrees.into_iter().map(u32::to_le_bytes)),
            values: columns
                .into_iter()
                .map(|c| packed(c.into_iter().map(f32::to_le_bytes)))
                .collect(),
            bars,
            degree_bars: ranges.iter().map(|range| tables::vertices_in(method, range)).collect(),
            worst: drawn.partition_point(|&number| number < worst),
            busiest,
        }
    };
    Picture {
        center: center.to_array(),
        corners: corners.map(|corner| (corner - center).to_array()).collect(),
        points: packed(coordinates.into_iter().map(f64::to_le_bytes)),
        vertices: packed(shown.iter().flatten().copied().map(u32::to_le_bytes)),
        optimal_max_degree: report.domain.optimal_max_degree,
        degree_colors: degree_color::DISTINCT
            .map(|degree| {
                let [red, green, blue] = degree_color::srgb(degree);
                format!("#{red:02x}{green:02x}{blue:02x}")
            })
            .collect(),
        lowest_colored_degree: *degree_color::DISTINCT.start(),
        degrees: ranges.iter().map(|range| (tables::degree_name(range), *range.start())).collect(),
        metrics: SHOWN
            .iter()
            .zip(&axes)
            .map(|(shown, &range)| Measure {
                name: shown.name,
                title: shown.title.to_owned(),
                unit: shown.metric().unit,
                explanation: shown.explanation(),
                higher_is_better: shown.higher_is_better(),
                logarithmic: shown.scale == Scale::Logarithmic,
                range,
                goes_beyond: beyond(report, shown, range),
            })
            .collect(),
        methods: comparison.methods().zip(&drawn).map(drawing).collect(),
    }
}

/// The numbers of the triangles that are drawn, ascending: all, or the largest, which make up
/// most of the picture, the worst, and others evenly by number.
fn drawn_triangles(method: &MethodFigures, points: &[DVec2], triangles: &[[u32; 3]]) -> Vec<usize> {
    let count = triangles.len();
    if count <= MAX_DRAWN {
        return (0..count).collect();
    }
    let areas: Vec<f64> =
        triangles.iter().map(|&triangle| measure::quality(points, triangle).area).collect();
    let mut drawn: Vec<usize> = (0..count).collect();
    drawn.select_nth_unstable_by(MAX_DRAWN / 4, |&a, &b| {
        areas[b].total_cmp(&areas[a]).then(a.cmp(&b))
    });
    drawn.truncate(MAX_DRAWN / 4);
    drawn.extend(method.worst_triangles.iter().map(|worst| worst.triangle as usize));
    let others = MAX_DRAWN - drawn.len();
    drawn.extend((0..others).map(|i| (i as u64 * count as u64 / others as u64) as usize));
    drawn.sort_unstable();
    drawn.dedup();
    drawn
}

/// The vertices of all drawn triangles, ascending; `None` where none is left out.
fn shown_vertices(comparison: &Comparison, drawn: &[Vec<usize>]) -> Option<Vec<u32>> {
    let is_thinned = comparison.methods().zip(drawn).any(|((_, all), some)| some.len() < all.len());
    is_thinned.then(|| {
        let used = comparison.methods().zip(drawn).flat_map(|((_, triangles), drawn)| {
            drawn.iter().flat_map(move |&number| triangles[number])
        });
        let mut shown: Vec<u32> = used.collect();
        shown.sort_unstable();
        shown.dedup();
        shown
    })
}

/// The range of a measure in the meshes that matter most, mindeg's and Delaunay's: others would
/// flatten the differences between these two. What is beyond goes to the ends.
fn axis(report: &Report, shown: &ShownMetric) -> [f64; 2] {
    let spreads = report.methods.iter().filter(|method| {
        method.valid && [MINDEG, Reference::Delaunay.name()].contains(&&*method.name)
    });
    let spreads = spreads.filter_map(|method| method.metrics.as_ref().map(shown.of));
    let [low, high] = spreads.fold([f64::INFINITY, 0.0_f64], |[low, high], spread| {
        [low.min(spread.min), high.max(spread.max)]
    });
    // A single value still needs an axis, and so does no mesh at all.
    match (low < high, low > 0.0 && low.is_finite()) {
        (true, true) => [low, high],
        (false, true) => [low / 2.0, low * 2.0],
        (_, false) => [0.5, 1.0],
    }
}

fn beyond(report: &Report, shown: &ShownMetric, [low, high]: [f64; 2]) -> [bool; 2] {
    let spreads = report.methods.iter().filter_map(|method| method.metrics.as_ref().map(shown.of));
    spreads.fold([false; 2], |[below, above], spread| {
        [below || spread.min < low, above || spread.max > high]
    })
}

/// Where a value lies on an axis, 0 to 1.
fn position(value: f64, [low, high]: [f64; 2], scale: Scale) -> f64 {
    let share = match scale {
        Scale::Linear => (value - low) / (high - low),
        Scale::Logarithmic => libm::log(value / low) / libm::log(high / low),
    };
    share.clamp(0.0, 1.0)
}

fn packed<const N: usize>(numbers: impl Iterator<Item = [u8; N]>) -> String {
    STANDARD.encode(numbers.flatten().collect::<Vec<u8>>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_have_a_place_whatever_they_are() {
        for (value, scale, expected) in [
            (1.0, Scale::Linear, 0.0),
            (5.0, Scale::Linear, 4.0 / 15.0),
            (4.0, Scale::Logarithmic, 0.5),
            (16.0, Scale::Logarithmic, 1.0),
            (0.0, Scale::Logarithmic, 0.0),
            (f64::INFINITY, Scale::Logarithmic, 1.0),
            (f64::INFINITY, Scale::Linear, 1.0),
            (-3.0, Scale::Linear, 0.0),
        ] {
            assert_eq!(position(value, [1.0, 16.0], scale), expected, "{value}");
        }
    }
}
