//! Whatever a mesh, its groups, lines and materials are called: what is written is read again as the
//! same triangles, points, lines and number of groups, and no name means anything to a format.

use std::io::{self, ErrorKind};
use std::path::Path;
use std::sync::Arc;

use glam::DVec3;
use mindeg_formats::{Encoding, Format, MshVersion, SurfaceOptions, WriteOptions, Writer, read};
use mindeg_mesh::{ByName, Group, Line, Material, Progress, TriMesh, Triangles};
use proptest::prelude::*;

/// Names that mean something to one format or another, or that XML or a line of text cannot hold.
const EVIL: [&str; 52] = [
    "",
    " ",
    "\\",
    "st\\",
    "C:\\parts\\",
    "a\\ ",
    "a\\\u{2028}",
    "a\nf 1 1 1",
    "a\rv 9 9 9",
    "a\u{85}b",
    "a\u{2028}b",
    "a\0b",
    "\u{1b}[31mred",
    "\u{fffe}",
    "a\u{ffff}b",
    "\u{feff}",
    "\u{202e}abc",
    "\"",
    "a\" 9 \"b",
    "a' b",
    "#",
    "# comment",
    "a # b",
    "50% of it",
    "none",
    "mesh",
    "wall",
    "Wall",
    "a b",
    "a_b",
    "a,b=c",
    "*NODE",
    " *NODE",
    "**",
    "$MeshFormat",
    "$EndPhysicalNames",
    "$Nodes",
    "ply",
    "OFF",
    "solid rock",
    "MESH2D",
    "NDIME= 2",
    "glTF",
    "PK\u{3}\u{4}",
    "{\"asset\"",
    "<VTKFile",
    "# vtk DataFile",
    "v 0 0 0",
    "]]>",
    "--><script>alert(1)</script>",
    "(",
    "&amp;&#0;",
];

fn name() -> impl Strategy<Value = String> {
    prop_oneof![
        4 => prop::sample::select(&EVIL[..]).prop_map(str::to_owned),
        1 => "\\PC{0,3}[\\\\\"'*$#%]{0,2}",
        1 => "[a]{120,300}",
        1 => any::<String>(),
    ]
}

/// A strip of four triangles in three groups, with two lines, by nine names.
fn mesh_named(names: &[String]) -> TriMesh {
    let at = |i: u32| DVec3::new(f64::from(i / 2), f64::from(i % 2), 0.0);
    let triangle = |i: u32| if i.is_multiple_of(2) { [i, i + 2, i + 1] } else { [i, i + 1, i + 2] };
    // A material without a name is none.
    let material = |name: &str| match name.trim() {
        "" => None,
        _ => Some(Arc::new(Material { name: name.to_owned(), color: None })),
    };
    let group = |i: usize, triangles| Group {
        name: names[i].clone(),
        triangles,
        material: material(&names[3 + i]).filter(|_| i < 2),
    };
    let line = |name: &String, segments| Line { name: name.clone(), segments, is_straight: true };
    TriMesh::new((0..6).map(at).collect(), (0..4).map(triangle).collect())
        .unwrap()
        .with_groups(vec![group(0, 0..1), group(1, 1..2), group(2, 2..4)])
        .with_lines(
            vec![line(&names[6], 0..2), line(&names[7], 2..3)],
            vec![[0, 2], [2, 4], [4, 5]],
        )
        .unwrap()
        .named(names[8].clone())
}

/// Whether groups and lines have different names: those of one name are one.
fn names_differ(mesh: &TriMesh) -> bool {
    let groups = ByName::new(mesh.groups().iter().map(Group::label));
    let lines = ByName::new(mesh.lines().iter().map(|line| &line.name));
    (groups.names.len(), lines.names.len()) == (3, 2)
}

fn meshes() -> impl Strategy<Value = TriMesh> {
    let any = prop::collection::vec(name(), 9).prop_map(|names| mesh_named(&names));
    any.prop_filter("names differ", names_differ)
}

/// The mesh that is read from the files of another.
fn again(mesh: &TriMesh, format: Format, options: WriteOptions) -> Result<TriMesh, TestCaseError> {
    let files = written(mesh, format, options);
    let beside = |name: &str| {
        let found = files.iter().find(|(file, _)| file == name);
        found.map(|(_, bytes)| bytes.clone()).ok_or(io::Error::from(ErrorKind::NotFound))
    };
    let again = read(files[0].0.as_ref(), &files[0].1[..], beside);
    again.map_err(|error| TestCaseError::fail(format!("{format:?}: {error}")))
}

/// The numbers of groups and of segments.
fn counts(mesh: &TriMesh) -> [usize; 2] {
    let groups = mesh.groups().iter().filter(|group| !group.triangles.is_empty());
    [groups.count(), mesh.segments().len()]
}

fn ways() -> Vec<(Format, WriteOptions)> {
    let surface = SurfaceOptions { boundary_lines: true, ..SurfaceOptions::default() };
    let plain = WriteOptions { surface, ..WriteOptions::default() };
    let text = WriteOptions { encoding: Encoding::Ascii, ..plain };
    // An STL has no names and numbers the vertices anew.
    let formats = Format::READ.into_iter().filter(|format| *format != Format::Stl);
    let mut ways: Vec<_> = formats.map(|format| (format, plain)).collect();
    ways.extend([Format::Msh, Format::Vtu, Format::Vtk].map(|format| (format, text)));
    ways.push((Format::Msh, WriteOptions { msh_version: MshVersion::V2, ..text }));
    ways
}

fn written(mesh: &TriMesh, format: Format, options: WriteOptions) -> Vec<(String, Vec<u8>)> {
    let writer = Writer::new(format, options, mesh, mesh.triangle_count()).unwrap();
    let path = Path::new("part").with_extension(format.extension());
    let mut paths = format.files(&path);
    paths.extend(format.material_library(&path));
    let mut files: Vec<_> =
        paths.iter().map(|path| (path.display().to_string(), Vec::new())).collect();
    let mut open: Vec<_> =
        files.iter_mut().map(|(name, file)| (name.as_str(), &mut *file)).collect();
    writer.write(mesh, &mut open, Progress::NONE).unwrap();
    files
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn no_name_changes_what_is_read(mesh in meshes()) {
        let plain = mesh_named(&["a", "b", "c", "d", "e", "f", "g", "h", "i"].map(str::to_owned));
        for (format, options) in ways() {
            let read = again(&mesh, format, options)?;
            prop_assert_eq!(read.triangles(), mesh.triangles(), "{:?}", format);
            prop_assert_eq!(read.positions(), mesh.positions(), "{:?}", format);
            // As many as with names that mean nothing: some formats hold no groups or lines.
            let held = counts(&again(&plain, format, options)?);
            prop_assert_eq!(counts(&read), held, "{:?}", format);
        }
    }

    /// XML holds no other characters, not even escaped.
    #[test]
    fn a_picture_is_well_formed(mesh in meshes()) {
        let [(_, picture)] = &written(&mesh, Format::Svg, WriteOptions::default())[..] else {
            return Err(TestCaseError::fail("a picture is one file"));
        };
        let picture = std::str::from_utf8(picture).unwrap();
        let is_held = |letter: char| {
            matches!(letter, '\t' | '\n' | ' '..='\u{7e}' | '\u{a0}'..='\u{fffd}' | '\u{10000}'..)
        };
        prop_assert!(picture.chars().all(is_held));
        let title = picture.split_once("<title id=\"title\">").unwrap().1;
        let title = title.split_once("</title>").unwrap().0;
        prop_assert!(!title.contains(['<', '>', '\n']));
    }
}
