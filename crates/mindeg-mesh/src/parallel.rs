//! Work on items `0..count`, shared by all threads. The results do not depend on the number of
//! threads.
//!
//! The items form blocks of fixed size; one thread works on a block from front to back, and the
//! results of the blocks come in order. So a sum of floats has the same bits on every machine.
//!
//! The threads are rayon's: the pool of the caller, else one thread for each core, or as many as
//! the environment variable `RAYON_NUM_THREADS` says.
//!
//! Limits: one result is kept for each block of 16,384 items.

#[cfg(feature = "parallel")]
use rayon::prelude::*;
use std::ops::Range;

/// Items in a block: at least a hundred microseconds of work, so that scheduling costs little.
const BLOCK: u32 = 1 << 14;

/// The items of the block with an index.
pub fn block(index: usize, count: u32) -> Range<u32> {
    let start = index as u32 * BLOCK;
    start..start.saturating_add(BLOCK).min(count)
}

/// How many threads share work.
pub fn threads() -> usize {
    #[cfg(feature = "parallel")]
    return rayon::current_num_threads();
    #[cfg(not(feature = "parallel"))]
    return 1;
}

/// The results of `work` on each block of the items `0..count`, in order. If a block fails, the
/// error of any failed block; then some blocks are not run.
pub fn try_blocks<R: Send, E: Send>(
    count: u32,
    work: impl Fn(Range<u32>) -> Result<R, E> + Sync + Send,
) -> Result<Vec<R>, E> {
    // Waking other threads for a single block would only cost time.
    if count <= BLOCK {
        return work(0..count).map(|result| vec![result]);
    }
    let indices = 0..count.div_ceil(BLOCK) as usize;
    #[cfg(feature = "parallel")]
    return indices.into_par_iter().map(|index| work(block(index, count))).collect();
    #[cfg(not(feature = "parallel"))]
    return indices.map(|index| work(block(index, count))).collect();
}

/// The results of `work` on each block of the items `0..count`, in order.
pub fn blocks<R: Send>(count: u32, work: impl Fn(Range<u32>) -> R + Sync + Send) -> Vec<R> {
    let Ok(results) = try_blocks(count, |range| Ok::<_, std::convert::Infallible>(work(range)));
    results
}

/// Fills a list block by block: `fill` gets the index of the first value and the block.
pub fn fill_blocks<T: Send>(values: &mut [T], fill: impl Fn(u32, &mut [T]) + Sync + Send) {
    // To wake another thread takes longer.
    if values.len() <= BLOCK as usize {
        return fill(0, values);
    }
    #[cfg(feature = "parallel")]
    let parts = values.par_chunks_mut(BLOCK as usize).enumerate();
    #[cfg(not(feature = "parallel"))]
    let parts = values.chunks_mut(BLOCK as usize).enumerate();
    parts.for_each(|(index, part)| fill(index as u32 * BLOCK, part));
}

/// The result of `work` on the first block of the items `0..count` that has a result.
pub fn first_of_blocks<R: Send>(
    count: u32,
    work: impl Fn(Range<u32>) -> Option<R> + Sync + Send,
) -> Option<R> {
    let indices = 0..count.div_ceil(BLOCK) as usize;
    #[cfg(feature = "parallel")]
    return indices.into_par_iter().find_map_first(|index| work(block(index, count)));
    #[cfg(not(feature = "parallel"))]
    return { indices }.find_map(|index| work(block(index, count)));
}

/// The results of `work` on each of a few large items, in order.
pub fn map_all<T: Send, R: Send>(items: Vec<T>, work: impl Fn(T) -> R + Sync + Send) -> Vec<R> {
    #[cfg(feature = "parallel")]
    if items.len() > 1 {
        return items.into_par_iter().map(work).collect();
    }
    items.into_iter().map(work).collect()
}

/// The results of `work` on chunks of `len` items, in order; the last chunk may be shorter. For items that take
/// much longer than those of [`blocks`].
pub fn map_chunks<R: Send>(
    items: Range<usize>,
    len: usize,
    work: impl Fn(Range<usize>) -> R + Sync + Send,
) -> Vec<R> {
    let chunks = items.clone().step_by(len).map(|start| start..items.end.min(start + len));
    map_all(chunks.collect(), work)
}

/// Sorts values; equal ones must be identical. O(n log n), shared by all threads.
pub fn sort_all<T: Ord + Send>(values: &mut [T]) {
    #[cfg(feature = "parallel")]
    values.par_sort_unstable();
    #[cfg(not(feature = "parallel"))]
    values.sort_unstable();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_come_in_order_without_gap() {
        for count in [1, BLOCK - 1, BLOCK, BLOCK + 1, 20 * BLOCK + 5] {
            let ranges = blocks(count, |range| range);
            assert!(ranges.iter().all(|range| range.len() <= BLOCK as usize));
            assert!(ranges.into_iter().flatten().eq(0..count), "{count}");
        }
        let last = try_blocks(u32::MAX, |range| if range.start == 0 { Ok(()) } else { Err(range) });
        assert!(last.is_err());
    }

    #[test]
    fn chunks_come_in_order_without_gap() {
        for (items, len) in [(0..0, 3), (5..6, 3), (0..9, 3), (7..17, 3), (2..1000, 1)] {
            let chunks = map_chunks(items.clone(), len, |chunk| chunk);
            assert!(chunks.iter().all(|chunk| !chunk.is_empty() && chunk.len() <= len));
            assert!(chunks.into_iter().flatten().eq(items));
        }
    }

    #[test]
    fn the_first_find_is_found() {
        for first in [0, 1, BLOCK, 7 * BLOCK - 1, 20 * BLOCK + 4] {
            let found = first_of_blocks(20 * BLOCK + 5, |mut range| range.find(|&i| i >= first));
            assert_eq!(found, Some(first));
        }
        assert_eq!(first_of_blocks(20 * BLOCK, |_| None::<()>), None);
    }
}
