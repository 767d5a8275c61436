//! One face of a model: its vertices in order, and its plane.

use glam::{DVec2, DVec3};
use mindeg_mesh::planar::{BoundaryFaults, PlanarBoundary};

use super::{Model, Pass};

/// The plane of a face, with coordinates in which the face is counter-clockwise.
///
/// A plane along two axes keeps two coordinates unchanged, so that nothing is rounded. In any other
/// plane the coordinates are along two perpendicular unit vectors, from a corner of the face.
/// Lengths and angles are the same in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// The unit normal.
    pub normal: DVec3,
    /// The origin of the coordinates.
    origin: DVec3,
    axes: [DVec3; 2],
    /// A mean of corners.
    pub(super) center: DVec3,
}

impl Plane {
    /// The plane through the mean of the corners of a loop, with Newell's normal; `None` if the
    /// loop has no area.
    pub(super) fn of_loop(corners: &[DVec3]) -> Option<Self> {
        let first = corners[0];
        let mut sum = DVec3::ZERO;
        let mut normal = DVec3::ZERO;
        for (index, &corner) in corners.iter().enumerate() {
            let next = corners[(index + 1) % corners.len()];
            sum += corner - first;
            normal += (corner - first).cross(next - first);
        }
        // The length of a product may vanish although its factors do not.
        let largest = normal.abs().max_element();
        let normal = (normal / largest).try_normalize()?;
        let center = first + sum / corners.len() as f64;
        Some(Self::new(normal, first, center))
    }

    fn new(normal: DVec3, first: DVec3, center: DVec3) -> Self {
        let size = normal.abs();
        let (origin, axes) = if size.x == 1.0 {
            (DVec3::ZERO, [DVec3::Y * normal.x, DVec3::Z])
        } else if size.y == 1.0 {
            (DVec3::ZERO, [DVec3::Z * normal.y, DVec3::X])
        } else if size.z == 1.0 {
            (DVec3::ZERO, [DVec3::X * normal.z, DVec3::Y])
        } else {
            let along = if size.x <= size.y && size.x <= size.z {
                DVec3::X
            } else if size.y <= size.z {
                DVec3::Y
            } else {
                DVec3::Z
            };
            let u = along.cross(normal).normalize();
            (first, [u, normal.cross(u)])
        };
        Self { normal, origin, axes, center }
    }

    /// The coordinates of a point in the plane.
    pub fn project(&self, point: DVec3) -> DVec2 {
        let from_origin = point - self.origin;
        DVec2::new(from_origin.dot(self.axes[0]), from_origin.dot(self.axes[1]))
    }

    /// The point of the plane with these coordinates.
    pub fn lift(&self, point: DVec2) -> DVec3 {
        let height = (self.center - self.origin).dot(self.normal);
        self.origin + self.axes[0] * point.x + self.axes[1] * point.y + self.normal * height
    }

    /// The distance of a point from the plane.
    pub fn distance(&self, point: DVec3) -> f64 {
        (point - self.center).dot(self.normal).abs()
    }
}

impl Model {
    /// The vertices of a face, ring by ring: the outer one counter-clockwise, holes clockwise.
    /// O(m) for m vertices.
    ///
    /// # Panics
    ///
    /// If the model has no such face.
    pub fn face_vertices(&self, face: usize) -> Vec<u32> {
        self.face_rings(face).concat()
    }

    /// The vertices of a face, in the order of [`face_vertices`](Self::face_vertices), and its
    /// boundary in its plane, with the straight runs of its edges. `positions` are the positions of
    /// the model's vertices.
    ///
    /// # Errors
    ///
    /// Points that rounding has moved onto or past each other.
    ///
    /// # Panics
    ///
    /// If the model has no such face.
    pub fn boundary(
        &self,
        face: usize,
        positions: &[DVec3],
    ) -> Result<(Vec<u32>, PlanarBoundary), BoundaryFaults> {
        let rings = self.face_rings(face);
        let project = |&vertex: &u32| self.plane(face).project(positions[vertex as usize]);
        let points: Vec<Vec<DVec2>> =
            rings.iter().map(|ring| ring.iter().map(project).collect()).collect();
        let boundary = PlanarBoundary::new(&points)?;
        let mut corners = Vec::new();
        let mut next = 0;
        for pass in self.faces[face].loops.iter().flatten() {
            corners.push(next);
            next += self.edges[pass.edge as usize].law.intervals();
        }
        Ok((rings.concat(), boundary.with_straight_sides(corners)))
    }

    /// The vertices of each ring of a face.
    fn face_rings(&self, face: usize) -> Vec<Vec<u32>> {
        let of_pass = |&Pass { edge, is_upward }: &Pass| {
            let edge = &self.edges[edge as usize];
            let [low, high] = edge.corners;
            let first = self.vertex_of(if is_upward { low } else { high });
            let mut inner: Vec<u32> = edge.inner().collect();
            if !is_upward {
                inner.reverse();
            }
            [first].into_iter().chain(inner)
        };
        let rings = self.faces[face].loops.iter();
        rings.map(|passes| passes.iter().flat_map(of_pass).collect()).collect()
    }

    /// The corners of a face, loop by loop: the outer one first, holes opposite to it.
    ///
    /// # Panics
    ///
    /// If the model has no such face.
    pub fn face_loops(&self, face: usize) -> impl Iterator<Item = Vec<u32>> + '_ {
        self.faces[face].loops.iter().map(|passes| {
            let begin = |pass: &Pass| {
                let [low, high] = self.edges[pass.edge as usize].corners;
                if pass.is_upward { low } else { high }
            };
            passes.iter().map(begin).collect()
        })
    }

    /// The plane of a face.
    ///
    /// # Panics
    ///
    /// If the model has no such face.
    pub fn plane(&self, face: usize) -> &Plane {
        &self.faces[face].plane
    }

    /// The number of vertices of a face.
    ///
    /// # Panics
    ///
    /// If the model has no such face.
    pub fn face_size(&self, face: usize) -> u32 {
        let passes = self.faces[face].loops.iter().flatten();
        passes.map(|pass| self.edges[pass.edge as usize].law.intervals()).sum()
    }
}
