//! Writing VTU.

use mindeg_mesh::Mesh;

use crate::grid::{Arrays, Field, text_of_names};
use crate::numbers::Numbers;
use crate::sections::Section;
use crate::tables::NamedRuns;
use crate::{Encoding, WriteOptions, made_by};

/// The file from front to back.
pub(crate) fn sections<'a>(mesh: &'a dyn Mesh, options: &WriteOptions) -> Vec<Section<'a>> {
    let is_binary = options.encoding == Encoding::Binary;
    let numbers = Numbers::of(options.encoding);
    let arrays = Arrays::new(mesh, numbers, options.fields);
    let (points, cells) = (mesh.vertex_count(), arrays.cell_count());
    let mut file = File { is_binary, ..File::default() };

    // Two hyphens would end the remark.
    let made_by = made_by(mesh).replace("--", "%2D%2D");
    file.text(&format!(
        "<?xml version=\"1.0\"?>\n<!-- {made_by} -->\n<VTKFile type=\"UnstructuredGrid\" \
         version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
    ));
    if options.fields {
        let lists = [
            ("side_names", NamedRuns::of_lines(mesh).names),
            ("group_names", NamedRuns::of_groups(mesh).names),
        ];
        file.text("<FieldData>\n");
        for (name, names) in lists {
            if names.iter().any(|name| !name.is_empty()) {
                let (text, len) = text_of_names(&names, numbers);
                let head = format!("type=\"UInt8\" Name=\"{name}\" NumberOfTuples=\"{len}\"");
                file.array(&head, vec![Section::bytes(text)]);
            }
        }
        file.text("</FieldData>\n");
    }
    file.text(&format!("<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">\n"));
    if options.fields {
        file.text("<PointData Scalars=\"degree\">\n");
        file.field(arrays.degrees());
        file.text("</PointData>\n<CellData Scalars=\"min_angle\">\n");
        arrays.of_cells().into_iter().for_each(|field| file.field(field));
        file.text("</CellData>\n");
    }
    file.text("<Points>\n");
    file.array("type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", arrays.points());
    file.text("</Points>\n<Cells>\n");
    file.array("type=\"Int64\" Name=\"connectivity\"", arrays.connectivity());
    file.array("type=\"Int64\" Name=\"offsets\"", arrays.offsets());
    file.array("type=\"UInt8\" Name=\"types\"", arrays.types::<u8>());
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
    /// The length of the appended data.
    offset: u64,
}

impl<'a> File<'a> {
    fn text(&mut self, text: &str) {
        self.xml += text;
    }

    fn field(&mut self, field: Field<'a>) {
        let kind = if field.is_float { "Float64" } else { "Int32" };
        self.array(&format!("type=\"{kind}\" Name=\"{}\"", field.name), field.sections);
    }

    /// An array; `head` is the start of its element, up to how it is stored.
    fn array(&mut self, head: &str, sections: Vec<Section<'a>>) {
        if self.is_binary {
            let offset = self.offset;
            self.text(&format!("<DataArray {head} format=\"appended\" offset=\"{offset}\"/>\n"));
            let len: u64 = sections.iter().map(Section::byte_len).sum();
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
