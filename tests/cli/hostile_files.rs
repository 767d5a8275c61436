//! Files that promise far more than they hold: refused for what is missing, in little memory.

use crate::run::shell;
use std::fs;
use std::path::Path;

/// A gigabyte of addresses; each of the files below promises at least ten times as much.
const LIMIT: &str = "ulimit -c 0; ulimit -v 1000000; ";

/// A `.glb` of this document and so many zeros.
fn glb(document: &str, zeros: usize) -> Vec<u8> {
    let padding = document.len().next_multiple_of(4) - document.len();
    let json = document.to_owned() + &" ".repeat(padding);
    let chunk = |kind: &[u8; 4], bytes: &[u8]| -> Vec<u8> {
        [&(bytes.len() as u32).to_le_bytes(), &kind[..], bytes].concat()
    };
    let chunks = [chunk(b"JSON", json.as_bytes()), chunk(b"BIN\0", &vec![0; zeros])].concat();
    let len = chunks.len() as u32 + 12;
    [b"glTF", &2_u32.to_le_bytes()[..], &len.to_le_bytes(), &chunks].concat()
}

/// A document of one mesh with these accessors, shown by so many nodes.
fn document(accessors: &str, indices: &str, nodes: usize) -> String {
    let nodes: Vec<String> =
        (0..nodes).map(|i| format!(r#"{{"mesh": 0, "translation": [{i}, 0, 0]}}"#)).collect();
    format!(
        r#"{{"asset": {{"version": "2.0"}}, "buffers": [{{"byteLength": 36000}}],
            "bufferViews": [{{"buffer": 0, "byteLength": 36000}}], "accessors": [{accessors}],
            "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}{indices}}}]}}],
            "nodes": [{}]}}"#,
        nodes.join(",")
    )
}

fn vectors(count: u64, view: &str) -> String {
    format!(r#"{{{view}"componentType": 5126, "count": {count}, "type": "VEC3"}}"#)
}

fn meshes() -> Vec<(&'static str, Vec<u8>)> {
    const VIEW: &str = r#""bufferView": 0, "#;
    let stl = [&[0; 80][..], &4_000_000_000_u32.to_le_bytes(), &[0; 50]].concat();
    let scalars = r#", {"componentType": 5125, "count": 4000000000, "type": "SCALAR"}"#;
    let ply = |format: &str, list: &str, body: &[u8]| {
        let head = format!(
            "ply\nformat {format} 1.0\nelement vertex 4000000000\nproperty float x\nproperty float \
             y\nproperty float z\nelement face 4000000000\nproperty list {list} vertex_indices\n\
             end_header\n"
        );
        [head.as_bytes(), body].concat()
    };
    let msh2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4000000000\n1 0 0 0\n";
    let msh4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 4000000000 1 4000000000\n2 1 0 \
                4000000000\n1\n";
    let entities = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n1000000000000 0 0 0\n1 0 0 0 \
                    1000000000000 1\n";
    let binary_msh = [
        &b"$MeshFormat\n4.1 1 8\n"[..],
        &1_u32.to_le_bytes(),
        b"\n$EndMeshFormat\n$Nodes\n",
        &[1_u64 << 40, 1 << 40, 1, 1 << 40].map(u64::to_le_bytes).concat(),
    ]
    .concat();
    let vtk = |encoding: &str, what: &str| {
        format!(
            "# vtk DataFile Version 3.0\nx\n{encoding}\nDATASET UNSTRUCTURED_GRID\n{what}\n0 0 0\n"
        )
    };
    let vtu = |data: &str| {
        format!(
            r#"<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian"
                header_type="UInt64" compressor="vtkZLibDataCompressor"><UnstructuredGrid>
                <Piece NumberOfPoints="4000000000" NumberOfCells="4000000000"><Points>
                <DataArray type="Float64" NumberOfComponents="3" {data}</DataArray></Points>
                </Piece></UnstructuredGrid></VTKFile>"#
        )
    };
    // Base64 of three lengths of 8 bytes: 2^40 blocks of 2^40 bytes.
    let blocks = r#"format="binary">AAAAAAABAAAAAAAAAAEAAAAAAAAAAQAA"#;
    vec![
        ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4000000000\n".to_vec()),
        ("a.stl", stl),
        ("text.ply", ply("ascii", "uchar uint", b"0 0 0\n")),
        ("a.ply", ply("binary_little_endian", "uint uint", &[0xff; 200])),
        ("a.off", b"OFF\n4000000000 4000000000 0\n0 0 0\n".to_vec()),
        ("a.node", b"4000000000 2 0 0\n1 0 0\n".to_vec()),
        ("a.grd", b"grid\n4000000000 4000000000\n1 0 0 0\n".to_vec()),
        ("two.msh", msh2.as_bytes().to_vec()),
        ("four.msh", msh4.as_bytes().to_vec()),
        ("entities.msh", entities.as_bytes().to_vec()),
        ("binary.msh", binary_msh),
        ("points.vtk", vtk("ASCII", "POINTS 4000000000 double").into_bytes()),
        ("binary.vtk", vtk("BINARY", "POINTS 4000000000 double").into_bytes()),
        ("cells.vtk", vtk("ASCII", "POINTS 1 float\n0 0 0\nCELLS 4000000000 16000000000").into()),
        ("blocks.vtu", vtu(blocks).into_bytes()),
        ("text.vtu", vtu(r#"format="ascii">0 0 0"#).into_bytes()),
        ("points.glb", glb(&document(&vectors(4_000_000_000, VIEW), "", 1), 36_000)),
        // Without a buffer view, an accessor is all zeros, and so long as it says.
        ("zeros.glb", glb(&document(&vectors(4_000_000_000, ""), "", 1), 36_000)),
        (
            "indices.glb",
            glb(&document(&(vectors(3, VIEW) + scalars), r#", "indices": 1"#, 1), 36_000),
        ),
        // A thousand triangles, shown at ten thousand positions.
        ("copies.glb", glb(&document(&vectors(3_000, VIEW), "", 10_000), 36_000)),
    ]
}

#[track_caller]
fn is_refused(folder: &Path, command: &str, file: &str) {
    let run = shell(folder, &format!("{LIMIT}exec \"$MINDEG\" {command}"));
    assert_eq!(run.code, Some(2), "{command}: {run:?}");
    assert!(run.errors.contains(file), "{command}: {}", run.errors);
    assert!(!run.errors.contains("memory"), "{command}: {}", run.errors);
}

#[test]
fn meshes_that_promise_billions_are_refused_in_little_memory() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("a.ele"), "4000000000 3 0\n").expect("a file");
    for (name, bytes) in meshes() {
        fs::write(folder.path().join(name), bytes).expect("a file");
        is_refused(folder.path(), &format!("inspect {name}"), name);
    }
}

#[test]
fn outlines_that_promise_billions_are_refused_in_little_memory() {
    let folder = tempfile::tempdir().expect("a folder");
    let msh = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 4000000000 1 4000000000\n1 1 0 \
               4000000000\n1\n";
    let hole =
        r#""holes": [{"polygon": {"corners": [[1, 1], [2, 1], [2, 2]]}, "sides": 4000000000}]"#;
    let far = "{\"rectangle\": {\"width\": 9, \"height\": 9}, \"sides\": ".to_owned();
    for (name, text) in [
        ("a.poly", "4000000000 2 0 0\n1 0 0\n".to_owned()),
        ("lines.poly", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n4000000000 0\n1 1 2\n".to_owned()),
        ("a.msh", msh.to_owned()),
        (
            "hole.json",
            format!("{{\"rectangle\": {{\"width\": 9, \"height\": 9}}, \"size\": 1, {hole}}}"),
        ),
        (
            "arc.json",
            far + "[{\"intervals\": 4000000000, \"arc\": {\"through\": [4, -1]}}, {}, {}, {}]}",
        ),
    ] {
        fs::write(folder.path().join(name), text).expect("a file");
        is_refused(folder.path(), &format!("mesh {name} -q -o x.obj"), name);
    }
    // Everything a run may write was refused before.
    assert!(!folder.path().join("x.obj").exists());
}

#[test]
fn a_buffer_that_is_named_twice_is_read_once() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("a.bin"), vec![0; 1 << 20]).expect("a file");
    // Ten thousand names of one file of a megabyte.
    let buffer =
        |i: usize| format!(r#"{{"byteLength": 1048576, "uri": "{}a.bin"}}"#, "./".repeat(i % 99));
    let buffers: Vec<String> = (0..10_000).map(buffer).collect();
    let document =
        format!(r#"{{"asset": {{"version": "2.0"}}, "buffers": [{}]}}"#, buffers.join(","));
    fs::write(folder.path().join("a.gltf"), document).expect("a file");
    is_refused(folder.path(), "inspect a.gltf", "named a second time");
}

#[cfg(target_os = "linux")]
#[test]
fn what_never_ends_is_refused_in_little_memory() {
    let folder = tempfile::tempdir().expect("a folder");
    std::os::unix::fs::symlink("/dev/zero", folder.path().join("z.json")).expect("a link");
    for command in
        ["domain z.json", "degree z.json", "mesh z.json -q -o x.obj", "domain - < /dev/zero"]
    {
        is_refused(folder.path(), command, "its first 4096 bytes are 0");
    }
}
