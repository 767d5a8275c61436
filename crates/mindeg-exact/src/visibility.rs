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
    /// With these, one question shows that no vertex is near a chord.
    hulls: Option<&'a Hulls<'a>>,
    /// With a polygon's ring it passes over many triangles at once.
    ring: Option<&'a Ring<'a>>,
    /// The vertices follow each other along the boundary of one ring, and only larger ones than the eye are
    /// wanted: half of all that it sees.
    is_upward: bool,
    /// The field `clear` of [`Sides`].
    clear: Option<f64>,
}

/// The ring 0, 1, 2, … of a polygon, where the vertices beyond an edge follow each other.
pub(crate) struct Ring<'a> {
    mesh: &'a Linked,
    hulls: &'a Hulls<'a>,
    /// The corners at each vertex counter-clockwise.
    corners: Corners,
}

impl<'a> Ring<'a> {
    fn new(mesh: &'a Linked, hulls: &'a Hulls<'a>, count: usize) -> Self {
        let mut corners = Corners::new(count, &mesh.triangles);
        corners.sort_by_key(mesh, |vertex, next| after(vertex, next, count));
        Self { mesh, hulls, corners }
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
    pub(crate) fn new(sides: &Sides, is_upward: bool) -> Self {
        Self { open: Vec::new(), hulls: None, ring: None, is_upward, clear: sides.clear }
    }

    /// The views from one look at the whole ring to the next: about what that takes.
    const PATIENCE: u32 = if cfg!(test) { 2 } else { 32 };

    /// Visits every wanted vertex, once, that corner `corner` (3 * triangle + corner) sees through its
    /// triangle: the last corner of the triangle unless it is a boundary neighbour, and all that is
    /// visible through the opposite edge. All corners of a vertex together visit each vertex that
    /// it sees, without its boundary neighbours. O(triangles seen); returns how many it passed.
    pub(crate) fn look(
        &mut self,
        mesh: &Linked,
        points: &[DVec2],
        corner: u32,
        is_wanted: impl Fn(u32) -> bool,
        mut visit: impl FnMut(u32),
    ) -> u64 {
        let (triangle, at) = (corner as usize / 3, corner as usize % 3);
        let corners = mesh.triangles[triangle];
        let [eye, right, left] = [corners[at], corners[(at + 1) % 3], corners[(at + 2) % 3]];
        if mesh.neighbours[triangle][(at + 2) % 3] != NONE && is_wanted(left) {
            visit(left);
        }
        let at_eye = points[eye as usize];
        let turn = |a: u32, b: u32| orientation(at_eye, points[a as usize], points[b as usize]);
        let beyond = mesh.neighbours[triangle][(at + 1) % 3];
        if beyond != NONE {
            let (right_limit, left_limit) = (right, left);
            self.open.push(View { triangle: beyond, right, left, right_limit, left_limit });
        }
        // Beyond an edge are the vertices from its right end to its left one.
        let is_upward = self.is_upward;
        let is_open = |right: u32| !is_upward || (right > eye && right as usize + 1 < points.len());
        let (mut views, mut walked) = (0, 0);
        while let Some(View { triangle, right, left, right_limit, left_limit }) = self.open.pop() {
            if !is_open(right) {
                continue;
            }
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
            if is_left_of_right && is_right_of_left && is_wanted(apex) {
                let is_near = |limit: u32, angle: f64| {
                    let [a, b] = [limit, apex].map(|vertex| points[vertex as usize] - at_eye);
                    a.perp_dot(b).abs() <= angle * a.dot(b)
                };
                let may_pass = self.clear.is_some_and(|angle| {
                    (is_near(right_limit, angle) || is_near(left_limit, angle))
                        && self.is_any_passed(points, [eye, apex], angle)
                });
                // Few chords pass a vertex, seen or not.
                if !may_pass || sees_from(mesh, points, corner, apex, true, &mut walked) {
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
        u64::from(views) + walked
    }
}

impl Eye<'_> {
    /// Whether a chord may pass some vertex of the domain.
    fn is_any_passed(&self, points: &[DVec2], ends: [u32; 2], angle: f64) -> bool {
        self.hulls.is_none_or(|hulls| {
            let chord = ends.map(|end| points[end as usize]);
            let distance = angle * chord[0].distance(chord[1]);
            let is_passed = |v: u32| !ends.contains(&v) && passes(chord, points[v as usize]);
            hulls.any_beside(chord, distance, is_passed)
        })
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
    let pairs = seen_pairs(mesh, points, sides, true, most, stage)?;
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
    seen_pairs(mesh, points, sides, false, most, stage)
}

fn seen_pairs(
    mesh: &Linked,
    points: &[DVec2],
    sides: &Sides,
    is_ring: bool,
    most: usize,
    stage: &Stage<'_>,
) -> Result<Option<Vec<Vec<[u32; 2]>>>, Cancelled> {
    const CHUNK: usize = 16;
    const ROUND: usize = 32 * CHUNK;
    let vertices = points.len();
    let corners = Corners::new(vertices, &mesh.triangles);
    let hulls = &Hulls::new(points);
    let ring = is_ring.then(|| Ring::new(mesh, hulls, vertices));
    let seen_by = |range: Range<usize>| {
        let mut eye = Eye { hulls: Some(hulls), ring: ring.as_ref(), ..Eye::new(sides, is_ring) };
        let mut seen = Vec::new();
        for vertex in range.start as u32..range.end as u32 {
            let is_wanted = |other: u32| other > vertex && !sides.has_both(vertex, other);
            for &corner in corners.of(vertex) {
                eye.look(mesh, points, corner, is_wanted, |other| seen.push([vertex, other]));
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

    /// Each of its chords along the back was walked, past all teeth: a minute for 10,000 teeth.
    #[test]
    fn a_comb_takes_work_in_proportion_to_its_teeth() {
        const TEETH: u32 = 1000;
        let mut points = vec![DVec2::new(-1.0, 0.0), DVec2::new(f64::from(TEETH), 0.0)];
        let mut triangles = Vec::new();
        let mut before = None;
        for tooth in 0..TEETH {
            let x = f64::from(TEETH - 1 - tooth);
            let right = points.len() as u32;
            let corners = [(x + 0.9999, 1.0), (x + 0.6, 100.0), (x + 0.5, 100.0), (x, 1.0)];
            points.extend(corners.map(DVec2::from));
            triangles.extend([[right, right + 1, right + 2], [right, right + 2, right + 3]]);
            triangles.extend(before.map(|left| [1, left, right]));
            triangles.push([1, right, right + 3]);
            before = Some(right + 3);
        }
        let count = points.len() as u32;
        triangles.push([0, 1, count - 1]);
        let mut mesh = Linked::new(triangles).unwrap();
        let sides = Sides::of_triangulation(&mut mesh, &points, &Vec::from_iter(0..count));
        let (corners, hulls) = (Corners::new(points.len(), &mesh.triangles), Hulls::new(&points));
        let ring = Ring::new(&mesh, &hulls, points.len());
        let mut eye = Eye { hulls: Some(&hulls), ring: Some(&ring), ..Eye::new(&sides, true) };
        let (mut seen, mut steps) = (0, 0);
        for &corner in corners.of(0) {
            steps += eye.look(&mesh, &points, corner, |_| true, |_| seen += 1);
        }
        assert_eq!(seen, 2 * TEETH - 1);
        assert!(steps < 10 * u64::from(count), "{steps} steps for {count} vertices");
    }

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
            let [mut with, mut without] = [true, false].map(|is_ring| {
                let pairs = seen_pairs(&mesh, &outline.points, &sides, is_ring, n * n, stage);
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
