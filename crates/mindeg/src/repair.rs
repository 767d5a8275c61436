//! Meshes that are no surface made one: points that nearly coincide, faces without area or twice, edges of three faces or
//! more, faces that face opposite ways, small holes.
//!
//! [`repaired`] mends what can be mended without asking, and counts it. The caller has to look for faults that stay. Vertices
//! keep their indices, so lines and names of points keep theirs.

use std::collections::BTreeMap;

use glam::DVec3;
use mindeg_mesh::quality::area_in_space;
use mindeg_mesh::{DisjointSets, Group, Progress, TriMesh, Triangles, edges_of, sorted, weld};

use crate::error::MeshError;
use crate::fill::{FillOptions, fill};
use crate::loops::Loops;

/// The repairs, each counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "json", derive(serde::Serialize))]
pub struct Repairs {
    /// Points that were nearly those of others, and are these now.
    pub welded_points: usize,
    /// Faces without area that were dropped, or whose neighbour was divided instead.
    pub flat_faces: usize,
    /// Faces with the same corners as another that were dropped.
    pub doubled_faces: usize,
    /// Faces that were dropped at edges of three faces or more.
    pub crowded_faces: usize,
    /// Faces that were turned over, to face as those around them.
    pub turned_faces: usize,
    /// Points where several fans of faces met that have a vertex for each now.
    pub split_points: usize,
    /// Holes that were filled.
    pub filled_holes: usize,
    /// The faces in them.
    pub fill_faces: usize,
}

/// Points nearer than this share of the diagonal are one: six digits in a file of text say no more.
const NEAR: f64 = 1e-6;
/// A face is flat if it is lower than this share of its longest edge.
const FLAT: f64 = 1e-12;

/// Mends a mesh. Holes whose rim is shorter than `rim`, in units of length, are filled, and pieces that hang on an edge of
/// other faces are dropped whole if they are smaller than such a hole. O(n log n) for each round in which faces are
/// dropped at an edge.
///
/// # Errors
///
/// [`MeshError`] if no face is left, or `progress` breaks.
///
/// # Example
///
/// ```
/// use mindeg::{Progress, TriMesh, glam::DVec3, repair::repaired};
///
/// // A tetrahedron with one face twice and another missing.
/// let points = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
/// let part = TriMesh::new(points, vec![[0, 2, 1], [0, 1, 3], [0, 2, 1], [1, 2, 3]])?;
/// let (mesh, repairs) = repaired(&part, 4.0, Progress::NONE)?;
/// assert_eq!((repairs.doubled_faces, repairs.filled_holes), (1, 1));
/// assert!(mesh.boundary_loops().is_empty());
/// # Ok::<(), mindeg::MeshError>(())
/// ```
pub fn repaired(
    mesh: &TriMesh,
    rim: f64,
    progress: Progress<'_>,
) -> Result<(TriMesh, Repairs), MeshError> {
    let mut repairs = Repairs::default();
    let mut faces = Faces::of(mesh, &mut repairs);
    progress.report("repairing", 0, 4)?;
    faces.drop_flat(&mut repairs);
    faces.drop_doubled(&mut repairs);
    progress.report("repairing", 1, 4)?;
    faces.drop_crowded(rim, &mut repairs);
    progress.report("repairing", 2, 4)?;
    faces.turn(&mut repairs);
    let open = faces.mesh(mesh)?;
    progress.report("repairing", 3, 4)?;
    let loops = Loops::of(&open);
    let length = |vertices: &[u32]| -> f64 {
        let next = vertices.iter().cycle().skip(1);
        vertices.iter().zip(next).map(|(a, b)| faces.at(*a).distance(faces.at(*b))).sum()
    };
    let is_small = |index: &usize| {
        let found = &loops.list()[*index];
        found.defect.is_none() && length(&found.vertices) < rim
    };
    let only: Vec<usize> = (0..loops.list().len()).filter(is_small).collect();
    let options = FillOptions { only: Some(only), ..FillOptions::default() };
    let filled = fill(open, &loops, &options, progress)?;
    repairs.filled_holes = filled.filled.len();
    for hole in &filled.filled {
        // They belong to the group of a face beside them.
        let rim = &loops.list()[hole.index].vertices;
        let group = faces.group_at([rim[0], rim[1 % rim.len()]]);
        let own = hole.triangles.start as usize..hole.triangles.end as usize;
        repairs.fill_faces += own.len();
        faces.list.extend(filled.mesh.triangles()[own].iter().map(|corners| (*corners, group)));
    }
    repairs.split_points = faces.split_points();
    progress.report("repairing", 4, 4)?;
    Ok((faces.mesh(mesh)?, repairs))
}

/// The faces of a mesh under repair.
struct Faces<'a> {
    positions: &'a [DVec3],
    /// By their vertices, of which near ones are one, with their groups.
    list: Vec<([u32; 3], u32)>,
}

/// The faces at an edge.
type AtEdge = BTreeMap<[u32; 2], Vec<u32>>;

impl<'a> Faces<'a> {
    fn of(mesh: &'a TriMesh, repairs: &mut Repairs) -> Self {
        let positions = mesh.positions();
        let (low, high) = positions
            .iter()
            .fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(l, h), p| (l.min(*p), h.max(*p)));
        let near = (NEAR * low.distance(high)).max(2.0 * mesh.rounding());
        let [equal, near] = [0.0, near].map(|tolerance| weld(positions, tolerance));
        let mut moved: Vec<u32> =
            mesh.triangles().iter().flatten().map(|v| equal[*v as usize]).collect();
        moved.sort_unstable();
        moved.dedup();
        let is_moved = |v: &&u32| equal[near[**v as usize] as usize] != **v;
        repairs.welded_points = moved.iter().filter(is_moved).count();
        let groups = (0_u32..)
            .zip(mesh.groups())
            .flat_map(|(index, group)| group.triangles.clone().map(move |_| index));
        let welded = mesh.triangles().iter().map(|corners| corners.map(|v| near[v as usize]));
        Self { positions, list: welded.zip(groups).collect() }
    }

    fn at(&self, vertex: u32) -> DVec3 {
        self.positions[vertex as usize]
    }

    fn area(&self, face: u32) -> f64 {
        area_in_space(self.list[face as usize].0.map(|v| self.at(v)))
    }

    fn by_edge(&self) -> AtEdge {
        let mut at_edge = AtEdge::new();
        for (face, (corners, _)) in (0_u32..).zip(&self.list) {
            for edge in edges_of(*corners) {
                at_edge.entry(sorted(edge)).or_default().push(face);
            }
        }
        at_edge
    }

    /// Keeps the faces that are not marked.
    fn keep(&mut self, is_dropped: &[bool]) {
        let mut dropped = is_dropped.iter();
        self.list.retain(|_| !dropped.next().copied().unwrap_or(false));
    }

    /// The index, 0 to 2, of the longest edge of a face without area, if it has none.
    fn flat(&self, corners: [u32; 3]) -> Option<usize> {
        let [a, b, c] = corners.map(|v| self.at(v));
        let lengths = [a.distance_squared(b), b.distance_squared(c), c.distance_squared(a)];
        let longest = (0..3).fold(0, |best, i| if lengths[i] > lengths[best] { i } else { best });
        let is_flat = (b - a).cross(c - a).length() <= FLAT * lengths[longest];
        is_flat.then_some(longest)
    }

    /// Drops faces with a corner twice. A face whose corners lie on a line is dropped, too; the face beyond its longest
    /// edge is divided at its middle corner, else there would be a slit.
    fn drop_flat(&mut self, repairs: &mut Repairs) {
        let before = self.list.len();
        self.list.retain(|([a, b, c], _)| a != b && b != c && c != a);
        repairs.flat_faces += before - self.list.len();
        let mut at_edge = self.by_edge();
        let mut is_dropped = vec![false; self.list.len()];
        let is_flat = |faces: &Self, t: &u32| faces.flat(faces.list[*t as usize].0).is_some();
        let mut queue: Vec<u32> =
            (0..self.list.len() as u32).filter(|t| is_flat(self, t)).collect();
        // Each step replaces a flat face, and its neighbour by two; those may be flat again.
        let mut left = 20 * queue.len();
        while let Some(face) = queue.pop() {
            let (corners, _) = self.list[face as usize];
            let Some(i) = self.flat(corners).filter(|_| !is_dropped[face as usize]) else {
                continue;
            };
            let [a, b, middle] = [0, 1, 2].map(|j| corners[(i + j) % 3]);
            let beyond: Vec<u32> = at_edge[&sorted([a, b])].clone();
            is_dropped[face as usize] = true;
            repairs.flat_faces += 1;
            for edge in edges_of(corners) {
                at_edge.entry(sorted(edge)).or_default().retain(|other| *other != face);
            }
            let &[one, other] = beyond.as_slice() else { continue };
            let neighbour = if one == face { other } else { one };
            let (across, group) = self.list[neighbour as usize];
            if across.contains(&middle) || left == 0 {
                continue;
            }
            left -= 1;
            let [to_a, to_b] = [b, a].map(|old| across.map(|v| if v == old { middle } else { v }));
            let new = self.list.len() as u32;
            self.list[neighbour as usize].0 = to_a;
            self.list.push((to_b, group));
            is_dropped.push(false);
            for edge in edges_of(across) {
                at_edge.entry(sorted(edge)).or_default().retain(|other| *other != neighbour);
            }
            for (part, corners) in [(neighbour, to_a), (new, to_b)] {
                for edge in edges_of(corners) {
                    at_edge.entry(sorted(edge)).or_default().push(part);
                }
                if self.flat(corners).is_some() {
                    queue.push(part);
                }
            }
        }
        self.keep(&is_dropped);
    }

    /// Of faces with the same corners, keeps the first of those by which one side has more; none if both have as many.
    fn drop_doubled(&mut self, repairs: &mut Repairs) {
        let mut same: BTreeMap<[u32; 3], Vec<(u32, bool)>> = BTreeMap::new();
        for (face, (corners, _)) in (0_u32..).zip(&self.list) {
            let least = (0..3).fold(0, |best, i| if corners[i] < corners[best] { i } else { best });
            let [a, b, c] = [0, 1, 2].map(|i| corners[(least + i) % 3]);
            same.entry([a, b.min(c), b.max(c)]).or_default().push((face, b < c));
        }
        let mut is_dropped = vec![false; self.list.len()];
        for faces in same.into_values().filter(|faces| faces.len() > 1) {
            let left = faces.iter().filter(|(_, is_left)| *is_left).count();
            let right = faces.len() - left;
            let kept =
                faces.iter().find(|(_, is_left)| left != right && *is_left == (left > right));
            let kept = kept.map(|(face, _)| *face);
            repairs.doubled_faces += faces.len() - usize::from(kept.is_some());
            for (face, _) in faces {
                is_dropped[face as usize] = Some(face) != kept;
            }
        }
        self.keep(&is_dropped);
    }

    /// At edges of three faces or more, keeps two that agree: those of the largest pieces, then the largest.
    fn drop_crowded(&mut self, rim: f64, repairs: &mut Repairs) {
        // A disc with such a rim.
        let small = rim * rim / (4.0 * std::f64::consts::PI);
        loop {
            let at_edge = self.by_edge();
            if at_edge.values().all(|faces| faces.len() < 3) {
                return;
            }
            let mut pieces = DisjointSets::new(self.list.len());
            for faces in at_edge.values() {
                if let &[a, b] = faces.as_slice() {
                    pieces.join(a, b);
                }
            }
            let mut areas = vec![0.0; self.list.len()];
            for face in 0..self.list.len() as u32 {
                areas[pieces.least(face) as usize] += self.area(face);
            }
            let mut is_dropped = vec![false; self.list.len()];
            let mut lost = vec![false; self.list.len()];
            for (edge, faces) in at_edge.iter().filter(|(_, faces)| faces.len() > 2) {
                let runs = |face: u32| edges_of(self.list[face as usize].0).contains(edge);
                let mut ranked: Vec<(f64, f64, u32)> = faces
                    .iter()
                    .map(|face| (areas[pieces.least(*face) as usize], self.area(*face), *face))
                    .collect();
                ranked.sort_by(|a, b| {
                    b.0.total_cmp(&a.0).then(b.1.total_cmp(&a.1)).then(a.2.cmp(&b.2))
                });
                let first = ranked[0].2;
                let second = ranked[1..].iter().find(|face| runs(face.2) != runs(first));
                let second = second.unwrap_or(&ranked[1]).2;
                for (of_piece, _, face) in ranked {
                    if face != first && face != second {
                        is_dropped[face as usize] = true;
                        let piece = pieces.least(face) as usize;
                        lost[piece] |= of_piece < small && piece != pieces.least(first) as usize;
                    }
                }
            }
            for face in 0..self.list.len() as u32 {
                is_dropped[face as usize] |= lost[pieces.least(face) as usize];
            }
            repairs.crowded_faces += is_dropped.iter().filter(|is_dropped| **is_dropped).count();
            self.keep(&is_dropped);
        }
    }

    /// Turns faces over so that each piece faces as most of its area did. Where that cannot be, some edges stay wrong.
    fn turn(&mut self, repairs: &mut Repairs) {
        let at_edge = self.by_edge();
        let count = self.list.len();
        let mut turned: Vec<Option<bool>> = vec![None; count];
        let mut piece = Vec::new();
        for start in 0..count as u32 {
            if turned[start as usize].is_some() {
                continue;
            }
            turned[start as usize] = Some(false);
            piece.clear();
            piece.push(start);
            let mut next = 0;
            while let Some(&face) = piece.get(next) {
                next += 1;
                let own = turned[face as usize].unwrap_or(false);
                for edge in edges_of(self.list[face as usize].0) {
                    for &other in at_edge[&sorted(edge)].iter().filter(|other| **other != face) {
                        if turned[other as usize].is_none() {
                            let agrees = !edges_of(self.list[other as usize].0).contains(&edge);
                            turned[other as usize] = Some(own == agrees);
                            piece.push(other);
                        }
                    }
                }
            }
            let area = |is_turned: bool| -> f64 {
                let of = piece.iter().filter(|face| turned[**face as usize] == Some(is_turned));
                of.map(|face| self.area(*face)).sum()
            };
            // The other way round, if that turns less.
            let other_way = area(true) > area(false);
            for &face in &piece {
                if turned[face as usize] == Some(!other_way) {
                    self.list[face as usize].0.swap(1, 2);
                    repairs.turned_faces += 1;
                }
            }
        }
    }

    /// The group of the first face at an edge.
    fn group_at(&self, edge: [u32; 2]) -> u32 {
        let at = |(corners, _): &&([u32; 3], u32)| edge.iter().all(|v| corners.contains(v));
        self.list.iter().find(at).map_or(0, |(_, group)| *group)
    }

    /// The number of points where several fans of faces meet.
    fn split_points(&self) -> usize {
        let mut fans = DisjointSets::new(3 * self.list.len());
        let corner = |face: u32, v: u32| {
            let at = self.list[face as usize].0.iter().position(|other| *other == v);
            3 * face + at.unwrap_or(0) as u32
        };
        for (edge, faces) in self.by_edge() {
            for pair in faces.windows(2) {
                edge.iter().for_each(|v| fans.join(corner(pair[0], *v), corner(pair[1], *v)));
            }
        }
        let mut at: Vec<[u32; 2]> = (0_u32..)
            .zip(self.list.iter().flat_map(|(corners, _)| corners))
            .map(|(corner, v)| [*v, fans.least(corner)])
            .collect();
        at.sort_unstable();
        at.dedup();
        at.chunk_by(|a, b| a[0] == b[0]).filter(|fans| fans.len() > 1).count()
    }

    /// The faces in the groups of the mesh that they come from.
    fn mesh(&self, of: &TriMesh) -> Result<TriMesh, MeshError> {
        let mut list = self.list.clone();
        list.sort_by_key(|(_, group)| *group);
        let mut end = 0;
        let mut groups = Vec::new();
        for same in list.chunk_by(|a, b| a.1 == b.1) {
            let start = end;
            end += same.len() as u32;
            groups.push(Group { triangles: start..end, ..of.groups()[same[0].1 as usize].clone() });
        }
        let triangles = list.into_iter().map(|(corners, _)| corners).collect();
        let mesh = TriMesh::new(self.positions.to_vec(), triangles)?.with_groups(groups);
        let mesh = mesh.with_lines(of.lines().into_owned(), of.segments().to_vec())?;
        let mesh = mesh.with_named_vertices(of.named_vertices().into_owned())?;
        Ok(mesh.called(of.name()))
    }
}
