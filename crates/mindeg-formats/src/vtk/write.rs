//! Writing legacy VTK.

use mindeg_mesh::Mesh;

use crate::grid::{Arrays, Field};
use crate::names::one_line;
use crate::numbers::Numbers;
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
    let (points, cells) = (mesh.vertex_count(), arrays.cell_count());
    let mut file = Vec::new();
    let mut add = |head: String, numbers: Vec<Section<'a>>| {
        file.push(Section::bytes(head));
        file.extend(numbers);
        if is_binary {
            file.push(Section::bytes("\n"));
        }
    };
    let title = title(mesh_name(mesh));
    let head = format!(
        "# vtk DataFile Version 4.2\n{title}\n{kind}\nDATASET UNSTRUCTURED_GRID\n\
         POINTS {points} double\n"
    );
    add(head, arrays.points());
    let size = cells + arrays.corner_count();
    add(format!("CELLS {cells} {size}\n"), arrays.counted_cells());
    add(format!("CELL_TYPES {cells}\n"), arrays.types::<i32>());
    if options.fields {
        let mut head = format!("POINT_DATA {points}\n");
        let of_points = [(arrays.degrees(), format!("CELL_DATA {cells}\n"))];
        let of_cells = arrays.of_cells().into_iter().map(|field| (field, String::new()));
        for (Field { name, is_float, sections }, next) in of_points.into_iter().chain(of_cells) {
            let kind = if is_float { "double" } else { "int" };
            head += &format!("SCALARS {name} {kind} 1\nLOOKUP_TABLE default\n");
            add(std::mem::replace(&mut head, next), sections);
        }
    }
    file
}

/// A name in one line that is not too long.
fn title(name: &str) -> String {
    let mut title = one_line(name);
    while title.len() >= TITLE {
        title.pop();
    }
    title
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
