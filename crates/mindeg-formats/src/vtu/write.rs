//! Writing VTU.

use mindeg_mesh::Mesh;

use crate::grid::{Arrays, text_of_names};
use crate::scanner::Numbers;
use crate::sections::Section;
use crate::{Encoding, GENERATOR, WriteOptions};

/// One array of the file.
struct Array<'a> {
    /// The start of its element, up to how it is stored.
    head: String,
    /// Its length in bytes.
    len: u64,
    sections: Vec<Section<'a>>,
}

/// The file from front to back.
pub(crate) fn sections<'a>(mesh: &'a dyn Mesh, options: &WriteOptions) -> Vec<Section<'a>> {
    let is_binary = options.encoding == Encoding::Binary;
    let numbers = if is_binary { Numbers::LittleEndian } else { Numbers::Text };
    let arrays = Arrays::new(mesh, numbers, options.fields);
    let (points, cells) = (arrays.vertex_count(), arrays.cell_count());
    let mut file = File { is_binary, ..File::default() };

    file.text(&format!(
        "<?xml version=\"1.0\"?>\n<!-- {GENERATOR} -->\n<VTKFile type=\"UnstructuredGrid\" \
         version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
    ));
    if options.fields {
        let sides = mesh.lines();
        let lists = [
            ("side_names", sides.iter().map(|line| &*line.name).collect::<Vec<_>>()),
            ("group_names", mesh.groups().iter().map(|group| group.label()).collect()),
        ];
        file.text("<FieldData>\n");
        for (name, names) in lists {
            if names.iter().any(|name| !name.is_empty()) {
                let (text, len) = text_of_names(names.into_iter(), numbers);
                let head = format!("type=\"UInt8\" Name=\"{name}\" NumberOfTuples=\"{len}\"");
                file.array(Array { head, len: len as u64, sections: vec![Section::bytes(text)] });
            }
        }
        file.text("</FieldData>\n");
    }
    file.text(&format!("<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">\n"));
    if options.fields {
        file.text("<PointData Scalars=\"degree\">\n");
        file.add("Int32", "degree", 4 * points, vec![arrays.degrees()]);
        file.text("</PointData>\n<CellData Scalars=\"min_angle\">\n");
        file.add("Float64", "min_angle", 8 * cells, arrays.min_angles());
        if arrays.segments > 0 {
            file.add("Int32", "side", 4 * cells, arrays.sides());
        }
        if mesh.groups().len() > 1 {
            file.add("Int32", "group", 4 * cells, arrays.groups());
        }
        file.text("</CellData>\n");
    }
    file.text("<Points>\n");
    let head = "type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"".to_owned();
    file.array(Array { head, len: 24 * points, sections: vec![arrays.points()] });
    file.text("</Points>\n<Cells>\n");
    file.add("Int64", "connectivity", 8 * arrays.corner_count(), arrays.connectivity());
    file.add("Int64", "offsets", 8 * cells, arrays.offsets());
    file.add("UInt8", "types", cells, arrays.types());
    file.text("</Cells>\n</Piece>\n</UnstructuredGrid>\n");
    file.finish()
}

/// The file so far.
#[derive(Default)]
struct File<'a> {
    is_binary: bool,
    sections: Vec<Section<'a>>,
    /// XML that is not yet among the sections.
    xml: String,
    appended: Vec<Section<'a>>,
    /// The length of what is appended.
    offset: u64,
}

impl<'a> File<'a> {
    fn text(&mut self, text: &str) {
        self.xml += text;
    }

    fn add(&mut self, kind: &str, name: &str, len: u64, sections: Vec<Section<'a>>) {
        self.array(Array { head: format!("type=\"{kind}\" Name=\"{name}\""), len, sections });
    }

    fn array(&mut self, array: Array<'a>) {
        let Array { head, len, sections } = array;
        if self.is_binary {
            let offset = self.offset;
            self.text(&format!("<DataArray {head} format=\"appended\" offset=\"{offset}\"/>\n"));
            self.appended.push(Section::bytes(len.to_le_bytes()));
            self.appended.extend(sections);
            self.offset += 8 + len;
        } else {
            self.text(&format!("<DataArray {head} format=\"ascii\">\n"));
            self.sections.push(Section::bytes(std::mem::take(&mut self.xml)));
            self.sections.extend(sections);
            self.text("</DataArray>\n");
        }
    }

    fn finish(mut self) -> Vec<Section<'a>> {
        if self.is_binary {
            self.text("<AppendedData encoding=\"raw\">\n_");
            self.sections.push(Section::bytes(std::mem::take(&mut self.xml)));
            self.sections.append(&mut self.appended);
            self.text("\n</AppendedData>\n");
        }
        self.text("</VTKFile>\n");
        self.sections.push(Section::bytes(self.xml));
        self.sections
    }
}
