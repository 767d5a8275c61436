//! The zip archive around the arrays: stored entries, with lengths of 64 bits.
//!
//! The layout is PKWARE's APPNOTE 6.3: each entry has a head, its bytes, and after these their check
//! sum; a directory of all entries ends the file. The writer here streams and writes each length before its
//! array; the crate `zip` reads the directory.

use crate::ReadError;
use crate::unfold::unfold;
use std::borrow::Cow;
use std::io::{self, Cursor, Write};
use zip::{CompressionMethod, ZipArchive};

const LOCAL: u32 = 0x0403_4b50;
const DESCRIPTOR: u32 = 0x0807_4b50;
const CENTRAL: u32 = 0x0201_4b50;
const END: u32 = 0x0605_4b50;
const END_64: u32 = 0x0606_4b50;
const LOCATOR_64: u32 = 0x0706_4b50;

/// The version that knows lengths of 64 bits.
const VERSION: u16 = 45;
/// The check sum follows the bytes.
const FLAGS: u16 = 1 << 3;
/// 1 January 1980, the first day that there is: no clock reaches the file.
const DATE: u16 = (1 << 5) | 1;

/// An entry that has been written.
struct Entry {
    name: String,
    offset: u64,
    len: u64,
    check_sum: u32,
}

/// An archive that is written from front to back.
pub(super) struct Archive<W> {
    out: W,
    offset: u64,
    entries: Vec<Entry>,
}

/// The little-endian bytes of numbers, one after the other.
macro_rules! bytes {
    ($($number:expr),* $(,)?) => {{
        let mut bytes: Vec<u8> = Vec::new();
        $(bytes.extend_from_slice(&$number.to_le_bytes());)*
        bytes
    }};
}

impl<W: Write + Send> Archive<W> {
    pub(super) fn new(out: W) -> Self {
        Self { out, offset: 0, entries: Vec::new() }
    }

    /// Writes an entry of `len` bytes, which `write` writes.
    pub(super) fn entry(
        &mut self,
        name: &str,
        len: u64,
        write: impl FnOnce(&mut Checked<'_, W>) -> io::Result<()>,
    ) -> io::Result<()> {
        let offset = self.offset;
        let mut head = bytes!(LOCAL, VERSION, FLAGS, 0_u16, 0_u16, DATE, 0_u32);
        head.extend(bytes!(u32::MAX, u32::MAX, name.len() as u16, 20_u16));
        head.extend_from_slice(name.as_bytes());
        head.extend(bytes!(1_u16, 16_u16, len, len));
        self.put(&head)?;
        let mut checked =
            Checked { out: &mut self.out, len: 0, check_sum: crc32fast::Hasher::new() };
        write(&mut checked)?;
        let Checked { len: written, check_sum, .. } = checked;
        debug_assert_eq!(written, len, "{name} is as long as was said");
        self.offset += written;
        let check_sum = check_sum.finalize();
        self.put(&bytes!(DESCRIPTOR, check_sum, len, len))?;
        self.entries.push(Entry { name: name.to_owned(), offset, len, check_sum });
        Ok(())
    }

    /// Writes the directory.
    pub(super) fn finish(mut self) -> io::Result<()> {
        let start = self.offset;
        let count = self.entries.len() as u64;
        for Entry { name, offset, len, check_sum } in std::mem::take(&mut self.entries) {
            let mut entry = bytes!(CENTRAL, VERSION, VERSION, FLAGS, 0_u16, 0_u16, DATE);
            entry.extend(bytes!(check_sum, u32::MAX, u32::MAX, name.len() as u16, 28_u16));
            entry.extend(bytes!(0_u16, 0_u16, 0_u16, 0_u32, u32::MAX));
            entry.extend_from_slice(name.as_bytes());
            entry.extend(bytes!(1_u16, 24_u16, len, len, offset));
            self.put(&entry)?;
        }
        let end = self.offset;
        let mut ends = bytes!(END_64, 44_u64, VERSION, VERSION, 0_u32, 0_u32);
        ends.extend(bytes!(count, count, end - start, start));
        ends.extend(bytes!(LOCATOR_64, 0_u32, end, 1_u32));
        ends.extend(bytes!(END, 0_u16, 0_u16, count as u16, count as u16));
        ends.extend(bytes!(u32::MAX, u32::MAX, 0_u16));
        self.put(&ends)?;
        self.out.flush()
    }

    fn put(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.offset += bytes.len() as u64;
        self.out.write_all(bytes)
    }
}

/// Counts the bytes of an entry, and sums them up.
pub(super) struct Checked<'a, W> {
    out: &'a mut W,
    len: u64,
    check_sum: crc32fast::Hasher,
}

impl<W: Write + Send> Write for Checked<'_, W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.out.write(bytes)?;
        self.check_sum.update(&bytes[..written]);
        self.len += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// The bytes of an entry, and where they begin in the file.
pub(super) type Found<'a> = (usize, Cow<'a, [u8]>);

/// The archive that a file is.
pub(super) fn archive(file: &[u8]) -> Result<ZipArchive<Cursor<&[u8]>>, ReadError> {
    // Each end would have the directory read once more: the last has a comment of 64 KiB at most behind it.
    let tail = &file[file.len().saturating_sub(22 + usize::from(u16::MAX))..];
    if memchr::memmem::find_iter(tail, &END.to_le_bytes()).count() > 1 {
        return Err(ReadError::byte(file.len(), "the zip directory ends twice"));
    }
    ZipArchive::new(Cursor::new(file)).map_err(|_| {
        ReadError::byte(file.len(), "the file has no zip directory; it may have been cut off")
    })
}

/// The entry of a name; `None` if the archive has no such entry.
pub(super) fn entry<'a>(
    file: &'a [u8],
    archive: &mut ZipArchive<Cursor<&[u8]>>,
    name: &str,
) -> Result<Option<Found<'a>>, ReadError> {
    let Some(index) = archive.index_for_name(name) else { return Ok(None) };
    let entry = archive.by_index_raw(index);
    let entry = entry.map_err(|error| ReadError::place(name, error.to_string()))?;
    let problem =
        |problem: &str| ReadError::byte(entry.header_start(), format!("{name}: {problem}"));
    if entry.encrypted() {
        return Err(problem("the array is encrypted"));
    }
    let start =
        entry.data_start().and_then(|start| usize::try_from(start).ok()).unwrap_or(file.len());
    let len = usize::try_from(entry.compressed_size()).ok();
    let stored = file.get(start..).zip(len).and_then(|(rest, len)| rest.get(..len));
    let stored = stored.ok_or_else(|| problem("the file ends within the array"))?;
    let bytes = match entry.compression() {
        CompressionMethod::STORE => Cow::Borrowed(stored),
        CompressionMethod::DEFLATE => {
            let mut unfolded = Vec::new();
            if !unfold(stored, false, entry.size(), &mut unfolded)? {
                return Err(problem("the compressed array is damaged"));
            }
            Cow::Owned(unfolded)
        }
        method => {
            return Err(problem(&format!(
                "the array is compressed by {method}; only arrays that are stored or deflated are read"
            )));
        }
    };
    if bytes.len() as u64 != entry.size() {
        return Err(problem("the array is not as long as the archive says"));
    }
    if crc32fast::hash(&bytes) != entry.crc32() {
        return Err(problem("the check sum is wrong; the file is damaged"));
    }
    Ok(Some((start, bytes)))
}
