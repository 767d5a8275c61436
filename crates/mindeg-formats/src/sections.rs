//! Turning numbered items into bytes with all threads, and writing the bytes in order.
//!
//! A file is a list of [`Section`]s, and these are cut into blocks of about [`BLOCK_LEN`] bytes. The
//! threads of rayon's current pool format one batch of blocks while the calling thread writes the
//! batch before. The bytes do not depend on the number of threads, and never more than two batches of
//! [`BATCH`] blocks for each thread are in memory.

use std::io::{self, Write};
use std::ops::Range;

use mindeg_mesh::{Counter, Progress};

/// About how many bytes a block takes: enough to be worth a task, and little enough to be still in a
/// core's cache when it is written.
const BLOCK_LEN: u32 = 1 << 17;

/// How many blocks of a batch each thread formats: several, so that no thread waits long for another.
const BATCH: usize = 4;

/// The most items formatted at a time.
const PART: usize = 4096;

/// A buffer that takes a block, also one that is longer than was thought.
fn buffer() -> io::Result<Vec<u8>> {
    let mut buffer = Vec::new();
    buffer.try_reserve_exact(2 * BLOCK_LEN as usize)?;
    Ok(buffer)
}
/// How a range of items becomes bytes: they are appended to the buffer.
type Format<'a> = dyn Fn(Range<u32>, &mut Vec<u8>) + Sync + 'a;

/// Items of one kind that follow one another in a file.
pub(crate) struct Section<'a> {
    items: Range<u32>,
    /// How many items go into a block.
    block: u32,
    format: Box<Format<'a>>,
}

impl<'a> Section<'a> {
    /// The items `0..count`, each of about `item_len` bytes and formatted without regard to the
    /// others.
    pub(crate) fn new(
        count: u32,
        item_len: u32,
        format: impl Fn(Range<u32>, &mut Vec<u8>) + Sync + 'a,
    ) -> Self {
        Self::of(0..count, item_len, format)
    }

    /// [`new`](Self::new), of the items in a range.
    pub(crate) fn of(
        items: Range<u32>,
        item_len: u32,
        format: impl Fn(Range<u32>, &mut Vec<u8>) + Sync + 'a,
    ) -> Self {
        Self { items, block: (BLOCK_LEN / item_len).max(1), format: Box::new(format) }
    }

    /// Some bytes as they are.
    pub(crate) fn bytes(bytes: impl Into<Vec<u8>>) -> Self {
        let bytes = bytes.into();
        Self::new(1, BLOCK_LEN, move |_, buffer| buffer.extend_from_slice(&bytes))
    }

    /// The same bytes for each of `count` items.
    pub(crate) fn repeated(count: u32, item: &[u8]) -> Self {
        const COPIES: usize = 256;
        let (len, copies) = (item.len(), item.repeat(COPIES));
        Self::new(count, len as u32, move |range, buffer| {
            let mut items = range.len();
            while items > 0 {
                let some = items.min(COPIES);
                buffer.extend_from_slice(&copies[..some * len]);
                items -= some;
            }
        })
    }

    /// The items of each block.
    fn blocks(&self) -> impl Iterator<Item = Block<'_, 'a>> {
        let starts = self.items.clone().step_by(self.block as usize);
        starts.map(move |start| {
            let end = start.saturating_add(self.block).min(self.items.end);
            Block { section: self, items: start..end }
        })
    }
}

/// Items that are formatted at a time.
struct Block<'s, 'a> {
    section: &'s Section<'a>,
    items: Range<u32>,
}

impl Block<'_, '_> {
    fn format(&self, buffer: &mut Vec<u8>) {
        buffer.clear();
        // In parts, so that what is made of several items at a time, such as points, stays small.
        for start in self.items.clone().step_by(PART) {
            let end = start.saturating_add(PART as u32).min(self.items.end);
            (self.section.format)(start..end, buffer);
        }
    }
}

/// How many blocks some sections have.
pub(crate) fn block_count(sections: &[Section<'_>]) -> u64 {
    sections.iter().map(|section| section.items.len().div_ceil(section.block as usize) as u64).sum()
}

/// Writes the sections one after the other.
pub(crate) fn write_sections(out: &mut impl Write, sections: &[Section<'_>]) -> io::Result<()> {
    write_counted(out, sections, &Progress::NONE.counter("", 0))
}

/// [`write_sections`], which counts the blocks that are written.
pub(crate) fn write_counted(
    out: &mut impl Write,
    sections: &[Section<'_>],
    written: &Counter<'_>,
) -> io::Result<()> {
    let mut blocks = sections.iter().flat_map(Section::blocks);
    #[cfg(feature = "parallel")]
    if rayon::current_num_threads() > 1 && block_count(sections) > 1 {
        let len = (BATCH * rayon::current_num_threads()).min(block_count(sections) as usize);
        let buffers = || (0..len).map(|_| buffer()).collect::<Result<Vec<_>, _>>();
        let (mut full, mut empty) = (buffers()?, buffers()?);
        let mut ready = 0;
        loop {
            let batch: Vec<_> = blocks.by_ref().take(len).collect();
            rayon::in_place_scope(|scope| {
                for (block, buffer) in batch.iter().zip(&mut empty) {
                    scope.spawn(move |_| block.format(buffer));
                }
                full[..ready].iter().try_for_each(|buffer| out.write_all(buffer))
            })?;
            written.add(ready).map_err(io::Error::other)?;
            if batch.is_empty() {
                return Ok(());
            }
            ready = batch.len();
            std::mem::swap(&mut full, &mut empty);
        }
    }
    let mut buffer = buffer()?;
    for block in blocks {
        block.format(&mut buffer);
        out.write_all(&buffer)?;
        written.add(1).map_err(io::Error::other)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

    fn numbers<'a>(count: u32) -> Section<'a> {
        Section::new(count, 4, |range, buffer| {
            range.for_each(|i| buffer.extend_from_slice(&i.to_le_bytes()));
        })
    }

    fn with_threads<R: Send>(threads: usize, work: impl FnOnce() -> R + Send) -> R {
        rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(work)
    }

    #[test]
    fn sections_follow_each_other_without_gap() {
        const BLOCK: u32 = BLOCK_LEN / 4;
        for counts in [
            &[0, 0][..],
            &[1],
            &[BLOCK - 1, 0, 1],
            &[0, BLOCK, 0, BLOCK + 1],
            &[3, 7 * BLOCK + 5, 2, 5 * BLOCK],
        ] {
            let expected: Vec<u8> =
                counts.iter().flat_map(|&count| 0..count).flat_map(u32::to_le_bytes).collect();
            for threads in [1, 2, 5] {
                let mut out = Vec::new();
                let sections: Vec<Section<'_>> = counts.iter().copied().map(numbers).collect();
                with_threads(threads, || write_sections(&mut out, &sections)).unwrap();
                assert!(out == expected, "{counts:?}, {threads} threads");
            }
        }
    }

    #[test]
    fn no_more_than_two_batches_are_in_memory() {
        let formatted = AtomicUsize::new(0);
        let sections = [Section::new(100, BLOCK_LEN, |range, buffer| {
            formatted.fetch_add(range.len(), Relaxed);
            buffer.push(0);
        })];
        /// Waits with each block until the threads have nothing more to do.
        struct Slow<'a>(usize, &'a AtomicUsize);
        impl Write for Slow<'_> {
            fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
                std::thread::sleep(std::time::Duration::from_millis(5));
                self.0 += 1;
                let formatted = self.1.load(Relaxed);
                assert!(
                    formatted <= self.0 + 2 * BATCH * 3,
                    "{formatted} when {} are written",
                    self.0
                );
                Ok(bytes.len())
            }
            fn flush(&mut self) -> io::Result<()> {
                Ok(())
            }
        }
        let mut slow = Slow(0, &formatted);
        with_threads(3, || write_sections(&mut slow, &sections)).unwrap();
        assert_eq!(slow.0, 100);
    }

    /// Whoever writes the file must get to delete it.
    #[test]
    fn a_panic_is_passed_on_and_holds_nobody_up() {
        for threads in [1, 4] {
            let sections = [Section::new(40, BLOCK_LEN, |range, _| assert!(range.start != 7))];
            let write = || write_sections(&mut io::sink(), &sections);
            let result = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
                with_threads(threads, write)
            }));
            assert!(result.is_err());
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
        for threads in [1, 4] {
            let write = |room: usize, blocks: u32| {
                let sections = [Section::new(blocks, BLOCK_LEN, |_, buffer| buffer.push(0))];
                with_threads(threads, || write_sections(&mut Full(room), &sections))
            };
            let error = write(2, 10).unwrap_err();
            assert_eq!(error.kind(), io::ErrorKind::StorageFull);
            write(2, 2).unwrap();
        }
    }
}
