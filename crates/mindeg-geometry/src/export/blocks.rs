//! Turning numbered items into bytes, one block at a time.

use std::io::{self, Write};
use std::ops::Range;

/// Items to a block: 64 KiB and more of most formats, so that one write pays for itself.
const BLOCK: u32 = 8192;

/// Writes the items `0..count` in order. `format` appends the bytes of a range of items to
/// the buffer it is given; no range is longer than [`BLOCK`], so memory does not grow with
/// `count`. Each block is formatted without regard to the others.
pub(super) fn write_items(
    out: &mut impl Write,
    count: u32,
    format: impl Fn(Range<u32>, &mut Vec<u8>),
) -> io::Result<()> {
    let mut buffer = Vec::new();
    let mut start = 0;
    while start < count {
        let end = start.saturating_add(BLOCK).min(count);
        buffer.clear();
        format(start..end, &mut buffer);
        out.write_all(&buffer)?;
        start = end;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_follow_each_other_without_gap() {
        for count in [0, 1, BLOCK - 1, BLOCK, BLOCK + 1, 3 * BLOCK + 5] {
            let mut out = Vec::new();
            write_items(&mut out, count, |range, buffer| {
                assert!(range.len() <= BLOCK as usize);
                range.for_each(|i| buffer.extend_from_slice(&i.to_le_bytes()));
            })
            .unwrap();
            let expected: Vec<u8> = (0..count).flat_map(u32::to_le_bytes).collect();
            assert_eq!(out, expected);
        }
    }

    #[test]
    fn the_first_error_ends_it() {
        struct Full(usize);
        impl Write for Full {
            fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
                if self.0 == 0 {
                    return Err(io::ErrorKind::StorageFull.into());
                }
                self.0 -= 1;
                Ok(bytes.len())
            }
            fn flush(&mut self) -> io::Result<()> {
                Ok(())
            }
        }
        let bytes = |range: Range<u32>, buffer: &mut Vec<u8>| buffer.resize(range.len(), 0);
        let error = write_items(&mut Full(2), 10 * BLOCK, bytes).unwrap_err();
        assert_eq!(error.kind(), io::ErrorKind::StorageFull);
        write_items(&mut Full(2), 2 * BLOCK, bytes).unwrap();
    }
}
