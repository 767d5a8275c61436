//! OFF, the Object File Format of Geomview, as text.
//!
//! Limits: names, groups, lines and colors are not kept. Binary OFF and `4OFF` are not read.

use crate::ReadError;
use crate::corners::{positions, triangles};
use crate::dropped;
use crate::face_list::FaceList;
use crate::facts::Facts;
use crate::lists::push;
use crate::numbers::Numbers;
use crate::records::Records;
use crate::sections::Section;
use crate::{MeshPlane, made_by};
use mindeg_mesh::{Mesh, NonTriangles, TriMesh};
use std::io::BufRead;

pub(crate) const FACTS: Facts = Facts {
    name: "off",
    description: "Object File Format",
    extensions: &["off"],
    first_words: &["OFF", "COFF", "NOFF", "STOFF", "CNOFF"],
    read: Some(|source| read(source.input)),
    write: |job, files| job.write(files, [sections(job.mesh, job.options.surface.plane)]),
    ..Facts::NONE
};

/// The file from front to back.
fn sections(mesh: &dyn Mesh, plane: MeshPlane) -> Vec<Section<'_>> {
    let (vertices, faces) = (mesh.vertex_count(), mesh.triangle_count());
    let points = move |range| positions(mesh, range).map(move |p| plane.place(p).to_array());
    let corners = |range| triangles(mesh, range).into_iter().map(|corners| ([3], corners));
    vec![
        Section::bytes(format!("OFF\n# {}\n{vertices} {faces} 0\n", made_by(mesh))),
        Numbers::Text.records(0..vertices, points),
        Numbers::Text.records(0..faces, corners),
    ]
}

/// Reads a mesh from a text OFF, with or without the keyword `OFF` and what may come before it (`C`,
/// `N`, `ST`): colors, normals and texture coordinates are passed over.
///
/// Faces of more than three corners are kept as the mesh's polygons; of fewer, they are left out,
/// with a note. O(n) time and memory for n bytes, whatever the file says, but for the cutting of
/// polygons.
///
/// # Errors
///
/// Errors of the input; lines that break the format; corners that the file has no
/// vertex for; a file without faces.
///
/// # Example
///
/// ```
/// use mindeg_formats::off;
///
/// let mesh = off::read("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n".as_bytes())?;
/// assert_eq!(mesh.triangles(), [[0, 1, 2]]);
///
/// let error = off::read("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n".as_bytes()).unwrap_err();
/// assert_eq!(error.to_string(), "line 6: vertex 3 does not exist; the file has 3, from 0");
/// # Ok::<(), mindeg_formats::ReadError>(())
/// ```
pub fn read(input: impl BufRead) -> Result<TriMesh, ReadError> {
    let mut records = Records::new(input, Some(b'#'));
    let mut words = records.expect("its head")?;
    let line = words;
    let keyword = words.word().unwrap_or_default();
    let before = keyword.strip_suffix(b"OFF").unwrap_or_default();
    let (is_textured, before) = match before.strip_prefix(b"ST") {
        Some(rest) => (true, rest),
        None => (false, before),
    };
    let mut is_colored = before.contains(&b'C');
    let has_normals = before.contains(&b'N');
    if !keyword.ends_with(b"OFF") {
        words = line;
    } else if keyword.contains(&b'4') || keyword.contains(&b'n') || words.rest.ends_with(b"BINARY")
    {
        return Err(line.problem("only text OFF files in three dimensions are read"));
    }
    if words.is_empty() {
        words = records.expect("the number of vertices")?;
    }
    let vertices = words.count("the number of vertices")?;
    let count = words.count("the number of faces")?;
    let mut points = Vec::new();
    for _ in 0..vertices {
        let mut words = records.expect("its last vertex")?;
        push(&mut points, words.point("z")?)?;
    }
    let mut faces = FaceList::default();
    let mut corners = Vec::new();
    let mut short = 0_u64;
    for _ in 0..count {
        let mut words = records.expect("its last face")?;
        corners.clear();
        for _ in 0..words.count("the number of corners")? {
            let corner = words.count("the number of a vertex")?;
            if corner >= vertices {
                let problem =
                    format!("vertex {corner} does not exist; the file has {vertices}, from 0");
                return Err(words.problem(problem));
            }
            // More vertices than 32 bits count are refused at the end.
            push(&mut corners, corner as u32)?;
        }
        is_colored |= !words.is_empty();
        short += u64::from(corners.len() < 3);
        faces.push(&corners)?;
    }
    let mesh = faces.into_mesh(points, NonTriangles::default())?.with_dropped(dropped::found([
        (dropped::TEXTURE, is_textured),
        (dropped::NORMALS, has_normals),
        (dropped::COLORS, is_colored),
    ]));
    let note = format!("faces with fewer than three corners, left out: {short}");
    Ok(if short > 0 { mesh.with_notes(vec![note]) } else { mesh })
}
