//! The cost of a mesh: the sum of the costs of its triangles and its vertices.

use crate::array_mesh::ArrayMesh;
use crate::goal::{Goal, Weights};
use crate::manifold::Manifold;
use crate::space::Vector;
use crate::triangle::{SQRT_3, distortion, doubled_area, has_sine, min_angle};

/// How far below its limit a corner's angle may stay, as a share.
const NEAR_LIMIT: f64 = 0.97;

/// The cost of a part of the mesh, and its minimum angle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cost {
    pub(crate) energy: f64,
    pub(crate) min_angle: f64,
    /// The part of the energy that hard degree violations cause.
    pub(crate) hard: f64,
}

impl Weights {
    /// The angle that a triangle should have: the floor, or less where its boundary vertices allow less.
    pub(crate) fn wanted_angle<S: Manifold>(&self, mesh: &ArrayMesh<S>, triangle: u32) -> f64 {
        let mut wanted = self.floor;
        for v in mesh.triangles[triangle as usize].vertices {
            if let Some(goal) = mesh.goals.get(mesh.vertices[v as usize].goal as usize) {
                wanted = wanted.min(NEAR_LIMIT * goal.local_limit());
            }
        }
        wanted
    }

    /// The least limit at a triangle's vertices, in degrees; 60 at most.
    pub(crate) fn local_limit<S: Manifold>(&self, mesh: &ArrayMesh<S>, triangle: u32) -> f64 {
        let goal = |v: u32| mesh.goals.get(mesh.vertices[v as usize].goal as usize);
        let limits = mesh.triangles[triangle as usize]
            .vertices
            .map(|v| goal(v).map_or(60.0, Goal::local_limit));
        limits.into_iter().fold(60.0, f64::min)
    }

    /// The cost of a triangle: shape, size, and what its minimum angle lacks; with the angle, which is not
    /// told where it is above the floor, or where shares count.
    pub(crate) fn triangle<S: Manifold>(&self, mesh: &ArrayMesh<S>, triangle: u32) -> (f64, f64) {
        let corners = mesh.corners(triangle);
        let mut bend = S::bend(mesh, triangle);
        if self.is_outside(mesh, triangle) {
            bend += self.degree;
        }
        if self.by_share {
            return (self.share(corners, self.wanted_sine(mesh, triangle)) + bend, 0.0);
        }
        let shape = distortion(corners);
        if !shape.is_finite() {
            return (f64::INFINITY, -180.0);
        }
        let vertices = mesh.triangles[triangle as usize].vertices;
        let size = vertices.iter().map(|v| mesh.vertices[*v as usize].size).sum::<f64>() / 3.0;
        let growth = libm::log(doubled_area(corners) / (SQRT_3 / 2.0 * size * size));
        let squared = shape * shape;
        let cost = squared * squared - 1.0 + 0.3 * growth * growth + bend;
        // Most angles are large enough: no trigonometry.
        if has_sine(corners, self.floor_sine) {
            return (cost, 180.0);
        }
        let angle = min_angle(corners);
        let lack = (self.wanted_angle(mesh, triangle) - angle).max(0.0) / 5.0;
        (cost + self.angle * lack * lack, angle)
    }

    /// True if a triangle has no corner inside and should have one.
    pub(crate) fn is_outside<S: Manifold>(&self, mesh: &ArrayMesh<S>, triangle: u32) -> bool {
        let is_at_boundary = |v: &u32| {
            let goal = mesh.goals.get(mesh.vertices[*v as usize].goal as usize);
            goal.is_some_and(|goal| goal.is_boundary)
        };
        self.corners_inside && mesh.triangles[triangle as usize].vertices.iter().all(is_at_boundary)
    }

    /// The sine of the angle that a triangle should have.
    pub(crate) fn wanted_sine<S: Manifold>(&self, mesh: &ArrayMesh<S>, triangle: u32) -> f64 {
        let mut wanted = self.floor_sine;
        for v in mesh.triangles[triangle as usize].vertices {
            if let Some(goal) = mesh.goals.get(mesh.vertices[v as usize].goal as usize) {
                wanted = wanted.min(goal.sine);
            }
        }
        wanted
    }

    /// The cost of a triangle whose minimum angle should have this sine: mostly by the share of it.
    pub(crate) fn share<V: Vector>(&self, corners @ [a, b, c]: [V; 3], wanted: f64) -> f64 {
        let doubled = doubled_area(corners);
        if doubled <= 0.0 {
            return f64::INFINITY;
        }
        let squares = [a.distance_squared(b), b.distance_squared(c), c.distance_squared(a)];
        let least = squares[0].min(squares[1]).min(squares[2]);
        let sum = squares[0] + squares[1] + squares[2];
        // The minimum angle's sine is the doubled area over the product of the two longer edges.
        let longer = (squares[0] * squares[1] * squares[2] / least).sqrt();
        let lack = (wanted * longer / doubled - 1.0).max(0.0);
        let shape = (sum / (2.0 * SQRT_3 * doubled) - 1.0).min(20.0);
        self.angle * (lack + lack * lack) + 0.1 * shape
    }

    /// The cost of a vertex's degree: all of it, and the part for a hard violation.
    pub(crate) fn vertex<S: Manifold>(&self, mesh: &ArrayMesh<S>, vertex: u32) -> (f64, f64) {
        let (excess, soft) = S::degree(mesh, self, vertex);
        let hard = self.degree * f64::from(excess.pow(2));
        (0.3 * soft * soft + hard, hard)
    }

    /// By how much a vertex's degree is out of its range.
    pub(crate) fn excess<S: Manifold>(&self, mesh: &ArrayMesh<S>, vertex: u32) -> u32 {
        S::degree(mesh, self, vertex).0
    }

    /// The same of a vertex of which only the number of triangles counts, if it had so many.
    pub(crate) fn excess_of<S: Manifold>(
        &self,
        mesh: &ArrayMesh<S>,
        vertex: u32,
        triangles: u32,
    ) -> u32 {
        // A vertex that is not there yet is free.
        let known = mesh.vertices.get(vertex as usize);
        let goal = known.and_then(|known| mesh.goals.get(known.goal as usize));
        let (least, most) = match goal {
            Some(goal) => (goal.least, goal.triangles),
            None => (*self.interior.start(), *self.interior.end()),
        };
        triangles.saturating_sub(most).max(least.saturating_sub(triangles))
    }
}
