//! The data of the pictures and charts of an HTML page, packed small.
//!
//! Arrays go as base64 of little-endian numbers. Coordinates are relative to the center of what is
//! drawn, so that they are exact as far from the origin as they are near it. Measures go as
//! f32: they choose a color and are read off to four digits.
//!
//! Limits: of a mesh with more triangles than [`Scene::most_drawn`] at most so many go into the
//! picture. Charts and tables always count all.

use super::svg::{self, DegreeColor};
use super::tables::{self, Named};
use crate::axis::{Axis, BARS};
use crate::figures::MethodFigures;
use crate::{Comparison, Method, measure};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use glam::DVec2;
use mindeg::quality::Distribution;
use mindeg::quality::TriangleQuality;
use mindeg_answers::measures::{MeasureFacts, SHOWN, ShownMetric};
use mindeg_answers::numbers::count;
use serde::Serialize;
use std::ops::RangeInclusive;

/// The most triangles of one mesh in a page with several.
pub(crate) const MAX_DRAWN: usize = 20_000;

/// Meshes that share their points, as they are to be drawn.
pub(crate) struct Scene<'a> {
    /// Lines around what is drawn; a closed one ends where it starts.
    pub(crate) outlines: Vec<Vec<DVec2>>,
    /// Whether what is within the outlines is all surface, so that it can be filled at once.
    pub(crate) fills_outlines: bool,
    /// Whether the vertices are those of one boundary, in order.
    pub(crate) is_ring: bool,
    pub(crate) points: &'a [DVec2],
    /// The indices of the vertices that belong to the meshes, ascending.
    pub(crate) vertices: Vec<u32>,
    /// The least maximum degree of any mesh of these vertices, if it is known.
    pub(crate) at_least: Option<u32>,
    /// The most triangles of a mesh in the picture.
    pub(crate) most_drawn: usize,
    /// Each mesh with its triangles.
    pub(crate) meshes: Vec<(Named<'a>, &'a [[u32; 3]])>,
    /// The degrees of all points in each mesh.
    pub(crate) degrees: Vec<Vec<u32>>,
    /// The measures of a triangle.
    pub(crate) quality: &'a dyn Fn([u32; 3]) -> TriangleQuality,
}

/// Everything the script of the page reads.
#[derive(Serialize)]
pub(crate) struct Picture {
    /// Width and height of what is drawn.
    size: [f64; 2],
    /// x and y along each outline, f64.
    outlines: Vec<String>,
    fills_outlines: bool,
    is_ring: bool,
    /// x and y of each shown vertex, f64.
    points: String,
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
    /// For each measure, its value for each drawn triangle, f32.
    values: Vec<String>,
    /// For each measure, the number of triangles in each bar of its chart.
    bars: Vec<Vec<u32>>,
    /// The number of vertices in each bar of the degree chart.
    degree_bars: Vec<u64>,
    /// The index of the worst triangle among the drawn.
    worst: usize,
    /// The index of a vertex of the largest degree among the shown.
    max_degree_vertex: usize,
}

/// The data for the pictures of a comparison.
pub(crate) fn of_comparison(comparison: &Comparison) -> Picture {
    let report = comparison.report();
    let points = comparison.points();
    let meshes: Vec<_> = tables::named(report)
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
        vertices: (0..vertex_count).collect(),
        at_least: Some(report.domain.at_least),
        most_drawn: MAX_DRAWN,
        degrees: meshes
            .iter()
            .map(|(_, triangles)| measure::degrees(comparison.boundary(), triangles))
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
        points: packed(shown.vertices.iter().flat_map(|&vertex| coordinates(placed(vertex)))),
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

/// The note on a mesh with more than `most_drawn` triangles, the most that a page draws.
pub(crate) fn thinned(triangles: usize, most_drawn: usize) -> Option<String> {
    (triangles > most_drawn).then(|| {
        format!(
            "Thinned out: {} of {} triangles are drawn, the largest and others evenly. Figures \
             and charts count all.",
            count(most_drawn as u64),
            count(triangles as u64)
        )
    })
}

/// The elements of the meshes that the pictures show.
struct Shown {
    /// The indices of each mesh's triangles, ascending.
    triangles: Vec<Vec<usize>>,
    /// All vertices, or those of the triangles of all meshes and those of maximum degree, ascending.
    vertices: Vec<u32>,
}

impl Shown {
    fn new(scene: &Scene) -> Self {
        let triangles: Vec<Vec<usize>> =
            scene.meshes.iter().map(|(mesh, all)| drawn_triangles(scene, mesh, all)).collect();
        let drawn = || scene.meshes.iter().map(|&(_, all)| all).zip(&triangles);
        let vertices = if drawn().any(|(all, some)| some.len() < all.len()) {
            let drawn = drawn().flat_map(|(all, some)| some.iter().flat_map(|&n| all[n]));
            let max_degree_vertex = scene.degrees.iter().map(|degrees| max_degree_vertex(degrees));
            let mut vertices: Vec<u32> = drawn.chain(max_degree_vertex).collect();
            vertices.sort_unstable();
            vertices.dedup();
            vertices
        } else {
            scene.vertices.clone()
        };
        Self { triangles, vertices }
    }

    /// The index of a shown vertex.
    fn place_of(&self, vertex: u32) -> usize {
        self.vertices.partition_point(|&other| other < vertex)
    }
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
            let axis = Axis { range: metric.range, is_logarithmic: metric.logarithmic };
            bars[axis.bar(value)] += 1;
        }
    }
    let mut columns = SHOWN.map(|_| Vec::with_capacity(drawn.len()));
    for &number in drawn {
        for (column, value) in columns.iter_mut().zip(values(number)) {
            column.push((value as f32).to_le_bytes());
        }
    }
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
        degrees: packed(shown.vertices.iter().map(|&v| degrees[v as usize].to_le_bytes())),
        values: columns.into_iter().map(|column| packed(column.into_iter())).collect(),
        bars,
        degree_bars: degree_ranges
            .iter()
            .map(|range| tables::vertices_in(mesh.figures, range))
            .collect(),
        worst: drawn.partition_point(|&number| number < worst),
        max_degree_vertex: shown.place_of(max_degree_vertex(degrees)),
    }
}

/// The indices of the triangles that are drawn, ascending: all, or the largest, which make up
/// most of the picture, the worst, and others evenly by number.
fn drawn_triangles(scene: &Scene, mesh: &Named, triangles: &[[u32; 3]]) -> Vec<usize> {
    let (count, most) = (triangles.len(), scene.most_drawn);
    if count <= most {
        return (0..count).collect();
    }
    let area = |&triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|vertex| scene.points[vertex as usize]);
        (b - a).perp_dot(c - a).abs()
    };
    let areas: Vec<f64> = triangles.iter().map(area).collect();
    let mut drawn: Vec<usize> = (0..count).collect();
    drawn.select_nth_unstable_by(most / 4, |&a, &b| areas[b].total_cmp(&areas[a]).then(a.cmp(&b)));
    drawn.truncate(most / 4);
    drawn.extend(mesh.figures.worst_triangles.iter().map(|worst| worst.triangle as usize));
    let others = most - drawn.len();
    drawn.extend((0..others).map(|i| (i as u64 * count as u64 / others as u64) as usize));
    drawn.sort_unstable();
    drawn.dedup();
    drawn
}

/// The first vertex of the largest degree.
fn max_degree_vertex(degrees: &[u32]) -> u32 {
    let last_of_max = (0..degrees.len()).rev().max_by_key(|&vertex| degrees[vertex]);
    last_of_max.unwrap_or(0) as u32
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
/// flatten the differences between these two. What is beyond goes to the ends, as do the zeros and
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
