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

/// The note on the last line of `V4`, which is of order 2.
const STRAIGHTENED: &str = "took edges of higher order as straight ones between their ends";

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
    assert_eq!(outlines.notes, [STRAIGHTENED]);
    let with_triangles = V4
        .replace("3 5 1 5", "4 7 1 7")
        .replace("$EndElements", "2 1 2 2\n6 10 12 11\n7 12 10 11\n$EndElements");
    let outlines = read(&with_triangles).unwrap();
    assert_eq!(outlines.notes, ["left out 2 other elements", STRAIGHTENED]);
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
        ("f 1 2 3", "the file has faces, so it is a model or a mesh: mindeg mesh meshes its faces"),
        ("", "the file has no lines;"),
        ("l 1 2 0", "line 5: vertex 0 does not exist; numbers start at 1"),
        ("l 1 2 -9", "line 5: vertex -9 does not exist; the file has 4 up to this line"),
        ("l 1 2 3 5 1", "line 5: vertex 5 does not exist; the file has 4"),
        ("l 1 4294967296", "line 5: vertex 4294967296 does not exist; the file has 4"),
        ("v 1 2", "line 5: a vertex has three coordinates; found 2"),
        ("v 1 2 x", "line 5: the coordinate \"x\" is not a finite number"),
        ("v 1 1 1\nl 1 2 5 1", "the points do not lie in a plane of equal z"),
        ("l 1 2 3", "the point (0, 0): no line closes"),
    ] {
        let error = read_obj(&format!("{SQUARE}{lines}")).unwrap_err();
        assert!(error.starts_with(message) || error.contains(message), "{error}");
    }
}

/// Two squares side by side, the right one with a triangular hole, the left one with a crack and a gauge inside.
fn two_surfaces() -> String {
    let points = "0 0,2 0,4 0,4 2,2 2,0 2,2.5 0.5,3.5 0.5,3 1.5,0.5 1,1 1,1.5 1.2,1 0.5";
    let points: Vec<&str> = points.split(',').collect();
    let curves = "1 1 2,2 2 3,3 3 4,4 4 5,5 5 6,6 6 1,7 2 5,8 7 8,9 8 9,10 9 7,11 10 11,11 11 12";
    let curves: Vec<Vec<&str>> = curves.split(',').map(|it| it.split(' ').collect()).collect();
    let group = |curve: &str| match curve {
        "7" => 3,
        "8" | "9" | "10" => 4,
        "11" => 5,
        _ => 2,
    };
    let mut text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n8\n0 8 \"gauge\"\n0 9 \"corner\"\n1 2 \"wall\"\n\
                    1 3 \"interface\"\n1 4 \"bore\"\n1 5 \"crack\"\n2 6 \"clay\"\n2 7 \"sand\"\n$EndPhysicalNames\n\
                    $Entities\n2 11 2 0\n1 1 0.5 0 1 8\n2 4 0 0 1 9\n"
        .to_owned();
    for curve in 1..=11 {
        text += &format!("{curve} 0 0 0 0 0 0 1 {} 0\n", group(&curve.to_string()));
    }
    // Gmsh lists an embedded curve under a tag that no curve has.
    text +=
        "1 0 0 0 0 0 0 1 6 5 1 7 5 6 22\n2 0 0 0 0 0 0 1 7 7 2 3 4 -7 -8 -9 -10\n$EndEntities\n";
    text += &format!("$Nodes\n1 {0} 1 {0}\n2 1 0 {0}\n", points.len());
    (1..=points.len()).for_each(|tag| text += &format!("{tag}\n"));
    points.iter().for_each(|point| text += &format!("{point} 0\n"));
    text += "$EndNodes\n$Elements\n14 14 1 14\n0 1 15 1\n1 13\n0 2 15 1\n2 3\n";
    for (tag, curve) in (3..).zip(&curves) {
        text += &format!("1 {} 1 1\n{tag} {} {}\n", curve[0], curve[1], curve[2]);
    }
    text + "$EndElements\n"
}

fn map(text: &str) -> Result<mindeg_domain::Domain, String> {
    let outlines = read(text)?;
    let polygons = crate::labelled(outlines.features);
    let (maps, _) = crate::maps(&polygons, &outlines.inside, &crate::Division::default(), false)
        .map_err(|error| error.to_string())?;
    let [map] = &maps[..] else { panic!("one map") };
    Ok(map.clone())
}

#[test]
fn surfaces_are_regions_and_other_curves_lines_inside() {
    let domain = map(&two_surfaces()).unwrap();
    assert_eq!(domain.rings().ring_count(), 2);
    assert_eq!([0, 1].map(|face| domain.region_name(face)), ["clay", "sand"]);
    let sides: Vec<_> = (0..domain.sides().len()).map(|side| domain.side_name(side)).collect();
    assert_eq!(sides, ["wall", "wall", "wall", "wall", "wall", "wall", "bore", "bore", "bore"]);
    let lines = domain.inner_lines();
    let lines: Vec<_> =
        lines.iter().map(|(line, _)| (&*line.name, line.segments.clone())).collect();
    assert_eq!(lines, [("interface", 0..1), ("crack", 1..3)]);
    let boundary = domain.boundary().unwrap();
    let named = domain.named_vertices();
    let named: Vec<_> =
        named.iter().map(|one| (&*one.name, boundary.point(one.vertex).to_array())).collect();
    assert_eq!(named, [("gauge", [1.0, 0.5]), ("corner", [4.0, 0.0])]);
    assert!(!domain.divisible_segments().contains(&true));
}

#[test]
fn surfaces_by_their_faces_are_the_same_regions() {
    let text = two_surfaces();
    // Without entities, faces tell the surfaces; one of the two has them here.
    let (start, rest) = text.split_once("$Elements").unwrap();
    let faces = "2 1 3 2\n20 1 2 5 6\n21 1 6 5 6\n2 2 2 7\n";
    let faces = faces.replace("2 1 3 2\n20 1 2 5 6\n21 1 6 5 6\n", "2 1 3 1\n20 1 2 5 6\n");
    let faces = faces + "22 2 3 8\n23 2 8 7\n24 3 4 8\n25 8 4 9\n26 4 5 9\n27 9 5 7\n28 5 2 7\n";
    let rest = rest.replacen("14 14 1 14", "16 22 1 28", 1);
    let rest = rest.replace("$EndElements", &format!("{faces}$EndElements"));
    let with_faces = map(&format!("{start}$Elements{rest}")).unwrap();
    let plain = map(&text).unwrap();
    assert_eq!(with_faces.boundary().unwrap(), plain.boundary().unwrap());
    assert_eq!(with_faces.inside(), plain.inside());
}

#[test]
fn surfaces_without_curves_and_points_outside_are_told() {
    let text = two_surfaces();
    let without = text.replace("1 7 1 1\n9 2 5\n", "1 1 1 1\n9 1 2\n");
    let error = map(&without).unwrap_err();
    assert!(
        error.starts_with("surface 1 (clay): curve 7 bounds it and has no line elements; put all"),
        "{error}"
    );
    let outside = text.replace("1 0.5 0\n$EndNodes", "9 9 0\n$EndNodes");
    let error = map(&outside).unwrap_err();
    assert!(error.starts_with("(9, 9): this point lies outside all regions"), "{error}");
    let line = text.replace("0.5 1 0\n1 1 0\n1.5 1.2 0\n", "9 1 0\n9 2 0\n9 3 0\n");
    let error = map(&line).unwrap_err();
    assert!(error.contains("this line lies outside all regions"), "{error}");
    let across = text.replace("1.5 1.2 0\n", "2.2 1.2 0\n");
    let error = map(&across).unwrap_err();
    assert!(error.contains("one of them has no point there"), "{error}");
    let named = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"clay\"\n2 2 \"sand\"\n$EndPhysicalNames\n\
                 $Nodes\n3\n1 0 0 0\n2 4 0 0\n3 0 3 0\n$EndNodes\n$Elements\n3\n1 1 2 0 1 1 2\n2 1 2 0 1 2 3\n3 1 2 0 1 3 1\n$EndElements\n";
    let error = read(named).unwrap_err();
    assert!(
        error.contains("the file names 2 surfaces (clay, sand), and MSH 2.2 without"),
        "{error}"
    );
}

#[test]
fn a_group_that_lacks_what_another_one_has_is_named() {
    let told = |name: &str| {
        format!(
            "left out what \"{name}\" shares with other physical groups: each point, curve and surface is in the first one alone"
        )
    };
    let of_curve = V4.replace("1 -5 2 1 -2", "2 -5 -8 2 1 -2");
    let names = "3\n1 5 \"in let\"\n1 8 \"top\"";
    let notes = |text: &str| read(text).unwrap().notes;
    assert_eq!(notes(&of_curve.replace("2\n1 5 \"in let\"", names)), [STRAIGHTENED, &*told("top")]);
    // 2.2 has the elements once for each group.
    let twice =
        V2.replace("$Elements\n5", "$Elements\n6").replace("2 7\n4 1", "2 7\n6 1 2 8 2 2 7\n4 1");
    assert!(notes(&twice).contains(&told("physical 8")), "{:?}", notes(&twice));
}
