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
            let all = Sectors::of(&mesh, v);
            let limit = all.limit();
            mesh.vertices[v as usize].goal = mesh.goals.len() as u32;
            let total = Sectors::sharp(&mesh, v).total(
                [&Sectors::seen(&mesh, v), &all],
                &weights.interior,
                weights.floor,
            );
            let (least, triangles) = (*total.start(), *total.end());
            let goal = Goal { limit, least, triangles, wanted: triangles, ..weights.goal_inside() };
            mesh.goals.push(goal.aimed());
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

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::operations::{Cavity, Operation, operations};
    use crate::options::Options;
    use crate::surface::models;
    use crate::surface::motion::neighbours_on_curve;
    use mindeg_mesh::Progress;
    use mindeg_surfaces::{FeatureRules, SizeRules};
    use proptest::prelude::*;

    /// The reference of a model, with edges so many times as long as its own.
    pub(crate) fn reference(name: &str, coarser: f64) -> Reference {
        let found = models::all().into_iter().find(|model| model.0 == name).unwrap();
        let (points, triangles, size) = found.1;
        let size = coarser * size.unwrap();
        let surface = Surface::new(&points, &triangles, &[], &FeatureRules::default()).unwrap();
        let fine = surface.refined(&SizeRules::of_size(size), Progress::NONE).unwrap();
        let curves = fine.curves().len();
        Reference::new(fine, size, 0.2 * size, vec![false; curves])
    }

    pub(crate) fn weights() -> Weights {
        Weights::single(&Options::default(), 35.0)
    }

    pub(crate) fn mesh(reference: &Reference) -> SurfaceMesh<'_> {
        work_mesh(reference, &reference.surface, &weights()).unwrap()
    }

    /// Vertices less edges plus triangles, and the edges of each curve.
    pub(crate) fn euler(mesh: &SurfaceMesh<'_>) -> (i64, Vec<u32>) {
        let vertices = mesh.vertices.iter().filter(|v| v.triangles > 0).count() as i64;
        let alive = || mesh.triangles.iter().filter(|t| t.is_alive());
        let mut halves = 0;
        let mut curves = vec![0; mesh.space.0.surface.curves().len()];
        for t in alive() {
            for i in 0..3 {
                let weight = if t.neighbours[i] == NONE { 2 } else { 1 };
                halves += i64::from(weight);
                if t.is_locked(i) {
                    curves[t.labels[i].0 as usize] += weight;
                }
            }
        }
        (vertices - halves / 2 + alive().count() as i64, curves)
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]
        /// Whatever operations are done, the invariants hold, the topology stays, each curve still has edges, and undoing
        /// restores the mesh bit for bit.
        #[test]
        fn random_operations_keep_the_surface(
            which in 0..4_usize,
            steps in prop::collection::vec(
                (any::<prop::sample::Index>(), 0..8_u32, any::<prop::sample::Index>()), 1..160,
            ),
        ) {
            let reference = reference(["cube", "saddle", "cylinder", "torus"][which], 5.0);
            let mut mesh = mesh(&reference);
            let (start, first) = (mesh.clone(), euler(&mesh));
            mesh.record();
            let mut cavity = Cavity::default();
            let mut list = Vec::new();
            for (place, kind, choice) in steps {
                let alive: Vec<u32> = (0..mesh.vertices.len() as u32)
                    .filter(|v| mesh.vertices[*v as usize].triangles > 0)
                    .collect();
                operations(&mesh, *place.get(&alive), true, &mut list);
                // Else nearly all are splits of vertices, and no collapse leaves a small mesh.
                list.retain(|operation| match operation {
                    Operation::SplitVertex { .. } => kind == 0,
                    Operation::Split { .. } => kind == 1,
                    Operation::Collapse { .. } | Operation::Flip { .. } => kind > 1,
                });
                if list.is_empty() {
                    continue;
                }
                let operation = *choice.get(&list);
                let mark = mesh.mark();
                if cavity.open(&mesh, operation) && cavity.plan(&mut mesh, operation) {
                    cavity.carry_out(&mut mesh);
                } else {
                    mesh.undo(mark);
                }
                mesh.check().map_err(TestCaseError::fail)?;
                let (chi, curves) = euler(&mesh);
                prop_assert_eq!(chi, first.0);
                prop_assert!(curves.iter().all(|edges| *edges > 0), "{:?}", operation);
                let mut star = Vec::new();
                for v in (0..mesh.vertices.len() as u32).filter(|v| {
                    let vertex = &mesh.vertices[*v as usize];
                    vertex.kind == Kind::Curve && vertex.triangles > 0
                }) {
                    mesh.star(v, &mut star);
                    prop_assert_eq!(neighbours_on_curve(&mesh, v, &star).len(), 2);
                }
            }
            let small = compacted(&mesh).map_err(TestCaseError::fail)?;
            prop_assert_eq!(euler(&small), euler(&mesh));
            mesh.undo(0);
            prop_assert_eq!(&mesh.triangles, &start.triangles);
            prop_assert_eq!(&mesh.vertices, &start.vertices);
        }
    }

    #[test]
    fn corners_have_their_limits_as_goals() {
        let reference = reference("cube", 3.0);
        let mesh = mesh(&reference);
        let corners: Vec<_> = mesh.vertices.iter().filter(|v| v.kind == Kind::Fixed).collect();
        assert_eq!((corners.len(), mesh.goals.len()), (8, 8));
        assert!(mesh.goals.iter().all(|goal| (goal.limit - 45.0).abs() < 1e-9));
    }
}
