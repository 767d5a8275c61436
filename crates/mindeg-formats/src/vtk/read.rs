//! Reading legacy VTK.

use std::io::Read;

use mindeg_mesh::TriMesh;

use crate::ReadError;
use crate::dropped;
use crate::grid::{CellData, Cells, Grid};
use crate::lists::push;
use crate::numbers::{Numbers, Scalar, Value};
use crate::scanner::Scanner;

/// Reads a mesh from a legacy VTK file: an unstructured grid, or polygonal data.
///
/// Triangles, quadrilaterals, polygons, pixels and strips become faces; lines and poly-lines become
/// lines, one for each value of the cell data `side` if the file has it. Of curved cells the
/// corners are taken; points are counted, volumes are noted; other data is passed over.
///
/// O(n) time but for polygons that are cut, and memory for the file and the mesh, whatever the file
/// says of its size.
///
/// # Errors
///
/// Errors of the input; other datasets; a file that breaks the format, by line or byte; a file
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

/// The type of numbers with the name that follows; none for bits.
fn kind(scanner: &mut Scanner<'_>) -> Result<Option<Scalar>, ReadError> {
    let word = scanner.word().unwrap_or_default().to_ascii_lowercase();
    Ok(Some(match &word[..] {
        b"bit" => return Ok(None),
        b"char" | b"signed_char" => Scalar::Signed(1),
        b"unsigned_char" => Scalar::Unsigned(1),
        b"short" => Scalar::Signed(2),
        b"unsigned_short" => Scalar::Unsigned(2),
        b"int" => Scalar::Signed(4),
        b"unsigned_int" => Scalar::Unsigned(4),
        b"long" | b"long_long" | b"vtkidtype" => Scalar::Signed(8),
        b"unsigned_long" | b"unsigned_long_long" => Scalar::Unsigned(8),
        b"float" => Scalar::Float(4),
        b"double" => Scalar::Float(8),
        other => {
            let other = String::from_utf8_lossy(&other[..other.len().min(40)]);
            let known = other.strip_prefix("vtktype");
            let known = known.and_then(|name| Scalar::of_name(name, ["int", "uint", "float"], 8));
            let problem = || scanner.problem(format!("{other:?} is not a type of numbers"));
            known.ok_or_else(problem)?
        }
    }))
}

/// The product of two counts of the file.
fn product(scanner: &Scanner<'_>, count: u64, each: u64) -> Result<u64, ReadError> {
    count.checked_mul(each).ok_or_else(|| scanner.problem("no file has so many numbers"))
}

/// The contents of the file read so far.
#[derive(Default)]
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
    /// Whether there are texture coordinates, normals and colors.
    has: [bool; 3],
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
                let kind = kind(scanner)?;
                let count = product(scanner, count, 3)?;
                self.positions = self.numbers(scanner, count, kind, "a coordinate")?;
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
                let kind = Some(Scalar::Signed(4));
                self.types = self.numbers(scanner, count, kind, "the type of a cell")?;
            }
            b"POINT_DATA" | b"CELL_DATA" => {
                self.on_cells = Some(word == b"CELL_DATA");
                self.count = scanner.size("the number of data")?;
            }
            b"FIELD" => self.take_field(scanner)?,
            b"METADATA" => pass_over_metadata(scanner),
            b"LOOKUP_TABLE" => {
                scanner.word();
                let count = scanner.size("the size of a table")?;
                let count = product(scanner, count, 4)?;
                self.take_data(scanner, b"", count, Some(Scalar::Unsigned(1)))?;
            }
            b"COLOR_SCALARS" => {
                self.has[2] = true;
                scanner.word();
                let components = scanner.size("the number of components")?;
                let count = product(scanner, self.count, components)?;
                self.take_data(scanner, b"", count, Some(Scalar::Unsigned(1)))?;
            }
            _ => return self.take_attribute(word, start, scanner),
        }
        Ok(())
    }

    /// An array of data; the side or group of each cell is kept.
    fn take_attribute(
        &mut self,
        word: &[u8],
        start: usize,
        scanner: &mut Scanner<'_>,
    ) -> Result<(), ReadError> {
        let mut components = match word {
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
        self.has[1] |= word == b"NORMALS";
        if word == b"TEXTURE_COORDINATES" {
            self.has[0] = true;
            components = scanner.size("the number of dimensions")?;
        }
        let kind = kind(scanner)?;
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
        let count = product(scanner, self.count, components)?;
        self.take_data(scanner, name, count, kind)
    }

    /// Arrays, each with a name, a number of components and of values, and a type.
    fn take_field(&mut self, scanner: &mut Scanner<'_>) -> Result<(), ReadError> {
        scanner.word();
        for _ in 0..scanner.size("the number of arrays")? {
            // The array before may have ended in bytes.
            scanner.encoding = Numbers::Text;
            let name = loop {
                // An array may have metadata, up to an empty line.
                match scanner.word() {
                    Some(b"METADATA") => pass_over_metadata(scanner),
                    name => break name.unwrap_or_default(),
                }
            };
            let components = scanner.size("the number of components")?;
            let tuples = scanner.size("the number of values")?;
            let kind = kind(scanner)?;
            let count = product(scanner, components, tuples)?;
            self.take_data(scanner, name, count, kind)?;
        }
        Ok(())
    }

    fn take_data(
        &mut self,
        scanner: &mut Scanner<'_>,
        name: &[u8],
        count: u64,
        kind: Option<Scalar>,
    ) -> Result<(), ReadError> {
        let is_of_cells = self.on_cells == Some(true) && count == self.count;
        let is_whole = kind.is_some_and(Scalar::is_whole);
        if is_of_cells && is_whole && matches!(name, b"side" | b"group") {
            let values = self.numbers(scanner, count, kind, "a side or group")?;
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
            None => count.div_ceil(8),
            Some(kind) => count.saturating_mul(kind.len() as u64),
        };
        self.start_of_bytes(scanner);
        scanner.take_items(bytes, 1, "bytes of data").map(drop)
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
    fn numbers<T: Value>(
        &self,
        scanner: &mut Scanner<'_>,
        count: u64,
        kind: Option<Scalar>,
        what: &str,
    ) -> Result<Vec<T>, ReadError> {
        self.start_of_bytes(scanner);
        let mut values = Vec::new();
        if self.encoding == Numbers::Text {
            for _ in 0..count {
                push(&mut values, scanner.parsed(what, T::KIND)?)?;
            }
            return Ok(values);
        }
        let wrong = |scanner: &Scanner<'_>| scanner.problem(format!("{what} must be {}", T::KIND));
        let kind = kind.ok_or_else(|| wrong(scanner))?;
        let bytes = scanner.take_items(count, kind.len(), "numbers")?;
        values.try_reserve_exact(bytes.len() / kind.len())?;
        for item in bytes.chunks_exact(kind.len()) {
            values.push(T::of(kind, item, true).ok_or_else(|| wrong(scanner))?);
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
            let kind_of_offsets = kind(scanner)?;
            let offsets: Vec<i64> = self.numbers(scanner, count, kind_of_offsets, "an offset")?;
            scanner.encoding = Numbers::Text;
            if scanner.word() != Some(b"CONNECTIVITY") {
                return Err(scanner.problem("CONNECTIVITY should follow here"));
            }
            let kind = kind(scanner)?;
            let connectivity: Vec<i64> = self.numbers(scanner, size, kind, "a corner")?;
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
        let problem = |problem: String| scanner.problem_at(self.start, problem);
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
        grid.add_cells(0, &cells, problem)?;
        let [has_texture, has_normals, has_colors] = self.has;
        Ok(grid.into_mesh()?.with_dropped(dropped::found([
            (dropped::TEXTURE, has_texture),
            (dropped::NORMALS, has_normals),
            (dropped::COLORS, has_colors),
        ])))
    }
}

/// Metadata end at an empty line.
fn pass_over_metadata(scanner: &mut Scanner<'_>) {
    scanner.line();
    while scanner.line().is_some_and(|line| !line.trim_ascii().is_empty()) {}
}
