//! The numbers of a `DataArray`, however they are stored.

use base64::Engine;
use base64::engine::DecodePaddingMode;
use base64::engine::general_purpose::{GeneralPurpose, GeneralPurposeConfig};

use std::collections::TryReserveError;

use super::xml::Tag;
use crate::ReadError;
use crate::unfold::{UnfoldError, unfold};
use crate::words::{number, words};

/// Padding is as writers have it.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &base64::alphabet::STANDARD,
    GeneralPurposeConfig::new()
        .with_decode_padding_mode(DecodePaddingMode::Indifferent)
        .with_decode_allow_trailing_bits(true),
);

/// How the numbers of a file are stored.
#[derive(Clone, Copy, Debug)]
pub(super) struct Storage<'a> {
    pub(super) file: &'a [u8],
    pub(super) is_big: bool,
    /// The length of a length in bytes, 4 or 8.
    pub(super) length_len: usize,
    pub(super) is_compressed: bool,
    /// Where the appended numbers begin, and whether they are base64.
    pub(super) appended: Option<(usize, bool)>,
}

/// The type of an array's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Signed(usize),
    Unsigned(usize),
    Float(usize),
}

impl Kind {
    fn of(name: &str) -> Option<Self> {
        let bytes = |bits: &str| match bits {
            "8" => Some(1),
            "16" => Some(2),
            "32" => Some(4),
            "64" => Some(8),
            _ => None,
        };
        if let Some(bits) = name.strip_prefix("UInt") {
            return bytes(bits).map(Self::Unsigned);
        }
        if let Some(bits) = name.strip_prefix("Int") {
            return bytes(bits).map(Self::Signed);
        }
        let len = name.strip_prefix("Float").and_then(bytes)?;
        (len >= 4).then_some(Self::Float(len))
    }

    fn len(self) -> usize {
        match self {
            Self::Signed(len) | Self::Unsigned(len) | Self::Float(len) => len,
        }
    }
}

/// Why an array has no bytes.
enum Problem {
    /// An error of this array.
    Fault(String),
    /// There is too little memory.
    Memory(TryReserveError),
}

impl From<String> for Problem {
    fn from(words: String) -> Self {
        Self::Fault(words)
    }
}

impl From<&str> for Problem {
    fn from(words: &str) -> Self {
        Self::Fault(words.to_owned())
    }
}

/// The values of an array.
pub(super) trait Value: Sized + std::str::FromStr {
    fn of_integer(value: i64) -> Self;
    fn of_float(value: f64) -> Option<Self>;
}

impl Value for f64 {
    fn of_integer(value: i64) -> Self {
        value as Self
    }

    fn of_float(value: f64) -> Option<Self> {
        Some(value)
    }
}

impl Value for i64 {
    fn of_integer(value: i64) -> Self {
        value
    }

    fn of_float(_: f64) -> Option<Self> {
        None
    }
}

/// The values of the array that begins with a tag.
pub(super) fn values<T: Value>(storage: &Storage<'_>, tag: &Tag<'_>) -> Result<Vec<T>, ReadError> {
    let problem = |problem: String| {
        let name = tag.attribute("Name").unwrap_or("without a name");
        ReadError::byte(tag.start, format!("the array {name}: {problem}"))
    };
    let kind = tag.attribute("type").unwrap_or_default();
    let kind = Kind::of(kind)
        .ok_or_else(|| problem(format!("its type {kind:?} is not a number's such as Float64")))?;
    let format = tag.attribute("format").unwrap_or("ascii");
    let bytes = match format {
        "ascii" => {
            let mut list = Vec::new();
            for word in words(inline(storage, tag)) {
                let value = number(word).ok_or_else(|| {
                    let word = String::from_utf8_lossy(&word[..word.len().min(40)]);
                    problem(format!("{word:?} is not a number of its type"))
                })?;
                crate::lists::push(&mut list, value)?;
            }
            return Ok(list);
        }
        "binary" => storage.block(inline(storage, tag).trim_ascii_start(), true),
        "appended" => {
            let (start, is_base64) =
                storage.appended.ok_or_else(|| problem("the file has no AppendedData".into()))?;
            let offset = tag.attribute("offset").and_then(|offset| offset.trim().parse().ok());
            let offset: usize =
                offset.ok_or_else(|| problem("it has no offset into AppendedData".into()))?;
            let place = start.checked_add(offset).and_then(|start| storage.file.get(start..));
            let place = place
                .ok_or_else(|| problem(format!("its offset {offset} is beyond the file's end")))?;
            storage.block(place, is_base64)
        }
        _ => {
            let words = format!("its format is {format:?}, not ascii, binary or appended");
            return Err(problem(words));
        }
    };
    let bytes = bytes.map_err(|found| match found {
        Problem::Fault(words) => problem(words),
        Problem::Memory(error) => error.into(),
    })?;
    let mut list = Vec::new();
    list.try_reserve_exact(bytes.len() / kind.len())?;
    for item in bytes.chunks_exact(kind.len()) {
        let value = value_of(item, kind, storage.is_big);
        list.push(value.ok_or_else(|| problem("its numbers must be whole".into()))?);
    }
    Ok(list)
}

/// The text between a tag and the next.
fn inline<'a>(storage: &Storage<'a>, tag: &Tag<'_>) -> &'a [u8] {
    if tag.is_empty {
        return &[];
    }
    let rest = &storage.file[tag.end..];
    &rest[..memchr::memchr(b'<', rest).unwrap_or(rest.len())]
}

fn value_of<T: Value>(item: &[u8], kind: Kind, is_big: bool) -> Option<T> {
    // The bytes from the least on.
    let mut least_first = [0; 8];
    for (index, byte) in least_first.iter_mut().take(item.len()).enumerate() {
        *byte = item[if is_big { item.len() - 1 - index } else { index }];
    }
    let bits = u64::from_le_bytes(least_first);
    match kind {
        Kind::Float(4) => T::of_float(f32::from_bits(bits as u32).into()),
        Kind::Float(_) => T::of_float(f64::from_bits(bits)),
        // One beyond the range of i64 is far beyond any count.
        Kind::Unsigned(_) => Some(T::of_integer(i64::try_from(bits).unwrap_or(i64::MAX))),
        Kind::Signed(len) => {
            let unused = 64 - 8 * len as u32;
            Some(T::of_integer(((bits << unused) as i64) >> unused))
        }
    }
}

impl Storage<'_> {
    /// The bytes of the array that begins here, without what tells their length.
    fn block(&self, place: &[u8], is_base64: bool) -> Result<Vec<u8>, Problem> {
        let mut source = Source { place, is_base64 };
        let word = self.length_len;
        if !self.is_compressed {
            let head = source.peek(word)?;
            let len = self.length(&head);
            // Some writers end the base64 of the length by itself.
            let is_apart = is_base64 && place.get(chars(word) - 1) == Some(&b'=');
            if is_apart || !is_base64 {
                source.skip(word)?;
                return Ok(source.take(len)?);
            }
            let len = len.checked_add(word as u64).ok_or("its length is beyond any file's")?;
            let mut bytes = source.take(len)?;
            bytes.drain(..word);
            return Ok(bytes);
        }
        // The number of blocks, the length of all but the last, that of the last unless it is 0,
        // and what each block takes.
        let blocks = self.length(&source.peek(word)?);
        let head_len = (blocks.saturating_add(3)).saturating_mul(word as u64);
        let head = source.take(head_len)?;
        let lengths: Vec<u64> = head.chunks_exact(word).map(|item| self.length(item)).collect();
        let [_, full, last, compressed @ ..] = &lengths[..] else {
            return Err("its list of compressed blocks is too short".into());
        };
        let all = compressed.iter().try_fold(0_u64, |sum, &len| sum.checked_add(len));
        let data = source.take(all.ok_or("its blocks are longer than any file")?)?;
        let mut rest = &data[..];
        let mut bytes = Vec::new();
        for (index, &len) in compressed.iter().enumerate() {
            // The sum of all is the length of the data.
            let (block, others) = rest.split_at(len as usize);
            rest = others;
            let is_last = index + 1 == compressed.len();
            let expected = if is_last && *last > 0 { *last } else { *full };
            unfold(block, true, expected, &mut bytes).map_err(|error| match error {
                UnfoldError::Memory(error) => Problem::Memory(error),
                UnfoldError::Damaged => format!("block {index} of its zlib data is broken").into(),
            })?;
        }
        Ok(bytes)
    }

    fn length(&self, bytes: &[u8]) -> u64 {
        let kind = Kind::Unsigned(self.length_len);
        value_of::<i64>(bytes, kind, self.is_big).map_or(0, i64::unsigned_abs)
    }
}

/// The number of base64 characters for a number of bytes.
fn chars(bytes: usize) -> usize {
    bytes.div_ceil(3) * 4
}

/// Bytes as they are, or as base64.
struct Source<'a> {
    place: &'a [u8],
    is_base64: bool,
}

impl Source<'_> {
    /// The next bytes, which stay the next.
    fn peek(&mut self, len: usize) -> Result<Vec<u8>, String> {
        let place = self.place;
        let bytes = self.take(len as u64);
        self.place = place;
        bytes
    }

    fn skip(&mut self, len: usize) -> Result<(), String> {
        self.take(len as u64).map(drop)
    }

    /// The next bytes. Base64 ends with them.
    fn take(&mut self, len: u64) -> Result<Vec<u8>, String> {
        let too_long = || {
            let left = self.place.len();
            format!("it should have {len} bytes; the file goes on for {left} bytes")
        };
        let len = usize::try_from(len).map_err(|_| too_long())?;
        let stored = if self.is_base64 {
            len.checked_next_multiple_of(3).and_then(|len| (len / 3).checked_mul(4))
        } else {
            Some(len)
        };
        let place = self.place;
        let stored = stored.and_then(|stored| place.get(..stored)).ok_or_else(too_long)?;
        self.place = &place[stored.len()..];
        if !self.is_base64 {
            return Ok(stored.to_vec());
        }
        let mut bytes = BASE64.decode(stored).map_err(|error| format!("its base64: {error}"))?;
        if bytes.len() < len {
            return Err("its base64 ends too early".into());
        }
        bytes.truncate(len);
        Ok(bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_their_sign_and_their_order_of_bytes() {
        for (bytes, kind, expected) in [
            (&[0xfe][..], Kind::Signed(1), -2),
            (&[0xfe, 0xff], Kind::Signed(2), -2),
            (&[0x01, 0x00, 0x00, 0x80], Kind::Signed(4), -0x7fff_ffff),
            (&[7, 0, 0, 0, 0, 0, 0, 0], Kind::Signed(8), 7),
            (&[0xfe, 0xff], Kind::Unsigned(2), 0xfffe),
            (&[0xff; 8], Kind::Unsigned(8), i64::MAX),
        ] {
            let backward: Vec<u8> = bytes.iter().rev().copied().collect();
            assert_eq!(value_of::<i64>(bytes, kind, false), Some(expected), "{kind:?}");
            assert_eq!(value_of::<i64>(&backward, kind, true), Some(expected), "{kind:?}");
            assert_eq!(value_of::<f64>(bytes, kind, false), Some(expected as f64), "{kind:?}");
        }
        for (bytes, kind) in
            [(1.5_f64.to_le_bytes().to_vec(), 8), (1.5_f32.to_le_bytes().to_vec(), 4)]
        {
            assert_eq!(value_of::<f64>(&bytes, Kind::Float(kind), false), Some(1.5));
            assert_eq!(value_of::<i64>(&bytes, Kind::Float(kind), false), None);
        }
    }
}
