//! 2DM, the mesh files of the Surface-water Modeling System and of programs around it.
//!
//! Vertices and triangles count from 1 without gaps; groups are materials; each line of the mesh is
//! a node string; those of one name have one number. z counts upwards: it is the bed's height, and so the depth with the other sign.
//!
//! Limits: names of groups and lines are not kept, since the format has numbers for them.

use crate::boundary::{MarkedChain, MarkedChains, chain_vertices};
use crate::corners::positions;
use crate::decimals::push_integer;
use crate::facts::Facts;
use crate::names::quoted;
use crate::numbered::Numbered;
use crate::records::{Records, Words};
use crate::sections::Section;
use crate::tables::{NamedRuns, corners_from_one, numbered_lines};
use crate::{ReadError, made_by, mesh_name};
use mindeg_mesh::{Mesh, TriMesh, filled};
use std::io::BufRead;
use std::ops::Range;

/// Vertices of a node string to a line of the file.
const STRING_WIDTH: u32 = 10;

pub(crate) const FACTS: Facts = Facts {
    name: "2dm",
    description: "SMS .2dm",
    extensions: &["2dm"],
    leaves_out_depths: false,
    has_boundary: true,
    first_words: &["MESH2D"],
    read: Some(|source| read(source.input)),
    write: |job, files| job.write(files, [sections(job.mesh)]),
    ..Facts::NONE
};

/// The file from front to back.
fn sections(mesh: &dyn Mesh) -> Vec<Section<'_>> {
    let name = quoted(mesh_name(mesh));
    let groups = NamedRuns::of_groups(mesh);
    let elements = move |range: Range<u32>| {
        let materials = groups.of(range.clone()).map(|group| [group + 1]);
        corners_from_one(mesh, range).zip(materials)
    };
    let head = format!("MESH2D\n# {}\nMESHNAME \"{name}\"\n", made_by(mesh));
    let mut sections = vec![
        Section::bytes(head),
        numbered_lines("E3T", 0..mesh.triangle_count(), elements),
        numbered_lines("ND", 0..mesh.vertex_count(), |range| points(mesh, range)),
    ];
    let chains = MarkedChains::of(mesh).chains;
    sections.extend(chains.into_iter().map(|chain| node_string(mesh, chain)));
    sections
}

/// Each vertex; where the mesh has depths, z is the height of the bed.
fn points(mesh: &dyn Mesh, range: Range<u32>) -> impl Iterator<Item = [f64; 3]> {
    let depths = filled(range.clone(), 0.0, |first, out| mesh.fill_depths(first, out));
    positions(mesh, range).zip(depths).map(|(point, depth)| [point.x, point.y, point.z - depth])
}

/// The vertices of a chain, the last with a minus sign before it, then the number of its name.
fn node_string(mesh: &dyn Mesh, chain: MarkedChain) -> Section<'_> {
    let id = chain.name + 1;
    let last = chain.segments.len() as u32;
    Section::new(last.saturating_add(1), 11, move |range, buffer| {
        for (index, vertex) in range.clone().zip(chain_vertices(mesh, &chain, range)) {
            if index % STRING_WIDTH == 0 {
                buffer.extend_from_slice(b"NS");
            }
            let number = i64::from(vertex) + 1;
            if index == last {
                push_integer(-number, buffer);
                push_integer(id, buffer);
            } else {
                push_integer(number, buffer);
            }
            if index == last || index % STRING_WIDTH == STRING_WIDTH - 1 {
                buffer.push(b'\n');
            }
        }
    })
}

/// Reads a mesh from a 2DM.
///
/// Triangles (`E3T`) and quadrilaterals (`E4Q`) of different materials become groups, if those of a
/// material follow one another; node strings (`NS`) become lines, `E2L` and `E3L` are counted. Of
/// elements with vertices on their sides (`E6T`, `E8Q`, `E9Q`) the corners are taken. Vertices may
/// have any numbers. Other lines are passed over. If seen from above all triangles are counter-clockwise, the mesh is flat, and
/// z gives its depths; else it is a surface in space.
///
/// O(n log n) time and O(n) memory for n bytes.
///
/// # Errors
///
/// Errors of the input; lines that break the format; elements and node strings that
/// name vertices that the file does not have; a file without elements.
///
/// # Example
///
/// ```
/// use mindeg_formats::sms2dm;
///
/// let file = "MESH2D\nE3T 1 7 8 9 1\nND 7 0 0 0\nND 8 1 0 0\nND 9 0 1 0\nNS 7 -8 1\n";
/// let mesh = sms2dm::read(file.as_bytes())?;
/// assert_eq!((mesh.triangles(), mesh.segments()), (&[[0, 1, 2]][..], &[[0, 1]][..]));
///
/// let error = sms2dm::read(file.replace("8 9 1", "8 6 1").as_bytes()).unwrap_err();
/// assert_eq!(error.to_string(), "line 2: vertex 6 does not exist; the file has 7 to 9");
/// # Ok::<(), mindeg_formats::ReadError>(())
/// ```
pub fn read(input: impl BufRead) -> Result<TriMesh, ReadError> {
    let mut records = Records::new(input, Some(b'#'));
    let mut contents = Numbered::default();
    let mut name = None;
    // The vertices of the node string so far, each with its line, and how many were before.
    let mut string = Vec::new();
    let mut strings = 0_u32;
    while let Some(mut words) = records.next()? {
        match words.word().unwrap_or_default() {
            b"MESHNAME" => name = Some(words.text().trim_matches('"').to_owned()),
            b"ND" => {
                let id = words.id()?;
                contents.nodes.push(id.into(), words.point("z")?)?;
            }
            b"E3T" => element(&mut contents, words, [0, 1, 2], 3)?,
            b"E4Q" => element(&mut contents, words, [0, 1, 2, 3], 4)?,
            b"E6T" => element(&mut contents, words, [0, 2, 4], 6)?,
            b"E8Q" => element(&mut contents, words, [0, 2, 4, 6], 8)?,
            b"E9Q" => element(&mut contents, words, [0, 2, 4, 6], 9)?,
            b"NS" => {
                while !words.is_empty() {
                    let id = words.integer("the number of a vertex")?;
                    let number = u32::try_from(id.unsigned_abs())
                        .map_err(|_| words.problem(format!("the vertex {id} is beyond 32 bits")))?;
                    crate::lists::push(&mut string, (number, words.line))?;
                    if id < 0 {
                        strings += 1;
                        let name = match words.text() {
                            text if text.is_empty() => strings.to_string(),
                            text => text,
                        };
                        contents.string(&format!("node string {name}"), None, string.drain(..))?;
                        break;
                    }
                }
            }
            _ => {}
        }
    }
    let mesh = contents.into_mesh("material")?.with_bed_as_depths();
    Ok(mesh.called(name.filter(|name| !name.is_empty())))
}

/// An element: its number, `count` vertices of which some are corners, and its material.
fn element<const N: usize>(
    contents: &mut Numbered,
    mut words: Words<'_>,
    corners: [usize; N],
    count: usize,
) -> Result<(), ReadError> {
    words.id()?;
    let mut vertices = [0; 9];
    for vertex in &mut vertices[..count] {
        *vertex = words.id()?;
    }
    let material = if words.is_empty() { 1 } else { words.number("the material")? as i64 };
    Ok(contents.element(words.line, &corners.map(|corner| vertices[corner]), material)?)
}
