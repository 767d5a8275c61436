//! Periodic curves: `$Periodic`, from a list of lines and to it.

use std::collections::HashMap;

use mindeg_mesh::PeriodicLine;

use crate::lists::push;
use crate::numbered::Nodes;
use crate::numbers::Numbers;
use crate::scanner::Scanner;
use crate::{MshVersion, ReadError};

/// The matrix of a link that gives none.
const UNMOVED: [[f64; 4]; 4] =
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

/// The curves that a file says are others, moved.
#[derive(Default)]
pub(super) struct Links(Vec<Link>);

struct Link {
    /// The tags of the curve and of the other.
    curves: [i64; 2],
    matrix: [[f64; 4]; 4],
    /// By the tags of nodes.
    nodes: Vec<[u64; 2]>,
}

impl Links {
    /// Reads `$Periodic`. Before version 4 it is text in binary files, too.
    pub(super) fn take(
        &mut self,
        scanner: &mut Scanner<'_>,
        version: MshVersion,
    ) -> Result<(), ReadError> {
        let is_v4 = version == MshVersion::V4;
        let links = scanner.size("the number of periodic entities")?;
        for _ in 0..links {
            let dimension = scanner.int("the dimension of a periodic entity")?;
            let mut curves = [0; 2];
            for curve in &mut curves {
                *curve = scanner.int("the tag of a periodic entity")?.saturating_abs();
            }
            let mut matrix = UNMOVED;
            let count = if is_v4 {
                scanner.size("the number of values of a matrix")?
            } else {
                let before = scanner.offset();
                match scanner.word() {
                    Some(b"Affine") => 16,
                    _ => {
                        scanner.go_to(before);
                        0
                    }
                }
            };
            let mut places = matrix.as_flattened_mut().iter_mut();
            for _ in 0..count {
                let value = scanner.double("a value of a matrix")?;
                if let Some(own) = places.next() {
                    *own = value;
                }
            }
            let mut nodes = Vec::new();
            for _ in 0..scanner.size("the number of pairs of nodes")? {
                let mut pair = [0; 2];
                for node in &mut pair {
                    *node = if is_v4 {
                        scanner.size("a periodic node")?
                    } else {
                        u64::try_from(scanner.int("a periodic node")?).unwrap_or(u64::MAX)
                    };
                }
                push(&mut nodes, pair)?;
            }
            if dimension == 1 {
                push(&mut self.0, Link { curves, matrix, nodes })?;
            }
        }
        Ok(())
    }

    /// The lines that these are, of the curves that have one; pairs of nodes that the file does not have are left out.
    pub(super) fn lines(
        self,
        line_of: &HashMap<i64, u32>,
        nodes: Option<&Nodes>,
    ) -> Vec<PeriodicLine> {
        let line = |Link { curves: [curve, other], matrix, nodes: pairs }: Link| {
            let vertex = |tag: u64| nodes.and_then(|nodes| nodes.index(tag));
            let pairs = pairs.into_iter().filter_map(|[a, b]| Some([vertex(a)?, vertex(b)?]));
            let (line, of) = (*line_of.get(&curve)?, *line_of.get(&other)?);
            Some(PeriodicLine { line, of, matrix, vertices: pairs.collect() })
        };
        self.0.into_iter().filter_map(line).collect()
    }
}

/// The contents of `$Periodic`: dimension, both tags, the matrix, and the pairs of nodes.
pub(super) fn links(periodic: &[PeriodicLine], version: MshVersion, numbers: Numbers) -> Vec<u8> {
    let mut list = b"$Periodic\n".to_vec();
    let put = |link: &PeriodicLine, list: &mut Vec<u8>| {
        let is_v4 = version == MshVersion::V4;
        let numbers = if is_v4 { numbers } else { Numbers::Text };
        numbers.put([1, link.line as i32 + 1, link.of as i32 + 1], list);
        numbers.end_line(list);
        match is_v4 {
            true => numbers.put([16_u64], list),
            false => list.extend_from_slice(b"Affine "),
        }
        link.matrix.iter().for_each(|row| numbers.put(*row, list));
        numbers.end_line(list);
        numbers.put([link.vertices.len() as u64], list);
        numbers.end_line(list);
        for pair in &link.vertices {
            numbers.put(pair.map(|node| u64::from(node) + 1), list);
            numbers.end_line(list);
        }
    };
    match version {
        MshVersion::V4 => numbers.put([periodic.len() as u64], &mut list),
        MshVersion::V2 => Numbers::Text.put([periodic.len() as u64], &mut list),
    }
    if version == MshVersion::V2 || numbers == Numbers::Text {
        list.push(b'\n');
    }
    periodic.iter().for_each(|link| put(link, &mut list));
    list
}
