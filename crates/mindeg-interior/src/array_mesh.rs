//! The mesh that the optimiser works on: arrays of triangles and neighbours, with an undo log.
//!
//! # Invariants
//!
//! 1. Triangles are counter-clockwise; a dead one has [`NONE`] as its first vertex.
//! 2. `neighbours[i]` lies across the edge opposite `vertices[i]`, and knows this triangle in turn; [`NONE`]
//!    marks a boundary edge.
//! 3. `labels[i]` says what the edge opposite vertex i is a part of, if it stays; both triangles agree.
//! 4. `anchor` of a vertex is one of its triangles, or [`NONE`] if it is dead;
//!    `triangles` is their number.
//! 5. The triangles at a vertex form one fan: closed inside, open at the boundary.
//!
//! [`check`](ArrayMesh::check) tests them all; [`replace`](ArrayMesh::replace) tests what it touched in debug builds.

use crate::goal::Goal;
use crate::space::{Plane, Space};

/// No triangle, no vertex.
pub(crate) const NONE: u32 = u32::MAX;

/// The operations that a vertex allows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// On the boundary: stays.
    Boundary,
    /// Inside, but wanted by the user: stays.
    Fixed,
    /// On a curve: may move along it and go.
    Curve,
    /// Inside: may move and go.
    Free,
}

impl Kind {
    /// True if the vertex may move.
    pub(crate) fn is_movable(self) -> bool {
        matches!(self, Self::Free | Self::Curve)
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Vertex<S: Space = Plane> {
    pub(crate) at: S::Site,
    /// The wanted edge length here.
    pub(crate) size: f64,
    pub(crate) anchor: u32,
    /// The index of a boundary vertex's goal.
    pub(crate) goal: u32,
    pub(crate) triangles: u32,
    pub(crate) kind: Kind,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Triangle<S: Space = Plane> {
    pub(crate) vertices: [u32; 3],
    pub(crate) neighbours: [u32; 3],
    pub(crate) labels: [S::Label; 3],
    pub(crate) patch: S::Patch,
}

impl<S: Space> Triangle<S> {
    pub(crate) fn new(vertices: [u32; 3], patch: S::Patch) -> Self {
        Self { vertices, neighbours: [NONE; 3], labels: [S::Label::default(); 3], patch }
    }

    /// True if the edge opposite a corner stays.
    pub(crate) fn is_locked(&self, corner: usize) -> bool {
        self.labels[corner] != S::Label::default()
    }

    pub(crate) fn is_alive(&self) -> bool {
        self.vertices[0] != NONE
    }

    /// Where `vertex` is among the three.
    pub(crate) fn corner(&self, vertex: u32) -> usize {
        if self.vertices[0] == vertex {
            0
        } else if self.vertices[1] == vertex {
            1
        } else {
            2
        }
    }
}

/// One write, with what was there before.
#[derive(Debug, Clone, Copy)]
enum Change<S: Space> {
    Triangle(u32, Triangle<S>),
    Vertex(u32, Vertex<S>),
    NewTriangle,
    NewVertex,
}

/// The triangles, the vertices, and the way back.
#[derive(Debug, Clone)]
pub(crate) struct ArrayMesh<S: Space = Plane> {
    pub(crate) space: S,
    pub(crate) vertices: Vec<Vertex<S>>,
    pub(crate) triangles: Vec<Triangle<S>>,
    pub(crate) goals: Vec<Goal>,
    log: Vec<Change<S>>,
    is_recording: bool,
}

impl ArrayMesh {
    /// Links triangles into a mesh.
    ///
    /// `locked` are edges that must stay. Fails with a vertex where the triangles do not
    /// form one fan, or with an edge that two triangles use in one direction.
    pub(crate) fn new(
        vertices: Vec<Vertex>,
        triangles: &[[u32; 3]],
        goals: Vec<Goal>,
        locked: &[[u32; 2]],
    ) -> Result<Self, String> {
        let mut mesh = Self::linked(Plane, vertices, triangles, &[], goals)?;
        for [a, b] in locked {
            mesh.lock(*a, *b, true)?;
        }
        Ok(mesh)
    }
}

impl<S: Space> ArrayMesh<S> {
    /// Links triangles into a mesh without locked edges. `patches`: of each triangle, or none.
    ///
    /// Fails with a vertex where the triangles do not form one fan, or with an edge that two triangles use in one direction.
    pub(crate) fn linked(
        space: S,
        vertices: Vec<Vertex<S>>,
        triangles: &[[u32; 3]],
        patches: &[S::Patch],
        goals: Vec<Goal>,
    ) -> Result<Self, String> {
        let patch = |t: usize| patches.get(t).copied().unwrap_or_default();
        let triangles =
            triangles.iter().enumerate().map(|(t, v)| Triangle::new(*v, patch(t))).collect();
        let (log, is_recording) = (Vec::new(), false);
        let mut mesh = Self { space, vertices, triangles, goals, log, is_recording };
        mesh.link()?;
        mesh.anchor()?;
        Ok(mesh)
    }

    fn link(&mut self) -> Result<(), String> {
        // Half-edges by their lower vertex, in lists: no hash map, no sorting.
        let count = self.vertices.len();
        let mut heads = vec![NONE; count];
        let mut nexts = vec![NONE; 3 * self.triangles.len()];
        for half in 0..nexts.len() as u32 {
            let (from, to) = self.ends(half);
            let mut other = heads[from.min(to) as usize];
            while other != NONE {
                let ends = self.ends(other);
                if ends == (from, to) {
                    return Err(format!("two triangles use edge {from}-{to} in one direction"));
                }
                if ends == (to, from) {
                    let (t, i) = (half as usize / 3, half as usize % 3);
                    let (u, j) = (other as usize / 3, other as usize % 3);
                    self.triangles[t].neighbours[i] = u as u32;
                    self.triangles[u].neighbours[j] = t as u32;
                }
                other = nexts[other as usize];
            }
            nexts[half as usize] = heads[from.min(to) as usize];
            heads[from.min(to) as usize] = half;
        }
        Ok(())
    }

    /// The directed edge opposite corner `half % 3` of triangle `half / 3`.
    fn ends(&self, half: u32) -> (u32, u32) {
        let vertices = self.triangles[half as usize / 3].vertices;
        let corner = half as usize % 3;
        (vertices[(corner + 1) % 3], vertices[(corner + 2) % 3])
    }

    fn anchor(&mut self) -> Result<(), String> {
        for (t, triangle) in (0..).zip(&self.triangles) {
            for v in triangle.vertices {
                self.vertices[v as usize].anchor = t;
                self.vertices[v as usize].triangles += 1;
            }
        }
        let mut star = Vec::new();
        for v in 0..self.vertices.len() as u32 {
            let vertex = self.vertices[v as usize];
            if vertex.anchor == NONE {
                continue;
            }
            self.star(v, &mut star);
            if star.len() as u32 != vertex.triangles {
                return Err(format!("the triangles at vertex {v} form more than one fan"));
            }
        }
        Ok(())
    }

    /// Makes an edge stay; an error if it is not there.
    pub(crate) fn lock(&mut self, a: u32, b: u32, label: S::Label) -> Result<(), String> {
        let mut star = Vec::new();
        self.star(a, &mut star);
        let mut found = false;
        for t in star {
            let triangle = &mut self.triangles[t as usize];
            if triangle.vertices.contains(&b) {
                let corner = (0..3).find(|i| ![a, b].contains(&triangle.vertices[*i]));
                triangle.labels[corner.unwrap_or(0)] = label;
                found = true;
            }
        }
        if found { Ok(()) } else { Err(format!("edge {a}-{b} is missing")) }
    }

    pub(crate) fn at(&self, vertex: u32) -> S::Vector {
        S::position(&self.vertices[vertex as usize].at)
    }

    pub(crate) fn corners(&self, triangle: u32) -> [S::Vector; 3] {
        self.triangles[triangle as usize].vertices.map(|v| self.at(v))
    }

    /// The triangles at a vertex, counter-clockwise, from the boundary if it has one. True if closed.
    pub(crate) fn star(&self, vertex: u32, out: &mut Vec<u32>) -> bool {
        out.clear();
        let start = self.vertices[vertex as usize].anchor;
        let mut at = start;
        loop {
            out.push(at);
            let triangle = &self.triangles[at as usize];
            at = triangle.neighbours[(triangle.corner(vertex) + 1) % 3];
            if at == start {
                return true;
            }
            if at == NONE {
                break;
            }
        }
        // The rest of an open fan, from the start backwards.
        let forward = out.len();
        at = start;
        loop {
            let triangle = &self.triangles[at as usize];
            at = triangle.neighbours[(triangle.corner(vertex) + 2) % 3];
            if at == NONE {
                break;
            }
            out.push(at);
        }
        out[forward..].reverse();
        out.rotate_left(forward);
        false
    }

    /// From now on writes are kept, to be undone.
    pub(crate) fn record(&mut self) {
        self.is_recording = true;
    }

    /// A place in the log to go back to.
    pub(crate) fn mark(&self) -> usize {
        self.log.len()
    }

    /// Takes back all writes since `mark`, the last first.
    pub(crate) fn undo(&mut self, mark: usize) {
        while self.log.len() > mark {
            match self.log.pop() {
                Some(Change::Triangle(t, before)) => self.triangles[t as usize] = before,
                Some(Change::Vertex(v, before)) => self.vertices[v as usize] = before,
                Some(Change::NewTriangle) => drop(self.triangles.pop()),
                Some(Change::NewVertex) => drop(self.vertices.pop()),
                None => {}
            }
        }
    }

    /// Keeps all writes for good and stops recording.
    pub(crate) fn commit(&mut self) {
        self.log.clear();
        self.is_recording = false;
    }

    /// Logs a triangle that is about to change.
    pub(crate) fn keep_triangle(&mut self, triangle: u32) {
        if self.is_recording {
            self.log.push(Change::Triangle(triangle, self.triangles[triangle as usize]));
        }
    }

    /// Logs a vertex that is about to change.
    pub(crate) fn keep_vertex(&mut self, vertex: u32) {
        if self.is_recording {
            self.log.push(Change::Vertex(vertex, self.vertices[vertex as usize]));
        }
    }

    pub(crate) fn move_to(&mut self, vertex: u32, at: S::Site) {
        self.keep_vertex(vertex);
        self.vertices[vertex as usize].at = at;
    }

    /// A new triangle that nothing is linked to.
    pub(crate) fn push_triangle(&mut self, triangle: Triangle<S>) {
        self.triangles.push(triangle);
        if self.is_recording {
            self.log.push(Change::NewTriangle);
        }
    }

    /// A new vertex, to be used by the next [`replace`](Self::replace).
    pub(crate) fn push_vertex(&mut self, at: S::Site, size: f64, kind: Kind) -> u32 {
        self.vertices.push(Vertex { at, size, anchor: NONE, goal: NONE, triangles: 0, kind });
        if self.is_recording {
            self.log.push(Change::NewVertex);
        }
        self.vertices.len() as u32 - 1
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::operations::{Cavity, operations};
    use crate::samples;
    use glam::DVec2;
    use proptest::prelude::*;

    /// A square of 2 by 2 cells on each side, each cell cut in two, with a locked edge inside.
    pub(crate) fn grid(cells: u32) -> ArrayMesh {
        let across = cells + 1;
        let on_rim = |i: u32| i == 0 || i == cells;
        let vertex = |v: u32| Vertex {
            at: DVec2::new(f64::from(v % across), f64::from(v / across)),
            size: 1.0,
            anchor: NONE,
            goal: NONE,
            triangles: 0,
            kind: match (
                on_rim(v % across) || on_rim(v / across),
                v == across + 1 || v == across + 2,
            ) {
                (true, _) => Kind::Boundary,
                (false, true) => Kind::Fixed,
                (false, false) => Kind::Free,
            },
        };
        let vertices = (0..across * across).map(vertex).collect();
        let triangles: Vec<[u32; 3]> = (0..cells * cells)
            .map(|cell| cell / cells * across + cell % cells)
            .flat_map(|v| [[v, v + 1, v + across + 1], [v, v + across + 1, v + across]])
            .collect();
        ArrayMesh::new(vertices, &triangles, Vec::new(), &[[across + 1, across + 2]]).unwrap()
    }

    proptest! {
        /// Whatever operations are done, the invariants hold, the locked edge stays, and undoing restores
        /// the mesh bit for bit.
        #[test]
        fn random_operations_keep_the_invariants(
            steps in prop::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>()), 1..60),
        ) {
            let mut mesh = grid(5);
            let start = mesh.clone();
            mesh.record();
            let mut cavity = Cavity::default();
            let mut list = Vec::new();
            for (place, choice) in steps {
                let alive: Vec<u32> = (0..mesh.vertices.len() as u32)
                    .filter(|v| mesh.vertices[*v as usize].triangles > 0)
                    .collect();
                operations(&mesh, *place.get(&alive), true, &mut list);
                if list.is_empty() {
                    continue;
                }
                let operation = *choice.get(&list);
                let mark = mesh.mark();
                let before = mesh.clone();
                let is_done = cavity.open(&mesh, operation) && cavity.plan(&mut mesh, operation);
                if is_done {
                    cavity.carry_out(&mut mesh);
                }
                mesh.check().map_err(TestCaseError::fail)?;
                if !is_done {
                    mesh.undo(mark);
                    prop_assert_eq!(&mesh.triangles, &before.triangles);
                    prop_assert_eq!(&mesh.vertices, &before.vertices);
                }
                let area: f64 = (0..mesh.triangles.len() as u32)
                    .filter(|t| mesh.triangles[*t as usize].is_alive())
                    .map(|t| crate::triangle::doubled_area(mesh.corners(t)))
                    .sum();
                prop_assert!((area - 50.0).abs() < 1e-9);
                let locked = mesh.triangles.iter().filter(|t| t.is_alive() && (0..3).any(|i| t.is_locked(i))).count();
                prop_assert_eq!(locked, 2);
            }
            mesh.undo(0);
            prop_assert_eq!(&mesh.triangles, &start.triangles);
            prop_assert_eq!(&mesh.vertices, &start.vertices);
        }
    }

    #[test]
    fn stars_are_counter_clockwise_and_begin_at_the_boundary() {
        let mesh = grid(3);
        let mut star = Vec::new();
        for v in 0..16 {
            let is_closed = mesh.star(v, &mut star);
            assert_eq!(is_closed, mesh.vertices[v as usize].kind != Kind::Boundary);
            for pair in star.windows(2) {
                let triangle = mesh.triangles[pair[0] as usize];
                assert_eq!(triangle.neighbours[(triangle.corner(v) + 1) % 3], pair[1]);
            }
        }
    }

    #[test]
    fn the_sample_outline_has_boundary_angles() {
        let outline = samples::plate_with_hole();
        let total: f64 = (0..outline.vertex_count()).map(|v| outline.angle(v)).sum();
        // Rings of n and m vertices: (n - 2) pi inside the outer one, (m + 2) pi round the hole.
        assert!((total / std::f64::consts::PI - 92.0).abs() < 1e-9);
    }
}
