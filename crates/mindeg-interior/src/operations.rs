//! Local changes of the mesh: each removes a few triangles and fills the hole anew.

use crate::array_mesh::{ArrayMesh, Kind, NONE};
use crate::triangle::is_proper;
use glam::DVec2;

/// One change. Triangles and corners are those of the mesh before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Operation {
    /// Turns the edge opposite a corner of a triangle within its two triangles.
    Flip { triangle: u32, corner: u8 },
    /// Puts a vertex on the middle of that edge.
    Split { triangle: u32, corner: u8 },
    /// Moves a free vertex onto a neighbour.
    Collapse { from: u32, to: u32 },
    /// Gives `count` consecutive triangles of a vertex, from the `first` of its star, to a new vertex.
    SplitVertex { vertex: u32, first: u8, count: u8 },
}

/// Room for an operation's triangles, used again and again.
#[derive(Debug, Clone, Default)]
pub(crate) struct Cavity {
    pub(crate) removed: Vec<u32>,
    pub(crate) added: Vec<[u32; 3]>,
    /// All vertices of both.
    pub(crate) vertices: Vec<u32>,
    star: Vec<u32>,
}

/// Larger stars are not split: their operations would be too many.
const LARGEST_STAR: usize = 40;

impl Cavity {
    /// Finds the triangles that an operation removes; false if it is not possible.
    pub(crate) fn open(&mut self, mesh: &ArrayMesh, operation: Operation) -> bool {
        self.removed.clear();
        self.vertices.clear();
        match operation {
            Operation::Flip { triangle, corner } | Operation::Split { triangle, corner } => {
                let across = mesh.triangles[triangle as usize].neighbours[corner as usize];
                if across == NONE {
                    return false;
                }
                self.removed.extend([triangle, across]);
            }
            Operation::Collapse { from, .. } => {
                if mesh.vertices[from as usize].kind != Kind::Free {
                    return false;
                }
                mesh.star(from, &mut self.star);
                self.removed.extend(&self.star);
            }
            Operation::SplitVertex { vertex, first, count } => {
                let is_closed = mesh.star(vertex, &mut self.star);
                let (first, count, all) = (first as usize, count as usize, self.star.len());
                if count + 2 > all + usize::from(!is_closed) * 2
                    || !is_closed && first + count > all
                {
                    return false;
                }
                self.removed.extend((first..first + count).map(|i| self.star[i % all]));
            }
        }
        for t in &self.removed {
            for v in mesh.triangles[*t as usize].vertices {
                if !self.vertices.contains(&v) {
                    self.vertices.push(v);
                }
            }
        }
        !mesh.has_lock(&self.removed)
    }

    /// Finds the triangles that the operation puts in place of those that [`open`](Self::open) has
    /// found; false if one would be inverted or flat. A new vertex is in the mesh from here on.
    pub(crate) fn plan(&mut self, mesh: &mut ArrayMesh, operation: Operation) -> bool {
        self.added.clear();
        match operation {
            Operation::Flip { triangle, .. } => {
                let [a, b, c, d] = self.quad(mesh, triangle);
                self.added.extend([[c, a, d], [c, d, b]]);
            }
            Operation::Split { triangle, .. } => {
                let [a, b, c, d] = self.quad(mesh, triangle);
                let size = (mesh.vertices[a as usize].size + mesh.vertices[b as usize].size) / 2.0;
                let m = mesh.push_vertex(mesh.at(a).midpoint(mesh.at(b)), size);
                self.vertices.push(m);
                self.added.extend([[c, a, m], [c, m, b], [d, b, m], [d, m, a]]);
            }
            Operation::Collapse { from, to } => {
                for t in &self.removed {
                    let vertices = mesh.triangles[*t as usize].vertices;
                    if !vertices.contains(&to) {
                        self.added.push(vertices.map(|v| if v == from { to } else { v }));
                    }
                }
            }
            Operation::SplitVertex { vertex, .. } => return self.split_vertex(mesh, vertex),
        }
        self.is_proper(mesh)
    }

    /// The edge a-b of the two removed triangles, with c on its left and d on its right.
    fn quad(&self, mesh: &ArrayMesh, triangle: u32) -> [u32; 4] {
        let left = mesh.triangles[triangle as usize];
        let across = self.removed[1];
        let corner = left.neighbours.iter().position(|n| *n == across).unwrap_or(0);
        // Two triangles may share only one edge here: with two, their common vertex would have degree 2.
        let [c, a, b] = [0, 1, 2].map(|i| left.vertices[(corner + i) % 3]);
        let right = mesh.triangles[across as usize].vertices;
        let d = right.into_iter().find(|v| *v != a && *v != b).unwrap_or(c);
        [a, b, c, d]
    }

    fn split_vertex(&mut self, mesh: &mut ArrayMesh, vertex: u32) -> bool {
        let center = mesh.at(vertex);
        let others = |t: u32| {
            let triangle = &mesh.triangles[t as usize];
            let corner = triangle.corner(vertex);
            [1, 2].map(|i| triangle.vertices[(corner + i) % 3])
        };
        let mut rim: Vec<u32> = self.removed.iter().map(|t| others(*t)[0]).collect();
        let Some(last) = self.removed.last() else { return false };
        rim.push(others(*last)[1]);
        let offsets: Vec<DVec2> = rim.iter().map(|v| mesh.at(*v) - center).collect();
        let shortest = offsets.iter().map(|o| o.length()).fold(f64::INFINITY, f64::min);
        let direction: DVec2 = offsets.iter().map(|o| o.normalize_or_zero()).sum();
        let direction = direction.normalize_or_zero();
        let size =
            rim.iter().map(|v| mesh.vertices[*v as usize].size).sum::<f64>() / rim.len() as f64;
        let fan: Vec<[u32; 2]> = rim.windows(2).map(|ends| [ends[0], ends[1]]).collect();
        let mut share = 0.5;
        let place = loop {
            let place = center + direction * (share * shortest);
            let is_fine = |a: u32, b: u32| is_proper([place, mesh.at(a), mesh.at(b)]);
            let ends = [rim[0], rim[rim.len() - 1]];
            if fan.iter().all(|[a, b]| is_fine(*a, *b))
                && is_fine(vertex, ends[0])
                && is_fine(ends[1], vertex)
            {
                break place;
            }
            share /= 2.0;
            if share < 0.05 {
                return false;
            }
        };
        let new = mesh.push_vertex(place, size);
        self.vertices.push(new);
        self.added.extend(fan.into_iter().map(|[a, b]| [new, a, b]));
        self.added.extend([[vertex, rim[0], new], [vertex, new, rim[rim.len() - 1]]]);
        self.is_proper(mesh)
    }

    fn is_proper(&self, mesh: &ArrayMesh) -> bool {
        self.added.iter().all(|vertices| is_proper(vertices.map(|v| mesh.at(v))))
    }

    /// By how many triangles `vertex` grows if the plan is carried out.
    pub(crate) fn growth(&self, mesh: &ArrayMesh, vertex: u32) -> i32 {
        let added = self.added.iter().filter(|t| t.contains(&vertex)).count();
        let at = |t: &&u32| mesh.triangles[**t as usize].vertices.contains(&vertex);
        added as i32 - self.removed.iter().filter(at).count() as i32
    }

    /// Carries out what [`plan`](Self::plan) has found.
    pub(crate) fn carry_out(&self, mesh: &mut ArrayMesh) {
        mesh.replace(&self.removed, &self.added);
    }
}

/// All operations at a vertex and on the edges of its link, in a fixed order.
pub(crate) fn operations(
    mesh: &ArrayMesh,
    vertex: u32,
    with_splits: bool,
    out: &mut Vec<Operation>,
) {
    out.clear();
    let mut star = Vec::new();
    let is_closed = mesh.star(vertex, &mut star);
    if star.len() > LARGEST_STAR {
        star.truncate(LARGEST_STAR);
    }
    let kind = mesh.vertices[vertex as usize].kind;
    for t in &star {
        let triangle = &mesh.triangles[*t as usize];
        let corner = triangle.corner(vertex);
        // The link edge, and the edge towards the next triangle: each edge at the vertex once.
        for corner in [corner, (corner + 1) % 3] {
            let (triangle, corner) = (*t, corner as u8);
            out.push(Operation::Flip { triangle, corner });
            if with_splits {
                out.push(Operation::Split { triangle, corner });
            }
        }
        let [next, last] = [1, 2].map(|i| triangle.vertices[(corner + i) % 3]);
        let is_last = !is_closed && triangle.neighbours[(corner + 1) % 3] == NONE;
        for other in [Some(next), is_last.then_some(last)].into_iter().flatten() {
            if kind == Kind::Free {
                out.push(Operation::Collapse { from: vertex, to: other });
            }
            if mesh.vertices[other as usize].kind == Kind::Free {
                out.push(Operation::Collapse { from: other, to: vertex });
            }
        }
    }
    let all = star.len();
    let most = if is_closed { all.saturating_sub(2) } else { all };
    for count in 2..=most {
        let firsts = if is_closed { all } else { all - count + 1 };
        out.extend((0..firsts).map(|first| Operation::SplitVertex {
            vertex,
            first: first as u8,
            count: count as u8,
        }));
    }
}
