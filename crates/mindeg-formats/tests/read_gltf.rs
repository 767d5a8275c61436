//! The glTF reader on files of other programs, and on files that are none.

use base64::Engine;
use glam::DVec3;
use mindeg_formats::{ReadError, gltf};
use mindeg_mesh::{NonTriangles, TriMesh, Triangles};
use serde_json::{Value, json};
use std::io;

fn no_files(_: &str) -> io::Result<Vec<u8>> {
    Err(io::ErrorKind::Unsupported.into())
}

fn read(document: &Value) -> Result<TriMesh, ReadError> {
    gltf::read(document.to_string().as_bytes(), no_files)
}

/// A document with the unit square's corners as positions, and these indices to them.
fn square(indices: &[u16]) -> Value {
    let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0_f32]];
    let mut bytes: Vec<u8> = positions.concat().iter().flat_map(|x| x.to_le_bytes()).collect();
    bytes.extend(indices.iter().flat_map(|i| i.to_le_bytes()));
    let data = base64::engine::general_purpose::STANDARD.encode(&bytes);
    json!({
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "square"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
            {"bufferView": 1, "componentType": 5123, "count": indices.len(), "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": 48},
            {"buffer": 0, "byteLength": 2 * indices.len(), "byteOffset": 48},
        ],
        "buffers": [{
            "byteLength": bytes.len(),
            "uri": format!("data:application/octet-stream;base64,{data}"),
        }],
    })
}

/// The document with the value at a JSON pointer replaced, or put there.
fn with(mut document: Value, pointer: &str, value: Value) -> Value {
    let (parent, key) = pointer.rsplit_once('/').unwrap();
    match document.pointer_mut(parent).unwrap() {
        Value::Object(object) => drop(object.insert(key.to_owned(), value)),
        Value::Array(array) => match key.parse::<usize>() {
            Ok(i) => array[i] = value,
            Err(_) => array.push(value),
        },
        other => panic!("{other}"),
    }
    document
}

const TWO: [u16; 6] = [0, 1, 2, 0, 2, 3];

#[test]
fn every_mode_of_triangles_and_none_of_the_others() {
    for (mode, indices, triangles) in [
        (4, &TWO[..], &[[0, 1, 2], [0, 2, 3]][..]),
        (5, &[0, 1, 3, 2], &[[0, 1, 3], [1, 2, 3]]),
        // A strip that repeats vertices to jump.
        (5, &[0, 1, 3, 3, 1, 1, 3, 2], &[[0, 1, 3], [1, 2, 3]]),
        (6, &[0, 1, 2, 3], &[[1, 2, 0], [2, 3, 0]]),
    ] {
        let mesh =
            read(&with(square(indices), "/meshes/0/primitives/0/mode", json!(mode))).unwrap();
        assert_eq!(mesh.triangles(), triangles, "mode {mode}");
        assert_eq!(mesh.positions()[2], DVec3::new(1.0, 1.0, 0.0));
        assert_eq!((mesh.groups()[0].name.as_str(), mesh.groups().len()), ("square", 1));
    }
    for (mode, line_segments, points) in [(0, 0, 6), (1, 3, 0), (2, 6, 0), (3, 5, 0)] {
        let extra = json!({"attributes": {"POSITION": 0}, "indices": 1, "mode": mode});
        let mesh = read(&with(square(&TWO), "/meshes/0/primitives/-", extra)).unwrap();
        assert_eq!(mesh.triangles().len(), 2);
        let expected = NonTriangles { line_segments, points, ..NonTriangles::default() };
        assert_eq!(mesh.non_triangles(), expected);
    }
}

#[test]
fn indices_of_every_width_or_none() {
    let bytes = square(&[0x0100, 0x0002]);
    let bytes = with(bytes, "/accessors/1/componentType", json!(5121));
    let bytes = with(bytes, "/accessors/1/count", json!(3));
    assert_eq!(read(&bytes).unwrap().triangles(), [[0, 1, 2]]);
    let words = with(square(&[0, 0, 1, 0, 2, 0]), "/accessors/1/componentType", json!(5125));
    let words = with(words, "/accessors/1/count", json!(3));
    assert_eq!(read(&words).unwrap().triangles(), [[0, 1, 2]]);
    let none = with(square(&TWO), "/accessors/0/count", json!(3));
    let none = with(none, "/meshes/0/primitives/0", json!({"attributes": {"POSITION": 0}}));
    assert_eq!(read(&none).unwrap().triangles(), [[0, 1, 2]]);
}

#[test]
fn nodes_move_their_meshes() {
    let placed = |node: Value| {
        let node = with(node, "/mesh", json!(0));
        let mesh = read(&with(square(&TWO), "/nodes/0", node)).unwrap();
        (mesh.positions()[1], mesh.triangles()[0])
    };
    let half = 0.5_f64.sqrt();
    for (node, position, triangle) in [
        (
            json!({"translation": [500_000, 4_650_000, 0.5]}),
            [500_001.0, 4_650_000.0, 0.5],
            [0, 1, 2],
        ),
        (json!({"scale": [3, 2, 1]}), [3.0, 0.0, 0.0], [0, 1, 2]),
        // A quarter turn about z.
        (json!({"rotation": [0, 0, half, half]}), [0.0, 1.0, 0.0], [0, 1, 2]),
        // Mirrored: triangles are turned back.
        (json!({"scale": [-1, 1, 1]}), [-1.0, 0.0, 0.0], [0, 2, 1]),
        (json!({"matrix": [0,2,0,0, -2,0,0,0, 0,0,2,0, 5,6,7,1]}), [5.0, 8.0, 7.0], [0, 1, 2]),
    ] {
        let (found, found_triangle) = placed(node.clone());
        assert!(found.distance(DVec3::from_array(position)) < 1e-9, "{node}: {found}");
        assert_eq!(found_triangle, triangle, "{node}");
    }
    // A parent moves its children; a mesh used twice is there twice, parents first.
    let nodes = json!([
        {"mesh": 0, "name": "parent", "translation": [10, 0, 0], "children": [1, 2]},
        {"mesh": 0, "name": "child", "scale": [2, 2, 2]},
        {"mesh": 0, "name": "second"},
    ]);
    let mesh = read(&with(square(&TWO), "/nodes", nodes)).unwrap();
    // Corners in the same place have the same vertex.
    assert_eq!(mesh.positions().len(), 8);
    assert_eq!(mesh.positions()[1], DVec3::new(11.0, 0.0, 0.0));
    assert_eq!(mesh.positions()[5], DVec3::new(12.0, 0.0, 0.0));
    assert_eq!(mesh.triangles()[2], [4, 5, 6]);
    assert_eq!(mesh.triangles()[4], [0, 1, 2]);
    let names: Vec<_> = mesh.groups().iter().map(|part| part.name.as_str()).collect();
    assert_eq!(names, ["parent", "child", "second"]);
}

#[test]
fn primitives_of_one_node_share_vertices_where_they_share_positions() {
    let extra = json!({"attributes": {"POSITION": 0}, "indices": 1});
    let mesh = read(&with(square(&TWO), "/meshes/0/primitives/-", extra)).unwrap();
    assert_eq!(mesh.positions().len(), 4);
    assert_eq!(mesh.triangles().len(), 4);
}

#[test]
fn without_a_scene_the_nodes_without_a_parent_are_shown() {
    let mut document = square(&TWO);
    document.as_object_mut().unwrap().remove("scene");
    assert_eq!(read(&document).unwrap().triangles().len(), 2);
    document.as_object_mut().unwrap().remove("scenes");
    let nodes = json!([{"mesh": 0}, {"children": [0], "translation": [0, 0, 9]}]);
    let mesh = read(&with(document, "/nodes", nodes)).unwrap();
    assert_eq!(mesh.positions()[0], DVec3::new(0.0, 0.0, 9.0));
}

#[test]
fn sparse_positions_are_patched() {
    let mut document = square(&[0, 1, 2, 2, 0, 0]);
    // The position of vertex 2 (index at byte 52) becomes that of vertex 3.
    document["bufferViews"]
        .as_array_mut()
        .unwrap()
        .push(json!({"buffer": 0, "byteLength": 2, "byteOffset": 52}));
    document["bufferViews"]
        .as_array_mut()
        .unwrap()
        .push(json!({"buffer": 0, "byteLength": 12, "byteOffset": 36}));
    let sparse = json!({"count": 1, "indices": {"bufferView": 2, "componentType": 5123}, "values": {"bufferView": 3}});
    let document = with(document, "/accessors/0/sparse", sparse);
    assert_eq!(read(&document).unwrap().positions()[2], DVec3::Y);
}

#[test]
fn data_comes_from_files_by_their_unescaped_names() {
    let mut document = square(&TWO);
    let uri = document["buffers"][0]["uri"].as_str().unwrap().to_owned();
    let data = uri.rsplit(',').next().unwrap();
    let data = base64::engine::general_purpose::STANDARD.decode(data).unwrap();
    document["buffers"][0]["uri"] = json!("sub/my%20f%C3%BCr.bin");
    let text = document.to_string();
    let mesh = gltf::read(text.as_bytes(), |name| {
        assert_eq!(name, "sub/my für.bin");
        Ok(data.clone())
    });
    assert_eq!(mesh.unwrap().triangles().len(), 2);
    let missing = gltf::read(text.as_bytes(), |_| Err(io::ErrorKind::NotFound.into()));
    assert_eq!(
        missing.unwrap_err().to_string(),
        "the file \"sub/my für.bin\", which this one needs, could not be read: entity not found"
    );
    let short = gltf::read(text.as_bytes(), |_| Ok(data[1..].to_vec()));
    assert_eq!(
        short.unwrap_err().to_string(),
        "buffers[0]: is 60 bytes long, of which 59 are there"
    );
}

#[test]
fn extensions_are_refused_unless_they_leave_geometry_alone() {
    let required = |name: &str| with(square(&TWO), "/extensionsRequired", json!([name]));
    for name in ["KHR_materials_unlit", "KHR_texture_transform", "KHR_mesh_quantization"] {
        assert_eq!(read(&required(name)).unwrap().triangles().len(), 2);
    }
    for (name, what) in [
        ("KHR_draco_mesh_compression", " (triangles compressed by Draco)"),
        ("EXT_meshopt_compression", " (triangles compressed by meshopt)"),
        ("EXT_mesh_gpu_instancing", " (many instances of a mesh)"),
        ("ACME_spheres", ""),
    ] {
        assert_eq!(
            read(&required(name)).unwrap_err().to_string(),
            format!("extensionsRequired[0]: {name}{what} is not read; export the file without it")
        );
    }
    // A texture whose image only an extension knows is no reason.
    let texture = with(required("KHR_texture_basisu"), "/textures", json!([{}]));
    assert!(read(&texture).is_ok());
    // Attributes of an application's own are none either.
    let own = json!({"POSITION": 0, "_BATCH": 0});
    assert!(read(&with(square(&TWO), "/meshes/0/primitives/0/attributes", own)).is_ok());
}

#[test]
fn compressed_triangles_are_refused_by_name_where_there_are_no_others() {
    let draco = json!({"KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {}}});
    let mut document = with(square(&TWO), "/meshes/0/primitives/0/extensions", draco);
    assert!(read(&document).is_ok());
    document["accessors"][0].as_object_mut().unwrap().remove("bufferView");
    assert_eq!(
        read(&document).unwrap_err().to_string(),
        "meshes[0].primitives[0]: is compressed by Draco (KHR_draco_mesh_compression), which is \
         not read; export the file without it"
    );
    let meshopt = json!({"EXT_meshopt_compression": {"buffer": 0}});
    let mut document = with(square(&TWO), "/bufferViews/0/extensions", meshopt);
    assert!(read(&document).is_ok());
    document["buffers"].as_array_mut().unwrap().push(json!({"byteLength": 48}));
    document["bufferViews"][0]["buffer"] = json!(1);
    assert_eq!(
        read(&document).unwrap_err().to_string(),
        "accessors[0]: lies in bufferViews[0], which is compressed by meshopt \
         (EXT_meshopt_compression); export the file without it"
    );
}

#[test]
fn quantized_positions_are_read() {
    let read = |code: u32, normalized: bool, bytes: &[u8]| {
        let data = base64::engine::general_purpose::STANDARD.encode(bytes);
        let accessor = json!({
            "bufferView": 0, "componentType": code, "count": 3, "type": "VEC3",
            "normalized": normalized,
        });
        let document = with(square(&TWO), "/accessors/0", accessor);
        let document = with(document, "/extensionsUsed", json!(["KHR_mesh_quantization"]));
        let view = json!({"buffer": 0, "byteLength": bytes.len(), "byteStride": bytes.len() / 3});
        let document = with(document, "/bufferViews/0", view);
        let primitive = json!({"attributes": {"POSITION": 0}});
        let document = with(document, "/meshes/0/primitives/0", primitive);
        let uri = format!("data:;base64,{data}");
        let buffer = json!({"byteLength": bytes.len(), "uri": uri});
        self::read(&with(document, "/buffers/0", buffer)).unwrap().positions().to_vec()
    };
    let bytes = [0, 1, 2, 0, 127, 128, 129, 0, 255, 254, 253, 0_u8];
    let points = |points: [[f64; 3]; 3]| points.map(DVec3::from_array);
    assert_eq!(
        read(5121, false, &bytes),
        points([[0.0, 1.0, 2.0], [127.0, 128.0, 129.0], [255.0, 254.0, 253.0]])
    );
    assert_eq!(
        read(5120, true, &bytes),
        points([
            [0.0, 1.0 / 127.0, 2.0 / 127.0],
            [1.0, -1.0, -1.0],
            [-1.0 / 127.0, -2.0 / 127.0, -3.0 / 127.0]
        ])
    );
    let words = [0, 1, 32767, 0, 32768, 32769, 65535, 0, 300, 2, 3, 0_u16];
    let bytes: Vec<u8> = words.into_iter().flat_map(u16::to_le_bytes).collect();
    assert_eq!(read(5123, true, &bytes)[0], DVec3::new(0.0, 1.0 / 65535.0, 32767.0 / 65535.0));
    assert_eq!(read(5122, false, &bytes)[1], DVec3::new(-32768.0, -32767.0, -1.0));
    assert_eq!(read(5122, true, &bytes)[1].x, -1.0);
}

#[test]
fn accessors_without_bytes_are_zero_but_for_sparse_items() {
    let mut document = square(&TWO);
    let accessor = document["accessors"][0].as_object_mut().unwrap();
    accessor.remove("bufferView");
    assert!(read(&document).unwrap().positions().iter().all(|point| *point == DVec3::ZERO));
    // Indices 1, 2 (bytes 50 to 54), and the values of vertices 1 and 2.
    for view in [
        json!({"buffer": 0, "byteLength": 4, "byteOffset": 50}),
        json!({"buffer": 0, "byteLength": 24, "byteOffset": 12}),
    ] {
        document["bufferViews"].as_array_mut().unwrap().push(view);
    }
    let sparse = json!({"count": 2, "indices": {"bufferView": 2, "componentType": 5123}, "values": {"bufferView": 3}});
    let mesh = read(&with(document.clone(), "/accessors/0/sparse", sparse)).unwrap();
    assert_eq!(mesh.positions(), [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::ZERO]);
    let beyond = json!({"count": 2, "indices": {"bufferView": 1, "byteOffset": 8, "componentType": 5123}, "values": {"bufferView": 3}});
    let document = with(document, "/accessors/0/count", json!(3));
    let error = read(&with(document, "/accessors/0/sparse", beyond)).unwrap_err();
    assert_eq!(error.to_string(), "accessors[0].sparse: has the index 3, and 3 items");
}

#[test]
fn translations_keep_64_bits() {
    let triangle = json!([{"mesh": 0, "translation": [4650008.1, 0, 0]}, {"mesh": 0, "translation": [4650008.2, 0, 0]}]);
    let document = with(square(&TWO), "/nodes", triangle);
    let document = with(document, "/scenes/0/nodes", json!([0, 1]));
    let mesh = read(&document).unwrap();
    assert_eq!(mesh.positions()[0].x, 4650008.1);
    assert_eq!(mesh.positions()[4].x, 4650008.2);
    let nodes = json!([
        {"translation": [1e8, 16777217, 0], "children": [1, 2]},
        {"mesh": 0, "translation": [-1e8, 0, 0]},
        {"mesh": 0, "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, -99999999,0,0,1]},
    ]);
    let mesh = read(&with(square(&TWO), "/nodes", nodes)).unwrap();
    assert_eq!(mesh.positions()[0], DVec3::new(0.0, 16777217.0, 0.0));
    assert_eq!(mesh.positions()[4], DVec3::new(1.0, 16777217.0, 0.0));
}

#[test]
fn lines_between_vertices_of_triangles_are_kept() {
    // Listed before the surface that they are on.
    let nodes = json!([{"mesh": 1, "name": "edge"}, {"mesh": 0, "name": "square"}]);
    let document = with(square(&TWO), "/nodes", nodes);
    let document = with(document, "/scenes/0/nodes", json!([0, 1]));
    for (mode, segments) in [
        (1, &[[0, 1], [2, 0], [2, 3]][..]),
        (2, &[[0, 1], [1, 2], [2, 0], [0, 2], [2, 3], [3, 0]]),
        (3, &[[0, 1], [1, 2], [2, 0], [0, 2], [2, 3]]),
    ] {
        let line =
            json!({"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "mode": mode}]});
        let mesh = read(&with(document.clone(), "/meshes/-", line)).unwrap();
        assert_eq!(mesh.segments(), segments);
        assert_eq!(Triangles::lines(&mesh)[0].name, "edge");
        assert_eq!(mesh.groups().len(), 1);
    }
}

#[test]
fn values_at_vertices_that_are_not_read_are_told() {
    let dropped = |attributes: Value| {
        let document = with(square(&[0, 1, 2]), "/meshes/0/primitives/0/attributes", attributes);
        read(&document).unwrap().dropped().to_vec()
    };
    assert!(dropped(json!({"POSITION": 0, "_WIND": 0})).is_empty());
    let textures = json!({"POSITION": 0, "TEXCOORD_0": 0, "TEXCOORD_1": 0, "COLOR_0": 0});
    assert_eq!(dropped(textures), ["texture coordinates", "second texture coordinates", "colors"]);
    let normals = json!({"POSITION": 0, "NORMAL": 0, "TANGENT": 0});
    assert_eq!(dropped(normals), ["normals of the file", "tangents"]);
    let skins = json!({"POSITION": 0, "JOINTS_0": 0, "WEIGHTS_0": 0});
    assert_eq!(dropped(skins), ["joints and weights of skins"]);
}

#[test]
fn a_byte_order_mark_is_passed_over() {
    let document = format!("\u{feff}{}", square(&TWO));
    assert!(gltf::read(document.as_bytes(), no_files).is_ok());
}

#[test]
fn versions_follow_the_specification() {
    for (asset, message) in [
        (json!({"version": "2.1"}), ""),
        (json!({"version": "3.0", "minVersion": "2.0"}), ""),
        (json!({"version": "1.0"}), "asset.version: is \"1.0\"; only glTF 2.0 is read"),
        (json!({"version": "3.0"}), "asset.version: is \"3.0\"; only glTF 2.0 is read"),
        (
            json!({"version": "3.0", "minVersion": "3.0"}),
            "asset.minVersion: is \"3.0\"; only glTF 2.0 is read",
        ),
        (
            json!({"version": "2.1", "minVersion": "2.1"}),
            "asset.minVersion: is \"2.1\"; only glTF 2.0 is read",
        ),
    ] {
        let read = read(&with(square(&TWO), "/asset", asset.clone()));
        assert_eq!(read.err().map_or(String::new(), |error| error.to_string()), message, "{asset}");
    }
}

#[test]
fn uris_that_leave_the_folder_are_refused_without_a_look() {
    for (uri, problem) in [
        ("http://x.y/a.bin", "only files beside the .gltf are read"),
        ("file:///etc/passwd", "only files beside the .gltf are read"),
        ("C:/a.bin", "only files beside the .gltf are read"),
        ("", "the name is empty; it must be that of a file beside the .gltf"),
    ] {
        let document = with(square(&TWO), "/buffers/0/uri", json!(uri));
        let resolve = |_: &str| -> io::Result<Vec<u8>> { panic!("nobody is to be asked") };
        let error = gltf::read(document.to_string().as_bytes(), resolve).unwrap_err();
        let expected =
            format!("the file {uri:?}, which this one needs, could not be read: {problem}");
        assert_eq!(error.to_string(), expected);
    }
}

#[test]
fn errors_name_the_place() {
    let huge = json!(u64::MAX - 3);
    for (pointer, value, message) in [
        ("/nodes/0/children", json!([0]), "nodes[0]: is reached twice, and nodes must form trees"),
        ("/scenes/0/nodes", json!([0, 0]), "nodes[0]: is reached twice, and nodes must form trees"),
        (
            "/scenes/0/nodes",
            json!([1]),
            "scenes[0].nodes[0]: names nodes[1], which does not exist; the file has 1",
        ),
        (
            "/nodes/0/mesh",
            json!(7),
            "nodes[0].mesh: names meshes[7], which does not exist; the file has 1",
        ),
        (
            "/nodes/0/mesh",
            json!(1_u64 << 32),
            "nodes[0].mesh: names meshes[4294967296], which does not exist; the file has 1",
        ),
        (
            "/scene",
            json!(1_u64 << 40),
            "scene: names scenes[1099511627776], which does not exist; the file has 1",
        ),
        (
            "/nodes/0/children",
            json!([3]),
            "nodes[0].children[0]: names nodes[3], which does not exist; the file has 1",
        ),
        (
            "/meshes/0/primitives/0/indices",
            json!((1_u64 << 32) + 1),
            "meshes[0].primitives[0].indices: names accessors[4294967297], which does not exist; the file has 2",
        ),
        (
            "/meshes/0/primitives/0/mode",
            json!((1_u64 << 32) + 4),
            "meshes[0].primitives[0].mode: is 4294967300; modes are 0 to 6",
        ),
        (
            "/accessors/1/componentType",
            json!((1_u64 << 32) + 5123),
            "accessors[1]: is used for indices; these must be unsigned integers",
        ),
        (
            "/accessors/0/bufferView",
            json!(1_u64 << 32),
            "accessors[0]: names bufferViews[4294967296], which does not exist; the file has 2",
        ),
        (
            "/bufferViews/0/buffer",
            json!(1_u64 << 32),
            "bufferViews[0].buffer: names buffers[4294967296], which does not exist; the file has 1",
        ),
        (
            "/nodes/0/mesh",
            json!(-1),
            "nodes[0].mesh: found the number -1, expected a whole number that is not negative, in line 1, column C",
        ),
        (
            "/nodes/0/mesh",
            json!(0.5),
            "nodes[0].mesh: found the number 0.5, expected a whole number that is not negative, in line 1, column C",
        ),
        (
            "/nodes/0/mesh",
            json!("x"),
            "nodes[0].mesh: found the text \"x\", expected a whole number that is not negative, in line 1, column C",
        ),
        (
            "/nodes/0/translation",
            json!([0, 0]),
            "nodes[0].translation: found an array of length 2, expected an array of length 3, in line 1, column C",
        ),
        (
            "/nodes/0/scale",
            json!([0, 0, "x"]),
            "nodes[0].scale[2]: found the text \"x\", expected a number, in line 1, column C",
        ),
        ("/nodes", json!(5), "nodes: found the number 5, expected an array, in line 1, column C"),
        (
            "/nodes/0",
            json!(5),
            "nodes[0]: found the number 5, expected an object, in line 1, column C",
        ),
        (
            "/accessors/1",
            json!({"componentType": 5123, "type": "SCALAR"}),
            "accessors[1]: the key \"count\" is missing, in line 1, column C",
        ),
        (
            "/bufferViews/1/byteOffset",
            json!(47),
            "accessors[1]: starts at byte 47 of buffers[0], with 2 bytes from item to item; both must be multiples of 2",
        ),
        (
            "/buffers/0/byteLength",
            json!(1),
            "accessors[0]: lies in bufferViews[0], which reaches beyond buffers[0]",
        ),
        (
            "/nodes/0/rotation",
            json!([0, 0, 0, 0]),
            "nodes[0].rotation: is not a rotation; its length must be 1",
        ),
        (
            "/meshes/0/primitives/0/indices",
            json!(2),
            "meshes[0].primitives[0].indices: names accessors[2], which does not exist; the file has 2",
        ),
        (
            "/meshes/0/primitives/0/attributes/POSITION",
            json!(2),
            "meshes[0].primitives[0].attributes.POSITION: names accessors[2], which does not exist; the file has 2",
        ),
        (
            "/meshes/0/primitives/0/attributes",
            json!({"NORMAL": 0}),
            "meshes[0].primitives[0]: has no positions",
        ),
        (
            "/accessors/0/type",
            json!("VEC2"),
            "accessors[0]: is used for positions; these must be three 32-bit floats",
        ),
        (
            "/accessors/0/componentType",
            json!(5123),
            "accessors[0]: is used for positions; these must be three 32-bit floats",
        ),
        ("/accessors/0/count", json!(5), "accessors[0]: reaches beyond bufferViews[0]"),
        (
            "/accessors/0/count",
            json!(0),
            "accessors[0]: holds no items, and must hold at least one",
        ),
        ("/accessors/0/count", huge.clone(), "accessors[0]: reaches beyond bufferViews[0]"),
        ("/accessors/0/byteOffset", huge.clone(), "accessors[0]: reaches beyond bufferViews[0]"),
        (
            "/accessors/1/componentType",
            json!(5126),
            "accessors[1]: is used for indices; these must be unsigned integers",
        ),
        (
            "/accessors/1/count",
            json!(5),
            "meshes[0].primitives[0]: is a list of triangles with 5 indices, no multiple of 3",
        ),
        (
            "/accessors/0/sparse",
            json!({"count": 9, "indices": {"bufferView": 1, "componentType": 5123}, "values": {"bufferView": 0}}),
            "accessors[0].sparse: reaches beyond bufferViews[1]",
        ),
        (
            "/accessors/0/sparse",
            json!({"count": 0, "indices": {"bufferView": 1, "componentType": 5123}, "values": {"bufferView": 0}}),
            "accessors[0].sparse: holds no items, and must hold at least one",
        ),
        (
            "/bufferViews/0/byteStride",
            json!(8),
            "accessors[0]: has items of 12 bytes, 8 bytes apart",
        ),
        (
            "/bufferViews/0/byteLength",
            huge.clone(),
            "accessors[0]: lies in bufferViews[0], which reaches beyond buffers[0]",
        ),
        (
            "/bufferViews/0/byteOffset",
            huge.clone(),
            "accessors[0]: lies in bufferViews[0], which reaches beyond buffers[0]",
        ),
        (
            "/bufferViews/1/byteOffset",
            json!(50),
            "accessors[1]: lies in bufferViews[1], which reaches beyond buffers[0]",
        ),
        (
            "/buffers/0/byteLength",
            huge,
            "buffers[0]: is 18446744073709551612 bytes long, of which 60 are there",
        ),
        (
            "/buffers/0/uri",
            json!("data:text/plain,abc"),
            "buffers[0].uri: is data that is not in base64; only base64 is read",
        ),
        (
            "/buffers/0/uri",
            json!("data:;base64,@"),
            "buffers[0].uri: is not base64: Invalid symbol 64, offset 0.",
        ),
        (
            "/buffers/0",
            json!({"byteLength": 60}),
            "accessors[0]: lies in buffers[0], which has no data",
        ),
        (
            "/meshes",
            json!([]),
            "nodes[0].mesh: names meshes[0], which does not exist; the file has 0",
        ),
        ("/nodes/0", json!({}), "the mesh has no triangle (0 vertices)"),
    ] {
        let error = read(&with(square(&TWO), pointer, value.clone())).unwrap_err();
        // Where in the line does not matter here.
        let mut found = error.to_string();
        if let Some(column) = found.find(" column ") {
            found.replace_range(column + 8.., "C");
        }
        assert_eq!(found, message, "{pointer} = {value}");
    }
    let error = read(&square(&[0, 1, 4])).unwrap_err();
    assert_eq!(error.to_string(), "meshes[0].primitives[0]: has the index 4, and 4 vertices");
}

#[test]
fn no_file_of_another_kind_passes_for_one() {
    for (bytes, message) in [
        (
            &b""[..],
            "the JSON document: the JSON text ends too early, in line 1, column 1: the file is not whole",
        ),
        (b"v 0 0 0\n", "the JSON document: this is not JSON, in line 1, column 1"),
        (b"{}", "the JSON document: the key \"asset\" is missing, in line 1, column 2"),
        (b"glTF", "the .glb header: the file ends before its header does"),
        (
            b"glTF\x02\0\0\0\x03\0\0\0",
            "the .glb header: the file should be 3 bytes long, and is 12",
        ),
        (
            b"glTF\x02\0\0\0\xff\0\0\0",
            "the .glb header: the file should be 255 bytes long, and is 12",
        ),
        (b"glTF\x01\0\0\0\x0c\0\0\0", "the .glb header: the version is 1; only 2 is read"),
        (b"glTF\x02\0\0\0\x0c\0\0\0", "the .glb container: the first chunk must be JSON"),
        (
            b"glTF\x02\0\0\0\x14\0\0\0\x04\0\0\0JSON",
            "the .glb container: the file ends before its JSON chunk does",
        ),
        (b"{} {}", "the JSON document: the key \"asset\" is missing, in line 1, column 2"),
    ] {
        assert_eq!(gltf::read(bytes, no_files).unwrap_err().to_string(), message);
    }
}
