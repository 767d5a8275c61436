//! The check of a map: lines are edges, holes are empty, groups are regions. It shares nothing with the mesher: it knows
//! no faces, only the lines of the domain and the triangles.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec2;
use mindeg_domain::{Domain, Region};
use mindeg_mesh::planar::PlanarBoundary;
use mindeg_mesh::{Group, TriMesh};
use robust::{Coord, orient2d};

use super::defect::{MeshDefect, at};
use super::matching::VerifiedMesh;

/// The lines of a map in a mesh.
pub(super) struct MapLines {
    /// The edges that lines consist of, both ways.
    edges: BTreeSet<[u32; 2]>,
    /// Of these, those without a triangle on their left.
    pub(super) open: Vec<[u32; 2]>,
}

/// Positive if three points run counter-clockwise; exact.
pub(super) fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    let [a, b, c] = [a, b, c].map(|p| Coord { x: p.x, y: p.y });
    orient2d(a, b, c)
}

impl MapLines {
    /// Finds the edges of all lines: each segment is one, or several in a row where it may be divided.
    pub(super) fn new(
        domain: &Domain,
        boundary: &PlanarBoundary,
        mesh: &VerifiedMesh,
    ) -> Result<Self, MeshDefect> {
        let mut lines = Self { edges: BTreeSet::new(), open: Vec::new() };
        if boundary.segments().is_empty() {
            return Ok(lines);
        }
        let halves: BTreeSet<[u32; 2]> = mesh.triangles.iter().flat_map(|&t| sides(t)).collect();
        let all: BTreeSet<[u32; 2]> = halves.iter().flat_map(|&[a, b]| [[a, b], [b, a]]).collect();
        let point = |vertex: u32| mesh.points[vertex as usize];
        let divisible = domain.divisible_segments();
        for (segment, &[from, to]) in boundary.segments().iter().enumerate() {
            let mut last = from;
            while last != to {
                let span = point(to) - point(from);
                let along = |vertex: u32| (point(vertex) - point(from)).dot(span);
                let is_ahead = |vertex: &u32| {
                    let off = span.perp_dot(point(*vertex) - point(from)).abs() / span.length();
                    off <= mesh.tolerance
                        && along(*vertex) > along(last)
                        && along(*vertex) < along(to)
                };
                let near = all.range([last, 0]..=[last, u32::MAX]).map(|edge| edge[1]);
                let next = if all.contains(&[last, to]) {
                    Some(to)
                } else {
                    let ahead = near.filter(|vertex| divisible[segment] && is_ahead(vertex));
                    ahead.min_by(|a, b| along(*a).total_cmp(&along(*b)))
                };
                let Some(next) = next else {
                    return Err(missing(domain, mesh, segment as u32, [from, to]));
                };
                for half in [[last, next], [next, last]] {
                    lines.edges.insert(half);
                    lines.open.extend((!halves.contains(&half)).then_some(half));
                }
                last = next;
            }
        }
        Ok(lines)
    }

    /// Checks that the faces without triangles are the holes: no others, and none of them covered.
    ///
    /// Triangles that pair up along all other edges cover each place 1 - w times, where w is how often the open edges
    /// wind around it. So w is 1 on the left of every open edge, and at every hole.
    pub(super) fn check_holes(
        &self,
        domain: &Domain,
        mesh: &VerifiedMesh,
    ) -> Result<(), MeshDefect> {
        let holes = domain.inside().regions.iter().filter(|region| region.hole);
        for hole in holes.clone() {
            if self.winding(mesh, hole.at, None, false) != 1 {
                let message = format!("triangles cover the hole at {}", at(hole.at));
                return Err(MeshDefect::new("filled_hole", message));
            }
        }
        let mut ends: BTreeMap<u32, [u32; 2]> = BTreeMap::new();
        for &[from, to] in &self.open {
            ends.entry(from).or_default()[0] += 1;
            ends.entry(to).or_default()[1] += 1;
        }
        // Open edges in a row, without a branch, have one face on their left.
        let next: BTreeMap<u32, usize> =
            self.open.iter().enumerate().map(|(index, edge)| (edge[0], index)).collect();
        let mut is_seen = vec![false; self.open.len()];
        for first in 0..self.open.len() {
            if is_seen[first] {
                continue;
            }
            let [from, to] = self.open[first].map(|vertex| mesh.points[vertex as usize]);
            let span = (to - from).abs();
            if self.winding(mesh, from.midpoint(to), Some(first), span.x > span.y) != 1 {
                let message = format!("triangles overlap near {}", at(from.midpoint(to)));
                return Err(MeshDefect::new("overlap", message));
            }
            let mut edge = first;
            while !std::mem::replace(&mut is_seen[edge], true) {
                let end = self.open[edge][1];
                match (ends.get(&end), next.get(&end)) {
                    (Some([1, 1]), Some(after)) => edge = *after,
                    _ => break,
                }
            }
        }
        let empty = empty_faces(mesh);
        let expected = domain.rings().ring_count() - 1 + holes.count();
        if empty != expected {
            let message = format!(
                "the mesh leaves {empty} places empty, and the domain has {expected} holes"
            );
            return Err(MeshDefect::new("empty_region", message));
        }
        Ok(())
    }

    /// How often the open edges wind around a point; just left of an edge if it is the middle of that one. The ray that
    /// counts runs along x, or along y.
    fn winding(&self, mesh: &VerifiedMesh, at: DVec2, of: Option<usize>, along_y: bool) -> i32 {
        let turned = |p: DVec2| if along_y { DVec2::new(p.y, -p.x) } else { p };
        let at = turned(at);
        let crossing = |(index, edge): (usize, &[u32; 2])| {
            let [from, to] = edge.map(|vertex| turned(mesh.points[vertex as usize]));
            let is_own = of == Some(index);
            if from.y <= at.y && to.y > at.y {
                i32::from(is_own || turn(from, to, at) > 0.0)
            } else if from.y > at.y && to.y <= at.y {
                -i32::from(!is_own && turn(from, to, at) < 0.0)
            } else {
                0
            }
        };
        self.open.iter().enumerate().map(crossing).sum()
    }

    /// Checks that each region lies in one group, and regions of other names in others, if the mesh has several groups.
    pub(super) fn check_groups(
        &self,
        domain: &Domain,
        mesh: &TriMesh,
        found: &VerifiedMesh,
    ) -> Result<(), MeshDefect> {
        let regions = &domain.inside().regions;
        let in_face = self.triangles_by_face(&found.triangles);
        let around = triangles_around(regions, found);
        let groups = if mesh.groups().len() > 1 { mesh.groups() } else { &[] };
        let labels: Vec<(String, Option<String>)> = groups.iter().map(label_of).collect();
        // Groups of one label are one.
        let mut group_of: Vec<Option<usize>> = vec![None; in_face.len()];
        let mut first_of = BTreeMap::new();
        for (index, (group, label)) in groups.iter().zip(&labels).enumerate() {
            let first = *first_of.entry(label).or_insert(index);
            let triangles = group.triangles.start as usize..group.triangles.end as usize;
            group_of[triangles].fill(Some(first));
        }
        let mut group_of_face = vec![None; in_face.len()];
        for (t, face) in in_face.iter().enumerate() {
            let own = group_of[t];
            if *group_of_face[*face as usize].get_or_insert(own) != own {
                let message =
                    format!("triangle {t} is of another group than the rest of its region");
                return Err(MeshDefect::new("group", message));
            }
        }
        let names: BTreeSet<String> =
            (0..regions.len() as u32).map(|region| domain.region_name(region)).collect();
        let mut known: BTreeMap<usize, String> = BTreeMap::new();
        for (index, region) in regions.iter().enumerate().filter(|(_, region)| !region.hole) {
            let Some(t) = around[index] else {
                let message = format!("region {} at {} has no triangles", index + 1, at(region.at));
                return Err(MeshDefect::new("empty_region", message));
            };
            let name = domain.region_name(index as u32);
            let Some(own) = group_of[t] else { continue };
            let label = &labels[own].0;
            let of_other = *label != name && names.contains(label);
            if of_other || known.get(&own).is_some_and(|before| *before != name) {
                let message =
                    format!("{name:?}, around {}, is in the group {label:?}", at(region.at));
                return Err(MeshDefect::new("group", message));
            }
            known.insert(own, name);
        }
        Ok(())
    }

    /// The edges of lines, both ways.
    pub(super) fn edges(&self) -> impl Iterator<Item = [u32; 2]> {
        self.edges.iter().copied()
    }

    /// Whether an edge is of a line.
    pub(super) fn has(&self, edge: [u32; 2]) -> bool {
        self.edges.contains(&edge)
    }

    /// For each triangle, the least triangle that can be reached without crossing a line.
    pub(super) fn triangles_by_face(&self, triangles: &[[u32; 3]]) -> Vec<u32> {
        let of_half: BTreeMap<[u32; 2], usize> = triangles
            .iter()
            .enumerate()
            .flat_map(|(t, triangle)| sides(*triangle).map(|side| (side, t)))
            .collect();
        let mut face = vec![u32::MAX; triangles.len()];
        for first in 0..triangles.len() {
            let mut open = vec![first];
            while let Some(t) = open.pop() {
                if face[t] != u32::MAX {
                    continue;
                }
                face[t] = first as u32;
                for side in sides(triangles[t]).iter().filter(|side| !self.edges.contains(*side)) {
                    open.extend(of_half.get(&[side[1], side[0]]).copied());
                }
            }
        }
        face
    }

    /// Whether the lines at a vertex alone prove that its degree is above a limit in any mesh: each sector between two of
    /// them takes a triangle, two from 180° on, three if it is the full turn.
    pub(super) fn exceeds(&self, mesh: &VerifiedMesh, vertex: u32, limit: u32) -> bool {
        let at = mesh.points[vertex as usize];
        let mut ends: Vec<DVec2> = self
            .edges
            .range([vertex, 0]..=[vertex, u32::MAX])
            .map(|edge| mesh.points[edge[1] as usize])
            .collect();
        let angle = |end: &DVec2| libm::atan2(end.y - at.y, end.x - at.x);
        ends.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
        let sector = |index: usize| {
            let (from, to) = (ends[index], ends[(index + 1) % ends.len()]);
            1 + u32::from(turn(at, from, to) <= 0.0) + u32::from(ends.len() == 1)
        };
        (0..ends.len()).map(sector).sum::<u32>() > limit
    }
}

fn label_of(group: &Group) -> (String, Option<String>) {
    (group.name.clone(), group.material.as_ref().map(|material| material.name.clone()))
}

/// A triangle's edges, the triangle on the left of each.
pub(super) fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

fn missing(domain: &Domain, mesh: &VerifiedMesh, segment: u32, ends: [u32; 2]) -> MeshDefect {
    let lines = domain.inner_lines();
    let own = lines.iter().find(|(line, _)| line.segments.contains(&segment));
    let name = own.map_or("a line", |(line, _)| &line.name);
    let [from, to] = ends.map(|vertex| mesh.points[vertex as usize]);
    let [a, b] = ends.map(|vertex| mesh.vertex_of[vertex as usize]);
    let place = at(from.midpoint(to));
    let message = format!("no edge from vertex {a} to vertex {b} near {place}, on {name}");
    MeshDefect::new("missing_edge", message)
}

/// The faces without triangles inside the outline: by Euler's formula, for a mesh whose triangles do not overlap.
fn empty_faces(mesh: &VerifiedMesh) -> usize {
    let mut part: BTreeMap<u32, u32> = BTreeMap::new();
    fn root(part: &mut BTreeMap<u32, u32>, vertex: u32) -> u32 {
        let mut at = vertex;
        while let Some(&above) = part.get(&at).filter(|above| **above != at) {
            if let Some(&higher) = part.get(&above) {
                part.insert(at, higher);
            }
            at = above;
        }
        part.entry(at).or_insert(at);
        at
    }
    let mut edges: BTreeSet<[u32; 2]> = BTreeSet::new();
    for [a, b] in mesh.triangles.iter().flat_map(|&t| sides(t)) {
        edges.insert([a.min(b), a.max(b)]);
        let [a, b] = [root(&mut part, a), root(&mut part, b)];
        part.insert(a.max(b), a.min(b));
    }
    let parts = part.iter().filter(|(vertex, above)| vertex == above).count();
    (parts + edges.len()).saturating_sub(part.len() + mesh.triangles.len())
}

/// A triangle around the point of each region.
fn triangles_around(regions: &[Region], mesh: &VerifiedMesh) -> Vec<Option<usize>> {
    let mut found = vec![None; regions.len()];
    let mut order: Vec<(f64, usize)> =
        regions.iter().enumerate().map(|(index, region)| (region.at.x, index)).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (t, triangle) in mesh.triangles.iter().enumerate() {
        let [a, b, c] = triangle.map(|vertex| mesh.points[vertex as usize]);
        let (low, high) = (a.min(b).min(c).x, a.max(b).max(c).x);
        let from = order.partition_point(|(x, _)| *x < low);
        for (_, index) in order[from..].iter().take_while(|(x, _)| *x <= high) {
            let at = regions[*index].at;
            if [[a, b], [b, c], [c, a]].iter().all(|[from, to]| turn(*from, *to, at) >= 0.0) {
                found[*index] = Some(t);
            }
        }
    }
    found
}
