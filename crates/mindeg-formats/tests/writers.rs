//! The writers, byte by byte on a small mesh and by their rules on larger ones.

use glam::DVec3;
use mindeg::{BoundaryMesh, Domain};
use mindeg_formats::{MeshPlane, SurfaceOptions, WriteError, glb, gltf, obj, svg};
use mindeg_mesh::{Group, Line, TriMesh};
use serde_json::Value;
use std::io::{self, Write};

/// A right triangle with five vertices, on which the triangulation leaves no choice.
const GUSSET: &str = r#"{"name": "gusset plate",
    "polygon": {"corners": [[0, 0], [3, 0], [0, 1.5]]},
    "sides": [{"intervals": 3, "name": "bottom"}, {"intervals": 1}, {"intervals": 1, "name": "wall"}]}"#;

fn mesh(json: &str) -> BoundaryMesh {
    BoundaryMesh::least_degree(&Domain::from_json(json).unwrap()).unwrap()
}

fn rectangle(intervals: [u32; 4]) -> BoundaryMesh {
    let sides = intervals.map(|i| format!(r#"{{"intervals": {i}}}"#)).join(",");
    mesh(&format!(r#"{{"rectangle": {{"width": 4, "height": 3}}, "sides": [{sides}]}}"#))
}

fn polygon(corners: &str, intervals: &[u32]) -> BoundaryMesh {
    let sides: Vec<_> = intervals.iter().map(|i| format!(r#"{{"intervals": {i}}}"#)).collect();
    let sides = sides.join(",");
    mesh(&format!(r#"{{"polygon": {{"corners": {corners}}}, "sides": [{sides}]}}"#))
}

const BARE: SurfaceOptions = SurfaceOptions {
    normals: false,
    texture_coordinates: false,
    degree_colors: false,
    boundary_lines: false,
    plane: MeshPlane::Xy,
};

const EVERYTHING: SurfaceOptions = SurfaceOptions {
    normals: true,
    texture_coordinates: true,
    degree_colors: true,
    boundary_lines: true,
    plane: MeshPlane::Floor,
};

fn obj_text(mesh: &BoundaryMesh, options: &SurfaceOptions) -> String {
    let mut out = Vec::new();
    obj::write(mesh, options, &mut out).unwrap();
    String::from_utf8(out).unwrap()
}

fn glb_bytes(mesh: &BoundaryMesh, options: &SurfaceOptions) -> Vec<u8> {
    let mut out = Vec::new();
    glb::write(mesh, options, &mut out).unwrap();
    out
}

/// The document and the binary, each as it stands in the file.
fn chunks(glb: &[u8]) -> (Value, Vec<u8>) {
    let number = |at: usize| u32::from_le_bytes(glb[at..at + 4].try_into().unwrap());
    assert_eq!(&glb[..4], b"glTF");
    assert_eq!(number(4), 2);
    assert_eq!(number(8) as usize, glb.len());
    let json_len = number(12) as usize;
    assert_eq!(&glb[16..20], b"JSON");
    let json = &glb[20..20 + json_len];
    let binary = &glb[20 + json_len..];
    let binary_len = u32::from_le_bytes(binary[..4].try_into().unwrap()) as usize;
    assert_eq!(&binary[4..8], b"BIN\0");
    assert_eq!(binary.len(), 8 + binary_len);
    assert!(json_len.is_multiple_of(4) && binary_len.is_multiple_of(4));
    (serde_json::from_slice(json).unwrap(), binary[8..].to_vec())
}

fn floats(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

fn shorts(values: &[u16]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

#[test]
fn obj_is_as_in_the_fixtures() {
    let mesh = mesh(GUSSET);
    let version = |text: &str| text.replace("VERSION", env!("CARGO_PKG_VERSION"));
    let expected = version(include_str!("fixtures/gusset.obj"));
    assert_eq!(obj_text(&mesh, &SurfaceOptions::default()), expected);
    let expected = version(include_str!("fixtures/gusset_everything.obj"));
    assert_eq!(obj_text(&mesh, &EVERYTHING), expected);
}

#[test]
fn obj_faces_name_what_there_is() {
    for (normals, texture_coordinates, face) in [
        (false, false, "f 1 2 5"),
        (true, false, "f 1//1 2//2 5//5"),
        (false, true, "f 1/1 2/2 5/5"),
        (true, true, "f 1/1/1 2/2/2 5/5/5"),
    ] {
        let options = SurfaceOptions { normals, texture_coordinates, ..BARE };
        let text = obj_text(&mesh(GUSSET), &options);
        let faces: Vec<_> = text.lines().filter(|line| line.starts_with('f')).collect();
        assert!(faces.contains(&face), "{faces:?}");
        assert_eq!(text.contains("\nvn "), normals);
        assert_eq!(text.contains("\nvt "), texture_coordinates);
    }
}

#[test]
fn obj_names_have_no_white_space() {
    for (name, line) in [
        ("two words", "o two_words"),
        ("  f 1\u{2003}2\u{a0} 3 ", "o f_1_2_3"),
        ("Flügel № 3", "o Flügel_№_3"),
    ] {
        let text = obj_text(&mesh(&GUSSET.replace("gusset plate", name)), &BARE);
        assert_eq!(text.lines().nth(2), Some(line), "{name:?}");
    }
}

/// A square of which two sides have names that are one in an OBJ, and the plate is called as the fourth side.
const NAMESAKES: &str = r#"{"name": "side 4", "rectangle": {"width": 4, "height": 3},
    "sides": [{"intervals": 1, "name": "a b"}, {"intervals": 1},
              {"intervals": 1, "name": "a_b"}, {"intervals": 1}]}"#;

#[test]
fn names_that_come_again_get_a_number() {
    let lines = SurfaceOptions { boundary_lines: true, ..BARE };
    let text = obj_text(&mesh(NAMESAKES), &lines);
    let names: Vec<_> = text.lines().filter_map(|line| line.strip_prefix("o ")).collect();
    assert_eq!(names, ["side_4", "a_b", "side_2", "a_b_2", "side_4_2"]);
    let (json, _) = chunks(&glb_bytes(&mesh(NAMESAKES), &lines));
    let mut names: Vec<_> = json["nodes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|node| node["name"].as_str().unwrap())
        .collect();
    names.sort_unstable();
    assert_eq!(names, ["a b", "a_b", "side 2", "side 4", "side 4_2"]);
}

/// A reader that works in 64 bits sees the points where they are, to the last bit of what 32-bit
/// floats keep of them near the middle.
#[test]
fn translations_are_exact_in_64_bits() {
    for (x, y) in [(-3_300_000.3, 0.0), (500_012.7, 4_650_008.1), (1e9 + 7.0, -1e9 - 3.0)] {
        let corners = format!("[[{x}, {y}], [{}, {y}], [{x}, {}]]", x + 7.0, y + 5.0);
        let mesh = polygon(&corners, &[4, 3, 2]);
        let (json, binary) = chunks(&glb_bytes(&mesh, &BARE));
        let moved: [f64; 3] =
            serde_json::from_value(json["nodes"][0]["translation"].clone()).unwrap();
        for (v, bytes) in binary[..12 * 9].chunks(12).enumerate() {
            let at =
                |i: usize| f64::from(f32::from_le_bytes(bytes[4 * i..][..4].try_into().unwrap()));
            let point = mesh.point(v as u32);
            let off = (moved[0] + at(0) - point.x).abs().max((moved[1] + at(1) - point.y).abs());
            // Beyond rounding to 32 bits within the middle 64 of the mesh.
            assert!(off <= 4e-6, "{off} at {point}");
        }
    }
}

#[test]
fn gltf_is_as_in_the_fixture() {
    let mesh = mesh(GUSSET);
    let (mut json, mut bin) = (Vec::new(), Vec::new());
    gltf::write(&mesh, &EVERYTHING, "gusset plate.bin", &mut json, &mut bin).unwrap();
    let expected = include_str!("fixtures/gusset_everything.gltf");
    let expected = expected.replace("VERSION", env!("CARGO_PKG_VERSION"));
    assert_eq!(String::from_utf8(json).unwrap(), expected);

    let arrays = [
        floats(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 2.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0, 0.0, -1.5]),
        floats(&[0.0, 1.0, 0.0].repeat(5)),
        floats(&[0.0, 1.0, 1.0 / 3.0, 1.0, 2.0 / 3.0, 1.0, 1.0, 1.0, 0.0, 0.0]),
        // In linear light: degree 2, 3, 3, 2 and 4.
        [
            [1, 1, 62, 255],
            [53, 0, 100, 255],
            [53, 0, 100, 255],
            [1, 1, 62, 255],
            [133, 10, 59, 255],
        ]
        .concat(),
        shorts(&[0, 1, 4, 1, 2, 4, 2, 3, 4]),
        shorts(&[0, 1, 1, 2, 2, 3]),
        shorts(&[3, 4]),
        shorts(&[4, 0]),
    ];
    assert_eq!(bin, arrays.concat());
}

#[test]
fn glb_is_the_document_and_the_binary() {
    let mesh = mesh(GUSSET);
    for options in [BARE, SurfaceOptions::default(), EVERYTHING] {
        let (mut json, mut bin) = (Vec::new(), Vec::new());
        gltf::write(&mesh, &options, "x.bin", &mut json, &mut bin).unwrap();
        let mut document: Value = serde_json::from_slice(&json).unwrap();
        document["buffers"][0].as_object_mut().unwrap().remove("uri");
        assert_eq!(document["buffers"][0]["byteLength"], bin.len());
        bin.resize(bin.len().next_multiple_of(4), 0);
        assert_eq!(chunks(&glb_bytes(&mesh, &options)), (document, bin));
    }
}

#[test]
fn arrays_follow_one_another_aligned_and_cover_the_binary() {
    for mesh in [mesh(GUSSET), rectangle([3, 3, 2, 2]), rectangle([20_000; 4])] {
        for bits in 0..16 {
            let options = SurfaceOptions {
                normals: bits & 1 != 0,
                texture_coordinates: bits & 2 != 0,
                degree_colors: bits & 4 != 0,
                boundary_lines: bits & 8 != 0,
                plane: MeshPlane::Xy,
            };
            let (json, binary) = chunks(&glb_bytes(&mesh, &options));
            let mut end = 0;
            for view in json["bufferViews"].as_array().unwrap() {
                assert_eq!(view["byteOffset"], end);
                assert!(end % 4 == 0);
                end += view["byteLength"].as_u64().unwrap();
            }
            assert_eq!(json["buffers"][0]["byteLength"], end);
            assert_eq!(binary.len() as u64, end.next_multiple_of(4));
            for accessor in json["accessors"].as_array().unwrap() {
                let size = match accessor["componentType"].as_u64().unwrap() {
                    5121 => 1,
                    5123 => 2,
                    5125 | 5126 => 4,
                    other => panic!("{other}"),
                };
                assert_eq!(accessor["byteOffset"].as_u64().unwrap() % size, 0);
            }
        }
    }
}

#[test]
fn indices_are_wide_from_65536_vertices() {
    for (last, component, size) in [(16_383, 5123, 2), (16_384, 5125, 4)] {
        let mesh = rectangle([16_384, 16_384, 16_384, last]);
        let (json, binary) = chunks(&glb_bytes(&mesh, &BARE));
        assert_eq!(json["accessors"][1]["componentType"], component);
        assert_eq!(json["bufferViews"][1]["byteLength"], mesh.triangle_count() * 3 * size);
        let indices = &binary[12 * mesh.vertex_count() as usize..];
        let greatest = indices[..(mesh.triangle_count() * 3 * size) as usize]
            .chunks(size as usize)
            .map(|bytes| bytes.iter().rev().fold(0, |number, &byte| number << 8 | u32::from(byte)))
            .max();
        assert_eq!(greatest, Some(mesh.vertex_count() - 1));
    }
}

#[test]
fn positions_have_their_range_in_the_document() {
    // Not the range of the points: 0.1 is not a 32-bit float.
    // And -1e-60 is zero there, not negative zero.
    let mesh = polygon("[[0.1, -1e-60], [4.7, -1e-30], [0.3, 2]]", &[3, 4, 5]);
    let (json, binary) = chunks(&glb_bytes(&mesh, &BARE));
    let mut range = [[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]];
    for (i, bytes) in binary[..12 * 12].chunks(4).enumerate() {
        let value = f32::from_le_bytes(bytes.try_into().unwrap());
        assert!(value != 0.0 || value.is_sign_positive());
        range[0][i % 3] = range[0][i % 3].min(value);
        range[1][i % 3] = range[1][i % 3].max(value);
    }
    for (key, values) in ["min", "max"].into_iter().zip(range) {
        let written: Vec<f64> = serde_json::from_value(json["accessors"][0][key].clone()).unwrap();
        assert_eq!(written, values.map(f64::from));
    }
    assert_eq!(
        json["accessors"][0]["min"].to_string(),
        "[0.10000000149011612,-1.0000000031710769e-30,0]"
    );
}

#[test]
fn far_from_the_origin_the_node_carries_the_offset() {
    let corners =
        |x: f64, y: f64| format!("[[{}, {}], [{}, {}], [{}, {}]]", x, y, x + 40.0, y, x, y + 30.0);
    for (x, y, translation) in [
        (0.0, 0.0, None),
        (-100.0, 200.0, None),
        (500_000.25, 4_650_000.25, Some([500_020.25, 4_650_015.0, 0.0])),
        (319.0, -269.0, None),
        (320.0, 0.0, Some([340.0, 0.0, 0.0])),
        (0.0, -300.0, Some([0.0, -285.0, 0.0])),
    ] {
        let mesh = polygon(&corners(x, y), &[4, 4, 4]);
        let (json, binary) = chunks(&glb_bytes(&mesh, &BARE));
        let written: Option<[f64; 3]> =
            serde_json::from_value(json["nodes"][0]["translation"].clone()).unwrap();
        assert_eq!(written, translation);
        let moved = translation.unwrap_or_default();
        for (v, bytes) in binary[..12 * 12].chunks(12).enumerate() {
            let at =
                |i: usize| f64::from(f32::from_le_bytes(bytes[4 * i..][..4].try_into().unwrap()));
            let point = mesh.point(v as u32);
            assert_eq!([moved[0] + at(0), moved[1] + at(1)], [point.x, point.y]);
        }
    }
}

#[test]
fn near_the_origin_the_middle_becomes_the_origin_where_that_keeps_vertices_apart() {
    let width_of = |parameters: &str| {
        mesh(&format!(
            r#"{{"rectangle": {{"width": 4, "height": 3}}, "sides": [
                {{"spacing": {{"parameters": {parameters}}}}},
                {{"intervals": 1}}, {{"intervals": 1}}, {{"intervals": 1}}]}}"#
        ))
    };
    for (parameters, translation) in [
        ("[0.75, 0.750001]", Value::Null),
        // 3 and 3.0000001, which are both 3; but 1 and 1.0000001 are apart.
        ("[0.75, 0.750000025]", serde_json::json!([2.0, 1.5, 0.0])),
    ] {
        let (json, _) = chunks(&glb_bytes(&width_of(parameters), &BARE));
        assert_eq!(json["nodes"][0]["translation"], translation);
    }
}

#[test]
fn gltf_refuses_what_32_bit_floats_cannot_hold() {
    for (corners, intervals, message) in [
        (
            "[[0, 0], [1, 0], [1, 1], [0.999999999, 1.000000001], [0, 1]]",
            &[1; 5][..],
            "vertices 2 and 3 (counted from 0) at (0.999999999, 1.000000001) are too close \
             together for 32-bit floats to tell them apart; use fewer intervals there, or \
             write OBJ, which keeps every digit",
        ),
        (
            // Across the sharp corner between them.
            "[[0, 0], [1, 1], [-2e-9, 2e-9]]",
            &[2, 2, 1],
            "vertices 1 and 3 (counted from 0) at (0.49999999900000003, 0.5000000010000001) are \
             too close together for 32-bit floats to tell them apart; use fewer intervals \
             there, or write OBJ, which keeps every digit",
        ),
        (
            "[[0, 0], [1e39, 0], [0, 1e39]]",
            &[1; 3],
            "vertex 1 (counted from 0) at (1000000000000000000000000000000000000000, 0) is beyond \
             the range of 32-bit floats; scale the domain down, or write OBJ",
        ),
    ] {
        let mesh = polygon(corners, intervals);
        let mut out = Vec::new();
        let error = glb::write(&mesh, &BARE, &mut out).unwrap_err();
        assert_eq!(error.to_string(), message);
        assert!(out.is_empty());
        let error = gltf::write(&mesh, &BARE, "x.bin", &mut out, io::sink()).unwrap_err();
        assert_eq!(error.to_string(), message);
        assert!(out.is_empty());
    }
}

#[test]
fn svg_is_as_in_the_fixture() {
    let mut picture = Vec::new();
    svg::write(&mesh(GUSSET), &mut picture).unwrap();
    let expected = include_str!("fixtures/gusset.svg");
    let expected = expected.replace("VERSION", env!("CARGO_PKG_VERSION"));
    assert_eq!(String::from_utf8(picture).unwrap(), expected);
}

#[test]
fn svg_text_is_escaped() {
    let name = r#"a < b & \"c\" > d\uffff"#;
    let mut picture = Vec::new();
    svg::write(&mesh(&GUSSET.replace("gusset plate", name)), &mut picture).unwrap();
    let picture = String::from_utf8(picture).unwrap();
    assert!(picture.contains("<title id=\"title\">a &lt; b &amp; \"c\" &gt; d\u{fffd}</title>"));
}

#[test]
fn svg_draws_every_interior_edge_once_and_every_vertex_up_to_a_size() {
    for (intervals, edges, dots, refused) in [
        ([1, 1, 1, 1], 1, 4 + 2, false),
        ([3, 3, 2, 2], 7, 10 + 3, false),
        ([1250; 4], 4997, 5000 + 3, false),
        ([1250, 1250, 1250, 1251], 4998, 0, false),
        ([25_000; 4], 99_997, 0, false),
        ([25_000, 25_000, 25_001, 25_000], 0, 0, true),
    ] {
        let mut picture = Vec::new();
        let result = svg::write(&rectangle(intervals), &mut picture);
        let picture = String::from_utf8(picture).unwrap();
        if refused {
            let message = "an SVG shows 100000 vertices at most, and this mesh has 100001; write \
                           OBJ or glTF, or use fewer intervals";
            assert_eq!(result.unwrap_err().to_string(), message);
            assert!(picture.is_empty());
        } else {
            result.unwrap();
            let path = picture.lines().find(|line| line.starts_with("<path class=\"edge\""));
            assert_eq!(path.unwrap().matches('M').count(), edges, "{intervals:?}");
            assert_eq!(picture.matches("<circle").count(), dots, "{intervals:?}");
            assert_eq!(picture.contains("<path class=\"shade\""), dots > 0, "{intervals:?}");
        }
    }
}

#[test]
fn svg_colors_groups_by_name_and_draws_lines_inside() {
    let points = [(0, 0), (1, 0), (2, 0), (2, 1), (1, 1), (0, 1)];
    let points = points.map(|(x, y)| DVec3::new(f64::from(x), f64::from(y), 0.0)).to_vec();
    let triangles = vec![[0, 1, 4], [0, 4, 5], [1, 2, 3], [1, 3, 4]];
    let picture_of = |groups: &[(&str, std::ops::Range<u32>)]| {
        let line = |name: &str, segments| Line { name: name.into(), segments, is_straight: true };
        let lines = vec![line("wall", 0..2), line("interface", 2..3)];
        let groups = groups.iter().map(|(name, range)| Group::new(*name, range.clone())).collect();
        let mesh = TriMesh::new(points.clone(), triangles.clone()).unwrap();
        let mesh =
            mesh.with_groups(groups).with_lines(lines, vec![[0, 1], [1, 2], [1, 4]]).unwrap();
        let mut picture = Vec::new();
        svg::write(&mesh, &mut picture).unwrap();
        String::from_utf8(picture).unwrap()
    };
    let picture = picture_of(&[("sand", 0..1), ("clay", 1..2), ("sand", 2..4)]);
    assert_eq!(picture.matches("hsl(0,60%,50%)").count(), 2);
    assert_eq!(picture.matches("hsl(137,60%,50%)").count(), 1);
    let inner = picture.lines().find(|line| line.starts_with("<path class=\"outline\""));
    assert_eq!(inner.unwrap().matches('M').count(), 1);
    assert!(!picture_of(&[("sand", 0..4)]).contains("hsl"));
}

/// A writer that takes so many bytes and then fails.
struct Full(usize);

impl Write for Full {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.0.min(bytes.len()) {
            0 if !bytes.is_empty() => Err(io::ErrorKind::StorageFull.into()),
            taken => {
                self.0 -= taken;
                Ok(taken)
            }
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_writer_that_fails_ends_the_writing_with_its_error() {
    let mesh = rectangle([30, 20, 30, 20]);
    let storage_full = |error: WriteError| match error {
        WriteError::Io(error) => error.kind() == io::ErrorKind::StorageFull,
        _ => false,
    };
    for room in [0, 1, 50, 500, 2000, 4000] {
        let error = obj::write(&mesh, &EVERYTHING, Full(room)).unwrap_err();
        assert_eq!(error.kind(), io::ErrorKind::StorageFull);
        assert!(storage_full(glb::write(&mesh, &EVERYTHING, Full(room)).unwrap_err()));
        assert!(storage_full(svg::write(&mesh, Full(room)).unwrap_err()));
        let write_gltf = |json, bin| gltf::write(&mesh, &EVERYTHING, "x.bin", json, bin);
        assert!(storage_full(write_gltf(Full(room), Full(usize::MAX)).unwrap_err()));
        assert!(storage_full(write_gltf(Full(usize::MAX), Full(room)).unwrap_err()));
    }
}
