//! A grid in an array of numpy, as `numpy.save` writes it: a row of x, y and value for each point.

use super::array::Array;
use crate::ReadError;
use crate::raster::Raster;
use glam::DVec2;
use std::borrow::Cow;

/// Columns and rows may lie this share of their distance off: coordinates of 32 bits do.
const OFF: f64 = 1e-2;

/// Reads a grid from rows of x, y and value, in any order. O(n log n) time.
pub(crate) fn read_rows(file: &[u8]) -> Result<Raster, ReadError> {
    let array = Array::new(0, Cow::Borrowed(file))?;
    let [count, width] = array.shape();
    if width != 3 {
        return Err(ReadError::place(
            "",
            format!(
                "the array has the shape ({count}, {width}) and no place; rows of x, y and value are read, or an NPZ of \
                 numpy.savez(\"grid.npz\", values=array, origin=[x, y], spacing=[dx, dy]), its rows from the lowest y on"
            ),
        ));
    }
    let [xs, ys] = [0, 1].map(|axis| {
        let mut all: Vec<f64> = (0..count).map(|row| array.float(row, axis)).collect();
        all.sort_unstable_by(f64::total_cmp);
        all.dedup();
        all
    });
    let problem = |problem: String| Err(ReadError::place("", problem));
    if xs.len().checked_mul(ys.len()) != Some(count) {
        return problem(format!(
            "its {count} rows of x, y and value are no grid: {} different x and {} different y",
            xs.len(),
            ys.len()
        ));
    }
    let (Some((x, dx)), Some((y, dy))) = (even(&xs), even(&ys)) else {
        return problem(
            "its rows of x, y and value need two or more x and y, each at even distances"
                .to_owned(),
        );
    };
    let mut values = vec![None; count];
    for row in 0..count {
        let place = |all: &[f64], axis: usize| {
            all.binary_search_by(|other| other.total_cmp(&array.float(row, axis)))
        };
        let (Ok(column), Ok(line)) = (place(&xs, 0), place(&ys, 1)) else {
            return problem(format!("row {row} is at no point of the grid"));
        };
        if values[line * xs.len() + column].replace(array.float(row, 2)).is_some() {
            return problem(format!("row {row} is at the place of an earlier one"));
        }
    }
    // As many rows as places, each at one of its own.
    let values = values.into_iter().flatten().collect();
    Ok(Raster { origin: DVec2::new(x, y), spacing: DVec2::new(dx, dy), columns: xs.len(), values })
}

/// The first of two or more numbers, and the even distance from each to the next.
fn even(numbers: &[f64]) -> Option<(f64, f64)> {
    let (&[first, ..], &[.., last]) = (numbers, numbers) else { return None };
    let step = (last - first) / (numbers.len() - 1) as f64;
    let is_near = |(i, at): (usize, &f64)| (first + i as f64 * step - at).abs() <= OFF * step;
    // Neither holds of NaN and infinity.
    (step > 0.0 && step.is_finite() && numbers.iter().enumerate().all(is_near))
        .then_some((first, step))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::npz::array::head;

    fn file(rows: &[[f64; 3]]) -> Vec<u8> {
        let mut file = head("<f8", rows.len() as u32, Some(3));
        file.extend(rows.iter().flatten().flat_map(|number| number.to_le_bytes()));
        file
    }

    const ROWS: [[f64; 3]; 6] = [
        [2.0, 7.0, 4.0],
        [1.0, 5.0, 1.0],
        [1.0, 7.0, 3.0],
        [3.0, 5.0, f64::NAN],
        [2.0, 5.0, 2.0],
        [3.0, 7.0, 5.0],
    ];

    #[test]
    fn rows_in_any_order_are_a_grid() {
        let grid = read_rows(&file(&ROWS)).unwrap();
        assert_eq!((grid.origin, grid.spacing), (DVec2::new(1.0, 5.0), DVec2::new(1.0, 2.0)));
        assert_eq!(grid.columns, 3);
        assert!(grid.values[2].is_nan());
        assert_eq!([0, 1, 3, 4, 5].map(|at| grid.values[at]), [1.0, 2.0, 3.0, 4.0, 5.0]);
    }

    #[test]
    fn rows_that_are_no_grid_are_refused() {
        let changed = |row: usize, to: [f64; 3]| {
            let mut rows = ROWS;
            rows[row] = to;
            file(&rows)
        };
        for (file, words) in [
            (file(&ROWS[..5]), "5 rows of x, y and value are no grid: 3 different x and 2"),
            (file(&ROWS[..0]), "need two or more x and y"),
            (changed(0, ROWS[1]), "row 1 is at the place of an earlier one"),
            (changed(0, [2.5, 7.0, 0.0]), "no grid: 4 different x"),
            (file(&[1.0, 2.0, 9.0].map(|x| [x, 1.0, 0.0])), "at even distances"),
            (
                file(
                    &[[0.0, 0.0], [0.0, 1.0], [f64::INFINITY, 0.0], [f64::INFINITY, 1.0]]
                        .map(|[x, y]| [x, y, 0.0]),
                ),
                "at even distances",
            ),
            (head("<f8", 0, Some(2)), "shape (0, 2) and no place; rows of x, y and value"),
            (file(&ROWS)[..264].to_vec(), "not what its shape"),
        ] {
            let error = read_rows(&file).unwrap_err().to_string();
            assert!(error.contains(words), "{error}");
        }
    }
}
