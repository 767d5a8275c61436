//! Grids in classic NetCDF: a number at each longitude and latitude, or x and y.
//!
//! The three kinds of the classic format are read: with offsets of 32 and of 64 bits, and with all counts of 64 bits (CDF-1, 2 and 5).
//! The grid is the variable with two dimensions that both have coordinates, evenly spaced; dimensions of length 1 before them do
//! not count. Grids of GMT 3 are read, too. `scale_factor`, `add_offset`, `_FillValue` and `missing_value` hold. Nothing is allocated beyond what the file holds.
//!
//! Limits: NetCDF-4 is HDF5, which is not read.

mod header;

use glam::DVec2;

use self::header::{Dataset, Kind, Variable};
use crate::ReadError;
use crate::raster::Raster;

/// The names that the depth or the height has in the usual grids, where several variables are on one.
const USUAL: [&str; 7] = ["elevation", "depth", "z", "bathymetry", "topo", "altitude", "Band1"];
/// Coordinates may be so far from even, as a share of their distance: those of 32 bits are rounded.
const UNEVEN: f64 = 0.05;

impl<'a> Dataset<'a> {
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
        let [fill, missing] = ["_FillValue", "missing_value"].map(|name| variable.number(name));
        let missing = [fill.or(variable.kind.fill()), missing];
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

    fn named(&self, name: &str) -> Option<&Variable<'a>> {
        self.variables.iter().find(|own| own.name == name)
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

/// Reads a grid as GMT 3 wrote it: no coordinates but their ranges, and the values in one row, from the highest y on.
fn of_gmt_3(data: &Dataset<'_>) -> Result<Raster, ReadError> {
    let wrong = || {
        let problem = "the grid is of GMT's old kind and its parts do not fit together; gmt grdconvert OLD.grd=cf NEW.nc \
             --IO_NC4_CHUNK_SIZE=classic may make one that is read";
        ReadError::place("", problem)
    };
    let row = |name: &str, count: usize| {
        let variable = data.named(name).ok_or_else(wrong)?;
        match variable.dimensions[..] {
            [own] if data.dimensions[own].1 == count => data.numbers(variable, [count, 1], own),
            _ => Err(wrong()),
        }
    };
    let pair = |name: &str| Ok::<_, ReadError>(DVec2::from_slice(&row(name, 2)?));
    let [x, y, counts] = [pair("x_range")?, pair("y_range")?, pair("dimension")?];
    let [columns, rows] = counts.to_array().map(|count| count as usize);
    let count = columns.checked_mul(rows).filter(|_| columns > 1 && rows > 1).ok_or_else(wrong)?;
    let values = row("z", count)?;
    let values = values.chunks_exact(columns).rev().flatten().copied().collect();
    let reach = DVec2::new(x[1] - x[0], y[1] - y[0]);
    if !(reach.is_finite() && reach.cmpgt(DVec2::ZERO).all()) {
        return Err(wrong());
    }
    let is_of_cells = data.named("z").and_then(|z| z.number("node_offset")) == Some(1.0);
    let spacing = reach / if is_of_cells { counts } else { counts - DVec2::ONE };
    let first = if is_of_cells { spacing / 2.0 } else { DVec2::ZERO };
    Ok(Raster { origin: DVec2::new(x[0], y[0]) + first, spacing, columns, values })
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
        [] if data.named("x_range").is_some() => return of_gmt_3(&data),
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
    use super::header::{ATTRIBUTES, DIMENSIONS, VARIABLES};
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

    /// They have no coordinates, and were refused.
    #[test]
    fn grids_of_gmt_3_are_read() {
        let int = |value: i32| value.to_be_bytes().to_vec();
        let grid = |columns: i32, offset: i32| {
            let own = vec![
                attribute("scale_factor", 6, 1, &floats(&[2.0]), 1),
                attribute("node_offset", 4, 1, &int(offset), 1),
            ];
            file(
                1,
                &[("side", 2), ("xysize", 6)],
                &[
                    ("x_range", &[0], vec![], 6, floats(&[20.0, 21.0])),
                    ("y_range", &[0], vec![], 6, floats(&[30.0, 32.0])),
                    ("z_range", &[0], vec![], 6, floats(&[1.0, 6.0])),
                    ("spacing", &[0], vec![], 6, floats(&[0.0, 0.0])),
                    ("dimension", &[0], vec![], 4, [int(columns), int(2)].concat()),
                    ("z", &[1], own, 3, shorts(&[1, 2, 3, 4, 5, 6])),
                ],
            )
        };
        // Rows run from the north on, and cells have their values in the middle.
        for (offset, origin, spacing) in
            [(0, [20.0, 30.0], [0.5, 2.0]), (1, [20.0 + 1.0 / 6.0, 30.5], [1.0 / 3.0, 1.0])]
        {
            let found = read_raster(&grid(3, offset)).unwrap();
            assert_eq!((found.origin, found.spacing), (origin.into(), spacing.into()));
            assert_eq!((found.columns, found.values), (3, vec![8.0, 10.0, 12.0, 2.0, 4.0, 6.0]));
        }
        for columns in [4, 1, -3] {
            let told = read_raster(&grid(columns, 0)).unwrap_err().to_string();
            assert!(told.contains("gmt grdconvert OLD.grd=cf NEW.nc"), "{told}");
        }
    }

    /// Without `_FillValue` such values came out as depths of 10^37.
    #[test]
    fn the_fill_values_of_netcdf_are_no_values_unless_others_are_named() {
        let of = |kind: u32, z: Vec<u8>, attributes: Vec<Vec<u8>>| {
            let axes = [floats(&[0.0, 1.0]), floats(&[5.0, 6.0])];
            let [x, y] = axes.map(|bytes| (vec![], 6, bytes));
            let bytes = file(
                1,
                &[("y", 2), ("x", 2)],
                &[
                    ("x", &[1], x.0, x.1, x.2),
                    ("y", &[0], y.0, y.1, y.2),
                    ("z", &[0, 1], attributes, kind, z),
                ],
            );
            read_raster(&bytes).unwrap().values
        };
        let single = |own: &[f32]| own.iter().flat_map(|value| value.to_be_bytes()).collect();
        let fill = 9.969_21e36_f32;
        let found = of(5, single(&[1.0, fill, 3.0, 4.0]), vec![]);
        assert!(found[1].is_nan() && found[2] == 3.0, "{found:?}");
        assert!(of(3, shorts(&[1, -32_767, 3, 4]), vec![])[1].is_nan());
        let named = vec![attribute("_FillValue", 3, 1, &shorts(&[3]), 1)];
        let found = of(3, shorts(&[1, -32_767, 3, 4]), named);
        assert!(found[1] == -32_767.0 && found[2].is_nan(), "{found:?}");
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
