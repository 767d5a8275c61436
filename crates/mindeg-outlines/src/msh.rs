//! Gmsh's MSH 4.1 and 2.2 as text, with line elements: what `gmsh -1` writes.
//!
//! The closed loops of the line elements are rings, with the nodes' coordinates bit for bit. A
//! curve of the geometry is a side; the name of its physical group is the side's name. Loops inside
//! others are holes. Triangles and other elements are left out if there are lines.
//!
//! Limits: no binary files; second-order lines are read as lines between their ends.

mod content;
mod rows;
mod v2;
mod v4;

use self::content::File;
use self::rows::Rows;
use super::outline::Outlines;
use super::text::{at_line, quoted, text_of, whole_at};
use crate::error::ReadError;

/// Reads the line elements of a text file of version 4.1 or 2.2.
///
/// # Errors
///
/// Binary files and other versions; what is not as the format has it, with its line; elements that
/// refer to nodes that are not there; lines that close no ring.
pub(super) fn read(bytes: &[u8]) -> Result<Outlines, ReadError> {
    // The header of a binary file is text.
    if bytes.starts_with(b"$MeshFormat") {
        let mut header = bytes
            .splitn(3, |&byte| byte == b'\n')
            .nth(1)
            .unwrap_or_default()
            .trim_ascii()
            .split(|&byte| byte == b' ');
        if header.nth(1) == Some(b"1") {
            return Err(at_line(2, "this is a binary file; write text with Mesh.Binary = 0"));
        }
    }
    let mut rows = Rows::new(text_of(bytes)?);
    let mut file = File::default();
    let mut version = None;
    while let Some((line, text)) = rows.try_next() {
        let Some(section) = text.strip_prefix('$') else {
            return Err(at_line(
                line,
                format!("found {}, expected a section such as $Nodes", quoted(text)),
            ));
        };
        match (section, version) {
            ("MeshFormat", _) => version = Some(format_version(&mut rows)?),
            ("PhysicalNames", Some(_)) => physical_names(&mut rows, &mut file)?,
            ("Entities", Some(Version::V4)) => v4::entities(&mut rows, &mut file)?,
            ("Nodes", Some(Version::V4)) => v4::nodes(&mut rows, &mut file)?,
            ("Elements", Some(Version::V4)) => v4::elements(&mut rows, &mut file)?,
            ("Nodes", Some(Version::V2)) => v2::nodes(&mut rows, &mut file)?,
            ("Elements", Some(Version::V2)) => v2::elements(&mut rows, &mut file)?,
            ("Nodes" | "Elements" | "Entities", None) => {
                return Err(at_line(line, format!("${section} stands before $MeshFormat")));
            }
            _ => {}
        }
        rows.skip_to_end_of(section, line)?;
    }
    if version.is_none() {
        return Err(at_line(1, "the section $MeshFormat is missing"));
    }
    file.outlines()
}

#[derive(Clone, Copy)]
enum Version {
    V2,
    V4,
}

fn format_version(rows: &mut Rows<'_>) -> Result<Version, ReadError> {
    let mut row = rows.next("the version")?;
    let version = row.words.next().unwrap_or_default();
    if row.words.next() != Some("0") {
        return Err(at_line(row.line, "this is a binary file; write text with Mesh.Binary = 0"));
    }
    match version {
        "4.1" => Ok(Version::V4),
        "2" | "2.0" | "2.1" | "2.2" => Ok(Version::V2),
        other => Err(at_line(
            row.line,
            format!("found the version {}, expected 4.1 or 2.2", quoted(other)),
        )),
    }
}

fn physical_names(rows: &mut Rows<'_>, file: &mut File) -> Result<(), ReadError> {
    let count = rows.next("the number of names")?.whole("number of names")?;
    for _ in 0..count {
        let Some((line, text)) = rows.try_next().filter(|(_, text)| !text.starts_with('$')) else {
            return Err(at_line(rows.last, "the section ends where a name should be"));
        };
        let mut words = text.splitn(3, char::is_whitespace);
        let dimension = whole_at(line, words.next(), "dimension")?;
        let tag = whole_at(line, words.next(), "tag of the group")?;
        let name = words.next().unwrap_or_default().trim().trim_matches('"');
        if dimension == 1 && !name.trim().is_empty() {
            file.names.insert(tag, name.into());
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
