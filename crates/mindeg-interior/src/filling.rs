//! Filling a cavity of the mesh with other triangles: the one way in which triangles change.

use crate::array_mesh::{ArrayMesh, NONE, Triangle};
use crate::manifold::Manifold;
use crate::space::{Plane, Space};

/// An edge of a cavity's rim, seen from inside the cavity.
#[derive(Debug, Clone, Copy)]
struct Rim<S: Space> {
    from: u32,
    to: u32,
    neighbour: u32,
    label: S::Label,
}

/// The triangles that fill a cavity.
#[derive(Debug, Clone)]
pub(crate) struct Filling<S: Space = Plane> {
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The patch of each triangle.
    pub(crate) patches: Vec<S::Patch>,
    /// New edges that stay, whose ends are in any order.
    pub(crate) labels: Vec<([u32; 2], S::Label)>,
}

impl<S: Space> Default for Filling<S> {
    fn default() -> Self {
        Self { triangles: Vec::new(), patches: Vec::new(), labels: Vec::new() }
    }
}

impl<S: Space> Filling<S> {
    pub(crate) fn clear(&mut self) {
        self.triangles.clear();
        self.patches.clear();
        self.labels.clear();
    }

    pub(crate) fn push(&mut self, triangle: [u32; 3], patch: S::Patch) {
        self.triangles.push(triangle);
        self.patches.push(patch);
    }

    fn label(&self, a: u32, b: u32) -> S::Label {
        let found = self.labels.iter().find(|(ends, _)| *ends == [a, b] || *ends == [b, a]);
        found.map_or_else(S::Label::default, |(_, label)| *label)
    }
}

impl<S: Manifold> ArrayMesh<S> {
    /// Replaces connected triangles by others that fill the same cavity.
    ///
    /// The caller has made sure that `filling` has the rim of `removed`, but for edges without neighbours that it labels
    /// anew, and that no other locked edge lies between removed triangles ([`has_lock`](Self::has_lock)). New triangles
    /// get indices at the end.
    pub(crate) fn replace(&mut self, removed: &[u32], filling: &Filling<S>) {
        let added = &filling.triangles;
        let mut rim: Vec<Rim<S>> = Vec::with_capacity(removed.len() + 2);
        for t in removed {
            let triangle = self.triangles[*t as usize];
            for i in 0..3 {
                let neighbour = triangle.neighbours[i];
                if neighbour == NONE || !removed.contains(&neighbour) {
                    rim.push(Rim {
                        from: triangle.vertices[(i + 1) % 3],
                        to: triangle.vertices[(i + 2) % 3],
                        neighbour,
                        label: triangle.labels[i],
                    });
                }
            }
        }
        for t in removed {
            self.keep_triangle(*t);
            for v in self.triangles[*t as usize].vertices {
                self.keep_vertex(v);
                let vertex = &mut self.vertices[v as usize];
                vertex.triangles -= 1;
                vertex.anchor = NONE;
            }
            self.triangles[*t as usize] = Triangle::new([NONE; 3], S::Patch::default());
        }
        let first = self.triangles.len() as u32;
        for ((t, vertices), patch) in (first..).zip(added).zip(&filling.patches) {
            let mut triangle = Triangle::new(*vertices, *patch);
            for i in 0..3 {
                let (from, to) = (vertices[(i + 1) % 3], vertices[(i + 2) % 3]);
                if let Some(edge) = rim.iter().find(|edge| (edge.from, edge.to) == (from, to)) {
                    triangle.neighbours[i] = edge.neighbour;
                    triangle.labels[i] = edge.label;
                    if edge.neighbour != NONE {
                        self.keep_triangle(edge.neighbour);
                        let other = &mut self.triangles[edge.neighbour as usize];
                        let corner = (0..3).find(|j| {
                            (other.vertices[(j + 1) % 3], other.vertices[(j + 2) % 3]) == (to, from)
                        });
                        debug_assert!(corner.is_some());
                        other.neighbours[corner.unwrap_or(0)] = t;
                    }
                } else {
                    let opposite = added.iter().position(|other| {
                        (0..3).any(|j| (other[(j + 1) % 3], other[(j + 2) % 3]) == (to, from))
                    });
                    if !filling.labels.is_empty() {
                        triangle.labels[i] = filling.label(from, to);
                    }
                    debug_assert!(
                        opposite.is_some() || triangle.is_locked(i),
                        "a new edge needs two triangles"
                    );
                    triangle.neighbours[i] = opposite.map_or(NONE, |u| first + u as u32);
                }
            }
            self.push_triangle(triangle);
            for v in *vertices {
                self.keep_vertex(v);
                self.vertices[v as usize].anchor = t;
                self.vertices[v as usize].triangles += 1;
            }
        }
        // A vertex of the rim that lost its anchor has one again; others are gone.
        #[cfg(debug_assertions)]
        self.check_near(&rim.iter().map(|edge| edge.from).collect::<Vec<_>>());
    }

    /// The label of an edge, if one of these triangles has it.
    pub(crate) fn label(&self, triangles: &[u32], a: u32, b: u32) -> S::Label {
        let find = |t: &u32| {
            let triangle = &self.triangles[*t as usize];
            let has_both = triangle.vertices.contains(&a) && triangle.vertices.contains(&b);
            let corner = (0..3).find(|i| ![a, b].contains(&triangle.vertices[*i]));
            corner.filter(|_| has_both).map(|i| triangle.labels[i])
        };
        triangles.iter().find_map(find).unwrap_or_default()
    }

    /// True if a locked edge lies between two of the triangles.
    pub(crate) fn has_lock(&self, triangles: &[u32]) -> bool {
        triangles.iter().any(|t| {
            let triangle = &self.triangles[*t as usize];
            (0..3).any(|i| triangle.is_locked(i) && triangles.contains(&triangle.neighbours[i]))
        })
    }
}
