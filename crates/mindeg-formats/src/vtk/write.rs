//! Writing legacy VTK.

use mindeg_mesh::Mesh;

use crate::grid::Arrays;
use crate::names::one_line;
use crate::scanner::Numbers;
use crate::sections::Section;
use crate::{Encoding, WriteOptions, mesh_name};

/// The longest second line, with its end.
const TITLE: usize = 256;

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
