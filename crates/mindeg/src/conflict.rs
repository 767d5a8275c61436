//! Finds limits that conflict with each other: as few as a number of tries finds.
//!
//! The shortest list of first limits that conflict ends in a limit that is part of every conflict in
//! the list. Bisection finds it; it is kept while the list before it is searched in the same way.
//!
//! Limits: a conflict of several, not the smallest one; and with too few tries, more limits than
//! needed. The returned limits always conflict.

/// A list of limits that conflict, of limits that are known to conflict.
///
/// With `k` limits in the answer of `n`, it takes about k log n of at most `tries_left` tries.
///
/// # Errors
///
/// The errors of `conflict`.
pub(crate) fn smallest<T: Copy, E>(
    mut suspects: Vec<T>,
    mut tries_left: u64,
    mut conflict: impl FnMut(&[T]) -> Result<bool, E>,
) -> Result<Vec<T>, E> {
    let mut found = Vec::new();
    let mut tried = |suspects: &[T], found: &[T]| {
        if tries_left == 0 {
            return Ok(None);
        }
        tries_left -= 1;
        conflict(&[suspects, found].concat()).map(Some)
    };
    loop {
        // Together with those found, the first `low` do not conflict and the first `high` do.
        let (mut low, mut high) = (0, suspects.len());
        while high - low > 1 {
            let middle = low.midpoint(high);
            match tried(&suspects[..middle], &found)? {
                Some(true) => high = middle,
                Some(false) => low = middle,
                None => return Ok([&suspects[..high], &found].concat()),
            }
        }
        suspects.truncate(high);
        found.extend(suspects.pop());
        if suspects.is_empty() || tried(&[], &found)? == Some(true) {
            return Ok(found);
        }
    }
}

/// Vertices as a message lists them.
pub(crate) fn vertex_list(vertices: &[u32]) -> String {
    const MOST: usize = 8;
    let names: Vec<String> = vertices.iter().take(MOST).map(u32::to_string).collect();
    match vertices.len() {
        0 | 1 => format!("vertex {}", names.join("")),
        count @ 2..=MOST => {
            format!("vertices {} and {} together", names[..count - 1].join(", "), names[count - 1])
        }
        count => format!("vertices {}, … ({count} in all) together", names.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::convert::Infallible;

    /// The answer where some sets of numbers below `count` conflict, and the tries taken.
    fn smallest_of(count: u32, sets: &[&[u32]], tries: u64) -> (Vec<u32>, u64) {
        let mut taken = 0;
        let Ok(mut found) = smallest((0..count).collect(), tries, |limits: &[u32]| {
            taken += 1;
            let holds = |set: &&&[u32]| set.iter().all(|limit| limits.contains(limit));
            Ok::<_, Infallible>(sets.iter().any(|set| holds(&set)))
        });
        found.sort_unstable();
        (found, taken)
    }

    #[test]
    fn finds_a_conflict_without_a_limit_too_many() {
        for set in [&[7_u32][..], &[0], &[99], &[0, 99], &[3, 4, 5], &[0, 50, 98, 99]] {
            let (found, taken) = smallest_of(100, &[set], 1000);
            assert_eq!(found, set);
            assert!(taken <= 8 * set.len() as u64, "{taken}");
        }
        assert_eq!(smallest_of(1, &[&[0]], 10).0, [0]);
        assert_eq!(smallest_of(100, &[&[40, 60], &[10, 70]], 1000).0, [40, 60]);
    }

    #[test]
    fn with_few_tries_what_it_returns_still_conflicts() {
        for tries in 0..30 {
            let (found, taken) = smallest_of(100, &[&[20, 50, 90]], tries);
            assert!(taken <= tries);
            assert!([20, 50, 90].iter().all(|limit| found.contains(limit)), "{tries}: {found:?}");
        }
        assert_eq!(smallest_of(100, &[&[20, 50, 90]], 0).0.len(), 100);
        assert_eq!(smallest_of(100, &[&[20, 50, 90]], 30).0.len(), 3);
    }

    #[test]
    fn a_long_list_of_vertices_is_cut() {
        assert_eq!(vertex_list(&[7]), "vertex 7");
        assert_eq!(vertex_list(&[1, 4, 7]), "vertices 1, 4 and 7 together");
        let many: Vec<u32> = (0..100).collect();
        assert_eq!(vertex_list(&many), "vertices 0, 1, 2, 3, 4, 5, 6, 7, … (100 in all) together");
    }
}
