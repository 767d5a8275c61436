//! Reading SELAFIN.

use std::io::BufRead;

use glam::DVec3;
use mindeg_mesh::TriMesh;

use crate::ReadError;
use crate::numbers::{Numbers, Scalar, bits};
use crate::scanner::Scanner;

/// The letters of the title, and of the word behind it that tells the size of the numbers.
pub(super) const TITLE: [usize; 2] = [72, 8];
/// The letters of a variable's name, and of its unit.
pub(super) const VARIABLE: [usize; 2] = [16, 16];
/// The variable that holds the depths, in TELEMAC's two languages.
pub(super) const BOTTOM: [&str; 2] = ["BOTTOM", "FOND"];

/// The bytes of the title's record.
const TITLE_LEN: usize = TITLE[0] + TITLE[1];
const WHOLE: Scalar = Scalar::Signed(4);

/// Whether a file begins with the record of a title that names the format.
pub(super) fn begins(bytes: &[u8]) -> bool {
    let word = bytes.get(4 + TITLE[0]..).unwrap_or_default();
    word.starts_with(b"SERAFIN") && is_big(bytes).is_some()
}

/// Whether the length of the title begins with its most significant byte; `None` if it is another length.
fn is_big(bytes: &[u8]) -> Option<bool> {
    let length = bytes.get(..4)?;
    [true, false].into_iter().find(|&is_big| bits(length, is_big) == TITLE_LEN as u64)
}

/// Reads a mesh from a SELAFIN of either precision and order of bytes, with the variable BOTTOM of the first time as
/// its depth.
///
/// O(n) time and memory for n bytes, whatever the file says.
///
/// # Errors
///
/// Errors of the input; records that break the format; elements of other than three corners; corners that the file
/// has no point for; a file without elements.
///
/// # Example
///
/// ```
/// use mindeg_formats::slf;
///
/// let error = slf::read(&[0, 0, 0, 80, b' '][..]).unwrap_err();
/// assert_eq!(error.to_string(), "byte 4: the title should take 80 bytes; the file has 1 more");
/// ```
pub fn read(mut input: impl BufRead) -> Result<TriMesh, ReadError> {
    let mut bytes = Vec::new();
    input.read_to_end(&mut bytes)?;
    let Some(is_big) = is_big(&bytes) else {
        return Err(ReadError::byte(
            0,
            format!("a SELAFIN begins with a record of {TITLE_LEN} bytes"),
        ));
    };
    let mut scanner = Scanner::new(&bytes);
    scanner.encoding = if is_big { Numbers::BigEndian } else { Numbers::LittleEndian };
    let mut records = Records { scanner };
    let title = records.next("the title", TITLE_LEN)?;
    let (name, word) = title.split_at(TITLE[0]);
    let float = Scalar::Float(if word.starts_with(b"SERAFIND") { 8 } else { 4 });
    let [linear, quadratic] = records.whole("the numbers of variables")?;
    let mut bottom = None;
    for index in 0..linear.saturating_add(quadratic) {
        let variable = records.next("the name of a variable", VARIABLE.iter().sum())?;
        let variable = variable[..VARIABLE[0]].trim_ascii();
        if BOTTOM.iter().any(|name| variable.eq_ignore_ascii_case(name.as_bytes())) {
            bottom = Some(index);
        }
    }
    let [_, _, left, low, _, _, planes, _, _, has_date] = records.whole("the parameters")?;
    if planes > 1 {
        return Err(records
            .scanner
            .problem(format!("the mesh has {planes} planes; only one is read")));
    }
    if has_date == 1 {
        let _: [i64; 6] = records.whole("the date")?;
    }
    let [elements, points, corners, _] = records.whole("the sizes")?;
    if corners != 3 {
        let problem = format!("the elements have {corners} corners; triangles have 3");
        return Err(records.scanner.problem(problem));
    }
    let corner = |item: &[u8]| {
        let number = WHOLE.whole(item, is_big).filter(|number| (1..=points).contains(number));
        number.and_then(|number| u32::try_from(number - 1).ok())
    };
    let ikle = records.next("the corners of the elements", size(elements, 3, WHOLE))?;
    let triangles = ikle.as_chunks::<12>().0.iter().map(|item| {
        let [a, b, c] = [0, 4, 8].map(|at| corner(&item[at..at + 4]));
        Some([a?, b?, c?])
    });
    let Some(triangles) = triangles.collect::<Option<Vec<_>>>() else {
        let problem = "an element names a point that does not exist";
        return Err(records.scanner.problem(format!("{problem}; the file has 1 to {points}")));
    };
    records.next("the numbers of the boundary points", size(points, 1, WHOLE))?;
    let length = size(points, 1, float);
    let mut numbers = |what, from: i64| -> Result<Vec<f64>, ReadError> {
        let items = records.next(what, length)?.chunks_exact(float.len());
        Ok(items.map(|item| float.float(item, is_big) + from as f64).collect())
    };
    let [xs, ys] = [numbers("the x of the points", left)?, numbers("the y of the points", low)?];
    let mut depths = Vec::new();
    if let Some(bottom) = bottom
        && !records.scanner.rest().is_empty()
    {
        records.next("the time", float.len())?;
        for _ in 0..bottom {
            records.next("a variable", length)?;
        }
        let heights = records.next("the heights of the bottom", length)?;
        let heights = heights.chunks_exact(float.len());
        depths = heights.map(|item| 0.0 - float.float(item, is_big)).collect();
    }
    let positions = xs.into_iter().zip(ys).map(|(x, y)| DVec3::new(x, y, 0.0)).collect();
    let mesh = TriMesh::new(positions, triangles)?;
    let name = String::from_utf8_lossy(name.trim_ascii());
    let mesh = if name.is_empty() { mesh } else { mesh.named(name) };
    let has_depths = depths.iter().any(|&depth| depth != 0.0);
    Ok(if has_depths { mesh.with_depths(depths) } else { mesh })
}

/// The bytes of `count` times `each` numbers.
fn size(count: i64, each: usize, number: Scalar) -> usize {
    usize::try_from(count).unwrap_or(0).saturating_mul(each * number.len())
}

/// Records of Fortran: each between two copies of its length.
struct Records<'a> {
    scanner: Scanner<'a>,
}

impl<'a> Records<'a> {
    /// The next record, which is to have this length.
    fn next(&mut self, what: &str, length: usize) -> Result<&'a [u8], ReadError> {
        self.length(what, length)?;
        let content = self.scanner.take(length, what)?;
        self.length(what, length)?;
        Ok(content)
    }

    /// The numbers of the next record.
    fn whole<const N: usize>(&mut self, what: &str) -> Result<[i64; N], ReadError> {
        let items = self.next(what, N * WHOLE.len())?.chunks_exact(WHOLE.len());
        let mut numbers = [0; N];
        let is_big = self.scanner.encoding == Numbers::BigEndian;
        for (number, item) in numbers.iter_mut().zip(items) {
            *number = WHOLE.whole(item, is_big).unwrap_or(0);
        }
        Ok(numbers)
    }

    fn length(&mut self, what: &str, length: usize) -> Result<(), ReadError> {
        let at = self.scanner.offset();
        let found = self.scanner.int(what)?;
        if usize::try_from(found) == Ok(length) {
            return Ok(());
        }
        let problem = format!("the record of {what} has {found} bytes; it should have {length}");
        Err(self.scanner.problem_at(at, problem))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg_mesh::{Positions, Triangles};

    /// A file of a triangle; `little` turns every number round.
    fn file(little: bool, word: &str) -> Vec<u8> {
        let mut bytes = Vec::new();
        let number = |value: i32| if little { value.to_le_bytes() } else { value.to_be_bytes() };
        let float = |value: f32| number(value.to_bits() as i32);
        let mut record = |content: &[u8]| {
            let length = number(content.len() as i32);
            bytes.extend([&length[..], content, &length].concat());
        };
        let whole =
            |values: &[i32]| values.iter().flat_map(|value| number(*value)).collect::<Vec<_>>();
        let floats =
            |values: &[f32]| values.iter().flat_map(|value| float(*value)).collect::<Vec<_>>();
        record(format!("{:72}{word:8}", "bay").as_bytes());
        record(&whole(&[2, 0]));
        record(format!("{:16}{:16}", "VITESSE U", "M/S").as_bytes());
        record(format!("{:16}{:16}", "FOND", "M").as_bytes());
        record(&whole(&[1, 0, 500, 0, 0, 0, 0, 0, 0, 1]));
        record(&whole(&[1972, 7, 13, 17, 24, 27]));
        record(&whole(&[1, 3, 3, 1]));
        record(&whole(&[1, 2, 3]));
        record(&whole(&[1, 2, 3]));
        record(&floats(&[0.0, 1.0, 0.0]));
        record(&floats(&[0.0, 0.0, 1.0]));
        record(&floats(&[0.0]));
        record(&floats(&[9.0, 9.0, 9.0]));
        record(&floats(&[-2.5, 0.0, 1.0]));
        bytes
    }

    #[test]
    fn both_orders_of_bytes_the_origin_and_the_date_are_read() {
        for little in [false, true] {
            let mesh = read(&file(little, "SERAFIN")[..]).unwrap();
            assert_eq!((mesh.name(), mesh.triangles()), (Some("bay"), &[[0, 1, 2]][..]));
            assert_eq!(mesh.positions()[1], DVec3::new(501.0, 0.0, 0.0));
            let mut depths = [0.0; 3];
            mesh.fill_depths(0, &mut depths);
            assert_eq!(depths, [2.5, 0.0, -1.0]);
            assert!(begins(&file(little, "SERAFIN")));
        }
    }

    #[test]
    fn a_file_that_ends_or_lies_is_refused_with_the_byte() {
        let whole = file(false, "SERAFIN");
        for end in 0..whole.len() {
            // Behind the points the file may end: it has no time then.
            if let Ok(mesh) = read(&whole[..end]) {
                assert_eq!(mesh.positions().len(), 3, "{end} bytes");
            }
        }
        let refused = |at: usize, message: &str| {
            let mut bytes = whole.clone();
            bytes[at] = 0x70;
            let error = read(&bytes[..]).map(|_| ()).unwrap_err().to_string();
            assert!(error.starts_with(message), "{error}");
        };
        refused(0, "byte 0: a SELAFIN begins with a record of 80 bytes");
        refused(88, "byte 88: the record of the numbers of variables has 1879048200 bytes");
        // More variables than the file has.
        refused(
            92,
            "byte 184: the record of the name of a variable has 40 bytes; it should have 32",
        );
    }
}
