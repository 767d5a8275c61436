//! Decompression of deflated bytes in zip archives and VTU files.

use miniz_oxide::inflate::decompress_slice_iter_to_slice;
use std::collections::TryReserveError;

/// The most bytes that deflate makes of one.
const LARGEST_RATIO: usize = 1040;

/// Adds to `bytes` what `stored` unfolds to, at most `len` bytes; false if it is not compressed, or
/// unfolds to more.
pub(crate) fn unfold(
    stored: &[u8],
    has_zlib_head: bool,
    len: u64,
    bytes: &mut Vec<u8>,
) -> Result<bool, TryReserveError> {
    let len = usize::try_from(len).unwrap_or(usize::MAX);
    let len = len.min(stored.len().saturating_mul(LARGEST_RATIO));
    // The numbers go to lists of their own, which take as much again, and then to the mesh.
    let mut asked = Vec::<u8>::new();
    asked.try_reserve_exact(len.saturating_mul(4))?;
    drop(std::hint::black_box(asked));
    bytes.try_reserve_exact(len)?;
    let start = bytes.len();
    bytes.resize(start + len, 0);
    let input = std::iter::once(stored);
    let unfolded = decompress_slice_iter_to_slice(&mut bytes[start..], input, has_zlib_head, false);
    bytes.truncate(start + unfolded.unwrap_or(0));
    Ok(unfolded.is_ok())
}

#[cfg(test)]
mod tests {
    use super::*;
    use miniz_oxide::deflate::{compress_to_vec, compress_to_vec_zlib};

    #[test]
    fn bytes_are_added_up_to_their_length() {
        let mut bytes = b"before ".to_vec();
        assert_eq!(unfold(&compress_to_vec_zlib(b"and after", 6), true, 9, &mut bytes), Ok(true));
        assert_eq!(bytes, b"before and after");
        // Fewer than the given length.
        assert_eq!(unfold(&compress_to_vec(b", here", 6), false, u64::MAX, &mut bytes), Ok(true));
        assert_eq!(bytes, b"before and after, here");
    }

    #[test]
    fn what_does_not_unfold_is_damaged() {
        let zeros = compress_to_vec(&[0; 100_000], 6);
        for (stored, len) in [(&zeros[..], 99_999), (&zeros[..zeros.len() - 1], 100_000), (b"", 7)]
        {
            assert_eq!(unfold(stored, false, len, &mut Vec::new()), Ok(false));
        }
    }
}
