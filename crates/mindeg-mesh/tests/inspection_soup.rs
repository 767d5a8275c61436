//! Inspections of random triangles against plain definitions, each looked up on its own.

use glam::DVec3;
use mindeg_mesh::TriMesh;
use mindeg_mesh::inspection::{Inspection, InspectionOptions};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

type Triangle = [u32; 3];

fn is_face(t: &Triangle) -> bool {
    BTreeSet::from(*t).len() == 3
}

fn edges(t: &Triangle) -> [[u32; 2]; 3] {
    let [a, b, c] = *t;
    [[a, b], [b, c], [c, a]].map(|[p, q]| [p.min(q), p.max(q)])
}

/// The number of classes of `things` if `join` relates things of one class.
fn class_count<T>(things: &[T], join: impl Fn(&T, &T) -> bool) -> usize {
    let mut class: Vec<usize> = (0..things.len()).collect();
    for i in 0..things.len() {
        for j in 0..i {
            if join(&things[i], &things[j]) {
                let [old, new] = [class[i], class[j]];
                class.iter_mut().filter(|c| **c == old).for_each(|c| *c = new);
            }
        }
    }
    BTreeSet::from_iter(class).len()
}

/// The same triangles on the first vertex at each position.
fn welded(positions: &[DVec3], triangles: &[Triangle]) -> Vec<Triangle> {
    let first = |v: u32| positions.iter().position(|&p| p == positions[v as usize]).unwrap() as u32;
    triangles.iter().map(|t| t.map(first)).collect()
}

fn check(found: &Inspection, all: &[Triangle], vertices: &[u32]) -> Result<(), TestCaseError> {
    let faces: Vec<Triangle> = all.iter().copied().filter(is_face).collect();
    let mut faces_of_edge: BTreeMap<[u32; 2], Vec<Triangle>> = BTreeMap::new();
    for face in &faces {
        for edge in edges(face) {
            faces_of_edge.entry(edge).or_default().push(*face);
        }
    }
    let with = |count: fn(usize) -> bool| -> Vec<[u32; 2]> {
        faces_of_edge.iter().filter(|(_, f)| count(f.len())).map(|(e, _)| *e).collect()
    };
    let boundary = with(|n| n == 1);
    prop_assert_eq!(found.face_count, faces.len());
    prop_assert_eq!(found.edge_count, faces_of_edge.len());
    prop_assert_eq!(found.boundary_edge_count, boundary.len());
    prop_assert_eq!(&found.non_manifold_edges, &with(|n| n > 2));

    let runs = |t: &Triangle, [a, b]: [u32; 2]| {
        [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]].contains(&[a, b])
    };
    let inconsistent: Vec<_> = faces_of_edge
        .iter()
        .filter(|(e, f)| f.len() == 2 && runs(&f[0], **e) == runs(&f[1], **e))
        .map(|(e, _)| *e)
        .collect();
    prop_assert_eq!(&found.inconsistent_edges, &inconsistent);

    let set = |t: &Triangle| BTreeSet::from(*t);
    let duplicates: Vec<u32> = (0..all.len())
        .filter(|&i| is_face(&all[i]) && all[..i].iter().any(|t| set(t) == set(&all[i])))
        .map(|i| i as u32)
        .collect();
    prop_assert_eq!(&found.duplicate_faces, &duplicates);

    let share_edge = |a: &Triangle, b: &Triangle| edges(a).iter().any(|e| edges(b).contains(e));
    prop_assert_eq!(found.component_count, class_count(&faces, share_edge));

    let used: BTreeSet<u32> = faces.iter().flatten().copied().collect();
    let unreferenced: Vec<u32> = vertices.iter().copied().filter(|v| !used.contains(v)).collect();
    prop_assert_eq!(&found.unreferenced_vertices, &unreferenced);

    let mut non_manifold = Vec::new();
    let [mut on_boundary, mut interior] = [BTreeMap::new(), BTreeMap::new()];
    let mut six_characteristics = 0;
    for &vertex in &used {
        let at: Vec<Triangle> = faces.iter().copied().filter(|t| t.contains(&vertex)).collect();
        let joined = |a: &Triangle, b: &Triangle| {
            edges(a).iter().any(|e| e.contains(&vertex) && edges(b).contains(e))
        };
        if class_count(&at, joined) > 1 {
            non_manifold.push(vertex);
        }
        let degree = at.iter().flatten().collect::<BTreeSet<_>>().len() - 1;
        let is_on_boundary = boundary.iter().any(|e| e.contains(&vertex));
        let histogram = if is_on_boundary { &mut on_boundary } else { &mut interior };
        *histogram.entry(degree as u32).or_insert(0_u64) += 1;
        // Every edge is at two vertices and every face at three.
        six_characteristics += 6 - 3 * degree as i64 + 2 * at.len() as i64;
        prop_assert!(degree as u32 <= found.max_degree());
        let is_pole = found.poles.iter().any(|p| {
            (p.vertex, p.degree, p.on_boundary) == (vertex, degree as u32, is_on_boundary)
        });
        prop_assert_eq!(is_pole, degree > 4);
    }
    prop_assert_eq!(&found.non_manifold_vertices, &non_manifold);
    prop_assert!(found.boundary_degrees.iter().eq(on_boundary));
    prop_assert!(found.interior_degrees.iter().eq(interior));
    prop_assert_eq!(6 * found.euler_characteristic, six_characteristics);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// Points of a small grid, so that many coincide or lie on a line or in a plane.
    #[test]
    fn counts_are_those_of_the_definitions(
        points in prop::collection::vec(prop::array::uniform3(0..3_u8), 1..9),
        indices in prop::collection::vec(prop::array::uniform3(any::<prop::sample::Index>()), 1..16),
        corner_angle in prop_oneof![Just(0.0), Just(1.0), Just(60.0), Just(f64::NAN)],
    ) {
        let positions: Vec<DVec3> = points.iter().map(|p| DVec3::from(p.map(f64::from))).collect();
        let triangles: Vec<Triangle> =
            indices.iter().map(|t| t.map(|i| i.index(positions.len()) as u32)).collect();
        let mesh = TriMesh::new(positions.clone(), triangles.clone()).unwrap();
        let options = InspectionOptions { weld: None, pole_degree: 4, corner_angle };

        let as_it_is = Inspection::of(&mesh, &options);
        prop_assert_eq!((as_it_is.vertex_count, as_it_is.welded_count), (positions.len(), 0));
        check(&as_it_is, &triangles, &(0..positions.len() as u32).collect::<Vec<_>>())?;

        let of_places = Inspection::of(&mesh, &InspectionOptions { weld: Some(0.0), ..options });
        let firsts: Vec<u32> = (0..positions.len())
            .filter(|&v| !positions[..v].contains(&positions[v]))
            .map(|v| v as u32)
            .collect();
        prop_assert_eq!(of_places.welded_count, positions.len() - firsts.len());
        check(&of_places, &welded(&positions, &triangles), &firsts)?;

        // On a small grid, products are exact.
        let flat: Vec<u32> = (0..triangles.len())
            .filter(|&i| {
                let [a, b, c] = triangles[i].map(|v| positions[v as usize]);
                (b - a).cross(c - a) == DVec3::ZERO
            })
            .map(|i| i as u32)
            .collect();
        prop_assert_eq!(&of_places.zero_area_triangles, &flat);
        prop_assert_eq!(of_places.quality, as_it_is.quality);
    }

    /// Positions of any size, where sums and products overflow and vanish.
    #[test]
    fn no_position_is_too_much(
        numbers in prop::collection::vec(prop::array::uniform3(prop::num::f64::ANY), 3..20),
        closed in any::<bool>(),
    ) {
        let finite = |x: f64| if x.is_finite() { x } else { f64::MAX };
        let positions: Vec<DVec3> = numbers.iter().map(|p| DVec3::from(p.map(finite))).collect();
        let last = positions.len() as u32 - 1;
        let fan = (1..last).map(|i| [0, i, i + 1]).chain(closed.then_some([0, last, 1])).collect();
        let mesh = TriMesh::new(positions, fan).unwrap();
        let found = Inspection::of(&mesh, &InspectionOptions::default());
        prop_assert_eq!(found.triangle_count, mesh.triangles().len());
        let again = Inspection::of(&mesh, &InspectionOptions::default());
        prop_assert_eq!(again, found);
    }
}
