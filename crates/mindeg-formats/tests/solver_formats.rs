//! MSH, VTU, legacy VTK, SU2 and Abaqus input: what is written is read again, and no bytes are a
//! panic.

use glam::DVec3;
use mindeg::{BoundaryMesh, Domain, Side};
use mindeg_formats::{
    Encoding, Format, MshVersion, ReadError, SurfaceOptions, WriteOptions, Writer, msh, read_as,
    vtk, vtu, write,
};
use mindeg_mesh::{Group, Line, Mesh, NamedVertex, Progress, TriMesh, Triangles};
use proptest::prelude::*;

/// Every way to write a format that is read again.
fn ways() -> Vec<(Format, WriteOptions)> {
    let mut ways = Vec::new();
    for encoding in [Encoding::Binary, Encoding::Ascii] {
        for fields in [true, false] {
            let options = WriteOptions { encoding, fields, ..WriteOptions::default() };
            for msh_version in [MshVersion::V4, MshVersion::V2] {
                ways.push((Format::Msh, WriteOptions { msh_version, ..options }));
            }
            ways.push((Format::Vtu, options));
            ways.push((Format::Vtk, options));
        }
    }
    ways
}

fn written(mesh: &dyn Mesh, format: Format, options: WriteOptions) -> Vec<u8> {
    let mut file = Vec::new();
    let writer = Writer::new(format, options, mesh, mesh.triangle_count()).unwrap();
    writer.write(mesh, &mut [("a", &mut file)], Progress::NONE).unwrap();
    file
}

fn read(format: Format, file: &[u8]) -> Result<TriMesh, ReadError> {
    read_as(format, "a".as_ref(), file, |_| Err(std::io::ErrorKind::NotFound.into()))
}

/// A strip in space, in two groups, with three lines, of which two have one name.
fn strip() -> TriMesh {
    let points = (0..8).map(|i| DVec3::new(f64::from(i / 2) / 3.0, f64::from(i % 2), 1e-3 / 7.0));
    let triangles = vec![[0, 2, 1], [2, 3, 1], [2, 4, 3], [4, 5, 3], [4, 6, 5], [6, 7, 5]];
    let group = |name: &str, triangles| Group::new(name, triangles);
    let line = |name: &str, segments| Line { name: name.to_owned(), segments, is_straight: false };
    TriMesh::new(points.collect(), triangles)
        .unwrap()
        .with_groups(vec![group("left part", 0..4), group("rechts \u{e4}", 4..6)])
        .with_lines(
            vec![line("wall", 0..3), line("end", 3..4), line("wall", 4..7)],
            vec![[0, 2], [2, 4], [4, 6], [6, 7], [7, 5], [5, 3], [3, 1]],
        )
        .unwrap()
}

fn names(mesh: &TriMesh) -> Vec<(String, std::ops::Range<u32>)> {
    mesh.lines().iter().map(|line| (line.name.clone(), line.segments.clone())).collect()
}

#[test]
fn what_is_written_is_read_again() {
    let mesh = strip();
    for (format, options) in ways() {
        let file = written(&mesh, format, options);
        let found = read(format, &file).unwrap_or_else(|error| panic!("{format:?}: {error}"));
        let what = format!("{format:?} {options:?}");
        assert_eq!(found.positions(), mesh.positions(), "{what}");
        assert_eq!(found.triangles(), mesh.triangles(), "{what}");
        let has_sides = options.fields || format == Format::Msh;
        if !has_sides {
            assert!(found.segments().is_empty(), "{what}");
            continue;
        }
        if format == Format::Msh {
            // A curve is a line, and its physical group the name.
            assert_eq!(found.segments(), mesh.segments(), "{what}");
            let expected = [("wall", 0..3), ("end", 3..4), ("wall", 4..7)];
            assert_eq!(names(&found), expected.map(|(name, range)| (name.to_owned(), range)));
        } else {
            let segments = [[0, 2], [2, 4], [4, 6], [7, 5], [5, 3], [3, 1], [6, 7]];
            assert_eq!(found.segments(), segments, "{what}");
            let expected =
                if format == Format::Vtk { ["side 1", "side 2"] } else { ["wall", "end"] };
            let expected = expected.into_iter().zip([0..6, 6..7]);
            assert!(names(&found).into_iter().eq(expected.map(|(name, it)| (name.to_owned(), it))));
        }
        let groups: Vec<_> = found.groups().iter().map(|group| group.triangles.clone()).collect();
        assert_eq!(groups, [0..4, 4..6], "{what}");
        if format != Format::Vtk {
            assert_eq!(found.groups()[1].name, "rechts \u{e4}", "{what}");
        }
    }
}

#[test]
fn a_formula_is_written_as_its_list() {
    let domain =
        Domain::rectangle(4.0, 3.0, [20_000, 15_000, 9_000, 14_000].map(Side::count).into())
            .unwrap();
    let mesh = BoundaryMesh::least_degree(&domain).unwrap();
    for (format, options) in ways() {
        let found = read(format, &written(&mesh, format, options)).unwrap();
        assert!(found.triangles().iter().copied().eq(mesh.triangles()), "{format:?}");
        assert!(found.positions().iter().zip(mesh.points()).all(|(a, b)| a.truncate() == b));
        if options.fields {
            assert_eq!(found.lines().len(), 4);
            assert_eq!(found.boundary_loops().len(), 1);
        }
    }
}

#[test]
fn data_are_where_readers_look_for_them() {
    let mesh = strip();
    let ascii = WriteOptions { encoding: Encoding::Ascii, ..WriteOptions::default() };
    let text = |format| String::from_utf8(written(&mesh, format, ascii)).unwrap();
    let file = text(Format::Msh);
    assert!(file.contains("$PhysicalNames\n4\n1 1 \"wall\"\n1 2 \"end\"\n2 3 \"left part\"\n"));
    assert!(
        file.contains("$NodeData\n1\n\"degree\"\n1\n0.0\n3\n0\n1\n8\n1 2\n2 3\n3 4\n"),
        "{file}"
    );
    assert!(file.contains("$ElementData\n1\n\"min_angle\"\n1\n0.0\n3\n0\n1\n13\n1 60\n"), "{file}");
    let file = text(Format::Vtu);
    assert!(
        file.contains("Name=\"side\" format=\"ascii\">\n-1\n-1\n-1\n-1\n-1\n-1\n0\n0\n0\n1\n0\n")
    );
    assert!(file.contains("Name=\"degree\" format=\"ascii\">\n2\n3\n4\n"), "{file}");
    let file = text(Format::Vtk);
    assert!(file.contains("\nCELLS 13 45\n3 0 2 1\n"), "{file}");
}

#[test]
fn markers_of_one_name_are_one() {
    let mut flat = strip().positions().to_vec();
    flat.iter_mut().for_each(|point| point.z = 0.5);
    let strip = strip();
    let mesh = TriMesh::new(flat, strip.triangles().to_vec())
        .unwrap()
        .with_lines(strip.lines().into_owned(), strip.segments().to_vec())
        .unwrap();
    let mut file = Vec::new();
    write(Format::Su2, &mesh, &WriteOptions::default(), &mut file).unwrap();
    let file = String::from_utf8(file).unwrap();
    let markers = "NMARK= 2\nMARKER_TAG= wall\nMARKER_ELEMS= 6\n3 0 2\n3 2 4\n3 4 6\n3 7 5\n3 5 3\n\
                   3 3 1\nMARKER_TAG= end\nMARKER_ELEMS= 1\n3 6 7\n";
    assert!(file.ends_with(markers), "{file}");
}

#[test]
fn sides_of_one_name_are_one_group_in_every_format() {
    let strip = strip();
    let flat = strip.positions().iter().map(|point| DVec3::new(point.x, point.y, 0.0)).collect();
    let named = |vertex| NamedVertex { name: "gauge".to_owned(), vertex };
    let mesh = TriMesh::new(flat, strip.triangles().to_vec())
        .unwrap()
        .with_lines(strip.lines().into_owned(), strip.segments().to_vec())
        .and_then(|mesh| mesh.with_named_vertices(vec![named(2), named(5)]))
        .unwrap();
    let surface = SurfaceOptions { boundary_lines: true, ..SurfaceOptions::default() };
    let encoding = Encoding::Ascii;
    let options = WriteOptions { surface, encoding, ..WriteOptions::default() };
    let text = |format: Format| {
        let mut files = vec![Vec::new(); format.files("a".as_ref()).len()];
        let mut open: Vec<_> = files.iter_mut().map(|file| ("a", file)).collect();
        let writer = Writer::new(format, options, &mesh, mesh.triangle_count()).unwrap();
        writer.write(&mesh, &mut open, Progress::NONE).unwrap();
        String::from_utf8_lossy(&files.concat()).into_owned()
    };
    for (format, expected) in [
        (Format::Msh, &["\n1 1 \"wall\"\n1 2 \"end\"\n", "0 4 \"gauge\"\n"][..]),
        (Format::Su2, &["NMARK= 2\n"]),
        (Format::Inp, &["NSET=wall\n1, 3, 5, 7, 8, 6, 4, 2\n", "NSET=gauge\n3, 6\n"]),
        (Format::Sms2dm, &["NS 1 3 5 -7 1\n", "NS 8 6 4 -2 1\n", "NS 7 -8 2\n"]),
        (Format::Obj, &["o wall\nl 1 3\nl 3 5\nl 5 7\nl 8 6\n", "o end\nl 7 8\n"]),
        (Format::Gltf, &["\"name\": \"wall\""]),
        (Format::Vtu, &["-1\n-1\n0\n0\n0\n1\n0\n0\n0\n"]),
        (Format::Vtk, &["-1\n-1\n0\n0\n0\n1\n0\n0\n0\n"]),
        (
            Format::Node,
            &[
                "# marker 1: wall\n# marker 2: end\n# marker 3: gauge\n",
                " 3 0.3333333333333333 0 3",
            ],
        ),
        (
            Format::Npz,
            &["w\0\0\0a\0\0\0l\0\0\0l\0\0\0", "g\0\0\0a\0\0\0u\0\0\0g\0\0\0e\0\0\0g\0\0\0"],
        ),
    ] {
        let text = text(format);
        let text = text.replace("  ", " ");
        for expected in expected {
            // In glTF a node and its mesh.
            let count = if format == Format::Gltf { 2 } else { 1 };
            assert_eq!(text.matches(expected).count(), count, "{format:?} {expected:?}:\n{text}");
        }
        assert!(!text.contains("wall_2") && !text.contains("wall 2"), "{format:?}");
    }
}

#[test]
fn named_vertices_and_their_physical_points_are_read_again() {
    let named = |name: &str, vertex| NamedVertex { name: name.to_owned(), vertex };
    let points = vec![named("gauge", 3), named("support \u{e4}", 7), named("gauge", 0)];
    let mesh = strip().with_named_vertices(points.clone()).unwrap();
    for (format, options) in ways().into_iter().filter(|(format, _)| *format == Format::Msh) {
        let found = read(format, &written(&mesh, format, options)).unwrap();
        assert_eq!(found.named_vertices()[..], points, "{options:?}");
        assert_eq!(names(&found), names(&mesh), "{options:?}");
    }
}

#[test]
fn markers_and_attributes_of_triangle_keep_their_numbers() {
    let files = |mesh: &TriMesh| {
        let mut files = vec![Vec::new(); 3];
        let mut open: Vec<_> = files.iter_mut().map(|file| ("a", file)).collect();
        let writer = Writer::new(Format::Node, WriteOptions::default(), mesh, 2).unwrap();
        writer.write(mesh, &mut open, Progress::NONE).unwrap();
        files.into_iter().map(|file| String::from_utf8(file).unwrap()).collect::<Vec<_>>()
    };
    let node = "4 2 0 1\n1 0 0 9\n2 1 0 9\n3 1 1 -4\n4 0 1 -4\n";
    let ele = "2 3 1\n1 1 2 3 70\n2 1 3 4 -2\n";
    let poly = "# marker 5: inlet\n0 2 0 1\n4 1\n1 1 2 9\n2 2 3 -4\n3 3 4 5\n4 4 1 9\n0\n";
    let mesh =
        mindeg_formats::triangle::read(node.as_bytes(), ele.as_bytes(), Some(poly.as_bytes()));
    let mesh = mesh.unwrap();
    let lines = files(&mesh);
    assert!(lines[1].contains(" 1 1 2 3 70\n 2 1 3 4 -2\n"), "{}", lines[1]);
    assert!(
        lines[2].contains("# marker 1: inlet\n0 2 0 1\n4 1\n 1 2 3 -4\n 2 3 4 1\n"),
        "{}",
        lines[2]
    );
    for segment in [" 1 2 9\n", " 4 1 9\n"] {
        assert!(lines[2].contains(segment), "{}", lines[2]);
    }
}

#[test]
fn the_names_of_lines_inside_that_a_file_leaves_out_are_given() {
    let points = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
    let names = ["rim", "middle", "rim", "gap"].into_iter().zip([0..2, 2..3, 3..5, 5..6]);
    let line = |(name, segments)| Line { name: String::from(name), segments, is_straight: false };
    let segments = vec![[0, 1], [1, 2], [2, 0], [2, 3], [3, 0], [0, 2]];
    let mesh = TriMesh::new(points.to_vec(), vec![[0, 1, 2], [0, 2, 3]]).unwrap();
    let mesh = mesh.with_lines(names.map(line).collect(), segments).unwrap();
    for (format, left_out) in
        [(Format::Fort14, &["middle", "gap"][..]), (Format::Su2, &[]), (Format::Msh, &[])]
    {
        let writer = Writer::new(format, WriteOptions::default(), &mesh, 2).unwrap();
        let mut file = Vec::new();
        let told = writer.write(&mesh, &mut [("a", &mut file)], Progress::NONE).unwrap();
        assert_eq!(told, left_out, "{format:?}");
        let file = String::from_utf8_lossy(&file);
        assert_eq!(file.contains("middle"), left_out.is_empty(), "{format:?}");
    }
}

#[test]
fn a_mesh_in_space_is_refused_for_the_plane() {
    let points = vec![DVec3::ZERO, DVec3::X, DVec3::Y + DVec3::Z];
    let mesh = TriMesh::new(points, vec![[0, 1, 2]]).unwrap();
    let error = Writer::new(Format::Su2, WriteOptions::default(), &mesh, 1).err().unwrap();
    let error = error.to_string();
    assert!(
        error.starts_with("SU2 holds meshes in the plane") && error.contains("0 to 1"),
        "{error}"
    );
}

#[test]
fn what_other_programs_write_is_read() {
    // As VTK 9.7 writes one triangle: inline base64, appended base64 and zlib.
    for (file, what) in [
        (include_str!("fixtures/vtk-base64.vtu"), "inline base64"),
        (include_str!("fixtures/vtk-zlib.vtu"), "inline zlib"),
        (include_str!("fixtures/vtk-appended-zlib.vtu"), "appended zlib"),
    ] {
        let mesh = vtu::read(file.as_bytes()).unwrap_or_else(|error| panic!("{what}: {error}"));
        assert_eq!(mesh.triangles(), [[0, 1, 2], [0, 2, 3]], "{what}");
        assert_eq!(mesh.positions()[2], DVec3::new(2.0, 1.0, 0.0), "{what}");
    }
    // As Gmsh writes a square: points of the geometry, quadratic elements, and several blocks.
    let mesh = msh::read(&include_bytes!("fixtures/gmsh-square.msh")[..]).unwrap();
    let lines = names(&mesh);
    let found: Vec<_> = lines.iter().map(|(name, range)| (&**name, range.len())).collect();
    assert_eq!(found, [("inlet", 2), ("curve 2", 2), ("wall", 2), ("wall", 2)]);
    assert_eq!(mesh.groups()[0].name, "plate");
    let area: f64 = mesh
        .triangles()
        .iter()
        .map(|corners| {
            let [a, b, c] = corners.map(|vertex| mesh.positions()[vertex as usize].truncate());
            (b - a).perp_dot(c - a) / 2.0
        })
        .sum();
    assert!((area - 1.0).abs() < 1e-12, "{area}");
    let file = "# vtk DataFile Version 5.1\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n\
                0 0 0 1 0 0 1 1 0 0 1 0\nCELLS 3 6\nOFFSETS vtktypeint64\n0 4 6\n\
                CONNECTIVITY vtktypeint64\n0 1 3 2 0 1\nCELL_TYPES 2\n8\n3\n";
    let mesh = vtk::read(file.as_bytes()).unwrap();
    assert_eq!(mesh.polygons().unwrap().corners(0), [0, 1, 2, 3]);
    assert_eq!((mesh.segments(), names(&mesh)), (&[[0, 1]][..], vec![("lines".to_owned(), 0..1)]));
}

/// As meshio writes data: several arrays of bytes in one field.
#[test]
fn fields_of_bytes_follow_one_another() {
    let mut file = b"# vtk DataFile Version 4.2\nx\nBINARY\nDATASET UNSTRUCTURED_GRID\n\
                     POINTS 3 double\n"
        .to_vec();
    for value in [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0_f64] {
        file.extend_from_slice(&value.to_be_bytes());
    }
    let ints = |file: &mut Vec<u8>, head: &str, values: &[i32]| {
        file.extend_from_slice(head.as_bytes());
        values.iter().for_each(|value| file.extend_from_slice(&value.to_be_bytes()));
    };
    ints(&mut file, "\nCELLS 2 7\n", &[3, 0, 1, 2, 2, 0, 1]);
    ints(&mut file, "\nCELL_TYPES 2\n", &[5, 3]);
    ints(&mut file, "\nCELL_DATA 2\nFIELD FieldData 2\nother 1 2 int\n", &[7, 8]);
    ints(&mut file, "\nside 1 2 vtktypeint32\n", &[-1, 4]);
    let mesh = vtk::read(&file[..]).unwrap();
    assert_eq!(names(&mesh), [("side 5".to_owned(), 0..1)]);
}

#[test]
fn errors_say_where() {
    let msh2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 x\n";
    let big =
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 99999999999 1 9\n2 1 0 99999999999\n1\n";
    let vtk_head = "# vtk DataFile Version 4.2\nx\nBINARY\nDATASET UNSTRUCTURED_GRID\n";
    let huge = format!("{vtk_head}POINTS 9000000000000000000 double\n");
    let cut = format!("{vtk_head}POINTS 2 double\n1234");
    for (format, file, message) in [
        (Format::Msh, "$Nodes\n", "line 2: $Nodes has no $EndNodes"),
        (Format::Msh, "", "line 1: $MeshFormat is missing; is it a mesh of Gmsh?"),
        (Format::Msh, "$MeshFormat\n4 0 8\n", "line 2: MSH 4 is not read; save it as 4.1 or 2.2"),
        (Format::Msh, msh2, "line 6: a coordinate is \"x\", which is not a number"),
        (Format::Msh, big, "line 7: the file ends before the tag of a node"),
        (Format::Vtk, &huge, "line 5: no file has so many numbers"),
        (Format::Vtk, &cut, "byte 78: numbers should take 48 bytes; the file has 4 more"),
        (Format::Vtk, "x", "line 1: a legacy VTK file begins with # vtk DataFile Version"),
        (Format::Vtu, "<a/>", "byte 0: no element VTKFile; is it a VTU?"),
        (
            Format::Vtu,
            "<VTKFile type=\"PolyData\">",
            "byte 0: the type of VTK file is \"PolyData\"; only \"UnstructuredGrid\" (.vtu) is read",
        ),
    ] {
        let error = read(format, file.as_bytes()).unwrap_err().to_string();
        assert!(error.starts_with(message), "{error}\n{message}");
    }
}

/// Found by fuzzing: numbers that are appended before the head of the file.
#[test]
fn a_vtu_that_ends_before_it_begins_is_read_without_a_panic() {
    let file = "<!-- <AppendedData>_ --><VTKFile type=\"UnstructuredGrid\" header_type=\"UInt64\">";
    let read = vtu::read(file.as_bytes()).map(|mesh| mesh.triangles().len());
    assert!(matches!(read, Ok(0) | Err(_)), "{read:?}");
}

/// Files of all ways, to be broken.
fn files() -> Vec<(Format, Vec<u8>)> {
    let mesh = strip();
    let ways = ways().into_iter();
    ways.map(|(format, options)| (format, written(&mesh, format, options))).collect()
}

#[test]
fn files_cut_short_are_no_panic() {
    for (format, file) in files() {
        for len in 0..file.len() {
            let _ = read(format, &file[..len]);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    #[test]
    fn any_bytes_are_no_panic(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
        for (format, start) in [
            (Format::Msh, &b"$MeshFormat\n4.1 1 8\n\x01\0\0\0\n$EndMeshFormat\n$Nodes\n"[..]),
            (Format::Msh, b"$MeshFormat\n2.2 1 8\n\x01\0\0\0\n$EndMeshFormat\n$Elements\n"),
            (Format::Vtk, b"# vtk DataFile Version 4.2\nx\nBINARY\nDATASET UNSTRUCTURED_GRID\n"),
            (Format::Vtu, b"<VTKFile type=\"UnstructuredGrid\">"),
        ] {
            let _ = read(format, &bytes);
            let _ = read(format, &[start, &bytes].concat());
        }
    }

    #[test]
    fn broken_files_are_no_panic(
        index in 0_usize..16,
        changes in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        removed in any::<prop::sample::Index>(),
        count in 0_usize..40,
    ) {
        let (format, mut file) = files().swap_remove(index);
        for (place, byte) in changes {
            let place = place.index(file.len());
            file[place] = byte;
        }
        let start = removed.index(file.len());
        file.drain(start..(start + count).min(file.len()));
        let _ = read(format, &file);
    }
}
