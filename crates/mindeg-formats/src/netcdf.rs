//! Grids in classic NetCDF: a number at each longitude and latitude, or x and y.
//!
//! The three kinds of the classic format are read: with offsets of 32 and of 64 bits, and with all counts of 64 bits (CDF-1, 2 and 5).
//! The grid is the variable with two dimensions that both have coordinates, evenly spaced; dimensions of length 1 before them do
//! not count. `scale_factor`, `add_offset`, `_FillValue` and `missing_value` hold. Nothing is allocated beyond what the file holds.
//!
//! Limits: NetCDF-4 is HDF5, which is not read.

use std::ops::Range;

use glam::DVec2;

use crate::ReadError;
use crate::raster::Raster;

/// The names that the depth or the height has in the usual grids, where several variables are on one.
const USUAL: [&str; 7] = ["elevation", "depth", "z", "bathymetry", "topo", "altitude", "Band1"];
/// Coordinates may be so far from even, as a share of their distance: those of 32 bits are rounded.
const UNEVEN: f64 = 0.05;

/// What each list of a header begins with.
const DIMENSIONS: u32 = 10;
const VARIABLES: u32 = 11;
const ATTRIBUTES: u32 = 12;

/// The type of numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    I8,
    Text,
    I16,
    I32,
    F32,
    F64,
    U8,
    U16,
    U32,
    I64,
    U64,
}

impl Kind {
    fn of(number: u32) -> Option<Self> {
        const ALL: [Kind; 11] = [
            Kind::I8,
            Kind::Text,
            Kind::I16,
            Kind::I32,
            Kind::F32,
            Kind::F64,
            Kind::U8,
            Kind::U16,
            Kind::U32,
            Kind::I64,
            Kind::U64,
        ];
        ALL.get(number.checked_sub(1)? as usize).copied()
    }

    fn bytes(self) -> usize {
        match self {
            Self::I8 | Self::U8 | Self::Text => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 | Self::I64 | Self::U64 => 8,
        }
    }

    /// The number in its bytes, of which there are as many as it has.
    fn number(self, bytes: &[u8]) -> f64 {
        fn array<const N: usize>(bytes: &[u8]) -> [u8; N] {
            std::array::from_fn(|index| bytes.get(index).copied().unwrap_or_default())
        }
        match self {
            Self::I8 => i8::from_be_bytes(array(bytes)).into(),
            Self::U8 | Self::Text => u8::from_be_bytes(array(bytes)).into(),
            Self::I16 => i16::from_be_bytes(array(bytes)).into(),
            Self::U16 => u16::from_be_bytes(array(bytes)).into(),
            Self::I32 => i32::from_be_bytes(array(bytes)).into(),
            Self::U32 => u32::from_be_bytes(array(bytes)).into(),
            Self::F32 => f32::from_be_bytes(array(bytes)).into(),
            Self::F64 => f64::from_be_bytes(array(bytes)),
            Self::I64 => i64::from_be_bytes(array(bytes)) as f64,
            Self::U64 => u64::from_be_bytes(array(bytes)) as f64,
        }
    }
}

/// An attribute: its numbers, or its text.
struct Attribute<'a> {
    name: String,
    kind: Kind,
    bytes: &'a [u8],
}

struct Variable<'a> {
    name: String,
    /// Indices of dimensions.
    dimensions: Vec<usize>,
    attributes: Vec<Attribute<'a>>,
    kind: Kind,
    begin: usize,
}

impl Variable<'_> {
    fn number(&self, attribute: &str) -> Option<f64> {
        let found = self.attributes.iter().find(|own| own.name == attribute)?;
        let is_one = found.kind != Kind::Text && found.bytes.len() == found.kind.bytes();
        is_one.then(|| found.kind.number(found.bytes))
    }

    fn text(&self, attribute: &str) -> String {
        let found = self.attributes.iter().find(|own| own.name == attribute);
        found.map_or(String::new(), |own| String::from_utf8_lossy(own.bytes).to_ascii_lowercase())
    }

    /// Whether it is a coordinate of the axis, by its attributes or its name: x and east, or y and north.
    fn is_along(&self, axis: &str, degrees: &str, names: [&str; 2]) -> bool {
        let name = self.name.to_ascii_lowercase();
        self.text("axis") == axis
            || self.text("units").contains(degrees)
            || names.into_iter().any(|start| name.starts_with(start))
    }
}

/// The header of a file, from front to back.
struct Header<'a> {
    file: &'a [u8],
    at: usize,
    version: u8,
}

impl<'a> Header<'a> {
    fn problem(&self, problem: &str) -> ReadError {
        ReadError::byte(self.at, problem)
    }

    fn take(&mut self, count: usize) -> Result<&'a [u8], ReadError> {
        let bytes = self.file.get(self.at..).and_then(|rest| rest.get(..count));
        let bytes = bytes.ok_or_else(|| self.problem("the file ends within the header"))?;
        self.at += count;
        Ok(bytes)
    }

    fn word(&mut self) -> Result<u32, ReadError> {
        Ok(Kind::U32.number(self.take(4)?) as u32)
    }

    fn long(&mut self) -> Result<usize, ReadError> {
        let bytes = self.take(8)?;
        let value = bytes.iter().fold(0_u64, |value, byte| value << 8 | u64::from(*byte));
        usize::try_from(value).map_err(|_| self.problem("this number is too large"))
    }

    /// A count, or a length.
    fn count(&mut self) -> Result<usize, ReadError> {
        if self.version == 5 { self.long() } else { Ok(self.word()? as usize) }
    }

    /// Bytes, and those that fill them up to four.
    fn padded(&mut self, count: usize) -> Result<&'a [u8], ReadError> {
        let bytes = self.take(count)?;
        self.take((4 - count % 4) % 4)?;
        Ok(bytes)
    }

    fn name(&mut self) -> Result<String, ReadError> {
        let count = self.count()?;
        Ok(String::from_utf8_lossy(self.padded(count)?).into_owned())
    }

    /// The number of items of a list.
    fn list(&mut self, tag: u32) -> Result<Range<usize>, ReadError> {
        let found = self.word()?;
        let count = self.count()?;
        match (found, count) {
            (0, 0) => Ok(0..0),
            (found, count) if found == tag => Ok(0..count),
            _ => Err(self.problem("this is no list of a NetCDF header")),
        }
    }

    fn kind(&mut self) -> Result<Kind, ReadError> {
        let kind = Kind::of(self.word()?);
        kind.ok_or_else(|| self.problem("this type of numbers is not known"))
    }

    fn attributes(&mut self) -> Result<Vec<Attribute<'a>>, ReadError> {
        let mut all = Vec::new();
        for _ in self.list(ATTRIBUTES)? {
            let (name, kind, count) = (self.name()?, self.kind()?, self.count()?);
            let bytes = count.checked_mul(kind.bytes());
            let bytes = bytes.ok_or_else(|| self.problem("this count is too large"))?;
            all.push(Attribute { name, kind, bytes: self.padded(bytes)? });
        }
        Ok(all)
    }
}

/// A file with its header read.
struct Dataset<'a> {
    file: &'a [u8],
    /// Names and lengths; one dimension may be that of the records.
    dimensions: Vec<(String, usize)>,
    of_records: Option<usize>,
    /// The bytes from one record to the next.
    record: usize,
    variables: Vec<Variable<'a>>,
}

impl<'a> Dataset<'a> {
    fn read(file: &'a [u8]) -> Result<Self, ReadError> {
        let version = file.get(3).copied().unwrap_or_default();
        let mut header = Header { file, at: 4, version };
        let records = header.count()?;
        let mut dimensions = Vec::new();
        let mut of_records = None;
        for index in header.list(DIMENSIONS)? {
            let (name, length) = (header.name()?, header.count()?);
            if length == 0 {
                of_records = Some(index);
            }
            dimensions.push((name, if length == 0 { records } else { length }));
        }
        header.attributes()?;
        let mut variables: Vec<Variable<'a>> = Vec::new();
        let mut records = Vec::new();
        for _ in header.list(VARIABLES)? {
            let name = header.name()?;
            let mut own = Vec::new();
            for _ in 0..header.count()? {
                let index = header.count()?;
                if index >= dimensions.len() {
                    return Err(header.problem("there is no such dimension"));
                }
                own.push(index);
            }
            let (attributes, kind, size) = (header.attributes()?, header.kind()?, header.count()?);
            let begin = if version == 1 { header.word()? as usize } else { header.long()? };
            if own.first().is_some_and(|first| Some(*first) == of_records) {
                let values = own[1..].iter().try_fold(kind.bytes(), |bytes, dimension| {
                    bytes.checked_mul(dimensions[*dimension].1)
                });
                records.push((size, values.unwrap_or(size)));
            }
            variables.push(Variable { name, dimensions: own, attributes, kind, begin });
        }
        let record = match records[..] {
            // A single variable of records is not filled up to four bytes.
            [(_, values)] => values,
            _ => records.iter().fold(0, |sum: usize, (size, _)| sum.saturating_add(*size)),
        };
        Ok(Self { file, dimensions, of_records, record, variables })
    }

    /// The dimensions of a variable without those of length 1 that come first.
    fn shape<'v>(&self, variable: &'v Variable<'_>, least: usize) -> &'v [usize] {
        let mut own = &variable.dimensions[..];
        while own.len() > least && self.dimensions[own[0]].1 == 1 {
            own = &own[1..];
        }
        own
    }

    /// All numbers of a variable of so many rows and columns, scaled; NaN where there is none. `of_rows` is the dimension of the rows.
    fn numbers(
        &self,
        variable: &Variable<'_>,
        [rows, columns]: [usize; 2],
        of_rows: usize,
    ) -> Result<Vec<f64>, ReadError> {
        let short =
            || ReadError::place(&variable.name, "the file ends before the last of its values");
        let size = variable.kind.bytes();
        let row = columns.checked_mul(size).ok_or_else(short)?;
        let step = if Some(of_rows) == self.of_records { self.record } else { row };
        let last = rows.checked_sub(1).and_then(|last| last.checked_mul(step));
        let end = last.and_then(|last| last.checked_add(row));
        let end = end.and_then(|length| variable.begin.checked_add(length)).ok_or_else(short)?;
        if end > self.file.len() || step < row || row == 0 {
            return Err(short());
        }
        let scale = variable.number("scale_factor").unwrap_or(1.0);
        let offset = variable.number("add_offset").unwrap_or(0.0);
        let missing = ["_FillValue", "missing_value"].map(|name| variable.number(name));
        let mut all = Vec::new();
        all.try_reserve_exact(rows * columns)?;
        for index in 0..rows {
            let start = variable.begin + index * step;
            all.extend(self.file[start..start + row].chunks_exact(size).map(|bytes| {
                let raw = variable.kind.number(bytes);
                if missing.contains(&Some(raw)) { f64::NAN } else { raw * scale + offset }
            }));
        }
        Ok(all)
    }

    /// The coordinates along a dimension, if it has them.
    fn coordinates(&self, dimension: usize) -> Option<&Variable<'a>> {
        let (name, _) = &self.dimensions[dimension];
        self.variables.iter().find(|own| {
            own.name == *name && own.dimensions == [dimension] && own.kind != Kind::Text
        })
    }

    /// The first coordinate along a dimension and their distance, which is below 0 if they fall.
    fn axis(&self, variable: &Variable<'_>) -> Result<[f64; 2], ReadError> {
        let count = self.dimensions[variable.dimensions[0]].1;
        let wrong = |problem: &str| ReadError::place(&variable.name, problem);
        if count < 2 {
            return Err(wrong("a grid needs two or more coordinates each way"));
        }
        let values = self.numbers(variable, [count, 1], variable.dimensions[0])?;
        let step = (values[count - 1] - values[0]) / (count - 1) as f64;
        let is_even = |(index, value): (usize, &f64)| {
            (value - (values[0] + index as f64 * step)).abs() <= UNEVEN * step.abs()
        };
        if step == 0.0 || !step.is_finite() || !values.iter().enumerate().all(is_even) {
            return Err(wrong("its values are not evenly spaced; a grid is"));
        }
        Ok([values[0], step])
    }
}

/// Reads a grid.
pub(crate) fn read_raster(file: &[u8]) -> Result<Raster, ReadError> {
    let data = Dataset::read(file)?;
    let on_grid = |variable: &&Variable<'_>| {
        let own = data.shape(variable, 2);
        own.len() == 2
            && variable.kind != Kind::Text
            && own.iter().all(|dimension| data.coordinates(*dimension).is_some())
    };
    let grids: Vec<&Variable<'_>> = data.variables.iter().filter(on_grid).collect();
    let usual = || USUAL.iter().find_map(|name| grids.iter().find(|own| own.name == *name));
    let grid = match grids[..] {
        [] => {
            let problem = "no variable has two dimensions with coordinates, such as lat and lon";
            return Err(ReadError::place("", problem));
        }
        [grid] => grid,
        _ => usual().copied().ok_or_else(|| {
            let names: Vec<&str> = grids.iter().take(10).map(|own| &*own.name).collect();
            let names = names.join(", ");
            ReadError::place("", format!("{names} are all on grids; leave one in the file"))
        })?,
    };
    let own = data.shape(grid, 2);
    let lengths = [data.dimensions[own[0]].1, data.dimensions[own[1]].1];
    let [Some(first), Some(second)] = [own[0], own[1]].map(|it| data.coordinates(it)) else {
        return Err(ReadError::place(&grid.name, "it has no coordinates"));
    };
    let is_transposed = first.is_along("x", "degrees_east", ["lon", "x"])
        || second.is_along("y", "degrees_north", ["lat", "y"]);
    let mut values = data.numbers(grid, lengths, own[0])?;
    let (mut y, mut x) = (data.axis(first)?, data.axis(second)?);
    let [mut rows, mut columns] = lengths;
    if is_transposed {
        let at = |row: usize, column: usize| values[column * columns + row];
        let turned = (0..columns).flat_map(|row| (0..rows).map(move |column| (row, column)));
        values = turned.map(|(row, column)| at(row, column)).collect();
        (x, y, rows, columns) = (y, x, columns, rows);
    }
    // Rows run from the lowest y on, columns from the lowest x.
    if y[1] < 0.0 {
        values = values.chunks_exact(columns).rev().flatten().copied().collect();
        y = [y[0] + y[1] * (rows - 1) as f64, -y[1]];
    }
    if x[1] < 0.0 {
        values.chunks_exact_mut(columns).for_each(<[f64]>::reverse);
        x = [x[0] + x[1] * (columns - 1) as f64, -x[1]];
    }
    let (origin, spacing) = (DVec2::new(x[0], y[0]), DVec2::new(x[1], y[1]));
    Ok(Raster { origin, spacing, columns, values })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A list of a header: what it begins with, and its items.
    fn list(tag: u32, items: &[Vec<u8>], version: u8) -> Vec<u8> {
        let tag = if items.is_empty() { 0 } else { tag };
        [tag.to_be_bytes().to_vec(), count(items.len(), version), items.concat()].concat()
    }

    fn count(value: usize, version: u8) -> Vec<u8> {
        match version {
            5 => (value as u64).to_be_bytes().to_vec(),
            _ => (value as u32).to_be_bytes().to_vec(),
        }
    }

    fn padded(bytes: &[u8]) -> Vec<u8> {
        let mut bytes = bytes.to_vec();
        bytes.resize(bytes.len().next_multiple_of(4), 0);
        bytes
    }

    fn name(name: &str, version: u8) -> Vec<u8> {
        [count(name.len(), version), padded(name.as_bytes())].concat()
    }

    fn attribute(key: &str, kind: u32, values: usize, bytes: &[u8], version: u8) -> Vec<u8> {
        [name(key, version), kind.to_be_bytes().to_vec(), count(values, version), padded(bytes)]
            .concat()
    }

    /// A variable for a file: name, dimensions, attributes, type and bytes.
    type Given<'a> = (&'a str, &'a [usize], Vec<Vec<u8>>, u32, Vec<u8>);

    fn file(version: u8, dimensions: &[(&str, usize)], variables: &[Given<'_>]) -> Vec<u8> {
        let header = |begins: &[usize]| {
            let dimensions: Vec<Vec<u8>> = dimensions
                .iter()
                .map(|(key, length)| [name(key, version), count(*length, version)].concat())
                .collect();
            let variables: Vec<Vec<u8>> = variables
                .iter()
                .zip(begins)
                .map(|((key, own, attributes, kind, bytes), begin)| {
                    let own: Vec<u8> = own.iter().flat_map(|it| count(*it, version)).collect();
                    let begin = match version {
                        1 => (*begin as u32).to_be_bytes().to_vec(),
                        _ => (*begin as u64).to_be_bytes().to_vec(),
                    };
                    [
                        name(key, version),
                        count(own.len() / count(0, version).len(), version),
                        own,
                        list(ATTRIBUTES, attributes, version),
                        kind.to_be_bytes().to_vec(),
                        count(padded(bytes).len(), version),
                        begin,
                    ]
                    .concat()
                })
                .collect();
            [
                vec![b'C', b'D', b'F', version],
                count(1, version),
                list(DIMENSIONS, &dimensions, version),
                list(ATTRIBUTES, &[], version),
                list(VARIABLES, &variables, version),
            ]
            .concat()
        };
        let mut at = header(&vec![0; variables.len()]).len();
        let mut begins = Vec::new();
        for variable in variables {
            begins.push(at);
            at += padded(&variable.4).len();
        }
        let data = variables.iter().flat_map(|variable| padded(&variable.4));
        header(&begins).into_iter().chain(data).collect()
    }

    fn floats(values: &[f64]) -> Vec<u8> {
        values.iter().flat_map(|value| value.to_be_bytes()).collect()
    }

    fn shorts(values: &[i16]) -> Vec<u8> {
        values.iter().flat_map(|value| value.to_be_bytes()).collect()
    }

    /// Heights in half metres above 100, three to a row, from north to south, in one record.
    fn heights(version: u8) -> Vec<u8> {
        let scaled = vec![
            attribute("scale_factor", 6, 1, &floats(&[0.5]), version),
            attribute("add_offset", 6, 1, &floats(&[100.0]), version),
            attribute("_FillValue", 3, 1, &shorts(&[-99]), version),
        ];
        file(
            version,
            &[("time", 0), ("lat", 2), ("lon", 3)],
            &[
                ("lat", &[1], vec![], 6, floats(&[41.0, 40.5])),
                ("lon", &[2], vec![], 5, [20.0_f32, 20.25, 20.5].map(f32::to_be_bytes).concat()),
                ("elevation", &[0, 1, 2], scaled, 3, shorts(&[1, 2, 3, 4, -99, 6])),
            ],
        )
    }

    #[test]
    fn all_three_kinds_of_classic_grids_are_read() {
        for version in [1, 2, 5] {
            let grid = read_raster(&heights(version)).unwrap();
            assert_eq!(
                (grid.origin, grid.spacing, grid.columns),
                (DVec2::new(20.0, 40.5), DVec2::new(0.25, 0.5), 3)
            );
            // From the south on.
            assert_eq!((grid.values[0], grid.values[2]), (102.0, 103.0));
            assert!(grid.values[1].is_nan());
            assert_eq!(grid.values[3..], [100.5, 101.0, 101.5]);
        }
    }

    #[test]
    fn columns_before_rows_and_falling_coordinates_are_turned() {
        let bytes = file(
            2,
            &[("x", 3), ("y", 2)],
            &[
                ("x", &[0], vec![], 6, floats(&[2.0, 1.0, 0.0])),
                ("y", &[1], vec![], 6, floats(&[5.0, 6.0])),
                ("z", &[0, 1], vec![], 1, vec![1, 2, 3, 4, 5, 0xff]),
            ],
        );
        let grid = read_raster(&bytes).unwrap();
        assert_eq!((grid.origin, grid.columns), (DVec2::new(0.0, 5.0), 3));
        assert_eq!(grid.values, [5.0, 3.0, 1.0, -1.0, 4.0, 2.0]);
    }

    #[test]
    fn what_is_no_grid_is_refused_with_the_reason() {
        let refusal = |bytes: &[u8]| read_raster(bytes).unwrap_err().to_string();
        let uneven = |y: [f64; 3]| {
            file(
                1,
                &[("y", 3), ("x", 2)],
                &[
                    ("y", &[0], vec![], 6, floats(&y)),
                    ("x", &[1], vec![], 6, floats(&[0.0, 1.0])),
                    ("a", &[0, 1], vec![], 6, floats(&[0.0; 6])),
                    ("b", &[0, 1], vec![], 6, floats(&[0.0; 6])),
                ],
            )
        };
        let two = refusal(&uneven([0.0, 1.0, 2.0]));
        assert!(two.contains("a, b are all on grids"), "{two}");
        let mut uneven = uneven([0.0, 1.0, 5.0]);
        let b = uneven.windows(5).rposition(|word| word == b"\x01b\0\0\0").unwrap();
        uneven[b + 1] = b'z';
        assert!(refusal(&uneven).contains("not evenly spaced"), "{}", refusal(&uneven));
        let none = file(1, &[("y", 3)], &[("y", &[0], vec![], 6, floats(&[0.0, 1.0, 2.0]))]);
        assert!(refusal(&none).contains("no variable has two dimensions"));
    }

    /// Cut anywhere, and with any byte another one, a file is read or refused.
    #[test]
    fn hostile_files_are_refused_without_a_panic() {
        for version in [1, 2, 5] {
            let good = heights(version);
            for end in 0..good.len() {
                assert!(read_raster(&good[..end]).is_err(), "{version} {end}");
            }
            for at in 4..good.len() {
                for byte in [0, 1, 3, 0x7f, 0x80, 0xff] {
                    let mut bad = good.clone();
                    bad[at] = byte;
                    let _ = read_raster(&bad);
                }
            }
        }
    }
}
