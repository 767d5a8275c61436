//! An exact solver that shares no code with the constructions, to test them.
//!
//! Interval dynamic programming over chords. A chord (i, j) cuts off the boundary from i to j. For
//! the rest of the polygon, only the number of interior edges of the cut-off side at i and at j
//! matters. So for each number of edges allowed at i, the solver stores the least number at j.
//!
//! Limits: O(n³ D) time and 8 n² (D-1) bytes for a degree D, without a guard against long times or
//! lack of memory. Use it to check the closed forms on boundaries of up to a few hundred vertices.

use mindeg_core::Boundary;

/// The least possible maximum degree: tries 2, 3, … until [`is_feasible`]. O(n³ D²).
pub(crate) fn least_max_degree(boundary: &Boundary) -> u32 {
    (2..boundary.vertex_count())
        .find(|&max_degree| is_feasible(boundary, max_degree))
        .expect("a vertex has at most n - 1 neighbours")
}

/// Whether some triangulation has no vertex of degree above `max_degree`. O(n³ D).
pub(crate) fn is_feasible(boundary: &Boundary, max_degree: u32) -> bool {
    // No vertex has more than n - 1 neighbours, so a higher limit has no effect.
    let max_degree = max_degree.min(boundary.vertex_count() - 1);
    let Some(most) = max_degree.checked_sub(2) else { return false };
    let vertices = boundary.vertex_count() as usize;
    let states = most as usize + 1;
    // For chord (i, j): entry a is the least number of edges at j if i may have a edges; neither
    // count includes the chord. None if that is impossible.
    let mut least: Vec<Option<u32>> = vec![None; vertices * vertices * states];
    let at = |i: usize, j: usize| (i * vertices + j) * states;

    for i in 0..vertices - 1 {
        least[at(i, i + 1)..][..states].fill(Some(0));
    }
    for span in 2..vertices {
        for i in 0..vertices - span {
            let j = i + span;
            for apex in i + 1..j {
                if boundary.is_flat([i as u32, apex as u32, j as u32]) {
                    continue;
                }
                let left_edge = u32::from(apex > i + 1);
                let right_edge = u32::from(j > apex + 1);
                for at_i in left_edge..=most {
                    let at_j = least[at(i, apex) + (at_i - left_edge) as usize]
                        .and_then(|at_apex| most.checked_sub(at_apex + left_edge + right_edge))
                        .and_then(|left_at_apex| least[at(apex, j) + left_at_apex as usize])
                        .map(|at_j| at_j + right_edge)
                        .filter(|&at_j| at_j <= most);
                    let best = &mut least[at(i, j) + at_i as usize];
                    *best = match (*best, at_j) {
                        (Some(a), Some(b)) => Some(a.min(b)),
                        (a, b) => a.or(b),
                    };
                }
            }
        }
    }
    least[at(0, vertices - 1) + most as usize].is_some()
}

mod tests {
    use super::*;

    /// Tries every triangulation of the polygon from `i` to `j`, without a table.
    fn every(boundary: &Boundary, i: u32, j: u32, degrees: &mut [u32]) -> u32 {
        fn go(boundary: &Boundary, chords: &mut Vec<(u32, u32)>, degrees: &mut [u32]) -> u32 {
            let Some((i, j)) = chords.pop() else {
                return degrees.iter().copied().max().unwrap_or(0);
            };
            let mut best = u32::MAX;
            if j == i + 1 {
                best = go(boundary, chords, degrees);
            }
            for apex in i + 1..j {
                if boundary.is_flat([i, apex, j]) {
                    continue;
                }
                let len = chords.len();
                for (a, b) in [(i, apex), (apex, j)] {
                    if b > a + 1 {
                        degrees[a as usize] += 1;
                        degrees[b as usize] += 1;
                    }
                    chords.push((a, b));
                }
                best = best.min(go(boundary, chords, degrees));
                chords.truncate(len);
                for (a, b) in [(i, apex), (apex, j)] {
                    if b > a + 1 {
                        degrees[a as usize] -= 1;
                        degrees[b as usize] -= 1;
                    }
                }
            }
            chords.push((i, j));
            best
        }
        go(boundary, &mut vec![(i, j)], degrees)
    }

    #[test]
    fn agrees_with_trying_every_triangulation() {
        for sides in [
            &[1, 1, 1][..],
            &[2, 1, 1],
            &[2, 2, 2],
            &[5, 2, 2],
            &[3, 3, 3],
            &[6, 1, 1, 1],
            &[3, 3, 2, 2],
            &[4, 4, 1, 1],
            &[3, 1, 1, 3, 1],
            &[2, 2, 2, 2, 2],
            &[1, 1, 1, 1, 1, 1, 1, 1],
            &[8, 1, 2],
        ] {
            let boundary = Boundary::new(sides).unwrap();
            let n = boundary.vertex_count();
            let brute = every(&boundary, 0, n - 1, &mut vec![2; n as usize]);
            assert_eq!(least_max_degree(&boundary), brute, "{sides:?}");
        }
    }

    #[test]
    fn no_triangulation_has_degree_below_two() {
        let boundary = Boundary::new(&[1, 1, 1]).unwrap();
        assert!(!is_feasible(&boundary, 1) && !is_feasible(&boundary, 0));
        assert!(is_feasible(&boundary, 2) && is_feasible(&boundary, u32::MAX));
    }
}
