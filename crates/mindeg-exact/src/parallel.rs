//! Work on items by all threads of the current rayon pool, or by one without the feature
//! `parallel`; the results are the same.
//!
//! [`mindeg_mesh::parallel`] cuts work into blocks of 16,384 items, for items that take some
//! nanoseconds; these take much longer.

#[cfg(feature = "parallel")]
use rayon::prelude::*;
use std::ops::Range;

/// The results of `work` on the items in chunks of `len`, in order. The last chunk may be shorter.
pub(crate) fn map_chunks<R: Send>(
    items: Range<usize>,
    len: usize,
    work: impl Fn(Range<usize>) -> R + Sync + Send,
) -> Vec<R> {
    let chunks = 0..items.len().div_ceil(len);
    let of_chunk = |chunk: usize| {
        let start = items.start + chunk * len;
        work(start..items.end.min(start + len))
    };
    // Waking other threads for a single chunk would only cost time.
    #[cfg(feature = "parallel")]
    if chunks.len() > 1 {
        return chunks.into_par_iter().map(of_chunk).collect();
    }
    chunks.map(of_chunk).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chunks_come_in_order_without_gap() {
        for (items, len) in [(0..0, 3), (5..6, 3), (0..9, 3), (7..17, 3), (2..1000, 1)] {
            let chunks = map_chunks(items.clone(), len, |chunk| chunk);
            assert!(chunks.iter().all(|chunk| !chunk.is_empty() && chunk.len() <= len));
            assert!(chunks.into_iter().flatten().eq(items));
        }
    }
}
