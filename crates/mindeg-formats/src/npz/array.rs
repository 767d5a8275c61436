//! An array of numpy: a head that tells type and shape, then the numbers.

use crate::ReadError;
use crate::numbers::{HALF_EPSILON, Scalar, bits};
use std::borrow::Cow;

/// The first bytes of an array.
pub(crate) const MAGIC: &[u8] = b"\x93NUMPY";

/// The head of an array with rows of `columns` numbers; of one number without it.
pub(super) fn head(kind: &str, rows: u32, columns: Option<u32>) -> Vec<u8> {
    let columns = columns.map_or(String::new(), |columns| columns.to_string());
    let mut text =
        format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({rows}, {columns}), }}");
    // The numbers begin at a multiple of 64.
    let len = (10 + text.len() + 1).next_multiple_of(64) - 10;
    text.extend(std::iter::repeat_n(' ', len - 1 - text.len()));
    text.push('\n');
    let mut head = [MAGIC, &[1, 0]].concat();
    head.extend_from_slice(&(len as u16).to_le_bytes());
    head.extend_from_slice(text.as_bytes());
    head
}

/// An array that is read.
#[derive(Debug)]
pub(super) struct Array<'a> {
    scalar: Scalar,
    is_big: bool,
    is_transposed: bool,
    shape: [usize; 2],
    numbers: Cow<'a, [u8]>,
}

/// The head of an array.
struct Head {
    /// The type without the byte order.
    kind: String,
    is_big: bool,
    is_transposed: bool,
    /// One dimension is a row.
    shape: [usize; 2],
    /// The number of bytes before the numbers.
    len: usize,
}

impl Head {
    fn read(offset: usize, bytes: &[u8]) -> Result<Self, ReadError> {
        let problem = |problem: &str| ReadError::byte(offset, problem.to_owned());
        let broken = || problem("this is not the head of an array of numpy");
        let rest = bytes.strip_prefix(MAGIC).ok_or_else(broken)?;
        let (len, rest) = match rest {
            [1, _, a, b, rest @ ..] => (u16::from_le_bytes([*a, *b]).into(), rest),
            [2 | 3, _, a, b, c, d, rest @ ..] => (u32::from_le_bytes([*a, *b, *c, *d]), rest),
            _ => return Err(broken()),
        };
        let (head, numbers) = rest.split_at_checked(len as usize).ok_or_else(broken)?;
        let head = std::str::from_utf8(head).map_err(|_| broken())?;
        let value = |key: &str| {
            let (_, value) = head.split_once(&format!("'{key}':"))?;
            Some(value.trim_start())
        };
        let kind = value("descr").ok_or_else(broken)?;
        let kind = kind.strip_prefix('\'').and_then(|kind| kind.split_once('\''));
        let (kind, _) = kind.ok_or_else(|| problem("the array has records, not numbers"))?;
        let is_big = kind.starts_with('>');
        let kind = kind.trim_start_matches(['<', '>', '|', '=']);
        if kind == "O" {
            return Err(problem("the array is pickled, which is not read"));
        }
        let is_transposed = value("fortran_order").ok_or_else(broken)?.starts_with("True");
        let shape = value("shape").and_then(|shape| shape.strip_prefix('(')?.split_once(')'));
        let (shape, _) = shape.ok_or_else(broken)?;
        let lengths = shape.split(',').map(str::trim).filter(|length| !length.is_empty());
        let lengths: Vec<usize> =
            lengths.map(str::parse).collect::<Result<_, _>>().map_err(|_| broken())?;
        let (rows, columns) = match lengths[..] {
            [rows, columns] => (rows, columns),
            [columns] => (1, columns),
            _ => {
                let count = lengths.len();
                return Err(problem(&format!("the array has {count} dimensions, not 2")));
            }
        };
        let (shape, len) = ([rows, columns], bytes.len() - numbers.len());
        Ok(Self { kind: kind.to_owned(), is_big, is_transposed, shape, len })
    }

    /// The number of items of so many bytes each, which are all that follows.
    fn count(&self, offset: usize, item: usize, bytes: &[u8]) -> Result<usize, ReadError> {
        let [rows, columns] = self.shape;
        let (count, found) = (rows.checked_mul(columns), bytes.len() - self.len);
        match count {
            Some(count) if count.checked_mul(item) == Some(found) => Ok(count),
            _ => Err(ReadError::byte(
                offset,
                format!(
                    "the array has {found} bytes, which is not what its shape ({rows}, {columns}) takes"
                ),
            )),
        }
    }
}

/// The texts of an array of one dimension that starts at an offset of the file.
pub(super) fn texts(offset: usize, bytes: &[u8]) -> Result<Vec<String>, ReadError> {
    let head = Head::read(offset, bytes)?;
    let problem = |problem: String| ReadError::byte(offset, problem);
    let letters = head.kind.strip_prefix('U').and_then(|letters| letters.parse::<usize>().ok());
    let item = letters.and_then(|letters| letters.checked_mul(4));
    let item = item
        .ok_or_else(|| problem(format!("the array has the type {:?}, expected text", head.kind)))?;
    let count = head.count(offset, item, bytes)?;
    let text = |bytes: &[u8]| {
        let letter = |bytes: &[u8; 4]| match head.is_big {
            true => u32::from_be_bytes(*bytes),
            false => u32::from_le_bytes(*bytes),
        };
        let (letters, _) = bytes.as_chunks::<4>();
        let text: Option<String> =
            letters.iter().map(|bytes| char::from_u32(letter(bytes))).collect();
        // A text is filled up with zeros.
        text.map(|text| text.trim_end_matches('\0').to_owned())
    };
    let (start, mut texts) = (head.len, Vec::new());
    texts.try_reserve_exact(count)?;
    for index in 0..count {
        let text = text(&bytes[start + index * item..][..item]);
        texts.push(text.ok_or_else(|| {
            problem(format!("text {index} has letters that Unicode does not know"))
        })?);
    }
    Ok(texts)
}

impl<'a> Array<'a> {
    /// An array of two dimensions, or of one as a row, that starts at an offset of the file.
    pub(super) fn new(offset: usize, bytes: Cow<'a, [u8]>) -> Result<Self, ReadError> {
        let head = Head::read(offset, &bytes)?;
        let Head { kind, is_big, is_transposed, shape, len: start } = &head;
        let scalar = Scalar::of_name(kind, ["i", "u", "f"], 1).ok_or_else(|| {
            let problem = format!(
                "the array has the type {kind:?}; integers and floats of 16, 32 and 64 bits are read"
            );
            ReadError::byte(offset, problem)
        })?;
        head.count(offset, scalar.len(), &bytes)?;
        let (is_big, is_transposed, shape, start) = (*is_big, *is_transposed, *shape, *start);
        let numbers = match bytes {
            Cow::Borrowed(bytes) => Cow::Borrowed(&bytes[start..]),
            Cow::Owned(mut bytes) => {
                bytes.drain(..start);
                Cow::Owned(bytes)
            }
        };
        Ok(Self { scalar, is_big, is_transposed, shape, numbers })
    }

    pub(super) fn shape(&self) -> [usize; 2] {
        self.shape
    }

    /// The most that rounding to the type has changed a number, as a share of it; 0 for 64 bits.
    pub(super) fn rounding(&self) -> f64 {
        match self.scalar {
            Scalar::Float(2) => HALF_EPSILON / 2.0,
            Scalar::Float(4) => f64::from(f32::EPSILON) / 2.0,
            _ => 0.0,
        }
    }

    fn bytes(&self, row: usize, column: usize) -> &[u8] {
        let [rows, columns] = self.shape;
        let index = if self.is_transposed { column * rows + row } else { row * columns + column };
        let len = self.scalar.len();
        &self.numbers[index * len..][..len]
    }

    /// A number, as a float.
    pub(super) fn float(&self, row: usize, column: usize) -> f64 {
        self.scalar.float(self.bytes(row, column), self.is_big)
    }

    /// A number, if it is a whole one of 0 to 2^32 - 1; or else in words.
    pub(super) fn index(&self, row: usize, column: usize) -> Result<u32, String> {
        let bytes = self.bytes(row, column);
        match self.scalar.whole(bytes, self.is_big) {
            Some(i64::MAX) => Err(bits(bytes, self.is_big).to_string()),
            Some(whole) => u32::try_from(whole).map_err(|_| whole.to_string()),
            None => {
                let value = self.float(row, column);
                let index = value as u32;
                if f64::from(index) == value { Ok(index) } else { Err(value.to_string()) }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn array(kind: &str, order: &str, shape: &str, numbers: &[u8]) -> Vec<u8> {
        let head = format!("{{'descr': {kind}, 'fortran_order': {order}, 'shape': {shape}, }}\n");
        let mut bytes = b"\x93NUMPY\x01\0".to_vec();
        bytes.extend_from_slice(&(head.len() as u16).to_le_bytes());
        [bytes, head.into_bytes(), numbers.to_vec()].concat()
    }

    #[test]
    fn numbers_of_all_types_and_orders_are_read() {
        for (kind, order, numbers) in [
            ("'<i2'", "False", &[1, 0, 2, 0, 3, 0, 4, 0][..]),
            ("'>u2'", "False", &[0, 1, 0, 2, 0, 3, 0, 4]),
            ("'|i1'", "True", &[1, 3, 2, 4]),
            ("'>i2'", "True", &[0, 1, 0, 3, 0, 2, 0, 4]),
        ] {
            let bytes = array(kind, order, "(2, 2)", numbers);
            let array = Array::new(0, Cow::Borrowed(&bytes)).unwrap();
            let rows = [[0, 0], [0, 1], [1, 0], [1, 1]];
            assert_eq!(rows.map(|[i, j]| array.index(i, j)), [1, 2, 3, 4].map(Ok), "{kind}");
            assert_eq!(rows.map(|[i, j]| array.float(i, j)), [1.0, 2.0, 3.0, 4.0], "{kind}");
        }
        let halves: Vec<u8> = [0.5_f32, -1.5].iter().flat_map(|x| x.to_be_bytes()).collect();
        let bytes = array("'>f4'", "False", "(1, 2)", &halves);
        let array = Array::new(0, Cow::Borrowed(&bytes)).unwrap();
        assert_eq!([array.float(0, 0), array.float(0, 1)], [0.5, -1.5]);
    }

    #[test]
    fn whole_floats_are_indices() {
        let floats: Vec<u8> =
            [7.0, 1.5, -1.0, 1e10].iter().flat_map(|x: &f64| x.to_le_bytes()).collect();
        let bytes = array("'<f8'", "False", "(1, 4)", &floats);
        let array = Array::new(0, Cow::Borrowed(&bytes)).unwrap();
        let indices = [0, 1, 2, 3].map(|column| array.index(0, column));
        let refused = |word: &str| Err(word.to_owned());
        assert_eq!(indices, [Ok(7), refused("1.5"), refused("-1"), refused("10000000000")]);
    }

    #[test]
    fn indices_beyond_32_bits_are_told() {
        let bytes = array("'<i8'", "False", "(1, 1)", &(-1_i64).to_le_bytes());
        assert_eq!(Array::new(0, Cow::Borrowed(&bytes)).unwrap().index(0, 0), Err("-1".to_owned()));
        let bytes = array("'<u8'", "False", "(1, 1)", &(1_u64 << 32).to_le_bytes());
        assert_eq!(
            Array::new(0, Cow::Borrowed(&bytes)).unwrap().index(0, 0),
            Err("4294967296".to_owned())
        );
        let bytes = array("'<u8'", "False", "(1, 1)", &(1_u64 << 63).to_le_bytes());
        let index = Array::new(0, Cow::Borrowed(&bytes)).unwrap().index(0, 0);
        assert_eq!(index, Err("9223372036854775808".to_owned()));
    }

    #[test]
    fn other_arrays_are_refused() {
        for (kind, shape, expected) in [
            ("'|O'", "(1, 2)", "the array is pickled, which is not read"),
            ("[('x', '<f8')]", "(1, 2)", "the array has records, not numbers"),
            (
                "'<c8'",
                "(1, 2)",
                "the array has the type \"c8\"; integers and floats of 16, 32 and 64 bits are read",
            ),
            ("'<f8'", "(1, 1, 2)", "the array has 3 dimensions, not 2"),
            ("'<f8'", "(9, 9)", "the array has 16 bytes, which is not what its shape (9, 9) takes"),
            (
                "'<f8'",
                "(4294967296, 4294967296)",
                "the array has 16 bytes, which is not what its shape (4294967296, 4294967296) takes",
            ),
            ("'<f8'", "x", "this is not the head of an array of numpy"),
        ] {
            let bytes = array(kind, "False", shape, &[0; 16]);
            let error = Array::new(7, Cow::Borrowed(&bytes)).unwrap_err();
            assert_eq!(error.to_string(), format!("byte 7: {expected}"));
        }
    }

    #[test]
    fn heads_end_at_multiples_of_64() {
        for (rows, columns) in [(0, Some(3)), (4_294_967_295, Some(3)), (12, None)] {
            let head = head("<f8", rows, columns);
            assert_eq!((head.len() % 64, head.last()), (0, Some(&b'\n')));
        }
    }
}
