//! The plane: sites are points, every step ends where it points to, and signed areas guard all.

use crate::array_mesh::ArrayMesh;
use crate::goal::Weights;
use crate::manifold::{Manifold, Slope};
use crate::space::Plane;
use crate::triangle::{cross, is_proper};
use glam::DVec2;
use mindeg_mesh::planar::orientation;

impl Manifold for Plane {
    type Frame = ();
    type Survey = ();

    fn middle(mesh: &ArrayMesh, [a, b]: [u32; 2], _: bool, (): ()) -> Option<DVec2> {
        Some(mesh.at(a).midpoint(mesh.at(b)))
    }

    fn beside(mesh: &ArrayMesh, vertex: u32, (): (), offset: DVec2) -> Option<DVec2> {
        Some(mesh.at(vertex) + offset)
    }

    fn is_proper(&self, corners: [&DVec2; 3]) -> bool {
        is_proper(corners.map(|corner| *corner))
    }

    fn check(mesh: &ArrayMesh, triangle: u32) -> Result<(), String> {
        let [a, b, c] = mesh.corners(triangle);
        if orientation(a, b, c) <= 0.0 {
            return Err(format!("triangle {triangle} is not counter-clockwise"));
        }
        Ok(())
    }

    fn bend(_: &ArrayMesh, _: u32) -> f64 {
        0.0
    }

    fn degree(mesh: &ArrayMesh, weights: &Weights, vertex: u32) -> (u32, f64) {
        let v = &mesh.vertices[vertex as usize];
        let soft = match mesh.goals.get(v.goal as usize) {
            Some(goal) => ((f64::from(v.triangles) - goal.ideal).abs() - 0.5).max(0.0),
            None => f64::from(v.triangles) - 6.0,
        };
        (weights.excess_of(mesh, vertex, v.triangles), soft)
    }

    fn counts_triangles(_: &ArrayMesh, _: u32) -> bool {
        true
    }

    fn frame(_: &ArrayMesh, _: u32) {}

    fn is_on_line(_: &ArrayMesh, _: u32) -> bool {
        false
    }

    fn slope((): &(), x: DVec2, b: DVec2, c: DVec2) -> Option<Slope> {
        let (u, v) = (b - x, c - x);
        let doubled = cross(u, v);
        (doubled > 0.0).then(|| Slope {
            squares: u.length_squared() + v.length_squared() + b.distance_squared(c),
            doubled,
            of_squares: -2.0 * (u + v),
            of_doubled: DVec2::new(b.y - c.y, c.x - b.x),
        })
    }

    fn moved(_: &ArrayMesh, _: u32, from: &DVec2, (): &(), step: DVec2) -> Option<DVec2> {
        Some(*from + step)
    }

    fn may_move(_: &ArrayMesh, _: u32, _: &[u32], to: &DVec2) -> bool {
        to.is_finite()
    }

    fn survey(_: &ArrayMesh, _: &[u32], _: bool) -> Option<()> {
        None
    }

    fn keeps(_: &ArrayMesh, (): &(), _: &[u32]) -> bool {
        true
    }
}
