//! A disc's triangulation whose triangles may be turned over, with what its degrees and shapes cost.

use crate::array_mesh::{ArrayMesh, Kind, NONE, Triangle, Vertex};
use crate::goal::Weights;
use crate::kernel::untangle;
use crate::triangle::doubled_area;
use glam::DVec2;
use mindeg_mesh::planar::orientation;
use std::f64::consts::LN_2;

/// The cost of a degree one beyond its range; it grows as the square.
pub(crate) const DEGREE: f64 = 15.0;
/// The cost of a triangle that is turned over, at the start and at the end.
pub(crate) const TURNED: [f64; 2] = [6.0, 30.0];
/// How a disc is searched.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Effort {
    /// Moves for each triangle.
    pub(crate) moves: u32,
    /// The cost of an angle e times smaller than wanted.
    pub(crate) shape: f64,
    /// The cost of a vertex.
    pub(crate) vertex: f64,
}

/// The aims at a vertex: the sine of its angles, squared, and the least and the greatest number of triangles.
#[derive(Debug, Clone, Copy)]
struct Aim {
    squared_sine: f64,
    least: u32,
    most: u32,
}

impl Aim {
    /// Of a vertex that is free.
    fn inside(weights: &Weights) -> Self {
        let (least, most) = (*weights.interior.start(), *weights.interior.end());
        Self { squared_sine: weights.floor_sine * weights.floor_sine, least, most }
    }
}

/// A disc's triangulation that changes.
pub(crate) struct Sketch<'a> {
    pub(crate) weights: &'a Weights,
    pub(crate) mesh: &'a ArrayMesh,
    pub(crate) vertices: Vec<Vertex>,
    pub(crate) triangles: Vec<Triangle>,
    /// The aims at each vertex.
    aims: Vec<Aim>,
    /// Triangles and vertices that are no longer there.
    pub(crate) unused: [Vec<u32>; 2],
    /// By how much degrees are out of their ranges.
    pub(crate) excess: u32,
    pub(crate) effort: Effort,
    /// The cost of a triangle that is turned over.
    pub(crate) turned: f64,
    /// The cost of each triangle's shape, or [`TURNED_OVER`].
    costs: Vec<f64>,
    /// The edges that stay.
    edges: Vec<[u32; 2]>,
}

/// Stands for the cost of a triangle that is turned over, which changes.
const TURNED_OVER: f64 = -1.0;

impl<'a> Sketch<'a> {
    pub(crate) fn new(mesh: &'a ArrayMesh, weights: &'a Weights, effort: Effort) -> Self {
        let aim = |vertex: &Vertex| match mesh.goals.get(vertex.goal as usize) {
            Some(goal) => {
                let sine = goal.sine.min(weights.floor_sine);
                Aim { squared_sine: sine * sine, least: goal.least, most: goal.triangles }
            }
            None => Aim::inside(weights),
        };
        let used = (0..).zip(&mesh.vertices).filter(|(_, vertex)| vertex.triangles > 0);
        let stays = |t: &Triangle, i: usize| t.neighbours[i] == NONE || t.is_locked(i);
        let edges = mesh.triangles.iter().flat_map(|t| {
            let own = (0..3).filter(|i| stays(t, *i));
            own.map(|i| [1, 2].map(|j| t.vertices[(i + j) % 3]))
        });
        let mut sketch = Self {
            weights,
            mesh,
            vertices: mesh.vertices.clone(),
            triangles: mesh.triangles.clone(),
            aims: mesh.vertices.iter().map(aim).collect(),
            unused: [Vec::new(), Vec::new()],
            effort,
            turned: TURNED[0],
            excess: used.map(|(v, _)| weights.excess(mesh, v)).sum(),
            costs: vec![0.0; mesh.triangles.len()],
            edges: edges.collect(),
        };
        (0..mesh.triangles.len() as u32).for_each(|t| sketch.rate(t));
        sketch
    }

    pub(crate) fn at(&self, vertex: u32) -> DVec2 {
        self.vertices[vertex as usize].at
    }

    pub(crate) fn is_free(&self, vertex: u32) -> bool {
        self.vertices[vertex as usize].kind == Kind::Free
    }

    /// By how much a vertex with so many triangles is out of its range.
    pub(crate) fn excess_of(&self, vertex: u32, triangles: u32) -> u32 {
        let aim = self.aims[vertex as usize];
        triangles.saturating_sub(aim.most).max(aim.least.saturating_sub(triangles))
    }

    /// A free vertex that no triangle has yet, and its index.
    pub(crate) fn push_vertex(&mut self, vertex: Vertex) -> u32 {
        if let Some(v) = self.unused[1].pop() {
            self.vertices[v as usize] = vertex;
            return v;
        }
        self.vertices.push(vertex);
        self.aims.push(Aim::inside(self.weights));
        self.vertices.len() as u32 - 1
    }

    /// The change of the cost of degrees, and of their excess, if vertices have so many triangles more.
    pub(crate) fn change(&self, vertices: &[(u32, i32)]) -> (f64, i32) {
        let (mut cost, mut excess) = (0.0, 0);
        for &(v, more) in vertices {
            let before = self.vertices[v as usize].triangles;
            let [old, new] =
                [before, before.saturating_add_signed(more)].map(|n| self.excess_of(v, n) as i32);
            cost += f64::from(new * new - old * old);
            excess += new - old;
        }
        (DEGREE * cost, excess)
    }

    /// The cost of the shape of three vertices. Infinite if none of them can move and they are turned over.
    pub(crate) fn shape(&self, vertices: [u32; 3]) -> f64 {
        self.now(self.cost(vertices))
    }

    /// The cost of a triangle's shape.
    pub(crate) fn shape_of(&self, triangle: u32) -> f64 {
        self.now(self.costs[triangle as usize])
    }

    /// Puts a triangle in the place of another, or after all.
    pub(crate) fn put(&mut self, at: u32, triangle: Triangle) {
        self.triangles[at as usize] = triangle;
        self.rate(at);
    }

    /// Looks at the shape of a triangle that has changed.
    pub(crate) fn rate(&mut self, triangle: u32) {
        let cost = self.cost(self.triangles[triangle as usize].vertices);
        self.costs[triangle as usize] = cost;
    }

    /// The index of a new triangle.
    pub(crate) fn push_triangle(&mut self) -> u32 {
        self.unused[0].pop().unwrap_or_else(|| {
            self.triangles.push(Triangle::new([NONE; 3], ()));
            self.costs.push(0.0);
            self.triangles.len() as u32 - 1
        })
    }

    fn now(&self, cost: f64) -> f64 {
        if cost == TURNED_OVER { self.turned } else { cost }
    }

    fn cost(&self, vertices: [u32; 3]) -> f64 {
        let corners @ [a, b, c] = vertices.map(|v| self.at(v));
        let doubled = doubled_area(corners);
        let [ab, bc, ca] = [a.distance_squared(b), b.distance_squared(c), c.distance_squared(a)];
        // The minimum angle's sine is the doubled area over the product of the two longer edges.
        let longer = (ab * bc).max(bc * ca).max(ca * ab);
        let squared = doubled * doubled;
        if doubled <= 0.0 || squared <= 1e-18 * longer {
            let is_free = vertices.iter().any(|v| self.is_free(*v));
            return if is_free { TURNED_OVER } else { f64::INFINITY };
        }
        let sine = |v: u32| self.aims[v as usize].squared_sine;
        let wanted = sine(vertices[0]).min(sine(vertices[1])).min(sine(vertices[2])) * longer;
        if wanted <= squared {
            return 0.0;
        }
        0.5 * self.effort.shape * about_log(wanted / squared)
    }

    /// The triangle across the edge opposite a corner, with its corner opposite; the vertices of both: opposite, the edge's, opposite.
    pub(crate) fn quad(&self, triangle: u32, corner: usize) -> Option<(u32, usize, [u32; 4])> {
        let one = &self.triangles[triangle as usize];
        let other = one.neighbours[corner];
        if other == NONE || one.is_locked(corner) {
            return None;
        }
        let [c, a, b] = [0, 1, 2].map(|i| one.vertices[(corner + i) % 3]);
        let across = &self.triangles[other as usize];
        let opposite = (0..3)
            .find(|i| across.neighbours[*i] == triangle && across.vertices[(i + 1) % 3] == b)?;
        Some((other, opposite, [c, a, b, across.vertices[opposite]]))
    }

    /// True if an edge between two vertices is there, one of whose triangles is given.
    pub(crate) fn are_joined(&self, a: u32, b: u32, triangle: u32) -> bool {
        // Both ways round the vertex, in case it is on the rim.
        for turn in [1, 2] {
            let mut at = triangle;
            loop {
                let t = &self.triangles[at as usize];
                if t.vertices.contains(&b) {
                    return true;
                }
                at = t.neighbours[(t.corner(a) + turn) % 3];
                if at == triangle {
                    return false;
                }
                if at == NONE {
                    break;
                }
            }
        }
        false
    }

    /// True if two vertices that stay may have an edge: no edge that stays crosses it.
    pub(crate) fn is_visible(&self, a: u32, b: u32) -> bool {
        let [p, q] = [a, b].map(|v| self.at(v));
        let (low, high) = (p.min(q), p.max(q));
        let crosses = |u: u32, w: u32| {
            if [a, b].contains(&u) || [a, b].contains(&w) {
                return false;
            }
            let [r, s] = [u, w].map(|v| self.at(v));
            // Most edges are elsewhere.
            let is_apart = r.min(s).cmpgt(high) | r.max(s).cmplt(low);
            !is_apart.any()
                && orientation(p, q, r) * orientation(p, q, s) <= 0.0
                && orientation(r, s, p) * orientation(r, s, q) <= 0.0
        };
        self.edges.iter().all(|[u, w]| !crosses(*u, *w))
    }

    /// Makes `of` know that `now` lies where `before` lay.
    pub(crate) fn relink(&mut self, of: u32, before: u32, now: u32) {
        if of != NONE {
            let triangle = &mut self.triangles[of as usize];
            for neighbour in &mut triangle.neighbours {
                if *neighbour == before {
                    *neighbour = now;
                    return;
                }
            }
        }
    }

    pub(crate) fn count(&mut self, vertices: &[(u32, i32)], excess: i32) {
        for &(v, more) in vertices {
            let count = &mut self.vertices[v as usize].triangles;
            *count = count.saturating_add_signed(more);
        }
        self.excess = self.excess.saturating_add_signed(excess);
    }

    /// The closed star of a free vertex from one of its triangles on, counter-clockwise, if it has at most so many.
    pub(crate) fn star<const N: usize>(
        &self,
        vertex: u32,
        triangle: u32,
    ) -> Option<([u32; N], usize)> {
        let (mut star, mut count, mut at) = ([NONE; N], 0, triangle);
        loop {
            *star.get_mut(count)? = at;
            count += 1;
            let t = &self.triangles[at as usize];
            at = t.neighbours[(t.corner(vertex) + 1) % 3];
            if at == triangle {
                return Some((star, count));
            }
            if at == NONE {
                return None;
            }
        }
    }

    /// The mesh with its points put right, if that is possible.
    pub(crate) fn into_mesh(self) -> Option<ArrayMesh> {
        let mut vertices = self.vertices;
        vertices.iter_mut().for_each(|v| (v.anchor, v.triangles) = (NONE, 0));
        let alive = self.triangles.iter().filter(|t| t.is_alive());
        let triangles: Vec<[u32; 3]> = alive.map(|t| t.vertices).collect();
        let locked = self.mesh.locked_edges();
        let mut mesh =
            ArrayMesh::new(vertices, &triangles, self.mesh.goals.clone(), &locked).ok()?;
        untangle(&mut mesh).then_some(mesh)
    }
}

/// Nearly the natural logarithm of a positive number that is not subnormal, by at most 0.0002 off: costs and chances need no more.
pub(crate) fn about_log(x: f64) -> f64 {
    let bits = x.to_bits();
    let exponent = (bits >> 52) as i64 - 1023;
    let mantissa = f64::from_bits(bits & ((1 << 52) - 1) | 1023 << 52);
    // The series of ln((1 + t) / (1 - t)).
    let t = (mantissa - 1.0) / (mantissa + 1.0);
    let square = t * t;
    exponent as f64 * LN_2 + t * (2.0 + square * (2.0 / 3.0 + square * (2.0 / 5.0)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::array_mesh::tests::grid;
    use crate::options::Options;

    const EFFORT: Effort = Effort { moves: 0, shape: 1.0, vertex: 0.0 };

    #[test]
    fn edges_between_vertices_that_stay_cross_no_edge_that_stays() {
        let (mut mesh, weights) = (grid(4), Weights::local(&Options::default(), 36.0));
        mesh.vertices.iter_mut().for_each(|v| v.kind = Kind::Boundary);
        let sketch = Sketch::new(&mesh, &weights, EFFORT);
        // The locked edge runs from 6 to 7.
        assert!(!sketch.is_visible(1, 12) && sketch.is_visible(1, 10));
        assert!(sketch.is_visible(6, 12) && !sketch.is_visible(5, 9));
    }

    #[test]
    fn logarithms_are_nearly_right() {
        for i in 0..4000 {
            let x = libm::exp(f64::from(i - 2000) / 3.0);
            let error = about_log(x) - libm::log(x);
            assert!(error.abs() < 2e-4, "{x}: {error}");
        }
    }
}
