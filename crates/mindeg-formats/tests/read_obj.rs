//! The OBJ reader on files of other programs, and on files that are none.

use glam::DVec3;
use mindeg_formats::{ReadError, obj};
use mindeg_mesh::{NonTriangles, TriMesh};

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
        // A quad and a line-continued one.
        ("f 1 2 3 4", &[[0, 1, 2], [0, 2, 3]]),
        ("f 1 2 \\\n 3 \\\r\n 4\nf 2 3 4", &[[0, 1, 2], [0, 2, 3], [1, 2, 3]]),
        // Comments, other keywords, odd spacing, line ends.
        ("# f 9 9 9\nmtllib x y.mtl\nusemtl q\ns off\nf 1 2 3 # 4", &[[0, 1, 2]]),
        ("\t f\t1  2\t3 \r\n\r\nbevel on\nf 1 2 4\r\n", &[[0, 1, 2], [0, 1, 3]]),
        // A vertex used before it is there.
        ("f 1 2 5\nv 7 7 7", &[[0, 1, 4]]),
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
    let text = "\u{feff}v 0.1 -2.5e-7 1e+300\nv 4650000.123456789 0.30000000000000004 -0\n\
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
fn what_is_no_triangle_is_counted() {
    let lines = "f 1 2 3 4\nl 1 2\nl 1 2 3 4 1\nl 3\np 1 2\nf 1 2\nf 3\nf\nf 1 2 3 4 1\nf 1 2 3\n";
    let mesh = read(&format!("{SQUARE}{lines}")).unwrap();
    assert_eq!(mesh.triangles().len(), 2 + 3 + 1);
    let expected = NonTriangles { quads: 1, polygons: 1, line_segments: 6, points: 3 };
    assert_eq!(mesh.non_triangles(), expected);
}

#[test]
fn errors_name_the_line() {
    for (lines, message) in [
        ("f 1 2 3\nf 1 2 5", "line 6: a face names vertex 5, and the file has 4 in all"),
        ("f 1 2 0", "line 5: a face names vertex 0, and vertices count from 1"),
        ("\n\nf -1 -4 -5", "line 7: a face names vertex -5, counted back, and there are 4 so far"),
        ("f 1 two 3", "line 5: the corner \"two\" of a face is not a vertex number"),
        ("f 1 2 /3", "line 5: the corner \"\" of a face is not a vertex number"),
        ("f 1 2 \\\n \\\n x", "line 7: the corner \"x\" of a face is not a vertex number"),
        (
            "f 1 2 99999999999999999999",
            "line 5: the corner \"99999999999999999999\" of a face is not a vertex number",
        ),
        (
            "f 1 2 9223372036854775807",
            "line 5: a face names vertex 9223372036854775807, and the file has 4 in all",
        ),
        (
            "f 1 2 -9223372036854775808",
            "line 5: a face names vertex -9223372036854775808, counted back, and there are 4 so far",
        ),
        ("v 1 2", "line 5: a vertex needs three numbers"),
        ("v 1 2 x\nf 1 2 3", "line 5: a vertex needs three numbers"),
        ("v 1 2 3 0\nf 1 2 3", "line 5: a vertex has the weight 0"),
        (
            "v nan 0 0\nf 1 2 3",
            "vertex 4 (counted from 0) has a coordinate that is not a finite number",
        ),
        (
            "v 1e999 0 0\nf 1 2 3",
            "vertex 4 (counted from 0) has a coordinate that is not a finite number",
        ),
        (
            "l 1 2",
            "the file holds no triangle and no other face (4 vertices, 1 line segments); is it a mesh in this format?",
        ),
    ] {
        let error = read(&format!("{SQUARE}{lines}")).unwrap_err();
        assert_eq!(error.to_string(), message, "{lines:?}");
    }
    let error = obj::read(&b"v 0 0 \xff\nf 1 1 1\n"[..]).unwrap_err();
    assert_eq!(error.to_string(), "line 1: this is not text");
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
