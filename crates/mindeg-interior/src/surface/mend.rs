//! Mends degrees out of their ranges by chains of operations. Where none keeps the mesh near the surface, because that bends
//! too much between the triangles of a vertex, these make room first: their edges become half as long.

use crate::array_mesh::NONE;
use crate::compass::settle;
use crate::goal::Weights;
use crate::manifold::Manifold;
use crate::operations::{Cavity, Operation};
use crate::smooth::Ring;
use crate::stage::Stage;
use crate::surface::chains::{BROKEN, LOST, excess_of, is_broken, is_mended, least_share};
use crate::surface::reference::OnSurface;
use crate::surface::work::SurfaceMesh;
use mindeg_mesh::Cancelled;

/// Edges at the vertex become this share of what they were.
const SHORTER: f64 = 0.5;
/// Shorter edges than this share of the size are not divided.
const DIVIDED: f64 = 0.7;
/// Degrees are mended within so many rings.
const RINGS: usize = 3;
/// So many chains are looked for in one place.
const CHAINS: usize = 24;
/// So many operations are looked at for a vertex, and for each of those chains.
const MOST: usize = 12_000;
const MOST_WITH_ROOM: usize = 4_000;
/// So many vertices get a search: a mesh with more broken ones has a part that cannot be mended.
const VERTICES: usize = 300;
/// Sweeps over what has moved.
const SWEEPS: usize = 3;

/// Mends vertices whose degrees are out of range. Returns how many chains were done.
pub(crate) fn mend(
    mesh: &mut SurfaceMesh<'_>,
    weights: &Weights,
    stage: &mut Stage<'_>,
) -> Result<usize, Cancelled> {
    let all = 0..mesh.vertices.len() as u32;
    let mut star = Vec::new();
    let mut is_wanted = |v: &u32| is_broken(mesh, weights, *v) && !is_frozen(mesh, *v, &mut star);
    let broken: Vec<u32> = all.filter(&mut is_wanted).take(VERTICES).collect();
    let mut done = 0;
    for vertex in broken {
        stage.still()?;
        if !is_broken(mesh, weights, vertex) {
            continue;
        }
        mesh.record();
        let is_done =
            is_mended(mesh, weights, vertex, MOST) || is_mended_with_room(mesh, weights, vertex);
        done += usize::from(is_done);
        mesh.commit();
    }
    Ok(done)
}

/// True if all edges at a vertex stay, and so does its degree.
fn is_frozen(mesh: &SurfaceMesh<'_>, vertex: u32, star: &mut Vec<u32>) -> bool {
    mesh.star(vertex, star);
    star.iter().all(|t| {
        let triangle = &mesh.triangles[*t as usize];
        let corner = triangle.corner(vertex);
        [1, 2].into_iter().all(|i| {
            let label = triangle.labels[(corner + i) % 3].0;
            label != NONE && mesh.space.0.keeps(label)
        })
    })
}

/// Divides the edges at a vertex and mends all degrees near by. True if there are fewer wrong ones then; else the mesh is as
/// it was. The mesh is recording.
fn is_mended_with_room(mesh: &mut SurfaceMesh<'_>, weights: &Weights, vertex: u32) -> bool {
    let (mark, given) = (mesh.mark(), mesh.vertices.len() as u32);
    let near = rings(mesh, vertex, RINGS);
    let (before, share) = (excess_of(mesh, weights, &near), least_share(mesh, weights, &near));
    let survey = OnSurface::survey(mesh, &near, false);
    let now = |mesh: &SurfaceMesh<'_>| -> Vec<u32> {
        let new = given..mesh.vertices.len() as u32;
        let all = near.iter().copied().chain(new);
        all.filter(|v| mesh.vertices[*v as usize].triangles > 0).collect()
    };
    divide(mesh, weights, vertex);
    for _ in 0..CHAINS {
        // The one that room was made for comes first.
        let broken: Vec<u32> =
            now(mesh).into_iter().filter(|v| is_broken(mesh, weights, *v)).collect();
        if !broken.into_iter().any(|v| is_mended(mesh, weights, v, MOST_WITH_ROOM)) {
            break;
        }
    }
    let after = now(mesh);
    let is_good = excess_of(mesh, weights, &after) < before
        && least_share(mesh, weights, &after) >= BROKEN.min(LOST * share)
        && survey.is_none_or(|survey| OnSurface::keeps(mesh, &survey, &after));
    if !is_good {
        mesh.undo(mark);
    }
    is_good
}

/// Halves the edges at a vertex that are not short, and moves the vertices there until they rest.
fn divide(mesh: &mut SurfaceMesh<'_>, weights: &Weights, vertex: u32) {
    let around = rings(mesh, vertex, 1);
    let given = mesh.vertices.len() as u32;
    let mut cavity = Cavity::default();
    let mut star = Vec::new();
    for &other in around.iter().filter(|v| **v != vertex) {
        let [p, q] = [vertex, other].map(|v| &mesh.vertices[v as usize]);
        if p.at.at.distance(q.at.at) < DIVIDED * 0.5 * (p.size + q.size) {
            continue;
        }
        mesh.star(vertex, &mut star);
        let at = star.iter().find(|t| mesh.triangles[**t as usize].vertices.contains(&other));
        let Some(&triangle) = at else { continue };
        let corners = mesh.triangles[triangle as usize].vertices;
        let Some(corner) = (0..3).find(|i| ![vertex, other].contains(&corners[*i])) else {
            continue;
        };
        let mark = mesh.mark();
        let split = Operation::Split { triangle, corner: corner as u8 };
        if cavity.open(mesh, split) && cavity.plan(mesh, split) {
            cavity.carry_out(mesh);
        } else {
            mesh.undo(mark);
        }
    }
    let new = given..mesh.vertices.len() as u32;
    for v in new.clone().chain([vertex]) {
        mesh.keep_vertex(v);
        mesh.vertices[v as usize].size *= SHORTER;
    }
    let mut ring = Ring::default();
    let movable: Vec<u32> = new
        .chain(around)
        .filter(|v| {
            let vertex = &mesh.vertices[*v as usize];
            vertex.kind.is_movable() && vertex.triangles > 0
        })
        .collect();
    for _ in 0..SWEEPS {
        for v in &movable {
            settle(mesh, *v, weights, 0.03, &mut ring);
        }
    }
}

/// The vertices within so many rings round a vertex, each once, from the nearest on.
fn rings(mesh: &SurfaceMesh<'_>, vertex: u32, rings: usize) -> Vec<u32> {
    let (mut found, mut inside, mut star) = (vec![vertex], 0, Vec::new());
    for _ in 0..rings {
        let end = found.len();
        for at in inside..end {
            mesh.star(found[at], &mut star);
            for v in star.iter().flat_map(|t| mesh.triangles[*t as usize].vertices) {
                if !found.contains(&v) {
                    found.push(v);
                }
            }
        }
        inside = end;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::array_mesh::Kind;
    use crate::surface::reference::{CurveLabel, Reference};
    use crate::surface::work::tests::{mesh, reference};

    #[test]
    fn a_vertex_is_frozen_where_all_its_edges_are_kept() {
        let given = reference("cube", 3.0);
        let curves = given.surface.curves().len();
        for is_kept in [false, true] {
            let (fine, size, tolerance) = (given.surface.clone(), given.size, given.tolerance);
            let reference = Reference::new(fine, size, tolerance, vec![is_kept; curves]);
            let mut mesh = mesh(&reference);
            let free = mesh.vertices.iter().position(|v| v.kind == Kind::Free).unwrap() as u32;
            let mut star = Vec::new();
            let around = rings(&mesh, free, 1);
            for other in around.into_iter().filter(|v| *v != free) {
                assert!(!is_frozen(&mesh, free, &mut star));
                mesh.lock(free, other, CurveLabel(0)).unwrap();
            }
            assert_eq!(is_frozen(&mesh, free, &mut star), is_kept);
        }
    }
}
