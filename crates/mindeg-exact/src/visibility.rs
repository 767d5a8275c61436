//! Finds vertices that see each other: triangular expansion through a triangulation, exact.
//!
//! Vertex w is visible from v when the open segment between them is in the open interior. A
//! segment that touches a vertex or runs along the boundary is not a chord: as an edge it would
//! pass a vertex. From v the view is a cone, and every edge that it crosses narrows it; the strict
//! signs of [`orientation`] decide where it touches, and [`passes`] what is as good as touched.
//!
//! ```text
//!        L  w        v looks through the edge (r, l) at the third corner w.
//!        \ /|        left of R and right of L: w is visible, and splits the cone;
//!     l---*-+-r      else one of the two edges at w is out of sight.
//!       \ | /
//!         v
//! ```

use crate::chords::Chords;
use crate::hulls::{Hulls, Which};
use crate::linked::{Corners, Linked, NONE};
use crate::progress::Stage;
use crate::sides::Sides;
use glam::DVec2;
use mindeg_mesh::Cancelled;
use mindeg_mesh::parallel::map_chunks;
use mindeg_mesh::planar::{orientation, passes};
use std::ops::Range;

/// The view through one edge.
struct View {
    triangle: u32,
    /// The ends of the edge, right and left as seen from the eye.
    right: u32,
    left: u32,
    /// The vertices that limit the cone.
    right_limit: u32,
    left_limit: u32,
}

/// Finds the vertices that a vertex sees; reuses its memory.
pub(crate) struct Eye<'a> {
    open: Vec<View>,
    /// With a polygon's ring it passes over many triangles at once.
    ring: Option<&'a Ring<'a>>,
    /// The field `clear` of [`Sides`].
    clear: Option<f64>,
}

/// The ring 0, 1, 2, … of a polygon, where the vertices beyond an edge follow each other.
pub(crate) struct Ring<'a> {
    mesh: &'a Linked,
    hulls: Hulls<'a>,
    /// The corners at each vertex counter-clockwise.
    corners: Corners,
}

impl<'a> Ring<'a> {
    fn new(mesh: &'a Linked, points: &'a [DVec2]) -> Self {
        let count = points.len();
        let mut corners = Corners::new(count, &mesh.triangles);
        corners.sort_by_key(mesh, |vertex, next| after(vertex, next, count));
        Self { mesh, hulls: Hulls::new(points), corners }
    }

    /// Goes on with a view past triangles with no corner in the cone, whose vertices are all on one side
    /// of it; false if nothing more can be seen.
    fn skip(&self, points: &[DVec2], eye: DVec2, view: &mut View) -> bool {
        let View { right, left, .. } = *view;
        let [right_limit, left_limit] =
            [view.right_limit, view.left_limit].map(|limit| points[limit as usize]);
        let beyond = right + 1..left;
        let first = self.hulls.left_of([eye, right_limit], beyond.clone(), Which::First);
        let last = self.hulls.left_of([left_limit, eye], beyond, Which::Last);
        let (Some(first), Some(last)) = (first, last) else { return false };
        // All others are beside the cone, and so are the triangles at an end of the edge that have none but
        // these: the view passes from one to the next.
        let count = points.len();
        if after(right, first, count) > after(right, last, count) {
            return false;
        }
        let fan = self.corners.of(right);
        let is_short = |&corner: &u32| {
            let [_, end] = self.mesh.beside(corner);
            after(right, end, count) <= after(right, last, count)
        };
        let corner = fan[fan.partition_point(is_short)];
        let [_, end] = self.mesh.beside(corner);
        if end != left {
            (view.triangle, view.left) = (corner / 3, end);
            return true;
        }
        let fan = self.corners.of(left);
        let is_before = |&corner: &u32| {
            let [start, _] = self.mesh.beside(corner);
            after(left, start, count) < after(left, first, count)
        };
        let corner = fan[fan.partition_point(is_before) - 1];
        let [start, _] = self.mesh.beside(corner);
        (view.triangle, view.right) = (corner / 3, start);
        true
    }
}

/// How many vertices of a ring a vertex comes after another.
fn after(from: u32, to: u32, count: usize) -> u32 {
    if to >= from { to - from } else { to + count as u32 - from }
}

impl<'a> Eye<'a> {
    /// An eye that sees past no vertex that a chord may not pass.
    pub(crate) fn new(sides: &Sides, ring: Option<&'a Ring<'a>>) -> Self {
        Self { open: Vec::new(), ring, clear: sides.clear }
    }

    /// The views from one look at the whole ring to the next: about what that takes.
    const PATIENCE: u32 = if cfg!(test) { 2 } else { 32 };

    /// Visits every vertex, once, that corner `corner` (3 * triangle + corner) sees through its
    /// triangle: the last corner of the triangle unless it is a boundary neighbour, and all that is
    /// visible through the opposite edge. All corners of a vertex together visit each vertex that
    /// it sees, without its boundary neighbours. O(triangles seen).
    pub(crate) fn look(
        &mut self,
        mesh: &Linked,
        points: &[DVec2],
        corner: u32,
        mut visit: impl FnMut(u32),
    ) {
        let (triangle, at) = (corner as usize / 3, corner as usize % 3);
        let corners = mesh.triangles[triangle];
        let [eye, right, left] = [corners[at], corners[(at + 1) % 3], corners[(at + 2) % 3]];
        if mesh.neighbours[triangle][(at + 2) % 3] != NONE {
            visit(left);
        }
        let at_eye = points[eye as usize];
        let turn = |a: u32, b: u32| orientation(at_eye, points[a as usize], points[b as usize]);
        let beyond = mesh.neighbours[triangle][(at + 1) % 3];
        if beyond != NONE {
            let (right_limit, left_limit) = (right, left);
            self.open.push(View { triangle: beyond, right, left, right_limit, left_limit });
        }
        let mut views = 0;
        while let Some(View { triangle, right, left, right_limit, left_limit }) = self.open.pop() {
            views += 1;
            let mut view = View { triangle, right, left, right_limit, left_limit };
            if let Some(ring) = self.ring
                && views % Self::PATIENCE == 0
                && !ring.skip(points, at_eye, &mut view)
            {
                continue;
            }
            let View { triangle, right, left, right_limit, left_limit } = view;
            let (edge, apex) = mesh.enter(triangle, left);
            let is_left_of_right = turn(right_limit, apex) > 0.0;
            let is_right_of_left = turn(apex, left_limit) > 0.0;
            if is_left_of_right && is_right_of_left {
                // Few chords come so near to a vertex that it takes a look at all of them.
                let is_near = |limit: u32| {
                    let [a, b] = [limit, apex].map(|vertex| points[vertex as usize] - at_eye);
                    self.clear.is_some_and(|angle| a.perp_dot(b).abs() <= angle * a.dot(b))
                };
                let may_pass = is_near(right_limit) || is_near(left_limit);
                if !may_pass || sees_from(mesh, points, corner, apex, true, &mut 0) {
                    visit(apex);
                }
            }
            let neighbours = &mesh.neighbours[triangle as usize];
            let over_right = neighbours[(edge + 1) % 3];
            if is_left_of_right && over_right != NONE {
                let left_limit = if is_right_of_left { apex } else { left_limit };
                let view =
                    View { triangle: over_right, right, left: apex, right_limit, left_limit };
                self.open.push(view);
            }
            let over_left = neighbours[(edge + 2) % 3];
            if is_right_of_left && over_left != NONE {
                let right_limit = if is_left_of_right { apex } else { right_limit };
                let view = View { triangle: over_left, right: apex, left, right_limit, left_limit };
                self.open.push(view);
            }
        }
    }
}

/// All admissible chords of a simple polygon; `None` if more than `most`. O(triangles seen),
/// in parallel.
pub(crate) fn chords(
    mesh: &Linked,
    points: &[DVec2],
    sides: &Sides,
    most: usize,
    stage: &Stage<'_>,
) -> Result<Option<Chords>, Cancelled> {
    let pairs = seen_pairs(mesh, points, sides, Some(&Ring::new(mesh, points)), most, stage)?;
    Ok(pairs.map(|pairs| Chords::new(points.len(), &pairs)))
}

/// The vertices that see each other in any domain, boundary neighbours and those within a side left
/// out, smaller ones first and ascending; none if they are more than `most`. With holes a triangle is
/// seen more than once, on either side of a hole.
pub(crate) fn pairs(
    mesh: &Linked,
    points: &[DVec2],
    sides: &Sides,
    most: usize,
    stage: &Stage<'_>,
) -> Result<Option<Vec<Vec<[u32; 2]>>>, Cancelled> {
    seen_pairs(mesh, points, sides, None, most, stage)
}

fn seen_pairs(
    mesh: &Linked,
    points: &[DVec2],
    sides: &Sides,
    ring: Option<&Ring<'_>>,
    most: usize,
    stage: &Stage<'_>,
) -> Result<Option<Vec<Vec<[u32; 2]>>>, Cancelled> {
    const CHUNK: usize = 16;
    const ROUND: usize = 32 * CHUNK;
    let vertices = points.len();
    let corners = Corners::new(vertices, &mesh.triangles);
    let seen_by = |range: Range<usize>| {
        let mut eye = Eye::new(sides, ring);
        let mut seen = Vec::new();
        for vertex in range.start as u32..range.end as u32 {
            for &corner in corners.of(vertex) {
                eye.look(mesh, points, corner, |other| {
                    if other > vertex && !sides.has_both(vertex, other) {
                        seen.push([vertex, other]);
                    }
                });
            }
        }
        seen
    };
    let mut chunks: Vec<Vec<[u32; 2]>> = Vec::new();
    let mut count = 0;
    // In rounds, so that too many chords end it early.
    for round in (0..vertices).step_by(ROUND) {
        stage.report(round as f64 / vertices as f64)?;
        let found = map_chunks(round..vertices.min(round + ROUND), CHUNK, seen_by);
        count += found.iter().map(Vec::len).sum::<usize>();
        if count > most {
            return Ok(None);
        }
        chunks.extend(found);
    }
    Ok(Some(chunks))
}

/// Whether two vertices see each other or are the ends of an edge, by a walk from one to the other.
/// O(triangles crossed), which `steps` counts.
pub(crate) fn sees(
    mesh: &Linked,
    points: &[DVec2],
    corners: &Corners,
    [from, to]: [u32; 2],
    is_clear: bool,
    steps: &mut u64,
) -> bool {
    let [at_from, at_to] = [from, to].map(|vertex| points[vertex as usize]);
    for &corner in corners.of(from) {
        *steps += 1;
        let ends = mesh.beside(corner);
        if ends.contains(&to) {
            return true;
        }
        let [right, left] = ends.map(|vertex| points[vertex as usize]);
        if orientation(at_from, right, at_to) > 0.0 && orientation(at_from, at_to, left) > 0.0 {
            return sees_from(mesh, points, corner, to, is_clear, steps);
        }
    }
    false
}

/// Whether a corner (3 * triangle + corner) sees a vertex within the angle of its triangle; if `is_clear`,
/// past no vertex of the triangles between by less than the tolerance of [`passes`].
fn sees_from(
    mesh: &Linked,
    points: &[DVec2],
    corner: u32,
    to: u32,
    is_clear: bool,
    steps: &mut u64,
) -> bool {
    let (triangle, at) = (corner as usize / 3, corner as usize % 3);
    let chord = [mesh.triangles[triangle][at], to].map(|vertex| points[vertex as usize]);
    let is_passed = |vertex: u32| is_clear && passes(chord, points[vertex as usize]);
    let [right, mut left] = mesh.beside(corner);
    if is_passed(right) || is_passed(left) {
        return false;
    }
    let mut beyond = mesh.neighbours[triangle][(at + 1) % 3];
    while beyond != NONE {
        *steps += 1;
        let (edge, apex) = mesh.enter(beyond, left);
        if apex == to {
            return true;
        }
        let side = orientation(chord[0], chord[1], points[apex as usize]);
        if side == 0.0 || is_passed(apex) {
            return false;
        }
        let next = if side > 0.0 { 1 } else { 2 };
        if side > 0.0 {
            left = apex;
        }
        beyond = mesh.neighbours[beyond as usize][(edge + next) % 3];
    }
    false
}

#[cfg(test)]
#[path = "../tests/outlines/mod.rs"]
mod outlines;

#[cfg(test)]
mod tests {
    use super::outlines::{Outline, Random};
    use super::*;
    use mindeg_mesh::Progress;

    #[test]
    fn the_chords_are_those_of_the_definition() {
        let stage = &Stage::new(Progress::NONE, "");
        let mut random = Random(5);
        let mut outlines = vec![
            Outline::l_shape([4, 3, 2, 1, 2, 3]),
            Outline::comb(4, 9, 2),
            Outline::gear(8, 2),
            Outline::spiral(3),
            Outline::comb(12, 1, 1),
            Outline::gear(20, 1),
        ];
        while outlines.len() < 300 {
            let corners = 4 + random.below(17) as usize;
            outlines.extend(Outline::random(&mut random, corners, 30));
        }
        for outline in outlines {
            let n = outline.points.len();
            let mut mesh = Linked::new(outline.ears()).unwrap();
            let sides = Sides::of_triangulation(&mut mesh, &outline.points, &outline.side_of);
            let found = chords(&mesh, &outline.points, &sides, n * n, stage).unwrap().unwrap();
            let corners = Corners::new(n, &mesh.triangles);
            // With a look at the whole ring now and then, and without.
            let [mut with, mut without] =
                [Some(Ring::new(&mesh, &outline.points)), None].map(|ring| {
                    let (points, sides) = (&outline.points, &sides);
                    let pairs = seen_pairs(&mesh, points, sides, ring.as_ref(), n * n, stage);
                    pairs.unwrap().unwrap().concat()
                });
            with.sort_unstable();
            without.sort_unstable();
            assert_eq!(with, without);
            for (i, j) in (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j))) {
                assert_eq!(found.has(i as u32, j as u32), outline.may_join(i, j), "{outline:?}");
                if j > i + 1 && j < i + n - 1 {
                    let ends = [i as u32, j as u32];
                    let sees = sees(&mesh, &outline.points, &corners, ends, false, &mut 0);
                    assert_eq!(sees, outline.is_visible(i, j), "{i}, {j}: {outline:?}");
                }
            }
            let is_triple = |i: usize, k: usize, j: usize| {
                outline.may_join(i, j) && outline.may_join(i, k) && outline.may_join(k, j)
            };
            let triples = (0..n).flat_map(|i| (i + 1..n).map(move |k| (i, k)));
            let triples: usize =
                triples.map(|(i, k)| (k + 1..n).filter(|&j| is_triple(i, k, j)).count()).sum();
            assert_eq!(found.count_triples(u64::MAX, stage), Ok(Some(triples as u64)));
            assert_eq!(found.count_triples(triples as u64 - 1, stage), Ok(None));
            let few = found.len() - n - 1;
            let fewer = chords(&mesh, &outline.points, &sides, few, stage).unwrap();
            assert!(fewer.is_none() || found.len() <= n);
        }
    }
}
