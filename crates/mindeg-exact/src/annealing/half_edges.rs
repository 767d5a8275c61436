//! The triangles of several faces as half-edges: a chord keeps its numbers while flips turn it, so that a random
//! chord is drawn without a look at boundary edges.

use crate::linked::{Linked, NONE};
use mindeg_mesh::parallel::sort_all;

/// The half-edges of several faces, one face after another.
pub(super) struct HalfEdges {
    /// For each half-edge the place where it begins, the next one of its triangle, and that of the triangle beyond.
    places: Vec<u32>,
    next: Vec<u32>,
    twins: Vec<u32>,
    /// Where the half-edges of each face begin, and where all end.
    starts: Vec<u32>,
}

impl HalfEdges {
    /// The places of a face are counted from its number in `first_places` on.
    pub(super) fn new(faces: &[Linked], first_places: &[u32]) -> Self {
        let mut all =
            Self { places: Vec::new(), next: Vec::new(), twins: Vec::new(), starts: vec![0] };
        for (mesh, first_place) in faces.iter().zip(first_places) {
            let start = all.places.len() as u32;
            for (triangle, corners) in (0..).zip(&mesh.triangles) {
                let first = start + 3 * triangle;
                for edge in 0..3 {
                    let beyond = mesh.neighbours[triangle as usize][edge];
                    let twin = || {
                        let (at, _) = mesh.enter(beyond, corners[(edge + 1) % 3]);
                        start + 3 * beyond + at as u32
                    };
                    all.places.push(first_place + corners[edge]);
                    all.next.push(first + (edge as u32 + 1) % 3);
                    all.twins.push(if beyond == NONE { NONE } else { twin() });
                }
            }
            all.starts.push(all.places.len() as u32);
        }
        all
    }

    /// One half-edge of each chord, with its face.
    pub(super) fn chords(&self) -> Vec<[u32; 2]> {
        let of_face = |(face, ends): (u32, &[u32])| {
            let is_first = |half: &u32| {
                let twin = self.twins[*half as usize];
                twin != NONE && twin > *half
            };
            (ends[0]..ends[1]).filter(is_first).map(move |half| [half, face])
        };
        (0..).zip(self.starts.windows(2)).flat_map(of_face).collect()
    }

    /// The places at a chord: its ends a and b, and the corners c and d opposite it, of its own triangle and of that beyond.
    pub(super) fn corners_at(&self, half: u32) -> [u32; 4] {
        let twin = self.twins[half as usize];
        let opposite = |half: u32| self.places[self.before(half) as usize];
        let [a, b] = [half, twin].map(|half| self.places[half as usize]);
        [a, b, opposite(half), opposite(twin)]
    }

    /// Turns a chord into the other diagonal of its quadrilateral.
    pub(super) fn flip(&mut self, half: u32) {
        let twin = self.twins[half as usize];
        let [_, _, c, d] = self.corners_at(half);
        let [after, before] = [self.next[half as usize], self.before(half)];
        let [twin_after, twin_before] = [self.next[twin as usize], self.before(twin)];
        self.places[half as usize] = d;
        self.places[twin as usize] = c;
        for triangle in [[half, before, twin_after], [twin, twin_before, after]] {
            (0..3).for_each(|at| self.next[triangle[at] as usize] = triangle[(at + 1) % 3]);
        }
    }

    fn before(&self, half: u32) -> u32 {
        self.next[self.next[half as usize] as usize]
    }

    /// The triangles of each face, whose places are counted as in [`new`](Self::new).
    pub(super) fn triangles(&self, first_places: &[u32]) -> Vec<Vec<[u32; 3]>> {
        let of_face = |(ends, &first_place): (&[u32], &u32)| {
            let is_first = |half: &u32| {
                let after = self.next[*half as usize];
                *half < after && *half < self.next[after as usize]
            };
            let corners = |half: u32| {
                let after = self.next[half as usize];
                let halves = [half, after, self.next[after as usize]];
                halves.map(|half| self.places[half as usize] - first_place)
            };
            let mut own: Vec<[u32; 3]> = (ends[0]..ends[1]).filter(is_first).map(corners).collect();
            sort_all(&mut own);
            own
        };
        self.starts.windows(2).zip(first_places).map(of_face).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chord_turns_and_turns_back() {
        let square = || Linked::new(vec![[0, 1, 2], [0, 2, 3]]).unwrap();
        let five = Linked::new(vec![[0, 1, 2], [0, 2, 3], [0, 3, 4]]).unwrap();
        let firsts = [0, 4];
        let mut halves = HalfEdges::new(&[square(), five.clone()], &firsts);
        let chords = halves.chords();
        assert_eq!(chords.iter().map(|chord| chord[1]).collect::<Vec<_>>(), [0, 1, 1]);
        assert_eq!(halves.triangles(&firsts), [square().triangles, five.triangles.clone()]);
        assert_eq!(halves.corners_at(chords[1][0]), [6, 4, 5, 7]);
        halves.flip(chords[1][0]);
        halves.flip(chords[0][0]);
        assert_eq!(halves.corners_at(chords[1][0]), [7, 5, 6, 4]);
        // The other chord of the five has a new neighbour.
        assert_eq!(halves.corners_at(chords[2][0]), [7, 4, 5, 8]);
        let [first, second] = [0, 1].map(|face| halves.triangles(&firsts)[face].clone());
        assert_eq!(Linked::new(first).unwrap().boundary_edges().count(), 4);
        assert_eq!(second.len(), 3);
        assert_eq!(Linked::new(second).unwrap().boundary_edges().count(), 5);
        (0..3).for_each(|_| halves.flip(chords[1][0]));
        halves.flip(chords[0][0]);
        let turned = |triangles: &[[u32; 3]]| -> Vec<[u32; 3]> {
            let least = |it: &[u32; 3]| (0..3).min_by_key(|&at| it[at]).unwrap();
            let turned = |it: &[u32; 3]| std::array::from_fn(|at| it[(at + least(it)) % 3]);
            let mut turned: Vec<[u32; 3]> = triangles.iter().map(turned).collect();
            turned.sort_unstable();
            turned
        };
        let back = halves.triangles(&firsts);
        assert_eq!(turned(&back[0]), square().triangles);
        assert_eq!(turned(&back[1]), five.triangles);
    }
}
