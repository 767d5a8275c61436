//! The zip archive around the arrays: stored entries, with lengths of 64 bits.
//!
//! The layout is PKWARE's APPNOTE 6.3: each entry has a head, its bytes, and after these their check
//! sum; a directory of all entries ends the file.

use crate::ReadError;
use crate::unfold::unfold;
use std::borrow::Cow;
use std::io::{self, Write};

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

/// An entry of a file that is read.
pub(super) struct Stored<'a> {
    pub(super) name: String,
    /// The offset of its head.
    pub(super) offset: usize,
    method: u16,
    is_encrypted: bool,
    /// How many bytes it takes in the file, and how many it has.
    stored_len: u64,
    len: u64,
    check_sum: u32,
    file: &'a [u8],
}

/// Little-endian numbers of a file, which ends where it ends.
#[derive(Clone, Copy)]
struct Numbers<'a> {
    file: &'a [u8],
    at: usize,
}

impl Numbers<'_> {
    fn take<const N: usize>(&mut self) -> Result<[u8; N], ReadError> {
        let rest = self.file.get(self.at..).unwrap_or_default();
        let Some(bytes) = rest.first_chunk() else {
            return Err(ReadError::byte(self.at, "the archive ends within an entry"));
        };
        self.at += N;
        Ok(*bytes)
    }

    fn u16(&mut self) -> Result<u16, ReadError> {
        self.take().map(u16::from_le_bytes)
    }

    fn u32(&mut self) -> Result<u32, ReadError> {
        self.take().map(u32::from_le_bytes)
    }

    fn u64(&mut self) -> Result<u64, ReadError> {
        self.take().map(u64::from_le_bytes)
    }

    /// An offset; one beyond the file is found out when something is looked for there.
    fn offset(&mut self) -> Result<usize, ReadError> {
        Ok(usize::try_from(self.u64()?).unwrap_or(usize::MAX))
    }

    fn slice(&mut self, len: usize) -> Result<&[u8], ReadError> {
        let end = self.at.checked_add(len).filter(|&end| end <= self.file.len());
        let end = end.ok_or_else(|| {
            ReadError::byte(self.at.min(self.file.len()), "the archive ends within an entry")
        })?;
        let start = std::mem::replace(&mut self.at, end);
        Ok(&self.file[start..end])
    }
}

/// The entries that the directory of an archive lists.
pub(super) fn entries(file: &[u8]) -> Result<Vec<Stored<'_>>, ReadError> {
    // The last record has a comment of 64 KiB at most behind it.
    let tail = file.len().saturating_sub(22 + usize::from(u16::MAX));
    let end = memchr::memmem::rfind(&file[tail..], &END.to_le_bytes());
    let end = tail
        + end.ok_or_else(|| {
            ReadError::byte(file.len(), "the file has no zip directory; it may have been cut off")
        })?;
    let mut numbers = Numbers { file, at: end + 10 };
    let (mut count, _) = (u64::from(numbers.u16()?), numbers.u32()?);
    let mut start = numbers.u32()? as usize;
    let locator = Numbers { file, at: end.saturating_sub(20) };
    if { locator }.u32()? == LOCATOR_64 {
        let mut locator = Numbers { at: locator.at + 8, ..locator };
        let mut end = Numbers { file, at: locator.offset()?.min(file.len()) };
        if end.u32()? != END_64 {
            return Err(ReadError::byte(end.at - 4, "the end of the zip directory is not here"));
        }
        end.at += 28;
        (count, _, start) = (end.u64()?, end.u64()?, end.offset()?);
    }
    let mut numbers = Numbers { file, at: start.min(file.len()) };
    let mut entries = Vec::new();
    // An entry takes bytes, so a count that is too large comes to the end of the file.
    for _ in 0..count {
        crate::lists::push(&mut entries, entry(&mut numbers)?)?;
    }
    Ok(entries)
}

fn entry<'a>(numbers: &mut Numbers<'a>) -> Result<Stored<'a>, ReadError> {
    let start = numbers.at;
    if numbers.u32()? != CENTRAL {
        return Err(ReadError::byte(start, "the zip directory has no entry here"));
    }
    numbers.at += 4;
    let (flags, method) = (numbers.u16()?, numbers.u16()?);
    numbers.at += 4;
    let check_sum = numbers.u32()?;
    let [mut stored_len, mut len] = [u64::from(numbers.u32()?), u64::from(numbers.u32()?)];
    let [name_len, extra_len, comment_len] = [numbers.u16()?, numbers.u16()?, numbers.u16()?];
    numbers.at += 8;
    let mut offset = numbers.u32()? as usize;
    let name = String::from_utf8_lossy(numbers.slice(name_len.into())?).into_owned();
    let extra_start = numbers.at;
    numbers.slice(extra_len.into())?;
    let mut extra = Numbers { file: &numbers.file[..numbers.at], at: extra_start };
    while extra.at + 4 <= extra.file.len() {
        let (kind, size) = (extra.u16()?, extra.u16()?);
        let next = extra.at + usize::from(size);
        if kind == 1 {
            // Lengths and offset, each where the 32 bits before are all ones.
            if len == u64::from(u32::MAX) {
                len = extra.u64()?;
            }
            if stored_len == u64::from(u32::MAX) {
                stored_len = extra.u64()?;
            }
            if offset == u32::MAX as usize {
                offset = extra.offset()?;
            }
        }
        extra.at = next;
    }
    numbers.slice(comment_len.into())?;
    let (is_encrypted, file) = (flags & 1 != 0, numbers.file);
    Ok(Stored { name, offset, method, is_encrypted, stored_len, len, check_sum, file })
}

impl<'a> Stored<'a> {
    /// The bytes of the entry, and their offset in the file. A compressed entry takes as much memory
    /// as its bytes unfold to, however many it says it has: at most 1032 times its place in the file.
    pub(super) fn bytes(&self) -> Result<(usize, Cow<'a, [u8]>), ReadError> {
        let Self { name, offset, .. } = self;
        let problem = |problem: &str| ReadError::byte(*offset, format!("{name}: {problem}"));
        if self.is_encrypted {
            return Err(problem("the array is encrypted"));
        }
        let mut head = Numbers { file: self.file, at: (*offset).min(self.file.len()) };
        if head.u32()? != LOCAL {
            return Err(problem("the zip archive has no entry here"));
        }
        head.at += 22;
        let skipped = usize::from(head.u16()?) + usize::from(head.u16()?);
        let start = head.at + skipped;
        let end = usize::try_from(self.stored_len).ok().and_then(|len| start.checked_add(len));
        let bytes = end.and_then(|end| self.file.get(start..end));
        let bytes = bytes.ok_or_else(|| problem("the file ends within the array"))?;
        let bytes = match self.method {
            0 => Cow::Borrowed(bytes),
            8 => {
                let mut unfolded = Vec::new();
                if !unfold(bytes, false, self.len, &mut unfolded)? {
                    return Err(problem("the compressed array is damaged"));
                }
                Cow::Owned(unfolded)
            }
            method => {
                return Err(problem(&format!(
                    "the array is compressed by method {method}; only 0 (stored) and 8 (deflate) \
                     are read"
                )));
            }
        };
        if bytes.len() as u64 != self.len {
            return Err(problem("the array is not as long as the archive says"));
        }
        if crc32fast::hash(&bytes) != self.check_sum {
            return Err(problem("the check sum is wrong; the file is damaged"));
        }
        Ok((start, bytes))
    }
}
