//! Every format that is read and written, through `read` and `Writer`: what is written and read again
//! is the same mesh as far as the format goes, and what is damaged between is an error or another
//! mesh, never a panic.

use glam::DVec3;
use mindeg::{BoundaryMesh, Domain};
use mindeg_formats::{Format, ReadError, WriteOptions, Writer, read, read_as};
use mindeg_mesh::{Group, Line, LineKind, Mesh, Positions, Progress, TriMesh, Triangles};
use proptest::prelude::*;
use std::io::{self, ErrorKind};
use std::path::Path;

/// The formats of this file.
const FORMATS: [Format; 7] = [
    Format::Ply,
    Format::Stl,
    Format::Off,
    Format::Node,
    Format::Fort14,
    Format::Sms2dm,
    Format::Npz,
];

/// The files of a mesh by their extensions.
type Files = Vec<(String, Vec<u8>)>;

fn write(mesh: &dyn Mesh, format: Format, options: WriteOptions) -> Files {
    let writer = Writer::new(format, options, mesh, mesh.triangle_count()).unwrap();
    let paths = format.files(Path::new("mesh").with_extension(format.extension()).as_path());
    let mut files: Files =
        paths.iter().map(|path| (path.display().to_string(), Vec::new())).collect();
    let mut open: Vec<(&str, &mut Vec<u8>)> =
        files.iter_mut().map(|(name, file)| (name.as_str(), file)).collect();
    writer.write(mesh, &mut open, Progress::NONE).unwrap();
    files
}

fn beside(files: &Files) -> impl FnMut(&str) -> io::Result<Vec<u8>> {
    |name| {
        let found = files.iter().find(|(file, _)| file == name);
        found.map(|(_, bytes)| bytes.clone()).ok_or(ErrorKind::NotFound.into())
    }
}

fn read_back(files: &Files) -> Result<TriMesh, ReadError> {
    let (name, bytes) = &files[0];
    read(name.as_ref(), bytes.as_slice(), beside(files))
}

fn exact() -> WriteOptions {
    WriteOptions { double: true, ..WriteOptions::default() }
}

fn positions(mesh: &dyn Mesh) -> Vec<DVec3> {
    mindeg_mesh::filled(0..mesh.vertex_count(), DVec3::ZERO, |first, out| {
        mesh.fill_positions(first, out);
    })
}

fn triangles(mesh: &dyn Mesh) -> Vec<[u32; 3]> {
    mindeg_mesh::filled(0..mesh.triangle_count(), [0; 3], |first, out| {
        mesh.fill_triangles(first, out);
    })
}

fn names(mesh: &dyn Mesh) -> Vec<String> {
    mesh.lines().iter().map(|line| line.name.clone()).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(120))]

    #[test]
    fn what_is_written_is_read(mesh in crate::polygons::meshes()) {
        for format in FORMATS {
            if format == Format::Stl && Writer::new(format, exact(), &mesh, 1).is_err() {
                // Points that 32 bits cannot tell apart.
                continue;
            }
            let files = write(&mesh, format, exact());
            let read = read_back(&files).unwrap();
            let (points, faces) = (positions(&mesh), triangles(&mesh));
            if format == Format::Stl {
                prop_assert_eq!(read.triangles().len(), faces.len());
                for (triangle, face) in read.triangles().iter().zip(&faces) {
                    for (&vertex, &expected) in triangle.iter().zip(face) {
                        let [read, expected] =
                            [read.positions()[vertex as usize], points[expected as usize]];
                        prop_assert_eq!(read, expected.as_vec3().as_dvec3());
                    }
                }
                prop_assert_eq!(read.positions().len(), points.len());
                continue;
            }
            prop_assert_eq!(read.positions(), &points[..], "{:?}", format);
            prop_assert_eq!(read.triangles(), &faces[..], "{:?}", format);
            let lines = match format {
                Format::Node | Format::Npz => names(&mesh),
                // Sides without names are one land boundary.
                Format::Fort14 => vec!["land".to_owned()],
                Format::Sms2dm => {
                    (1..=mesh.lines().len()).map(|i| format!("node string {i}")).collect()
                }
                _ => vec![],
            };
            prop_assert_eq!(names(&read), lines, "{:?}", format);
            if !read.segments().is_empty() {
                let segments = mindeg_mesh::filled(0..mesh.vertex_count(), [0; 2], |first, out| {
                    mesh.fill_segments(first, out);
                });
                prop_assert_eq!(read.segments(), &segments[..], "{:?}", format);
            }
            // The mesh that was read is written to the same bytes, but for names that the format lost.
            let again = read.clone().named(mesh.name().unwrap_or("mesh"));
            if !matches!(format, Format::Sms2dm | Format::Npz) {
                prop_assert_eq!(&write(&again, format, exact()), &files, "{:?}", format);
            }
        }
    }

    #[test]
    fn float_ply_keeps_what_32_bits_can(mesh in crate::polygons::meshes()) {
        if Writer::new(Format::Ply, WriteOptions::default(), &mesh, 1).is_ok() {
            let read = read_back(&write(&mesh, Format::Ply, WriteOptions::default())).unwrap();
            let points = positions(&mesh).into_iter().map(|point| point.as_vec3().as_dvec3());
            prop_assert!(points.eq(read.positions().iter().copied()));
            let far = positions(&mesh).iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
            prop_assert!(read.rounding() >= 0.99 * far / f64::from(1 << 24));
        }
    }
}

/// How a file can be damaged: bits turned over, bytes cut out or doubled, the end missing, digits
/// changed.
fn damaged(mut file: Vec<u8>, damages: &[(u8, usize, usize)]) -> Vec<u8> {
    for &(kind, at, count) in damages {
        let len = file.len();
        if len == 0 {
            break;
        }
        let (at, end) = (at % len, (at % len + count).min(len));
        match kind {
            0 => file[at] ^= 1 << (count % 8),
            1 => drop(file.drain(at..end)),
            2 => {
                let piece = file[at..end].to_vec();
                file.splice(at..at, piece);
            }
            3 => file.truncate(at),
            _ => {
                let digit = (at..len).find(|&i| file[i].is_ascii_digit());
                digit.into_iter().for_each(|i| file[i] = b"0123456789-.e "[count % 14]);
            }
        }
    }
    file
}

/// How files begin.
const STARTS: [&[u8]; 5] = [
    b"",
    b"solid ",
    b"PK\x03\x04",
    b"OFF\n",
    b"ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
      element face 2\nproperty list uchar int vertex_index\nend_header\n",
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn no_damage_makes_a_reader_panic(
        mesh in crate::polygons::meshes(),
        damages in prop::collection::vec((0..5_u8, any::<usize>(), 1..40_usize), 1..4),
        which in 0..3_usize,
    ) {
        for format in FORMATS {
            if format == Format::Stl && Writer::new(format, exact(), &mesh, 1).is_err() {
                continue;
            }
            let mut files = write(&mesh, format, exact());
            let file = which % files.len();
            files[file].1 = damaged(std::mem::take(&mut files[file].1), &damages);
            let input = files[0].1.as_slice();
            if let Ok(mesh) = read_as(format, files[0].0.as_ref(), input, beside(&files)) {
                let _ = mesh.boundary_loops();
            }
        }
    }

    #[test]
    fn no_bytes_make_a_reader_panic(
        bytes in prop::collection::vec(any::<u8>(), 0..300),
        start in prop::sample::select(&STARTS[..]),
    ) {
        let file = [start, &bytes].concat();
        for format in Format::READ {
            let _ = read_as(format, "mesh.x".as_ref(), file.as_slice(), |_| Ok(bytes.clone()));
        }
    }
}

/// The mesh of a text, or its error.
fn outcome(format: Format, text: &str) -> String {
    let no_files = |_: &str| Err(ErrorKind::NotFound.into());
    match read_as(format, "mesh".as_ref(), text.as_bytes(), no_files) {
        Ok(mesh) => {
            let count = mesh.polygons().map_or(mesh.triangles().len(), |polygons| polygons.count());
            format!("{} vertices, {count} faces, {} lines", mesh.vertex_count(), mesh.lines().len())
        }
        Err(error) => error.to_string(),
    }
}

#[test]
fn files_of_other_programs_are_read_and_faults_are_named() {
    const PLY: &str = "ply\r\nformat ascii 1.0\r\ncomment x\r\nelement vertex 4\r\n\
                       property double x\r\nproperty double y\r\nproperty double z\r\n\
                       property uchar red\r\nelement face 1\r\n\
                       property list uchar uint vertex_index\r\nelement edge 1\r\n\
                       property int vertex1\r\nproperty int vertex2\r\nend_header\r\n";
    let ply = |rest: &str| format!("{PLY}0 0 0 1\r\n1 0 0 1\r\n1 1 0 1\r\n0 1 0 1\r\n{rest}");
    let square = "4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    let fort14 = "bay\n1 3\n1 0 0 1\n2 1 0 1\n3 0 1 1\n1 3 1 2 3\n";
    let nodes = "ND 1 0 0 0\nND 5 1 0 0\nND 9 0 1 0\n";
    for (format, file, expected) in [
        (Format::Ply, ply("4 0 1 2 3\r\n0 1\r\n"), "4 vertices, 1 faces, 0 lines"),
        (Format::Ply, ply("3 0 1\r\n0 1\r\n"), "line 19: vertex_index is missing"),
        (
            Format::Ply,
            ply("3 0 1 -1\r\n0 1\r\n"),
            "line 19: vertex -1 does not exist; the file has 4, from 0",
        ),
        (
            Format::Ply,
            ply("3 0 1 2\r\n"),
            "line 20: the file ends before the last row of the element \"edge\"",
        ),
        (Format::Ply, ply("2 0 1\r\n0 1\r\n"), "the mesh has no triangle (4 vertices)"),
        (
            Format::Ply,
            "ply\nformat ascii 1.0\n".into(),
            "line 3: the header of the PLY has no end_header",
        ),
        (
            Format::Ply,
            "ply\nelement face 1\nproperty list float int x\n".into(),
            "line 3: the length of a list is a whole number",
        ),
        (Format::Ply, "ply\nproperty int x\n".into(), "line 2: the property belongs to no element"),
        (Format::Ply, "obj\n".into(), "line 1: a PLY starts with \"ply\""),
        (Format::Off, format!("OFF\n{square}4 0 1 2 3\n"), "4 vertices, 1 faces, 0 lines"),
        (Format::Off, format!("OFF {square}3 0 1 2\n"), "4 vertices, 1 faces, 0 lines"),
        (
            Format::Off,
            format!("# no keyword\n{square}3 0 1 2 # red\n"),
            "4 vertices, 1 faces, 0 lines",
        ),
        (
            Format::Off,
            format!("OFF BINARY\n{square}"),
            "line 1: only text OFF files in three dimensions are read",
        ),
        (Format::Off, format!("OFF\n{square}"), "line 7: the file ends before its last face"),
        (
            Format::Off,
            "OFF\n1 x 0\n".into(),
            "line 2: the number of faces is \"x\", which is not a whole number, 0 or more",
        ),
        (
            Format::Stl,
            "\u{feff}SOLID\n".into(),
            "byte 9: the file ends here; an STL is a text that begins with \"solid\", or has a head of 84 bytes",
        ),
        (
            Format::Stl,
            "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 inf\n".into(),
            "line 4: z is \"inf\", which is not a finite number",
        ),
        (Format::Fort14, fort14.into(), "3 vertices, 1 faces, 0 lines"),
        (
            Format::Fort14,
            format!("{fort14}1 = open\n2 = nodes\n2 = x\n1\n2\n1\n3\n3 1\n1\n2\n3\n"),
            "3 vertices, 1 faces, 2 lines",
        ),
        (
            Format::Fort14,
            format!("{fort14}1\n2\n2\n1\n"),
            "line 11: the file ends before the last vertex of a boundary segment",
        ),
        (
            Format::Fort14,
            format!("{fort14}1\n2\n2\n1\n7\n0\n0\n"),
            "line 11: vertex 7 does not exist; the file has 1 to 3",
        ),
        (Format::Fort14, "\n1 3\n1 0 0\n".into(), "line 3: the depth is missing"),
        (
            Format::Sms2dm,
            format!("MESH2D\nE3T 1 1 5 9 2\nE3T 2 9 5 1 3\n{nodes}"),
            "3 vertices, 2 faces, 0 lines",
        ),
        (
            Format::Sms2dm,
            format!("MESH2D\nE3T 1 1 5 7 2\n{nodes}"),
            "line 2: vertex 7 does not exist",
        ),
        (
            Format::Sms2dm,
            format!("MESH2D\n{nodes}ND 1 2 2 0\n"),
            "two vertices, 0 and 3 (counted from 0), have the number 1",
        ),
        (
            Format::Npz,
            "PK".into(),
            "byte 2: the file has no zip directory; it may have been cut off",
        ),
    ] {
        assert_eq!(outcome(format, &file), expected, "{format:?}: {file}");
    }
}

#[test]
fn values_of_a_ply_that_are_not_read_are_told() {
    let dropped = |vertex: &str, face: &str, values: &str, end: &str| {
        let file = format!(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n{vertex}\
             element face 1\nproperty list uchar int vertex_index\n{face}end_header\n\
             0 0{values}\n1 0{values}\n0 1{values}\n3 0 1 2{end}\n"
        );
        mindeg_formats::ply::read(file.as_bytes()).unwrap().dropped().to_vec()
    };
    assert!(dropped("", "", "", "").is_empty());
    assert!(dropped("property float quality\n", "", " 1", "").is_empty());
    let vertex = "property float nx\nproperty uchar red\n";
    assert_eq!(dropped(vertex, "", " 1 255", ""), ["normals of the file", "colors"]);
    let face = "property list uchar float texcoord\n";
    assert_eq!(dropped("", face, "", " 2 0.5 0.5"), ["texture coordinates"]);
}

#[test]
fn values_that_are_not_read_are_told_by_one_name_in_all_formats() {
    let off = |head: &str, values: &str, end: &str| {
        let file =
            format!("{head}\n3 1 0\n0 0 0{values}\n1 0 0{values}\n0 1 0{values}\n3 0 1 2{end}\n");
        mindeg_formats::off::read(file.as_bytes()).unwrap().dropped().to_vec()
    };
    assert!(off("OFF", "", "").is_empty());
    assert_eq!(off("OFF", "", " 255 0 0"), ["colors"]);
    assert_eq!(
        off("STCNOFF", " 0 0 1 1 1 1 1 0 0", ""),
        ["texture coordinates", "normals of the file", "colors"]
    );
    assert_eq!(off("NOFF", " 0 0 1", ""), ["normals of the file"]);

    let vtk = |data: &str| {
        let file = format!(
            "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n0 0 0 1 0 0 0 1 0\n\
             POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\n{data}"
        );
        mindeg_formats::vtk::read(file.as_bytes()).unwrap().dropped().to_vec()
    };
    assert!(vtk("SCALARS heat double 1\nLOOKUP_TABLE default\n1 2 3\n").is_empty());
    assert_eq!(vtk("NORMALS n double\n0 0 1 0 0 1 0 0 1\n"), ["normals of the file"]);
    assert_eq!(vtk("COLOR_SCALARS c 3\n0 0 0 0 0 0 0 0 0\n"), ["colors"]);
    assert_eq!(vtk("TEXTURE_COORDINATES t 2 double\n0 0 0 0 0 0\n"), ["texture coordinates"]);

    let array =
        |kind: &str, values: &str| format!("<DataArray type=\"{kind}\" {values}</DataArray>");
    let vtu = |data: &str| {
        let file = format!(
            "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"3\" NumberOfCells=\"1\">\
             <PointData {data}></PointData><Points>{}</Points><Cells>{}{}{}</Cells></Piece></UnstructuredGrid></VTKFile>",
            array("Float64", "NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0"),
            array("Int32", "Name=\"connectivity\" format=\"ascii\">0 1 2"),
            array("Int32", "Name=\"offsets\" format=\"ascii\">3"),
            array("UInt8", "Name=\"types\" format=\"ascii\">5"),
        );
        mindeg_formats::vtu::read(file.as_bytes()).unwrap().dropped().to_vec()
    };
    assert!(vtu("Scalars=\"heat\"").is_empty());
    assert_eq!(vtu("Normals=\"n\" TCoords=\"t\""), ["texture coordinates", "normals of the file"]);
}

#[test]
fn faces_that_are_not_convex_are_cut_within() {
    let points = "3 0 0\n3 1 0\n1 1 0\n1 3 0\n0 3 0\n0 0 0\n";
    let file = format!("OFF\n6 1 0\n{points}6 0 1 2 3 4 5\n");
    let mesh = read_as(Format::Off, "l".as_ref(), file.as_bytes(), beside(&Vec::new())).unwrap();
    let areas = mesh.triangles().iter().map(|corners| {
        let [a, b, c] = corners.map(|vertex| mesh.positions()[vertex as usize].truncate());
        (b - a).perp_dot(c - a) / 2.0
    });
    let areas: Vec<f64> = areas.collect();
    assert_eq!((areas.len(), areas.iter().sum::<f64>()), (4, 5.0));
    assert!(areas.iter().all(|&area| area > 0.0), "{areas:?}");
}

/// A reader whose every second call is interrupted by a signal.
struct Interrupted<'a> {
    bytes: &'a [u8],
    is_next: bool,
}

impl std::io::Read for Interrupted<'_> {
    fn read(&mut self, out: &mut [u8]) -> std::io::Result<usize> {
        self.is_next = !self.is_next;
        if self.is_next { Err(ErrorKind::Interrupted.into()) } else { self.bytes.read(out) }
    }
}

#[test]
fn a_signal_while_reading_changes_nothing() {
    for format in FORMATS {
        let files = write(&ring(), format, exact());
        let [plain, interrupted] = [false, true].map(|is_interrupted| {
            let bytes = files[0].1.as_slice();
            let name = files[0].0.as_ref();
            if is_interrupted {
                let reader = Interrupted { bytes, is_next: false };
                mindeg_formats::read(name, reader, beside(&files)).unwrap()
            } else {
                mindeg_formats::read(name, bytes, beside(&files)).unwrap()
            }
        });
        assert_eq!(plain, interrupted, "{format:?}");
    }
}

/// A square of size 3 with a square hole of size 1 in its middle, by eight triangles.
fn ring() -> TriMesh {
    let corners = |a: f64, b: f64| [[a, a], [b, a], [b, b], [a, b]];
    let points: Vec<_> = corners(0.0, 3.0).into_iter().chain(corners(1.0, 2.0)).collect();
    // The hole runs clockwise: 4, 7, 6, 5.
    let points = points.into_iter().map(|[x, y]| DVec3::new(x, y, 0.0)).collect();
    let faces =
        (0..4).flat_map(|i| [[i, (i + 1) % 4, 4 + (i + 1) % 4], [i, 4 + (i + 1) % 4, 4 + i]]);
    let segments = vec![[0, 1], [1, 2], [2, 3], [3, 0], [4, 7], [7, 6], [6, 5], [5, 4]];
    let line = |name: &str, segments| Line { name: name.to_owned(), segments, is_straight: false };
    let lines =
        vec![line("sea", 0..1), line("coast", 1..4), line("rock", 4..6), line("pier", 6..8)];
    let mesh = TriMesh::new(points, faces.collect()).unwrap().named("bay");
    mesh.with_lines(lines, segments).unwrap()
}

fn text(files: &Files, file: usize) -> String {
    String::from_utf8(files[file].1.clone()).unwrap()
}

#[test]
fn sides_without_a_name_of_their_own_are_one_land_boundary() {
    // The outer ring begins within land, and the pier is no bend of it.
    let line = |name: &str, segments| Line { name: name.to_owned(), segments, is_straight: false };
    let names_of = |names: [&str; 6]| {
        let segments = [0..1, 1..2, 2..3, 3..4, 4..7, 7..8];
        let lines = names.iter().zip(segments).map(|(name, segments)| line(name, segments));
        let mesh = ring();
        let segments = mesh.segments().to_vec();
        let kinds = [None, Some(LineKind::Open), None, None, None, None].to_vec();
        let mesh = mesh.with_lines(lines.collect(), segments).unwrap().with_line_kinds(kinds);
        text(&write(&mesh, Format::Fort14, exact()), 0)
    };
    let counted = names_of(["side 1", "mouth", "side 3", "side 4", "hole side 1", "hole side 2"]);
    let tail = "
 2 = number of land boundaries
 8 = number of all nodes of land boundaries
 4 0 = nodes of land boundary 1 (land)
 3
 4
 1
 2
 4 1 = nodes of island boundary 2 (island)
 5
 8
 7
 6
";
    assert!(counted.ends_with(tail), "{counted}");
    let named = names_of(["side 1", "mouth", "pier", "side 4", "rock", "hole side 2"]);
    let tail = "
 2 0 = nodes of land boundary 1 (pier)
 3
 4
 3 0 = nodes of land boundary 2 (land)
 4
 1
 2
 4 1 = nodes of island boundary 3 (rock)
 5
 8
 7
 6
";
    assert!(named.ends_with(tail), "{named}");
}

#[test]
fn holes_are_islands_and_have_a_point_inside() {
    let mesh = ring().with_line_kinds(vec![Some(LineKind::Open), None, None, None]);
    let mesh = mesh.with_depths((0..8).map(f64::from).collect());
    let fort14 = write(&mesh, Format::Fort14, exact());
    // OCSMesh wants nothing but the numbers of elements and of nodes in their line.
    let head = format!("bay\n {} 8\n 1 0", mesh.triangle_count());
    assert!(text(&fort14, 0).starts_with(&head), "{}", text(&fort14, 0));
    let by = concat!(", by mindeg ", env!("CARGO_PKG_VERSION"));
    let tail = "
 2 = number of all nodes of open boundaries
 2 = nodes of open boundary 1 (sea)
 1
 2
 2 = number of land boundaries
 8 = number of all nodes of land boundaries
 4 0 = nodes of land boundary 1 (coast)
 2
 3
 4
 1
 4 1 = nodes of island boundary 2 (rock, pier)
 5
 8
 7
 6
";
    let tail = format!(" 1 = number of open boundaries{by}{tail}");
    assert!(text(&fort14, 0).ends_with(&tail), "{}", text(&fort14, 0));
    let read = read_back(&fort14).unwrap();
    assert_eq!(names(&read), ["sea", "coast", "rock, pier"]);
    let kinds = [LineKind::Open, LineKind::Land, LineKind::Island].map(Some);
    assert_eq!([0, 1, 2].map(|line| read.line_kind(line)), kinds);
    // A pier of the island that is called land leaves it whole.
    let pier = vec![None, None, Some(LineKind::Island), Some(LineKind::Land)];
    let with_pier = write(&ring().with_line_kinds(pier), Format::Fort14, exact());
    let island = " 4 1 = nodes of island boundary 3 (rock, pier)\n 5\n 8\n 7\n 6\n";
    assert!(text(&with_pier, 0).ends_with(island), "{}", text(&with_pier, 0));
    let mut depths = [0.0; 8];
    read.fill_depths(0, &mut depths);
    assert_eq!(depths, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]);
    assert_eq!(write(&read, Format::Fort14, exact()), fort14);

    let triangle = write(&mesh, Format::Node, exact());
    let poly = text(&triangle, 2);
    let (_, hole) = poly.split_once("\n1\n 1 ").unwrap();
    let hole: Vec<f64> = hole.split_whitespace().map(|x| x.parse().unwrap()).collect();
    assert!(hole.iter().all(|&x| 1.0 < x && x < 2.0), "{hole:?}");
    assert!(poly.contains("# marker 4: pier\n0 2 0 1\n8 1\n 1 1 2 1\n"), "{poly}");
    // The marker of a corner is that of the line that begins there.
    let node = text(&triangle, 0);
    let markers: Vec<_> = node.lines().skip(1).map(|line| line.rsplit(' ').next()).collect();
    assert_eq!(markers, ["1", "2", "2", "2", "3", "4", "4", "3"].map(Some));
    assert_eq!(read_back(&triangle).unwrap().segments(), mesh.segments());
}

#[test]
fn depths_are_heights_of_the_bed_in_a_2dm() {
    let mesh = ring().with_depths((0..8).map(f64::from).collect());
    let file = write(&mesh, Format::Sms2dm, exact());
    assert!(text(&file, 0).contains("\nND 3 3 3 -2\n"), "{}", text(&file, 0));
    let read = read_back(&file).unwrap();
    let mut depths = [0.0; 8];
    read.fill_depths(0, &mut depths);
    assert_eq!(depths, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]);
    assert_eq!(read.positions(), mesh.positions());
    // No other file loses them in silence.
    assert!(Format::Obj.leaves_out_depths(&mesh) && !Format::Obj.leaves_out_depths(&ring()));
    assert!(!Format::Sms2dm.leaves_out_depths(&mesh) && !Format::Svg.leaves_out_depths(&mesh));
    // A surface that folds back keeps its place in space.
    let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 1.0], [0.0, 1.0, 2.0], [1.0, 1.0, 3.0]];
    let points = points.map(DVec3::from).to_vec();
    let folded = TriMesh::new(points, vec![[0, 1, 2], [1, 2, 3]]).unwrap();
    let read = read_back(&write(&folded, Format::Sms2dm, exact())).unwrap();
    assert_eq!(read.positions(), folded.positions());
}

#[test]
fn groups_are_materials_and_regions() {
    let group = |name: &str, triangles| Group::new(name, triangles);
    let mesh = ring().with_groups(vec![group("mud", 0..3), group("sand", 3..8)]);
    for (format, name) in [(Format::Sms2dm, "material"), (Format::Node, "region")] {
        let read = read_back(&write(&mesh, format, exact())).unwrap();
        let groups = [group(&format!("{name} 1"), 0..3), group(&format!("{name} 2"), 3..8)];
        assert_eq!(read.groups(), groups, "{format:?}");
    }
}

#[test]
fn node_strings_are_ten_to_a_line() {
    let points = (0..25_u32).map(|i| DVec3::new(f64::from(i), f64::from(i % 2), 0.0)).collect();
    let segments: Vec<_> = (0..24).map(|i| [i, i + 1]).collect();
    let line = Line { name: "long".to_owned(), segments: 0..24, is_straight: false };
    let mesh = TriMesh::new(points, vec![[0, 1, 2]]).unwrap();
    let mesh = mesh.with_lines(vec![line], segments).unwrap();
    let file = write(&mesh, Format::Sms2dm, exact());
    let text = text(&file, 0);
    assert!(text.ends_with("\nNS 11 12 13 14 15 16 17 18 19 20\nNS 21 22 23 24 -25 1\n"), "{text}");
    assert_eq!(read_back(&file).unwrap().segments(), mesh.segments());
}

#[test]
fn formats_for_the_plane_refuse_a_mesh_in_space() {
    let points = vec![DVec3::ZERO, DVec3::X, DVec3::new(0.0, 1.0, 0.5)];
    let mesh = TriMesh::new(points, vec![[0, 1, 2]]).unwrap();
    for format in FORMATS {
        let writer = Writer::new(format, exact(), &mesh, 1);
        let is_planar = matches!(format, Format::Node | Format::Fort14);
        assert_eq!(writer.is_err(), is_planar, "{format:?}");
        if let Err(error) = writer {
            let ending = "holds meshes in the plane, and the z of this one goes from 0 to 0.5; \
                          write .vtu, .ply or .obj instead";
            assert!(error.to_string().ends_with(ending), "{error}");
        }
    }
}

/// Vertices 5 and 19 lie across from one another in the middle of a sliver.
#[test]
fn a_sliver_far_away_is_refused_in_32_bits() {
    let sliver = |x: f64| {
        let json = format!(
            r#"{{"polygon": {{"corners": [[{x}, {x}], [{}, {x}], [{}, {}]]}},
                "sides": [{{"intervals": 10}}, {{"intervals": 1}}, {{"intervals": 16}}]}}"#,
            x + 10.0,
            x + 10.0,
            x + 0.2
        );
        BoundaryMesh::least_degree(&Domain::from_json(&json).unwrap()).unwrap()
    };
    for format in [Format::Ply, Format::Stl] {
        let writer = |x| Writer::new(format, WriteOptions::default(), &sliver(x), 25);
        assert!(writer(0.0).is_ok());
        let error = writer(4_000_000.0).err().unwrap().to_string();
        assert!(error.starts_with("vertices 5 and 19 (counted from 0) at"), "{error}");
    }
}

#[test]
fn damaged_and_compressed_arrays_are_refused() {
    let mesh = ring();
    let file = &write(&mesh, Format::Npz, WriteOptions { fields: false, ..exact() })[0].1;
    let find = |what: &[u8]| file.windows(what.len()).position(|window| window == what).unwrap();
    // A damaged number is found by the check sum.
    let mut damaged = file.clone();
    damaged[find(b"\x93NUMPY") + 140] ^= 1;
    let error = |file: &[u8]| {
        read("m.npz".as_ref(), file, |_| Err(ErrorKind::NotFound.into())).unwrap_err().to_string()
    };
    assert_eq!(error(&damaged), "byte 0: points.npy: the check sum is wrong; the file is damaged");
    let twice = [&file[..], &file[file.len() - 22..]].concat();
    assert_eq!(error(&twice), format!("byte {}: the zip directory ends twice", twice.len()));
    let mut compressed = file.clone();
    compressed[find(b"PK\x01\x02") + 10] = 12;
    let expected = "byte 0: points.npy: the array is compressed by Bzip2; only arrays that are stored \
                    or deflated are read";
    assert_eq!(error(&compressed), expected);
}
