//! Writing NPZ.

use super::array::head;
use super::zip::Archive;
use crate::corners::{degrees, min_angles, positions, triangles};
use crate::numbers::Numbers;
use crate::sections::{Section, write_sections};
use mindeg_mesh::Mesh;
use std::io::{self, Write};

/// Writes a mesh as NPZ, with `degrees` and `min_angles` if `fields` are asked for.
pub(super) fn write(mesh: &dyn Mesh, fields: bool, out: impl Write + Send) -> io::Result<()> {
    let mut archive = Archive::new(out);
    let (vertices, count) = (mesh.vertex_count(), mesh.triangle_count());
    let numbers = Numbers::LittleEndian;
    let points = |range| positions(mesh, range).map(|point| point.to_array());
    let corners = |range| triangles(mesh, range).into_iter();
    let mut arrays = vec![
        ("points.npy", head("<f8", vertices, Some(3)), numbers.records(0..vertices, points)),
        ("triangles.npy", head("<u4", count, Some(3)), numbers.records(0..count, corners)),
    ];
    if fields {
        let degrees = |range| degrees(mesh, range).into_iter().map(|degree| [degree]);
        let degrees = numbers.records(0..vertices, degrees);
        arrays.push(("degrees.npy", head("<u4", vertices, None), degrees));
        let angles = |range| min_angles(mesh, range).map(|angle| [angle]);
        let angles = numbers.records(0..count, angles);
        arrays.push(("min_angles.npy", head("<f8", count, None), angles));
    }
    for (name, head, rows) in arrays {
        let sections = [Section::bytes(head), rows];
        let len = sections.iter().map(Section::byte_len).sum();
        archive.entry(name, len, |mut out| write_sections(&mut out, &sections))?;
    }
    archive.finish()
}
