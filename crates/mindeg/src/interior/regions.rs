//! The groups of a mesh whose edges between groups are kept: told from these edges alone.

use std::collections::{BTreeMap, VecDeque};

/// The edges between triangles of different groups, each once, in ascending order.
pub(super) fn interfaces(triangles: &[[u32; 3]], group: impl Fn(usize) -> usize) -> Vec<[u32; 2]> {
    let mut halves: Vec<([u32; 2], usize)> = triangles
        .iter()
        .enumerate()
        .flat_map(|(index, triangle)| edges(*triangle).map(|edge| (sorted(edge), group(index))))
        .collect();
    halves.sort_unstable();
    let mut found: Vec<[u32; 2]> = halves
        .windows(2)
        .filter(|pair| pair[0].0 == pair[1].0 && pair[0].1 != pair[1].1)
        .map(|pair| pair[0].0)
        .collect();
    found.dedup();
    found
}

/// The group of each triangle, told from edges that are known to have one on their left: what can
/// be reached from such an edge without crossing another is of its group.
pub(super) fn spread(triangles: &[[u32; 3]], known: &BTreeMap<[u32; 2], usize>) -> Vec<usize> {
    let mut left = BTreeMap::new();
    for (index, triangle) in triangles.iter().enumerate() {
        left.extend(edges(*triangle).map(|edge| (edge, index)));
    }
    let mut group = vec![usize::MAX; triangles.len()];
    let mut queue = VecDeque::new();
    for (edge, of) in known {
        if let Some(&index) = left.get(edge) {
            group[index] = *of;
            queue.push_back(index);
        }
    }
    while let Some(index) = queue.pop_front() {
        for [a, b] in edges(triangles[index]) {
            if known.contains_key(&[a, b]) {
                continue;
            }
            if let Some(&other) = left.get(&[b, a])
                && group[other] == usize::MAX
            {
                group[other] = group[index];
                queue.push_back(other);
            }
        }
    }
    group
}

/// A triangle's edges, the triangle on the left of each.
pub(super) fn edges([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

fn sorted([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_spread_up_to_known_edges() {
        // A strip of four triangles; two groups of two.
        let before = [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]];
        assert_eq!(interfaces(&before, |t| t / 2), [[2, 3]]);
        assert_eq!(interfaces(&before, |_| 0), [] as [[u32; 2]; 0]);
        // The same with the diagonals turned.
        let after = [[0, 1, 3], [0, 3, 2], [2, 3, 5], [2, 5, 4]];
        let known = [([3, 2], 0), ([2, 3], 1), ([0, 1], 0), ([5, 4], 1)].into();
        assert_eq!(spread(&after, &known), [0, 0, 1, 1]);
    }
}
