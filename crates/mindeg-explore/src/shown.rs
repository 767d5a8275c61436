//! Domains and meshes as the page draws them.

use mindeg::glam::DVec2;
use mindeg::quality::{Distribution, METRICS, Metric, TriangleQuality};
use mindeg::{BoundaryMesh, Domain};

use crate::api::{Bars, DomainShown, Request, Shown, SideShown, View};
use crate::arrays::{f32s, f64s, u32s};

/// The number of bars of a histogram.
const BARS: usize = 30;

/// The middle and the extent of a boundary.
#[derive(Clone, Copy)]
struct Frame {
    center: DVec2,
    size: DVec2,
}

impl Frame {
    fn of(domain: &Domain) -> Self {
        let ends = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let points = domain.placement().points();
        let (low, high) = points.fold(ends, |(low, high), p| (low.min(p), high.max(p)));
        Self { center: low + (high - low) / 2.0, size: high - low }
    }
}

pub(crate) fn domain(domain: &Domain) -> DomainShown {
    let rings = domain.rings();
    let Frame { center, size } = Frame::of(domain);
    let side = |side| SideShown {
        name: domain.side_name(side),
        ring: rings.ring_of_side(side),
        start: rings.corner(side),
        intervals: rings.intervals(side),
        is_straight: domain.is_straight(side),
    };
    DomainShown {
        name: domain.name().map(str::to_owned),
        vertices: rings.vertex_count(),
        triangles: rings.vertex_count() + 2 * rings.ring_count() as u32 - 4,
        is_convex: domain.convex().is_some(),
        center: center.to_array(),
        size: size.to_array(),
        points: f64s(domain.placement().points().map(|point| point - center)),
        rings: rings.rings().map(|ring| ring.start).chain([rings.vertex_count()]).collect(),
        sides: (0..rings.side_count()).map(side).collect(),
        notes: domain.notes(),
    }
}

/// A mesh with its figures.
pub(crate) struct Figure {
    frame: Frame,
    triangles: Vec<[u32; 3]>,
    degrees: Vec<u32>,
    qualities: Vec<TriangleQuality>,
}

impl Figure {
    pub(crate) fn of(mesh: &BoundaryMesh) -> Self {
        let degrees = (0..mesh.vertex_count()).map(|vertex| mesh.total_degree(vertex)).collect();
        Self {
            frame: Frame::of(mesh.domain()),
            triangles: mesh.triangles().collect(),
            degrees,
            qualities: mesh.qualities().collect(),
        }
    }

    pub(crate) fn shown(&self, view: View, is_last: bool, request: &Request) -> Shown {
        let measure = METRICS.iter().find(|metric| Some(metric.name) == request.color.as_deref());
        let max_degree = self.degrees.iter().copied().max().unwrap_or(0);
        let worst = (0..self.qualities.len())
            .min_by(|&a, &b| self.qualities[a].min_angle.total_cmp(&self.qualities[b].min_angle));
        let worst = worst.unwrap_or(0);
        let min_angle = self.qualities.iter().map(|q| q.min_angle).fold(180.0, f64::min);
        let max_angle = self.qualities.iter().map(|q| q.max_angle).fold(0.0, f64::max);
        let values = |metric: &Metric| f32s(self.qualities.iter().map(metric.of));
        let mut degree_bars: Vec<[u64; 2]> = Vec::new();
        for degree in 0..=max_degree {
            let vertices = self.degrees.iter().filter(|&&other| other == degree).count();
            if vertices > 0 {
                degree_bars.push([degree.into(), vertices as u64]);
            }
        }
        Shown {
            view,
            is_last,
            words: format!("maximum degree {max_degree}, minimum angle {min_angle:.3}°"),
            interior_points: String::new(),
            triangles: u32s(self.triangles.iter().flatten().copied()),
            degrees: u32s(self.degrees.iter().copied()),
            values: measure.map_or_else(String::new, values),
            max_degree,
            at_least: None,
            min_angle,
            max_angle,
            share_of_delaunay: None,
            degree_bars,
            bars: measure.and_then(|measure| self.bars(measure)),
            worst_triangle: worst as u32,
            max_degree_vertex: self.degrees.iter().position(|&d| d == max_degree).unwrap_or(0)
                as u32,
        }
    }

    fn bars(&self, metric: &Metric) -> Option<Bars> {
        let values: Vec<f64> = self.qualities.iter().map(metric.of).collect();
        let (range, is_logarithmic) = axis(metric, self.frame.size);
        let mut counts = vec![0; BARS];
        for &value in &values {
            let bar = position(value, range, is_logarithmic) * BARS as f64;
            counts[(bar as usize).min(BARS - 1)] += 1;
        }
        let Distribution { min, median, mean, max, .. } = Distribution::of(values)?;
        let measure = metric.name.to_owned();
        Some(Bars { measure, range, is_logarithmic, counts, min, median, mean, max })
    }
}

/// The axis of a measure, and whether it is logarithmic.
fn axis(metric: &Metric, size: DVec2) -> ([f64; 2], bool) {
    match (metric.unit, metric.best) {
        ("degrees", Some(best)) => ([best.min(metric.worst), best.max(metric.worst)], false),
        (_, Some(best)) if metric.worst.is_finite() => ([metric.worst, best], false),
        (_, Some(best)) => ([best, 1e3 * best], true),
        ("length", None) => ([1e-4 * size.max_element(), size.max_element()], true),
        (_, None) => ([1e-8 * size.element_product(), size.element_product()], true),
    }
}

/// Where a value lies on an axis, 0 to 1.
fn position(value: f64, [low, high]: [f64; 2], is_logarithmic: bool) -> f64 {
    let share = if is_logarithmic {
        (value / low).ln() / (high / low).ln()
    } else {
        (value - low) / (high - low)
    };
    if share.is_nan() { 0.0 } else { share.clamp(0.0, 1.0) }
}
