use glam::DVec2;

use super::super::outline::{DrawnRing, Outlines, Piece};

const V4: &str = "\
$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
1 5 \"in let\"
2 6 \"water\"
$EndPhysicalNames
$Entities
1 2 1 0
1 0 0 0 0
7 0 0 0 4 0 0 1 -5 2 1 -2
8 0 0 0 4 3 0 0 2 1 -2
1 0 0 0 4 3 0 1 6 2 7 8
$EndEntities
$Nodes
2 3 1 12
0 1 0 1
10
0.1 0 0
1 7 0 2
12
11
4 0 0
0.1 3.3 0
$EndNodes
$Elements
3 5 1 5
0 1 15 1
1 10
1 7 1 2
2 10 12
3 12 11
1 8 8 1
4 11 10 99
$EndElements
";

const V2: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\nany $ text\n$EndComments\n\
    $Nodes\n3\n1 0.1 0 0\n2 4 0 0\n7 0.1 3.3 0\n$EndNodes\n$Elements\n5\n1 15 2 0 1 1\n\
    2 1 2 0 1 1 2\n3 1 2 9 2 2 7\n4 1 3 0 3 0 7 1\n5 2 2 0 1 1 2 7\n$EndElements\n";

fn read(text: &str) -> Result<Outlines, String> {
    super::read_msh(text.as_bytes()).map_err(|error| error.to_string())
}

fn points_and_sides(outlines: &Outlines) -> Vec<(DVec2, Option<&str>, bool)> {
    let pieces = outlines.features.iter().flat_map(|it| &it.rings).flat_map(|it| &it.pieces);
    pieces.map(|it| (it.start, it.side.as_deref(), it.begins_side)).collect()
}

#[test]
fn reads_line_elements_of_both_versions() {
    let [a, b, c] = [[0.1, 0.0], [4.0, 0.0], [0.1, 3.3]].map(DVec2::from);
    let outlines = read(V4).unwrap();
    let inlet = Some("in let");
    assert_eq!(points_and_sides(&outlines), [(a, inlet, true), (b, inlet, false), (c, None, true)]);
    assert!(outlines.notes.is_empty(), "{:?}", outlines.notes);
    let with_triangles = V4
        .replace("3 5 1 5", "4 7 1 7")
        .replace("$EndElements", "2 1 2 2\n6 10 12 11\n7 12 10 11\n$EndElements");
    let outlines = read(&with_triangles).unwrap();
    assert_eq!(outlines.notes, ["left out 2 other elements"]);
    let outlines = read(V2).unwrap();
    assert_eq!(
        points_and_sides(&outlines),
        [(a, None, true), (b, Some("physical 9"), true), (c, None, true)]
    );
    assert_eq!(outlines.notes, ["left out 1 other element"]);
}

#[test]
fn a_binary_file_gives_what_its_text_gives() {
    let mut bytes = b"$MeshFormat\n2.2 1 8\n".to_vec();
    bytes.extend(1_i32.to_le_bytes());
    bytes.extend(b"\n$EndMeshFormat\n$Nodes\n3\n");
    for (tag, [x, y]) in [(1_i32, [0.1, 0.0]), (2, [4.0, 0.0]), (7, [0.1, 3.3])] {
        bytes.extend(tag.to_le_bytes());
        bytes.extend([x, y, 0.0].into_iter().flat_map(f64::to_le_bytes));
    }
    bytes.extend(b"\n$EndNodes\n$Elements\n3\n");
    // Lines of two nodes, three in a block, with two tags each.
    bytes.extend([1, 3, 2].into_iter().flat_map(i32::to_le_bytes));
    for element in [[2, 0, 1, 1, 2], [3, 9, 2, 2, 7], [4, 0, 3, 7, 1]] {
        bytes.extend(element.into_iter().flat_map(i32::to_le_bytes));
    }
    bytes.extend(b"\n$EndElements\n");
    let outlines = super::read_msh(&bytes).unwrap();
    assert_eq!(outlines.features, read(V2).unwrap().features);
}

#[test]
fn errors_of_an_msh_say_where_and_what() {
    for (text, from, to, message) in [
        (V4, "4.1 0 8", "4.0 0 8", "line 2: MSH 4 is not read; save it as 4.1 or 2.2"),
        (V4, "\n12\n11", "\n12\n12", "two vertices, 1 and 2 (counted from 0), have the number 12"),
        (V4, "0.1 3.3 0", "0.1 x 0", "line 25: "),
        (V4, "0.1 3.3 0", "0.1 3.3 1", "the points do not lie in a plane of equal z"),
        (V4, "3 12 11", "3 12 13", "line 33: node 13 does not exist"),
        (V4, "4 11 10 99", "4 11 12 99", "three or more lines meet"),
        (V2, "4 1 3 0 3 0 7 1", "4 1 3 0 3 0 7 8", "line 18: node 8 does not exist"),
    ] {
        let error = read(&text.replacen(from, to, 1)).unwrap_err();
        assert!(error.contains(message), "{error}");
    }
    let only_triangles = V2
        .replace("\n2 1 2 0 1 1 2\n3 1 2 9 2 2 7\n4 1 3 0 3 0 7 1", "")
        .replace("$Elements\n5", "$Elements\n2");
    let error = read(&only_triangles).unwrap_err();
    assert!(error.starts_with("$Elements: the file has no line elements, only 1 other element; mesh the curves with gmsh -1"), "{error}");
    assert!(read("").unwrap_err().contains("$MeshFormat is missing"));
}

const SQUARE: &str = "v 0 0 0\nv 0.1 0 0\nv 0.1 0.3 0\nv 0 0.3 0\n";

fn read_obj(text: &str) -> Result<Outlines, String> {
    super::read_obj(text.as_bytes()).map_err(|error| error.to_string())
}

#[test]
fn loops_become_rings_with_their_points_and_names() {
    let expected = [[0.0, 0.0], [0.1, 0.0], [0.1, 0.3], [0.0, 0.3]].map(DVec2::from);
    for (lines, name) in [
        ("l 1 2 3 4 1", None),
        ("l 1 2\nl 3 4 # c\nl 2/7 3/7\nl -1 -4", None),
        ("o plate\ng\no plate\nl 1 2 3\nl 3 4 1", Some("plate")),
    ] {
        let outlines = read_obj(&format!("{SQUARE}{lines}")).unwrap();
        assert_eq!(outlines.features[0].rings, [DrawnRing::of_points(expected)], "{lines}");
        assert_eq!(outlines.features[0].name.as_deref(), name);
    }
    let outlines = read_obj(&format!("{SQUARE}o inlet\nl 4 1\no wall\nl 1 2 3 4")).unwrap();
    let sides = |piece: &Piece| piece.side.clone().unwrap().to_string();
    let sides: Vec<String> = outlines.features[0].rings[0].pieces.iter().map(sides).collect();
    assert_eq!(sides, ["inlet", "wall", "wall", "wall"]);
}

#[test]
fn errors_of_an_obj_say_where_and_what() {
    for (lines, message) in [
        ("f 1 2 3", "the file has faces, so it is a mesh;"),
        ("", "the file has no lines;"),
        ("l 1 2 0", "line 5: vertex 0 does not exist; numbers start at 1"),
        ("l 1 2 -9", "line 5: vertex -9 does not exist; the file has 4 up to this line"),
        ("l 1 2 3 5 1", "line 5: vertex 5 does not exist; the file has 4"),
        ("l 1 4294967296", "line 5: vertex 4294967296 does not exist; the file has 4"),
        ("v 1 2", "line 5: a vertex has three coordinates; found 2"),
        ("v 1 2 x", "line 5: the coordinate \"x\" is not a finite number"),
        ("v 1 1 1\nl 1 2 5 1", "the points do not lie in a plane of equal z"),
        ("l 1 2 3", "the point (0.0, 0.0): no line closes"),
    ] {
        let error = read_obj(&format!("{SQUARE}{lines}")).unwrap_err();
        assert!(error.starts_with(message) || error.contains(message), "{error}");
    }
}
