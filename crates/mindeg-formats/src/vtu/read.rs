//! Reading VTU.

use std::collections::BTreeMap;
use std::io::Read;

use mindeg_mesh::TriMesh;

use super::array::{Storage, values};
use super::xml::{Tag, next_tag};
use crate::ReadError;
use crate::dropped;
use crate::grid::{CellData, Cells, Grid};

/// Reads a mesh from a VTU.
///
/// Triangles, quadrilaterals, polygons, pixels and strips become faces; line cells become lines:
/// one for each value of the cell data `side` if the file has it, under the name that the field data
/// `side_names` has for it. So become the groups, by `group` and `group_names`. Of curved cells the
/// corners are taken; points are counted, volumes are noted; other data is passed over.
///
/// O(n) time but for polygons that are cut, and memory for the file and the mesh, whatever the file
/// says of its size.
///
/// # Errors
///
/// Errors of the input; other types of VTK files; data compressed by anything but zlib; elements
/// that break the format, by the byte where they begin; a file without faces.
///
/// # Example
///
/// ```
/// use mindeg_formats::vtu;
///
/// let array = |kind, values| format!("<DataArray type=\"{kind}\" {values}</DataArray>");
/// let file = [
///     "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>".to_owned(),
///     "<Piece NumberOfPoints=\"3\" NumberOfCells=\"1\"><Points>".to_owned(),
///     array("Float32", "NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0"),
///     "</Points><Cells>".to_owned(),
///     array("Int32", "Name=\"connectivity\">0 1 2") + &array("Int32", "Name=\"offsets\">3"),
///     array("UInt8", "Name=\"types\">5") + "</Cells></Piece></UnstructuredGrid></VTKFile>",
/// ];
/// assert_eq!(vtu::read(file.concat().as_bytes())?.triangles(), [[0, 1, 2]]);
/// # Ok::<(), mindeg_formats::ReadError>(())
/// ```
pub fn read(mut input: impl Read) -> Result<TriMesh, ReadError> {
    let mut file = Vec::new();
    input.read_to_end(&mut file)?;
    contents(&file, None)
}

/// Reads a mesh and the first point data of one number at each vertex.
pub(crate) fn read_values(file: &[u8]) -> Result<(TriMesh, Vec<f64>), ReadError> {
    let mut values = Vec::new();
    let mesh = contents(file, Some(&mut values))?;
    Ok((mesh, values))
}

/// Reads a mesh, and values at its vertices where they are wanted.
fn contents(file: &[u8], mut at_points: Option<&mut Vec<f64>>) -> Result<TriMesh, ReadError> {
    let (mut storage, mut offset) = head(file)?;
    storage.appended = appended(file)?;
    // Raw bytes follow, not XML.
    let end = storage.appended.map_or(file.len(), |(start, _)| start);
    let mut grid = Grid::default();
    let mut data = CellData::default();
    let mut piece: Option<Piece<'_>> = None;
    // The element that arrays are in.
    let mut inside: &[u8] = b"";
    let mut has = [false; 2];
    while let Some(tag) = next_tag(&file[..end], offset)? {
        offset = tag.end;
        match (tag.name, tag.is_end) {
            (b"Piece", false) => piece = Some(Piece::new(&tag)?),
            (b"Piece", true) => {
                if let Some(piece) = piece.take() {
                    if let Some(at_points) = &mut at_points {
                        at_points.extend(piece.values_at_points(&storage)?);
                    }
                    piece.add_to(&mut grid, &storage, &mut data)?;
                }
            }
            (b"DataArray", false) => match &mut piece {
                Some(piece) => piece.take_array(inside, tag),
                None if inside == b"FieldData" => take_names(&mut data, &storage, &tag)?,
                None => {}
            },
            (b"AppendedData", _) => break,
            (name @ (b"FieldData" | b"PointData" | b"CellData" | b"Points" | b"Cells"), false) => {
                inside = name;
                for (has, named) in has.iter_mut().zip(["TCoords", "Normals"]) {
                    *has |= tag.attribute(named).is_some();
                }
            }
            _ => {}
        }
    }
    let kinds = [(dropped::TEXTURE, has[0]), (dropped::NORMALS, has[1])];
    Ok(grid.into_mesh()?.with_dropped(dropped::found(kinds)))
}

/// How numbers are stored, and where the first element ends.
fn head(file: &[u8]) -> Result<(Storage<'_>, usize), ReadError> {
    let mut offset = 0;
    while let Some(tag) = next_tag(file, offset)? {
        offset = tag.end;
        if tag.name != b"VTKFile" || tag.is_end {
            continue;
        }
        let problem = |problem: String| Err(ReadError::byte(tag.start, problem));
        let attribute = |name, usual| tag.attribute(name).unwrap_or(usual);
        match attribute("type", "") {
            "UnstructuredGrid" => {}
            other => {
                return problem(format!(
                    "the type of VTK file is {other:?}; only \"UnstructuredGrid\" (.vtu) is read"
                ));
            }
        }
        let is_compressed = match attribute("compressor", "") {
            "" => false,
            "vtkZLibDataCompressor" => true,
            other => {
                return problem(format!(
                    "data compressed by {other} is not read; save it uncompressed, or with zlib"
                ));
            }
        };
        let length_len = match attribute("header_type", "UInt32") {
            "UInt32" => 4,
            "UInt64" => 8,
            other => return problem(format!("header_type is {other:?}, not UInt32 or UInt64")),
        };
        let is_big = attribute("byte_order", "LittleEndian") == "BigEndian";
        let storage = Storage { file, is_big, length_len, is_compressed, appended: None };
        return Ok((storage, offset));
    }
    Err(ReadError::byte(0, "no element VTKFile; is it a VTU?"))
}

/// Where appended numbers begin, and whether they are base64.
fn appended(file: &[u8]) -> Result<Option<(usize, bool)>, ReadError> {
    let Some(start) = memchr::memmem::find(file, b"<AppendedData") else { return Ok(None) };
    let Some(tag) = next_tag(file, start)? else { return Ok(None) };
    let mark = memchr::memchr(b'_', &file[tag.end..]);
    let mark = mark.ok_or_else(|| ReadError::byte(tag.start, "AppendedData has no _ before it"))?;
    let is_base64 = match tag.attribute("encoding") {
        Some("raw") => false,
        Some("base64") | None => true,
        Some(other) => {
            let problem = format!("the encoding is {other:?}, not raw or base64");
            return Err(ReadError::byte(tag.start, problem));
        }
    };
    Ok(Some((tag.end + mark + 1, is_base64)))
}

/// Takes the names of sides or groups.
fn take_names(data: &mut CellData, storage: &Storage<'_>, tag: &Tag<'_>) -> Result<(), ReadError> {
    let list = match tag.attribute("Name") {
        Some("side_names") => &mut data.side_names,
        Some("group_names") => &mut data.group_names,
        _ => return Ok(()),
    };
    let bytes: Vec<u8> =
        values::<i64>(storage, tag)?.into_iter().map(|value| value as u8).collect();
    let bytes = bytes.strip_suffix(b"\0").unwrap_or(&bytes);
    let names = bytes.split(|&byte| byte == 0);
    *list = names.map(|name| String::from_utf8_lossy(name).into_owned()).collect();
    Ok(())
}

/// The arrays of one piece, by the element that they are in and their name.
struct Piece<'a> {
    start: usize,
    points: u64,
    cells: u64,
    arrays: BTreeMap<(&'a [u8], &'a str), Tag<'a>>,
}

/// The name of the one array in Points, which may have any name there.
const POINTS: &str = "in Points";

impl<'a> Piece<'a> {
    fn new(tag: &Tag<'a>) -> Result<Self, ReadError> {
        let count = |name: &str| {
            let value = tag.attribute(name).unwrap_or_default();
            value.trim().parse().map_err(|_| {
                ReadError::byte(tag.start, format!("{name} is {value:?}, not a whole number"))
            })
        };
        let (points, cells) = (count("NumberOfPoints")?, count("NumberOfCells")?);
        Ok(Self { start: tag.start, points, cells, arrays: BTreeMap::new() })
    }

    fn take_array(&mut self, inside: &'a [u8], tag: Tag<'a>) {
        let name = if inside == b"Points" { Some(POINTS) } else { tag.attribute("Name") };
        self.arrays.entry((inside, name.unwrap_or_default())).or_insert(tag);
    }

    /// The first point data of one number at each point.
    fn values_at_points(&self, storage: &Storage<'_>) -> Result<Vec<f64>, ReadError> {
        let data = self.arrays.iter().filter(|((inside, _), _)| *inside == b"PointData");
        for (_, tag) in data {
            let found: Vec<f64> = values(storage, tag)?;
            if found.len() as u64 == self.points {
                return Ok(found);
            }
        }
        let problem = "the piece has no point data of one number at each point";
        Err(ReadError::byte(self.start, problem))
    }

    fn add_to(
        &self,
        grid: &mut Grid,
        storage: &Storage<'_>,
        data: &mut CellData,
    ) -> Result<(), ReadError> {
        let problem =
            |problem: String| ReadError::byte(self.start, format!("the piece: {problem}"));
        if self.points == 0 && self.cells == 0 {
            return Ok(());
        }
        let needed = |inside: &'static str, name: &'static str| {
            let tag = self.arrays.get(&(inside.as_bytes(), name));
            tag.ok_or_else(|| problem(format!("it has no array {name}")))
        };
        let check = |found: usize, expected: u64, what: &str| {
            if found as u64 == expected {
                return Ok(());
            }
            Err(problem(format!("{what} has {found} numbers; expected {expected}")))
        };
        let positions: Vec<f64> = values(storage, needed("Points", POINTS)?)?;
        check(positions.len(), self.points.saturating_mul(3), "Points")?;
        let offsets: Vec<i64> = values(storage, needed("Cells", "offsets")?)?;
        check(offsets.len(), self.cells, "offsets")?;
        let types: Vec<i64> = values(storage, needed("Cells", "types")?)?;
        check(types.len(), self.cells, "types")?;
        let connectivity: Vec<i64> = values(storage, needed("Cells", "connectivity")?)?;
        // Other programs may use these names too: only whole numbers, one for each, are ours.
        let of_cells = |name: &'static str| {
            let tag = self.arrays.get(&(&b"CellData"[..], name));
            let values: Option<Vec<i64>> = tag.and_then(|tag| values(storage, tag).ok());
            values.filter(|values| values.len() as u64 == self.cells).unwrap_or_default()
        };
        (data.sides, data.groups) = (of_cells("side"), of_cells("group"));
        let first = grid.point_count();
        grid.add_points(&positions)?;
        let cells = Cells { connectivity: &connectivity, ends: &offsets, types: &types, data };
        grid.add_cells(first, &cells, problem)
    }
}
