//! Meshes whose loops are filled or bridged.

use mindeg::bridge::{BridgeOptions, bridge};
use mindeg::fill::{FILL, FillOptions, Filled, fill};
use mindeg::glam::DVec3;
use mindeg::inspection::{Inspection, InspectionOptions};
use mindeg::{LoopDefect, Loops, Progress, TriMesh, Triangles};
use proptest::prelude::*;

const EDGES_THERE: &str = "every triangulation of it needs an edge that the mesh has already";

/// A bridge without points inside.
const STRIP: BridgeOptions = BridgeOptions { max_degree: None, interior: false };

fn inspected(mesh: &TriMesh) -> Inspection {
    Inspection::of(mesh, &InspectionOptions::default())
}

#[track_caller]
fn assert_sound(mesh: &TriMesh, loops: usize, euler: i64) {
    let found = inspected(mesh);
    assert_eq!(mesh.boundary_loops().len(), loops);
    assert_eq!(found.euler_characteristic, euler);
    assert!(found.non_manifold_edges.is_empty() && found.non_manifold_vertices.is_empty());
    assert!(found.inconsistent_edges.is_empty() && found.duplicate_faces.is_empty());
}

/// The old mesh, bit for bit, is the start of the new one.
#[track_caller]
fn assert_kept(old: &TriMesh, new: &TriMesh, group: &str) {
    assert_eq!(old.positions(), &new.positions()[..old.positions().len()]);
    assert_eq!(old.triangles(), &new.triangles()[..old.triangles().len()]);
    assert_eq!(old.groups(), &new.groups()[..old.groups().len()]);
    let last = &new.groups()[new.groups().len() - 1];
    assert_eq!(last.name, group);
    assert_eq!(last.triangles.end as usize, new.triangles().len());
}

/// All loops, the rims of flat sheets too.
fn every(loops: &Loops) -> FillOptions {
    FillOptions { only: Some((0..loops.list().len()).collect()), ..FillOptions::default() }
}

fn filled(mesh: &TriMesh) -> Filled {
    let loops = Loops::of(mesh);
    fill(mesh.clone(), &loops, &every(&loops), Progress::NONE).unwrap()
}

/// A tube: rings of n vertices one above the other, of a radius for each ring and a height for
/// each vertex of a ring.
fn tube(n: u32, rings: &[f64], height: impl Fn(f64) -> f64) -> TriMesh {
    let vertex = |ring: usize, i: u32| ring as u32 * n + i % n;
    let mut points = Vec::new();
    let mut triangles = Vec::new();
    for (ring, radius) in rings.iter().enumerate() {
        for i in 0..n {
            let angle = std::f64::consts::TAU * f64::from(i) / f64::from(n);
            let z = ring as f64 + height(angle);
            points.push(DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), z));
            if ring + 1 < rings.len() {
                let [a, b] = [vertex(ring, i), vertex(ring, i + 1)];
                triangles.extend([[a, b, a + n], [b, b + n, a + n]]);
            }
        }
    }
    TriMesh::new(points, triangles).unwrap()
}

/// A plane of squares, two triangles each, without some of the squares.
fn plate(width: u32, height: u32, holes: &[[u32; 2]]) -> TriMesh {
    let vertex = |x: u32, y: u32| y * (width + 1) + x;
    let points = (0..=height).flat_map(|y| (0..=width).map(move |x| [x, y]));
    let squares = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
    let triangles = squares.filter(|square| !holes.contains(square)).flat_map(|[x, y]| {
        let [a, b, c, d] = [vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1)];
        [[a, b, c], [a, c, d]]
    });
    let triangles = triangles.collect();
    let points = points.map(|[x, y]| DVec3::new(x.into(), y.into(), 0.0)).collect();
    TriMesh::new(points, triangles).unwrap()
}

#[test]
fn a_tube_closes_at_both_ends() {
    let open = tube(24, &[1.0, 1.5, 1.0], |angle| 0.3 * libm::cos(2.0 * angle)).named("tube");
    let closed = filled(&open);
    assert_sound(&closed.mesh, 0, 2);
    assert_kept(&open, &closed.mesh, FILL);
    assert_eq!(closed.filled.len(), 2);
    for found in &closed.filled {
        assert_eq!((found.limit, found.max_degree), (6, 6));
        assert_eq!(found.triangles.len(), 22);
        assert!(found.area >= found.without_limit.0 && found.min_angle > 0.0);
    }
    let first = open.triangles().len() as u32;
    let ranges = closed.filled.iter().map(|found| found.triangles.clone());
    assert!(ranges.eq([first..first + 22, first + 22..first + 44]));
    // Degrees at the ends are 4 before.
    assert_eq!(closed.mesh.degrees().iter().max(), Some(&6));
    assert_eq!(closed.crossings, [[0; 2]; 0]);
}

#[test]
fn each_limit_is_kept_and_what_cannot_be_is_refused_with_the_least() {
    let open = tube(24, &[1.0, 1.0], |_| 0.0);
    let under = |max_degree| {
        let options = FillOptions { max_degree: Some(max_degree), ..FillOptions::default() };
        fill(open.clone(), &Loops::of(&open), &options, Progress::NONE)
    };
    // Four edges at each vertex, and 21 chords for 24 vertices.
    let message = under(5).unwrap_err().to_string();
    let expected =
        "loop 1 from vertex 0: no triangulation here has maximum degree 5; the least is 6";
    assert_eq!(message, expected);
    for limit in 6..9 {
        let closed = under(limit).unwrap();
        assert!(closed.mesh.degrees().iter().all(|&degree| degree <= limit));
    }
}

#[test]
fn loops_that_touch_are_filled_so_that_their_vertex_is_sound() {
    // Two holes that meet in a corner are one walk round both.
    let open = plate(4, 4, &[[1, 1], [2, 2]]);
    assert_eq!(inspected(&open).non_manifold_vertices.len(), 1);
    let loops = Loops::of(&open);
    let inner: Vec<_> = loops.list().iter().filter(|found| found.vertices.len() == 4).collect();
    assert_eq!(inner.len(), 2);
    let closed = filled(&open);
    // The outer boundary is a loop as well: then the plate has two sides.
    assert_eq!(closed.filled.len(), 3);
    assert_sound(&closed.mesh, 0, 2);

    let only = FillOptions { max_loop: 5, ..every(&loops) };
    let closed = fill(open.clone(), &loops, &only, Progress::NONE).unwrap();
    assert_eq!((closed.filled.len(), closed.left.len()), (2, 1));
    let reason = "it has 16 vertices, and only loops below 5 are filled";
    assert_eq!((closed.left[0].index, &*closed.left[0].reason), (0, reason));
    assert_sound(&closed.mesh, 1, 1);
    assert_eq!(closed.crossings, [[0; 2]; 0]);
}

/// Two squares that meet at a vertex take one of two diagonals each; here all four choices are tried.
#[test]
fn loops_that_share_a_vertex_are_decided_together() {
    let mut state = 1_u64;
    let mut below = |most: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (state >> 33) % most
    };
    let (mut kept, mut refused) = (0, 0);
    for _ in 0..2000 {
        let plate = plate(4, 4, &[[1, 1], [2, 2]]);
        let (mut points, mut triangles) = (plate.positions().to_vec(), plate.triangles().to_vec());
        points.iter_mut().for_each(|point| point.z = below(100) as f64 / 100.0);
        for _ in 0..below(30) {
            // A vertex in a triangle gives its corners an edge more each.
            let [a, b, c] = triangles.swap_remove(below(triangles.len() as u64) as usize);
            let new = points.len() as u32;
            points.push([a, b, c].iter().map(|&v| points[v as usize]).sum::<DVec3>() / 3.0);
            triangles.extend([[a, b, new], [b, c, new], [c, a, new]]);
        }
        let open = TriMesh::new(points, triangles).unwrap();
        let loops = Loops::of(&open);
        let squares = (0..loops.list().len()).filter(|&at| loops.list()[at].vertices.len() == 4);
        let squares: Vec<usize> = squares.collect();
        // Mostly one edge more at the vertex that both have.
        let shared = loops.list()[squares[0]].vertices.iter();
        let shared = shared.copied().find(|v| loops.list()[squares[1]].vertices.contains(v));
        let limit = open.degrees()[shared.unwrap() as usize] + below(4).min(1) as u32;
        let keeps = |choice: [usize; 2]| {
            let mut degrees = open.degrees().to_vec();
            for (&square, diagonal) in squares.iter().zip(choice) {
                let corners = &loops.list()[square].vertices;
                for end in [corners[diagonal], corners[diagonal + 2]] {
                    degrees[end as usize] += 1;
                }
            }
            degrees.iter().zip(open.degrees()).all(|(new, old)| new <= old.max(&limit))
        };
        let is_possible = [[0, 0], [0, 1], [1, 0], [1, 1]].into_iter().any(keeps);
        let only = Some(squares.clone());
        let options = FillOptions { max_degree: Some(limit), only, ..FillOptions::default() };
        match fill(open.clone(), &loops, &options, Progress::NONE) {
            Ok(closed) => {
                kept += 1;
                assert!(is_possible);
                let degrees = closed.mesh.degrees().iter().zip(open.degrees());
                assert!(degrees.into_iter().all(|(new, old)| new <= old.max(&limit)));
                let told = closed.filled.iter().map(|found| found.max_degree).max();
                let corners = squares.iter().flat_map(|&at| &loops.list()[at].vertices);
                let most = corners.map(|&corner| closed.mesh.degrees()[corner as usize]).max();
                assert_eq!(told, most);
            }
            Err(error) => {
                refused += 1;
                assert!(!is_possible, "{error}");
            }
        }
    }
    assert!(kept > 10 && refused > 10, "{kept} {refused}");
}

/// All triangulations of a loop, each by its chords.
fn all_triangulations(corners: &[u32]) -> Vec<Vec<[u32; 2]>> {
    let last = corners.len() - 1;
    if last < 2 {
        return vec![Vec::new()];
    }
    let mut found = Vec::new();
    // The tip of the triangle on the edge from the first corner to the last.
    for tip in 1..last {
        let [left, right] = [&corners[..=tip], &corners[tip..]].map(all_triangulations);
        for (left, right) in left.iter().flat_map(|left| right.iter().map(move |it| (left, it))) {
            let mut chords = [&left[..], &right[..]].concat();
            let sides = [[0, tip], [tip, last]].into_iter().filter(|[a, b]| b - a > 1);
            chords.extend(
                sides.map(|[a, b]| [corners[a].min(corners[b]), corners[a].max(corners[b])]),
            );
            found.push(chords);
        }
    }
    found
}

/// Two rings of triangles whose inner loops, of 4 or 6 vertices, have two opposite vertices in common; all pairs
/// of triangulations are tried.
#[test]
fn loops_that_share_two_vertices_are_decided_together() {
    let mut random = mindeg_mesh::Random::new(1);
    let (mut kept, mut refused, mut open, mut wanted_twice) = (0, 0, 0, 0);
    for _ in 0..1500 {
        let half = 2 + random.below(2) as u32;
        let count = 2 * half;
        let mut points: Vec<DVec3> = Vec::new();
        let mut triangles = Vec::new();
        let mut inner = Vec::new();
        for ring in 0..2 {
            let first = points.len() as u32;
            let new = |i: u32| if ring == 1 && i.is_multiple_of(half) { i } else { first + i };
            let own: Vec<u32> = (0..count).map(new).collect();
            points.extend((0..2 * count).map(|i| {
                let [x, y, z] = [(); 3].map(|()| random.unit());
                DVec3::new(x + f64::from(i % count), y, z + f64::from(ring))
            }));
            let outer = |i: u32| first + count + i % count;
            for i in 0..count {
                let [a, b] = [own[i as usize], own[(i as usize + 1) % own.len()]];
                triangles.extend([[a, b, outer(i)], [b, outer(i + 1), outer(i)]]);
            }
            inner.push(own);
        }
        // Single triangles elsewhere have an edge that a filling may want.
        for _ in 0..random.below(4) {
            let corners = &inner[random.below(2)];
            let [a, b] = [random.below(corners.len()), random.below(corners.len())];
            if ![0, 1, corners.len() - 1].contains(&a.abs_diff(b)) {
                let tip = points.len() as u32;
                points.push(DVec3::new(random.unit(), random.unit(), 9.0));
                triangles.push([corners[a], corners[b], tip]);
            }
        }
        let Ok(mesh) = TriMesh::new(points, triangles) else { continue };
        let loops = Loops::of(&mesh);
        let is_inner = |corners: &[u32]| {
            inner
                .iter()
                .any(|own| corners.len() == own.len() && corners.iter().all(|v| own.contains(v)))
        };
        let only: Vec<usize> = (0..loops.list().len())
            .filter(|&at| is_inner(&loops.list()[at].vertices) && loops.list()[at].defect.is_none())
            .collect();
        if only.len() != 2 {
            continue;
        }
        let limit = 6 + random.below(4) as u32;
        let edges: std::collections::BTreeSet<[u32; 2]> = mesh
            .triangles()
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        let each = |at: usize| all_triangulations(&loops.list()[only[at]].vertices);
        let is_new = |chords: &[[u32; 2]]| chords.iter().all(|chord| !edges.contains(chord));
        let (mut possible, mut under_limit) = (false, false);
        for one in each(0).iter().filter(|chords| is_new(chords)) {
            for other in each(1).iter().filter(|chords| is_new(chords)) {
                if one.iter().any(|chord| other.contains(chord)) {
                    wanted_twice += 1;
                    continue;
                }
                possible = true;
                let mut degrees = mesh.degrees().to_vec();
                one.iter().chain(other).flatten().for_each(|&end| degrees[end as usize] += 1);
                let mut all = degrees.iter().zip(mesh.degrees());
                under_limit |= all.all(|(new, old)| new <= old.max(&limit));
            }
        }
        let options =
            FillOptions { max_degree: Some(limit), only: Some(only), ..FillOptions::default() };
        match fill(mesh.clone(), &loops, &options, Progress::NONE) {
            Ok(closed) if closed.left.is_empty() => {
                kept += 1;
                assert!(under_limit);
                let degrees = closed.mesh.degrees().iter().zip(mesh.degrees());
                assert!(degrees.into_iter().all(|(new, old)| new <= old.max(&limit)));
                assert!(
                    inspected(&closed.mesh).non_manifold_edges.len()
                        <= inspected(&mesh).non_manifold_edges.len()
                );
            }
            Ok(closed) => {
                open += 1;
                assert!(!possible, "{:?}", closed.left);
            }
            Err(error) => {
                refused += 1;
                assert!(!under_limit, "{error}");
            }
        }
        let without = FillOptions { max_degree: None, ..options };
        let closed = fill(mesh, &loops, &without, Progress::NONE).unwrap();
        assert_eq!(closed.left.is_empty(), possible, "{:?}", closed.left);
    }
    let counts = [kept, refused, open, wanted_twice];
    assert!(counts.iter().all(|&count| count > 10), "{counts:?}");
}

#[test]
fn what_is_no_sound_loop_stays_open() {
    let points = || vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z, -DVec3::ONE];
    for (triangles, reasons) in [
        (vec![[0, 1, 2]], vec![LoopDefect::SingleTriangle]),
        (
            vec![[0, 1, 2], [1, 0, 3], [0, 1, 4]],
            vec![
                LoopDefect::Open { vertex: 1 },
                LoopDefect::Open { vertex: 0 },
                LoopDefect::Open { vertex: 0 },
            ],
        ),
        (vec![[0, 1, 2], [0, 1, 3]], vec![LoopDefect::Disagreeing { edge: [0, 3] }]),
    ] {
        let mesh = TriMesh::new(points(), triangles).unwrap();
        let closed = filled(&mesh);
        let found: Vec<_> = closed.left.iter().map(|left| left.reason.clone()).collect();
        let expected: Vec<_> = reasons.iter().map(LoopDefect::to_string).collect();
        assert_eq!(found, expected);
        assert_eq!(closed.mesh, mesh);
    }
}

#[test]
fn edges_that_are_there_are_not_made_again() {
    // Four vertices all joined: both diagonals of the loop 0 1 2 3 are edges of other triangles.
    let points: Vec<DVec3> = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0], [2, 2, 5], [2, 2, -5]]
        .map(|point: [i32; 3]| DVec3::from(point.map(f64::from)))
        .to_vec();
    let sides = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
    let diagonal = [[0, 2, 5]];
    let both = [[0, 2, 5], [1, 3, 5]];
    let mesh =
        |more: &[[u32; 3]]| TriMesh::new(points.clone(), [&sides[..], more].concat()).unwrap();
    let loop_of_sides = |mesh: &TriMesh| {
        let loops = Loops::of(mesh);
        loops.list().iter().position(|found| found.vertices == [0, 1, 2, 3]).unwrap()
    };
    for (more, added) in [(&[][..], 2), (&diagonal, 2), (&both, 0)] {
        let open = mesh(more);
        let only = FillOptions { only: Some(vec![loop_of_sides(&open)]), ..FillOptions::default() };
        let closed = fill(open.clone(), &Loops::of(&open), &only, Progress::NONE).unwrap();
        let new = &closed.mesh.triangles()[open.triangles().len()..];
        assert_eq!(new.len(), added, "{more:?}");
        if added == 0 {
            assert_eq!(closed.left[0].reason, EDGES_THERE);
        } else if !more.is_empty() {
            assert!(new.iter().all(|triangle| triangle.contains(&1) && triangle.contains(&3)));
        }
    }
    // The two sides of a square, front and back, share its boundary: one diagonal each.
    let square = plate(1, 1, &[]);
    let closed = filled(&square);
    assert_sound(&closed.mesh, 0, 2);
}

#[test]
fn a_filling_that_crosses_is_named() {
    // A box of squares without its lid, and a spike through the opening.
    let mut points = vec![DVec3::ZERO, DVec3::X * 4.0, DVec3::new(4.0, 4.0, 0.0), DVec3::Y * 4.0];
    points.extend(points.clone().iter().map(|point| *point - DVec3::Z * 3.0));
    let below = [[4, 6, 5], [4, 7, 6]];
    let sides = [0, 1, 2, 3].map(|i: u32| [i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4]);
    let sides = sides.map(|[a, b, c, d]| [[a, d, b], [b, d, c]]).concat();
    let spike = points.len() as u32;
    points.extend([[1.0, 2.0, -1.0], [1.0, 1.9, 1.0], [1.3, 1.9, 1.0]].map(DVec3::from));
    let triangles = [&below[..], &sides, &[[spike, spike + 1, spike + 2]]].concat();
    let open = TriMesh::new(points, triangles).unwrap();
    let closed = filled(&open);
    assert_eq!(closed.filled.len(), 1);
    assert_eq!(closed.crossings.len(), 1);
    assert_eq!(closed.crossings[0][1], 10);
}

#[test]
fn seams_do_not_count_as_holes() {
    // Every triangle has vertices of its own.
    let tube = tube(12, &[1.0, 1.0, 1.0], |_| 0.0);
    let corners = tube.triangles().iter().flatten();
    let points = corners.map(|&vertex| tube.positions()[vertex as usize]).collect();
    let triangles = (0..tube.triangles().len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
    let soup = TriMesh::new(points, triangles.collect()).unwrap();
    let closed = filled(&soup);
    let limits: Vec<u32> = closed.filled.iter().map(|found| found.limit).collect();
    assert_eq!(limits, [6, 6]);
    let found = inspected(&closed.mesh);
    assert_eq!((Loops::of(&closed.mesh).list().len(), found.euler_characteristic), (0, 2));
}

#[test]
fn loops_that_are_not_there_are_refused() {
    let tube = tube(5, &[1.0, 1.0], |_| 0.0);
    let only = FillOptions { only: Some(vec![2]), ..FillOptions::default() };
    let error = fill(tube.clone(), &Loops::of(&tube), &only, Progress::NONE).unwrap_err();
    assert_eq!(error.to_string(), "there is no loop 3; the mesh has 2 boundary loops");
    for (loops, message) in [
        ([0, 7], "there is no loop 8; the mesh has 2 boundary loops"),
        ([1, 1], "both ends of the bridge are loop 2; give two loops"),
    ] {
        let error = bridge((tube.clone(), &Loops::of(&tube)), None, loops, &STRIP, Progress::NONE)
            .unwrap_err();
        assert_eq!(error.to_string(), message);
    }
}

#[test]
fn a_bridge_joins_two_meshes_or_two_loops_of_one() {
    let lower = tube(24, &[1.0, 1.0], |_| 0.0).named("lower");
    let raised = |mesh: &TriMesh, by: f64| {
        let points = mesh.positions().iter().map(|&point| point + DVec3::Z * by).collect();
        TriMesh::new(points, mesh.triangles().to_vec()).unwrap()
    };
    for count in [24, 17, 7] {
        let upper = raised(&tube(count, &[1.2, 0.8], |_| 0.0), 2.0);
        let joined = bridge(
            (lower.clone(), &Loops::of(&lower)),
            Some((&upper, &Loops::of(&upper))),
            [1, 0],
            &STRIP,
            Progress::NONE,
        )
        .unwrap();
        assert_sound(&joined.mesh, 2, 0);
        assert_kept(&lower, &joined.mesh, "bridge");
        assert_eq!(joined.crossings, [[0; 2]; 0]);
        assert_eq!(joined.turned_over, None);
        // Four edges at each vertex before, one of the strip, and the even share of the others.
        assert_eq!(joined.strip.max_degree, 5 + 24_u32.div_ceil(count));
        assert_eq!(joined.strip.lower_bound, joined.strip.max_degree);
        assert_eq!(joined.triangles.len() as u32, 24 + count);
        assert!((joined.min_angle - joined.strip.min_angle).abs() < 1e-8);

        // Two parts of one mesh: the same strip.
        let both = lower.clone().with_mesh_added(&upper).unwrap();
        let again = bridge((both.clone(), &Loops::of(&both)), None, [1, 2], &STRIP, Progress::NONE)
            .unwrap();
        assert_eq!(again.mesh.triangles(), joined.mesh.triangles());
    }
    // A tube whose ends are joined is a torus.
    let bent = tube(12, &[1.0, 2.0, 2.5, 2.0], |_| 0.0);
    let torus =
        bridge((bent.clone(), &Loops::of(&bent)), None, [0, 1], &STRIP, Progress::NONE).unwrap();
    assert_sound(&torus.mesh, 0, 0);
}

#[test]
fn a_mesh_that_is_inside_out_is_noticed() {
    let lower = tube(24, &[1.0, 1.0], |_| 0.0);
    let upper = tube(24, &[1.0, 1.0], |_| 0.0);
    let points = upper.positions().iter().map(|&point| point + DVec3::Z * 2.0).collect();
    let over = upper.triangles().iter().map(|&[a, b, c]| [a, c, b]).collect();
    let upper = TriMesh::new(points, over).unwrap();
    let joined = bridge(
        (lower.clone(), &Loops::of(&lower)),
        Some((&upper, &Loops::of(&upper))),
        [1, 0],
        &STRIP,
        Progress::NONE,
    )
    .unwrap();
    assert!(joined.turned_over.unwrap() > 10.0, "{:?}", joined.turned_over);
}

#[test]
fn a_ring_in_a_plane_is_closed_without_folds() {
    // A plate with a large hole, and a smaller plate within it.
    let holes: Vec<[u32; 2]> = (2..8).flat_map(|x| (2..8).map(move |y| [x, y])).collect();
    let outer = plate(10, 10, &holes);
    let points = plate(2, 2, &[]).positions().iter().map(|&p| p + DVec3::splat(4.0)).collect();
    let level = |points: Vec<DVec3>| points.into_iter().map(|p| p.truncate().extend(0.0)).collect();
    let inner = TriMesh::new(level(points), plate(2, 2, &[]).triangles().to_vec()).unwrap();
    let hole = Loops::of(&outer).list().iter().position(|found| found.vertices[0] != 0).unwrap();
    let joined = bridge(
        (outer.clone(), &Loops::of(&outer)),
        Some((&inner, &Loops::of(&inner))),
        [hole, 0],
        &STRIP,
        Progress::NONE,
    )
    .unwrap();
    assert!(joined.strip.is_planar);
    assert_sound(&joined.mesh, 1, 1);
    assert_eq!(joined.crossings, [[0; 2]; 0]);
    let area = inspected(&joined.mesh).quality.area;
    assert!((area - 100.0).abs() < 1e-9);
}

#[test]
fn a_bridge_between_loops_that_touch_is_refused() {
    let open = plate(4, 4, &[[1, 1], [2, 2]]);
    let loops = Loops::of(&open);
    let small = (0..loops.list().len()).filter(|&i| loops.list()[i].vertices.len() == 4);
    let [a, b] = small.collect::<Vec<_>>()[..] else { panic!("two holes") };
    let error = bridge((open.clone(), &Loops::of(&open)), None, [a, b], &STRIP, Progress::NONE)
        .unwrap_err();
    let message = "the loops touch at vertex 12; a bridge needs loops without a common vertex";
    assert_eq!(error.to_string(), message);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Any holes in a plate: each closes, and nothing else changes.
    #[test]
    fn plates_with_any_holes_close(
        holes in prop::collection::vec([0_u32..6, 0_u32..5], 0..20)
    ) {
        prop_assume!((0..6).any(|x| (0..5).any(|y| !holes.contains(&[x, y]))));
        let open = plate(6, 5, &holes);
        let before = Loops::of(&open);
        let closed = fill(open.clone(), &before, &every(&before), Progress::NONE).unwrap();
        prop_assert_eq!(closed.filled.len() + closed.left.len(), before.list().len());
        for left in &closed.left {
            prop_assert_eq!(&left.reason, EDGES_THERE);
        }
        prop_assert_eq!(closed.mesh.boundary_loops().len(), closed.left.len());
        let found = inspected(&closed.mesh);
        prop_assert!(found.non_manifold_edges.is_empty());
        prop_assert!(found.inconsistent_edges.is_empty());
        // Where two parts touch in a vertex, they still do.
        let touching = inspected(&open).non_manifold_vertices;
        prop_assert!(found.non_manifold_vertices.iter().all(|vertex| touching.contains(vertex)));
        for found in &closed.filled {
            prop_assert!(found.limit >= 6);
        }
    }

    /// Any triangles at all: an error or a mesh, and no edge gets more than two faces by a filling.
    #[test]
    fn any_triangles_are_filled_or_left(
        triangles in prop::collection::vec(prop::array::uniform3(0_u32..9), 1..24),
        points in prop::collection::vec(prop::array::uniform3(-4_i8..4), 9),
    ) {
        let points: Vec<DVec3> = points.into_iter().map(|p| DVec3::from(p.map(f64::from))).collect();
        let open = TriMesh::new(points, triangles).unwrap();
        let before = inspected(&open);
        let closed = fill(open.clone(), &Loops::of(&open), &FillOptions::default(), Progress::NONE).unwrap();
        let after = inspected(&closed.mesh);
        prop_assert_eq!(after.non_manifold_edges.len(), before.non_manifold_edges.len());
        let loops = Loops::of(&open);
        let edges = |loops: &Loops| loops.list().iter().map(|found| found.vertices.len()).sum::<usize>();
        prop_assert!(edges(&Loops::of(&closed.mesh)) <= edges(&loops));
        if loops.list().len() > 1 {
            // Nothing panics, and the joined mesh is no worse.
            if let Ok(joined) = bridge((open.clone(), &Loops::of(&open)), None, [0, 1], &STRIP, Progress::NONE) {
                let after = inspected(&joined.mesh);
                prop_assert_eq!(after.non_manifold_edges.len(), before.non_manifold_edges.len());
            }
        }
    }
}

/// Seams: four vertices at one position, whose edges were counted twice or not at all.
#[test]
fn the_degree_of_the_whole_counts_vertices_at_one_place_once() {
    let tip = DVec3::Z;
    let base = [DVec3::X, DVec3::Y, -DVec3::X, -DVec3::Y];
    let positions = [base.to_vec(), vec![tip; 4]].concat();
    let open = TriMesh::new(positions, vec![[0, 1, 4], [1, 2, 5], [2, 3, 6], [3, 0, 7]]).unwrap();
    let closed = filled(&open);
    assert_eq!((closed.mesh.max_degree(), closed.max_degree), (5, 4));
    assert_eq!(closed.max_degree, inspected(&closed.mesh).max_degree());
}

/// A ball by latitudes and longitudes, without what is above a height.
fn bowl(height: f64) -> TriMesh {
    let (rings, around) = (24_u32, 40_u32);
    let mut points = vec![-DVec3::Z];
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    let at = |ring: u32, i: u32| 1 + (ring - 1) * around + i % around;
    for ring in 1..rings {
        let turn = std::f64::consts::PI * f64::from(ring) / f64::from(rings);
        let (radius, z) = (libm::sin(turn), -libm::cos(turn));
        if z > height {
            break;
        }
        for i in 0..around {
            let turn = std::f64::consts::TAU * (f64::from(i) + 0.5 * f64::from(ring % 2))
                / f64::from(around);
            points.push(DVec3::new(radius * libm::cos(turn), radius * libm::sin(turn), z));
            let next = (i + 1) % around;
            if ring == 1 {
                triangles.push([0, at(1, next), at(1, i)]);
                continue;
            }
            let [a, b] = [i, next].map(|i| at(ring - 1, i));
            let [c, d] = [i, next].map(|i| at(ring, i));
            triangles.extend(if ring % 2 == 1 {
                [[a, b, c], [b, d, c]]
            } else {
                [[a, b, d], [a, d, c]]
            });
        }
    }
    TriMesh::new(points, triangles).unwrap()
}

#[test]
fn points_inside_go_on_as_the_mesh_around_does() {
    let open = bowl(0.4);
    let loops = Loops::of(&open);
    let options = FillOptions { interior: true, ..every(&loops) };
    let found = fill(open.clone(), &loops, &options, Progress::NONE).unwrap();
    assert_sound(&found.mesh, 0, 2);
    assert_kept(&open, &found.mesh, FILL);
    let [filled] = &found.filled[..] else { panic!("{found:?}") };
    let inside = filled.inside.clone().unwrap().unwrap();
    assert!(inside.vertices.len() > 40 && inside.off_degree.is_empty(), "{inside:?}");
    assert!(inside.degrees[0] >= 5 && inside.degrees[1] <= 7 && filled.max_degree <= 7);
    assert!(filled.min_angle > 30.0, "{filled:?}");
    assert!(found.crossings.is_empty());
    for v in inside.vertices.clone() {
        let length = found.mesh.positions()[v as usize].length();
        assert!((0.8..1.05).contains(&length), "{length}");
    }
    let degrees = found.mesh.degrees();
    assert!(inside.vertices.clone().all(|v| (5..=7).contains(&degrees[v as usize])));
    let again = fill(open, &loops, &options, Progress::NONE).unwrap();
    assert_eq!(again.mesh, found.mesh);
}

/// A flat sheet with a hole that is not convex stays flat, and both holes that share a vertex are filled.
#[test]
fn points_inside_stay_in_the_plane_of_a_sheet() {
    let n = 16_u32;
    let is_hole = |i: u32, j: u32| {
        (3..9).contains(&i) && (3..6).contains(&j)
            || (3..6).contains(&i) && (3..10).contains(&j)
            || (9..12).contains(&i) && (6..10).contains(&j)
    };
    let at = |i: u32, j: u32| i * (n + 1) + j;
    let points =
        (0..=n).flat_map(|i| (0..=n).map(move |j| DVec3::new(f64::from(i), f64::from(j), 2.0)));
    let cells = (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).filter(|&(i, j)| !is_hole(i, j));
    let triangles = cells.flat_map(|(i, j)| {
        [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]
    });
    let open = TriMesh::new(points.collect(), triangles.collect()).unwrap();
    let loops = Loops::of(&open);
    let options = FillOptions { interior: true, ..FillOptions::default() };
    let found = fill(open.clone(), &loops, &options, Progress::NONE).unwrap();
    assert_kept(&open, &found.mesh, FILL);
    assert_eq!((found.filled.len(), found.left.len()), (2, 1));
    assert!(found.crossings.is_empty());
    for filled in &found.filled {
        let inside = filled.inside.clone().unwrap().unwrap();
        assert!(inside.off_degree.is_empty() && filled.min_angle > 25.0, "{filled:?}");
        for v in inside.vertices {
            assert!((found.mesh.positions()[v as usize].z - 2.0).abs() < 1e-9);
        }
    }
}

/// The tube between two ends far apart has points inside, keeps its radius and is smooth at both ends.
#[test]
fn points_inside_a_bridge_go_on_as_both_ends_do() {
    let ring = |n: u32, radius: f64| tube(n, &[radius; 3], |_| 0.0);
    let raised = |mesh: &TriMesh| {
        let points = mesh.positions().iter().map(|&point| point + DVec3::Z * 6.0).collect();
        TriMesh::new(points, mesh.triangles().to_vec()).unwrap()
    };
    // Where one rim has shorter edges, sizes grow from it within few rows.
    for (n, least) in [(16, 35.0), (30, 15.0)] {
        let (lower, upper) = (ring(16, 1.0), raised(&ring(n, 1.0)));
        let options = BridgeOptions { interior: true, ..STRIP };
        let both = [Loops::of(&lower), Loops::of(&upper)];
        let join = || {
            let other = Some((&upper, &both[1]));
            bridge((lower.clone(), &both[0]), other, [1, 0], &options, Progress::NONE).unwrap()
        };
        let joined = join();
        assert_sound(&joined.mesh, 2, 0);
        assert_kept(&lower, &joined.mesh, "bridge");
        assert_eq!(joined.crossings, [[0; 2]; 0]);
        let inside = joined.inside.clone().unwrap().unwrap();
        assert!(inside.vertices.len() > 100 && inside.off_degree.is_empty(), "{inside:?}");
        assert!(inside.degrees[0] >= 5 && inside.degrees[1] <= 7);
        assert!(joined.min_angle > least && joined.strip.min_angle < 6.0, "{}", joined.min_angle);
        for v in inside.vertices {
            let radius = joined.mesh.positions()[v as usize].truncate().length();
            assert!((0.9..1.1).contains(&radius), "{radius}");
        }
        assert_eq!(join().mesh, joined.mesh);
    }
}

/// A rim that waves as a crown: a filling in the direction of the faces along it folds at the crests.
#[test]
fn points_inside_do_not_fold_on_wavy_rims() {
    for (waves, is_folded) in [(3.0, false), (6.0, true)] {
        let n = 16_u32;
        let turn = |i: u32| std::f64::consts::TAU * f64::from(i) / f64::from(n);
        let at = |i: u32| {
            let height = 0.3 * libm::sin(waves * turn(i));
            DVec3::new(libm::cos(turn(i)), libm::sin(turn(i)), height)
        };
        // A cone below it.
        let points = (0..n).map(at).chain([DVec3::new(0.0, 0.0, -1.0)]).collect();
        let open = TriMesh::new(points, (0..n).map(|i| [i, (i + 1) % n, n]).collect()).unwrap();
        let loops = Loops::of(&open);
        let options = FillOptions { interior: true, ..every(&loops) };
        let found = fill(open, &loops, &options, Progress::NONE).unwrap();
        let inside = found.filled[0].inside.clone().unwrap();
        if is_folded {
            assert_eq!(inside.unwrap_err(), "with points inside, it would fold");
        } else {
            assert!(found.crossings.is_empty() && inside.unwrap().vertices.len() > 10, "{waves}");
        }
    }
}
