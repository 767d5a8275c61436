//! Turning numbered items into bytes with all threads, and writing the bytes in order.
//!
//! A file is a list of [`Section`]s, and these are cut into blocks of about [`BLOCK_LEN`] bytes. With
//! `n` threads each formats every `n`-th block, waits until the thread before hands it the file, writes
//! its block and hands the file on: a thread writes while the others format, and a block is written
//! from the cache of the core that made it. The bytes do not depend on the number of threads, and there
//! are never more blocks in memory than threads.

use std::io::{self, Write};
use std::ops::Range;
use std::sync::mpsc;
use std::thread;

use mindeg_mesh::{Counter, Progress};

/// About how many bytes a block takes: enough to be worth handing the file on, and little enough to be
/// still in a core's cache when it is written.
const BLOCK_LEN: u32 = 1 << 19;

/// The most items formatted at a time.
const PART: usize = 4096;

/// How a range of items becomes bytes: they are appended to the buffer.
type Format<'a> = dyn Fn(Range<u32>, &mut Vec<u8>) + Sync + 'a;

/// Items of one kind that follow one another in a file.
pub(crate) struct Section<'a> {
    items: Range<u32>,
    /// About how many bytes an item takes.
    item_len: u32,
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
        Self { items, item_len, format: Box::new(format) }
    }

    /// Some bytes as they are.
    pub(crate) fn bytes(bytes: impl Into<Vec<u8>>) -> Self {
        let bytes = bytes.into();
        Self::new(1, bytes.len() as u32, move |_, buffer| buffer.extend_from_slice(&bytes))
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

    /// The length in bytes, if all items have the given length.
    pub(crate) fn byte_len(&self) -> u64 {
        self.items.len() as u64 * u64::from(self.item_len)
    }

    /// How many items go into a block.
    fn block(&self) -> u32 {
        BLOCK_LEN.checked_div(self.item_len).unwrap_or(1).max(1)
    }

    /// The items of each block.
    fn blocks(&self) -> impl Iterator<Item = Block<'_, 'a>> {
        let starts = self.items.clone().step_by(self.block() as usize);
        starts.map(move |start| {
            let end = start.saturating_add(self.block()).min(self.items.end);
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
        // A few items at a time, so that lists made of them, such as points, stay small.
        for start in self.items.clone().step_by(PART) {
            let end = start.saturating_add(PART as u32).min(self.items.end);
            (self.section.format)(start..end, buffer);
        }
    }
}

/// How many blocks some sections have.
pub(crate) fn block_count(sections: &[Section<'_>]) -> u64 {
    sections
        .iter()
        .map(|section| section.items.len().div_ceil(section.block() as usize) as u64)
        .sum()
}

/// Writes the sections one after the other.
pub(crate) fn write_sections(
    out: &mut (impl Write + Send),
    sections: &[Section<'_>],
) -> io::Result<()> {
    write_counted(out, sections, &Progress::NONE.counter("", 0))
}

/// [`write_sections`], which counts the blocks that are written.
pub(crate) fn write_counted(
    out: &mut (impl Write + Send),
    sections: &[Section<'_>],
    written: &Counter<'_>,
) -> io::Result<()> {
    let blocks = usize::try_from(block_count(sections)).unwrap_or(usize::MAX);
    let threads = thread_count().min(blocks).max(1);
    // The file goes round: each thread has the end of the channel that it gets the file from, and the
    // beginning of the next thread's. Whoever ends early drops both, so that all others end as well.
    let (mut hand_on, turns): (Vec<_>, Vec<_>) =
        (0..threads).map(|_| mpsc::sync_channel(1)).unzip();
    hand_on[0].send(out).expect("its receiver is in `turns`");
    hand_on.rotate_left(1);
    let mut shares = turns.into_iter().zip(hand_on).enumerate().map(|(first, (turn, hand_on))| {
        move || {
            // Dropped when this thread ends, also by an error or a panic.
            let (turn, hand_on) = (turn, hand_on);
            let mut buffer = Vec::new();
            buffer.try_reserve_exact(2 * BLOCK_LEN as usize)?;
            for block in sections.iter().flat_map(Section::blocks).skip(first).step_by(threads) {
                block.format(&mut buffer);
                let Ok(out) = turn.recv() else { return Ok(()) };
                out.write_all(&buffer)?;
                written.add(1).map_err(io::Error::other)?;
                // After the last block the next thread may have ended.
                let _ = hand_on.send(out);
            }
            Ok(())
        }
    });
    let own = shares.next().expect("at least one thread");
    thread::scope(|scope| {
        let others: io::Result<Vec<_>> =
            shares.map(|share| thread::Builder::new().spawn_scoped(scope, share)).collect();
        let own = own();
        let others = others?.into_iter().map(|other| other.join());
        others.fold(own, |all, other| {
            all.and(other.unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
        })
    })
}

/// How many threads may format at the same time.
fn thread_count() -> usize {
    #[cfg(feature = "parallel")]
    return rayon::current_num_threads();
    #[cfg(not(feature = "parallel"))]
    return 1;
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
    fn no_more_blocks_than_threads_are_in_memory() {
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
                let formatted = self.1.load(Relaxed);
                assert!(formatted <= self.0 + 3, "{formatted} when {} are written", self.0);
                self.0 += 1;
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
