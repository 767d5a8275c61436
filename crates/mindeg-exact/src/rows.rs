//! The pieces at each vertex, and the apexes between two vertices.
//!
//! A piece from i to j is in two rows: that of i, with the pieces that begin there, and that of j, with
//! those that end there. The other ends are bits, in blocks of 64 vertices, since a vertex mostly
//! sees others in runs. So the vertices that two rows have in common are found many at a time.

use crate::chords::{Chords, Lists};
use std::cmp::Ordering;
use std::ops::ControlFlow;

/// The pieces solved so far, each with a value, from short ones to long ones.
pub(crate) struct Rows<T> {
    /// The pieces that begin at a vertex, by ascending end.
    up: Half<T>,
    /// The pieces that end at a vertex, by descending begin.
    down: Half<T>,
}

struct Half<T> {
    blocks: Lists<Block>,
    values: Lists<T>,
}

/// Some of the vertices 64 * index to 64 * index + 63.
#[derive(Clone, Copy, Default)]
struct Block {
    index: u32,
    /// Where the values of this block begin in the row.
    first: u32,
    ends: u64,
}

/// The numbers of pieces and of blocks of each vertex.
struct Counts {
    pieces: Vec<u32>,
    blocks: Vec<u32>,
    /// The block of the last piece.
    last: Vec<u32>,
}

impl Counts {
    fn new(vertices: usize) -> Self {
        Self {
            pieces: vec![0; vertices],
            blocks: vec![0; vertices],
            last: vec![u32::MAX; vertices],
        }
    }

    fn add(&mut self, vertex: u32, end: u32) {
        let vertex = vertex as usize;
        self.pieces[vertex] += 1;
        if self.last[vertex] != end / 64 {
            self.last[vertex] = end / 64;
            self.blocks[vertex] += 1;
        }
    }
}

impl<T: Copy + Default> Half<T> {
    fn new(counts: &Counts) -> Self {
        Self { blocks: Lists::new(&counts.blocks), values: Lists::new(&counts.pieces) }
    }

    fn put(&mut self, vertex: u32, end: u32, value: T) {
        let first = self.values.of(vertex).len() as u32;
        self.values.push(vertex, value);
        let ends = 1 << (end % 64);
        match self.blocks.last_mut(vertex) {
            Some(block) if block.index == end / 64 => block.ends |= ends,
            _ => self.blocks.push(vertex, Block { index: end / 64, first, ends }),
        }
    }
}

impl<T: Copy + Default> Rows<T> {
    /// No pieces yet, and room for those of all these edges. O(edges).
    pub(crate) fn new(chords: &Chords) -> Self {
        let mut counts = [0, 1].map(|_| Counts::new(chords.vertex_count()));
        for [i, j] in chords.ends() {
            counts[0].add(i, j);
            counts[1].add(j, i);
        }
        let [up, down] = counts.map(|counts| Half::new(&counts));
        Self { up, down }
    }

    /// Adds a piece. The pieces of each vertex come by ascending length.
    pub(crate) fn put(&mut self, i: u32, j: u32, value: T) {
        self.up.put(i, j, value);
        self.down.put(j, i, value);
    }

    /// The longest piece that begins at a vertex: its end and its value.
    pub(crate) fn longest(&self, i: u32) -> Option<(u32, T)> {
        let block = self.up.blocks.of(i).last()?;
        Some((64 * block.index + block.ends.ilog2(), *self.up.values.of(i).last()?))
    }

    /// The value of the boundary edge that ends at a vertex.
    pub(crate) fn shortest_to(&self, j: u32) -> Option<T> {
        self.down.values.of(j).first().copied()
    }

    /// Visits the vertices between i and j that have a piece with each of them, in ascending order,
    /// with the values of these pieces, until `visit` breaks.
    pub(crate) fn meet(
        &self,
        i: u32,
        j: u32,
        mut visit: impl FnMut(u32, T, T) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let (lefts, rights) = (self.up.values.of(i), self.down.values.of(j));
        let (mut up, mut down) = (self.up.blocks.of(i), self.down.blocks.of(j));
        while let ([a, further_up @ ..], [further_down @ .., b]) = (up, down) {
            if a.index == b.index {
                let mut both = a.ends & b.ends;
                while both != 0 {
                    let end = both & both.wrapping_neg();
                    let before = (a.ends & (end - 1)).count_ones();
                    let after = (b.ends & !(end - 1) & !end).count_ones();
                    visit(
                        64 * a.index + end.trailing_zeros(),
                        lefts[(a.first + before) as usize],
                        rights[(b.first + after) as usize],
                    )?;
                    both &= both - 1;
                }
            }
            match a.index.cmp(&b.index) {
                Ordering::Equal => (up, down) = (further_up, further_down),
                Ordering::Less => up = &up[gallop(up, |block| block.index < b.index)..],
                Ordering::Greater => {
                    // Descending: the next one is the last.
                    let kept = down.partition_point(|block| block.index >= a.index);
                    down = &down[..kept];
                }
            }
        }
        ControlFlow::Continue(())
    }
}

/// The number of items at the start of a sorted list that are before another, in time logarithmic in that
/// number.
pub(crate) fn gallop<T>(sorted: &[T], is_before: impl Fn(&T) -> bool) -> usize {
    let mut step = 1;
    while step < sorted.len() && is_before(&sorted[step]) {
        step *= 2;
    }
    let from = step / 2;
    from + sorted[from..sorted.len().min(step + 1)].partition_point(is_before)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_meet_where_both_have_a_piece() {
        // Every third chord of 300 vertices, and every second piece of those.
        let n = 300_u32;
        let is_chord =
            |i: u32, j: u32| j - i == 1 || j - i == n - 1 || (i * 7 + j * 5).is_multiple_of(3);
        let of = |i: u32| (i + 1..n).filter(move |&j| j - i > 1 && j - i < n - 1 && is_chord(i, j));
        let lists: Vec<Vec<[u32; 2]>> = (0..n).map(|i| of(i).map(|j| [i, j]).collect()).collect();
        let chords = Chords::new(n as usize, &lists);
        let has = |i: u32, j: u32| is_chord(i, j) && (j - i == 1 || (i + j * 3).is_multiple_of(2));
        let mut rows = Rows::new(&chords);
        for [i, j] in chords.ends().filter(|&[i, j]| has(i, j)) {
            rows.put(i, j, [i, j]);
        }
        for (i, j) in (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j))) {
            let mut met = Vec::new();
            let flow = rows.meet(i, j, |apex, left, right| {
                assert_eq!((left, right), ([i, apex], [apex, j]));
                met.push(apex);
                if met.len() == 20 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            });
            let expected: Vec<u32> = (i + 1..j).filter(|&k| has(i, k) && has(k, j)).collect();
            assert!(met.iter().eq(expected.iter().take(20)), "{i}, {j}");
            assert_eq!(flow.is_break(), expected.len() >= 20);
        }
        for i in 0..n - 1 {
            let end = (i + 1..n).rev().find(|&j| has(i, j)).unwrap();
            assert_eq!(rows.longest(i), Some((end, [i, end])));
            assert_eq!(rows.shortest_to(i + 1), Some([i, i + 1]));
        }
        assert_eq!((rows.longest(n - 1), rows.shortest_to(0)), (None, None));
    }
}
