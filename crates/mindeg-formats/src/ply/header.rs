//! The header of a PLY: what the rows after it hold.

use crate::ReadError;
use crate::records::Words;
use std::io::{BufRead, Read};

/// The longest header that is read, in bytes.
const LONGEST: u64 = 1 << 24;

/// How numbers are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Ascii,
    LittleEndian,
    BigEndian,
}

/// A type of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn of_name(name: &[u8]) -> Option<Self> {
        Some(match name {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }

    pub(super) fn len(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// The number that the first bytes are, the least significant first.
    pub(super) fn value(self, bytes: [u8; 8]) -> f64 {
        let [a, b, c, d, ..] = bytes;
        match self {
            Self::I8 => i8::from_le_bytes([a]).into(),
            Self::U8 => a.into(),
            Self::I16 => i16::from_le_bytes([a, b]).into(),
            Self::U16 => u16::from_le_bytes([a, b]).into(),
            Self::I32 => i32::from_le_bytes([a, b, c, d]).into(),
            Self::U32 => u32::from_le_bytes([a, b, c, d]).into(),
            Self::F32 => f32::from_le_bytes([a, b, c, d]).into(),
            Self::F64 => f64::from_le_bytes(bytes),
        }
    }
}

/// A property of the rows of an element.
pub(super) struct Property {
    pub(super) name: String,
    /// The type of the length, if it is a list.
    pub(super) list: Option<Scalar>,
    pub(super) scalar: Scalar,
}

/// Rows of one kind.
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
}

/// The header and its length.
pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
    pub(super) lines: u64,
    pub(super) bytes: u64,
}

impl Header {
    pub(super) fn read(input: &mut impl BufRead) -> Result<Self, ReadError> {
        let mut input = input.take(LONGEST);
        let mut header =
            Self { encoding: Encoding::Ascii, elements: Vec::new(), lines: 0, bytes: 0 };
        let mut encoding = None;
        let mut text = Vec::new();
        loop {
            text.clear();
            let len = input.read_until(b'\n', &mut text)?;
            header.bytes += len as u64;
            header.lines += 1;
            let mut words = Words { rest: &text, line: header.lines };
            if text.last() != Some(&b'\n') {
                return Err(words.problem("the header of the PLY has no end_header"));
            }
            let keyword = words.word();
            if header.lines == 1 && keyword != Some(b"ply") {
                return Err(words.problem("a PLY starts with \"ply\""));
            }
            match keyword {
                Some(b"format") => encoding = Some(encoding_of(words)?),
                Some(b"element") => header.elements.push(element(words)?),
                Some(b"property") => {
                    let property = property(words)?;
                    let element = header.elements.last_mut();
                    let element = element
                        .ok_or_else(|| words.problem("the property belongs to no element"))?;
                    element.properties.push(property);
                }
                Some(b"end_header") => {
                    header.encoding =
                        encoding.ok_or_else(|| words.problem("the header has no format"))?;
                    return Ok(header);
                }
                _ => {}
            }
        }
    }

    /// How many rows the element has; 0 if there is none.
    pub(super) fn count(&self, name: &str) -> u64 {
        self.elements.iter().find(|element| element.name == name).map_or(0, |found| found.count)
    }
}

fn encoding_of(mut words: Words<'_>) -> Result<Encoding, ReadError> {
    match words.word() {
        Some(b"ascii") => Ok(Encoding::Ascii),
        Some(b"binary_little_endian") => Ok(Encoding::LittleEndian),
        Some(b"binary_big_endian") => Ok(Encoding::BigEndian),
        _ => {
            Err(words
                .problem("the format must be ascii, binary_little_endian or binary_big_endian"))
        }
    }
}

fn element(mut words: Words<'_>) -> Result<Element, ReadError> {
    let name = words.word().unwrap_or_default();
    let name = String::from_utf8_lossy(name).into_owned();
    let count = words.count("the number of rows")?;
    Ok(Element { name, count, properties: Vec::new() })
}

fn property(mut words: Words<'_>) -> Result<Property, ReadError> {
    let line = words;
    let scalar = |words: &mut Words<'_>, word: Option<&[u8]>| {
        let word = word.or_else(|| words.word()).unwrap_or_default();
        Scalar::of_name(word).ok_or_else(|| {
            let word = String::from_utf8_lossy(word);
            line.problem(format!("the property has the unknown type {word:?}"))
        })
    };
    let (list, scalar) = match words.word() {
        Some(b"list") => {
            let list = scalar(&mut words, None)?;
            if matches!(list, Scalar::F32 | Scalar::F64) {
                return Err(line.problem("the length of a list is a whole number"));
            }
            (Some(list), scalar(&mut words, None)?)
        }
        word => (None, scalar(&mut words, Some(word.unwrap_or_default()))?),
    };
    let name = words.word().ok_or_else(|| line.problem("the property has no name"))?;
    Ok(Property { name: String::from_utf8_lossy(name).into_owned(), list, scalar })
}
