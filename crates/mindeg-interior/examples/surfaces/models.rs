//! Surfaces that need no files: closed and open, smooth and sharp, thin and pointed.

use glam::DVec3;
use std::f64::consts::TAU;

/// Points, triangles, and an edge length.
pub(crate) type Model = (Vec<DVec3>, Vec<[u32; 3]>, Option<f64>);

/// All of them with their names.
pub(crate) fn all() -> Vec<(String, Model)> {
    let bumps = |p: DVec3| {
        let r =
            1.0 + 0.15 * libm::sin(5.0 * p.x) * libm::sin(4.0 * p.y) * libm::sin(3.0 * p.z + 1.0);
        p * r
    };
    let spike = |p: DVec3| if p.z > 0.97 { p * (1.0 + 25.0 * (p.z - 0.97)) } else { p };
    let plate = |p: DVec3| DVec3::new(p.x, p.y, 0.04 * p.z);
    [
        ("sphere", mapped(sphere(24), |p| p, 0.15)),
        ("bumpy", mapped(sphere(40), bumps, 0.08)),
        ("spike", mapped(sphere(40), spike, 0.12)),
        ("torus", torus()),
        ("cube", mapped(cube(), |p| p, 0.12)),
        ("plate", mapped(cube(), plate, 0.1)),
        ("cylinder", cylinder()),
        ("cone", cone()),
        ("saddle", saddle()),
        ("lshape", lshape()),
    ]
    .map(|(name, model)| (name.to_owned(), model))
    .into()
}

fn mapped(
    (points, triangles): (Vec<DVec3>, Vec<[u32; 3]>),
    to: impl Fn(DVec3) -> DVec3,
    size: f64,
) -> Model {
    (points.into_iter().map(to).collect(), triangles, Some(size))
}

fn cube() -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let points =
        (0..8).map(|i| DVec3::new(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)));
    let quads =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    (points.collect(), quads.into_iter().flat_map(halves).collect())
}

fn halves([a, b, c, d]: [u32; 4]) -> [[u32; 3]; 2] {
    [[a, b, c], [a, c, d]]
}

/// Rows of points from pole to pole.
fn sphere(rows: u32) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let around = 2 * rows;
    let mut points = vec![DVec3::Z];
    for row in 1..rows {
        let (z, r) = (
            libm::cos(TAU / 2.0 * f64::from(row) / f64::from(rows)),
            libm::sin(TAU / 2.0 * f64::from(row) / f64::from(rows)),
        );
        points.extend((0..around).map(|i| on_circle(i, around) * r + DVec3::Z * z));
    }
    points.push(-DVec3::Z);
    let at = |row: u32, i: u32| 1 + (row - 1) * around + i % around;
    let last = points.len() as u32 - 1;
    let mut triangles = Vec::new();
    for i in 0..around {
        triangles.push([0, at(1, i), at(1, i + 1)]);
        triangles.push([last, at(rows - 1, i + 1), at(rows - 1, i)]);
        for row in 1..rows - 1 {
            triangles.extend(halves([
                at(row, i),
                at(row + 1, i),
                at(row + 1, i + 1),
                at(row, i + 1),
            ]));
        }
    }
    (points, triangles)
}

fn on_circle(i: u32, of: u32) -> DVec3 {
    let angle = TAU * f64::from(i) / f64::from(of);
    DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
}

fn torus() -> Model {
    let (m, n) = (48, 24);
    let point = |i: u32, j: u32| {
        let (out, tube) = (on_circle(i, m), on_circle(j, n));
        out * (1.0 + 0.35 * tube.x) + DVec3::Z * 0.35 * tube.y
    };
    let points = (0..m * n).map(|v| point(v / n, v % n)).collect();
    let at = |i: u32, j: u32| i % m * n + j % n;
    let cells = (0..m * n).map(|v| (v / n, v % n));
    let triangles =
        cells.flat_map(|(i, j)| halves([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]));
    (points, triangles.collect(), Some(0.12))
}

/// A surface of revolution: rings of radius and height between two poles.
fn turned(rings: &[[f64; 2]], around: u32, ends: [f64; 2], size: f64) -> Model {
    let mut points = vec![DVec3::Z * ends[0]];
    for [r, z] in rings {
        points.extend((0..around).map(|i| on_circle(i, around) * *r + DVec3::Z * *z));
    }
    points.push(DVec3::Z * ends[1]);
    let last = points.len() as u32 - 1;
    let at = |ring: u32, i: u32| 1 + ring * around + i % around;
    let top = rings.len() as u32 - 1;
    let mut triangles = Vec::new();
    for i in 0..around {
        triangles.push([0, at(0, i + 1), at(0, i)]);
        triangles.push([last, at(top, i), at(top, i + 1)]);
        for ring in 0..top {
            triangles.extend(halves([
                at(ring, i),
                at(ring, i + 1),
                at(ring + 1, i + 1),
                at(ring + 1, i),
            ]));
        }
    }
    (points, triangles, Some(size))
}

fn cylinder() -> Model {
    turned(&[[1.0, 0.0], [1.0, 2.0]], 48, [0.0, 2.0], 0.2)
}

fn cone() -> Model {
    turned(&[[1.0, 0.0]], 48, [0.0, 1.2], 0.15)
}

/// An open surface with four corners.
fn saddle() -> Model {
    let n = 30;
    let x = |i: u32| 2.0 * f64::from(i) / f64::from(n) - 1.0;
    let point = |v: u32| {
        let (x, y) = (x(v % (n + 1)), x(v / (n + 1)));
        DVec3::new(x, y, 0.5 * (x * x - y * y))
    };
    let points = (0..(n + 1) * (n + 1)).map(point).collect();
    let corner = (0..n * n).map(|c| c / n * (n + 1) + c % n);
    let triangles = corner.flat_map(|v| halves([v, v + 1, v + n + 2, v + n + 1])).collect();
    (points, triangles, Some(0.1))
}

/// A block with a notch: a reflex edge.
fn lshape() -> Model {
    let outline = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
    let level = |z: f64| outline.map(|[x, y]| DVec3::new(x, y, z));
    let points: Vec<DVec3> = [level(0.0), level(1.0)].concat();
    let caps = [[0, 1, 3], [1, 2, 3], [0, 3, 5], [3, 4, 5]];
    let mut triangles: Vec<[u32; 3]> = caps.map(|[a, b, c]| [a, c, b]).into();
    triangles.extend(caps.map(|t| t.map(|v| v + 6)));
    for i in 0..6 {
        let next = (i + 1) % 6;
        triangles.extend(halves([i, next, next + 6, i + 6]));
    }
    (points, triangles, Some(0.2))
}
