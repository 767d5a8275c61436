//! Numbers in files: their types in binary files, and arrays of them, as bytes or as text.

use std::ops::Range;
use std::str::FromStr;

use crate::decimals::{Decimals, push_digits};
use crate::sections::Section;

/// How a file stores numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Numbers {
    #[default]
    Text,
    LittleEndian,
    BigEndian,
}

impl Numbers {
    /// Bytes, the least significant first, or text.
    pub(crate) fn of(encoding: crate::Encoding) -> Self {
        match encoding {
            crate::Encoding::Binary => Self::LittleEndian,
            crate::Encoding::Ascii => Self::Text,
        }
    }

    /// Appends a row; in a text with a blank before each number but the first of a line.
    pub(crate) fn put<R: Row>(self, row: R, buffer: &mut Vec<u8>) {
        row.put(self, &mut R::columns(), buffer);
    }

    /// Ends the line of a text.
    pub(crate) fn end_line(self, buffer: &mut Vec<u8>) {
        if self == Self::Text {
            buffer.push(b'\n');
        }
    }

    /// A row for each item; a line of a text.
    pub(crate) fn records<'a, I: Iterator<Item: Row>>(
        self,
        items: Range<u32>,
        of: impl Fn(Range<u32>) -> I + Sync + 'a,
    ) -> Section<'a> {
        let len = if self == Self::Text { I::Item::TEXT_LEN } else { I::Item::BYTE_LEN };
        Section::of(items, len as u32, move |range, buffer| {
            let mut columns = I::Item::columns();
            of(range).for_each(|row| {
                row.put(self, &mut columns, buffer);
                self.end_line(buffer);
            });
        })
    }

    /// The same row for all of `count` items.
    pub(crate) fn repeated<'a>(self, count: u32, row: impl Row) -> Section<'a> {
        let mut item = Vec::new();
        self.put(row, &mut item);
        self.end_line(&mut item);
        Section::repeated(count, &item)
    }
}

/// A line of a text, or a record of bytes: arrays of numbers, one after another.
pub(crate) trait Row {
    /// About how long it is as text.
    const TEXT_LEN: usize;

    /// How long it is as bytes, with all that is optional.
    const BYTE_LEN: usize;

    /// The state that a table of text keeps from one row to the next.
    type Columns;

    /// The columns before the first row.
    fn columns() -> Self::Columns;

    fn put(self, numbers: Numbers, columns: &mut Self::Columns, buffer: &mut Vec<u8>);
}

impl<T: Number, const N: usize> Row for [T; N] {
    const TEXT_LEN: usize = N * T::TEXT_LEN;
    const BYTE_LEN: usize = N * size_of::<T>();

    type Columns = [T::Column; N];

    fn columns() -> Self::Columns {
        std::array::from_fn(|_| T::Column::default())
    }

    #[inline]
    fn put(self, numbers: Numbers, columns: &mut Self::Columns, buffer: &mut Vec<u8>) {
        if numbers != Numbers::Text {
            return T::put_bytes(self, numbers == Numbers::BigEndian, buffer);
        }
        for (column, number) in columns.iter_mut().zip(self) {
            let is_first = matches!(buffer.last(), None | Some(b'\n' | b' '));
            number.put_text(is_first, column, buffer);
        }
    }
}

/// A keyword that begins a line, or the blank before its first number.
impl Row for &'static str {
    const TEXT_LEN: usize = 4;
    const BYTE_LEN: usize = 0;

    type Columns = ();

    fn columns() {}

    fn put(self, _: Numbers, (): &mut (), buffer: &mut Vec<u8>) {
        buffer.extend_from_slice(self.as_bytes());
    }
}

/// Numbers that some files leave out.
impl<R: Row> Row for Option<R> {
    const TEXT_LEN: usize = R::TEXT_LEN;
    const BYTE_LEN: usize = R::BYTE_LEN;

    type Columns = R::Columns;

    fn columns() -> Self::Columns {
        R::columns()
    }

    #[inline]
    fn put(self, numbers: Numbers, columns: &mut Self::Columns, buffer: &mut Vec<u8>) {
        if let Some(row) = self {
            row.put(numbers, columns, buffer);
        }
    }
}

macro_rules! rows {
    ($(($($row:ident: $index:tt),*))*) => {$(
        impl<$($row: Row),*> Row for ($($row,)*) {
            const TEXT_LEN: usize = $($row::TEXT_LEN +)* 1;
            const BYTE_LEN: usize = $($row::BYTE_LEN +)* 0;

            type Columns = ($($row::Columns,)*);

            fn columns() -> Self::Columns {
                ($($row::columns(),)*)
            }

            #[inline]
            fn put(self, numbers: Numbers, columns: &mut Self::Columns, buffer: &mut Vec<u8>) {
                $(self.$index.put(numbers, &mut columns.$index, buffer);)*
            }
        }
    )*};
}

rows! {
    (A: 0, B: 1)
    (A: 0, B: 1, C: 2)
    (A: 0, B: 1, C: 2, D: 3)
}

/// A number that is written.
pub(crate) trait Number: Copy + Send + Sync {
    /// About how long it is as text, with what follows.
    const TEXT_LEN: usize;

    /// A column of a table as text: decimals keep the last one, which often comes again.
    type Column: Default;

    fn put_bytes<const N: usize>(numbers: [Self; N], is_big: bool, buffer: &mut Vec<u8>);

    /// With a blank before all but the first of a line.
    fn put_text(self, is_first: bool, column: &mut Self::Column, buffer: &mut Vec<u8>);
}

macro_rules! number {
    ($($kind:ty: $len:literal, $column:ty, $put_text:expr;)*) => {$(
        impl Number for $kind {
            const TEXT_LEN: usize = $len;

            type Column = $column;

            fn put_bytes<const N: usize>(numbers: [Self; N], is_big: bool, buffer: &mut Vec<u8>) {
                // Not a choice of functions, whose calls would not be inlined.
                let bytes = match is_big {
                    true => numbers.map(Self::to_be_bytes),
                    false => numbers.map(Self::to_le_bytes),
                };
                buffer.extend_from_slice(bytes.as_flattened());
            }

            fn put_text(self, is_first: bool, column: &mut $column, buffer: &mut Vec<u8>) {
                $put_text(self, is_first, column, buffer);
            }
        }
    )*};
}

number! {
    u8: 4, (), put_whole;
    i32: 8, (), put_whole;
    u16: 6, (), put_whole;
    u32: 10, (), put_whole;
    i64: 10, (), put_whole;
    u64: 11, (), put_whole;
    f32: 12, Decimals<f32>, put_decimal;
    f64: 18, Decimals<f64>, put_decimal;
}

fn put_whole(value: impl itoa::Integer, is_first: bool, (): &mut (), buffer: &mut Vec<u8>) {
    if !is_first {
        buffer.push(b' ');
    }
    push_digits(value, buffer);
}

fn put_decimal<F: zmij::Float + PartialEq>(
    value: F,
    is_first: bool,
    column: &mut Decimals<F>,
    buffer: &mut Vec<u8>,
) {
    if is_first { column.push_first(value, buffer) } else { column.push(value, buffer) }
}

/// A type of numbers in a binary file, and the bytes of each: 1, 2, 4 or 8.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scalar {
    Signed(usize),
    Unsigned(usize),
    Float(usize),
}

impl Scalar {
    /// The type with a name such as `int32`, for these words for signed, unsigned and float; `unit` is
    /// the number that stands for a byte.
    pub(crate) fn of_name(name: &str, words: [&str; 3], unit: usize) -> Option<Self> {
        let len = |word: &str| {
            let digits = name.strip_prefix(word)?;
            [1, 2, 4, 8].into_iter().find(|len| (len * unit).to_string() == digits)
        };
        let [signed, unsigned, float] = words;
        let float = || len(float).filter(|&len| len > 1).map(Self::Float);
        len(unsigned).map(Self::Unsigned).or(len(signed).map(Self::Signed)).or_else(float)
    }

    pub(crate) fn len(self) -> usize {
        let (Self::Signed(len) | Self::Unsigned(len) | Self::Float(len)) = self;
        len
    }

    pub(crate) fn is_whole(self) -> bool {
        !matches!(self, Self::Float(_))
    }

    /// The number that the bytes of an item are.
    pub(crate) fn float(self, item: &[u8], is_big: bool) -> f64 {
        let bits = bits(item, is_big);
        match self {
            Self::Float(8) => f64::from_bits(bits),
            Self::Float(4) => f32::from_bits(bits as u32).into(),
            Self::Float(_) => half(bits as u16),
            Self::Unsigned(_) => bits as f64,
            Self::Signed(len) => signed(bits, len) as f64,
        }
    }

    /// The whole number that the bytes of an item are, at most that of i64; `None` for floats.
    pub(crate) fn whole(self, item: &[u8], is_big: bool) -> Option<i64> {
        let bits = bits(item, is_big);
        match self {
            Self::Float(_) => None,
            // A number beyond the range of i64 is far beyond any count.
            Self::Unsigned(_) => Some(i64::try_from(bits).unwrap_or(i64::MAX)),
            Self::Signed(len) => Some(signed(bits, len)),
        }
    }
}

/// The bytes of an item as one number.
pub(crate) fn bits(item: &[u8], is_big: bool) -> u64 {
    let bits = match *item {
        [a] => a.into(),
        [a, b] => u16::from_le_bytes([a, b]).into(),
        [a, b, c, d] => u32::from_le_bytes([a, b, c, d]).into(),
        [a, b, c, d, e, f, g, h] => u64::from_le_bytes([a, b, c, d, e, f, g, h]),
        _ => return 0,
    };
    if is_big { bits.swap_bytes() >> (64 - 8 * item.len()) } else { bits }
}

fn signed(bits: u64, len: usize) -> i64 {
    let unused = 64 - 8 * len;
    ((bits << unused) as i64) >> unused
}

/// The distance from 1 to the next float of 16 bits.
pub(crate) const HALF_EPSILON: f64 = 1.0 / 1024.0;

/// A float of 16 bits: a sign, 5 bits of exponent, 10 of fraction.
fn half(bits: u16) -> f64 {
    let (exponent, fraction) = (i32::from(bits >> 10 & 0x1f), f64::from(bits & 0x3ff));
    let magnitude = match exponent {
        0 => fraction * HALF_EPSILON * libm::exp2(-14.0),
        31 if fraction == 0.0 => f64::INFINITY,
        31 => f64::NAN,
        _ => (1.0 + fraction * HALF_EPSILON) * libm::exp2(f64::from(exponent - 15)),
    };
    if bits >> 15 == 0 { magnitude } else { -magnitude }
}

/// A number that is read: f64, or i64 of whole numbers.
pub(crate) trait Value: FromStr {
    /// The kind of number, as messages name it.
    const KIND: &'static str;

    /// The value of the bytes of an item; none if it is not of this kind.
    fn of(scalar: Scalar, item: &[u8], is_big: bool) -> Option<Self>;
}

impl Value for f64 {
    const KIND: &'static str = "a number";

    fn of(scalar: Scalar, item: &[u8], is_big: bool) -> Option<Self> {
        Some(scalar.float(item, is_big))
    }
}

impl Value for i64 {
    const KIND: &'static str = "a whole number";

    fn of(scalar: Scalar, item: &[u8], is_big: bool) -> Option<Self> {
        scalar.whole(item, is_big)
    }
}

#[cfg(test)]
mod tests {
    use super::Scalar::{Float, Signed, Unsigned};
    use super::*;

    #[test]
    fn numbers_have_their_sign_and_their_order_of_bytes() {
        for (bytes, scalar, expected) in [
            (&[0xfe][..], Signed(1), -2),
            (&[0xfe, 0xff], Signed(2), -2),
            (&[0x01, 0x00, 0x00, 0x80], Signed(4), -0x7fff_ffff),
            (&[7, 0, 0, 0, 0, 0, 0, 0], Signed(8), 7),
            (&[0xfe, 0xff], Unsigned(2), 0xfffe),
        ] {
            let backward: Vec<u8> = bytes.iter().rev().copied().collect();
            assert_eq!(scalar.whole(bytes, false), Some(expected), "{scalar:?}");
            assert_eq!(scalar.whole(&backward, true), Some(expected), "{scalar:?}");
            assert_eq!(scalar.float(&backward, true), expected as f64, "{scalar:?}");
        }
        assert_eq!(Unsigned(8).whole(&[0xff; 8], false), Some(i64::MAX));
        assert_eq!(Unsigned(8).float(&[0xff; 8], false), u64::MAX as f64);
        for (bytes, len) in
            [(1.5_f64.to_be_bytes().to_vec(), 8), (1.5_f32.to_be_bytes().to_vec(), 4)]
        {
            assert_eq!(Float(len).float(&bytes, true), 1.5);
            assert_eq!(Float(len).whole(&bytes, true), None);
        }
    }

    #[test]
    fn halves_are_read() {
        let halves = [0x3c00_u16, 0xc100, 0x0001, 0x7bff, 0x7c00];
        let floats = halves.map(|half| Float(2).float(&half.to_le_bytes(), false));
        assert_eq!(floats, [1.0, -2.5, 1.0 / 16_777_216.0, 65504.0, f64::INFINITY]);
        assert!(Float(2).float(&[0, 0xfe], false).is_nan());
    }

    #[test]
    fn types_have_names() {
        let of = |name| Scalar::of_name(name, ["int", "uint", "float"], 8);
        assert_eq!(of("int16"), Some(Signed(2)));
        assert_eq!(of("uint8"), Some(Unsigned(1)));
        assert_eq!(of("float64"), Some(Float(8)));
        assert_eq!(Scalar::of_name("u4", ["i", "u", "f"], 1), Some(Unsigned(4)));
        for name in ["float8", "int", "int+8", "int08", "int128", "Int8", ""] {
            assert_eq!(of(name), None, "{name}");
        }
    }

    #[test]
    fn records_are_bytes_or_lines() {
        let write = |numbers: Numbers| {
            let mut buffer = Vec::new();
            numbers.put([1_u32, 2], &mut buffer);
            numbers.put([0.5], &mut buffer);
            numbers.end_line(&mut buffer);
            numbers.put([-3_i64], &mut buffer);
            buffer
        };
        assert_eq!(write(Numbers::Text), b"1 2 0.5\n-3");
        let bytes =
            [&[1, 0, 0, 0, 2, 0, 0, 0][..], &0.5_f64.to_le_bytes(), &(-3_i64).to_le_bytes()];
        assert_eq!(write(Numbers::LittleEndian), bytes.concat());
    }
}
