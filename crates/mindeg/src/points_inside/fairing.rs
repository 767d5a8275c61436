//! The surface that bends least: points inside a filling move to where its thin-plate energy is least.
//!
//! The energy is the sum of |L x|² / A over the vertices inside and on the rim, with the cotangent Laplacian L and a third A of the
//! area around each. The rim and all beyond stay; as far as the rim's rows count, the filling continues the tangents of the mesh.

use std::collections::BTreeSet;

use glam::DVec3;
use mindeg_mesh::{Cancelled, Progress};

/// Triangles, of which a filling is the part with points that move.
pub(super) struct Patch<'a> {
    pub(super) triangles: &'a [[u32; 3]],
    /// Points from here on move.
    pub(super) fixed: usize,
    pub(super) rim: &'a BTreeSet<u32>,
    /// How much the rows of the rim count.
    pub(super) at_rim: f64,
}

/// The greatest cotangent that counts: thin triangles have others.
const MOST: f64 = 10.0;
/// The residual at which a solution is good enough, as a share of the first.
const ENOUGH: f64 = 1e-9;
/// So many steps are made at most, and so many for each point that moves: more do not help where rounding keeps the residual up.
const STEPS: usize = 20_000;
const STEPS_EACH: usize = 4;
/// Progress is reported every so many steps.
const REPORTED: usize = 256;

/// The points, moved. Where nothing moves, the points as they are.
pub(super) fn faired(
    points: Vec<DVec3>,
    patch: &Patch<'_>,
    progress: Progress<'_>,
) -> Result<Vec<DVec3>, Cancelled> {
    if points.len() == patch.fixed {
        return Ok(points);
    }
    let rows = rows(&points, patch);
    let mut x = points;
    // Conjugate gradients on the gradient of half the energy, scaled by its diagonal.
    let scale = diagonal(&rows, x.len(), patch.fixed);
    let mut residual: Vec<DVec3> =
        gradient(&rows, &x, patch.fixed).into_iter().map(|g| -g).collect();
    let scaled = |residual: &[DVec3]| -> Vec<DVec3> {
        residual.iter().zip(&scale).map(|(r, s)| *r / *s).collect()
    };
    let mut preconditioned = scaled(&residual);
    let mut direction = preconditioned.clone();
    let mut size = product(&residual, &preconditioned);
    let enough = ENOUGH * ENOUGH * size;
    for step in 0..STEPS.min(100 + STEPS_EACH * direction.len()) {
        if size <= enough || size == 0.0 {
            break;
        }
        if step % REPORTED == 0 {
            progress.report("fairing", 0, 1)?;
        }
        let mut moved = vec![DVec3::ZERO; x.len()];
        moved[patch.fixed..].copy_from_slice(&direction);
        let image = gradient(&rows, &moved, patch.fixed);
        let bent = product(&direction, &image);
        if bent <= 0.0 {
            break;
        }
        let length = size / bent;
        for (i, by) in direction.iter().enumerate() {
            x[patch.fixed + i] += length * *by;
            residual[i] -= length * image[i];
        }
        preconditioned = scaled(&residual);
        let next = product(&residual, &preconditioned);
        let kept = next / size;
        for (by, new) in direction.iter_mut().zip(&preconditioned) {
            *by = *new + kept * *by;
        }
        size = next;
    }
    Ok(x)
}

/// A row of the Laplacian, divided by the root of its area: weights of vertices.
type Row = Vec<(u32, f64)>;

/// The rows of the vertices inside and on the rim that no boundary passes.
fn rows(points: &[DVec3], patch: &Patch<'_>) -> Vec<Row> {
    let at = |v: u32| points[v as usize];
    let mut areas = vec![0.0; points.len()];
    let mut halves: Vec<([u32; 2], f64)> = Vec::new();
    for &[a, b, c] in patch.triangles {
        let doubled = (at(b) - at(a)).cross(at(c) - at(a)).length();
        for [x, from, to] in [[a, b, c], [b, c, a], [c, a, b]] {
            areas[x as usize] += doubled / 6.0;
            let dot = (at(from) - at(x)).dot(at(to) - at(x));
            let cotangent = if doubled > 0.0 { (dot / doubled).clamp(-MOST, MOST) } else { 0.0 };
            halves.extend([([from, to], 0.5 * cotangent), ([to, from], 0.5 * cotangent)]);
        }
    }
    halves.sort_by_key(|(edge, _)| *edge);
    let mut rows = Vec::new();
    for of_vertex in halves.chunk_by(|a, b| a.0[0] == b.0[0]) {
        let vertex = of_vertex[0].0[0];
        let is_wanted = vertex as usize >= patch.fixed || patch.rim.contains(&vertex);
        let edges: Vec<&[([u32; 2], f64)]> = of_vertex.chunk_by(|a, b| a.0 == b.0).collect();
        // An edge of one triangle is on a boundary.
        let is_wanted = is_wanted && (patch.at_rim > 0.0 || vertex as usize >= patch.fixed);
        if !is_wanted || edges.iter().any(|edge| edge.len() != 2) {
            continue;
        }
        let counts = if (vertex as usize) < patch.fixed { patch.at_rim } else { 1.0 };
        let root = (areas[vertex as usize].max(f64::MIN_POSITIVE) / counts).sqrt();
        let weights =
            edges.iter().map(|e| (e[0].0[1], e.iter().map(|(_, w)| w).sum::<f64>() / root));
        let mut row: Row = weights.collect();
        let all: f64 = row.iter().map(|(_, weight)| weight).sum();
        row.push((vertex, -all));
        rows.push(row);
    }
    rows
}

/// The gradient of half the energy, for the points that move.
fn gradient(rows: &[Row], x: &[DVec3], fixed: usize) -> Vec<DVec3> {
    let mut gradient = vec![DVec3::ZERO; x.len() - fixed];
    for row in rows {
        let bent: DVec3 = row.iter().map(|(v, weight)| *weight * x[*v as usize]).sum();
        for (v, weight) in row.iter().filter(|(v, _)| *v as usize >= fixed) {
            gradient[*v as usize - fixed] += *weight * bent;
        }
    }
    gradient
}

fn diagonal(rows: &[Row], count: usize, fixed: usize) -> Vec<f64> {
    let mut diagonal = vec![0.0; count - fixed];
    for (v, weight) in rows.iter().flatten().filter(|(v, _)| *v as usize >= fixed) {
        diagonal[*v as usize - fixed] += weight * weight;
    }
    diagonal.into_iter().map(|square: f64| square.max(f64::MIN_POSITIVE)).collect()
}

fn product(a: &[DVec3], b: &[DVec3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(*b)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A disc of rings of six times as many points as their index, on a height over the plane.
    fn disc(rings: u32, height: impl Fn(f64) -> f64) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let first = |ring: u32| 3 * ring * ring.saturating_sub(1) + ring.min(1);
        let at = |ring: u32, i: u32| first(ring) + if ring == 0 { 0 } else { i % (6 * ring) };
        let (mut points, mut triangles) = (vec![DVec3::Z * height(0.0)], Vec::new());
        for ring in 1..=rings {
            let radius = f64::from(ring) / f64::from(rings);
            for i in 0..6 * ring {
                let turn = std::f64::consts::TAU * f64::from(i) / f64::from(6 * ring);
                let (x, y) = (radius * libm::cos(turn), radius * libm::sin(turn));
                points.push(DVec3::new(x, y, height(radius)));
            }
            for sector in 0..6 {
                let (inner, outer) = (sector * (ring - 1), sector * ring);
                for i in 0..ring {
                    let next = at(ring, outer + i + 1);
                    triangles.push([at(ring - 1, inner + i), at(ring, outer + i), next]);
                    if i + 1 < ring {
                        let [a, b] = [i, i + 1].map(|i| at(ring - 1, inner + i));
                        triangles.push([a, next, b]);
                    }
                }
            }
        }
        (points, triangles)
    }

    /// The points inside, first moved by some noise, then faired; those outside the fifth ring of eight stay.
    fn refaired(height: impl Fn(f64) -> f64) -> (Vec<DVec3>, Vec<DVec3>) {
        let (points, triangles) = disc(8, height);
        // The points that stay come first.
        let (inner, count) = (61, points.len());
        let place = |v: u32| (v + (count as u32 - inner)) % count as u32;
        let triangles: Vec<[u32; 3]> = triangles.iter().map(|t| t.map(place)).collect();
        let fixed = count - inner as usize;
        let mut wanted = points[inner as usize..].to_vec();
        wanted.extend(&points[..inner as usize]);
        let mut moved = wanted.clone();
        for (i, point) in moved.iter_mut().enumerate().skip(fixed) {
            point.z += 0.01 * libm::sin(7.0 * i as f64);
        }
        let rim: BTreeSet<u32> = (0..30).collect();
        let patch = Patch { triangles: &triangles, fixed, rim: &rim, at_rim: 1.0 };
        (wanted, faired(moved, &patch, Progress::NONE).unwrap())
    }

    #[test]
    fn a_plane_is_plane_again() {
        let (wanted, found) = refaired(|_| 0.0);
        for (a, b) in wanted.iter().zip(&found) {
            assert!((b.z - a.z).abs() < 1e-6, "{a} {b}");
        }
        assert_eq!(wanted[..found.len() - 61], found[..found.len() - 61]);
    }

    /// Also in the middle, which the rim's height alone does not give: its tangents do.
    #[test]
    fn a_bowl_goes_on_across_its_hole() {
        let (wanted, found) = refaired(|radius| 0.5 * radius * radius);
        let deepest = found[found.len() - 61].z;
        assert!(deepest < 0.04, "{deepest}, where the rim is at 0.195");
        for (a, b) in wanted.iter().zip(&found) {
            assert!(a.distance(*b) < 0.04, "{a} {b}");
        }
    }
}
