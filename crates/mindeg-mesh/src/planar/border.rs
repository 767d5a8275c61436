//! The border of a map: its faces without those that are holes.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use glam::DVec2;

use super::boundary::PlanarBoundary;
use super::map::Faces;
use super::orientation;

/// A boundary around the faces of a map that are not holes.
///
/// Its rings may touch themselves and each other at vertices: a point with several sectors, which holes keep apart, has a vertex
/// for [each](PlanarBoundary::twins). Several rings may be outer ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Border {
    /// Rings with the domain on their left; the inner points and the lines between faces that are not holes.
    pub boundary: PlanarBoundary,
    /// The vertex of the map that each vertex is.
    pub vertices: Vec<u32>,
    /// The edge of the map that each edge is: of the rings, then of the lines.
    pub edges: Vec<u32>,
}

/// An edge of a map, from one of its ends.
#[derive(Clone, Copy)]
struct Spoke {
    at: u32,
    to: u32,
    edge: u32,
    /// Whether the domain is on the left, and on the right.
    has_domain: [bool; 2],
}

impl Spoke {
    /// Whether a ring leaves here along this edge, with the domain on its left.
    fn leaves(&self) -> bool {
        self.has_domain == [true, false]
    }
}

impl PlanarBoundary {
    /// The boundary around the faces that are not holes. Edges with a hole on both sides, and points in holes, are left
    /// out. O(n log n).
    ///
    /// # Example
    ///
    /// ```
    /// use glam::DVec2;
    /// use mindeg_mesh::planar::PlanarBoundary;
    ///
    /// // A triangular hole that touches a corner of a square.
    /// let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(DVec2::from);
    /// let inner = [[2.0, 1.0], [1.0, 2.0]].map(DVec2::from);
    /// let (map, _) = PlanarBoundary::map(&[square], &inner, &[vec![0, 4, 5, 0]])?;
    /// let faces = map.faces(&[DVec2::ONE])?;
    /// let border = map.border(&faces, |face| face == 0);
    /// assert_eq!(border.vertices, [0, 1, 2, 3, 0, 5, 4]);
    /// assert_eq!(border.boundary.twins(4).collect::<Vec<_>>(), [0]);
    /// # Ok::<(), mindeg_mesh::planar::BoundaryFaults>(())
    /// ```
    pub fn border(&self, faces: &Faces, is_hole: impl Fn(u32) -> bool) -> Border {
        let edges: Vec<u32> = (0..self.edge_count()).collect();
        let points: Vec<u32> = (self.vertex_count()..self.points.len() as u32).collect();
        let has_domain = |face: Option<u32>| face.is_some_and(|face| !is_hole(face));
        let mut border = self.border_of(faces, &edges, &points, None, has_domain);
        let lines = &border.edges[border.boundary.vertex_count() as usize..];
        let before =
            |start: &u32| lines.partition_point(|&edge| edge < self.vertex_count() + start) as u32;
        border.boundary.line_starts = self.line_starts.iter().map(before).collect();
        border
    }

    /// The border of each face by itself, in the order of the faces. The outer ring comes first and begins at the point that
    /// is least by x and then by y. Edges with the face on both sides, and points in it, are its lines and points; lines are
    /// not told apart. O(n log n).
    ///
    /// # Example
    ///
    /// ```
    /// use glam::DVec2;
    /// use mindeg_mesh::planar::PlanarBoundary;
    ///
    /// // A diagonal divides a square.
    /// let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(DVec2::from);
    /// let (map, _) = PlanarBoundary::map(&[square], &[], &[vec![0, 2]])?;
    /// let borders = map.face_borders(&map.faces(&[])?);
    /// assert_eq!(borders[0].vertices, [0, 1, 2]);
    /// assert_eq!(borders[1].vertices, [0, 2, 3]);
    /// # Ok::<(), mindeg_mesh::planar::BoundaryFaults>(())
    /// ```
    pub fn face_borders(&self, faces: &Faces) -> Vec<Border> {
        let mut edges = vec![Vec::new(); faces.count];
        for (edge, beside) in (0..).zip(&faces.beside) {
            for face in beside.iter().flatten() {
                let own: &mut Vec<u32> = &mut edges[*face as usize];
                if own.last() != Some(&edge) {
                    own.push(edge);
                }
            }
        }
        let mut points = vec![Vec::new(); faces.count];
        for (vertex, face) in (self.vertex_count()..).zip(&faces.points) {
            if let Some(face) = face {
                points[*face as usize].push(vertex);
            }
        }
        let border = |(face, (edges, points)): (u32, (&Vec<u32>, &Vec<u32>))| {
            let ends = edges.iter().flat_map(|&edge| self.ends(edge));
            let by_place = |a: &u32, b: &u32| {
                let [a, b] = [a, b].map(|vertex| self.point(*vertex));
                a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
            };
            self.border_of(faces, edges, points, ends.min_by(by_place), |other| other == Some(face))
        };
        (0..).zip(edges.iter().zip(&points)).map(border).collect()
    }

    /// The border around faces, whose edges, and points that are on no edge, are among those given, both in ascending order.
    /// Rings are in the order of their first edges, but that from the vertex `first` is the first. All lines are one.
    fn border_of(
        &self,
        faces: &Faces,
        given: &[u32],
        points: &[u32],
        first: Option<u32>,
        has_domain: impl Fn(Option<u32>) -> bool,
    ) -> Border {
        let beside = |edge: u32| faces.beside[edge as usize].map(&has_domain);
        let spokes = self.spokes_of(given, beside);
        let next = |index: usize| {
            let Spoke { at, to, .. } = spokes[index];
            let back = own(&spokes, to).find(|&spoke| spokes[spoke].to == at);
            back.and_then(|back| leaving(&spokes, back))
        };
        let mut vertices = Vec::new();
        let mut edges = Vec::new();
        let mut starts = vec![0];
        // The vertex of the border where each spoke leaves.
        let mut corners = vec![None; spokes.len()];
        let mut order: Vec<usize> = (0..spokes.len()).filter(|&at| spokes[at].leaves()).collect();
        order.sort_by_key(|&at| (Some(spokes[at].at) != first, spokes[at].edge));
        for first in order {
            let mut spoke = Some(first);
            while let Some(at) = spoke.filter(|&at| corners[at].is_none()) {
                corners[at] = Some(vertices.len() as u32);
                vertices.push(spokes[at].at);
                edges.push(spokes[at].edge);
                spoke = next(at);
            }
            if vertices.len() as u32 > starts[starts.len() - 1] {
                starts.push(vertices.len() as u32);
            }
        }
        let twins = twins(&vertices);
        let is_between = |edge: &u32| *edge >= self.vertex_count() && beside(*edge) == [true; 2];
        let kept: Vec<u32> = given.iter().copied().filter(is_between).collect();
        // A corner at each vertex of the rings; then the inner points that are left.
        let mut names: BTreeMap<u32, u32> = vertices.iter().copied().zip(0..).collect();
        let is_left =
            |point: &&u32| has_domain(faces.points[(**point - self.vertex_count()) as usize]);
        let inner = points.iter().filter(is_left).copied();
        let inner: BTreeSet<u32> =
            kept.iter().flat_map(|&edge| self.ends(edge)).chain(inner).collect();
        for vertex in inner {
            names.entry(vertex).or_insert_with(|| {
                vertices.push(vertex);
                vertices.len() as u32 - 1
            });
        }
        let end = |edge: u32, at: u32| {
            let spoke = own(&spokes, at).find(|&spoke| spokes[spoke].edge == edge);
            let corner = spoke.and_then(|spoke| corners[leaving(&spokes, spoke)?]);
            corner.unwrap_or(names[&at])
        };
        let segments = kept.iter().map(|&edge| self.ends(edge).map(|at| end(edge, at))).collect();
        let lines = vec![0, kept.len() as u32];
        edges.extend(kept);
        let points = vertices.iter().map(|&vertex| self.point(vertex)).collect();
        let mut boundary = Self::unproven(points, starts);
        (boundary.segments, boundary.line_starts, boundary.twins) = (segments, lines, twins);
        Border { boundary, vertices, edges }
    }

    /// The spokes of edges with the domain on a side, from both ends; at each vertex counter-clockwise.
    fn spokes_of(&self, edges: &[u32], beside: impl Fn(u32) -> [bool; 2]) -> Vec<Spoke> {
        let mut spokes: Vec<Spoke> = edges
            .iter()
            .flat_map(|&edge| {
                let ([at, to], [left, right]) = (self.ends(edge), beside(edge));
                let forth = Spoke { at, to, edge, has_domain: [left, right] };
                [forth, Spoke { at: to, to: at, edge, has_domain: [right, left] }]
            })
            .filter(|spoke| spoke.has_domain != [false; 2])
            .collect();
        spokes.sort_by(|a, b| {
            let by_turn =
                || counter_clockwise(self.point(a.at), self.point(a.to), self.point(b.to));
            a.at.cmp(&b.at).then_with(by_turn)
        });
        spokes
    }
}

/// The spokes of a vertex.
fn own(spokes: &[Spoke], at: u32) -> Range<usize> {
    let from = spokes.partition_point(|spoke| spoke.at < at);
    from..from + spokes[from..].partition_point(|spoke| spoke.at == at)
}

/// The spoke that bounds, on the right, the sector in which a spoke lies or which it bounds on the left; none at a vertex
/// inside the domain.
fn leaving(spokes: &[Spoke], spoke: usize) -> Option<usize> {
    let own = own(spokes, spokes[spoke].at);
    let before = (own.start..spoke).rev().chain((spoke..own.end).rev());
    before.into_iter().find(|&at| spokes[at].leaves())
}

/// The order of two directions from a point, counter-clockwise from the positive x axis; exact.
fn counter_clockwise(from: DVec2, a: DVec2, b: DVec2) -> Ordering {
    let is_below = |to: DVec2| to.y < from.y || to.y == from.y && to.x < from.x;
    let turn = || 0.0.partial_cmp(&orientation(from, a, b)).unwrap_or(Ordering::Equal);
    is_below(a).cmp(&is_below(b)).then_with(turn)
}

/// Each pair of corners at one vertex, both ways.
fn twins(vertices: &[u32]) -> Vec<[u32; 2]> {
    let mut corners: Vec<(u32, u32)> = vertices.iter().copied().zip(0..).collect();
    corners.sort_unstable();
    let mut twins: Vec<[u32; 2]> = corners
        .chunk_by(|a, b| a.0 == b.0)
        .flat_map(|same| {
            let others = |own: u32| same.iter().map(move |other| [own, other.1]);
            same.iter().flat_map(move |own| others(own.1))
        })
        .filter(|[own, other]| own != other)
        .collect();
    twins.sort_unstable();
    twins
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A square of cells of length 1, with a point in each and all edges between them as lines.
    fn cells(across: u32) -> (PlanarBoundary, Faces) {
        let at = |x: u32, y: u32| DVec2::new(x.into(), y.into());
        let sides = [[0, 0], [across, 0], [across, across], [0, across]];
        let walk = |side: usize| {
            let ends = [side, (side + 1) % 4].map(|corner| sides[corner].map(f64::from));
            let [from, to] = ends.map(DVec2::from);
            (0..across).map(move |i| from.lerp(to, f64::from(i) / f64::from(across)))
        };
        let ring: Vec<DVec2> = (0..4).flat_map(walk).collect();
        let inside = (1..across).flat_map(|y| (1..across).map(move |x| at(x, y)));
        let middles: Vec<DVec2> =
            (0..across * across).map(|cell| at(cell % across, cell / across) + 0.5).collect();
        let inner: Vec<DVec2> = inside.chain(middles.iter().copied()).collect();
        let all: Vec<DVec2> = ring.iter().chain(&inner).copied().collect();
        let vertex = |x, y| all.iter().position(|&point| point == at(x, y)).unwrap() as u32;
        let upright = (1..across).flat_map(|x| (0..across).map(move |y| [(x, y), (x, y + 1)]));
        let level = (1..across).flat_map(|y| (0..across).map(move |x| [(x, y), (x + 1, y)]));
        let lines: Vec<Vec<u32>> =
            upright.chain(level).map(|ends| ends.map(|(x, y)| vertex(x, y)).to_vec()).collect();
        let (map, _) = PlanarBoundary::map(&[ring], &inner, &lines).unwrap();
        let faces = map.faces(&middles.iter().map(|&at| at + 0.1).collect::<Vec<_>>()).unwrap();
        (map, faces)
    }

    /// A square with a hole, a line across, a line that ends inside, and a closed line at a corner of the hole.
    #[test]
    fn each_face_has_a_border_of_its_own() {
        let ring = |low: f64, high: f64| {
            [[low, low], [high, low], [high, high], [low, high]].map(DVec2::from).to_vec()
        };
        let hole: Vec<DVec2> = ring(2.0, 3.0).into_iter().rev().collect();
        let inner = [[1.0, 1.0], [4.0, 3.0], [4.0, 3.5], [5.5, 0.5]].map(DVec2::from);
        // 0 to 3 are the outline, 4 to 7 the hole from (2, 3) on, 8 to 11 the inner points.
        let lines = [vec![1, 3], vec![0, 8], vec![5, 9, 10, 5]];
        let (map, _) = PlanarBoundary::map(&[ring(0.0, 8.0), hole], &inner, &lines).unwrap();
        let borders =
            map.face_borders(&map.faces(&[[3.9, 3.2].into(), [7.0, 7.0].into()]).unwrap());
        let areas: Vec<f64> = borders
            .iter()
            .map(|border| {
                let corners =
                    border.boundary.edges().map(|ends| ends.map(|v| border.boundary.point(v)));
                corners.map(|[a, b]| a.perp_dot(b)).sum::<f64>() / 2.0
            })
            .collect();
        assert_eq!(areas, [0.25, 32.0, 32.0 - 1.0 - 0.25]);
        assert_eq!(borders[0].vertices, [5, 9, 10]);
        assert_eq!(borders[1].vertices, [3, 1, 2]);
        let rest = &borders[2];
        assert_eq!(
            (rest.vertices[0], rest.boundary.ring(0), rest.boundary.ring_count()),
            (0, 0..3, 2)
        );
        // The closed line and the hole are one ring, which passes their common corner twice.
        assert_eq!(rest.boundary.ring(1).len(), 4 + 3);
        let at_corner =
            (0..rest.boundary.vertex_count()).filter(|&v| rest.vertices[v as usize] == 5);
        let corners: Vec<u32> = at_corner.collect();
        assert!(rest.boundary.twins(corners[0]).eq([corners[1]]));
        let dangling = rest.boundary.segments()[0].map(|end| rest.vertices[end as usize]);
        assert_eq!((dangling, rest.boundary.inner_points()), ([0, 8], &[inner[0], inner[3]][..]));
        for border in &borders {
            for (name, &edge) in (0..).zip(&border.edges) {
                let mut ends = border.boundary.ends(name).map(|end| border.vertices[end as usize]);
                let mut expected = map.ends(edge);
                ends.sort_unstable();
                expected.sort_unstable();
                assert_eq!(ends, expected);
            }
        }
    }

    proptest! {
        /// Whichever cells are holes.
        #[test]
        fn rings_bound_the_cells_that_are_left(
            across in 2..5_u32, holes in prop::collection::vec(any::<bool>(), 25),
        ) {
            let (map, faces) = cells(across);
            let Border { boundary, vertices, edges } = map.border(&faces, |face| holes[face as usize]);
            let is_left = |x: u32, y: u32| {
                x < across && y < across && !holes[(y * across + x) as usize]
            };
            let cells = (0..across * across).filter(|cell| is_left(cell % across, cell / across));
            let area: f64 = boundary.edges().map(|[a, b]| boundary.point(a).perp_dot(boundary.point(b))).sum();
            prop_assert_eq!(area / 2.0, cells.count() as f64);
            for (name, &vertex) in (0..).zip(&vertices) {
                prop_assert_eq!(boundary.point(name), map.point(vertex));
            }
            for (name, &edge) in (0..).zip(&edges) {
                let mut ends = boundary.ends(name).map(|end| vertices[end as usize]);
                let mut expected = map.ends(edge);
                ends.sort_unstable();
                expected.sort_unstable();
                prop_assert_eq!(ends, expected);
            }
            // A corner for each sector; a line ends at the corner in whose sector it lies.
            let mut corners = 0;
            for (y, x) in (0..=across).flat_map(|y| (0..=across).map(move |x| (y, x))) {
                let around = [(x, y), (x.wrapping_sub(1), y), (x.wrapping_sub(1), y.wrapping_sub(1)), (x, y.wrapping_sub(1))]
                    .map(|(x, y)| is_left(x, y));
                corners += (0..4).filter(|&i| around[i] && !around[(i + 1) % 4]).count();
            }
            prop_assert_eq!(boundary.vertex_count() as usize, corners);
            for &[from, to] in boundary.segments() {
                for [at, to] in [[from, to], [to, from]] {
                    if at < boundary.vertex_count() {
                        let [at, before, after, to] =
                            [at, boundary.previous(at), boundary.next(at), to].map(|v| boundary.point(v));
                        let angle = |to: DVec2| {
                            let turned = (after - at).angle_to(to - at);
                            if turned <= 0.0 { turned + std::f64::consts::TAU } else { turned }
                        };
                        prop_assert!(angle(to) < angle(before));
                    }
                }
            }
            let middles = boundary.inner_points().iter().filter(|at| at.x.fract() == 0.5).count();
            prop_assert_eq!(middles as f64, area / 2.0);
            for vertex in 0..boundary.vertex_count() {
                let same = (0..boundary.vertex_count())
                    .filter(|&other| other != vertex && vertices[other as usize] == vertices[vertex as usize]);
                prop_assert!(boundary.twins(vertex).eq(same));
            }
        }
    }
}
