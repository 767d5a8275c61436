//! Materials: from files into groups, and back.

use std::io;
use std::ops::Range;
use std::sync::Arc;

use glam::DVec3;
use mindeg_formats::{Format, SurfaceOptions, WriteOptions, Writer, glb, obj, read};
use mindeg_mesh::{Group, Material, Progress, TriMesh};

fn group(name: &str, triangles: Range<u32>, material: Option<(&str, Option<[f32; 4]>)>) -> Group {
    let material = material.map(|(name, color)| Material { name: name.to_owned(), color });
    Group::new(name, triangles).of_material(material.map(Arc::new))
}

/// A strip of triangles in space, in these groups.
fn strip(groups: Vec<Group>) -> TriMesh {
    let count = groups.last().unwrap().triangles.end;
    let point = |i: u32| DVec3::new(f64::from(i), f64::from(i % 2), f64::from(i * i));
    let triangle = |i: u32| if i.is_multiple_of(2) { [i, i + 1, i + 2] } else { [i + 1, i, i + 2] };
    let points = (0..count + 2).map(point).collect();
    TriMesh::new(points, (0..count).map(triangle).collect()).unwrap().with_groups(groups)
}

/// The files of a mesh, each with its name.
fn written(mesh: &TriMesh, format: Format) -> Vec<(String, Vec<u8>)> {
    let options = WriteOptions::default();
    let writer = Writer::new(format, options, mesh, mesh.triangles().len() as u32).unwrap();
    let path = std::path::Path::new("part").with_extension(format.extension());
    let mut paths = format.files(&path);
    paths.extend(format.material_library(&path));
    let names: Vec<String> = paths.iter().map(|path| path.display().to_string()).collect();
    let mut contents = vec![Vec::new(); names.len()];
    let mut files: Vec<(&str, &mut Vec<u8>)> =
        names.iter().map(|name| &**name).zip(&mut contents).collect();
    writer.write(mesh, &mut files, Progress::NONE).unwrap();
    names.into_iter().zip(contents).collect()
}

fn read_again(files: &[(String, Vec<u8>)]) -> TriMesh {
    let beside = |name: &str| {
        let found = files.iter().find(|file| file.0 == name);
        found.map(|file| file.1.clone()).ok_or(io::ErrorKind::NotFound.into())
    };
    read(files[0].0.as_ref(), &files[0].1[..], beside).unwrap()
}

const BRICK: Option<(&str, Option<[f32; 4]>)> = Some(("brick", Some([0.5, 0.25, 0.125, 1.0])));
const GLASS: Option<(&str, Option<[f32; 4]>)> = Some(("glass", Some([0.1, 0.2, 0.3, 0.5])));

#[test]
fn groups_and_materials_survive() {
    for groups in [
        vec![group("walls", 0..1, BRICK), group("walls", 1..3, GLASS), group("roof", 3..4, BRICK)],
        vec![group("walls", 0..1, None), group("walls", 1..3, GLASS), group("roof", 3..4, None)],
        vec![group("walls", 0..2, BRICK), group("walls", 2..3, None)],
        vec![group("walls", 0..4, GLASS)],
        vec![group("a", 0..1, BRICK), group("b", 1..2, BRICK), group("a.2", 2..3, BRICK)],
    ] {
        let mesh = strip(groups.clone());
        for format in [Format::Obj, Format::Glb, Format::Gltf] {
            let again = read_again(&written(&mesh, format));
            assert_eq!(again.groups(), groups, "{format:?}");
            assert!(again.notes().is_empty());
        }
    }
}

#[test]
fn a_material_without_a_color_keeps_its_name() {
    let mesh = strip(vec![group("walls", 0..1, Some(("steel", None))), group("b", 1..2, BRICK)]);
    assert_eq!(read_again(&written(&mesh, Format::Obj)).groups(), mesh.groups());
    let again = read_again(&written(&mesh, Format::Glb));
    assert_eq!(again.groups()[0].material.as_ref().unwrap().name, "steel");
}

#[test]
fn an_obj_names_its_library_and_uses_each_material() {
    let blue_steel = Some(("blue steel", Some([0.1, 0.2, 0.75, 1.0])));
    let files = written(
        &strip(vec![group("walls", 0..1, BRICK), group("walls", 1..2, blue_steel)]),
        Format::Obj,
    );
    let [(_, object), (name, library)] = &files[..] else { panic!("two files") };
    assert_eq!(name, "part.mtl");
    let object = std::str::from_utf8(object).unwrap();
    let lines: Vec<&str> =
        object.lines().filter(|line| !line.starts_with(['v', 'f', '#'])).collect();
    assert_eq!(lines, ["mtllib part.mtl", "o walls", "usemtl brick", "usemtl blue_steel"]);
    let library = std::str::from_utf8(library).unwrap();
    let (_, library) = library.split_once('\n').unwrap();
    assert_eq!(
        library,
        "newmtl brick\nKd 0.5 0.25 0.125\nd 1\nnewmtl blue_steel\nKd 0.1 0.2 0.75\nd 1\n"
    );
    // Alone, or without materials, an OBJ names no library.
    let mut alone = Vec::new();
    obj::write(&strip(vec![group("a", 0..1, BRICK)]), &SurfaceOptions::default(), &mut alone)
        .unwrap();
    let alone = String::from_utf8(alone).unwrap();
    assert!(alone.contains("usemtl brick") && !alone.contains("mtllib"));
    let plain = written(&strip(vec![group("a", 0..1, None)]), Format::Obj);
    assert!(!String::from_utf8_lossy(&plain[0].1).contains("mtl"));
}

#[test]
fn degree_colors_are_not_tinted() {
    let mesh = strip(vec![group("a", 0..1, BRICK)]);
    let options = SurfaceOptions { degree_colors: true, ..SurfaceOptions::default() };
    let mut file = Vec::new();
    glb::write(&mesh, &options, &mut file).unwrap();
    let no_files = |_: &str| Err(io::ErrorKind::NotFound.into());
    let again = glb::read(&file[..], no_files).unwrap();
    assert_eq!(again.groups()[0].material.as_ref().unwrap().color, Some([1.0; 4]));
}

#[test]
fn what_blender_and_others_write_is_read() {
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    let faces = "o Cube\nusemtl Red paint #2\nf 1 2 3\nusemtl none\nf 1 3 4\nusemtl Red paint #2\n\
                 g other\nf 2 3 4\nusemtl \nf 1 2 4\n";
    for (mtllib, notes) in [
        ("mtllib two words.mtl\n", vec![]),
        ("mtllib absent.mtl red.mtl\n", vec![note("absent.mtl", "not there")]),
        (
            "mtllib bad.mtl\nmtllib red.mtl",
            vec![note("bad.mtl", "line 2: Kd has no numbers: Kd x")],
        ),
    ] {
        let file = format!("{mtllib}\n{square}{faces}");
        let library = "newmtl Red paint #2\nKd 1 0 0\n";
        let beside = |name: &str| match name {
            "two words.mtl" | "red.mtl" => Ok(library.as_bytes().to_vec()),
            "bad.mtl" => Ok(b"newmtl a\nKd x\n".to_vec()),
            _ => Err(io::Error::other("not there")),
        };
        let mesh = obj::read_with_libraries(file.as_bytes(), beside).unwrap();
        let red = Some(("Red paint #2", Some([1.0, 0.0, 0.0, 1.0])));
        assert_eq!(
            mesh.groups(),
            [
                group("Cube", 0..1, red),
                group("Cube", 1..2, None),
                group("other", 2..3, red),
                group("other", 3..4, None)
            ],
            "{mtllib}"
        );
        assert_eq!(mesh.notes(), notes);
    }
    // Without libraries, materials have names; a library that nothing uses is not asked for.
    let mesh = obj::read(format!("mtllib a.mtl\n{square}{faces}").as_bytes()).unwrap();
    assert_eq!(mesh.groups()[0].material.as_ref().unwrap().color, None);
    let unused = format!("mtllib a.mtl\n{square}f 1 2 3\n");
    let never = |_: &str| panic!("it is not asked for");
    assert!(obj::read_with_libraries(unused.as_bytes(), never).unwrap().notes().is_empty());
}

fn note(name: &str, problem: &str) -> String {
    format!("the material library {name:?} is not read, so its materials have no colors: {problem}")
}
