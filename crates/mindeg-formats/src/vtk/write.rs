//! Writing legacy VTK.

use std::io::Write;

use mindeg_mesh::Mesh;

use crate::grid::Arrays;
use crate::names::one_line;
use crate::scanner::Numbers;
use crate::sections::{Section, write_sections};
use crate::{Encoding, Format, WriteError, WriteOptions, mesh_name};

/// The longest second line, with its end.
const TITLE: usize = 256;

/// Writes a mesh as legacy VTK, in binary or text.
///
/// O(n) time, shared by all threads of rayon's current pool, and the memory of one block of about
/// half a MiB for each of them, and one more. Writes are large: `out` needs no buffer around it.
///
/// # Errors
///
/// [`TooLarge`](WriteError::TooLarge) before the first byte, and those of `out`.
///
/// # Example
///
/// ```
/// use mindeg_formats::{WriteOptions, obj, vtk};
///
/// let mesh = obj::read("v 0 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\no wall\nl 1 2\n".as_bytes())?;
/// let mut file = Vec::new();
/// vtk::write(&mesh, &WriteOptions::default(), &mut file)?;
/// let read = vtk::read(&file[..])?;
/// assert_eq!((read.triangles(), read.segments()), (mesh.triangles(), mesh.segments()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(
    mesh: &dyn Mesh,
    options: &WriteOptions,
    mut out: impl Write,
) -> Result<(), WriteError> {
    check_size(mesh.vertex_count())?;
    write_sections(&mut out, &sections(mesh, options))?;
    Ok(out.flush()?)
}

/// Refuses a mesh whose vertices 31 bits do not tell apart. O(1).
pub(crate) fn check_size(vertices: u32) -> Result<(), WriteError> {
    const LIMIT: u32 = i32::MAX as u32;
    if vertices > LIMIT {
        return Err(WriteError::TooLarge {
            format: Format::Vtk,
            what: "vertices",
            count: vertices.into(),
            limit: LIMIT.into(),
        });
    }
    Ok(())
}

/// The file from front to back.
pub(crate) fn sections<'a>(mesh: &'a dyn Mesh, options: &WriteOptions) -> Vec<Section<'a>> {
    let is_binary = options.encoding == Encoding::Binary;
    let (kind, numbers) =
        if is_binary { ("BINARY", Numbers::BigEndian) } else { ("ASCII", Numbers::Text) };
    let arrays = Arrays::new(mesh, numbers, options.fields);
    let (points, cells) = (arrays.vertex_count(), arrays.cell_count());
    let mut file = File { is_binary, sections: Vec::new() };
    let title = title(mesh_name(mesh));
    file.text(format!(
        "# vtk DataFile Version 4.2\n{title}\n{kind}\nDATASET UNSTRUCTURED_GRID\n\
         POINTS {points} double\n"
    ));
    file.numbers(vec![arrays.points()]);
    file.text(format!("CELLS {cells} {}\n", cells + arrays.corner_count()));
    file.numbers(arrays.counted_cells());
    file.text(format!("CELL_TYPES {cells}\n"));
    file.numbers(arrays.wide_types());
    if options.fields {
        file.text(format!("POINT_DATA {points}\n"));
        file.scalars("degree", "int", vec![arrays.degrees()]);
        file.text(format!("CELL_DATA {cells}\n"));
        file.scalars("min_angle", "double", arrays.min_angles());
        if arrays.segments > 0 {
            file.scalars("side", "int", arrays.sides());
        }
        if mesh.groups().len() > 1 {
            file.scalars("group", "int", arrays.groups());
        }
    }
    file.sections
}

/// A name in one line that is not too long.
fn title(name: &str) -> String {
    let mut title = one_line(name);
    while title.len() >= TITLE {
        title.pop();
    }
    title
}

struct File<'a> {
    is_binary: bool,
    sections: Vec<Section<'a>>,
}

impl<'a> File<'a> {
    fn text(&mut self, text: String) {
        self.sections.push(Section::bytes(text));
    }

    fn numbers(&mut self, sections: Vec<Section<'a>>) {
        self.sections.extend(sections);
        if self.is_binary {
            self.text("\n".to_owned());
        }
    }

    fn scalars(&mut self, name: &str, kind: &str, sections: Vec<Section<'a>>) {
        self.text(format!("SCALARS {name} {kind} 1\nLOOKUP_TABLE default\n"));
        self.numbers(sections);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_title_is_one_line_that_ends() {
        assert_eq!(title("a\nb"), "a b");
        assert_eq!(title(&"ä".repeat(200)).len(), 254);
    }
}
