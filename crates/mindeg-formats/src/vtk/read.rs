//! Reading legacy VTK.

use std::io::Read;

use mindeg_mesh::TriMesh;

use super::kind::Kind;
use crate::ReadError;
use crate::grid::{CellData, Cells, Grid};
use crate::lists::push;
use crate::scanner::{Numbers, Scanner};

/// Reads a mesh from a legacy VTK file: an unstructured grid, or polygonal data.
///
/// Triangles, quadrilaterals, polygons, pixels and strips become faces; lines and poly-lines become
/// lines, one for each value of the cell data `side` where there is such. Of curved cells the
/// corners are taken; points are counted, volumes are noted; other data is passed over.
///
/// O(n) time but for polygons that are cut, and memory for the file and the mesh, whatever the file
/// says of its size.
///
/// # Errors
///
/// Errors of the input; other datasets; what is not as the format has it, by line or byte; a file
/// without faces.
///
/// # Example
///
/// ```
/// use mindeg_formats::vtk;
///
/// let file = "# vtk DataFile Version 2.0\nby hand\nASCII\nDATASET POLYDATA\n\
///             POINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n";
/// assert_eq!(vtk::read(file.as_bytes())?.triangles(), [[0, 1, 2]]);
///
/// let error = vtk::read(file.replace("0 1 2", "0 1 x").as_bytes()).unwrap_err();
/// assert_eq!(error.to_string(), "line 8: a corner is \"x\", which is not a whole number");
/// # Ok::<(), mindeg_formats::ReadError>(())
/// ```
pub fn read(mut input: impl Read) -> Result<TriMesh, ReadError> {
    let mut file = Vec::new();
    input.read_to_end(&mut file)?;
    let mut scanner = Scanner::new(&file);
    let encoding = head(&mut scanner)?;
    let mut contents = Contents { encoding, ..Contents::default() };
    loop {
        scanner.encoding = Numbers::Text;
        let start = scanner.offset();
        let Some(word) = scanner.word() else { break };
        contents.take(&word.to_ascii_uppercase(), start, &mut scanner)?;
    }
    contents.into_mesh(&scanner)
}

/// Reads up to the word DATASET, and says how numbers are stored.
fn head(scanner: &mut Scanner<'_>) -> Result<Numbers, ReadError> {
    let first = scanner.line().unwrap_or_default();
    if !first.starts_with(b"# vtk DataFile Version") {
        return Err(scanner.problem_at(0, "a legacy VTK file begins with # vtk DataFile Version"));
    }
    scanner.line();
    match scanner.word().map(<[u8]>::to_ascii_uppercase).as_deref() {
        Some(b"ASCII") => Ok(Numbers::Text),
        Some(b"BINARY") => Ok(Numbers::BigEndian),
        _ => Err(scanner.problem("the third line must be ASCII or BINARY")),
    }
}

/// The contents of the file read so far.
struct Contents {
    encoding: Numbers,
    positions: Vec<f64>,
    connectivity: Vec<i64>,
    ends: Vec<i64>,
    types: Vec<i64>,
    data: CellData,
    /// Whether data belongs to cells now, to points, or to neither.
    on_cells: Option<bool>,
    /// The number of values of the data.
    count: u64,
    /// Where the cells begin in the file.
    start: usize,
}

impl Default for Contents {
    fn default() -> Self {
        Self {
            encoding: Numbers::Text,
            positions: Vec::new(),
            connectivity: Vec::new(),
            ends: Vec::new(),
            types: Vec::new(),
            data: CellData::default(),
            on_cells: None,
            count: 0,
            start: 0,
        }
    }
}

impl Contents {
    /// Reads what a word begins.
    fn take(
        &mut self,
        word: &[u8],
        start: usize,
        scanner: &mut Scanner<'_>,
    ) -> Result<(), ReadError> {
        match word {
            b"DATASET" => match scanner.word().map(<[u8]>::to_ascii_uppercase).as_deref() {
                Some(b"UNSTRUCTURED_GRID" | b"POLYDATA") => {}
                other => {
                    let other = String::from_utf8_lossy(other.unwrap_or_default()).into_owned();
                    return Err(scanner.problem(format!(
                        "a dataset of type {other:?} is not read, only UNSTRUCTURED_GRID and \
                         POLYDATA"
                    )));
                }
            },
            b"POINTS" => {
                let count = scanner.size("the number of points")?;
                let kind = Kind::read(scanner)?;
                let count = count.checked_mul(3);
                let count = count.ok_or_else(|| scanner.problem("no file has so many points"))?;
                self.positions = self.values(scanner, count, kind, "a coordinate")?;
            }
            b"CELLS" => {
                self.start = start;
                self.take_cells(scanner, None)?;
            }
            b"VERTICES" => self.take_cells(scanner, Some(2))?,
            b"LINES" => self.take_cells(scanner, Some(4))?,
            b"POLYGONS" => self.take_cells(scanner, Some(7))?,
            b"TRIANGLE_STRIPS" => self.take_cells(scanner, Some(6))?,
            b"CELL_TYPES" => {
                let count = scanner.size("the number of cell types")?;
                self.types = self.whole(scanner, count, Kind::Int(4), "the type of a cell")?;
            }
            b"POINT_DATA" | b"CELL_DATA" => {
                self.on_cells = Some(word == b"CELL_DATA");
                self.count = scanner.size("the number of data")?;
            }
            b"FIELD" => self.take_field(scanner)?,
            b"METADATA" => {
                // It ends at an empty line.
                scanner.line();
                while scanner.line().is_some_and(|line| !line.trim_ascii().is_empty()) {}
            }
            b"LOOKUP_TABLE" => {
                scanner.word();
                let count = scanner.size("the size of a table")?;
                self.colors(scanner, count, 4)?;
            }
            b"COLOR_SCALARS" => {
                scanner.word();
                let components = scanner.size("the number of components")?;
                self.colors(scanner, self.count, components)?;
            }
            _ => return self.take_attribute(word, start, scanner),
        }
        Ok(())
    }

    /// One array of data; the side or group of each cell is kept.
    fn take_attribute(
        &mut self,
        word: &[u8],
        start: usize,
        scanner: &mut Scanner<'_>,
    ) -> Result<(), ReadError> {
        let components = match word {
            b"SCALARS" | b"GLOBAL_IDS" | b"PEDIGREE_IDS" => 1,
            b"VECTORS" | b"NORMALS" => 3,
            b"TENSORS" => 9,
            b"TEXTURE_COORDINATES" => 0,
            _ => {
                let shown = String::from_utf8_lossy(&word[..word.len().min(40)]).into_owned();
                let problem = format!("{shown:?} is not a keyword of legacy VTK that is read");
                return Err(scanner.problem_at(start, problem));
            }
        };
        let name = scanner.word().unwrap_or_default();
        let components = match word {
            b"TEXTURE_COORDINATES" => scanner.size("the number of dimensions")?,
            _ => components,
        };
        let kind = Kind::read(scanner)?;
        let mut components = components;
        if word == b"SCALARS" {
            // The number of components may follow in the same line, and a table in the next.
            let rest = scanner.line().unwrap_or_default();
            components = crate::words::number(rest.trim_ascii()).unwrap_or(1);
            let before = scanner.offset();
            if scanner.word().is_some_and(|word| word.eq_ignore_ascii_case(b"LOOKUP_TABLE")) {
                scanner.word();
            } else {
                scanner.go_to(before);
            }
        }
        let count = self.count.checked_mul(components);
        let count = count.ok_or_else(|| scanner.problem("no file has so much data"))?;
        self.take_data(scanner, name, count, kind)
    }

    /// Arrays, each with a name, a number of components and of values, and a type.
    fn take_field(&mut self, scanner: &mut Scanner<'_>) -> Result<(), ReadError> {
        scanner.word();
        for _ in 0..scanner.size("the number of arrays")? {
            // The array before may have ended in bytes.
            scanner.encoding = Numbers::Text;
            let name = loop {
                // Of each array there may be more, up to an empty line.
                match scanner.word() {
                    Some(b"METADATA") => {
                        scanner.line();
                        while scanner.line().is_some_and(|line| !line.trim_ascii().is_empty()) {}
                    }
                    name => break name.unwrap_or_default(),
                }
            };
            let components = scanner.size("the number of components")?;
            let tuples = scanner.size("the number of values")?;
            let kind = Kind::read(scanner)?;
            let count = components.checked_mul(tuples);
            let count = count.ok_or_else(|| scanner.problem("no file has so much data"))?;
            self.take_data(scanner, name, count, kind)?;
        }
        Ok(())
    }

    fn take_data(
        &mut self,
        scanner: &mut Scanner<'_>,
        name: &[u8],
        count: u64,
        kind: Kind,
    ) -> Result<(), ReadError> {
        let is_of_cells = self.on_cells == Some(true) && count == self.count;
        if is_of_cells && kind.is_whole() && matches!(name, b"side" | b"group") {
            let values = self.whole(scanner, count, kind, "a side or group")?;
            *(if name == b"side" { &mut self.data.sides } else { &mut self.data.groups }) = values;
            return Ok(());
        }
        if self.encoding == Numbers::Text {
            for _ in 0..count {
                let word = scanner.word();
                word.ok_or_else(|| scanner.problem("the file ends within data"))?;
            }
            return Ok(());
        }
        let bytes = match kind {
            Kind::Bit => count.div_ceil(8),
            Kind::Int(len) | Kind::Unsigned(len) | Kind::Float(len) => {
                count.saturating_mul(len as u64)
            }
        };
        self.start_of_bytes(scanner);
        scanner.take_items(bytes, 1, "bytes of data").map(drop)
    }

    /// Colors: bytes, or words of a text.
    fn colors(
        &mut self,
        scanner: &mut Scanner<'_>,
        count: u64,
        components: u64,
    ) -> Result<(), ReadError> {
        let count = count.saturating_mul(components);
        self.take_data(scanner, b"", count, Kind::Unsigned(1))
    }

    /// Goes to where bytes begin: after the line's end.
    fn start_of_bytes(&self, scanner: &mut Scanner<'_>) {
        scanner.encoding = self.encoding;
        if self.encoding != Numbers::Text {
            let rest = scanner.rest();
            let blanks = rest.iter().take_while(|&&byte| matches!(byte, b' ' | b'\t' | b'\r'));
            let blanks = blanks.count();
            if rest.get(blanks) == Some(&b'\n') {
                scanner.go_to(scanner.offset() + blanks + 1);
            }
        }
    }

    /// So many numbers, each `what`.
    fn values(
        &self,
        scanner: &mut Scanner<'_>,
        count: u64,
        kind: Kind,
        what: &str,
    ) -> Result<Vec<f64>, ReadError> {
        self.start_of_bytes(scanner);
        let mut values = Vec::new();
        if self.encoding == Numbers::Text {
            for _ in 0..count {
                push(&mut values, scanner.double(what)?)?;
            }
        } else {
            let bytes = scanner.take_items(count, kind.len(), "numbers")?;
            values.try_reserve_exact(bytes.len() / kind.len())?;
            values.extend(bytes.chunks_exact(kind.len()).map(|item| kind.float(item)));
        }
        Ok(values)
    }

    /// So many whole numbers, each `what`.
    fn whole(
        &self,
        scanner: &mut Scanner<'_>,
        count: u64,
        kind: Kind,
        what: &str,
    ) -> Result<Vec<i64>, ReadError> {
        self.start_of_bytes(scanner);
        let mut values = Vec::new();
        if self.encoding == Numbers::Text {
            for _ in 0..count {
                push(&mut values, scanner.int(what)?)?;
            }
        } else {
            let bytes = scanner.take_items(count, kind.len(), "numbers")?;
            values.try_reserve_exact(bytes.len() / kind.len())?;
            values.extend(bytes.chunks_exact(kind.len()).map(|item| kind.whole(item)));
        }
        Ok(values)
    }

    /// Cells of one type, or of those that follow. Before version 5, each has its number of corners
    /// before them; from then on, two arrays follow.
    fn take_cells(
        &mut self,
        scanner: &mut Scanner<'_>,
        cell_type: Option<i64>,
    ) -> Result<(), ReadError> {
        let count = scanner.size("the number of cells")?;
        let size = scanner.size("the size of the cells")?;
        let before = scanner.offset();
        let first = self.connectivity.len() as i64;
        let types_before = self.ends.len();
        if scanner.word() == Some(b"OFFSETS") {
            let kind = Kind::read(scanner)?;
            let offsets = self.whole(scanner, count, kind, "an offset")?;
            scanner.encoding = Numbers::Text;
            if scanner.word() != Some(b"CONNECTIVITY") {
                return Err(scanner.problem("CONNECTIVITY should follow here"));
            }
            let kind = Kind::read(scanner)?;
            let connectivity = self.whole(scanner, size, kind, "a corner")?;
            self.ends.try_reserve(offsets.len())?;
            let ends = offsets.iter().skip(1).map(|offset| first.saturating_add(*offset));
            self.ends.extend(ends);
            self.connectivity.try_reserve(connectivity.len())?;
            self.connectivity.extend(connectivity);
        } else {
            scanner.go_to(before);
            self.start_of_bytes(scanner);
            for _ in 0..count {
                let corners = scanner.int("the number of corners of a cell")?;
                for _ in 0..corners {
                    push(&mut self.connectivity, scanner.int("a corner")?)?;
                }
                push(&mut self.ends, self.connectivity.len() as i64)?;
            }
        }
        if let Some(cell_type) = cell_type {
            let new = self.ends.len() - types_before;
            self.types.try_reserve(new)?;
            self.types.extend(std::iter::repeat_n(cell_type, new));
        }
        Ok(())
    }

    fn into_mesh(self, scanner: &Scanner<'_>) -> Result<TriMesh, ReadError> {
        let problem = |problem| scanner.problem_at(self.start, problem);
        if self.types.len() != self.ends.len() {
            let (cells, types) = (self.ends.len(), self.types.len());
            return Err(problem(format!("the file has {cells} cells and {types} cell types")));
        }
        let mut grid = Grid::default();
        grid.add_points(&self.positions)?;
        let Self { connectivity, ends, types, mut data, .. } = self;
        // Data that is not there for each cell is not known for any.
        for values in [&mut data.sides, &mut data.groups] {
            if values.len() != ends.len() {
                values.clear();
            }
        }
        let cells = Cells { connectivity: &connectivity, ends: &ends, types: &types, data: &data };
        grid.add_cells(0, &cells)
            .map_err(|(cell, error)| error.at(cell, |text| scanner.problem_at(self.start, text)))?;
        grid.into_mesh()
    }
}
