//! The fronts of all pieces of a polygon, and the triangulations that their states stand for.

use crate::chords::Chords;
use crate::rows::Rows;
use std::ops::ControlFlow;

/// For each piece its front: the states of the triangulations that no other one beats. The pieces come by
/// ascending length.
pub(crate) struct Fronts<S> {
    vertices: usize,
    /// The fronts, one after the other.
    states: Vec<S>,
    /// Where the front of each piece begins, and its length.
    pieces: Rows<[u32; 2]>,
}

impl<S: Copy> Fronts<S> {
    /// The boundary edges, each with this state; space for the pieces of all these edges.
    pub(crate) fn new(chords: &Chords, edge: S) -> Self {
        let vertices = chords.vertex_count();
        let mut pieces = Rows::new(chords);
        for i in 0..vertices as u32 - 1 {
            pieces.put(i, i + 1, [0, 1]);
        }
        Self { vertices, states: vec![edge], pieces }
    }

    /// Adds a piece whose states `append` pushes; a piece without states has no triangulation.
    pub(crate) fn put(&mut self, [i, j]: [usize; 2], append: impl FnOnce(&mut Vec<S>)) {
        let start = self.states.len();
        append(&mut self.states);
        let len = self.states.len() - start;
        if len > 0 {
            self.pieces.put(i as u32, j as u32, [start as u32, len as u32]);
        }
    }

    fn of(&self, [start, len]: [u32; 2]) -> &[S] {
        &self.states[start as usize..][..len as usize]
    }

    /// Visits the apexes between two vertices that have a piece with each of them, ascending, with the
    /// fronts of these pieces, until `visit` breaks.
    pub(crate) fn meet(
        &self,
        [i, j]: [usize; 2],
        mut visit: impl FnMut(usize, [&[S]; 2]) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        self.pieces.meet(i as u32, j as u32, |apex, left, right| {
            visit(apex as usize, [self.of(left), self.of(right)])
        })
    }

    /// The fronts beside apex j - 1 of the piece (i, j), if it is one.
    pub(crate) fn before_last(&self, [i, j]: [usize; 2]) -> Option<[&[S]; 2]> {
        let (apex, left) = self.pieces.longest(i as u32)?;
        let right = self.pieces.shortest_to(j as u32)?;
        (apex as usize == j - 1).then(|| [self.of(left), self.of(right)])
    }

    /// The front of the whole polygon, the piece of the boundary edge (0, n-1).
    pub(crate) fn whole(&self) -> &[S] {
        match self.pieces.longest(0) {
            Some((end, whole)) if end as usize == self.vertices - 1 => self.of(whole),
            _ => &[],
        }
    }
}

/// The n - 2 triangles of a triangulation, each before those beneath it: `split` gives the apex of the piece
/// between two vertices, and the states of the pieces beside it.
pub(crate) fn unfold<S>(
    vertices: usize,
    whole: S,
    mut split: impl FnMut([usize; 2], S) -> Option<(usize, [S; 2])>,
) -> Vec<[u32; 3]> {
    let mut triangles = Vec::with_capacity(vertices - 2);
    let mut open = vec![([0, vertices - 1], whole)];
    while let Some(([i, j], state)) = open.pop() {
        if j == i + 1 {
            continue;
        }
        let (apex, [left, right]) =
            split([i, j], state).expect("a state of a piece comes from one of its apexes");
        triangles.push([i, apex, j].map(|vertex| vertex as u32));
        open.extend([([apex, j], right), ([i, apex], left)]);
    }
    triangles
}
