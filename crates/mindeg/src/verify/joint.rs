//! The check of bounds on the degrees of maps, over all faces together. It shares nothing with the search: faces are what
//! the triangles of the mesh cover between lines, and their chords are tested one by one.
//!
//! Limits: weights are checked on faces of up to some hundred vertices.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use glam::DVec2;
use mindeg_domain::Domain;
use mindeg_exact::Problem;
use mindeg_exact::check::refutation::{CheckedFace, refutes};
use mindeg_exact::check::{CheckedOutline, is_passed};
use mindeg_mesh::planar::PlanarBoundary;

use super::map::{MapLines, sides, turn};
use super::matching::VerifiedMesh;
use super::proof::Proof;
use crate::model::bound::JointBound;

/// The most vertices of a face whose triangulations of least weight are looked for.
const MOST_WEIGHED: usize = 400;

/// A face without holes and lines inside, or any other.
struct Face {
    /// Triangles by vertices of the map.
    triangles: Vec<[u32; 3]>,
    /// The edges around it, with the face on their left.
    halves: BTreeSet<[u32; 2]>,
}

/// A face as the checker takes it.
struct Outline {
    vertices: Vec<u32>,
    points: Vec<DVec2>,
    rings: Vec<Range<u32>>,
    side_of: Vec<u32>,
    keeps_clear: bool,
}

/// A mesh of a map, its faces, and the edges that every mesh of the map has.
pub(super) struct JointCheck<'a> {
    domain: &'a Domain,
    boundary: &'a PlanarBoundary,
    mesh: &'a VerifiedMesh,
    faces: Vec<Face>,
    /// For each vertex its number in the mesh that is joined at periodic sides, in the order of the least vertices.
    numbers: Vec<u32>,
    /// The edges at each of these that every mesh has.
    edges_at: Vec<u32>,
}

impl<'a> JointCheck<'a> {
    /// None if the mesh lacks a line.
    pub(super) fn new(
        domain: &'a Domain,
        boundary: &'a PlanarBoundary,
        mesh: &'a VerifiedMesh,
    ) -> Option<Self> {
        let lines = MapLines::new(domain, boundary, mesh).ok()?;
        let all: BTreeSet<[u32; 2]> = mesh.triangles.iter().flat_map(|&t| sides(t)).collect();
        let is_around = |&[a, b]: &[u32; 2]| lines.has([a, b]) || !all.contains(&[b, a]);
        let mut faces: BTreeMap<u32, Face> = BTreeMap::new();
        for (triangle, first) in mesh.triangles.iter().zip(lines.triangles_by_face(&mesh.triangles))
        {
            let empty = || Face { triangles: Vec::new(), halves: BTreeSet::new() };
            let face = faces.entry(first).or_insert_with(empty);
            face.triangles.push(*triangle);
            face.halves.extend(sides(*triangle).into_iter().filter(is_around));
        }
        let numbers = joined_numbers(domain, mesh.points.len());
        let mut edges_at: Vec<u32> =
            vec![0; numbers.iter().max().map_or(0, |&last| last as usize + 1)];
        let moved = moved_edges(domain);
        let ring_edges = (0..domain.rings().vertex_count()).map(|v| [v, domain.rings().next(v)]);
        let ring_edges = ring_edges.filter(|&[a, b]| !moved.contains(&[a.min(b), a.max(b)]));
        for end in ring_edges.chain(boundary.segments().iter().copied()).flatten() {
            edges_at[numbers[end as usize] as usize] += 1;
        }
        for vertex in 0..domain.rings().vertex_count() {
            let edges = &mut edges_at[numbers[vertex as usize] as usize];
            *edges = edges.saturating_add(domain.external_degree(vertex));
        }
        let faces = faces.into_values().collect();
        Some(Self { domain, boundary, mesh, faces, numbers, edges_at })
    }

    /// Why no mesh of the map has a smaller maximum degree than `at_least`, if the bound proves that. `rings` are those of
    /// each face of the bound.
    pub(super) fn proof(
        &self,
        bound: &JointBound,
        rings: &[Vec<Vec<u32>>],
        at_least: u32,
    ) -> Option<Proof> {
        let less = at_least.checked_sub(1)?;
        match bound {
            JointBound::Sum { .. } => {
                // All meshes have as many edges as this one.
                let mut joined: BTreeMap<u32, u32> = BTreeMap::new();
                joined.extend(self.numbers.iter().copied().zip(self.mesh.degrees.iter().copied()));
                let sum: u64 = joined.values().map(|&degree| u64::from(degree)).sum();
                let most = u64::from(less) * joined.len() as u64;
                (sum > most).then_some(Proof::Counting)
            }
            JointBound::Edges { vertex, .. } => {
                let edges = self.edges_at[*self.numbers.get(*vertex as usize)? as usize];
                (edges >= at_least).then_some(Proof::Edges { edges })
            }
            JointBound::Side { face, .. } => {
                let outline = self.outline(rings.get(*face as usize)?)?;
                let intervals = self.crowded_side(&outline, less)?;
                Some(Proof::Side { intervals })
            }
            JointBound::Weights { weights, .. } => {
                self.weighs_more(weights, less)?.then_some(Proof::Weights)
            }
            JointBound::Refuted { refutation, .. } => {
                if rings.len() != self.faces.len() {
                    return None;
                }
                let outlines: Vec<Outline> =
                    rings.iter().map(|rings| self.outline(rings)).collect::<Option<_>>()?;
                let faces: Vec<CheckedFace<'_>> = outlines.iter().map(Outline::face).collect();
                let most: Option<Vec<u32>> =
                    self.edges_at.iter().map(|&edges| less.checked_sub(edges)).collect();
                let clauses = refutation.clauses.len();
                refutes(&faces, &most?, refutation).then_some(Proof::Refuted { clauses })
            }
        }
    }

    /// The outline that rings bound, if that is a face of the mesh.
    fn outline(&self, rings: &[Vec<u32>]) -> Option<Outline> {
        let vertices = rings.concat();
        let after = |ring: &[u32], at: usize| ring[(at + 1) % ring.len()];
        let halves: Vec<[u32; 2]> = rings
            .iter()
            .flat_map(|ring| (0..ring.len()).map(|at| [ring[at], after(ring, at)]))
            .collect();
        let first = halves.first()?;
        let face = self.faces.iter().find(|face| face.halves.contains(first))?;
        let is_same = face.halves.len() == halves.len()
            && halves.iter().copied().collect::<BTreeSet<_>>() == face.halves;
        let distinct: BTreeSet<u32> = vertices.iter().copied().collect();
        if !is_same || distinct.len() != vertices.len() {
            return None;
        }
        let points: Vec<DVec2> =
            vertices.iter().map(|&vertex| self.mesh.points[vertex as usize]).collect();
        let mut ranges = Vec::with_capacity(rings.len());
        let mut side_of = Vec::with_capacity(vertices.len());
        for ring in rings {
            let start = side_of.len() as u32;
            ranges.push(start..start + ring.len() as u32);
            side_of.extend(self.sides_of_ring(ring, start));
        }
        let place: BTreeMap<u32, u32> = vertices.iter().copied().zip(0..).collect();
        let triangles = face.triangles.iter();
        let triangles: Option<Vec<[u32; 3]>> = triangles
            .map(|t| {
                let [a, b, c] = t.map(|vertex| place.get(&vertex).copied());
                Some([a?, b?, c?])
            })
            .collect();
        let rings: Vec<&[DVec2]> = ranges
            .iter()
            .map(|range: &Range<u32>| &points[range.start as usize..range.end as usize])
            .collect();
        let boundary = PlanarBoundary::of_mesh(&rings).with_sides(Vec::new(), side_of.clone());
        let problem = Problem::triangulated(&boundary, &triangles?).ok()?;
        let keeps_clear = problem.keeps_clear();
        let vertices = vertices.iter().map(|&vertex| self.numbers[vertex as usize]).collect();
        Some(Outline { vertices, points, rings: ranges, side_of, keeps_clear })
    }

    /// The straight side of each edge of a ring: by the number from `first` on of the edge that it begins with.
    fn sides_of_ring(&self, ring: &[u32], first: u32) -> Vec<u32> {
        let n = ring.len();
        let is_straight = |at: usize| {
            let [before, here, after] = [ring[(at + n - 1) % n], ring[at], ring[(at + 1) % n]];
            match [self.ring_edge(before, here), self.ring_edge(here, after)] {
                [Some(a), Some(b)] => self.boundary.runs()[a] == self.boundary.runs()[b],
                _ => {
                    let [a, b, c] = [before, here, after].map(|v| self.mesh.points[v as usize]);
                    is_passed(b, [a, c])
                }
            }
        };
        let start = (0..n).find(|&at| !is_straight(at)).unwrap_or(0);
        let mut side_of = vec![0; n];
        let mut side = first;
        for at in (start..start + n).map(|at| at % n) {
            if !is_straight(at) {
                side = first + at as u32;
            }
            side_of[at] = side;
        }
        side_of
    }

    /// The edge of a ring of the domain from a vertex to another.
    fn ring_edge(&self, from: u32, to: u32) -> Option<usize> {
        let rings = self.domain.rings();
        let is_edge = from < rings.vertex_count() && rings.next(from) == to;
        is_edge.then_some(from as usize)
    }

    /// The intervals of a straight side whose triangles have too few apexes at a degree, if a face has one.
    fn crowded_side(&self, outline: &Outline, degree: u32) -> Option<u32> {
        let checked = outline.checked();
        let next = |place: u32| {
            let ring = checked.rings.iter().find(|ring| ring.contains(&place));
            ring.map_or(place, |ring| if place + 1 == ring.end { ring.start } else { place + 1 })
        };
        let named: BTreeSet<u32> = outline.side_of.iter().copied().collect();
        named.into_iter().find_map(|side| {
            let edges = (0..outline.side_of.len() as u32)
                .filter(|&place| outline.side_of[place as usize] == side);
            let edges: Vec<u32> = edges.collect();
            let on_side: BTreeSet<u32> =
                edges.iter().flat_map(|&place| [place, next(place)]).collect();
            let apexes =
                (0..outline.vertices.len() as u32).filter(|place| !on_side.contains(place));
            let apexes: u64 = apexes
                .map(|place| self.edges_at[outline.vertices[place as usize] as usize])
                .map(|edges| u64::from(degree.saturating_sub(edges.saturating_add(1))))
                .sum();
            (edges.len() as u64 > apexes + 2).then_some(edges.len() as u32)
        })
    }

    /// Whether the degrees of every mesh, weighted, are more than a degree; none if that cannot be told.
    fn weighs_more(&self, weights: &[u64], degree: u32) -> Option<bool> {
        if weights.len() != self.edges_at.len() {
            return None;
        }
        let of = |vertex: u32| u128::from(weights[vertex as usize]);
        let mut sum: u128 =
            (0..).zip(&self.edges_at).map(|(v, &edges)| of(v) * u128::from(edges)).sum();
        for face in &self.faces {
            let least = match self.ring_of(face).and_then(|ring| self.outline(&[ring])) {
                Some(outline) if outline.vertices.len() <= MOST_WEIGHED => {
                    let own: Vec<u64> =
                        outline.vertices.iter().map(|&vertex| weights[vertex as usize]).collect();
                    outline.least_weight(&own)?
                }
                _ => {
                    let vertices = face
                        .triangles
                        .iter()
                        .flatten()
                        .map(|&vertex| self.numbers[vertex as usize]);
                    let ends = 3 * face.triangles.len() - face.halves.len();
                    vertices.map(of).min()? * ends as u128
                }
            };
            sum += least;
        }
        let total: u128 = weights.iter().map(|&weight| u128::from(weight)).sum();
        Some(sum > total * u128::from(degree))
    }

    /// The only ring of a face, if it has one that passes no vertex twice.
    fn ring_of(&self, face: &Face) -> Option<Vec<u32>> {
        let next: BTreeMap<u32, u32> = face.halves.iter().map(|&[from, to]| (from, to)).collect();
        let first = *next.keys().next()?;
        let ring: Vec<u32> = std::iter::successors(Some(first), |from| {
            next.get(from).copied().filter(|&to| to != first)
        })
        .take(face.halves.len())
        .collect();
        (ring.len() == face.halves.len()).then_some(ring)
    }
}

/// For each of a number of vertices its number in the mesh that is joined at periodic sides.
fn joined_numbers(domain: &Domain, count: usize) -> Vec<u32> {
    let Some(periodic) = domain.periodic() else { return (0..count as u32).collect() };
    // Vertices that the pairs make one, until nothing changes.
    let mut least: Vec<u32> = (0..count as u32).collect();
    let mut is_changed = true;
    while is_changed {
        is_changed = false;
        for &[a, b] in periodic.sides().iter().flat_map(|side| &side.vertices) {
            let own = least[a as usize].min(least[b as usize]);
            is_changed |= least[a as usize] != own || least[b as usize] != own;
            (least[a as usize], least[b as usize]) = (own, own);
        }
    }
    let firsts: BTreeSet<u32> = least.iter().copied().collect();
    let number: BTreeMap<u32, u32> = firsts.into_iter().zip(0..).collect();
    least.iter().map(|vertex| number[vertex]).collect()
}

/// The edges of periodic sides, which are others in the joined mesh; the smaller end first.
fn moved_edges(domain: &Domain) -> BTreeSet<[u32; 2]> {
    let sides = domain.periodic().map_or(&[][..], |periodic| periodic.sides());
    let edges = sides.iter().flat_map(|side| side.vertices.windows(2));
    edges.map(|pair| [pair[0][0], pair[1][0]]).map(|[a, b]| [a.min(b), a.max(b)]).collect()
}

/// The number of edges at each of a number of vertices in the mesh that is joined at periodic sides.
pub(super) fn joined_degrees(domain: &Domain, triangles: &[[u32; 3]], count: usize) -> Vec<u32> {
    let (numbers, moved) = (joined_numbers(domain, count), moved_edges(domain));
    let edges: BTreeSet<[u32; 2]> =
        triangles.iter().flat_map(|&t| sides(t)).map(|[a, b]| [a.min(b), a.max(b)]).collect();
    let mut degrees = vec![0; count];
    for end in edges.difference(&moved).flatten() {
        degrees[numbers[*end as usize] as usize] += 1;
    }
    numbers.iter().map(|&number| degrees[number as usize]).collect()
}

impl Outline {
    fn checked(&self) -> CheckedOutline<'_> {
        CheckedOutline {
            points: &self.points,
            rings: &self.rings,
            side_of: &self.side_of,
            keeps_clear: self.keeps_clear,
        }
    }

    fn face(&self) -> CheckedFace<'_> {
        CheckedFace { outline: self.checked(), vertices: &self.vertices, least_tangent: 0.0 }
    }

    /// The least weight of the chords of all triangulations of a ring, where a chord weighs what its ends do. O(n³).
    fn least_weight(&self, weights: &[u64]) -> Option<u128> {
        let n = self.points.len();
        let checked = self.checked();
        let is_joined = |a: usize, b: usize| {
            b - a == 1 || b - a == n - 1 || checked.is_admissible([a as u32, b as u32])
        };
        // For each pair the least weight of what lies between them, with the chord that joins them.
        let mut best: Vec<Vec<Option<u128>>> = vec![vec![None; n]; n];
        for a in (0..n - 1).rev() {
            best[a][a + 1] = Some(0);
            for b in a + 2..n {
                if !is_joined(a, b) {
                    continue;
                }
                let inside = (a + 1..b).filter_map(|c| {
                    let is_triangle = turn(self.points[a], self.points[c], self.points[b]) > 0.0;
                    is_triangle.then(|| Some(best[a][c]? + best[c][b]?)).flatten()
                });
                let ends = u128::from(weights[a]) + u128::from(weights[b]);
                let chord = if b - a == n - 1 { 0 } else { ends };
                best[a][b] = inside.min().map(|inside| inside + chord);
            }
        }
        best[0][n - 1]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use mindeg_domain::Domain;
    use mindeg_exact::Refutation;
    use mindeg_mesh::TriMesh;

    /// Two squares of four intervals to a side, and one of eight beside them.
    fn map(long: u32) -> Domain {
        Domain::from_json(&format!(
            r#"{{"polygon": {{"corners": [[0, 0], [1, 0], [2, 0], [2, 1], [1, 1], [0, 1]]}},
                "sides": [{{"intervals": {long}}}, {{"intervals": 1}}, {{"intervals": 1}}, {{"intervals": 1}}, {{"intervals": 1}}, {{"intervals": 1}}],
                "lines": [{{"corners": [[1, 0], [1, 1]], "intervals": 1}}]}}"#
        ))
        .unwrap()
    }

    /// The check on a mesh of least degree, for a bound on the two faces.
    fn check(domain: &Domain, bound: &JointBound, at_least: u32) -> Option<Proof> {
        let mesh =
            crate::mesh(domain, crate::Goal::LeastDegree, mindeg_mesh::Progress::NONE).unwrap();
        let points: Vec<DVec3> = mesh.mesh.points().map(|point| point.extend(0.0)).collect();
        let mesh = TriMesh::new(points, mesh.mesh.triangles().collect()).unwrap();
        let mesh = crate::verify::triangulation(&mesh, domain, None).unwrap();
        let boundary = domain.boundary().unwrap();
        let n = domain.rings().vertex_count();
        let long = n - 5;
        let left: Vec<u32> = (0..=long).chain([n - 2, n - 1]).collect();
        let rings = [vec![left], vec![vec![long, long + 1, long + 2, n - 2]]];
        JointCheck::new(domain, &boundary, &mesh).unwrap().proof(bound, &rings, at_least)
    }

    #[test]
    fn wrong_bounds_are_refused() {
        let domain = map(12);
        let holds = |bound: &JointBound, at_least| check(&domain, bound, at_least).is_some();
        // 17 vertices, 12 + 5 edges of rings, one line, 11 + 1 + 1 chords: 30 edges and 60 ends.
        let sum = JointBound::Sum { sum: 999, vertices: 1 };
        assert_eq!([3, 4, 5].map(|degree| holds(&sum, degree)), [true, true, false]);
        let edges = JointBound::Edges { vertex: 12, edges: 99 };
        assert_eq!([3, 4].map(|degree| holds(&edges, degree)), [true, false]);
        // 10 edges of the side have the two corners above as apexes: one has 3 edges of lines and sides, one 2.
        let side = JointBound::Side { face: 0, intervals: 12, max_degree: 99 };
        assert_eq!([8, 9, 10].map(|degree| holds(&side, degree)), [true, true, false]);
        assert!(!holds(&JointBound::Side { face: 1, intervals: 12, max_degree: 9 }, 9));
        // With weight on these two alone, their degrees add up to all chords of the left and one more.
        let weights: Vec<u64> = (0..17).map(|vertex| u64::from(vertex >= 15)).collect();
        let weights = JointBound::Weights { weights, sum: 9999 };
        assert_eq!([8, 9, 10].map(|degree| holds(&weights, degree)), [true, true, false]);
        let nothing = Refutation { clauses: vec![vec![]] };
        let refuted = |max_degree| JointBound::Refuted { max_degree, refutation: nothing.clone() };
        assert_eq!([4, 20].map(|degree| holds(&refuted(degree), degree)), [true, false]);
    }
}
