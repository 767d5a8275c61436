//! The edges that a triangulation may use.

use crate::progress::Stage;
use crate::sides::Sides;
use mindeg_mesh::Cancelled;
use mindeg_mesh::parallel::map_chunks;
use std::ops::Range;

/// A set of edges that a triangulation may use: all boundary edges and some chords, ordered by
/// span, the number of boundary edges that they cut off.
#[derive(Clone, Debug)]
pub(crate) struct Chords {
    vertices: usize,
    /// Where the edges of each span begin in `starts`.
    offsets: Vec<u32>,
    /// The lower ends, ascending within a span.
    starts: Vec<u32>,
}

impl Chords {
    /// The boundary edges and these chords (lower end, upper end). The lists, one after the other,
    /// are in ascending order of lower ends. O(n + chords).
    pub(crate) fn new(vertices: usize, chords: &[Vec<[u32; 2]>]) -> Self {
        let mut offsets = vec![0_u32; vertices + 1];
        for [i, j] in chords.iter().flatten() {
            offsets[(j - i) as usize + 1] += 1;
        }
        offsets[2] += vertices as u32 - 1;
        offsets[vertices] += 1;
        for span in 0..vertices {
            offsets[span + 1] += offsets[span];
        }
        let mut next = offsets.clone();
        let mut starts = vec![0; offsets[vertices] as usize];
        let mut put = |i: u32, span: usize| {
            starts[next[span] as usize] = i;
            next[span] += 1;
        };
        (0..vertices as u32 - 1).for_each(|i| put(i, 1));
        put(0, vertices - 1);
        for &[i, j] in chords.iter().flatten() {
            put(i, (j - i) as usize);
        }
        Self { vertices, offsets, starts }
    }

    /// All chords of a convex polygon that are not on a side. No triangle of such chords and
    /// boundary edges is flat: the edges of a flat one are all on its side, so they would be
    /// boundary edges, but three boundary edges bound a triangle only where they are the whole
    /// boundary.
    pub(crate) fn all(vertices: usize, sides: &Sides) -> Self {
        let n = vertices as u32;
        let of = |i: u32| {
            let last = if i == 0 { n - 1 } else { n };
            let ends = (i + 2..last).filter(move |&j| !sides.has_both(i, j));
            ends.map(|j| [i, j]).collect()
        };
        Self::new(vertices, &(0..n).map(of).collect::<Vec<_>>())
    }

    /// The edges that are kept, boundary edges included.
    pub(crate) fn filtered(&self, is_kept: impl Fn(u32, u32) -> bool) -> Self {
        let mut kept = Self {
            vertices: self.vertices,
            offsets: Vec::with_capacity(self.offsets.len()),
            starts: Vec::new(),
        };
        kept.offsets.push(0);
        for span in 0..self.vertices {
            let is_boundary = span == 1 || span == self.vertices - 1;
            let starts = self.of_span(span).iter().copied();
            kept.starts.extend(starts.filter(|&i| is_boundary || is_kept(i, i + span as u32)));
            kept.offsets.push(kept.starts.len() as u32);
        }
        kept
    }

    pub(crate) fn vertex_count(&self) -> usize {
        self.vertices
    }

    /// The number of edges, boundary edges included.
    pub(crate) fn len(&self) -> usize {
        self.starts.len()
    }

    /// The indices of the edges of this span.
    pub(crate) fn indices(&self, span: usize) -> Range<usize> {
        self.offsets[span] as usize..self.offsets[span + 1] as usize
    }

    /// The lower ends of the edges of this span, ascending.
    pub(crate) fn of_span(&self, span: usize) -> &[u32] {
        &self.starts[self.indices(span)]
    }

    /// The ends of all edges, in order.
    pub(crate) fn ends(&self) -> impl Iterator<Item = [u32; 2]> + Clone + '_ {
        (1..self.vertices)
            .flat_map(|span| self.of_span(span).iter().map(move |&i| [i, i + span as u32]))
    }

    /// Whether the set has this edge; i < j. O(log n).
    #[cfg(test)]
    pub(crate) fn has(&self, i: u32, j: u32) -> bool {
        self.of_span((j - i) as usize).binary_search(&i).is_ok()
    }

    /// The number of triples i < k < j with all three edges, the work of one pass of the dynamic
    /// program; `None` if it is more than `most`. O(triples), in parallel.
    pub(crate) fn count_triples(
        &self,
        most: u64,
        stage: &Stage<'_>,
    ) -> Result<Option<u64>, Cancelled> {
        const CHUNK: usize = 64;
        const ROUND: usize = 16 * CHUNK;
        let [counts, _] = self.end_counts();
        let mut up = Lists::new(&counts);
        self.ends().for_each(|[i, j]| up.push(i, j));
        let count = |starts: Range<usize>| {
            let mut marks = vec![0_u8; self.vertices];
            let mut count = 0;
            for i in starts.start as u32..starts.end as u32 {
                up.of(i).iter().for_each(|&j| marks[j as usize] = 1);
                let last = up.of(i).last().copied().unwrap_or(0);
                for &k in up.of(i) {
                    let ends = up.of(k);
                    let ends = &ends[..ends.partition_point(|&j| j <= last)];
                    count += ends.iter().map(|&j| u64::from(marks[j as usize])).sum::<u64>();
                }
                up.of(i).iter().for_each(|&j| marks[j as usize] = 0);
            }
            count
        };
        let mut total = 0;
        // In rounds, so that too many triples end it early.
        for round in (0..self.vertices).step_by(ROUND) {
            stage.report(round as f64 / self.vertices as f64)?;
            let counts = map_chunks(round..self.vertices.min(round + ROUND), CHUNK, count);
            total += counts.iter().sum::<u64>();
            if total > most {
                return Ok(None);
            }
        }
        Ok(Some(total))
    }

    /// The number of chords at each vertex, without boundary edges.
    pub(crate) fn degrees(&self) -> Vec<u32> {
        let mut degrees = vec![0_u32; self.vertices];
        for [i, j] in self.ends() {
            degrees[i as usize] += 1;
            degrees[j as usize] += 1;
        }
        degrees.iter().map(|degree| degree - 2).collect()
    }

    /// For each vertex the number of edges with it as lower end, and as upper end.
    pub(crate) fn end_counts(&self) -> [Vec<u32>; 2] {
        let mut counts = [vec![0; self.vertices], vec![0; self.vertices]];
        for [i, j] in self.ends() {
            counts[0][i as usize] += 1;
            counts[1][j as usize] += 1;
        }
        counts
    }
}

/// One list for each vertex, in memory allocated at once.
#[derive(Clone, Debug)]
pub(crate) struct Lists<T> {
    offsets: Vec<u32>,
    lens: Vec<u32>,
    entries: Vec<T>,
}

impl<T: Copy + Default> Lists<T> {
    pub(crate) fn new(most: &[u32]) -> Self {
        let mut total = 0;
        let mut offsets = Vec::with_capacity(most.len());
        for most in most {
            offsets.push(total);
            total += most;
        }
        Self { offsets, lens: vec![0; most.len()], entries: vec![T::default(); total as usize] }
    }

    pub(crate) fn push(&mut self, vertex: u32, entry: T) {
        let len = &mut self.lens[vertex as usize];
        self.entries[(self.offsets[vertex as usize] + *len) as usize] = entry;
        *len += 1;
    }

    pub(crate) fn of(&self, vertex: u32) -> &[T] {
        &self.entries[self.offsets[vertex as usize] as usize..]
            [..self.lens[vertex as usize] as usize]
    }

    /// Puts the entries of every vertex in ascending order.
    pub(crate) fn sort(&mut self)
    where
        T: Ord,
    {
        for (&start, &len) in self.offsets.iter().zip(&self.lens) {
            self.entries[start as usize..][..len as usize].sort_unstable();
        }
    }

    pub(crate) fn last_mut(&mut self, vertex: u32) -> Option<&mut T> {
        let last = self.lens[vertex as usize].checked_sub(1)?;
        self.entries.get_mut((self.offsets[vertex as usize] + last) as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg_core::Boundary;

    #[test]
    fn chords_join_different_sides_and_make_no_flat_triangle() {
        for sides in
            [&[1, 1, 1][..], &[2, 1, 1], &[1, 1, 2], &[2, 2, 2], &[3, 1, 4, 1, 5], &[30, 5, 40]]
        {
            let boundary = Boundary::new(sides).unwrap();
            let n = boundary.vertex_count();
            let is_flat = |a, b, c| boundary.is_flat([a, b, c % n]);
            let chords = Chords::all(n as usize, &Sides::of_boundary(&boundary));
            let mut degrees = vec![0; n as usize];
            for (i, j) in (0..n).flat_map(|i| (i + 2..n).map(move |j| (i, j))) {
                if j - i < n - 1 {
                    let is_on_side = is_flat(i, i + 1, j) || is_flat(i, j, j + 1);
                    assert_eq!(chords.has(i, j), !is_on_side, "{sides:?}: {i}, {j}");
                    degrees[i as usize] += u32::from(!is_on_side);
                    degrees[j as usize] += u32::from(!is_on_side);
                }
                let may_be_apex =
                    |&apex: &u32| chords.has(i, j) && chords.has(i, apex) && chords.has(apex, j);
                let mut apexes = (i + 1..j).filter(may_be_apex);
                assert!(!apexes.any(|apex| is_flat(i, apex, j)), "{sides:?}: {i}, {j}");
            }
            assert!((0..n).all(|i| (i + 1..n).all(|j| j - i > 1 || chords.has(i, j))));
            assert_eq!(chords.degrees(), degrees);
            let kept = chords.filtered(|i, _| i > 0);
            let is_kept = |i, j| i > 0 || j == 1 || j == n - 1;
            assert!(chords.ends().all(|[i, j]| kept.has(i, j) == is_kept(i, j)));
        }
    }
}
