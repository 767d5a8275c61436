//! The edges of a mesh of any program, as a checker sees them.

use std::collections::BTreeSet;

use glam::DVec3;
use mindeg_mesh::TriMesh;

use super::defect::{MeshDefect, in_space};

/// A mesh with its edges; vertices in one place are one.
pub(super) struct Sides {
    pub(super) mesh: TriMesh,
    pub(super) corners: Vec<[DVec3; 3]>,
    /// All edges by their vertices, the lesser first.
    pub(super) edges: Vec<[u32; 2]>,
    pub(super) boundary: Vec<[u32; 2]>,
    /// Edges of two triangles, with the cosine of the angle between their normals.
    turns: Vec<([u32; 2], f64)>,
}

impl Sides {
    pub(super) fn of(mesh: &TriMesh) -> Self {
        let mesh = mesh.welded(0.0).with_groups(mesh.groups().to_vec());
        let corners: Vec<[DVec3; 3]> =
            mesh.triangles().iter().map(|t| t.map(|v| mesh.positions()[v as usize])).collect();
        let normal = |t: u32| {
            let [a, b, c] = corners[t as usize];
            (b - a).cross(c - a).normalize_or_zero()
        };
        let mut halves: Vec<([u32; 2], u32)> = (0_u32..)
            .zip(mesh.triangles())
            .flat_map(|(t, &[a, b, c])| {
                [[a, b], [b, c], [c, a]].map(|[p, q]| ([p.min(q), p.max(q)], t))
            })
            .collect();
        halves.sort_unstable();
        let (mut edges, mut boundary, mut turns) = (Vec::new(), Vec::new(), Vec::new());
        for same in halves.chunk_by(|a, b| a.0 == b.0) {
            edges.push(same[0].0);
            match same {
                [_] => boundary.push(same[0].0),
                [(edge, t), (_, u)] => turns.push((*edge, normal(*t).dot(normal(*u)))),
                _ => {}
            }
        }
        Self { mesh, corners, edges, boundary, turns }
    }

    /// The edges whose triangles' normals differ by more than an angle in degrees.
    pub(super) fn sharp(&self, angle: f64) -> Vec<[u32; 2]> {
        let cosine = libm::cos(angle.to_radians());
        self.turns.iter().filter(|(_, turn)| *turn < cosine).map(|(edge, _)| *edge).collect()
    }

    /// Edges as triangles without area.
    pub(super) fn segments(&self, edges: &[[u32; 2]]) -> Vec<[DVec3; 3]> {
        let at = |v: u32| self.mesh.positions()[v as usize];
        edges.iter().map(|&[a, b]| [at(a), at(b), at(b)]).collect()
    }

    /// A vertex by the bits of its point, in 32 bits if a file of 32-bit numbers is compared.
    pub(super) fn place(&self, vertex: u32, is_single: bool) -> [u64; 3] {
        // Adding zero turns -0 into 0.
        let at = (self.mesh.positions()[vertex as usize] + DVec3::ZERO).to_array();
        at.map(|x| if is_single { u64::from((x as f32).to_bits()) } else { x.to_bits() })
    }

    /// An edge by the places of its ends.
    fn key(&self, edge: [u32; 2], is_single: bool) -> [[u64; 3]; 2] {
        let mut ends = edge.map(|v| self.place(v, is_single));
        ends.sort_unstable();
        ends
    }

    /// The unit normal of a triangle.
    pub(super) fn normal(&self, triangle: u32) -> DVec3 {
        let [a, b, c] = self.corners[triangle as usize];
        (b - a).cross(c - a).normalize_or_zero()
    }
}

/// Edges of the part that the mesh must have, bit for bit.
pub(super) fn check_kept(
    kind: &'static str,
    what: &str,
    [part, own]: [&Sides; 2],
    [wanted, found]: [&[[u32; 2]]; 2],
    is_single: bool,
    defects: &mut Vec<MeshDefect>,
) {
    let found: BTreeSet<_> = found.iter().map(|&edge| own.key(edge, is_single)).collect();
    let missing = || wanted.iter().filter(|&&edge| !found.contains(&part.key(edge, is_single)));
    if let Some(&[a, b]) = missing().next() {
        let [a, b] = [a, b].map(|v| in_space(part.mesh.positions()[v as usize]));
        let count = missing().count();
        let message =
            format!("{count} {what} of the part are none of the mesh, the first from {a} to {b}");
        defects.push(MeshDefect::new(kind, message));
    }
}
