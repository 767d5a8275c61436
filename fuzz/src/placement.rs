//! Domains of hostile numbers: refused, or points that are finite, in order, and where the corners are.

use crate::hostile::Hostile;
use arbitrary::Arbitrary;
use glam::DVec2;
use mindeg::{Arc, BoundaryMesh, Curve, Domain, Intervals, Outline, Rectangle, Side, Spacing};

#[derive(Arbitrary, Debug)]
enum Law {
    Uniform,
    Geometric(Hostile),
    Bump(Hostile),
    Beta(Hostile),
    First(Hostile),
    Last(Hostile),
    Parameters(Vec<Hostile>),
}

#[derive(Arbitrary, Debug)]
enum Bend {
    Line,
    Through([Hostile; 2]),
    Center([Hostile; 2], bool),
    Cubic([Hostile; 4]),
    Polyline(Vec<[Hostile; 2]>),
}

#[derive(Arbitrary, Debug)]
enum Division {
    Count(u8),
    Many(u32),
    Size(Hostile),
    Points,
}

#[derive(Arbitrary, Debug)]
pub(crate) struct Input {
    rectangle: Option<[Hostile; 5]>,
    corners: Vec<[Hostile; 2]>,
    sides: Vec<(Bend, Division, Law)>,
}

fn point([x, y]: &[Hostile; 2]) -> DVec2 {
    DVec2::new(x.0, y.0)
}

fn side((bend, division, law): &(Bend, Division, Law)) -> Side {
    let curve = match bend {
        Bend::Line => Curve::Line,
        Bend::Through(at) => Curve::Arc(Arc::Through(point(at))),
        Bend::Center(at, is_clockwise) => {
            Curve::Arc(Arc::Center { center: point(at), is_clockwise: *is_clockwise })
        }
        Bend::Cubic([a, b, c, d]) => Curve::Cubic([point(&[*a, *b]), point(&[*c, *d])]),
        Bend::Polyline(points) => Curve::Polyline(points.iter().take(20).map(point).collect()),
    };
    let intervals = match division {
        Division::Count(count) => Intervals::Count(u64::from(*count)),
        // Points of curved sides are stored: more of them take their time.
        Division::Many(count) if matches!(bend, Bend::Line) => Intervals::Count(u64::from(*count)),
        Division::Many(count) => Intervals::Count(u64::from(count % 5_000)),
        Division::Size(size) => Intervals::Size(size.0),
        Division::Points => Intervals::Points,
    };
    let spacing = match law {
        Law::Uniform => Spacing::Uniform,
        Law::Geometric(ratio) => Spacing::Geometric { ratio: ratio.0 },
        Law::Bump(ratio) => Spacing::Bump { ratio: ratio.0 },
        Law::Beta(beta) => Spacing::Beta { beta: beta.0 },
        Law::First(length) => Spacing::FirstLength(length.0),
        Law::Last(length) => Spacing::LastLength(length.0),
        Law::Parameters(all) => Spacing::Parameters(all.iter().map(|t| t.0).collect()),
    };
    Side { intervals, ..Side::count(1).along(curve).spaced(spacing) }
}

pub(crate) fn run(input: Input) {
    let sides: Vec<Side> = input.sides.iter().take(8).map(side).collect();
    let outline = match input.rectangle {
        Some([width, height, x, y, rotation]) => Outline::Rectangle(Rectangle {
            rotation: rotation.0,
            origin: DVec2::new(x.0, y.0),
            ..Rectangle::new(width.0, height.0)
        }),
        None => Outline::Polygon(input.corners.iter().take(8).map(point).collect()),
    };
    // Points of curved sides are stored, 16 bytes each: so many stay far below what a target may take.
    let is_straight = sides.iter().all(|side| side.curve == Curve::Line);
    let max_vertices = if is_straight { u32::MAX } else { 1 << 20 };
    let domain = match Domain::builder(outline, sides).max_vertices(max_vertices).build() {
        Ok(domain) => domain,
        Err(error) => return assert!(!error.to_string().is_empty()),
    };
    let (rings, placement) = (domain.rings(), domain.placement());
    let n = rings.vertex_count();
    let bounds = placement.bounds();
    assert!(bounds.min.is_finite() && bounds.max.is_finite());
    // The sum is rounded, and rounding alone can open a ring by a hair.
    let extent = (bounds.max - bounds.min).max_element();
    let rounding = f64::from(n) * f64::EPSILON * extent * extent;
    assert!(placement.area() > -rounding, "{}", placement.area());
    for (side, corner) in placement.corners().iter().enumerate() {
        assert_eq!(placement.point(rings.corner(side)), *corner);
        assert!(placement.side_length(side) > 0.0);
    }
    for vertex in [0, n / 3, n / 2, n - 1] {
        assert!(placement.point(vertex).is_finite());
    }
    if n > 2_000 {
        return;
    }
    let points: Vec<DVec2> = placement.points().collect();
    let mut walk = placement.walk();
    for (vertex, at) in (0..).zip(&points) {
        assert_eq!(placement.point(vertex), *at);
        assert_eq!(walk.point(vertex), *at);
        assert_ne!(placement.point(rings.next(vertex)), *at, "vertex {vertex} and the next");
    }
    let mut filled = vec![DVec2::ZERO; (n / 2) as usize];
    placement.fill_points(n / 3, &mut filled[..(n / 2).min(n - n / 3) as usize]);
    for (place, at) in (n / 3..n.min(n / 3 + n / 2)).zip(&filled) {
        assert_eq!(points[place as usize], *at);
    }
    if domain.convex().is_some() {
        let _ = BoundaryMesh::least_degree(&domain);
    }
}
