//! A small part of a mesh as a mesh of its own, whose rim stays.

use crate::array_mesh::{ArrayMesh, Kind, NONE, Vertex};
use crate::filling::Filling;
use crate::goal::{Goal, Weights};
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};

/// A disc with a needy vertex in its middle, which has index 0.
#[derive(Debug, Clone)]
pub(crate) struct Disc {
    pub(crate) mesh: ArrayMesh,
    /// The index of each vertex in the whole mesh.
    names: Vec<u32>,
    /// The triangles of the whole mesh.
    triangles: Vec<u32>,
}

/// Discs with more do not grow further, as a rule.
pub(crate) const ENOUGH_TRIANGLES: usize = 200;
/// Larger discs are left alone.
const MOST_TRIANGLES: usize = 800;

impl Disc {
    /// Copies the triangles within so many rings round a vertex, until they are `enough`, and as many more as make one fan of those at
    /// each vertex. Vertices on the rim stay, and may have what their triangles outside leave of their degree.
    pub(crate) fn cut(
        whole: &ArrayMesh,
        weights: &Weights,
        center: u32,
        rings: usize,
        enough: usize,
    ) -> Option<Self> {
        let mut growing = Growing { vertices: vec![center], ..Growing::default() };
        growing.index.insert(center, 0);
        let mut inside = 0;
        for _ in 0..rings {
            let end = growing.vertices.len();
            for at in inside..end {
                growing.add_star(whole, growing.vertices[at]);
            }
            inside = end;
            if growing.triangles.len() > enough {
                break;
            }
        }
        while growing.close(whole) {
            if growing.triangles.len() > MOST_TRIANGLES {
                return None;
            }
        }
        growing.into_disc(whole, weights)
    }

    /// The vertices of the whole mesh in the disc.
    pub(crate) fn vertices(&self) -> &[u32] {
        &self.names
    }

    /// Puts another mesh of the disc, whose first vertices are the disc's, in its place.
    pub(crate) fn put_back(mut self, whole: &mut ArrayMesh, better: &ArrayMesh) {
        for (v, vertex) in better.vertices.iter().enumerate() {
            if v >= self.names.len() {
                let is_used = vertex.triangles > 0;
                self.names.push(if is_used {
                    whole.push_vertex(vertex.at, vertex.size, vertex.kind)
                } else {
                    NONE
                });
            } else if vertex.kind == Kind::Free && vertex.triangles > 0 {
                whole.move_to(self.names[v], vertex.at);
            }
        }
        let name = |v: u32| self.names[v as usize];
        let alive = better.triangles.iter().filter(|t| t.is_alive());
        let mut filling = Filling::default();
        alive.for_each(|t| filling.push(t.vertices.map(name), ()));
        whole.replace(&self.triangles, &filling);
        for [a, b] in better.locked_edges() {
            // The edge is there: it was in the disc's mesh.
            let _ = whole.lock(name(a), name(b), true);
        }
    }
}

/// The triangles and vertices of a disc that grows.
#[derive(Default)]
struct Growing {
    triangles: Vec<u32>,
    vertices: Vec<u32>,
    /// The index of each vertex.
    index: BTreeMap<u32, u32>,
    is_in: BTreeSet<u32>,
    star: Vec<u32>,
}

impl Growing {
    fn add_star(&mut self, whole: &ArrayMesh, vertex: u32) {
        let mut star = std::mem::take(&mut self.star);
        whole.star(vertex, &mut star);
        for t in &star {
            if !self.is_in.insert(*t) {
                continue;
            }
            self.triangles.push(*t);
            for v in whole.triangles[*t as usize].vertices {
                if let Entry::Vacant(entry) = self.index.entry(v) {
                    entry.insert(self.vertices.len() as u32);
                    self.vertices.push(v);
                }
            }
        }
        self.star = star;
    }

    /// Adds all triangles at vertices where the disc has more than one fan. True if there was one.
    fn close(&mut self, whole: &ArrayMesh) -> bool {
        let mut found = false;
        for at in 0..self.vertices.len() {
            let vertex = self.vertices[at];
            let is_closed = whole.star(vertex, &mut self.star);
            let is_in: Vec<bool> = self.star.iter().map(|t| self.is_in.contains(t)).collect();
            let starts = |i: usize| {
                let before = if i > 0 { is_in[i - 1] } else { is_closed && is_in[is_in.len() - 1] };
                is_in[i] && !before
            };
            if (0..is_in.len()).filter(|i| starts(*i)).count() > 1 {
                self.add_star(whole, vertex);
                found = true;
            }
        }
        found
    }

    fn into_disc(self, whole: &ArrayMesh, weights: &Weights) -> Option<Disc> {
        let mut counts = vec![0_u32; self.vertices.len()];
        let renamed = |t: &u32| whole.triangles[*t as usize].vertices.map(|v| self.index[&v]);
        let triangles: Vec<[u32; 3]> = self.triangles.iter().map(renamed).collect();
        triangles.iter().flatten().for_each(|v| counts[*v as usize] += 1);
        let mut goals = Vec::new();
        let mut vertices = Vec::with_capacity(counts.len());
        for (name, count) in self.vertices.iter().zip(counts) {
            let before = &whole.vertices[*name as usize];
            let mut vertex = Vertex { anchor: NONE, goal: NONE, triangles: 0, ..*before };
            let outside = before.triangles - count;
            let goal = whole.goals.get(before.goal as usize).copied();
            if outside > 0 {
                vertex.kind = Kind::Boundary;
            }
            if outside > 0 || goal.is_some() {
                vertex.goal = goals.len() as u32;
                goals.push(goal.unwrap_or_else(|| weights.goal_inside()).beside(outside));
            }
            vertices.push(vertex);
        }
        let mut locked = Vec::new();
        for t in &self.triangles {
            let triangle = &whole.triangles[*t as usize];
            for i in (0..3).filter(|i| triangle.is_locked(*i)) {
                if triangle.neighbours[i] != NONE && self.is_in.contains(&triangle.neighbours[i]) {
                    locked.push([1, 2].map(|j| self.index[&triangle.vertices[(i + j) % 3]]));
                }
            }
        }
        let mesh = ArrayMesh::new(vertices, &triangles, goals, &locked).ok()?;
        Some(Disc { mesh, names: self.vertices, triangles: self.triangles })
    }
}

impl Goal {
    /// The goal that remains beside `outside` triangles elsewhere. No fan begins where only a part of the
    /// triangles may change.
    fn beside(self, outside: u32) -> Self {
        if outside == 0 {
            return self;
        }
        Self {
            least: self.least.saturating_sub(outside),
            triangles: self.triangles.saturating_sub(outside),
            ideal: self.ideal - f64::from(outside),
            fan: Some(1),
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::array_mesh::tests::grid;
    use crate::options::Options;

    #[test]
    fn a_disc_that_is_put_back_leaves_the_mesh_as_it_was() {
        let weights = Weights::local(&Options::default(), 36.0);
        let sorted = |mesh: &ArrayMesh| {
            let alive = mesh.triangles.iter().filter(|t| t.is_alive());
            let mut all: Vec<[u32; 3]> = alive
                .map(|t| {
                    let mut vertices = t.vertices;
                    let least = (0..3).min_by_key(|i| vertices[*i]).unwrap();
                    vertices.rotate_left(least);
                    vertices
                })
                .collect();
            all.sort_unstable();
            all
        };
        let start = grid(7);
        for center in 0..64 {
            for rings in 1..5 {
                let mut mesh = start.clone();
                let disc = Disc::cut(&mesh, &weights, center, rings, ENOUGH_TRIANGLES).unwrap();
                // Degrees count with the triangles outside.
                for (v, name) in (0..).zip(&disc.names) {
                    let [small, whole] = [(&disc.mesh, v), (&mesh, *name)];
                    assert_eq!(
                        weights.excess(small.0, small.1) == 0,
                        weights.excess(whole.0, whole.1) == 0
                    );
                }
                let same = disc.mesh.clone();
                disc.put_back(&mut mesh, &same);
                mesh.check().unwrap();
                assert_eq!(sorted(&mesh), sorted(&start));
                assert_eq!(mesh.locked_edges().len(), 2);
                assert_eq!(mesh.vertices.len(), start.vertices.len());
            }
        }
    }
}
