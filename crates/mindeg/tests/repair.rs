//! Repairs of boxes that have one kind of fault each, and of one that has all.

#![cfg(feature = "interior")]

use mindeg::glam::DVec3;
use mindeg::remesh::{PartError, Remesh, remesh};
use mindeg::repair::{Repairs, repaired};
use mindeg::{Group, Line, Progress, TriMesh, Triangles};

type Faces = (Vec<DVec3>, Vec<[u32; 3]>);

/// A unit cube, each side of which has 4 x 4 squares; its points repeat along edges.
fn cube() -> Faces {
    let (mut points, mut faces) = (Vec::new(), Vec::new());
    for side in 0..6_u32 {
        let (axis, high) = (side as usize / 2, f64::from(side % 2));
        let at = |i: u32, j: u32| {
            let mut p = [0.0; 3];
            p[axis] = high;
            p[(axis + 1) % 3] = 0.25 * f64::from(i);
            p[(axis + 2) % 3] = 0.25 * f64::from(j);
            DVec3::from(p)
        };
        for (i, j) in (0..16).map(|k| (k / 4, k % 4)) {
            let first = points.len() as u32;
            points.extend([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
            let quad = if high > 0.0 { [0, 1, 2, 3] } else { [3, 2, 1, 0] }.map(|k| first + k);
            faces.extend([[quad[0], quad[1], quad[2]], [quad[0], quad[2], quad[3]]]);
        }
    }
    (points, faces)
}

fn mesh((points, faces): Faces) -> TriMesh {
    TriMesh::new(points, faces).unwrap()
}

/// The volume inside, if the mesh is closed and all edges have two faces that agree.
fn volume(mesh: &TriMesh) -> Option<f64> {
    let mesh = mesh.welded(0.0);
    let mut edges: Vec<[u32; 2]> =
        mesh.triangles().iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
    edges.sort_unstable();
    let is_closed = edges.iter().all(|&[a, b]| edges.binary_search(&[b, a]).is_ok());
    let is_simple = edges.windows(2).all(|pair| pair[0] != pair[1]);
    let of = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|v| mesh.positions()[v as usize]);
        a.cross(b).dot(c) / 6.0
    };
    (is_closed && is_simple).then(|| mesh.triangles().iter().map(of).sum())
}

fn mended(faces: Faces, rim: f64) -> (TriMesh, Repairs) {
    repaired(&mesh(faces), rim, Progress::NONE).unwrap()
}

#[test]
fn a_sound_mesh_stays() {
    let (after, repairs) = mended(cube(), 2.0);
    assert_eq!(repairs, Repairs::default());
    assert!((volume(&after).unwrap() - 1.0).abs() < 1e-12);
}

#[test]
fn points_that_nearly_coincide_are_welded() {
    let (mut points, faces) = cube();
    let sum: f64 = (0..points.len()).map(|i| f64::from((i % 7) as u32) * 1e-8).sum();
    points.iter_mut().enumerate().for_each(|(i, p)| p.x += f64::from((i % 7) as u32) * 1e-8);
    assert!(sum > 0.0 && volume(&mesh((points.clone(), faces.clone()))).is_none());
    let (after, repairs) = mended((points, faces), 0.0);
    assert!(repairs.welded_points > 90, "{repairs:?}");
    assert!((volume(&after).unwrap() - 1.0).abs() < 1e-6);
}

#[test]
fn faces_without_area_leave_no_slit() {
    // A corner twice; and one along an edge of two faces, whose middle only one of them knows.
    let (mut points, mut faces) = cube();
    faces.push([0, 0, 1]);
    let [a, b, c] = faces[0];
    let middle = points.len() as u32;
    points.push(points[a as usize].midpoint(points[b as usize]));
    faces[0] = [a, middle, c];
    faces.extend([[middle, b, c], [a, b, middle]]);
    let (after, repairs) = mended((points, faces), 0.0);
    assert_eq!(repairs, Repairs { flat_faces: 2, ..Repairs::default() });
    assert!((volume(&after).unwrap() - 1.0).abs() < 1e-12);
}

#[test]
fn doubled_faces_are_dropped() {
    let (points, mut faces) = cube();
    // The same again, from another corner; and one with its back, which leaves a hole.
    let [a, b, c] = faces[5];
    faces.push([b, c, a]);
    let (after, repairs) = mended((points.clone(), faces.clone()), 0.0);
    assert_eq!(repairs, Repairs { doubled_faces: 1, ..Repairs::default() });
    assert!((volume(&after).unwrap() - 1.0).abs() < 1e-12);
    faces[5] = [a, c, b];
    faces.pop();
    let back = faces[5];
    faces.push([back[0], back[2], back[1]]);
    let (after, repairs) = mended((points, faces), 2.0);
    assert_eq!((repairs.doubled_faces, repairs.filled_holes, repairs.fill_faces), (2, 1, 1));
    assert!((volume(&after).unwrap() - 1.0).abs() < 1e-12);
}

#[test]
fn what_hangs_on_an_edge_is_dropped() {
    let (mut points, mut faces) = cube();
    // A fin of two faces on an edge inside a side, and a much larger sheet on another.
    for (index, by) in [(0, 0.1), (40, 9.0)] {
        let [a, b, _] = faces[index];
        let first = points.len() as u32;
        let out = by * DVec3::new(0.3, 0.5, 0.7);
        points.extend([points[a as usize] + out, points[b as usize] + out]);
        faces.extend([[a, b, first + 1], [a, first + 1, first]]);
    }
    let count = faces.len();
    let (after, repairs) = mended((points, faces), 1.0);
    assert_eq!(repairs.crowded_faces, 3, "{repairs:?}");
    // The rest of the large sheet is a piece of its own, which touches the box in a point.
    assert_eq!((after.triangle_count() as usize, repairs.split_points), (count - 3, 1));
}

#[test]
fn faces_are_turned_and_holes_filled_up_to_a_rim() {
    let (points, mut faces) = cube();
    [3, 4, 90].into_iter().for_each(|face: usize| faces[face].swap(0, 1));
    // Two holes: of one face, and of the eight faces of four squares.
    faces.remove(60);
    faces.drain(0..4);
    faces.drain(4..8);
    let open = mesh((points.clone(), faces.clone()));
    assert_eq!(open.welded(0.0).boundary_loops().len(), 2);
    let (after, repairs) = mended((points.clone(), faces.clone()), 1.0);
    assert_eq!((repairs.turned_faces, repairs.filled_holes), (2, 1), "{repairs:?}");
    assert_eq!(after.welded(0.0).boundary_loops().len(), 1);
    let (after, repairs) = mended((points, faces), 2.5);
    assert_eq!((repairs.filled_holes, repairs.fill_faces), (2, 1 + 6), "{repairs:?}");
    assert!((volume(&after).unwrap() - 1.0).abs() < 1e-12);
}

#[test]
fn a_dirty_part_is_meshed_once_it_is_repaired() {
    let (mut points, mut faces) = cube();
    faces[3].swap(0, 1);
    faces.remove(100);
    let [a, b, _] = faces[0];
    points.push(DVec3::new(0.1, 0.1, -0.2));
    faces.extend([[a, b, points.len() as u32 - 1], faces[7]]);
    let (all, sides) = (faces.len() as u32, 64);
    let part = mesh((points, faces));
    let groups = vec![Group::new("two", 0..sides), Group::new("others", sides..all)];
    let part = part.with_groups(groups);
    let wish = Remesh { size: Some(0.2), ..Remesh::default() };
    let refused = remesh(&part, &wish, Progress::NONE);
    assert!(matches!(refused, Err(PartError::NoSurface(faults)) if faults.faults.len() > 3));
    let found = remesh(&part, &Remesh { repair: true, ..wish }, Progress::NONE).unwrap();
    let repairs = found.repairs.unwrap();
    assert_eq!(
        repairs,
        Repairs {
            doubled_faces: 1,
            crowded_faces: 1,
            turned_faces: 1,
            filled_holes: 1,
            fill_faces: 1,
            ..Repairs::default()
        }
    );
    assert_eq!(found.defects().count(), 0);
    assert!(found.reached.off_degree.is_empty() && found.distance() < 1e-7);
    let names: Vec<&str> = found.mesh.groups().iter().map(|group| group.name.as_str()).collect();
    assert_eq!(
        (names, volume(&found.mesh).map(|v| (v - 1.0).abs() < 1e-9)),
        (vec!["two", "others"], Some(true))
    );
}

#[test]
fn parts_that_touch_in_a_point_are_meshed() {
    let (mut points, mut faces) = cube();
    let count = points.len() as u32;
    points.extend(points.clone().iter().map(|p| *p + DVec3::ONE));
    faces.extend(faces.clone().iter().map(|t| t.map(|v| v + count)));
    let part = mesh((points, faces));
    let found = remesh(&part, &Remesh { size: Some(0.3), ..Remesh::default() }, Progress::NONE);
    let found = found.unwrap();
    assert_eq!(found.defects().collect::<Vec<_>>(), []);
}

#[test]
fn lines_and_names_are_carried_over() {
    // A line across the top of a cube, in two parts, another off all edges, and two named points.
    let (points, faces) = cube();
    let part = mesh((points, faces)).welded(0.0);
    let at = |x: f64, y: f64| {
        let place = DVec3::new(x, y, 1.0);
        part.positions().iter().position(|p| *p == place).unwrap() as u32
    };
    let path = [at(0.0, 0.25), at(0.25, 0.25), at(0.5, 0.25), at(0.5, 0.5), at(0.5, 0.75)];
    let mut segments: Vec<[u32; 2]> = path.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    segments.push([at(0.25, 0.75), at(0.75, 0.25)]);
    let line = |name: &str, segments| Line { name: name.to_owned(), segments, is_straight: false };
    let lines = vec![line("path", 0..3), line("end", 3..4), line("loose", 4..5)];
    let named = |name: &str, vertex| mindeg_mesh::NamedVertex { name: name.to_owned(), vertex };
    let part = part
        .clone()
        .with_lines(lines, segments)
        .unwrap()
        .with_named_vertices(vec![named("gauge", at(0.75, 0.5)), named("start", path[0])])
        .unwrap();
    let wish = Remesh { size: Some(0.1), ..Remesh::default() };
    let found = remesh(&part, &wish, Progress::NONE).unwrap();
    let mesh = &found.mesh;
    assert_eq!(
        (found.defects().count(), found.dropped),
        (0, vec!["lines off the edges of triangles"])
    );
    let names: Vec<_> = mesh.lines().iter().map(|line| line.name.clone()).collect();
    assert_eq!(names, ["path", "end"]);
    let place = |v: u32| mesh.positions()[v as usize];
    for (line, length, ends) in [
        (0, 0.75, [DVec3::new(0.0, 0.25, 1.0), DVec3::new(0.5, 0.5, 1.0)]),
        (1, 0.25, [DVec3::new(0.5, 0.5, 1.0), DVec3::new(0.5, 0.75, 1.0)]),
    ] {
        let range = mesh.lines()[line].segments.clone();
        let own = &mesh.segments()[range.start as usize..range.end as usize];
        assert!(own.windows(2).all(|pair| pair[0][1] == pair[1][0]), "{own:?}");
        let sum: f64 = own.iter().map(|&[a, b]| place(a).distance(place(b))).sum();
        assert!((sum - length).abs() < 1e-12 && own.len() > 1);
        assert_eq!([own[0][0], own[own.len() - 1][1]].map(place), ends);
    }
    let named = mesh.named_vertices();
    assert_eq!(
        (named[0].name.as_str(), place(named[0].vertex)),
        ("gauge", DVec3::new(0.75, 0.5, 1.0))
    );
    assert_eq!(
        (named[1].name.as_str(), place(named[1].vertex)),
        ("start", DVec3::new(0.0, 0.25, 1.0))
    );
}
