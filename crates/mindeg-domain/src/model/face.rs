//! One face of a model: its vertices in order, and its plane.

use std::ops::Range;

use glam::{DVec2, DVec3};
use mindeg_mesh::planar::LEAST_TURN;

use super::{Model, Pass};

/// The plane of a face, with coordinates in which the face is counter-clockwise.
///
/// A plane along two axes takes two coordinates as they are, so that nothing is rounded; in any
/// other plane the coordinates are those along two unit vectors at a right angle, from a corner of
/// the face. Lengths and angles are the same in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// The unit normal.
    pub normal: DVec3,
    /// What the coordinates are counted from.
    origin: DVec3,
    axes: [DVec3; 2],
    /// A mean of corners.
    pub(super) center: DVec3,
}

impl Plane {
    /// The plane through the mean of the corners of a loop, with Newell's normal; none if the loop
    /// has no area.
    pub(super) fn of_loop(corners: &[DVec3]) -> Option<Self> {
        let first = corners[0];
        let mut sum = DVec3::ZERO;
        let mut normal = DVec3::ZERO;
        for (index, &corner) in corners.iter().enumerate() {
            let next = corners[(index + 1) % corners.len()];
            sum += corner - first;
            normal += (corner - first).cross(next - first);
        }
        // A length of a product may vanish where lengths do not.
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
    #[must_use]
    pub fn project(&self, point: DVec3) -> DVec2 {
        let from_origin = point - self.origin;
        DVec2::new(from_origin.dot(self.axes[0]), from_origin.dot(self.axes[1]))
    }

    /// The point of the plane with some coordinates.
    #[must_use]
    pub fn lift(&self, point: DVec2) -> DVec3 {
        let height = (self.center - self.origin).dot(self.normal);
        self.origin + self.axes[0] * point.x + self.axes[1] * point.y + self.normal * height
    }

    /// How far a point is from the plane.
    #[must_use]
    pub fn distance(&self, point: DVec3) -> f64 {
        (point - self.center).dot(self.normal).abs()
    }
}

/// The vertices of a face: its outer ring and then its holes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FaceRings {
    /// The vertices of the model, ring by ring: the outer one counter-clockwise, holes clockwise.
    pub vertices: Vec<u32>,
    /// The vertices of each ring, as places in `vertices`.
    pub rings: Vec<Range<u32>>,
    /// Where an edge of the model begins, as places in `vertices`, ascending.
    pub corners: Vec<u32>,
}

impl FaceRings {
    /// For every place the straight run that the boundary edge beginning there belongs to. Edges of
    /// the model that follow each other on one line are one run.
    ///
    /// `points` are the positions of the vertices in the plane.
    #[must_use]
    pub fn straight_runs(&self, points: &[DVec2]) -> Vec<u32> {
        let mut runs = vec![0; points.len()];
        let mut run = 0;
        for ring in &self.rings {
            let first = self.corners.partition_point(|&corner| corner < ring.start);
            let last = self.corners.partition_point(|&corner| corner < ring.end);
            let corners = &self.corners[first..last];
            let at = |i: usize| points[corners[i % corners.len()] as usize];
            let first_run = run;
            for i in 0..corners.len() {
                let before = at(i) - at(i + corners.len() - 1);
                let after = at(i + 1) - at(i);
                let sine = before.perp_dot(after) / (before.length() * after.length());
                let is_straight = sine.abs() <= LEAST_TURN && before.dot(after) > 0.0;
                if i > 0 && !is_straight {
                    run += 1;
                }
                let end = corners.get(i + 1).copied().unwrap_or(ring.end);
                runs[corners[i] as usize..end as usize].fill(run);
            }
            // The last run may go on over the first corner.
            let before = at(0) - at(corners.len() - 1);
            let after = at(1) - at(0);
            let sine = before.perp_dot(after) / (before.length() * after.length());
            if sine.abs() <= LEAST_TURN && before.dot(after) > 0.0 && run > first_run {
                let ring = &mut runs[ring.start as usize..ring.end as usize];
                let last = run;
                ring.iter_mut().filter(|run| **run == last).for_each(|run| *run = first_run);
            }
            run += 1;
        }
        runs
    }
}

impl Model {
    /// The vertices of a face, ring by ring. O(its vertices).
    ///
    /// # Panics
    ///
    /// If there is no such face.
    #[must_use]
    pub fn rings(&self, face: usize) -> FaceRings {
        let mut rings = FaceRings::default();
        for passes in &self.faces[face].loops {
            let start = rings.vertices.len() as u32;
            for &Pass { edge, is_upward } in passes {
                let edge = &self.edges[edge as usize];
                let [low, high] = edge.corners;
                rings.corners.push(rings.vertices.len() as u32);
                rings.vertices.push(self.vertex_of(if is_upward { low } else { high }));
                if is_upward {
                    rings.vertices.extend(edge.inner());
                } else {
                    rings.vertices.extend(edge.inner().rev());
                }
            }
            rings.rings.push(start..rings.vertices.len() as u32);
        }
        rings
    }

    /// The corners of a face, loop by loop: the outer one first, holes opposite to it.
    ///
    /// # Panics
    ///
    /// If there is no such face.
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
    /// If there is no such face.
    #[must_use]
    pub fn plane(&self, face: usize) -> &Plane {
        &self.faces[face].plane
    }

    /// The number of vertices of a face.
    ///
    /// # Panics
    ///
    /// If there is no such face.
    #[must_use]
    pub fn face_size(&self, face: usize) -> u32 {
        let passes = self.faces[face].loops.iter().flatten();
        passes.map(|pass| self.edges[pass.edge as usize].law.intervals()).sum()
    }
}
