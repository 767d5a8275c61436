//! A mesh in space as a picture in the plane: a projection along an axis.

use glam::{DVec2, DVec3};
use mindeg_mesh::TriMesh;

/// An axis along which a mesh is viewed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Axis {
    X,
    Y,
    Z,
}

/// The points of a mesh in the plane of a picture.
#[derive(Debug)]
pub(super) struct Flattened {
    pub(super) points: Vec<DVec2>,
    /// The axis of the projection; `None` if the mesh lies in a plane of constant z.
    pub(super) axis: Option<Axis>,
}

impl Flattened {
    /// The mesh along the axis with the largest mean normal, among whose points are those of the
    /// `vertices` that belong to triangles.
    pub(super) fn of(mesh: &TriMesh, vertices: &[u32]) -> Self {
        let positions = mesh.positions();
        let mut heights = vertices.iter().map(|&vertex| positions[vertex as usize].z);
        let first = heights.next();
        let axis = if heights.all(|z| Some(z) == first) { None } else { Some(Axis::of(mesh)) };
        let points = positions.iter().map(|&position| axis.unwrap_or(Axis::Z).flatten(position));
        Self { points: points.collect(), axis }
    }
}

impl Axis {
    /// The axis along which the triangles show the largest area, front and back alike: in a closed
    /// mesh, normals with their signs add up to nothing.
    fn of(mesh: &TriMesh) -> Self {
        let positions = mesh.positions();
        // Small enough that no product overflows.
        let size = positions.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
        let scaled = |vertex: u32| positions[vertex as usize] / size.max(f64::MIN_POSITIVE);
        let normal = |&corners: &[u32; 3]| {
            let [a, b, c] = corners.map(scaled);
            (b - a).cross(c - a).abs()
        };
        let total: DVec3 = mesh.triangles().iter().map(normal).sum();
        // For equal components prefer z, then y.
        if total.z >= total.x && total.z >= total.y {
            Self::Z
        } else if total.y >= total.x {
            Self::Y
        } else {
            Self::X
        }
    }

    /// The position of a point in the picture, which is not mirrored: the view along x and z is from their
    /// positive end, y from its negative one.
    fn flatten(self, position: DVec3) -> DVec2 {
        let DVec3 { x, y, z } = position;
        match self {
            Self::X => DVec2::new(y, z),
            Self::Y => DVec2::new(x, z),
            Self::Z => DVec2::new(x, y),
        }
    }

    /// The note of a page on the projection.
    pub(super) fn note(self) -> String {
        let [along, right, up] = match self {
            Self::X => ["x", "y", "z"],
            Self::Y => ["y", "x", "z"],
            Self::Z => ["z", "x", "y"],
        };
        format!(
            "The mesh is in space. The picture is its projection along the {along} axis, with {right} \
             to the right and {up} up: angles can differ from what you see, and of triangles that lie \
             one behind the other the worse are on top. All figures are those in space."
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two triangles in a plane: one with corners at these positions, one turned over.
    fn plane(corners: [[f64; 3]; 4]) -> TriMesh {
        let positions = corners.map(DVec3::from).to_vec();
        TriMesh::new(positions, vec![[0, 1, 2], [0, 3, 2]]).unwrap()
    }

    #[test]
    fn a_mesh_is_seen_from_where_it_shows_most() {
        let (x, y, z) = ([1.0, 0.0, 0.1], [0.0, 1.0, 0.2], [0.0, 0.1, 1.0]);
        let sum = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| a[i] + b[i]);
        for (a, b, axis, last) in
            [(x, y, Axis::Z, [0.0, 1.0]), (x, z, Axis::Y, [0.0, 1.0]), (y, z, Axis::X, [0.1, 1.0])]
        {
            let flattened = Flattened::of(&plane([[0.0; 3], a, sum(a, b), b]), &[0, 1, 2, 3]);
            assert_eq!(flattened.axis, Some(axis));
            assert_eq!(flattened.points[3].to_array(), last);
        }
    }

    #[test]
    fn a_mesh_at_one_height_is_not_in_space() {
        let mesh = plane([[0.0, 0.0, 5.0], [1.0, 0.0, 5.0], [1.0, 1.0, 5.0], [0.0, 1.0, 5.0]]);
        assert_eq!(Flattened::of(&mesh, &[0, 1, 2, 3]).axis, None);
        // A vertex of no triangle does not count.
        let positions = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let mesh = TriMesh::new(positions, vec![[0, 1, 2]]).unwrap();
        assert_eq!(Flattened::of(&mesh, &[0, 1, 2]).axis, None);
    }
}
