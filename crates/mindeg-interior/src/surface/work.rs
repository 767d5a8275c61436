//! The mesh that work begins with: the triangles of the surface itself.

use crate::array_mesh::{ArrayMesh, Kind, NONE, Vertex};
use crate::goal::{Goal, Weights};
use crate::surface::reference::{CurveLabel, On, OnSurface, Reference, Site};
use crate::surface::sectors::Sectors;
use glam::DVec3;
use mindeg_surfaces::{Spot, Surface};

/// A mesh on a surface.
pub(crate) type SurfaceMesh<'a> = ArrayMesh<OnSurface<'a>>;

/// A surface as a mesh, whose corners know their limits: that of the reference, or that before it was refined. Samples of
/// curves that are kept are corners.
pub(crate) fn work_mesh<'a>(
    reference: &'a Reference,
    surface: &Surface,
    weights: &Weights,
) -> Result<SurfaceMesh<'a>, String> {
    // Refining keeps the vertices and appends others.
    let fine = &reference.surface;
    let mut corner_of = vec![(NONE, 0); fine.points().len()];
    for (t, corners) in (0_u32..).zip(fine.triangles()) {
        (0..3).for_each(|i| corner_of[corners[i] as usize] = (t, i));
    }
    let vertex = |(v, at): (u32, &DVec3)| {
        let (near, i) = corner_of[v as usize];
        let (kind, on, normal) = match surface.spot(v) {
            Spot::Inside { patch } => (Kind::Free, On::Patch(patch), fine.corner_normal(near, i)),
            Spot::Curve { curve, t } if !reference.keeps(curve) => {
                (Kind::Curve, On::Curve { curve, t }, DVec3::ZERO)
            }
            _ => (Kind::Fixed, On::Corner(v), DVec3::ZERO),
        };
        let site = Site { at: *at, normal, near, on };
        let size = reference.size_of(v);
        Vertex { at: site, size, anchor: NONE, goal: NONE, triangles: 0, kind }
    };
    let vertices = (0..).zip(surface.points()).map(vertex).collect();
    let patches: Vec<u32> =
        (0..surface.triangles().len() as u32).map(|t| surface.patch(t)).collect();
    let space = OnSurface(reference);
    let mut mesh = ArrayMesh::linked(space, vertices, surface.triangles(), &patches, Vec::new())?;
    for t in 0..mesh.triangles.len() {
        for i in 0..3 {
            if let Some(span) = surface.span(t as u32, i) {
                mesh.triangles[t].labels[i] = CurveLabel(span.curve);
            }
        }
    }
    for v in 0..mesh.vertices.len() as u32 {
        if mesh.vertices[v as usize].kind == Kind::Fixed {
            let limit = Sectors::of(&mesh, v).limit();
            mesh.vertices[v as usize].goal = mesh.goals.len() as u32;
            mesh.goals.push(Goal { limit, ..weights.goal_inside() }.aimed());
        }
    }
    Ok(mesh)
}

/// The same mesh without what is dead, neighbours near each other in memory.
pub(crate) fn compacted<'a>(mesh: &SurfaceMesh<'a>) -> Result<SurfaceMesh<'a>, String> {
    let mut order = Vec::with_capacity(mesh.triangles.len());
    let mut is_met = vec![false; mesh.triangles.len()];
    for start in 0..mesh.triangles.len() {
        if is_met[start] || !mesh.triangles[start].is_alive() {
            continue;
        }
        is_met[start] = true;
        let mut next = order.len();
        order.push(start);
        while next < order.len() {
            for neighbour in mesh.triangles[order[next]].neighbours {
                if neighbour != NONE && !is_met[neighbour as usize] {
                    is_met[neighbour as usize] = true;
                    order.push(neighbour as usize);
                }
            }
            next += 1;
        }
    }
    let alive = || order.iter().map(|t| &mesh.triangles[*t]);
    let mut renamed = vec![NONE; mesh.vertices.len()];
    let mut vertices = Vec::new();
    for v in alive().flat_map(|t| t.vertices) {
        if renamed[v as usize] == NONE {
            renamed[v as usize] = vertices.len() as u32;
            vertices.push(Vertex { anchor: NONE, triangles: 0, ..mesh.vertices[v as usize] });
        }
    }
    let triangles: Vec<[u32; 3]> =
        alive().map(|t| t.vertices.map(|v| renamed[v as usize])).collect();
    let patches: Vec<u32> = alive().map(|t| t.patch).collect();
    let mut other =
        ArrayMesh::linked(mesh.space, vertices, &triangles, &patches, mesh.goals.clone())?;
    let labels: Vec<[CurveLabel; 3]> = alive().map(|t| t.labels).collect();
    other.triangles.iter_mut().zip(labels).for_each(|(t, labels)| t.labels = labels);
    Ok(other)
}
