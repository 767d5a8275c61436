//! Turning numbered items into bytes with all threads, and writing the bytes in order.
//!
//! A file is a list of [`Section`]s, and these are cut into blocks of about [`BLOCK_LEN`] bytes.
//! There are as many lanes as threads in rayon's current pool. The blocks are dealt to the lanes,
//! each lane formats its own, and the calling thread takes them from the lanes in turn and writes
//! them. So the bytes do not depend on the number of threads, and there are never more blocks in
//! memory than lanes, and the one being written.
//!
//! Limits: lanes are threads of their own, started for each file, since rayon's should not wait
//! for one another.

use std::io::{self, Write};
use std::ops::Range;
use std::sync::mpsc::{self, Receiver, SyncSender};
use std::thread;

/// What a block takes in bytes, more or less: much for handing it over, and little enough for it
/// to be still in a core's cache when it is written.
const BLOCK_LEN: u32 = 1 << 19;

/// The most items formatted at a time.
const PART: usize = 4096;

/// A buffer that takes a block, also one that is longer than was thought.
fn buffer() -> Vec<u8> {
    Vec::with_capacity(2 * BLOCK_LEN as usize)
}

/// How a range of items becomes bytes: they are appended to the buffer.
type Format<'a> = dyn Fn(Range<u32>, &mut Vec<u8>) + Sync + 'a;

/// Items of one kind that follow one another in a file.
pub(crate) struct Section<'a> {
    count: u32,
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
        Self { count, block: (BLOCK_LEN / item_len).max(1), format: Box::new(format) }
    }

    /// Some bytes as they are.
    pub(crate) fn bytes(bytes: impl Into<Vec<u8>>) -> Self {
        let bytes = bytes.into();
        Self::new(1, BLOCK_LEN, move |_, buffer| buffer.extend_from_slice(&bytes))
    }

    fn block_count(&self) -> usize {
        self.count.div_ceil(self.block) as usize
    }

    fn format_block(&self, number: usize, buffer: &mut Vec<u8>) {
        let start = number as u32 * self.block;
        let end = start.saturating_add(self.block).min(self.count);
        // In parts, so that what is made of several items at a time, such as points, stays small.
        for part in (start..end).step_by(PART) {
            (self.format)(part..part.saturating_add(PART as u32).min(end), buffer);
        }
    }

    /// About how many bytes the section has: those of some of its items, times the share that they
    /// are of all.
    fn estimated_len(&self) -> u64 {
        const SAMPLES: u32 = 256;
        const SAMPLE: u32 = 8;
        if self.count <= SAMPLES * SAMPLE {
            let mut all = Vec::new();
            (self.format)(0..self.count, &mut all);
            return all.len() as u64;
        }
        let mut sampled = Vec::new();
        for sample in 0..SAMPLES {
            // One from each part of the section. Where in the part differs from each to the next by
            // the golden section, since lengths may go up and down with any period.
            let part = |number: u32| {
                u64::from(self.count - SAMPLE) * u64::from(number) / u64::from(SAMPLES)
            };
            let within = sample.wrapping_mul(0x9e37_79b9);
            let len = part(sample + 1) - part(sample);
            let start = (part(sample) + ((len * u64::from(within)) >> 32)) as u32;
            (self.format)(start..start + SAMPLE, &mut sampled);
        }
        sampled.len() as u64 * u64::from(self.count) / u64::from(SAMPLES * SAMPLE)
    }
}

/// About how many bytes the sections have in all. Takes a millisecond at most.
pub(crate) fn estimated_len(sections: &[Section<'_>]) -> u64 {
    sections.iter().map(Section::estimated_len).sum()
}

/// Writes the sections one after the other.
pub(crate) fn write_sections(out: &mut impl Write, sections: &[Section<'_>]) -> io::Result<()> {
    let blocks = Blocks::new(sections);
    let lanes = thread_count().min(blocks.count);
    if lanes < 2 {
        let mut buffer = buffer();
        for number in 0..blocks.count {
            buffer.clear();
            blocks.format(number, &mut buffer);
            out.write_all(&buffer)?;
        }
        return Ok(());
    }
    thread::scope(|scope| {
        let mut handovers = Vec::with_capacity(lanes);
        for lane in 0..lanes {
            let (empty_buffers, empty) = mpsc::sync_channel(1);
            let (full, full_buffers) = mpsc::sync_channel(1);
            let blocks = &blocks;
            thread::Builder::new().spawn_scoped(scope, move || {
                format_lane(blocks, lane..blocks.count, lanes, &empty, &full);
            })?;
            handovers.push((full_buffers, empty_buffers));
        }
        let mut written = buffer();
        for number in 0..blocks.count {
            let (full_buffers, empty_buffers) = &handovers[number % lanes];
            // A lane that is gone has panicked, which the scope passes on.
            let full = full_buffers.recv().map_err(io::Error::other)?;
            // A lane that has no more to do takes no more buffers.
            let _ = empty_buffers.send(std::mem::replace(&mut written, full));
            out.write_all(&written)?;
        }
        Ok(())
    })
}

/// How many threads may format at the same time.
fn thread_count() -> usize {
    #[cfg(feature = "parallel")]
    return rayon::current_num_threads();
    #[cfg(not(feature = "parallel"))]
    return 1;
}

/// Formats every `step`-th of the blocks into the buffers handed in, until there are no more, or
/// nobody takes them.
fn format_lane(
    blocks: &Blocks<'_>,
    numbers: Range<usize>,
    step: usize,
    empty: &Receiver<Vec<u8>>,
    full: &SyncSender<Vec<u8>>,
) {
    let mut buffer = buffer();
    for number in numbers.step_by(step) {
        buffer.clear();
        blocks.format(number, &mut buffer);
        if full.send(buffer).is_err() {
            return;
        }
        match empty.recv() {
            Ok(next) => buffer = next,
            Err(_) => return,
        }
    }
}

/// The blocks of all sections, numbered through.
struct Blocks<'a> {
    sections: &'a [Section<'a>],
    /// The number of the first block of each section.
    starts: Vec<usize>,
    count: usize,
}

impl<'a> Blocks<'a> {
    fn new(sections: &'a [Section<'a>]) -> Self {
        let mut count = 0;
        let start = |section: &Section<'_>| {
            let start = count;
            count += section.block_count();
            start
        };
        let starts = sections.iter().map(start).collect();
        Self { sections, starts, count }
    }

    fn format(&self, number: usize, buffer: &mut Vec<u8>) {
        // Of sections that start with the same block all but the last are empty.
        let section = self.starts.partition_point(|&start| start <= number) - 1;
        self.sections[section].format_block(number - self.starts[section], buffer);
    }
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
                assert_eq!(estimated_len(&sections), expected.len() as u64);
            }
        }
    }

    #[test]
    fn no_more_blocks_are_in_memory_than_lanes_and_the_one_being_written() {
        let formatted = AtomicUsize::new(0);
        let sections = [Section::new(40, BLOCK_LEN, |range, buffer| {
            formatted.fetch_add(range.len(), Relaxed);
            buffer.push(0);
        })];
        /// Waits with each block until the lanes have nothing more to do.
        struct Slow<'a>(usize, &'a AtomicUsize);
        impl Write for Slow<'_> {
            fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
                thread::sleep(std::time::Duration::from_millis(5));
                self.0 += 1;
                let formatted = self.1.load(Relaxed);
                assert!(formatted <= self.0 + 3, "{formatted} when {} are written", self.0);
                Ok(bytes.len())
            }
            fn flush(&mut self) -> io::Result<()> {
                Ok(())
            }
        }
        let mut slow = Slow(0, &formatted);
        with_threads(3, || write_sections(&mut slow, &sections)).unwrap();
        assert_eq!(slow.0, 40);
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
