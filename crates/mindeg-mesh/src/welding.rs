//! Merges vertices that a file repeats at one point in space.

use crate::connectivity::disjoint_sets::DisjointSets;
use crate::parallel::sort_all;
use crate::tri_mesh::TriMesh;
use glam::DVec3;

/// For each vertex, the vertex of lowest index that it is merged with (itself if not merged).
///
/// Two vertices are merged if they are no farther apart than `tolerance`, or if a chain of such
/// pairs joins them; at a tolerance of 0, if their coordinates are equal as numbers. O(n log n),
/// shared by all threads, as long as `tolerance` is 0 or more than 1e-11 of the largest coordinate;
/// below that, add O(m²) for m different positions within 1e-12 of it.
///
/// # Example
///
/// ```
/// use glam::DVec3;
/// use mindeg_mesh::weld;
///
/// assert_eq!(weld(&[DVec3::X, DVec3::Y, DVec3::X], 0.0), [0, 1, 0]);
/// ```
pub fn weld(positions: &[DVec3], tolerance: f64) -> Vec<u32> {
    let mut first = first_at_same_position(positions);
    if tolerance > 0.0 {
        let mut sets = DisjointSets::new(positions.len());
        let different = (0..).zip(&first).filter(|&(vertex, &first)| vertex == first);
        let different = different.map(|(vertex, _)| vertex).collect();
        Grid::new(positions, different, tolerance).join_near(&mut sets);
        first.iter_mut().for_each(|first| *first = sets.least(*first));
    }
    first
}

impl TriMesh {
    /// The triangles alone, between the vertices that [`weld`] merges theirs with; vertices keep their indices.
    #[must_use]
    pub fn welded(&self, tolerance: f64) -> Self {
        let first = weld(self.positions(), tolerance);
        let triangles = self.triangles().iter().map(|t| t.map(|v| first[v as usize])).collect();
        Self::new(self.positions().to_vec(), triangles)
            .expect("the positions and the number of triangles are those of a mesh")
    }
}

/// For every vertex the first with equal coordinates; -0 equals 0. O(n log n), shared by all
/// threads.
fn first_at_same_position(positions: &[DVec3]) -> Vec<u32> {
    // Adding zero turns -0 into 0, so that equal numbers have equal bits.
    let bits = |position: DVec3| (position + DVec3::ZERO).to_array().map(f64::to_bits);
    let mut vertices: Vec<_> = (0_u32..).zip(positions).map(|(v, &p)| (bits(p), v)).collect();
    sort_all(&mut vertices);
    let mut first = vec![0; positions.len()];
    for same in vertices.chunk_by(|a, b| a.0 == b.0) {
        for &(_, vertex) in same {
            first[vertex as usize] = same[0].1;
        }
    }
    first
}

/// Some vertices in the cubes of a grid.
struct Grid<'a> {
    positions: &'a [DVec3],
    tolerance: f64,
    /// Whether all vertices of a cube are within the tolerance of each other.
    is_fine: bool,
    /// The cube of each vertex, in the order of cubes, then vertices.
    vertices: Vec<([i64; 3], u32)>,
}

impl<'a> Grid<'a> {
    fn new(positions: &'a [DVec3], vertices: Vec<u32>, tolerance: f64) -> Self {
        let largest = positions.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
        // The diagonal of a cube is less than the tolerance. But if coordinates have more than 2^40
        // cubes, rounding would decide the cube of a vertex.
        let fine = tolerance / 1.75;
        let side = fine.max(libm::ldexp(largest, -40));
        let cube = |vertex: u32| {
            positions[vertex as usize].to_array().map(|x| libm::floor(x / side) as i64)
        };
        let mut vertices: Vec<_> = vertices.into_iter().map(|v| (cube(v), v)).collect();
        sort_all(&mut vertices);
        Self { positions, tolerance, is_fine: side == fine, vertices }
    }

    /// Joins vertices that are no farther apart than the tolerance, directly or through others.
    fn join_near(&self, sets: &mut DisjointSets) {
        // The cubes at most two away that follow in the order of x, y and z. Cubes with the same x
        // and y follow one another.
        const ROWS: [[i64; 2]; 12] = [
            [0, 1],
            [0, 2],
            [1, -2],
            [1, -1],
            [1, 0],
            [1, 1],
            [1, 2],
            [2, -2],
            [2, -1],
            [2, 0],
            [2, 1],
            [2, 2],
        ];
        let cubes: Vec<&[([i64; 3], u32)]> =
            self.vertices.chunk_by(|(a, _), (b, _)| a == b).collect();
        let cube_at = |index: usize| cubes.get(index).map(|cube| cube[0].0);
        let mut row_starts = [0; ROWS.len()];
        for (index, &cube) in cubes.iter().enumerate() {
            let [x, y, z] = cube[0].0;
            self.join_within(cube, sets);
            let own_row = [([x, y], index + 1)];
            let rows = ROWS.iter().zip(&mut row_starts).map(|([dx, dy], start)| {
                let row = [x + dx, y + dy];
                // Cubes come in order, and so do their rows.
                while cube_at(*start).is_some_and(|cube| cube < [row[0], row[1], z - 2]) {
                    *start += 1;
                }
                (row, *start)
            });
            for ([x, y], start) in own_row.into_iter().chain(rows) {
                let in_reach = |cube: &[i64; 3]| *cube <= [x, y, z + 2];
                for near in (start..).map_while(|i| cube_at(i).filter(in_reach).map(|_| cubes[i])) {
                    self.join_between(cube, near, sets);
                }
            }
        }
    }

    fn join_within(&self, cube: &[([i64; 3], u32)], sets: &mut DisjointSets) {
        for (i, &(_, a)) in cube.iter().enumerate() {
            if self.is_fine {
                sets.join(cube[0].1, a);
            } else {
                cube[..i]
                    .iter()
                    .filter(|&&(_, b)| self.is_near(a, b))
                    .for_each(|&(_, b)| sets.join(a, b));
            }
        }
    }

    fn join_between(
        &self,
        cube: &[([i64; 3], u32)],
        near: &[([i64; 3], u32)],
        sets: &mut DisjointSets,
    ) {
        if self.is_fine && sets.least(cube[0].1) == sets.least(near[0].1) {
            return;
        }
        for &(_, a) in cube {
            for &(_, b) in near.iter().filter(|&&(_, b)| self.is_near(a, b)) {
                sets.join(a, b);
                if self.is_fine {
                    return;
                }
            }
        }
    }

    fn is_near(&self, a: u32, b: u32) -> bool {
        let [a, b] = [a, b].map(|vertex| self.positions[vertex as usize]);
        // A power of two that keeps the squares of all lengths in range changes no digit.
        let scale = libm::ldexp(1.0, -libm::frexp(self.tolerance).1.clamp(-1000, 1000));
        ((a - b) * scale).length() <= self.tolerance * scale
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

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
            assert_eq!(weld(positions, 0.0), expected, "{positions:?}");
        }
    }

    #[test]
    fn chains_of_near_vertices_become_one() {
        let line = |xs: &[f64]| xs.iter().map(|&x| DVec3::new(x, 7.0, -x)).collect::<Vec<_>>();
        for (xs, tolerance, expected) in [
            (&[0.0, 3.0, 1.0, 2.0][..], 1.5, &[0, 0, 0, 0][..]),
            (&[0.0, 3.0, 1.0, 2.0], 1.4, &[0, 1, 2, 3]),
            (&[5.0, 0.0, 1.0, 4.0], 1.5, &[0, 1, 1, 0]),
            (&[1.0, 1.0 + 2e-16, 1.0 + 4e-16], 1e-15, &[0, 0, 0]),
            (&[1e300, 1.0, 2.0], 1.0, &[0, 1, 2]),
            (&[1e300, -1e300, 2e299], f64::MAX, &[0, 0, 0]),
            (&[1e-300, 2e-300, 4e-300], 1.5e-300, &[0, 0, 2]),
        ] {
            assert_eq!(weld(&line(xs), tolerance), expected, "{xs:?} {tolerance}");
        }
    }

    /// The definition, by trying all pairs until nothing changes.
    fn plain(positions: &[DVec3], tolerance: f64) -> Vec<u32> {
        let mut first: Vec<u32> = (0..).take(positions.len()).collect();
        loop {
            let before = first.clone();
            for (a, &p) in positions.iter().enumerate() {
                for (b, &q) in positions.iter().enumerate() {
                    if (p - q).length() <= tolerance {
                        first[a] = first[a].min(first[b]);
                    }
                }
            }
            if first == before {
                return first;
            }
        }
    }

    proptest! {
        /// Points of a lattice, slightly moved, at distances below, at and above the tolerance.
        #[test]
        fn welds_as_defined(
            points in prop::collection::vec(prop::array::uniform3(-6..6_i32), 1..60),
            moved in prop::collection::vec(prop::array::uniform3(-0.2..0.2_f64), 60),
            tolerance in prop_oneof![Just(0.3), Just(1.0), 0.1..5.0],
            scale in prop_oneof![Just(1.0), Just(1e-9), Just(1e-13), Just(1e12)],
            origin in prop_oneof![Just(0.0), Just(1.0)],
        ) {
            let position = |(p, m): (&[i32; 3], &[f64; 3])| {
                (DVec3::from(p.map(f64::from)) + DVec3::from(*m)) * scale + origin
            };
            let positions: Vec<DVec3> = points.iter().zip(&moved).map(position).collect();
            let tolerance = tolerance * scale;
            prop_assert_eq!(weld(&positions, tolerance), plain(&positions, tolerance));
        }
    }
}
