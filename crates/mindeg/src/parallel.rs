//! Work that is shared by all threads of the current rayon pool, or done by one without the feature
//! `parallel`; the results are the same.

/// The results of `work` on some indices, in order.
pub(crate) fn map_indices<R: Send>(
    indices: &[usize],
    work: impl Fn(usize) -> R + Sync + Send,
) -> Vec<R> {
    #[cfg(feature = "parallel")]
    if indices.len() > 1 {
        use rayon::prelude::*;
        return indices.par_iter().map(|&index| work(index)).collect();
    }
    indices.iter().map(|&index| work(index)).collect()
}
