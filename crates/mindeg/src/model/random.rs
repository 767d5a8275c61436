//! Numbers that look random and depend on what they are for alone.

/// A number for some indices: splitmix64 over each of them.
pub(super) fn hash(indices: &[u64]) -> u64 {
    indices.iter().fold(0x9e37_79b9_7f4a_7c15, |state, &index| {
        let mut z = (state ^ index).wrapping_add(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    })
}
