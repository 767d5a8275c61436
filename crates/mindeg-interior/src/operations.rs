//! Local changes of the mesh: each removes a few triangles and fills the hole anew.

use crate::array_mesh::{ArrayMesh, Kind, NONE, Triangle};
use crate::filling::Filling;
use crate::manifold::Manifold;
use crate::space::{Plane, Vector};

/// One change. Triangles and corners are those of the mesh before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Operation {
    /// Turns the edge opposite a corner of a triangle within its two triangles.
    Flip { triangle: u32, corner: u8 },
    /// Puts a vertex on the middle of that edge.
    Split { triangle: u32, corner: u8 },
    /// Moves a free vertex onto a neighbour, or one on a curve along that.
    Collapse { from: u32, to: u32 },
    /// Gives `count` consecutive triangles of a vertex, from the `first` of its star, to a new vertex.
    SplitVertex { vertex: u32, first: u8, count: u8 },
}

/// Room for an operation's triangles, used again and again.
#[derive(Debug, Clone)]
pub(crate) struct Cavity<S: Manifold = Plane> {
    pub(crate) removed: Vec<u32>,
    pub(crate) added: Filling<S>,
    /// All vertices of both.
    pub(crate) vertices: Vec<u32>,
    star: Vec<u32>,
}

impl<S: Manifold> Default for Cavity<S> {
    fn default() -> Self {
        let (removed, vertices, star) = (Vec::new(), Vec::new(), Vec::new());
        Self { removed, added: Filling::default(), vertices, star }
    }
}

/// An edge a-b with the vertices opposite it, on its left and, if it has two triangles, on its right.
#[derive(Debug, Clone, Copy)]
struct Quad<S: Manifold> {
    ends: [u32; 2],
    left: u32,
    right: Option<u32>,
    patches: [S::Patch; 2],
    label: S::Label,
}

/// Larger stars are not split: their operations would be too many.
const LARGEST_STAR: usize = 40;

impl<S: Manifold> Cavity<S> {
    /// Finds the triangles that an operation removes, and their vertices; false if it is not possible.
    pub(crate) fn open(&mut self, mesh: &ArrayMesh<S>, operation: Operation) -> bool {
        self.find(mesh, operation) && self.surround(mesh, operation)
    }

    /// Finds the triangles that an operation removes; false if it is not possible.
    pub(crate) fn find(&mut self, mesh: &ArrayMesh<S>, operation: Operation) -> bool {
        self.removed.clear();
        match operation {
            Operation::Flip { triangle, corner } | Operation::Split { triangle, corner } => {
                let split = matches!(operation, Operation::Split { .. });
                let across = mesh.triangles[triangle as usize].neighbours[corner as usize];
                if across == NONE && (S::IS_PLANE || !split) {
                    return false;
                }
                self.removed.push(triangle);
                self.removed.extend(Some(across).filter(|across| *across != NONE));
            }
            Operation::Collapse { from, to } => {
                let is_on_line = match mesh.vertices[from as usize].kind {
                    Kind::Free => false,
                    Kind::Curve => true,
                    Kind::Boundary | Kind::Fixed => return false,
                };
                mesh.star(from, &mut self.star);
                if is_on_line && mesh.label(&self.star, from, to) == S::Label::default() {
                    return false;
                }
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
        true
    }

    /// Finds the vertices of the triangles that [`find`](Self::find) has found; false if an edge between these stays.
    pub(crate) fn surround(&mut self, mesh: &ArrayMesh<S>, operation: Operation) -> bool {
        self.vertices.clear();
        for t in &self.removed {
            for v in mesh.triangles[*t as usize].vertices {
                if !self.vertices.contains(&v) {
                    self.vertices.push(v);
                }
            }
        }
        let crosses_line = match operation {
            Operation::Split { .. } => !S::IS_PLANE,
            Operation::Collapse { from, .. } => mesh.vertices[from as usize].kind == Kind::Curve,
            Operation::Flip { .. } | Operation::SplitVertex { .. } => false,
        };
        crosses_line || !mesh.has_lock(&self.removed)
    }

    /// How many triangles vertices would have after an operation for which [`find`](Self::find) has found triangles, without
    /// those that keep their number: in the plane that is known before anything else. A new vertex is [`NONE`].
    pub(crate) fn foreseen(&self, mesh: &ArrayMesh<S>, operation: Operation) -> [(u32, u32); 4] {
        let count = |v: u32| mesh.vertices[v as usize].triangles;
        let more = |v: u32| (v, count(v) + 1);
        let fewer = |v: u32| (v, count(v) - 1);
        match operation {
            Operation::Flip { triangle, corner } => {
                let Quad { ends: [a, b], left, right, .. } = self.quad(mesh, triangle, corner);
                [fewer(a), fewer(b), more(left), more(right.unwrap_or(left))]
            }
            Operation::Split { triangle, corner } => {
                let Quad { left, right, .. } = self.quad(mesh, triangle, corner);
                [more(left), more(right.unwrap_or(left)), (NONE, 4), (NONE, 0)]
            }
            Operation::Collapse { from, to } => {
                let own = self.removed.len() as u32;
                // The edge's two triangles go, and with them one at each vertex opposite it.
                let mut opposite = self.removed.iter().filter_map(|t| {
                    let vertices = mesh.triangles[*t as usize].vertices;
                    let other = vertices.into_iter().find(|v| ![from, to].contains(v));
                    other.filter(|_| vertices.contains(&to))
                });
                let mut next = || opposite.next().map_or((NONE, 0), fewer);
                [(from, 0), (to, count(to) + own - 4), next(), next()]
            }
            Operation::SplitVertex { vertex, count: own, .. } => {
                let own = u32::from(own);
                // The first vertex counter-clockwise from the split one, and the last.
                let rim = |t: u32, i: usize| {
                    let triangle = &mesh.triangles[t as usize];
                    triangle.vertices[(triangle.corner(vertex) + i) % 3]
                };
                let [first, last] = [self.removed[0], self.removed[self.removed.len() - 1]];
                let ends = [more(rim(first, 1)), more(rim(last, 2))];
                [ends[0], ends[1], (vertex, count(vertex) + 2 - own), (NONE, own + 2)]
            }
        }
    }

    /// Finds the triangles that the operation puts in place of those that [`open`](Self::open) has
    /// found; false if one would be inverted or flat. A new vertex is in the mesh from here on.
    pub(crate) fn plan(&mut self, mesh: &mut ArrayMesh<S>, operation: Operation) -> bool {
        self.added.clear();
        match operation {
            Operation::Flip { triangle, corner } => {
                let Quad { ends: [a, b], left: c, right, patches: [patch, _], .. } =
                    self.quad(mesh, triangle, corner);
                let Some(d) = right else { return false };
                if !S::IS_PLANE && are_joined(mesh, c, d, &mut self.star) {
                    return false;
                }
                self.added.push([c, a, d], patch);
                self.added.push([c, d, b], patch);
            }
            Operation::Split { triangle, corner } => {
                let Quad { ends: [a, b], left: c, right, patches, label } =
                    self.quad(mesh, triangle, corner);
                let size = (mesh.vertices[a as usize].size + mesh.vertices[b as usize].size) / 2.0;
                let Some(middle) = S::middle(mesh, [a, b], label, patches[0]) else { return false };
                let is_on_line = label != S::Label::default();
                let kind = if is_on_line { Kind::Curve } else { Kind::Free };
                let m = mesh.push_vertex(middle, size, kind);
                self.vertices.push(m);
                self.added.push([c, a, m], patches[0]);
                self.added.push([c, m, b], patches[0]);
                if let Some(d) = right {
                    self.added.push([d, b, m], patches[1]);
                    self.added.push([d, m, a], patches[1]);
                }
                if is_on_line {
                    self.added.labels.extend([([a, m], label), ([m, b], label)]);
                }
            }
            Operation::Collapse { from, to } => {
                if !S::IS_PLANE && !self.keeps_topology(mesh, from, to) {
                    return false;
                }
                for t in &self.removed {
                    let Triangle { vertices, patch, .. } = mesh.triangles[*t as usize];
                    if !vertices.contains(&to) {
                        self.added.push(vertices.map(|v| if v == from { to } else { v }), patch);
                    }
                }
            }
            Operation::SplitVertex { vertex, .. } => return self.split_vertex(mesh, vertex),
        }
        self.is_proper(mesh)
    }

    fn quad(&self, mesh: &ArrayMesh<S>, triangle: u32, corner: u8) -> Quad<S> {
        let left = mesh.triangles[triangle as usize];
        let corner = corner as usize;
        let [c, a, b] = [0, 1, 2].map(|i| left.vertices[(corner + i) % 3]);
        let right = self.removed.get(1).map(|across| &mesh.triangles[*across as usize]);
        let opposite = |t: &Triangle<S>| t.vertices.into_iter().find(|v| *v != a && *v != b);
        Quad {
            ends: [a, b],
            left: c,
            right: right.map(|t| opposite(t).unwrap_or(c)),
            patches: [left.patch, right.map_or(left.patch, |t| t.patch)],
            label: left.labels[corner],
        }
    }

    /// True if a mesh in space stays a surface when a vertex moves onto another: they have no common neighbours but those
    /// opposite their edge, which keep three triangles. Finds the new edge of a curve.
    fn keeps_topology(&mut self, mesh: &ArrayMesh<S>, from: u32, to: u32) -> bool {
        let mut opposite = Vec::new();
        let mut link = Vec::new();
        let mut curve = None;
        for t in &self.removed {
            let triangle = &mesh.triangles[*t as usize];
            let corner = triangle.corner(from);
            for i in [1, 2] {
                let v = triangle.vertices[(corner + i) % 3];
                // The edge from-v lies opposite the third vertex.
                let label = triangle.labels[(corner + 3 - i) % 3];
                if v != to && label != S::Label::default() {
                    curve = Some((v, label));
                }
                link.push(v);
            }
            if triangle.vertices.contains(&to) {
                opposite.extend(triangle.vertices.iter().filter(|v| ![from, to].contains(v)));
            }
        }
        mesh.star(to, &mut self.star);
        for t in &self.star {
            let vertices = mesh.triangles[*t as usize].vertices;
            let is_apart =
                |v: &u32| *v == from || *v == to || !link.contains(v) || opposite.contains(v);
            if !vertices.iter().all(is_apart) {
                return false;
            }
        }
        for v in &opposite {
            let least = if mesh.star(*v, &mut self.star) { 4 } else { 2 };
            if self.star.len() < least {
                return false;
            }
        }
        if let Some((v, label)) = curve {
            if opposite.contains(&v) {
                return false;
            }
            self.added.labels.push(([to, v], label));
        }
        true
    }

    fn split_vertex(&mut self, mesh: &mut ArrayMesh<S>, vertex: u32) -> bool {
        let center = mesh.at(vertex);
        let others = |t: u32| {
            let triangle = &mesh.triangles[t as usize];
            let corner = triangle.corner(vertex);
            [1, 2].map(|i| triangle.vertices[(corner + i) % 3])
        };
        let mut rim: Vec<u32> = self.removed.iter().map(|t| others(*t)[0]).collect();
        let Some(last) = self.removed.last() else { return false };
        let patch = mesh.triangles[*last as usize].patch;
        rim.push(others(*last)[1]);
        let offsets: Vec<S::Vector> = rim.iter().map(|v| mesh.at(*v) - center).collect();
        let shortest = offsets.iter().map(|o| o.length()).fold(f64::INFINITY, f64::min);
        let directions = offsets.iter().map(|o| o.normalize_or_zero());
        let direction = directions.fold(S::Vector::ZERO, |a, b| a + b).normalize_or_zero();
        let size =
            rim.iter().map(|v| mesh.vertices[*v as usize].size).sum::<f64>() / rim.len() as f64;
        let fan: Vec<[u32; 2]> = rim.windows(2).map(|ends| [ends[0], ends[1]]).collect();
        let mut share = 0.5;
        let place = loop {
            let offset = direction * (share * shortest);
            let Some(place) = S::beside(mesh, vertex, patch, offset) else { return false };
            let site = |v: u32| &mesh.vertices[v as usize].at;
            let is_fine = |a: u32, b: u32| mesh.space.is_proper([&place, site(a), site(b)]);
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
        let new = mesh.push_vertex(place, size, Kind::Free);
        self.vertices.push(new);
        fan.into_iter().for_each(|[a, b]| self.added.push([new, a, b], patch));
        self.added.push([vertex, rim[0], new], patch);
        self.added.push([vertex, new, rim[rim.len() - 1]], patch);
        self.is_proper(mesh)
    }

    fn is_proper(&self, mesh: &ArrayMesh<S>) -> bool {
        let site = |v: u32| &mesh.vertices[v as usize].at;
        self.added.triangles.iter().all(|vertices| mesh.space.is_proper(vertices.map(site)))
    }

    /// By how many triangles `vertex` grows if the plan is carried out.
    pub(crate) fn growth(&self, mesh: &ArrayMesh<S>, vertex: u32) -> i32 {
        let added = self.added.triangles.iter().filter(|t| t.contains(&vertex)).count();
        let at = |t: &&u32| mesh.triangles[**t as usize].vertices.contains(&vertex);
        added as i32 - self.removed.iter().filter(at).count() as i32
    }

    /// Carries out what [`plan`](Self::plan) has found.
    pub(crate) fn carry_out(&self, mesh: &mut ArrayMesh<S>) {
        mesh.replace(&self.removed, &self.added);
    }
}

/// True if an edge joins two vertices.
fn are_joined<S: Manifold>(mesh: &ArrayMesh<S>, a: u32, b: u32, star: &mut Vec<u32>) -> bool {
    mesh.star(a, star);
    star.iter().any(|t| mesh.triangles[*t as usize].vertices.contains(&b))
}

/// All operations at a vertex and on the edges of its link, in a fixed order.
pub(crate) fn operations<S: Manifold>(
    mesh: &ArrayMesh<S>,
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
            if kind.is_movable() {
                out.push(Operation::Collapse { from: vertex, to: other });
            }
            if mesh.vertices[other as usize].kind.is_movable() {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::array_mesh::tests::grid;
    use crate::surface::{OnSurface, Reference, work_mesh};
    use crate::{goal::Weights, options::Options};
    use glam::DVec3;
    use mindeg_surfaces::{FeatureRules, Surface};

    #[test]
    fn the_numbers_of_triangles_are_foreseen() {
        let mut mesh = grid(5);
        mesh.record();
        let (mut cavity, mut list, mut seen) = (Cavity::default(), Vec::new(), [0; 4]);
        for vertex in 0..mesh.vertices.len() as u32 {
            operations(&mesh, vertex, true, &mut list);
            for operation in list.clone() {
                if !cavity.find(&mesh, operation) {
                    continue;
                }
                let foreseen = cavity.foreseen(&mesh, operation);
                let (mark, known) = (mesh.mark(), mesh.vertices.len() as u32);
                if cavity.surround(&mesh, operation) && cavity.plan(&mut mesh, operation) {
                    for &v in &cavity.vertices {
                        let before = mesh.vertices[v as usize].triangles;
                        let after = before.saturating_add_signed(cavity.growth(&mesh, v));
                        let name = if v < known { v } else { NONE };
                        let own = foreseen.iter().find(|(u, _)| *u == name);
                        assert_eq!(own.map_or(before, |own| own.1), after, "{operation:?} {v}");
                    }
                    seen[match operation {
                        Operation::Flip { .. } => 0,
                        Operation::Split { .. } => 1,
                        Operation::Collapse { .. } => 2,
                        Operation::SplitVertex { .. } => 3,
                    }] += 1;
                }
                mesh.undo(mark);
            }
        }
        assert!(seen.iter().all(|count| *count > 20), "{seen:?}");
    }

    /// A tube of rings of three vertices: an edge of a ring has the third vertex as a neighbour of both ends, though not as
    /// a corner of its triangles.
    fn tube() -> Reference {
        let rings = 5;
        let point = |v: u32| {
            let angle = std::f64::consts::TAU * f64::from(v % 3) / 3.0;
            DVec3::new(libm::cos(angle), libm::sin(angle), f64::from(v / 3))
        };
        let points: Vec<DVec3> = (0..3 * rings).map(point).collect();
        let cells = (0..3 * (rings - 1)).map(|c| (c / 3 * 3, c % 3));
        let triangles: Vec<[u32; 3]> = cells
            .flat_map(|(row, i)| {
                let [a, b] = [row + i, row + (i + 1) % 3];
                [[a, b, b + 3], [a, b + 3, a + 3]]
            })
            .collect();
        let rules =
            FeatureRules { angle_deg: 180.0, weak_angle_deg: 180.0, ..FeatureRules::default() };
        let surface = Surface::new(&points, &triangles, &[], &rules).unwrap();
        let curves = surface.curves().len();
        Reference::new(surface, 1.0, 1.0, vec![false; curves])
    }

    #[test]
    fn a_collapse_keeps_a_surface_a_surface() {
        let reference = tube();
        let weights = Weights::single(&Options::default(), 35.0);
        let mut mesh = work_mesh(&reference, &reference.surface, &weights).unwrap();
        let mut cavity: Cavity<OnSurface<'_>> = Cavity::default();
        let mut keeps = |from: u32, to: u32| {
            assert!(cavity.open(&mesh, Operation::Collapse { from, to }));
            cavity.keeps_topology(&mesh, from, to)
        };
        // Round the tube, and along it.
        assert!(!keeps(6, 7) && !keeps(7, 8) && !keeps(8, 6));
        assert!(keeps(6, 9) && keeps(6, 3) && keeps(7, 10));
        // Edges that are there already are not made again.
        let mut flips = 0;
        for triangle in 0..mesh.triangles.len() as u32 {
            for corner in 0..3 {
                let flip = Operation::Flip { triangle, corner };
                if !cavity.open(&mesh, flip) {
                    continue;
                }
                let Quad { left, right, .. } = cavity.quad(&mesh, triangle, corner);
                let joined = are_joined(&mesh, left, right.unwrap(), &mut Vec::new());
                if cavity.plan(&mut mesh, flip) {
                    flips += 1;
                    assert!(!joined);
                }
            }
        }
        assert!(flips > 0);
    }
}
