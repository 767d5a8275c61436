//! What the pictures and charts of an HTML report are drawn from, packed small.
//!
//! Arrays go as base64 of little-endian numbers. Coordinates are relative to the center of the
//! domain, so that they are exact as far from the origin as they are near it. Measures go as
//! f32: they choose a color and are read off to four digits.
//!
//! Limits: of a method with more than [`MAX_DRAWN`] triangles at most so many go into the
//! picture. Charts and tables always count all.

use super::Report;
use super::metric::{SHOWN, ShownMetric};
use super::svg::{self, DegreeColor};
use super::tables::{self, Named};
use crate::figures::MethodFigures;
use crate::{Comparison, Method, measure};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use glam::DVec2;
use serde::Serialize;

/// The most triangles of one method in a picture.
pub(crate) const MAX_DRAWN: usize = 20_000;

/// The number of bars in the chart of a measure.
const BARS: usize = 30;

/// Everything the script of the page reads.
#[derive(Serialize)]
pub(crate) struct Picture {
    corners: Vec<[f64; 2]>,
    /// x and y of each shown vertex, f64.
    points: String,
    /// The numbers of the shown vertices, u32; empty where all are shown.
    vertices: String,
    optimal_max_degree: u32,
    /// The colors of degrees, from the lowest degree.
    degree_colors: Vec<DegreeColor>,
    /// The places on the axis of the degree chart: a name, the lowest and the highest degree.
    degrees: Vec<(String, u32, u32)>,
    metrics: Vec<Measure>,
    methods: Vec<Drawing>,
}

/// One measure, and the axis on which all methods show it.
#[derive(Serialize)]
struct Measure {
    name: &'static str,
    title: &'static str,
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
    /// Three indices into the shown vertices for each drawn triangle, u32.
    triangles: String,
    /// The numbers of the drawn triangles, u32; empty where all are drawn.
    numbers: String,
    /// The degree of each shown vertex, u32.
    degrees: String,
    /// For each measure, its value for each drawn triangle, f32.
    values: Vec<String>,
    /// For each measure, the number of triangles in each bar of its chart.
    bars: Vec<Vec<u32>>,
    /// The number of vertices in each bar of the degree chart.
    degree_bars: Vec<u64>,
    /// The index of the worst triangle among the drawn.
    worst: usize,
    /// The index of a vertex of the largest degree among the shown.
    busiest: usize,
}

/// What goes into the pictures of a comparison.
pub(crate) fn picture(comparison: &Comparison) -> Picture {
    let report = comparison.report();
    let corners = report.domain.corners.iter().copied().map(DVec2::from);
    let (low, high) = corners
        .clone()
        .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), c| (low.min(c), high.max(c)));
    let center = low + (high - low) / 2.0;

    let shown = Shown::new(comparison);
    let points = comparison.points();
    let placed = |vertex: u32| (points[vertex as usize] - center).to_array();
    let ranges = tables::degree_ranges(report);
    let metrics: Vec<Measure> = SHOWN.iter().map(|metric| measure(report, metric)).collect();
    Picture {
        corners: corners.map(|corner| (corner - center).to_array()).collect(),
        points: packed(shown.vertices.iter().flat_map(|&v| placed(v)).map(f64::to_le_bytes)),
        vertices: if shown.has_all_vertices(comparison) {
            String::new()
        } else {
            packed(shown.vertices.iter().map(|vertex| vertex.to_le_bytes()))
        },
        optimal_max_degree: report.domain.optimal_max_degree,
        degree_colors: svg::degree_scale(),
        degrees: ranges
            .iter()
            .map(|range| (tables::degree_name(range), *range.start(), *range.end()))
            .collect(),
        methods: tables::named(report)
            .iter()
            .map(|mesh| drawing(comparison, mesh, &shown, &metrics))
            .collect(),
        metrics,
    }
}

/// What of the meshes is in the pictures.
struct Shown {
    /// The numbers of each method's triangles, ascending.
    triangles: Vec<Vec<usize>>,
    /// The degrees of all vertices in each method.
    degrees: Vec<Vec<u32>>,
    /// All vertices, or those of the triangles of all methods and the busiest, ascending.
    vertices: Vec<u32>,
}

impl Shown {
    fn new(comparison: &Comparison) -> Self {
        let points = comparison.points();
        let count = points.len() as u32;
        let methods = || comparison.methods();
        let triangles: Vec<Vec<usize>> = methods()
            .map(|(method, triangles)| drawn_triangles(method, points, triangles))
            .collect();
        let degrees: Vec<Vec<u32>> =
            methods().map(|(_, triangles)| measure::degrees(count, triangles)).collect();
        let is_thinned = methods().zip(&triangles).any(|((_, all), some)| some.len() < all.len());
        let vertices = if is_thinned {
            let drawn = methods().zip(&triangles);
            let drawn = drawn.flat_map(|((_, all), some)| some.iter().flat_map(|&n| all[n]));
            let mut vertices: Vec<u32> = drawn.chain(degrees.iter().map(|d| busiest(d))).collect();
            vertices.sort_unstable();
            vertices.dedup();
            vertices
        } else {
            (0..count).collect()
        };
        Self { triangles, degrees, vertices }
    }

    fn has_all_vertices(&self, comparison: &Comparison) -> bool {
        self.vertices.len() == comparison.points().len()
    }

    /// The index of a shown vertex.
    fn place_of(&self, vertex: u32) -> usize {
        self.vertices.partition_point(|&other| other < vertex)
    }
}

fn drawing(comparison: &Comparison, mesh: &Named, shown: &Shown, metrics: &[Measure]) -> Drawing {
    let report = comparison.report();
    let (method, place) = (mesh.figures, mesh.place);
    let triangles = comparison.triangles(place);
    let (drawn, degrees) = (&shown.triangles[place], &shown.degrees[place]);
    let readers = SHOWN.map(|metric| metric.metric().of);
    let values = |number: usize| {
        let quality = measure::quality(comparison.points(), triangles[number]);
        readers.map(|read| read(&quality))
    };

    let mut bars = vec![vec![0; BARS]; SHOWN.len()];
    for number in 0..triangles.len() {
        for ((bars, value), metric) in bars.iter_mut().zip(values(number)).zip(metrics) {
            let bar = position(value, metric.range, metric.logarithmic) * BARS as f64;
            bars[(bar as usize).min(BARS - 1)] += 1;
        }
    }
    let mut columns = SHOWN.map(|_| Vec::with_capacity(drawn.len()));
    for &number in drawn {
        for (column, value) in columns.iter_mut().zip(values(number)) {
            column.push((value as f32).to_le_bytes());
        }
    }
    let indices = drawn.iter().flat_map(|&number| triangles[number]);
    let worst = method.worst_triangles.first().map_or(0, |worst| worst.triangle as usize);
    Drawing {
        name: mesh.name.clone(),
        triangles: packed(indices.map(|vertex| (shown.place_of(vertex) as u32).to_le_bytes())),
        numbers: if drawn.len() == triangles.len() {
            String::new()
        } else {
            packed(drawn.iter().map(|&number| (number as u32).to_le_bytes()))
        },
        degrees: packed(shown.vertices.iter().map(|&v| degrees[v as usize].to_le_bytes())),
        values: columns.into_iter().map(|column| packed(column.into_iter())).collect(),
        bars,
        degree_bars: tables::degree_ranges(report)
            .iter()
            .map(|range| tables::vertices_in(method, range))
            .collect(),
        worst: drawn.partition_point(|&number| number < worst),
        busiest: shown.place_of(busiest(degrees)),
    }
}

/// The numbers of the triangles that are drawn, ascending: all, or the largest, which make up
/// most of the picture, the worst, and others evenly by number.
fn drawn_triangles(method: &MethodFigures, points: &[DVec2], triangles: &[[u32; 3]]) -> Vec<usize> {
    let count = triangles.len();
    if count <= MAX_DRAWN {
        return (0..count).collect();
    }
    let area = |&triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|vertex| points[vertex as usize]);
        (b - a).perp_dot(c - a)
    };
    let areas: Vec<f64> = triangles.iter().map(area).collect();
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

/// The first vertex of the largest degree.
fn busiest(degrees: &[u32]) -> u32 {
    let last_of_max = (0..degrees.len()).rev().max_by_key(|&vertex| degrees[vertex]);
    last_of_max.unwrap_or(0) as u32
}

fn measure(report: &Report, shown: &ShownMetric) -> Measure {
    let range = axis(report, shown);
    Measure {
        name: shown.name,
        title: shown.title,
        unit: shown.metric().unit,
        explanation: shown.explanation(),
        higher_is_better: shown.higher_is_better(),
        logarithmic: shown.is_logarithmic,
        range,
        goes_beyond: beyond(report, shown, range),
    }
}

/// The range of a measure in the meshes that matter most, mindeg's and Delaunay's: others would
/// flatten the differences between these two. What is beyond goes to the ends.
fn axis(report: &Report, shown: &ShownMetric) -> [f64; 2] {
    let spreads = report.methods.iter().filter(|method| {
        method.valid && [Method::LeastDegree, Method::DELAUNAY].contains(&method.method)
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
fn position(value: f64, [low, high]: [f64; 2], is_logarithmic: bool) -> f64 {
    let share = if is_logarithmic {
        libm::log(value / low) / libm::log(high / low)
    } else {
        (value - low) / (high - low)
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
        for (value, is_logarithmic, expected) in [
            (1.0, false, 0.0),
            (5.0, false, 4.0 / 15.0),
            (4.0, true, 0.5),
            (16.0, true, 1.0),
            (0.0, true, 0.0),
            (f64::INFINITY, true, 1.0),
            (f64::INFINITY, false, 1.0),
            (-3.0, false, 0.0),
        ] {
            assert_eq!(position(value, [1.0, 16.0], is_logarithmic), expected, "{value}");
        }
    }
}
