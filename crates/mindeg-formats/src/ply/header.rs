//! The header of a PLY: what the rows after it hold.

use crate::ReadError;
use crate::numbers::{Numbers, Scalar};
use crate::records::Words;
use std::io::{BufRead, Read};

/// The longest header that is read, in bytes.
const LONGEST: u64 = 1 << 24;

/// The type of numbers with a name.
fn scalar_of(name: &[u8]) -> Option<Scalar> {
    Some(match name {
        b"char" => Scalar::Signed(1),
        b"uchar" => Scalar::Unsigned(1),
        b"short" => Scalar::Signed(2),
        b"ushort" => Scalar::Unsigned(2),
        b"int" => Scalar::Signed(4),
        b"uint" => Scalar::Unsigned(4),
        b"float" => Scalar::Float(4),
        b"double" => Scalar::Float(8),
        name => {
            let name = std::str::from_utf8(name).ok()?;
            return Scalar::of_name(name, ["int", "uint", "float"], 8);
        }
    })
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
    pub(super) encoding: Numbers,
    pub(super) elements: Vec<Element>,
    pub(super) lines: u64,
    pub(super) bytes: u64,
}

impl Header {
    pub(super) fn read(input: &mut impl BufRead) -> Result<Self, ReadError> {
        let mut input = input.take(LONGEST);
        let mut header = Self { encoding: Numbers::Text, elements: Vec::new(), lines: 0, bytes: 0 };
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

    /// The number of rows of an element; 0 without the element.
    pub(super) fn count(&self, name: &str) -> u64 {
        self.elements.iter().find(|element| element.name == name).map_or(0, |found| found.count)
    }
}

fn encoding_of(mut words: Words<'_>) -> Result<Numbers, ReadError> {
    match words.word() {
        Some(b"ascii") => Ok(Numbers::Text),
        Some(b"binary_little_endian") => Ok(Numbers::LittleEndian),
        Some(b"binary_big_endian") => Ok(Numbers::BigEndian),
        _ => {
            let problem = "the format must be ascii, binary_little_endian or binary_big_endian";
            Err(words.problem(problem))
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
        scalar_of(word).ok_or_else(|| {
            let word = String::from_utf8_lossy(word);
            line.problem(format!("the property has the unknown type {word:?}"))
        })
    };
    let (list, scalar) = match words.word() {
        Some(b"list") => {
            let list = scalar(&mut words, None)?;
            if !list.is_whole() {
                return Err(line.problem("the length of a list is a whole number"));
            }
            (Some(list), scalar(&mut words, None)?)
        }
        word => (None, scalar(&mut words, Some(word.unwrap_or_default()))?),
    };
    let name = words.word().ok_or_else(|| line.problem("the property has no name"))?;
    Ok(Property { name: String::from_utf8_lossy(name).into_owned(), list, scalar })
}
