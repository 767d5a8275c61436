//! The elements that MSH and VTK files have besides plain triangles, as their formats define them.

use std::fmt::Write as _;

use mindeg_formats::{Format, ReadError, read_as};
use mindeg_mesh::{TriMesh, Triangles};

fn read(format: Format, file: &[u8]) -> Result<TriMesh, ReadError> {
    read_as(format, "mesh".as_ref(), file, |_| Err(std::io::ErrorKind::NotFound.into()))
}

const HEAD: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";

/// An MSH 2.2 with so many nodes on a parabola, so that no three are on a line, and some elements.
fn msh(node_count: usize, elements: &[&str]) -> String {
    let mut file = format!("{HEAD}$Nodes\n{node_count}\n");
    for node in 1..=node_count {
        writeln!(file, "{node} {node} {} 0", node * node).unwrap();
    }
    write!(file, "$EndNodes\n$Elements\n{}\n", elements.len()).unwrap();
    for (element, number) in elements.iter().zip(1..) {
        writeln!(file, "{number} {element}").unwrap();
    }
    file + "$EndElements\n"
}

#[test]
fn elements_of_any_order_have_their_corners_first() {
    // The number of an element type, its corners and the order of its polynomials, as in Gmsh's manual.
    let complete = |corners: usize, order: usize| match corners {
        2 => order + 1,
        3 => (order + 1) * (order + 2) / 2,
        _ => (order + 1) * (order + 1),
    };
    // Without nodes inside: so many on each edge.
    let serendipity = |corners: usize, order: usize| corners * order;
    let table = [(1, 2, 1), (8, 2, 2), (26, 2, 3), (27, 2, 4), (28, 2, 5)].into_iter();
    let table = table.chain([(2, 3, 1), (9, 3, 2), (21, 3, 3), (23, 3, 4), (25, 3, 5)]);
    let table = table.chain([(3, 4, 1), (10, 4, 2), (36, 4, 3), (37, 4, 4), (38, 4, 5)]);
    let of_edges = [(20, 3, 3), (22, 3, 4), (24, 3, 5), (16, 4, 2), (39, 4, 3)];
    let cases =
        table.map(|(element, corners, order)| (element, corners, complete(corners, order))).chain(
            of_edges
                .map(|(element, corners, order)| (element, corners, serendipity(corners, order))),
        );
    for (element, corners, nodes) in cases {
        let tags: Vec<String> = (1..=nodes).map(|node| node.to_string()).collect();
        // A triangle beside it, whose tags are the last ones: a wrong count would take them.
        let other = format!("2 0 {} {} {}", nodes + 1, nodes + 2, nodes + 3);
        let file = msh(nodes + 3, &[&format!("{element} 0 {}", tags.join(" ")), &other]);
        let mesh = read(Format::Msh, file.as_bytes()).unwrap();
        assert_eq!(mesh.triangles().len(), corners - 1, "element type {element}");
        assert_eq!(mesh.segments().len(), usize::from(corners == 2), "element type {element}");
        if let Some(polygons) = mesh.polygons() {
            assert_eq!(polygons.corners(0).len(), if corners == 4 { 4 } else { 3 });
        }
    }
}

#[test]
fn points_and_volumes_are_counted_and_left_out() {
    let file = msh(4, &["15 0 1", "2 0 1 2 3", "15 0 2", "4 0 1 2 3 4"]);
    let mesh = read(Format::Msh, file.as_bytes()).unwrap();
    assert_eq!((mesh.triangles(), mesh.non_triangles().points), (&[[0, 1, 2]][..], 2));
    assert_eq!(mesh.notes(), ["1 volume elements"]);
}

#[test]
fn numbers_of_either_byte_order_are_read() {
    let file = |one: [u8; 4], int: fn(i32) -> [u8; 4], float: fn(f64) -> [u8; 8]| {
        let mut file = b"$MeshFormat\n2.2 1 8\n".to_vec();
        file.extend(one);
        file.extend(b"\n$EndMeshFormat\n$Nodes\n3\n");
        for (tag, [x, y]) in (1..).zip([[0.0, 0.0], [2.0, 0.5], [1.0, 3.0]]) {
            file.extend(int(tag));
            file.extend([x, y, 0.0].map(float).concat());
        }
        file.extend(b"\n$EndNodes\n$Elements\n1\n");
        file.extend([2, 1, 0, 1, 1, 2, 3].map(int).concat());
        file.extend(b"\n$EndElements\n");
        file
    };
    let little = file([1, 0, 0, 0], i32::to_le_bytes, f64::to_le_bytes);
    let big = file([0, 0, 0, 1], i32::to_be_bytes, f64::to_be_bytes);
    let [little, big] = [little, big].map(|file| read(Format::Msh, &file).unwrap());
    assert_eq!(little.triangles(), [[0, 1, 2]]);
    assert_eq!(little.positions()[1].to_array(), [2.0, 0.5, 0.0]);
    assert_eq!(little, big);
    let mixed = file([0, 1, 0, 0], i32::to_le_bytes, f64::to_le_bytes);
    let error = read(Format::Msh, &mixed).unwrap_err().to_string();
    assert!(
        error.ends_with(
            "the 4-byte integer 1 after the version is missing; cannot tell the byte order"
        ),
        "{error}"
    );
}

/// An empty block would be read for ever.
#[test]
fn a_block_of_no_elements_is_refused() {
    let mut file = b"$MeshFormat\n2.2 1 8\n\x01\0\0\0\n$EndMeshFormat\n$Elements\n1\n".to_vec();
    file.extend([2, 0, 0].map(i32::to_le_bytes).concat());
    let error = read(Format::Msh, &file).unwrap_err().to_string();
    assert!(error.ends_with("a block must have 1 to 1 elements"), "{error}");
}

#[test]
fn strips_of_a_grid_turn_every_other_triangle() {
    let file = "# vtk DataFile Version 4.2\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 double\n\
                0 0 0 0 1 0 1 0 0 1 1 0 2 0 0 0 0 5\nCELLS 2 11\n5 0 2 1 3 4\n4 0 1 2 5\n\
                CELL_TYPES 2\n6\n10\n";
    let mesh = read(Format::Vtk, file.as_bytes()).unwrap();
    assert_eq!(mesh.triangles(), [[0, 2, 1], [1, 2, 3], [1, 3, 4]]);
    assert_eq!(mesh.notes(), ["1 volume cells"]);
}

#[test]
fn a_2dm_has_a_name() {
    let file = "MESH2D\nMESHNAME \"the bay\"\nND 1 0 0 0\nND 2 1 0 0\nND 3 0 1 0\nE3T 1 1 2 3 1\n";
    assert_eq!(read(Format::Sms2dm, file.as_bytes()).unwrap().name(), Some("the bay"));
}
