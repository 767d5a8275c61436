use glam::DVec2;

use super::super::outline::Outlines;

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
    super::read(text.as_bytes()).map_err(|error| error.to_string())
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
    assert_eq!(outlines.notes, ["left out 2 elements that are no lines"]);
    let outlines = read(V2).unwrap();
    assert_eq!(
        points_and_sides(&outlines),
        [(a, None, true), (b, Some("physical 9"), true), (c, None, true)]
    );
    assert_eq!(outlines.notes, ["left out 1 element that are no lines"]);
}

#[test]
fn errors_say_where_and_what() {
    let binary = [V4.replace("4.1 0 8", "4.1 1 8").as_bytes(), b"\xff\xfe"].concat();
    let error = super::read(&binary).unwrap_err().to_string();
    assert_eq!(error, "line 2: this is a binary file; write text with Mesh.Binary = 0");
    for (text, from, to, message) in [
        (V4, "4.1 0 8", "4.0 0 8", "line 2: found the version \"4.0\", expected 4.1 or 2.2"),
        (
            V4,
            "4.1 0 8",
            "4.1 1 8",
            "line 2: this is a binary file; write text with Mesh.Binary = 0",
        ),
        (V4, "$MeshFormat", "$Mesh", "line 1: the section has no end: $EndMesh is missing"),
        (
            V4,
            "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n",
            "",
            "line 6: $Entities stands before $MeshFormat",
        ),
        (V4, "\n12\n11", "\n12\n12", "line 25: the node 12 is there twice"),
        (
            V4,
            "0.1 3.3 0",
            "0.1 x 0",
            "line 25: found \"x\", expected the y coordinate, a finite number",
        ),
        (
            V4,
            "0.1 3.3 0",
            "0.1 3.3 1",
            "the whole file: the points do not lie in a plane of equal z",
        ),
        (V4, "3 12 11", "3 12 13", "line 33: the node 13 is not in the file"),
        (V4, "3 12 11", "3 12", "line 33: the second node is missing"),
        (V4, "1 7 0 2", "1 7 0 9", "line 25: found \"0.1\", expected the tag of the node"),
        (V4, "$EndElements", "", "line 27: the section has no end: $EndElements is missing"),
        (V4, "4 11 10 99", "4 11 12 99", "node 11: three or more lines meet"),
        (V2, "4 1 3 0 3 0 7 1", "4 1 3 0 3 0 7 8", "line 18: the node 8 is not in the file"),
        (V2, "5 2 2 0 1 1 2 7", "", "line 20: the section ends where an element should be"),
    ] {
        let error = read(&text.replacen(from, to, 1)).unwrap_err();
        assert!(
            error.starts_with(message)
                || message.starts_with("node") && error.contains("three or more lines meet"),
            "{error}"
        );
    }
    let only_triangles = V2
        .replace("\n2 1 2 0 1 1 2\n3 1 2 9 2 2 7\n4 1 3 0 3 0 7 1", "")
        .replace("$Elements\n5", "$Elements\n2");
    let error = read(&only_triangles).unwrap_err();
    assert!(error.starts_with("$Elements: the file has no line elements, only 1 other element; mesh the curves with gmsh -1"), "{error}");
    assert_eq!(read("").unwrap_err(), "line 1: the section $MeshFormat is missing");
    assert!(read("x").unwrap_err().starts_with("line 1: found \"x\", expected a section"));
}
