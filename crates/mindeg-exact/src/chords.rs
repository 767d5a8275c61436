//! Which vertices may be joined.

use mindeg_core::Boundary;

/// A set of edges that a triangulation may use: all boundary edges and some chords.
///
/// It is kept both as bits, to find the vertices joined to two others, and as lists by span,
/// the number of boundary edges that a chord cuts off.
#[derive(Clone, Debug)]
pub(crate) struct Chords {
    vertices: usize,
    /// 64-bit words to a vertex.
    words: usize,
    /// Bit w of vertex v: v and w may be joined.
    bits: Vec<u64>,
    /// Entry s: the lower ends of the chords from i to i + s, in ascending order.
    by_span: Vec<Vec<u32>>,
}

impl Chords {
    /// The edges for which `may_join(i, span)` holds, asked for chords only.
    pub(crate) fn new(vertices: usize, mut may_join: impl FnMut(usize, usize) -> bool) -> Self {
        let words = vertices.div_ceil(64);
        let bits = vec![0; vertices * words];
        let mut chords = Self { vertices, words, bits, by_span: vec![Vec::new(); vertices] };
        for span in 1..vertices {
            for i in 0..vertices - span {
                let is_boundary_edge = span == 1 || span == vertices - 1;
                if is_boundary_edge || may_join(i, span) {
                    chords.flip(i, i + span);
                    chords.by_span[span].push(i as u32);
                }
            }
        }
        chords
    }

    /// All chords that are not on a side. No triangle of such chords and boundary edges is
    /// flat: the edges of a flat one are all on its side, so they would be boundary edges, but
    /// three boundary edges bound a triangle only where they are the whole boundary.
    pub(crate) fn all(boundary: &Boundary) -> Self {
        let vertices = boundary.vertex_count() as usize;
        let sides = Sides::new(boundary);
        Self::new(vertices, |i, span| !sides.has_both(i, i + span))
    }

    /// Puts the edge into the set or, where it is there, takes it out.
    pub(crate) fn flip(&mut self, i: usize, j: usize) {
        self.bits[i * self.words + j / 64] ^= 1 << (j % 64);
        self.bits[j * self.words + i / 64] ^= 1 << (i % 64);
    }

    /// The lower ends of all edges of this span that the set had when it was made.
    pub(crate) fn of_span(&self, span: usize) -> &[u32] {
        &self.by_span[span]
    }

    /// How many chords there are at `vertex`.
    pub(crate) fn degree(&self, vertex: usize) -> u32 {
        let bits = &self.bits[vertex * self.words..][..self.words];
        bits.iter().map(|word| word.count_ones()).sum::<u32>() - 2
    }

    /// The vertices strictly between `i` and `j` that may be joined to both, ascending.
    pub(crate) fn apexes(&self, i: usize, j: usize) -> impl Iterator<Item = usize> + '_ {
        let row = |vertex: usize| &self.bits[vertex * self.words..][..self.words];
        let (first, last) = (i + 1, j - 1);
        let words = first / 64..=last / 64;
        let both = row(i)[words.clone()].iter().zip(&row(j)[words.clone()]);
        words.zip(both).flat_map(move |(word, (of_i, of_j))| {
            let mut bits = of_i & of_j;
            if word == first / 64 {
                bits &= u64::MAX << (first % 64);
            }
            if word == last / 64 {
                bits &= u64::MAX >> (63 - last % 64);
            }
            std::iter::from_fn(move || {
                let bit = bits.trailing_zeros() as usize;
                bits &= bits.wrapping_sub(1);
                (bit < 64).then_some(word * 64 + bit)
            })
        })
    }

    pub(crate) fn vertex_count(&self) -> usize {
        self.vertices
    }
}

/// The one or two sides that every vertex is on.
pub(crate) struct Sides {
    after: Vec<usize>,
}

impl Sides {
    pub(crate) fn new(boundary: &Boundary) -> Self {
        let sides = boundary.sides().enumerate();
        Self { after: sides.flat_map(|(side, len)| (0..len).map(move |_| side)).collect() }
    }

    /// Whether one side has both vertices.
    pub(crate) fn has_both(&self, i: usize, j: usize) -> bool {
        let of = |vertex: usize| {
            let before = vertex.checked_sub(1).unwrap_or(self.after.len() - 1);
            [self.after[before], self.after[vertex]]
        };
        of(i).iter().any(|side| of(j).contains(side))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chords_join_different_sides_and_make_no_flat_triangle() {
        for sides in [
            &[1, 1, 1][..],
            &[2, 1, 1],
            &[1, 1, 2],
            &[2, 2, 2],
            &[3, 1, 4, 1, 5],
            &[30, 5, 40],
            &[32, 1, 32, 1],
            &[10, 54, 65],
        ] {
            let boundary = Boundary::new(sides).unwrap();
            let n = boundary.vertex_count();
            let is_flat = |a, b, c| boundary.is_flat([a, b, c % n]);
            let chords = Chords::all(&boundary);
            let has = |i: u32, j: u32| chords.of_span((j - i) as usize).contains(&i);
            let mut degrees = vec![0; n as usize];
            for (i, j) in (0..n).flat_map(|i| (i + 2..n).map(move |j| (i, j))) {
                if j - i < n - 1 {
                    let is_on_side = is_flat(i, i + 1, j) || is_flat(i, j, j + 1);
                    assert_eq!(has(i, j), !is_on_side, "{sides:?}: {i}, {j}");
                    degrees[i as usize] += u32::from(!is_on_side);
                    degrees[j as usize] += u32::from(!is_on_side);
                }
                let apexes: Vec<u32> =
                    chords.apexes(i as usize, j as usize).map(|apex| apex as u32).collect();
                let expected: Vec<u32> =
                    (i + 1..j).filter(|&apex| has(i, apex) && has(apex, j)).collect();
                assert_eq!(apexes, expected, "{sides:?}: {i}, {j}");
                let is_flat = |apex| is_flat(i, apex, j);
                assert!(!has(i, j) || !apexes.into_iter().any(is_flat), "{sides:?}: {i}, {j}");
            }
            assert!((0..n as usize).all(|vertex| chords.degree(vertex) == degrees[vertex]));
        }
    }

    #[test]
    fn a_chord_taken_out_is_no_longer_met() {
        let mut chords = Chords::all(&Boundary::new(&[1, 1, 1, 1, 1]).unwrap());
        assert!(chords.apexes(0, 4).eq([1, 2, 3]));
        chords.flip(0, 2);
        assert!(chords.apexes(0, 4).eq([1, 3]));
        assert_eq!([0, 1, 2].map(|vertex| chords.degree(vertex)), [1, 2, 1]);
    }
}
