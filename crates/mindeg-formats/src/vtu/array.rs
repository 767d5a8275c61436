//! The numbers of a `DataArray`, however they are stored.

use base64::Engine;
use base64::engine::DecodePaddingMode;
use base64::engine::general_purpose::{GeneralPurpose, GeneralPurposeConfig};

use super::xml::Tag;
use crate::ReadError;
use crate::numbers::{Scalar, Value, bits};
use crate::unfold::unfold;
use crate::words::{number, words};

/// Writers differ in padding: all forms are read.
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

fn fault(problem: impl Into<String>) -> ReadError {
    ReadError::place("", problem)
}

/// The values of the array that begins with a tag.
pub(super) fn values<T: Value>(storage: &Storage<'_>, tag: &Tag<'_>) -> Result<Vec<T>, ReadError> {
    let problem = |problem: String| {
        let name = tag.attribute("Name").unwrap_or("without a name");
        ReadError::byte(tag.start, format!("the array {name}: {problem}"))
    };
    let kind = tag.attribute("type").unwrap_or_default();
    let kind = Scalar::of_name(kind, ["Int", "UInt", "Float"], 8)
        .ok_or_else(|| problem(format!("its type {kind:?} is not a number's such as Float64")))?;
    let bytes = match tag.attribute("format").unwrap_or("ascii") {
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
        other => Err(fault(format!("its format is {other:?}, not ascii, binary or appended"))),
    };
    let bytes = bytes.map_err(|error| error.or_at(problem))?;
    let mut list = Vec::new();
    list.try_reserve_exact(bytes.len() / kind.len())?;
    for item in bytes.chunks_exact(kind.len()) {
        let value = T::of(kind, item, storage.is_big);
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

impl Storage<'_> {
    /// The bytes of the array that begins here, without what tells their length.
    fn block(&self, place: &[u8], is_base64: bool) -> Result<Vec<u8>, ReadError> {
        let mut source = Source { place, is_base64 };
        let word = self.length_len;
        if !self.is_compressed {
            let len = self.length(&{ source }.take(word as u64)?);
            // Some writers end the base64 of the length by itself.
            let is_apart = is_base64 && place.get(chars(word) - 1) == Some(&b'=');
            if is_apart || !is_base64 {
                source.take(word as u64)?;
                return source.take(len);
            }
            let len = len.checked_add(word as u64);
            let len = len.ok_or_else(|| fault("its length is beyond any file's"))?;
            let mut bytes = source.take(len)?;
            bytes.drain(..word);
            return Ok(bytes);
        }
        // The number of blocks, the length of all but the last, that of the last unless it is 0,
        // and what each block takes.
        let blocks = self.length(&{ source }.take(word as u64)?);
        let head_len = (blocks.saturating_add(3)).saturating_mul(word as u64);
        let head = source.take(head_len)?;
        let lengths: Vec<u64> = head.chunks_exact(word).map(|item| self.length(item)).collect();
        let [_, full, last, compressed @ ..] = &lengths[..] else {
            return Err(fault("its list of compressed blocks is too short"));
        };
        let all = compressed.iter().try_fold(0_u64, |sum, &len| sum.checked_add(len));
        let all = all.ok_or_else(|| fault("its blocks are longer than any file"))?;
        let data = source.take(all)?;
        let mut rest = &data[..];
        let mut bytes = Vec::new();
        for (index, &len) in compressed.iter().enumerate() {
            let len = usize::try_from(len).expect("the sum of all is the length of the data");
            let (block, others) = rest.split_at(len);
            rest = others;
            let is_last = index + 1 == compressed.len();
            let expected = if is_last && *last > 0 { *last } else { *full };
            if !unfold(block, true, expected, &mut bytes)? {
                return Err(fault(format!("block {index} of its zlib data is broken")));
            }
        }
        Ok(bytes)
    }

    fn length(&self, bytes: &[u8]) -> u64 {
        bits(bytes, self.is_big)
    }
}

/// The number of base64 characters for a number of bytes.
fn chars(bytes: usize) -> usize {
    bytes.div_ceil(3) * 4
}

/// Bytes as they are, or as base64.
#[derive(Clone, Copy)]
struct Source<'a> {
    place: &'a [u8],
    is_base64: bool,
}

impl Source<'_> {
    /// The next bytes. Base64 ends with them.
    fn take(&mut self, len: u64) -> Result<Vec<u8>, ReadError> {
        let too_long = || {
            let left = self.place.len();
            fault(format!("it should have {len} bytes; the file goes on for {left} bytes"))
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
        let bytes = BASE64.decode(stored);
        let mut bytes = bytes.map_err(|error| fault(format!("its base64: {error}")))?;
        if bytes.len() < len {
            return Err(fault("its base64 ends too early"));
        }
        bytes.truncate(len);
        Ok(bytes)
    }
}
