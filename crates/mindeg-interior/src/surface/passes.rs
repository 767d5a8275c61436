//! Passes over a whole mesh: long edges are split, short ones collapse, degrees become even by flips, and vertices move to the
//! middle of their stars. After some of them edges have their lengths and nearly all degrees are 5 to 7.

use crate::array_mesh::Kind;
use crate::goal::Weights;
use crate::manifold::Manifold;
use crate::operations::{Cavity, Operation};
use crate::smooth::{Power, Sweeper};
use crate::stage::Stage;
use crate::surface::motion::neighbours_on_curve;
use crate::surface::reference::{On, OnSurface};
use crate::surface::work::{SurfaceMesh, compacted};
use crate::triangle::{doubled_area, has_sine, min_angle};
use glam::{DVec2, DVec3};
use mindeg_mesh::Cancelled;

/// How often all passes are made.
pub(crate) const PASSES: usize = 5;
/// An edge longer than this many sizes is split, one shorter than that collapses.
const LONG: f64 = 4.0 / 3.0;
const SHORT: f64 = 4.0 / 5.0;
/// No collapse makes an edge longer than this many sizes,
const TOO_LONG: f64 = 1.5;
/// nor an angle smaller than this, in degrees, unless it was smaller.
const TOO_SMALL: f64 = 8.0;
/// Flips make no smaller angle than this, in degrees.
const FLIPPED: f64 = 10.0;
/// How often edges are looked for in a pass.
const ROUNDS: usize = 5;

/// All passes, each of them so often as edges are left to work on.
pub(crate) fn passes<'a>(
    mut mesh: SurfaceMesh<'a>,
    weights: &Weights,
    stage: &mut Stage<'_>,
) -> Result<Result<SurfaceMesh<'a>, String>, Cancelled> {
    mesh = match compacted(&mesh) {
        Ok(mesh) => mesh,
        Err(error) => return Ok(Err(error)),
    };
    for pass in 0..PASSES {
        stage.reach(pass as f64 / PASSES as f64)?;
        split_long(&mut mesh);
        stage.still()?;
        collapse_short(&mut mesh);
        stage.still()?;
        flip(&mut mesh, weights);
        stage.still()?;
        for _ in 0..2 {
            center(&mut mesh);
            stage.still()?;
        }
        Sweeper::new().run(&mut mesh, Power::Two, 3, stage)?;
        resize(&mut mesh);
        match compacted(&mesh) {
            Ok(other) => mesh = other,
            Err(error) => return Ok(Err(error)),
        }
    }
    Ok(Ok(mesh))
}

/// An edge with the triangle on its left, and its length in sizes.
#[derive(Debug, Clone, Copy)]
struct Edge {
    ratio: f64,
    triangle: u32,
    corner: u8,
    ends: [u32; 2],
}

fn ratio(mesh: &SurfaceMesh<'_>, [a, b]: [u32; 2]) -> f64 {
    let [p, q] = [a, b].map(|v| &mesh.vertices[v as usize]);
    p.at.at.distance(q.at.at) / (0.5 * (p.size + q.size))
}

/// The edges for which a ratio counts, each once, by their ratios.
fn edges(mesh: &SurfaceMesh<'_>, counts: impl Fn(f64) -> bool) -> Vec<Edge> {
    let mut edges = Vec::new();
    for (triangle, t) in (0..).zip(&mesh.triangles).filter(|(_, t)| t.is_alive()) {
        for corner in 0..3 {
            // The boundary has no other triangle.
            if t.neighbours[corner] < triangle {
                continue;
            }
            let ends = [1, 2].map(|i| t.vertices[(corner + i) % 3]);
            let ratio = ratio(mesh, ends);
            if counts(ratio) {
                edges.push(Edge { ratio, triangle, corner: corner as u8, ends });
            }
        }
    }
    edges.sort_unstable_by(|a, b| {
        a.ratio.total_cmp(&b.ratio).then((a.triangle, a.corner).cmp(&(b.triangle, b.corner)))
    });
    edges
}

fn is_there(mesh: &SurfaceMesh<'_>, edge: &Edge) -> bool {
    // A changed triangle gets another index.
    mesh.triangles[edge.triangle as usize].is_alive()
}

fn split_long(mesh: &mut SurfaceMesh<'_>) {
    let mut cavity = Cavity::default();
    for _ in 0..ROUNDS {
        let mut done = 0;
        for edge in edges(mesh, |ratio| ratio > LONG).into_iter().rev() {
            let split = Operation::Split { triangle: edge.triangle, corner: edge.corner };
            mesh.record();
            if is_there(mesh, &edge) && cavity.open(mesh, split) && cavity.plan(mesh, split) {
                cavity.carry_out(mesh);
                done += 1;
            } else {
                mesh.undo(0);
            }
            mesh.commit();
        }
        if done == 0 {
            break;
        }
    }
}

fn collapse_short(mesh: &mut SurfaceMesh<'_>) {
    let mut cavity = Cavity::default();
    for _ in 0..ROUNDS {
        let mut done = 0;
        for edge in edges(mesh, |ratio| ratio < SHORT) {
            let [a, b] = edge.ends;
            for [from, to] in [[a, b], [b, a]] {
                if is_there(mesh, &edge) && collapse(mesh, &mut cavity, from, to) {
                    done += 1;
                    break;
                }
            }
        }
        if done == 0 {
            break;
        }
    }
}

fn collapse<'a>(
    mesh: &mut SurfaceMesh<'a>,
    cavity: &mut Cavity<OnSurface<'a>>,
    from: u32,
    to: u32,
) -> bool {
    let collapse = Operation::Collapse { from, to };
    if !cavity.open(mesh, collapse) || !cavity.plan(mesh, collapse) {
        return false;
    }
    let least = |mesh: &SurfaceMesh<'_>, corners: [u32; 3]| min_angle(corners.map(|v| mesh.at(v)));
    let removed = cavity.removed.iter().map(|t| mesh.triangles[*t as usize].vertices);
    let before = removed.map(|corners| least(mesh, corners)).fold(TOO_SMALL, f64::min);
    let is_fine = cavity.added.triangles.iter().all(|corners| {
        let others = corners.iter().filter(|v| **v != to);
        others.into_iter().all(|v| ratio(mesh, [*v, to]) <= TOO_LONG)
            && least(mesh, *corners) >= before
    });
    is_fine && guarded(mesh, cavity)
}

/// Carries out what a cavity plans, if it keeps what must be kept.
fn guarded<'a>(mesh: &mut SurfaceMesh<'a>, cavity: &Cavity<OnSurface<'a>>) -> bool {
    let survey = OnSurface::survey(mesh, &cavity.vertices, false);
    mesh.record();
    cavity.carry_out(mesh);
    let keeps = survey.is_none_or(|survey| OnSurface::keeps(mesh, &survey, &cavity.vertices));
    if !keeps {
        mesh.undo(0);
    }
    mesh.commit();
    keeps
}

/// Flips edges where degrees become better, or angles with equal degrees.
fn flip(mesh: &mut SurfaceMesh<'_>, weights: &Weights) {
    // A hard excess counts twice.
    let weights = Weights { degree: 0.6, ..weights.clone() };
    let mut cavity = Cavity::default();
    for _ in 0..ROUNDS {
        let mut done = 0;
        for triangle in 0..mesh.triangles.len() as u32 {
            for corner in 0..3 {
                let t = &mesh.triangles[triangle as usize];
                if t.is_alive() && t.neighbours[corner as usize] > triangle {
                    let flip = Operation::Flip { triangle, corner };
                    if cavity.open(mesh, flip) && cavity.plan(mesh, flip) {
                        done += usize::from(flip_if_better(mesh, &cavity, &weights));
                    }
                }
            }
        }
        if done == 0 {
            break;
        }
    }
}

/// True if a triangle may have an angle below [`FLIPPED`].
fn is_thin(corners: [DVec3; 3]) -> bool {
    !has_sine(corners, 0.18)
}

fn flip_if_better<'a>(
    mesh: &mut SurfaceMesh<'a>,
    cavity: &Cavity<OnSurface<'a>>,
    weights: &Weights,
) -> bool {
    let triangles = |v: u32| mesh.vertices[v as usize].triangles;
    let is_counted = cavity.vertices.iter().all(|v| OnSurface::counts_triangles(mesh, *v));
    let least = |triangles: &[[u32; 3]]| {
        let angles = triangles.iter().map(|corners| min_angle(corners.map(|v| mesh.at(v))));
        angles.fold(60.0, f64::min)
    };
    let angles = || {
        let removed = [0, 1].map(|i| mesh.triangles[cavity.removed[i] as usize].vertices);
        [least(&removed), least(&cavity.added.triangles)]
    };
    let (change, [old, new]) = if is_counted {
        let of = |v: u32, count: u32| {
            let (excess, off) = (weights.excess_of(mesh, v, count), f64::from(count) - 6.0);
            0.3 * off * off + weights.degree * f64::from(excess * excess)
        };
        let grown = |v: u32| triangles(v).saturating_add_signed(cavity.growth(mesh, v));
        let change = |v: &u32| of(*v, grown(*v)) - of(*v, triangles(*v));
        let change: f64 = cavity.vertices.iter().map(change).sum();
        // Most edges: worse for degrees, and no angle asks.
        if change > 1e-9 && !cavity.removed.iter().any(|t| is_thin(mesh.corners(*t))) {
            return false;
        }
        (change, angles())
    } else {
        let cost = |mesh: &SurfaceMesh<'_>| -> f64 {
            cavity.vertices.iter().map(|v| weights.vertex(mesh, *v).0).sum()
        };
        let (angles, before) = (angles(), cost(mesh));
        mesh.record();
        cavity.carry_out(mesh);
        let change = cost(mesh) - before;
        mesh.undo(0);
        mesh.commit();
        (change, angles)
    };
    if new < FLIPPED && new <= old {
        return false;
    }
    let is_better =
        if old < FLIPPED { new > old } else { change < -1e-9 || change < 1e-9 && new > old + 1e-9 };
    is_better && guarded(mesh, cavity)
}

/// Moves each vertex towards the mean of its triangles' centroids, weighted by area over size squared; on a curve to the
/// middle between its neighbours.
fn center(mesh: &mut SurfaceMesh<'_>) {
    let mut star = Vec::new();
    for v in 0..mesh.vertices.len() as u32 {
        let vertex = &mesh.vertices[v as usize];
        if !vertex.kind.is_movable() || vertex.triangles == 0 {
            continue;
        }
        mesh.star(v, &mut star);
        let from = vertex.at;
        let step = match from.on {
            On::Curve { curve, t } => {
                let line = mesh.space.0.surface.curve(curve);
                let ways = neighbours_on_curve(mesh, v, &star).into_iter().filter_map(|other| {
                    let other = &mesh.vertices[other as usize];
                    let end = mesh.space.0.along(&other.at, curve, Some(t))?;
                    Some((line.way(t, end), other.size))
                });
                // Each interval as long as the size at its other end asks.
                let (way, of) =
                    ways.fold((0.0, 0.0), |(w, o), (way, size)| (w + way / size, o + 1.0 / size));
                DVec2::new(if of > 0.0 { way / of } else { 0.0 }, 0.0)
            }
            _ => {
                let (mut sum, mut of) = (DVec3::ZERO, 0.0);
                for t in &star {
                    let corners = mesh.corners(*t);
                    let vertices = mesh.triangles[*t as usize].vertices;
                    let size: f64 = vertices.iter().map(|u| mesh.vertices[*u as usize].size).sum();
                    let weight = doubled_area(corners) / (size * size);
                    sum += weight * (corners[0] + corners[1] + corners[2]) / 3.0;
                    of += weight;
                }
                let frame = OnSurface::frame(mesh, v);
                let way = if of > 0.0 { sum / of - from.at } else { DVec3::ZERO };
                frame.within(way)
            }
        };
        let frame = OnSurface::frame(mesh, v);
        let Some(site) = OnSurface::moved(mesh, v, &from, &frame, step) else { continue };
        if OnSurface::may_move(mesh, v, &star, &site) {
            let survey = OnSurface::survey(mesh, &[v], true);
            mesh.move_to(v, site);
            if survey.is_some_and(|survey| !OnSurface::keeps(mesh, &survey, &[v])) {
                mesh.move_to(v, from);
            }
        }
    }
}

/// Gives each vertex that moved the size where it is.
fn resize(mesh: &mut SurfaceMesh<'_>) {
    for v in 0..mesh.vertices.len() {
        let vertex = &mesh.vertices[v];
        if vertex.kind == Kind::Fixed || vertex.triangles == 0 {
            continue;
        }
        let patch = mesh.triangles[vertex.anchor as usize].patch;
        let foot = mesh.space.0.foot(patch, vertex.at.at, vertex.at.normal, vertex.at.near);
        mesh.vertices[v].size = mesh.space.0.size_at(&foot);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::work::tests::{euler, mesh, reference, weights};

    #[test]
    fn each_pass_keeps_the_invariants_and_brings_edges_nearer_to_their_lengths() {
        for name in ["cube", "saddle", "cone", "torus"] {
            let reference = reference(name, 2.0);
            let mut mesh = mesh(&reference);
            let (chi, _) = euler(&mesh);
            let check = |mesh: &SurfaceMesh<'_>| {
                mesh.check().unwrap();
                assert_eq!(euler(mesh).0, chi, "{name}");
            };
            split_long(&mut mesh);
            check(&mesh);
            assert!(edges(&mesh, |ratio| ratio > LONG).is_empty(), "{name}");
            let short = edges(&mesh, |ratio| ratio < SHORT).len();
            collapse_short(&mut mesh);
            check(&mesh);
            assert!(2 * edges(&mesh, |ratio| ratio < SHORT).len() < short, "{name}");
            let off = |mesh: &SurfaceMesh<'_>| -> f64 {
                (0..mesh.vertices.len() as u32)
                    .filter(|v| mesh.vertices[*v as usize].triangles > 0)
                    .map(|v| weights().vertex(mesh, v).0)
                    .sum()
            };
            let before = off(&mesh);
            flip(&mut mesh, &weights());
            check(&mesh);
            assert!(off(&mesh) < before, "{name}");
            let angles = |mesh: &SurfaceMesh<'_>| -> f64 {
                let alive = (0..).zip(&mesh.triangles).filter(|(_, t)| t.is_alive());
                alive.map(|(t, _)| min_angle(mesh.corners(t))).sum()
            };
            let before = angles(&mesh);
            center(&mut mesh);
            check(&mesh);
            assert!(angles(&mesh) > before, "{name}");
            resize(&mut mesh);
            check(&compacted(&mesh).unwrap());
        }
    }
}
