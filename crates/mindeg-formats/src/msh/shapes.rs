//! The elements that Gmsh knows, by their numbers.

use crate::ReadError;
use crate::scanner::Scanner;

/// The number of a point.
pub(super) const POINT: i32 = 15;

/// The number of a line of two nodes.
pub(super) const LINE: i32 = 1;

/// The number of a triangle of three nodes.
pub(super) const TRIANGLE: i32 = 2;

/// The shape of elements of one type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Shape {
    pub(super) dimension: u32,
    pub(super) nodes: usize,
    /// How many of the first nodes are corners; for volumes, which are not read, 0.
    pub(super) corners: usize,
}

/// The shape with a number that was just read.
pub(super) fn known_shape(scanner: &Scanner<'_>, element_type: i64) -> Result<Shape, ReadError> {
    shape(element_type)
        .ok_or_else(|| scanner.problem(format!("elements of type {element_type} are not known")))
}

/// The shape with a number; none that Gmsh's manual does not have.
#[rustfmt::skip]
fn shape(element_type: i64) -> Option<Shape> {
    let (dimension, corners, nodes) = match element_type {
        15 => (0, 1, 1),
        1 => (1, 2, 2),
        8 => (1, 2, 3),
        26 => (1, 2, 4),
        27 => (1, 2, 5),
        28 => (1, 2, 6),
        2 => (2, 3, 3),
        9 => (2, 3, 6),
        20 => (2, 3, 9),
        21 => (2, 3, 10),
        22 => (2, 3, 12),
        23 | 24 => (2, 3, 15),
        25 => (2, 3, 21),
        3 => (2, 4, 4),
        16 => (2, 4, 8),
        10 => (2, 4, 9),
        39 => (2, 4, 12),
        36 => (2, 4, 16),
        37 => (2, 4, 25),
        38 => (2, 4, 36),
        4 => (3, 0, 4),
        5 => (3, 0, 8),
        6 => (3, 0, 6),
        7 => (3, 0, 5),
        11 => (3, 0, 10),
        12 => (3, 0, 27),
        13 => (3, 0, 18),
        14 => (3, 0, 14),
        17 => (3, 0, 20),
        18 => (3, 0, 15),
        19 => (3, 0, 13),
        29 => (3, 0, 20),
        30 => (3, 0, 35),
        31 => (3, 0, 56),
        92 => (3, 0, 64),
        93 => (3, 0, 125),
        _ => return None,
    };
    Some(Shape { dimension, nodes, corners })
}
