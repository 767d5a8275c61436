//! The surroundings of a narrow place, as far as a mesh of it depends on that, and the angle that a mesh has there.
//!
//! A piece of a strait alone would be closed by edges across its mouths, which a mesh need not have. So triangles are taken
//! until these edges are far enough, and the edges get points, as if there were a mesh beyond.

use super::step::Step;
use crate::chains::Chains;
use crate::demands::GROWTH;
use crate::edges::LONGEST;
use glam::DVec2;
use mindeg_interior::{generate_once, least_angle};
use mindeg_mesh::planar::PlanarBoundary;
use mindeg_mesh::{Progress, edges_of, sorted};
use std::collections::{BTreeMap, BTreeSet};

/// The triangles up to so many edges across from those at the shores belong to the surroundings.
const REACH: usize = 8;
/// The most triangles of surroundings, about.
const MOST_TRIANGLES: usize = 600;

/// A triangulated domain: the chains as they are.
pub(super) struct Whole<'a> {
    pub(super) boundary: &'a PlanarBoundary,
    pub(super) triangles: &'a [[u32; 3]],
    /// The triangle on the left of each edge inside.
    pub(super) left: BTreeMap<[u32; 2], usize>,
    /// The chains' vertex of each of the rings.
    pub(super) vertices: Vec<u32>,
    /// The other way round.
    at_vertex: BTreeMap<u32, u32>,
    /// The edges of lines inside, in ascending order of their ends.
    lines: BTreeSet<[u32; 2]>,
}

impl<'a> Whole<'a> {
    /// `vertices`: the chains' vertex of each of the rings.
    pub(super) fn new(
        vertices: Vec<u32>,
        boundary: &'a PlanarBoundary,
        triangles: &'a [[u32; 3]],
    ) -> Self {
        let edges = (0..).zip(triangles).flat_map(|(index, corners)| {
            edges_of(*corners).into_iter().map(move |edge| (edge, index))
        });
        let lines = boundary.segments().iter().copied().map(sorted);
        Self {
            boundary,
            triangles,
            left: edges.collect(),
            at_vertex: vertices.iter().copied().zip(0..).collect(),
            vertices,
            lines: lines.collect(),
        }
    }

    /// Whether an edge is one of a ring, in its direction.
    pub(super) fn is_shore(&self, [a, b]: [u32; 2]) -> bool {
        a < self.vertices.len() as u32 && self.boundary.next(a) == b
    }

    fn is_line(&self, edge: [u32; 2]) -> bool {
        self.lines.contains(&sorted(edge))
    }

    /// The triangle beyond an edge of another one, unless a line is between them.
    fn beyond(&self, [a, b]: [u32; 2]) -> Option<usize> {
        self.left.get(&[b, a]).copied().filter(|_| !self.is_line([a, b]))
    }

    /// All triangles at a vertex.
    fn fan(&self, vertex: u32) -> impl Iterator<Item = usize> {
        self.left.range([vertex, 0]..=[vertex, u32::MAX]).map(|(_, triangle)| *triangle)
    }

    /// The surroundings of shores; none if that is not a domain.
    pub(super) fn around(&self, shores: &[Vec<u32>]) -> Option<Around> {
        let mut own = Cut { whole: self, triangles: BTreeSet::new(), queue: Vec::new() };
        for vertex in shores.iter().flatten() {
            own.take_fan(*self.at_vertex.get(vertex)?);
        }
        let mut start = 0;
        for _ in 0..REACH {
            let end = own.queue.len();
            for index in start..end {
                for side in edges_of(self.triangles[own.queue[index]]) {
                    if own.triangles.len() < MOST_TRIANGLES
                        && let Some(other) = self.beyond(side)
                    {
                        own.take(other);
                    }
                }
            }
            start = end;
        }
        own.rings().map(|rings| own.around(rings))
    }
}

/// Triangles of the whole, in the order in which they were taken.
struct Cut<'a> {
    whole: &'a Whole<'a>,
    triangles: BTreeSet<usize>,
    queue: Vec<usize>,
}

impl Cut<'_> {
    fn take(&mut self, triangle: usize) {
        if self.triangles.insert(triangle) {
            self.queue.push(triangle);
        }
    }

    /// Takes all triangles at a vertex.
    fn take_fan(&mut self, vertex: u32) {
        self.whole.fan(vertex).for_each(|triangle| self.take(triangle));
    }

    /// The edges with no triangle of the cut beyond them, as rings, with the domain on the left; none if they touch each other.
    fn rings(&mut self) -> Option<Vec<Vec<u32>>> {
        // All triangles at a vertex where they do make them part there.
        let next = loop {
            let mut next: BTreeMap<u32, u32> = BTreeMap::new();
            let mut touching = Vec::new();
            for &triangle in &self.triangles {
                for [a, b] in edges_of(self.whole.triangles[triangle]) {
                    let beyond = self.whole.beyond([a, b]);
                    let is_rim = beyond.is_none_or(|beyond| !self.triangles.contains(&beyond));
                    if is_rim && next.insert(a, b).is_some() {
                        touching.push(a);
                    }
                }
            }
            if touching.is_empty() {
                break next;
            }
            // Where all are taken a line ends or goes through, and stays two edges of the rim, whatever else is taken.
            if touching.iter().any(|v| self.whole.fan(*v).all(|t| self.triangles.contains(&t))) {
                return None;
            }
            touching.into_iter().for_each(|vertex| self.take_fan(vertex));
        };
        let mut seen: BTreeSet<u32> = BTreeSet::new();
        let mut rings: Vec<Vec<u32>> = Vec::new();
        for &start in next.keys() {
            let mut ring = Vec::new();
            let mut vertex = start;
            while seen.insert(vertex) {
                ring.push(vertex);
                vertex = *next.get(&vertex)?;
            }
            if !ring.is_empty() {
                rings.push(ring);
            }
        }
        // The outer one is the only one that is counter-clockwise.
        let at = |v: u32| self.whole.boundary.point(v);
        let doubled = |ring: &Vec<u32>| -> f64 {
            let ends = ring.iter().zip(ring.iter().cycle().skip(1));
            ends.map(|(a, b)| (at(*a) - at(ring[0])).perp_dot(at(*b) - at(ring[0]))).sum()
        };
        rings.sort_by(|a, b| doubled(b).total_cmp(&doubled(a)));
        Some(rings)
    }

    fn around(&self, rings: Vec<Vec<u32>>) -> Around {
        let whole = self.whole;
        let on_rim: BTreeSet<u32> = rings.iter().flatten().copied().collect();
        let corners = self.triangles.iter().flat_map(|triangle| whole.triangles[*triangle]);
        let inner: BTreeSet<u32> = corners.filter(|v| !on_rim.contains(v)).collect();
        let rim = |ring: Vec<u32>| -> Vec<Rim> {
            let place = |v: u32| match whole.vertices.get(v as usize) {
                Some(vertex) => Place::Vertex(*vertex),
                None => Place::Point(whole.boundary.point(v)),
            };
            let edges = ring.iter().zip(ring.iter().cycle().skip(1));
            let rim = |(a, b): (&u32, &u32)| {
                let is_free = !whole.is_shore([*a, *b]) && !whole.is_line([*a, *b]);
                Rim { place: place(*a), is_shore: whole.is_shore([*a, *b]), is_free }
            };
            edges.map(rim).collect()
        };
        Around {
            rings: rings.into_iter().map(rim).collect(),
            inner: inner.into_iter().map(|v| whole.boundary.point(v)).collect(),
        }
    }
}

#[derive(Clone, Copy)]
enum Place {
    /// A vertex of the chains.
    Vertex(u32),
    Point(DVec2),
}

/// A corner of the surroundings, and the edge from there to the next one.
#[derive(Clone, Copy)]
struct Rim {
    place: Place,
    is_shore: bool,
    /// Whether the edge goes across the domain.
    is_free: bool,
}

/// The surroundings of a narrow place.
pub(super) struct Around {
    rings: Vec<Vec<Rim>>,
    inner: Vec<DVec2>,
}

impl Around {
    /// Meshes it with the chains as they are now and a change; gives `was` where that is what was meshed, and none if there is no mesh.
    pub(super) fn meshed(
        &self,
        chains: &Chains<'_>,
        shores: &[Vec<u32>],
        step: Option<Step>,
        was: Option<&Meshed>,
    ) -> Option<Meshed> {
        let rings: Vec<Vec<Corner>> =
            self.rings.iter().map(|ring| corners(chains, ring, step)).collect();
        if let Some(was) = was.filter(|was| was.rings == rings && was.inner == self.inner) {
            return Some(was.clone());
        }
        let at_shores: BTreeSet<u32> = shores.iter().flatten().copied().collect();
        let vertices: Vec<Option<u32>> =
            rings.iter().flatten().map(|corner| corner.vertex).collect();
        let points: Vec<Vec<DVec2>> =
            rings.iter().map(|ring| ring.iter().map(|corner| corner.at).collect()).collect();
        let (outline, turned) = PlanarBoundary::map(&points, &self.inner, &[]).ok()?;
        if !turned.is_empty() {
            return None;
        }
        let mesh = generate_once(&outline, &chains.options(), Progress::NONE).ok()?;
        let of_chains = |v: &u32| vertices.get(*v as usize).copied().flatten();
        let is_at_shores = |v: &u32| of_chains(v).is_some_and(|v| at_shores.contains(&v));
        let counted = mesh.triangles.iter().filter(|corners| corners.iter().any(is_at_shores));
        let angle = |corners: &[u32; 3]| least_angle(corners.map(|v| mesh.points[v as usize]));
        let angles = counted.map(|corners| (angle(corners), corners));
        let (angle, worst) = angles.min_by(|a, b| a.0.total_cmp(&b.0))?;
        // The triangle and those across its edges.
        let is_beside =
            |corners: &&[u32; 3]| corners.iter().filter(|v| worst.contains(v)).count() > 1;
        let beside = mesh.triangles.iter().filter(is_beside).flatten().filter_map(of_chains);
        let (beside, inner) = (beside.collect(), self.inner.clone());
        Some(Meshed { angle, beside, rings, inner })
    }
}

/// The measures of a mesh of surroundings.
#[derive(Clone)]
pub(super) struct Meshed {
    /// The minimum angle of the triangles at the shores, in degrees.
    pub(super) angle: f64,
    /// The vertices of the chains at the triangle that has it and beside it.
    pub(super) beside: BTreeSet<u32>,
    /// The polygon that was meshed, and the points inside that stay.
    rings: Vec<Vec<Corner>>,
    inner: Vec<DVec2>,
}

/// A corner of the polygon that is meshed.
#[derive(Clone, PartialEq)]
struct Corner {
    at: DVec2,
    vertex: Option<u32>,
    /// The mean length of the edges beside it in the chains.
    size: f64,
}

/// The corners of a ring: shores as they are now but for a change, and points on edges across the domain.
fn corners(chains: &Chains<'_>, ring: &[Rim], step: Option<Step>) -> Vec<Corner> {
    let is_dropped = |v: u32| matches!(step, Some(Step::Drop { vertex }) if vertex == v);
    let corner = |v: u32| {
        let at = match step {
            Some(Step::Shift { vertex, to }) if vertex == v => to,
            _ => chains.at(v),
        };
        let size = (chains.length(v) + chains.length(chains.previous(v))) / 2.0;
        Corner { at, vertex: Some(v), size }
    };
    let new = |at| Corner { at, vertex: None, size: f64::INFINITY };
    let is_alive = |rim: &Rim| match rim.place {
        Place::Vertex(v) => chains.vertices[v as usize].is_alive,
        Place::Point(_) => true,
    };
    let first = ring.iter().position(is_alive).unwrap_or(0);
    let mut alive: Vec<Rim> = Vec::new();
    for rim in ring[first..].iter().chain(&ring[..first]) {
        match alive.last_mut() {
            // Where a point is gone, the edge before it ends at the next: a shore that ends at an edge across is one no longer.
            Some(before) if !is_alive(rim) => {
                before.is_shore &= rim.is_shore;
                before.is_free |= rim.is_free;
            }
            _ => alive.push(*rim),
        }
    }
    let mut corners: Vec<Corner> = Vec::new();
    // The corners that begin edges across the domain.
    let mut across: BTreeSet<usize> = BTreeSet::new();
    for (index, rim) in alive.iter().enumerate() {
        match (&rim.place, &alive[(index + 1) % alive.len()].place) {
            (Place::Vertex(from), Place::Vertex(to)) if rim.is_shore => {
                // The chain as it is now between two vertices of the rim.
                let own = std::iter::successors(Some(*from), |v| Some(chains.next(*v)));
                for v in own.take_while(|v| v != to).filter(|v| !is_dropped(*v)) {
                    corners.push(corner(v));
                    match step {
                        Some(Step::Insert { edge, at }) if edge == v => corners.push(new(at)),
                        _ => {}
                    }
                }
                continue;
            }
            (Place::Vertex(v), _) => corners.push(corner(*v)),
            (Place::Point(at), _) => corners.push(new(*at)),
        }
        if rim.is_free {
            across.insert(corners.len() - 1);
        }
    }
    let mut all: Vec<Corner> = Vec::new();
    let firsts: Vec<(DVec2, f64)> = corners.iter().map(|corner| (corner.at, corner.size)).collect();
    for (index, corner) in corners.into_iter().enumerate() {
        let ends = [(corner.at, corner.size), firsts[(index + 1) % firsts.len()]];
        all.push(corner);
        if across.contains(&index) {
            let length = ends[0].0.distance(ends[1].0);
            let put = &mut |at| all.push(new(at));
            divided(ends.map(|end| end.0), ends.map(|end| end.1.min(length)), put);
        }
    }
    all
}

/// Halves an edge until its parts have the lengths that are wanted at its ends, and grow from there.
fn divided([a, b]: [DVec2; 2], [at_a, at_b]: [f64; 2], put: &mut impl FnMut(DVec2)) {
    let length = a.distance(b);
    let wanted = at_a.min(at_b) + GROWTH * length / 2.0;
    if length > LONGEST * wanted {
        let middle = a.midpoint(b);
        divided([a, middle], [at_a, wanted], put);
        put(middle);
        divided([middle, b], [wanted, at_b], put);
    }
}

/// Where a mesh of the whole would have more points than so many for each edge, those far inside are fewer.
const MOST_FOR_AN_EDGE: f64 = 24.0;

/// The length of edges far inside a domain that is wide beside its edges, so that a mesh of it takes no longer than one of a coast; none
/// for others, whose mesh tells most as it will be.
pub(super) fn size_far_inside(boundary: &PlanarBoundary) -> Option<f64> {
    let count = f64::from(boundary.edge_count());
    let ends = boundary.edges().map(|ends| ends.map(|vertex| boundary.point(vertex)));
    let mean = ends.map(|[a, b]| a.distance(b)).sum::<f64>() / count;
    // Two triangles for each point, which are about equilateral.
    let points = boundary.area() / (mean * mean * 3_f64.sqrt() / 2.0);
    let many = points / (MOST_FOR_AN_EDGE * count);
    (many > 1.0).then(|| mean * many.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square of 8,192 edges took 47 s, nearly all for points far from them.
    #[test]
    fn edges_far_inside_are_longer_in_wide_domains_alone() {
        let of = |width: u32, height: u32| {
            let at = |x: u32, y: u32| DVec2::new(f64::from(x), f64::from(y));
            let there = (0..width).map(|x| at(x, 0)).chain((0..height).map(|y| at(width, y)));
            let back = (1..=width).rev().map(|x| at(x, height));
            let ring: Vec<DVec2> =
                there.chain(back).chain((1..=height).rev().map(|y| at(0, y))).collect();
            size_far_inside(&PlanarBoundary::new(&[ring]).unwrap())
        };
        assert_eq!([of(1000, 20), of(40, 40)], [None; 2]);
        let size = of(1000, 1000).unwrap();
        assert!((2.0..5.0).contains(&size), "{size}");
    }

    /// Counties of a map: the search went along all their borders, for each narrow place.
    #[test]
    fn surroundings_with_a_line_inside_end_where_it_is_met() {
        const LENGTH: u32 = 40;
        let at = |x: u32, y: f64| DVec2::new(f64::from(x), y);
        let bottom = (0..=LENGTH).map(|x| at(x, 0.0));
        let ring: Vec<DVec2> = bottom.chain((0..=LENGTH).rev().map(|x| at(x, 2.0))).collect();
        let first = ring.len() as u32;
        let inner: Vec<DVec2> = (1..LENGTH).map(|x| at(x, 1.0)).collect();
        let line: Vec<u32> = (first..).take(inner.len()).collect();
        let (boundary, _) = PlanarBoundary::map(&[ring], &inner, &[line]).unwrap();
        let (inner, lines) = (boundary.inner_points(), boundary.segments());
        let triangles =
            mindeg_delaunay::triangles(&boundary, inner, lines, Progress::NONE).unwrap();
        let whole = Whole::new((0..first).collect(), &boundary, &triangles);
        let mut cut = Cut { whole: &whole, triangles: BTreeSet::new(), queue: Vec::new() };
        // The fan of one vertex of the line ends at the next ones on both sides.
        cut.take_fan(first + LENGTH / 2);
        let fan = cut.triangles.len();
        assert!(cut.rings().is_none());
        assert!(cut.triangles.len() <= 3 * fan, "{} of {fan}", cut.triangles.len());
    }
}
