//! Vertices that are several in a file and one place in space.

use crate::parallel::sort_all;
use glam::DVec3;

/// For every vertex the first vertex at the same position, itself if there is none before it.
/// Positions are the same if their coordinates are equal as numbers. O(n log n), shared by all threads.
pub(super) fn first_at_position(positions: &[DVec3]) -> Vec<u32> {
    // Adding zero turns -0 into 0, so that equal numbers have equal bits.
    let bits = |position: DVec3| (position + DVec3::ZERO).to_array().map(f64::to_bits);
    let mut places: Vec<_> = (0_u32..).zip(positions).map(|(v, &p)| (bits(p), v)).collect();
    sort_all(&mut places);
    let mut first = vec![0; positions.len()];
    for same in places.chunk_by(|a, b| a.0 == b.0) {
        for &(_, vertex) in same {
            first[vertex as usize] = same[0].1;
        }
    }
    first
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_the_first_of_equal_positions() {
        let at = |x: f64, y: f64| DVec3::new(x, y, 1.0);
        for (positions, expected) in [
            (&[][..], &[][..]),
            (&[at(0.0, 0.0), at(1.0, 0.0), at(0.0, 0.0)], &[0, 1, 0]),
            (&[at(2.0, 0.0), at(-0.0, 2.0), at(0.0, 2.0), at(2.0, -0.0)], &[0, 1, 1, 0]),
            (&[at(1.0, 2.0), at(2.0, 1.0), at(1.0 + f64::EPSILON, 2.0)], &[0, 1, 2]),
            (&[at(3.0, 3.0); 4], &[0, 0, 0, 0]),
        ] {
            assert_eq!(first_at_position(positions), expected, "{positions:?}");
        }
    }
}
