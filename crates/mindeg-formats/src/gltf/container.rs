//! The bytes of a file: the document, the binary beside it, and the files that it names.

use super::schema::{Buffer, Document};
use crate::ReadError;
use base64::engine::general_purpose::STANDARD;
use base64::{DecodeSliceError, Engine};
use std::borrow::Cow;
use std::io::{self, ErrorKind};

/// The two parts of a `.glb`; of a `.gltf` the only one.
pub(super) struct Container<'a> {
    pub(super) json: &'a [u8],
    pub(super) binary: Option<&'a [u8]>,
}

impl<'a> Container<'a> {
    pub(super) fn split(file: &'a [u8]) -> Result<Self, ReadError> {
        let Some(after_magic) = file.strip_prefix(b"glTF") else {
            return Ok(Self { json: file, binary: None });
        };
        let problem = |problem: &str| ReadError::place("the .glb header", problem);
        let (version, rest) =
            number(after_magic).ok_or_else(|| problem("the file ends before its header does"))?;
        let (len, _) =
            number(rest).ok_or_else(|| problem("the file ends before its header does"))?;
        if version != 2 {
            return Err(problem(&format!("the version is {version}; only 2 is read")));
        }
        let Some(chunks) = file.get(12..len as usize) else {
            let found = file.len();
            return Err(problem(&format!("the file should be {len} bytes long, and is {found}")));
        };
        let (json, rest) = chunk(chunks, "JSON")?;
        // Chunks of other kinds are passed over.
        let mut rest = rest;
        while rest.get(4..8).is_some_and(|kind| kind != b"BIN\0") {
            let (_, after) = chunk_of_any_kind(rest).ok_or_else(|| ends_early("next"))?;
            rest = after;
        }
        let binary = if rest.len() < 8 { None } else { Some(chunk(rest, "BIN\0")?.0) };
        Ok(Self { json, binary })
    }
}

fn number(bytes: &[u8]) -> Option<(u32, &[u8])> {
    let (number, rest) = bytes.split_first_chunk()?;
    Some((u32::from_le_bytes(*number), rest))
}

/// The data of the first chunk, and what follows it.
fn chunk_of_any_kind(chunks: &[u8]) -> Option<(&[u8], &[u8])> {
    let (len, rest) = number(chunks)?;
    rest.get(4..)?.split_at_checked(len as usize)
}

fn chunk<'a>(chunks: &'a [u8], kind: &str) -> Result<(&'a [u8], &'a [u8]), ReadError> {
    let name = kind.trim_end_matches('\0');
    if chunks.get(4..8) != Some(kind.as_bytes()) {
        let problem = format!("the first chunk must be {name}");
        return Err(ReadError::place("the .glb container", problem));
    }
    chunk_of_any_kind(chunks).ok_or_else(|| ends_early(name))
}

fn ends_early(chunk: &str) -> ReadError {
    ReadError::place("the .glb container", format!("the file ends before its {chunk} chunk does"))
}

/// The bytes of each buffer of a document, as many as it says; none for a buffer without data.
pub(super) type Buffers<'a> = [Option<Cow<'a, [u8]>>];

/// Finds the bytes of each buffer.
pub(super) fn buffers<'a>(
    document: &Document<'_>,
    binary: Option<&'a [u8]>,
    mut resolve: impl FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<Vec<Option<Cow<'a, [u8]>>>, ReadError> {
    let mut buffers = Vec::new();
    for (index, Buffer { byte_length, uri }) in document.buffers.iter().enumerate() {
        let place = || format!("buffers[{index}]");
        let bytes = match uri {
            Some(uri) => Some(Cow::Owned(load(&uri.0, place, &mut resolve)?)),
            // The binary is the first buffer.
            None => binary.filter(|_| index == 0).map(Cow::Borrowed),
        };
        let (expected, found) = (byte_length.0, bytes.as_ref().map(|bytes| bytes.len()));
        if let Some(found) = found
            && (found as u64) < expected
        {
            let problem = format!("is {expected} bytes long, of which {found} are there");
            return Err(ReadError::place(place(), problem));
        }
        buffers.push(bytes.map(|bytes| {
            let len = usize::try_from(expected).expect("no buffer is longer than what was found");
            match bytes {
                Cow::Borrowed(bytes) => Cow::Borrowed(&bytes[..len]),
                Cow::Owned(mut bytes) => {
                    bytes.truncate(len);
                    Cow::Owned(bytes)
                }
            }
        }));
    }
    Ok(buffers)
}

/// The bytes behind a URI: in it, or in a file.
fn load(
    uri: &str,
    place: impl Fn() -> String,
    resolve: &mut impl FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<Vec<u8>, ReadError> {
    if let Some(data) = uri.strip_prefix("data:") {
        let problem = |problem: String| ReadError::place(format!("{}.uri", place()), problem);
        let (_, data) = data.split_once(";base64,").ok_or_else(|| {
            problem("is data that is not in base64; only base64 is read".to_owned())
        })?;
        let mut bytes = Vec::new();
        let len = base64::decoded_len_estimate(data.len());
        bytes.try_reserve_exact(len)?;
        bytes.resize(len, 0);
        let decoded = STANDARD.decode_slice(data, &mut bytes);
        bytes.truncate(decoded.map_err(|error| match error {
            DecodeSliceError::DecodeError(error) => problem(format!("is not base64: {error}")),
            error => problem(format!("is not base64: {error}")),
        })?);
        return Ok(bytes);
    }
    let name = percent_encoding::percent_decode_str(uri).decode_utf8_lossy();
    let refused = |problem: &str| Err(io::Error::new(ErrorKind::InvalidInput, problem));
    let bytes = if name.is_empty() {
        refused("the name is empty; it must be that of a file beside the .gltf")
    } else if has_scheme(uri) {
        refused("only files beside the .gltf are read")
    } else {
        resolve(&name)
    };
    bytes.map_err(|source| ReadError::External { uri: name.into_owned(), source })
}

/// Whether a URI starts with a scheme such as `http:` or `file:`.
fn has_scheme(uri: &str) -> bool {
    uri.split_once(':').is_some_and(|(scheme, _)| {
        let is_part = |c: char| c.is_ascii_alphanumeric() || "+-.".contains(c);
        scheme.starts_with(|c: char| c.is_ascii_alphabetic()) && scheme.chars().all(is_part)
    })
}
