//! The OBJ reader on files of other programs, and on files that are none.

use glam::DVec3;
use mindeg_formats::{ReadError, obj};
use mindeg_mesh::{NonTriangles, TriMesh, Triangles};

fn read(text: &str) -> Result<TriMesh, ReadError> {
    obj::read(text.as_bytes())
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

#[test]
fn faces_become_triangles_under_the_numbers_of_the_file() {
    for (lines, triangles) in [
        ("f 1 2 3", &[[0, 1, 2]][..]),
        // Not in the order of first use.
        ("f 4 1 3", &[[3, 0, 2]]),
        ("f 3 4 1\nf 2 3 1", &[[2, 3, 0], [1, 2, 0]]),
        // Counted back, with and without the rest.
        ("f -4 -3 -2\nf -2/1/1 -1/2/2 -4/3/3", &[[0, 1, 2], [2, 3, 0]]),
        // Corners that differ in normal or texture coordinates are one vertex.
        ("vn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 3//2 4//2 1//2", &[[0, 1, 2], [2, 3, 0]]),
        ("vt 0 0\nf 1/1 2/1 3/1\nf 3/1 4/1 1/1", &[[0, 1, 2], [2, 3, 0]]),
        // Texture coordinates and normals that are not there do not matter.
        ("f 1/77/99 2/-1/-5 3//-1", &[[0, 1, 2]]),
        ("f 1/ 2// 3", &[[0, 1, 2]]),
        // A quad and a line-continued one.
        ("f 1 2 3 4", &[[0, 1, 2], [0, 2, 3]]),
        ("f 1 2 \\\n 3 \\\r\n 4\nf 2 3 4", &[[0, 1, 2], [0, 2, 3], [1, 2, 3]]),
        // Comments, other keywords, odd spacing, line ends.
        ("# f 9 9 9\nmtllib x y.mtl\nusemtl q\ns off\nf 1 2 3 # 4", &[[0, 1, 2]]),
        ("\t f\t1  2\t3 \r\n\r\nbevel on\nf 1 2 4\r\n", &[[0, 1, 2], [0, 1, 3]]),
        // A vertex used before it is there.
        ("f 1 2 5\nv 7 7 7", &[[0, 1, 4]]),
        // A comment without a blank before it; lines that end as on old Macintoshes.
        ("f 1 2 3#4", &[[0, 1, 2]]),
        ("f 1 2 3\rf 2 3 4\r", &[[0, 1, 2], [1, 2, 3]]),
        // Triangles as degenerate as they come.
        ("f 1 1 1\nf 1 2 3\nf 1 2 3", &[[0, 0, 0], [0, 1, 2], [0, 1, 2]]),
    ] {
        let mesh = read(&format!("{SQUARE}{lines}")).unwrap();
        assert_eq!(mesh.triangles(), triangles, "{lines:?}");
        assert_eq!(mesh.positions()[..4], [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y]);
    }
}

#[test]
fn positions_keep_every_digit_and_every_vertex_its_place() {
    let text = "\u{feff}v 0.1 -2.5e-7 1.e+300\nv 4650000.123456789 0.30000000000000004 -0\n\
                v 9 9 9 # nobody's\nv 2 4 6 2\nv 1 2 3 0.5 0.5 0.5\nv 1 2 3 1 1 1 1\nf 5 2 1";
    let mesh = read(text).unwrap();
    let expected = [
        [0.1, -2.5e-7, 1e300],
        [4650000.123456789, 0.30000000000000004, 0.0],
        [9.0, 9.0, 9.0],
        [1.0, 2.0, 3.0],
        [1.0, 2.0, 3.0],
        [1.0, 2.0, 3.0],
    ];
    assert_eq!(mesh.positions(), expected.map(DVec3::from_array));
    assert_eq!(mesh.triangles(), [[4, 1, 0]]);
}

#[test]
fn parts_are_objects_and_groups_that_have_faces() {
    let lines = "f 1 2 3\no  left wing \nf 1 2 3 4\ng empty\no lines\nl 1 2 3\ng right/1\n\
                 f 1 2 4\nf 2 3 4\n";
    let mesh = read(&format!("{SQUARE}{lines}")).unwrap();
    let parts: Vec<_> =
        mesh.groups().iter().map(|part| (part.name.as_str(), part.triangles.clone())).collect();
    assert_eq!(parts, [("", 0..1), ("left wing", 1..3), ("right/1", 3..5)]);
}

#[test]
fn polygons_are_kept() {
    let text = format!("{SQUARE}v 2 0 0\nf 2 5 3\nf 1 2 3 4\nf 3 2 5\nf 4 1 2 5 3\n");
    let mesh = read(&text).unwrap();
    let polygons = mesh.polygons().unwrap();
    let corners: Vec<&[u32]> = polygons.iter().collect();
    assert_eq!(corners, [&[1, 4, 2][..], &[0, 1, 2, 3], &[2, 1, 4], &[3, 0, 1, 4, 2]]);
    assert_eq!(polygons.triangle_starts, [0, 1, 3, 4, 7]);
    assert_eq!(mesh.triangles().len(), 7);
    // Triangles need no polygons.
    assert!(read(&format!("{SQUARE}f 1 2 3\n")).unwrap().polygons().is_none());
}

#[test]
fn lines_are_kept_under_the_name_of_their_object() {
    let lines = "l 1 2\nf 1 2 3\no eaves\nl 1 2 3/1\nl -1 -2\ng\nl 4 1 2\no eaves\nl 2 3 # end\n";
    let mesh = read(&format!("{SQUARE}{lines}")).unwrap();
    let found: Vec<_> = Triangles::lines(&mesh)
        .iter()
        .map(|line| (line.name.clone(), &mesh.segments()[range(&line.segments)]))
        .collect();
    let expected = [
        ("line", &[[0, 1]][..]),
        ("eaves", &[[0, 1], [1, 2], [3, 2]]),
        ("line", &[[3, 0], [0, 1]]),
        ("eaves", &[[1, 2]]),
    ];
    assert_eq!(found, expected.map(|(name, segments)| (name.to_owned(), segments)));
    assert_eq!(mesh.non_triangles().line_segments, 7);
}

fn range(range: &std::ops::Range<u32>) -> std::ops::Range<usize> {
    range.start as usize..range.end as usize
}

#[test]
fn what_is_no_triangle_is_counted() {
    let lines = "f 1 2 3 4\nl 1 2\nl 1 2 3 4 1\nl 3\np 1 2\nf 1 2\nf 3\nf 1 2 3 4 1\nf 1 2 3\n";
    let mesh = read(&format!("{SQUARE}{lines}")).unwrap();
    assert_eq!(mesh.triangles().len(), 2 + 3 + 1);
    let expected = NonTriangles { quads: 1, polygons: 1, line_segments: 6, points: 4 };
    assert_eq!(mesh.non_triangles(), expected);
}

#[test]
fn errors_name_the_line() {
    for (lines, message) in [
        ("f 1 2 3\nf 1 2 5", "line 6: vertex 5 does not exist; the file has 4"),
        ("f 1 2 0", "line 5: vertex 0 does not exist; numbers start at 1"),
        ("\n\nf -1 -4 -5", "line 7: vertex -5 does not exist; the file has 4 up to this line"),
        ("f 1 2 3\nl 1 99", "line 6: vertex 99 does not exist; the file has 4"),
        ("f 1 2 3\np 77", "line 6: vertex 77 does not exist; the file has 4"),
        ("f", "line 5: a face, line or point names no vertex"),
        ("f 1 2 3\nl # 1 2", "line 6: a face, line or point names no vertex"),
        (
            "f 1 two 3",
            "line 5: the corner \"two\" is not a vertex number, nor several with / between them",
        ),
        (
            "f 1 2 /3",
            "line 5: the corner \"/3\" is not a vertex number, nor several with / between them",
        ),
        (
            "f 1 2 3/x",
            "line 5: the corner \"3/x\" is not a vertex number, nor several with / between them",
        ),
        (
            "f 1 2 3/1/1/1",
            "line 5: the corner \"3/1/1/1\" is not a vertex number, nor several with / between them",
        ),
        (
            "f 1 2 \\\n \\\n x",
            "line 7: the corner \"x\" is not a vertex number, nor several with / between them",
        ),
        (
            "f 1 2 99999999999999999999",
            "line 5: the corner \"99999999999999999999\" is not a vertex number, nor several with / \
             between them",
        ),
        (
            "f 1 2 9223372036854775807",
            "line 5: vertex 9223372036854775807 does not exist; the file has 4",
        ),
        ("f 1 2 4294967297", "line 5: vertex 4294967297 does not exist; the file has 4"),
        (
            "f 1 2 -9223372036854775808",
            "line 5: vertex -9223372036854775808 does not exist; the file has 4 up to this line",
        ),
        ("v 1 2", "line 5: a vertex has three coordinates; found 2"),
        ("v 1 2 x\nf 1 2 3", "line 5: the coordinate \"x\" is not a finite number"),
        ("v 1 2 3 0\nf 1 2 3", "line 5: a vertex divided by its weight is not finite"),
        ("v nan 0 0\nf 1 2 3", "line 5: the coordinate \"nan\" is not a finite number"),
        ("v 1e999 0 0\nf 1 2 3", "line 5: the coordinate \"1e999\" is not a finite number"),
        ("l 1 2", "the mesh has no triangle (4 vertices)"),
    ] {
        let error = read(&format!("{SQUARE}{lines}")).unwrap_err();
        assert_eq!(error.to_string(), message, "{lines:?}");
    }
    let error = obj::read(&b"v 0 0 \xff\nf 1 1 1\n"[..]).unwrap_err();
    assert_eq!(error.to_string(), "line 1: the coordinate \"\u{fffd}\" is not a finite number");
    let mesh = obj::read(&b"# \xe9t\xe9\nv 0 0 0\no \xe9\nf 1 1 1\n"[..]).unwrap();
    assert_eq!(mesh.groups()[0].name, "\u{fffd}");
}

#[test]
fn an_input_that_fails_is_that_error() {
    use std::io::{self, BufReader, Read};
    struct Broken;
    impl Read for Broken {
        fn read(&mut self, _: &mut [u8]) -> io::Result<usize> {
            Err(io::ErrorKind::TimedOut.into())
        }
    }
    let start = "v 0 0 0\nf 1 1 1\n".as_bytes();
    match obj::read(BufReader::new(start.chain(Broken))) {
        Err(ReadError::Io(error)) => assert_eq!(error.kind(), io::ErrorKind::TimedOut),
        other => panic!("{other:?}"),
    }
}

#[test]
fn many_vertices_come_back_in_order() {
    // More than one face over all vertices takes.
    let mut text = String::new();
    for i in 0..10_000 {
        text.push_str(&format!("v {i} 0 {}\n", i % 7));
    }
    text.push_str("f 9999 5 10000\nf 4096 4097 1\n");
    let mesh = read(&text).unwrap();
    assert_eq!(mesh.triangles(), [[9998, 4, 9999], [4095, 4096, 0]]);
    for (i, position) in mesh.positions().iter().enumerate() {
        assert_eq!(*position, DVec3::new(i as f64, 0.0, (i % 7) as f64));
    }
}
