//! One window: some neighbouring triangles that form a disk, and their exact retriangulation.

use crate::chords::Chords;
use crate::limits::Capacity;
use crate::linked::{Linked, NONE, chord_counts};
use crate::pieces::{Pieces, Rules};
use crate::problem::Problem;
use crate::visibility::Eye;
use glam::DVec2;

/// A triangulation that windows change, and the memory that they share.
pub(crate) struct Work<'a> {
    problem: &'a Problem,
    pub(crate) mesh: Linked,
    /// For each vertex the triangle on the boundary edge that begins there.
    first: Vec<u32>,
    /// For each vertex its number of edges, external ones included.
    pub(crate) totals: Vec<u32>,
    /// For each vertex and each triangle its index in the current window, or [`NONE`].
    vertex_in_window: Vec<u32>,
    triangle_in_window: Vec<u32>,
    eye: Eye<'a>,
}

/// Some triangles whose union is a disk.
pub(crate) struct Window {
    triangles: Vec<u32>,
    /// The vertices, in the order in which they were added.
    vertices: Vec<u32>,
    /// For each of these vertices the index of the next one on the ring around the window.
    next: Vec<u32>,
}

/// A window as a separate polygon, whose vertices are the indices 0, 1, 2, … on its ring.
pub(crate) struct Local {
    /// The vertex at each place.
    pub(crate) ring: Vec<u32>,
    pub(crate) points: Vec<DVec2>,
    pub(crate) mesh: Linked,
    /// The chords of the triangles at each place.
    pub(crate) chord_counts: Vec<u32>,
    /// All chords that a triangulation of the window may use.
    pub(crate) chords: Chords,
}

/// The aim of one window.
pub(crate) struct Aim<'a> {
    /// The vertex that should lose edges.
    pub(crate) vertex: u32,
    /// The most edges that it may keep, external ones included.
    pub(crate) keep: u32,
    /// The most edges of any other vertex, unless it has more already.
    pub(crate) limit: &'a dyn Fn(u32) -> u32,
    /// The least tangent of an angle.
    pub(crate) threshold: f64,
}

impl<'a> Work<'a> {
    /// The triangulation to change is one of the problem.
    pub(crate) fn new(problem: &'a Problem, mesh: Linked) -> Self {
        let vertices = problem.points().len();
        let mut first = vec![NONE; vertices];
        // The edges at a vertex of one fan are one more than its triangles.
        let mut totals: Vec<u32> =
            (0..vertices as u32).map(|v| problem.external_degree(v).saturating_add(1)).collect();
        for (triangle, (corners, neighbours)) in
            (0..).zip(mesh.triangles.iter().zip(&mesh.neighbours))
        {
            for (&corner, &beyond) in corners.iter().zip(neighbours) {
                totals[corner as usize] = totals[corner as usize].saturating_add(1);
                if beyond == NONE {
                    first[corner as usize] = triangle;
                }
            }
        }
        let triangle_in_window = vec![NONE; mesh.triangles.len()];
        let vertex_in_window = vec![NONE; vertices];
        let eye = Eye::new(problem.sides(), true);
        Self { problem, mesh, first, totals, vertex_in_window, triangle_in_window, eye }
    }

    /// The first triangle of the fan at `vertex`, counter-clockwise.
    pub(crate) fn first_of_fan(&self, vertex: u32) -> u32 {
        self.first[vertex as usize]
    }

    /// The triangle that follows counter-clockwise around `vertex`, or [`NONE`].
    pub(crate) fn next_of_fan(&self, vertex: u32, triangle: u32) -> u32 {
        let (at, _) = self.mesh.enter(triangle, vertex);
        self.mesh.neighbours[triangle as usize][(at + 2) % 3]
    }

    /// The number of triangles at `vertex`.
    pub(crate) fn fan_len(&self, vertex: u32) -> usize {
        (self.totals[vertex as usize] - self.problem.external_degree(vertex)) as usize - 1
    }

    /// Retriangulates a window of `fan` triangles at the aim's vertex from `start` on, and others
    /// around them up to `size`. Returns the triangle of the fan after those of the window, and, if
    /// the aim was achieved, the vertices whose number of edges has changed.
    pub(crate) fn retriangulate(
        &mut self,
        aim: &Aim<'_>,
        start: u32,
        fan: usize,
        size: usize,
    ) -> (u32, Option<Vec<u32>>) {
        self.retriangulate_by(aim.vertex, start, fan, size, |work, local| work.solve(aim, local))
    }

    /// As [`retriangulate`](Self::retriangulate), with what `solve` finds for the window: its
    /// triangles, each before those beneath it.
    pub(crate) fn retriangulate_by(
        &mut self,
        vertex: u32,
        start: u32,
        fan: usize,
        size: usize,
        solve: impl FnOnce(&Self, &Local) -> Option<Vec<[u32; 3]>>,
    ) -> (u32, Option<Vec<u32>>) {
        let (window, after) = self.window(vertex, start, fan, size);
        let local = self.local(&window);
        let triangles = solve(self, &local);
        let changed = triangles.map(|triangles| self.replace(&window, &local, &triangles));
        for &vertex in &window.vertices {
            self.vertex_in_window[vertex as usize] = NONE;
        }
        for &triangle in &window.triangles {
            self.triangle_in_window[triangle as usize] = NONE;
        }
        (after, changed)
    }

    fn window(&mut self, vertex: u32, start: u32, fan: usize, size: usize) -> (Window, u32) {
        let mut window = Window { triangles: Vec::new(), vertices: Vec::new(), next: Vec::new() };
        let (at, _) = self.mesh.enter(start, vertex);
        let corners = self.mesh.triangles[start as usize];
        for corner in 0..3 {
            self.put_vertex(&mut window, corners[(at + corner) % 3], [1, 2, 0][corner]);
        }
        self.put_triangle(&mut window, start);
        let mut after = self.next_of_fan(vertex, start);
        while after != NONE && window.triangles.len() < fan {
            let (edge, _) = self.mesh.enter(after, vertex);
            if !self.extend(&mut window, after, edge) {
                break;
            }
            after = self.next_of_fan(vertex, after);
        }
        let mut inner = 0;
        while inner < window.triangles.len() && window.triangles.len() < size {
            let triangle = window.triangles[inner];
            for edge in 0..3 {
                let beyond = self.mesh.neighbours[triangle as usize][edge];
                if beyond != NONE && window.triangles.len() < size {
                    let to = self.mesh.triangles[triangle as usize][(edge + 1) % 3];
                    let (entry, _) = self.mesh.enter(beyond, to);
                    self.extend(&mut window, beyond, entry);
                }
            }
            inner += 1;
        }
        (window, after)
    }

    /// Adds a triangle whose edge `edge` is on the ring of the window, if the opposite corner is
    /// new to the window: so the window stays a disk.
    fn extend(&mut self, window: &mut Window, triangle: u32, edge: usize) -> bool {
        let corners = self.mesh.triangles[triangle as usize];
        let apex = corners[(edge + 2) % 3];
        if self.triangle_in_window[triangle as usize] != NONE
            || self.vertex_in_window[apex as usize] != NONE
        {
            return false;
        }
        // The window has the opposite half-edge.
        let from = self.vertex_in_window[corners[(edge + 1) % 3] as usize] as usize;
        let next = window.next[from];
        window.next[from] = window.vertices.len() as u32;
        self.put_vertex(window, apex, next);
        self.put_triangle(window, triangle);
        true
    }

    fn put_vertex(&mut self, window: &mut Window, vertex: u32, next: u32) {
        self.vertex_in_window[vertex as usize] = window.vertices.len() as u32;
        window.vertices.push(vertex);
        window.next.push(next);
    }

    fn put_triangle(&mut self, window: &mut Window, triangle: u32) {
        self.triangle_in_window[triangle as usize] = window.triangles.len() as u32;
        window.triangles.push(triangle);
    }

    /// The window as a polygon of its own.
    fn local(&mut self, window: &Window) -> Local {
        let count = window.vertices.len();
        // From the order in which they were added to that on the ring.
        let mut ring = Vec::with_capacity(count);
        let mut position = vec![0; count];
        let mut at = 0;
        for place in 0..count as u32 {
            ring.push(window.vertices[at as usize]);
            position[at as usize] = place;
            at = window.next[at as usize];
        }
        let points: Vec<DVec2> =
            ring.iter().map(|&vertex| self.problem.points()[vertex as usize]).collect();
        let place = |vertex: u32| position[self.vertex_in_window[vertex as usize] as usize];
        let local = Linked {
            triangles: window
                .triangles
                .iter()
                .map(|&triangle| self.mesh.triangles[triangle as usize].map(place))
                .collect(),
            neighbours: window
                .triangles
                .iter()
                .map(|&triangle| {
                    self.mesh.neighbours[triangle as usize].map(|beyond| {
                        if beyond == NONE { NONE } else { self.triangle_in_window[beyond as usize] }
                    })
                })
                .collect(),
        };
        let chord_counts = chord_counts(count, &local.triangles);
        let mut seen = Vec::new();
        for corner in 0..3 * local.triangles.len() as u32 {
            let from = local.triangles[corner as usize / 3][corner as usize % 3];
            let sides = self.problem.sides();
            let is_wanted =
                |to: u32| from < to && !sides.has_both(ring[from as usize], ring[to as usize]);
            self.eye.look(&local, &points, corner, is_wanted, |to| seen.push([from, to]));
        }
        seen.sort_unstable();
        let chords = Chords::new(count, &[seen]);
        Local { ring, points, mesh: local, chord_counts, chords }
    }

    /// The triangles of a triangulation of the window that achieves the aim.
    fn solve(&self, aim: &Aim<'_>, local: &Local) -> Option<Vec<[u32; 3]>> {
        let capacities = local.chords.degrees().into_iter().enumerate().map(|(place, visible)| {
            let vertex = local.ring[place];
            let total = self.totals[vertex as usize];
            let limit =
                if vertex == aim.vertex { aim.keep } else { (aim.limit)(vertex).max(total) };
            let beyond = total - local.chord_counts[place];
            let capacity = limit.checked_sub(beyond)?;
            Some(if visible <= capacity {
                Capacity::Unlimited
            } else {
                Capacity::Limited(capacity)
            })
        });
        let capacities = capacities.collect::<Option<_>>()?;
        let rules = Rules { points: &local.points, threshold: aim.threshold, capacities };
        let pieces = Pieces::<()>::solve(rules, &local.chords, |_| Ok(())).ok()?;
        pieces.triangles().map(|(triangles, ())| triangles)
    }

    /// Replaces the window's triangles by these, each of which comes before those beneath it.
    /// Returns the vertices whose number of edges changes.
    fn replace(&mut self, window: &Window, local: &Local, triangles: &[[u32; 3]]) -> Vec<u32> {
        let Local { ring, mesh: local, chord_counts: before, .. } = local;
        let mut outer = vec![NONE; ring.len()];
        for ((&slot, corners), neighbours) in
            window.triangles.iter().zip(&local.triangles).zip(&local.neighbours)
        {
            for edge in 0..3 {
                if neighbours[edge] == NONE {
                    outer[corners[edge] as usize] = self.mesh.neighbours[slot as usize][edge];
                }
            }
        }
        let last = ring.len() as u32 - 1;
        let slot = |index: usize| window.triangles[index];
        self.mesh.neighbours[slot(0) as usize][2] = NONE;
        for (index, &[i, apex, j]) in triangles.iter().enumerate() {
            let own = slot(index);
            self.mesh.triangles[own as usize] = [i, apex, j].map(|place| ring[place as usize]);
            let left = index + 1;
            let right = index + (apex - i) as usize;
            for (edge, [from, to], child) in [(0, [i, apex], left), (1, [apex, j], right)] {
                if to - from > 1 {
                    self.mesh.neighbours[own as usize][edge] = slot(child);
                    self.mesh.neighbours[slot(child) as usize][2] = own;
                } else {
                    self.join(own, edge, ring, from, outer[from as usize]);
                }
            }
        }
        self.join(slot(0), 2, ring, last, outer[last as usize]);

        let after = chord_counts(ring.len(), triangles);
        let mut changed = Vec::new();
        for (place, &vertex) in ring.iter().enumerate() {
            if after[place] != before[place] {
                let total = &mut self.totals[vertex as usize];
                *total = *total + after[place] - before[place];
                changed.push(vertex);
            }
        }
        changed
    }

    /// Connects an edge of a new triangle, from ring place `from` to the next, with the triangle
    /// beyond the window.
    fn join(&mut self, triangle: u32, edge: usize, ring: &[u32], from: u32, beyond: u32) {
        self.mesh.neighbours[triangle as usize][edge] = beyond;
        if beyond == NONE {
            self.first[ring[from as usize] as usize] = triangle;
        } else {
            let to = ring[(from as usize + 1) % ring.len()];
            let (entry, _) = self.mesh.enter(beyond, to);
            self.mesh.neighbours[beyond as usize][entry] = triangle;
        }
    }
}
