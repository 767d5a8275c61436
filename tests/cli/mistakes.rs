//! What users get wrong in their files and numbers: the whole message, which says what is wrong, where, and
//! what to do. [`slips`](super::slips) has the slips of usage.

use crate::mesh::text;
use crate::run::output_of;
use std::fs;
use std::path::Path;
use std::process::Command;

/// The files of a case, the arguments in their folder, the exit code, and what is on standard error.
type Case = (&'static [(&'static str, &'static [u8])], &'static str, i32, &'static str);

const PLATE: (&str, &[u8]) =
    ("plate.json", br#"{"rectangle": {"width": 4, "height": 3}, "size": 1}"#);

const SQUARE: (&str, &[u8]) =
    ("square.obj", b"v 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nf 1 2 3\nf 1 3 4\n");

const MISTAKES: &[Case] = &[
    // A comma as the decimal mark.
    (
        &[("a.json", br#"{"rectangle": {"width": 4,5, "height": 3}, "size": 1}"#)],
        "mesh a.json -o x.obj",
        2,
        "error: a.json: line 1, column 27: a number after a comma, where a key is expected; write \
         decimals with a point\n",
    ),
    (
        &[],
        "mesh --rectangle 4x3 --size 0,5 -o x.obj",
        2,
        "error: invalid value '0,5' for '--size <S>': give a length above 0, such as 0.5; decimals have \
         a point\n\nFor more information, try '--help'.\n",
    ),
    (
        &[],
        "mesh --rectangle 4,5x3 --size 1 -o x.obj",
        2,
        "error: invalid value '4,5x3' for '--rectangle <WxH>': give a width and a height with an x \
         between, such as 4x3; decimals have a point\n\nFor more information, try '--help'.\n",
    ),
    // JSON by hand.
    (
        &[("a.json", br#"{rectangle: {"width": 4, "height": 3}, "size": 1}"#)],
        "mesh a.json -o x.obj",
        2,
        "error: a.json: line 1, column 2: a key must stand in double quotes\n",
    ),
    (
        &[("a.json", br#"{"rectangle": {"width": 4, "height": 3}, "size": 1,}"#)],
        "mesh a.json -o x.obj",
        2,
        "error: a.json: line 1, column 52: a comma without a value after it; remove it\n",
    ),
    (
        &[("a.json", br#"{"rectangle": {"widht": 4, "height": 3}, "size": 1}"#)],
        "mesh a.json -o x.obj",
        2,
        "error: a.json: line 1, column 25, rectangle.widht: unknown key \"widht\"; allowed: \"width\", \
         \"height\", \"origin\", \"rotation\"\n",
    ),
    (
        &[("a.json", br#"{"rectangle": {"width": "4", "height": 3}, "size": 1}"#)],
        "mesh a.json -o x.obj",
        2,
        "error: a.json: line 1, column 25, rectangle.width: found the text \"4\", expected a number\n",
    ),
    (
        &[("a.json", br#"{"rectangle": {"width": 4, "height": 3}, "sides": [{}, {}, {}], "size": 1}"#)],
        "mesh a.json -o x.obj",
        2,
        "error: a.json: line 1, column 51, sides: 3 sides are described and the outline has 4; describe \
         each side once\n",
    ),
    // How editors save text: line ends and a byte order mark are fine, UTF-16 is not.
    (
        &[("a.json", b"\xff\xfe{\x00}\x00")],
        "mesh a.json -o x.obj",
        2,
        "error: a.json: byte 0: this is not UTF-8 text; save the file as UTF-8\n",
    ),
    (
        &[("a.json", b"\xef\xbb\xbf{\"rectangle\": {\"width\": 4, \"height\": 3},\r\n\"size\": 1}\r\n")],
        "mesh a.json -q -o x.obj",
        0,
        "",
    ),
    // A mesh where a domain belongs, and the other way round.
    (
        &[("a.stl", b"solid a\nendsolid a\n")],
        "mesh a.stl -o x.obj",
        2,
        "error: a.stl: it is a mesh, and a domain is expected; of a mesh in the plane, `mindeg convert a.stl \
         -o outline.poly` writes the boundary, which is a domain\n",
    ),
    (
        &[PLATE],
        "inspect plate.json",
        2,
        "error: plate.json: neither the name nor the content tells a mesh format that can be read; the \
         name must end in .obj, .glb, .gltf, .msh, .vtu, .vtk, .ply, .stl, .off, .node, .14, .2dm or \
         .npz\n",
    ),
    (
        &[PLATE, SQUARE],
        "verify plate.json square.obj",
        2,
        "error: plate.json is a domain; swap the two: mindeg verify square.obj plate.json\n",
    ),
    // Another unit of length, and another domain.
    (
        &[("mm.obj", b"v 0 0 0\nv 4000 0 0\nv 4000 3000 0\nv 0 3000 0\nf 1 2 3\nf 1 3 4\n")],
        "verify mm.obj --rectangle 4x3 --intervals 1,1,1,1",
        3,
        "error: mm.obj is no triangulation of the domain: no vertex is at boundary point 1 on side 2, \
         (4, 0): the nearest, vertex 0, is 4 away, and 4.000e-6 is the tolerance; the mesh is 1000 times \
         as large as the domain: is its unit another one?\n",
    ),
    (
        &[SQUARE],
        "verify square.obj --rectangle 4x3 --size 1",
        3,
        "error: square.obj is no triangulation of the domain: no vertex is at boundary point 1 on side \
         1, (1, 0): the nearest, vertex 0, is 1 away, and 4.000e-6 is the tolerance\n",
    ),
    // Degrees, shares and limits.
    (
        &[],
        "mesh --rectangle 4x3 --size 1 --keep-angle 95 -o x.obj",
        2,
        "error: invalid value '95' for '--keep-angle <SHARE>': 95 is more than all of it; for 95 percent \
         write 95%\n\nFor more information, try '--help'.\n",
    ),
    (
        &[],
        "mesh --rectangle 4x3 --size 1 --interior --target-angle 80 -o x.obj",
        2,
        "error: invalid value '80' for '--target-angle <A>': give degrees from 0 to 60; no triangle has \
         only larger angles\n\nFor more information, try '--help'.\n",
    ),
    (
        &[],
        "mesh --rectangle 4x3 --size 1 --max-degree 3 -o x.obj",
        2,
        "error: no mesh of the domain has maximum degree 3; the least is 4\n",
    ),
    // Outlines.
    (
        &[("a.geojson", br#"{"type": "LineString", "coordinates": [[0, 0], [1, 0]]}"#)],
        "mesh a.geojson --size 1 -o x.obj",
        2,
        "error: a.geojson: no Polygon or MultiPolygon, only 1 LineString\n",
    ),
    (
        &[(
            "a.geojson",
            br#"{"type": "Polygon", "coordinates": [[[35.6, 139.7], [35.7, 139.7], [35.7, 139.8], [35.6, 139.7]]]}"#,
        )],
        "mesh a.geojson --size 1 -q -o x.obj",
        0,
        "a.geojson: the second coordinates go up to 139.8, and latitudes to 90: GeoJSON has longitude \
         first\n",
    ),
    (
        &[("a.csv", b"0,0\n4,5,0\n4,5,3\n0,3\n")],
        "mesh a.csv --size 1 -o x.obj",
        2,
        "a.csv: took the points from columns 1 and 2\nerror: a.csv: a: corners 2 and 3 are the \
         same point (4.0, 5.0); give each corner once (the outline closes by itself); --repair parts \
         rings that touch themselves\n",
    ),
    (
        &[],
        "mesh --corners 0,0+4,3+4,0+0,3 --size 1 -o x.obj",
        2,
        "error: interval 3 of side 1 and interval 3 of side 3 cross near (2.0, 1.5); list the points in \
         the order in which they lie around the domain, and keep rings apart\n",
    ),
    // Files.
    (
        &[],
        "inspect missing.obj",
        1,
        "error: cannot read missing.obj: No such file or directory\n",
    ),
    (
        &[PLATE],
        "mesh plate.json -o no/such/x.obj",
        1,
        "error: cannot write no/such/x.obj: No such file or directory; its folder does not exist\n",
    ),
    (
        &[PLATE],
        "mesh plate.json -o .",
        2,
        "error: .: the name tells no format; end it in .obj, .glb, .gltf, .svg, .png, .msh, .vtu, \
         .vtk, .su2, .inp, .ply, .stl, .off, .node, .14, .2dm or .npz, or give --format\n",
    ),
    (
        &[SQUARE],
        "convert square.obj -o square.obj",
        2,
        "error: square.obj is the mesh itself; give another output\n",
    ),
    (
        &[SQUARE],
        "improve square.obj",
        2,
        "error: where to? name a file, such as -o mesh.obj\n",
    ),
    (
        &[("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n")],
        "inspect a.obj",
        2,
        "error: a.obj: line 4: vertex 4 does not exist; the file has 3\n",
    ),
];

#[test]
fn mistakes_are_answered_with_what_and_where_and_what_to_do() {
    assert!(MISTAKES.len() >= 25);
    for &(files, arguments, code, message) in MISTAKES {
        let folder = tempfile::tempdir().expect("a folder");
        for (name, content) in files {
            fs::write(folder.path().join(name), content).expect("a file");
        }
        let (found, errors) = run(folder.path(), arguments);
        assert_eq!((found, errors.as_str()), (Some(code), message), "{arguments}");
    }
}

/// The exit code and standard error of a run in a folder. A + stands for a blank within an argument.
fn run(folder: &Path, arguments: &str) -> (Option<i32>, String) {
    let words = arguments.split(' ').map(|word| word.replace('+', " "));
    let mut command = Command::new(env!("CARGO_BIN_EXE_mindeg"));
    let run = output_of(command.args(words).current_dir(text(folder)));
    (run.status.code(), String::from_utf8_lossy(&run.stderr).into_owned())
}
