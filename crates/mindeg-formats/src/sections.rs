//! Turning numbered items into bytes with all threads, and writing the bytes in order.
//!
//! A file is a list of [`Section`]s, and these are cut into blocks of about [`BLOCK_LEN`] bytes.
//! As many threads work as rayon's current pool has, the calling thread among them. Each takes the
//! next block that nobody has taken, and formats it. The calling thread writes the blocks in order,
//! and formats one only while the next to write is not ready: so it writes and formats as much as
//! it takes for all threads to be done at the same time. The bytes do not depend on the number of
//! threads, and there are never more blocks in memory than threads, and the one being written.
//!
//! Limits: the other threads are started for each file, since rayon's should not wait for one
//! another.

use std::io::{self, Write};
use std::ops::Range;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;

/// What a block takes in bytes, more or less: much for handing it over, and little enough for it
/// to be still in a core's cache when it is written.
const BLOCK_LEN: u32 = 1 << 19;

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
    let threads = thread_count().min(blocks.count);
    if threads < 2 {
        let mut buffer = buffer()?;
        for number in 0..blocks.count {
            buffer.clear();
            blocks.format(number, &mut buffer);
            out.write_all(&buffer)?;
        }
        return Ok(());
    }
    let line = Line::new(blocks.count, threads)?;
    thread::scope(|scope| {
        // However this thread ends, the others are not to wait for it.
        let _end = EndOnDrop(&line);
        for _ in 1..threads {
            thread::Builder::new().spawn_scoped(scope, || {
                let _end = EndOnDrop(&line);
                while let Some((number, mut buffer)) = line.take_or_wait() {
                    blocks.format(number, &mut buffer);
                    line.put(number, buffer);
                }
            })?;
        }
        for number in 0..blocks.count {
            let buffer = loop {
                match line.next_to_write(number) {
                    Next::Write(buffer) => break buffer,
                    Next::Format(taken, mut buffer) => {
                        blocks.format(taken, &mut buffer);
                        line.put(taken, buffer);
                    }
                    // A thread has panicked, which the scope passes on.
                    Next::Never => return Err(io::Error::other("a block is missing")),
                }
            };
            out.write_all(&buffer)?;
            line.give_back(buffer);
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

/// The blocks of a file on their way from those who format them to the one who writes them.
struct Line {
    count: usize,
    state: Mutex<State>,
    /// Somebody who waits may go on.
    changed: Condvar,
}

struct State {
    /// The first block that nobody has taken.
    next: usize,
    /// The block that is being written, or waited for.
    writing: usize,
    /// The formatted blocks, each at its number modulo the length.
    ready: Vec<Option<Vec<u8>>>,
    /// The buffers that hold no block.
    empty: Vec<Vec<u8>>,
    /// Whether no more blocks are to be formatted.
    ended: bool,
}

/// What the thread that writes does next.
enum Next {
    /// Write this, which is the block that it asked for.
    Write(Vec<u8>),
    /// Format a block.
    Format(usize, Vec<u8>),
    /// The block will not come.
    Never,
}

impl Line {
    fn new(count: usize, threads: usize) -> io::Result<Self> {
        let ready = vec![None; threads + 1];
        let empty = (0..=threads).map(|_| buffer()).collect::<Result<_, _>>()?;
        let state = State { next: 0, writing: 0, ready, empty, ended: false };
        Ok(Self { count, state: Mutex::new(state), changed: Condvar::new() })
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn wait<'a>(&self, state: MutexGuard<'a, State>) -> MutexGuard<'a, State> {
        self.changed.wait(state).unwrap_or_else(PoisonError::into_inner)
    }

    /// Takes the next block, if there is a buffer for it.
    fn take(&self, state: &mut State) -> Option<(usize, Vec<u8>)> {
        let number = state.next;
        if number >= self.count {
            return None;
        }
        let mut buffer = state.empty.pop()?;
        buffer.clear();
        state.next += 1;
        Some((number, buffer))
    }

    /// Takes the next block; none if there are no more.
    fn take_or_wait(&self) -> Option<(usize, Vec<u8>)> {
        let mut state = self.state();
        loop {
            if state.ended || state.next >= self.count {
                return None;
            }
            if let Some(taken) = self.take(&mut state) {
                return Some(taken);
            }
            state = self.wait(state);
        }
    }

    /// Puts a formatted block where it is found.
    fn put(&self, number: usize, buffer: Vec<u8>) {
        let mut state = self.state();
        let place = number % state.ready.len();
        state.ready[place] = Some(buffer);
        if number == state.writing {
            self.changed.notify_all();
        }
    }

    fn next_to_write(&self, number: usize) -> Next {
        let mut state = self.state();
        state.writing = number;
        let place = number % state.ready.len();
        loop {
            if let Some(buffer) = state.ready[place].take() {
                return Next::Write(buffer);
            }
            if let Some((taken, buffer)) = self.take(&mut state) {
                return Next::Format(taken, buffer);
            }
            if state.ended {
                return Next::Never;
            }
            state = self.wait(state);
        }
    }

    fn give_back(&self, buffer: Vec<u8>) {
        self.state().empty.push(buffer);
        self.changed.notify_all();
    }
}

/// Ends the line if it is dropped while blocks are missing: by an error, or by a panic.
struct EndOnDrop<'a>(&'a Line);

impl Drop for EndOnDrop<'_> {
    fn drop(&mut self) {
        let mut state = self.0.state();
        if thread::panicking() || state.next < self.0.count {
            state.ended = true;
        }
        self.0.changed.notify_all();
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
