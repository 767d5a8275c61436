//! The data of the pictures and charts of an HTML page, packed small.
//!
//! Arrays go as base64 of little-endian numbers. Coordinates are relative to the center of what is
//! drawn, so that they are exact as far from the origin as they are near it. Measures go as
//! f32: they choose a color and are read off to four digits.

use super::scene::{MAX_DRAWN, Scene, Shown, max_degree_vertex};
use super::svg::{self, DegreeColor};
use super::tables;
use super::titles;
use crate::axis::{Axis, BARS};
use crate::figures::MethodFigures;
use crate::{Comparison, Method, measure};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use glam::{DVec2, DVec3};
use mindeg::quality::Distribution;
use mindeg_answers::measures::{MeasureFacts, SHOWN, ShownMetric};
use serde::Serialize;
use std::ops::RangeInclusive;

/// The most triangles of a mesh whose measures go into a page as numbers; of larger ones, their colors do.
const MAX_MEASURED: usize = 100_000;

/// The number of colors of a measure, as in the script of the viewer.
const STEPS: usize = 16;

/// Everything the script of the page reads.
#[derive(Serialize)]
pub(crate) struct Picture {
    /// Width and height of what is drawn.
    size: [f64; 2],
    /// x and y along each outline, f64.
    outlines: Vec<String>,
    fills_outlines: bool,
    is_ring: bool,
    /// x and y of each shown vertex, f64; empty for a mesh in space.
    points: String,
    /// x, y and z of each shown vertex of a mesh in space, f32.
    positions: Option<String>,
    /// The indices of the shown vertices, u32; empty where all are shown.
    vertices: String,
    at_least: Option<u32>,
    /// The colors of degrees, from the lowest degree.
    degree_colors: Vec<DegreeColor>,
    /// The positions on the axis of the degree chart: a name, the lowest and the highest degree.
    degrees: Vec<(String, u32, u32)>,
    metrics: Vec<Measure>,
    methods: Vec<Drawing>,
}

/// One measure, and the axis on which all meshes show it.
#[derive(Serialize)]
struct Measure {
    #[serde(flatten)]
    facts: MeasureFacts,
    logarithmic: bool,
    range: [f64; 2],
    /// Whether there are values below and above the range.
    goes_beyond: [bool; 2],
}

/// One mesh.
#[derive(Serialize)]
struct Drawing {
    name: String,
    /// Three indices into the shown vertices for each drawn triangle, u32.
    triangles: String,
    /// The indices of the drawn triangles, u32; empty where all are drawn.
    numbers: String,
    /// The degree of each shown vertex, u32.
    degrees: String,
    /// For each measure, its value for each drawn triangle, f32; of a mesh with very many triangles, empty.
    values: Vec<String>,
    /// Instead: for each measure, the color of each drawn triangle, a byte.
    steps: Vec<String>,
    /// For each measure, the number of triangles in each bar of its chart.
    bars: Vec<Vec<u32>>,
    /// The number of vertices in each bar of the degree chart.
    degree_bars: Vec<u64>,
    /// How many of the shown vertices it has; those of points inside follow the others.
    vertices: usize,
    /// The index of the worst triangle among the drawn.
    worst: usize,
    /// The index of a vertex of the largest degree among the shown.
    max_degree_vertex: usize,
}

/// The data for the pictures of a comparison.
pub(crate) fn of_comparison(comparison: &Comparison) -> Picture {
    let report = comparison.report();
    let points = comparison.points(Method::Inside);
    let meshes: Vec<_> = titles::named(report)
        .into_iter()
        .map(|named| {
            let triangles = comparison.triangles(named.place);
            (named, triangles)
        })
        .collect();
    let vertex_count = points.len() as u32;
    picture(&Scene {
        outlines: comparison.outlines().to_vec(),
        fills_outlines: report.domain.regions.is_none(),
        is_ring: report.domain.holes == 0 && report.domain.regions.is_none(),
        points,
        positions: None,
        vertices: (0..vertex_count).collect(),
        at_least: Some(report.domain.at_least),
        most_drawn: MAX_DRAWN,
        degrees: meshes
            .iter()
            .map(|(named, triangles)| {
                let vertices = comparison.points(named.figures.method).len();
                measure::degrees_of(comparison.boundary(), vertices, triangles)
            })
            .collect(),
        meshes,
        quality: &|triangle| measure::quality(points, triangle),
    })
}

/// The data for the pictures of some meshes.
pub(crate) fn picture(scene: &Scene) -> Picture {
    let (low, high) = scene
        .outlines
        .iter()
        .flatten()
        .copied()
        .chain(scene.vertices.iter().map(|&vertex| scene.points[vertex as usize]))
        .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), c| (low.min(c), high.max(c)));
    let center = low + (high - low) / 2.0;
    let coordinates = |point: DVec2| (point - center).to_array().map(f64::to_le_bytes);

    let shown = Shown::new(scene);
    let placed = |vertex: u32| scene.points[vertex as usize];
    let ranges = tables::degree_ranges(scene.meshes.iter().map(|(named, _)| named));
    let metrics: Vec<Measure> = SHOWN.iter().map(|metric| measure(scene, metric)).collect();
    let outline = |line: &Vec<DVec2>| packed(line.iter().copied().flat_map(coordinates));
    Picture {
        size: (high - low).to_array(),
        outlines: scene.outlines.iter().map(outline).collect(),
        fills_outlines: scene.fills_outlines,
        is_ring: scene.is_ring,
        points: match scene.positions {
            Some(_) => String::new(),
            None => packed(shown.vertices.iter().flat_map(|&vertex| coordinates(placed(vertex)))),
        },
        positions: scene.positions.map(|positions| in_space(positions, &shown.vertices)),
        vertices: if shown.vertices.len() == scene.points.len() {
            String::new()
        } else {
            packed(shown.vertices.iter().map(|vertex| vertex.to_le_bytes()))
        },
        at_least: scene.at_least,
        degree_colors: svg::degree_scale(),
        degrees: ranges
            .iter()
            .map(|range| (tables::degree_name(range), *range.start(), *range.end()))
            .collect(),
        methods: (0..scene.meshes.len())
            .map(|place| drawing(scene, place, &shown, &metrics, &ranges))
            .collect(),
        metrics,
    }
}

/// Positions from the middle of their box.
fn in_space(positions: &[DVec3], vertices: &[u32]) -> String {
    let at = |&vertex: &u32| positions[vertex as usize];
    let ends = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (low, high) =
        vertices.iter().map(at).fold(ends, |(low, high), p| (low.min(p), high.max(p)));
    // Half of each, since a difference of the two could overflow.
    let center = low / 2.0 + high / 2.0;
    let numbers = |vertex: &u32| (at(vertex) - center).to_array().map(|x| (x as f32).to_le_bytes());
    packed(vertices.iter().flat_map(numbers))
}

fn drawing(
    scene: &Scene,
    place: usize,
    shown: &Shown,
    metrics: &[Measure],
    degree_ranges: &[RangeInclusive<u32>],
) -> Drawing {
    let (mesh, triangles) = &scene.meshes[place];
    let (drawn, degrees) = (&shown.triangles[place], &scene.degrees[place]);
    let readers = SHOWN.map(|metric| metric.metric().of);
    let values = |number: usize| {
        let quality = (scene.quality)(triangles[number]);
        readers.map(|read| read(&quality))
    };

    let mut bars = vec![vec![0; BARS]; SHOWN.len()];
    for number in 0..triangles.len() {
        for ((bars, value), metric) in bars.iter_mut().zip(values(number)).zip(metrics) {
            bars[metric.axis().bar(value)] += 1;
        }
    }
    let is_measured = drawn.len() <= MAX_MEASURED;
    let mut columns = SHOWN.map(|_| Vec::new());
    let mut steps = SHOWN.map(|_| Vec::new());
    for &number in drawn {
        for (place, value) in values(number).into_iter().enumerate() {
            if is_measured {
                columns[place].push((value as f32).to_le_bytes());
            } else {
                steps[place].push([metrics[place].step(value)]);
            }
        }
    }
    let given =
        |columns: Vec<String>, are_given: bool| if are_given { columns } else { Vec::new() };
    let own = || shown.vertices.iter().take_while(|&&vertex| (vertex as usize) < degrees.len());
    let indices = drawn.iter().flat_map(|&number| triangles[number]);
    let worst = mesh.figures.worst_triangles.first().map_or(0, |worst| worst.triangle as usize);
    Drawing {
        name: mesh.name.clone(),
        triangles: packed(indices.map(|vertex| (shown.place_of(vertex) as u32).to_le_bytes())),
        numbers: if drawn.len() == triangles.len() {
            String::new()
        } else {
            packed(drawn.iter().map(|&number| (number as u32).to_le_bytes()))
        },
        degrees: packed(own().map(|&v| degrees[v as usize].to_le_bytes())),
        vertices: own().count(),
        values: given(columns.map(|column| packed(column.into_iter())).into(), is_measured),
        steps: given(steps.map(|column| packed(column.into_iter())).into(), !is_measured),
        bars,
        degree_bars: degree_ranges
            .iter()
            .map(|range| tables::vertices_in(mesh.figures, range))
            .collect(),
        worst: drawn.partition_point(|&number| number < worst),
        max_degree_vertex: shown.place_of(max_degree_vertex(degrees)),
    }
}

impl Measure {
    fn axis(&self) -> Axis {
        Axis { range: self.range, is_logarithmic: self.logarithmic }
    }

    /// The color of a value: 0 is good.
    fn step(&self, value: f64) -> u8 {
        let share = self.axis().share(value);
        let worse = if self.facts.higher_is_better { 1.0 - share } else { share };
        ((worse * STEPS as f64) as usize).min(STEPS - 1) as u8
    }
}

fn measure(scene: &Scene, shown: &ShownMetric) -> Measure {
    let range = axis(scene, shown);
    Measure {
        facts: shown.into(),
        logarithmic: shown.is_logarithmic,
        range,
        goes_beyond: beyond(scene, shown, range),
    }
}

/// The range of a measure in the meshes that matter most, mindeg's and Delaunay's: others would
/// flatten the differences between these two. Values beyond it go to its ends, as do the zeros and
/// infinities of flat triangles.
fn axis(scene: &Scene, shown: &ShownMetric) -> [f64; 2] {
    let matters = |figures: &MethodFigures| {
        figures.valid && [Method::LeastDegree, Method::DELAUNAY].contains(&figures.method)
    };
    let first = |values: [f64; 3]| values.into_iter().find(|&v| v > 0.0 && v.is_finite());
    let ends = spreads(scene, shown, matters).fold([f64::INFINITY, 0.0_f64], |[low, high], s| {
        let least = first([s.min, s.p01, s.median]).unwrap_or(f64::INFINITY);
        let greatest = first([s.max, s.p99, s.median]).unwrap_or(0.0);
        [low.min(least), high.max(greatest)]
    });
    let [low, high] = ends;
    // A single value still needs an axis, and so does no mesh at all.
    match (low < high, low > 0.0 && low.is_finite()) {
        (true, true) => [low, high],
        (false, true) => [low / 2.0, low * 2.0],
        (_, false) => [0.5, 1.0],
    }
}

fn beyond(scene: &Scene, shown: &ShownMetric, [low, high]: [f64; 2]) -> [bool; 2] {
    spreads(scene, shown, |_| true).fold([false; 2], |[below, above], spread| {
        [below || spread.min < low, above || spread.max > high]
    })
}

/// How a measure is spread in those of the meshes that are `wanted`.
fn spreads<'a>(
    scene: &'a Scene,
    shown: &ShownMetric,
    wanted: impl Fn(&MethodFigures) -> bool,
) -> impl Iterator<Item = &'a Distribution> {
    let figures = scene.meshes.iter().map(|(mesh, _)| mesh.figures);
    figures.filter(move |it| wanted(it)).filter_map(|figures| figures.spread(shown.name))
}

fn packed<const N: usize>(numbers: impl Iterator<Item = [u8; N]>) -> String {
    STANDARD.encode(numbers.flatten().collect::<Vec<u8>>())
}
