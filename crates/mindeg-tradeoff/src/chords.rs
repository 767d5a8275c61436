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

    /// Every chord that is not on a side. No triangle of such chords and boundary edges is
    /// flat: the edges of a flat one are all on its side, so they would be boundary edges, but
    /// three boundary edges bound a triangle only where they are the whole boundary.
    pub(crate) fn all(boundary: &Boundary) -> Self {
        let vertices = boundary.vertex_count() as usize;
        let sides = Sides::new(boundary);
        Self::new(vertices, |i, span| !sides.has_both(i, i + span))
    }

    fn flip(&mut self, i: usize, j: usize) {
        self.bits[i * self.words + j / 64] ^= 1 << (j % 64);
        self.bits[j * self.words + i / 64] ^= 1 << (i % 64);
    }

    /// Takes the chord between `i` and `j`, which is in the set, out of it.
    pub(crate) fn remove(&mut self, i: usize, j: usize) {
        self.flip(i, j);
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
