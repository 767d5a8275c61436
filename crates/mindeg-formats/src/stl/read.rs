//! Reading STL.

use crate::ReadError;
use crate::bytes::Bytes;
use crate::lists::push;
use crate::records::Records;
use glam::{DVec3, Vec3};
use mindeg_mesh::parallel::sort_all;
use mindeg_mesh::{Group, TriMesh, TriMeshError};
use std::io::{BufRead, Read};

/// How long the head of a binary file is: a comment of 80 bytes, and the number of triangles.
const HEAD: usize = 84;
/// How long a triangle is: a normal, three corners, and two bytes of anything.
const FACET: usize = 50;

/// Reads a mesh from an STL, text or binary.
///
/// Corners at exactly the same coordinates are one vertex; vertices are in the order in which
/// triangles first name them. Triangles run as their corners do, whatever the normals say, which
/// are passed over. Each `solid` of a text is a group.
///
/// A file is binary if its length is what its number of triangles says, or if its first word is
/// not `solid`; else text. O(n log n) time and O(n) memory for n bytes, whatever the file says.
///
/// # Errors
///
/// Errors of the input; lines or bytes that break the format; coordinates that are not
/// finite; a binary file with fewer or more triangles than it says; a file without triangles.
///
/// # Example
///
/// ```
/// use mindeg_formats::stl;
///
/// let file = "solid roof\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n\
///             vertex 0 1 0\nendloop\nendfacet\nendsolid roof\n";
/// let mesh = stl::read(file.as_bytes())?;
/// assert_eq!((mesh.triangles(), &*mesh.groups()[0].name), (&[[0, 1, 2]][..], "roof"));
///
/// let error = stl::read(file.replace("endloop", "vertex 1 1 0").as_bytes()).unwrap_err();
/// assert_eq!(error.to_string(), "line 7: \"vertex\" where endloop is expected");
/// # Ok::<(), mindeg_formats::ReadError>(())
/// ```
pub fn read(mut input: impl BufRead) -> Result<TriMesh, ReadError> {
    let mut head = Vec::new();
    input.by_ref().take(HEAD as u64).read_to_end(&mut head)?;
    let text = head.strip_prefix("\u{feff}".as_bytes()).unwrap_or(&head);
    if !text.trim_ascii_start().starts_with(b"solid") {
        return read_binary(&head, input);
    }
    // Only the length tells what this is.
    let mut rest = Vec::new();
    input.read_to_end(&mut rest)?;
    let facets = count(&head).and_then(|count| (count as usize).checked_mul(FACET));
    if facets == Some(rest.len()) {
        return read_binary(&head, &rest[..]);
    }
    read_text((&head[..]).chain(&rest[..]))
}

/// The number of triangles that the head of a binary file gives.
fn count(head: &[u8]) -> Option<u32> {
    Some(u32::from_le_bytes(head.get(80..HEAD)?.try_into().ok()?))
}

fn read_binary(head: &[u8], mut input: impl BufRead) -> Result<TriMesh, ReadError> {
    let count = count(head).ok_or_else(|| {
        let problem = "the file ends here; an STL is a text that begins with \"solid\", or has a \
                       head of 84 bytes";
        ReadError::byte(head.len(), problem)
    })?;
    let mut corners = Vec::new();
    let mut bytes = Bytes::new(&mut input, HEAD as u64);
    for triangle in 0..count {
        let mut facet = [0; FACET];
        bytes.fill(&mut facet, &format!("triangle {triangle} (from 0) of {count}"))?;
        let (numbers, _) = facet.as_chunks();
        for corner in numbers[3..12].as_chunks::<3>().0 {
            let corner = Vec3::from_array(corner.map(f32::from_le_bytes));
            if !corner.is_finite() {
                let problem = format!(
                    "triangle {triangle} (from 0) has a coordinate that is not \
                                       finite"
                );
                return Err(bytes.problem(problem));
            }
            push(&mut corners, corner.as_dvec3())?;
        }
    }
    if !bytes.is_at_end()? {
        return Err(bytes.problem(format!("the file goes on after its {count} triangles")));
    }
    welded(corners, Vec::new(), true)
}

fn read_text(input: impl BufRead) -> Result<TriMesh, ReadError> {
    let mut records = Records::new(input, None);
    let mut corners = Vec::new();
    let mut groups: Vec<Group> = Vec::new();
    while let Some(mut words) = records.next()? {
        let keyword = words.word().unwrap_or_default().to_ascii_lowercase();
        // More triangles than 32 bits count are refused at the end.
        let triangles = (corners.len() / 3) as u32;
        match &keyword[..] {
            b"solid" => {
                groups.push(Group::new(words.text(), triangles..triangles));
            }
            b"facet" => {
                if groups.is_empty() {
                    return Err(words.problem("a facet before the first solid"));
                }
                read_facet(&mut records, &mut corners)?;
            }
            b"endsolid" => {}
            _ => {
                let word = String::from_utf8_lossy(&keyword);
                let problem = format!("{word:?} where facet, endsolid or solid is expected");
                return Err(words.problem(problem));
            }
        }
        if let Some(group) = groups.last_mut() {
            group.triangles.end = (corners.len() / 3) as u32;
        }
    }
    welded(corners, groups, false)
}

/// Reads what follows the line `facet`.
fn read_facet(
    records: &mut Records<impl BufRead>,
    corners: &mut Vec<DVec3>,
) -> Result<(), ReadError> {
    let keywords = ["outer", "vertex", "vertex", "vertex", "endloop", "endfacet"];
    for keyword in keywords {
        let mut words = records.expect(keyword)?;
        let word = words.word().unwrap_or_default();
        if !word.eq_ignore_ascii_case(keyword.as_bytes()) {
            let word = String::from_utf8_lossy(word);
            return Err(words.problem(format!("{word:?} where {keyword} is expected")));
        }
        if keyword == "vertex" {
            push(corners, words.point("z")?)?;
        }
    }
    Ok(())
}

/// The mesh of triangles by their corners.
fn welded(corners: Vec<DVec3>, groups: Vec<Group>, is_binary: bool) -> Result<TriMesh, ReadError> {
    let count = corners.len();
    if u32::try_from(count).is_err() {
        return Err(TriMeshError::too_many("triangles", count / 3).into());
    }
    // Adding zero turns -0 into 0, so that equal numbers have equal bits.
    let bits = |corner: DVec3| (corner + DVec3::ZERO).to_array().map(f64::to_bits);
    let mut sorted = Vec::new();
    sorted.try_reserve_exact(count)?;
    sorted.extend((0_u32..).zip(&corners).map(|(index, &corner)| (bits(corner), index)));
    sort_all(&mut sorted);
    let mut vertices = Vec::new();
    vertices.try_reserve_exact(count)?;
    vertices.resize(count, 0);
    // First the first corner at the same place, then the vertex, which comes with that corner.
    for same in sorted.chunk_by(|a, b| a.0 == b.0) {
        same.iter().for_each(|&(_, index)| vertices[index as usize] = same[0].1);
    }
    drop(sorted);
    let mut positions = Vec::new();
    for index in 0..count {
        let first = vertices[index] as usize;
        if first == index {
            vertices[index] = positions.len() as u32;
            push(&mut positions, corners[index])?;
        } else {
            vertices[index] = vertices[first];
        }
    }
    let largest = positions.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    let mesh = TriMesh::new(positions, vertices.as_chunks().0.to_vec())?;
    let mesh = if groups.is_empty() { mesh } else { mesh.with_groups(groups) };
    // Half a unit in the last place of a 32-bit float.
    let rounding = if is_binary { largest * f64::from(f32::EPSILON) / 2.0 } else { 0.0 };
    Ok(mesh.with_rounding(rounding))
}
