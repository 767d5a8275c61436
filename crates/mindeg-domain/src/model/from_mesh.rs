//! A model from a reader's mesh: its polygons are the faces.

use mindeg_mesh::TriMesh;

use super::build::largest_extent;
use super::{Model, ModelFace, ModelParts, coplanar};
use crate::error::DomainError;
use crate::side::Side;

/// Options for turning a mesh into a model.
#[derive(Clone, Debug, PartialEq)]
pub struct FromMesh {
    /// The division of every edge.
    pub edges: Side,
    /// Whether neighbouring faces of one group in one plane become one face.
    pub merge_coplanar: bool,
    /// How far a corner may be from the plane of its face, in units of length; `None` means
    /// [`PLANAR_SHARE`](super::PLANAR_SHARE) of the largest extent.
    pub planar_tolerance: Option<f64>,
}

impl Model {
    /// The model whose faces are the polygons of a mesh, or its triangles if it has no other
    /// polygons. O(n log n).
    ///
    /// Vertices with equal coordinates are one corner, with the index of the first. A polygon that
    /// uses an edge twice, once in each direction, has a hole there. Groups and materials stay;
    /// triangles that name a corner twice are left out. The [notes](TriMesh::notes) of the mesh
    /// become notes of the model.
    ///
    /// With [`FromMesh::merge_coplanar`], faces of one group that share an edge with two faces
    /// become one, if all corners of the smaller are within a tolerance of the plane of the largest
    /// face of the whole region: four times the [rounding](TriMesh::rounding) of the mesh, or a
    /// millionth of its largest extent if that is more. A region that touches itself in a corner
    /// stays unchanged. Then corners between two edges on one line vanish.
    ///
    /// # Errors
    ///
    /// The errors of [`Model::new`]; indices of faces are those of the mesh, or after merging.
    ///
    /// # Example
    ///
    /// ```
    /// use glam::DVec3;
    /// use mindeg_domain::{FromMesh, Model, Side};
    /// use mindeg_mesh::TriMesh;
    ///
    /// let square = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
    /// let mesh = TriMesh::new(square, vec![[0, 1, 2], [0, 2, 3]])?;
    /// let with = FromMesh { edges: Side::count(2), merge_coplanar: true, planar_tolerance: None };
    /// let model = Model::of_mesh(&mesh, &with)?;
    /// assert_eq!((model.face_count(), model.edge_count()), (1, 4));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of_mesh(mesh: &TriMesh, with: &FromMesh) -> Result<Self, DomainError> {
        let corners = mesh.positions();
        let first_of = mindeg_mesh::weld(corners, 0.0);
        let weld = |corner: &u32| first_of[*corner as usize];
        let mut faces = Vec::new();
        let mut group = 0;
        let groups = mesh.groups();
        let mut add = |first_triangle: u32, polygon: &[u32]| {
            while groups.get(group).is_some_and(|at| at.triangles.end <= first_triangle) {
                group += 1;
            }
            let mut polygon: Vec<u32> = polygon.iter().map(weld).collect();
            polygon.dedup();
            while polygon.len() > 1 && polygon.first() == polygon.last() {
                polygon.pop();
            }
            if polygon.len() < 3 {
                return;
            }
            let mut loops = split_at_bridges(polygon);
            coplanar::put_largest_first(&mut loops, corners);
            let of = groups.get(group);
            let name = of.map(|group| group.name.clone()).filter(|name| !name.is_empty());
            let material = of.and_then(|group| group.material.clone());
            faces.push(ModelFace { loops, group: name, material, name: None });
        };
        match mesh.polygons() {
            Some(polygons) => {
                for (polygon, corners) in polygons.iter().enumerate() {
                    add(polygons.triangle_starts[polygon], corners);
                }
            }
            None => {
                for (triangle, corners) in (0..).zip(mesh.triangles()) {
                    add(triangle, corners);
                }
            }
        }
        if with.merge_coplanar {
            let extent = largest_extent(corners.iter().copied());
            let tolerance = (4.0 * mesh.rounding()).max(1e-6 * extent);
            faces = coplanar::merged(corners, faces, tolerance);
        }
        let mut model = Self::new(ModelParts {
            corners: corners.to_vec(),
            faces,
            edges: Vec::new(),
            other_edges: Some(with.edges.clone()),
            planar_tolerance: with.planar_tolerance,
        })?;
        model.notes.extend(mesh.notes().iter().map(|note| sentence(note)));
        Ok(match mindeg_mesh::Triangles::name(mesh) {
            Some(name) => model.named(name),
            None => model,
        })
    }
}

/// A phrase as a sentence.
fn sentence(phrase: &str) -> String {
    let mut letters = phrase.chars();
    letters
        .next()
        .map_or_else(String::new, |first| format!("{}{}.", first.to_uppercase(), letters.as_str()))
}

/// The loops of a polygon, cut at every edge that it uses twice, once in each direction.
fn split_at_bridges(polygon: Vec<u32>) -> Vec<Vec<u32>> {
    let mut open = vec![polygon];
    let mut loops = Vec::new();
    while let Some(corners) = open.pop() {
        match find_bridge(&corners) {
            Some((i, j)) => {
                // From i to i + 1 and from j to j + 1 along the bridge.
                open.push(corners[i + 1..j].to_vec());
                open.push([&corners[..i], &corners[j + 1..]].concat());
            }
            None => loops.push(corners),
        }
    }
    loops
}

/// The indices i < j of an edge that is used in both directions and is not a spike.
fn find_bridge(corners: &[u32]) -> Option<(usize, usize)> {
    let n = corners.len();
    let next = |i: usize| corners[(i + 1) % n];
    let mut edges: Vec<([u32; 2], usize)> = (0..n).map(|i| ([corners[i], next(i)], i)).collect();
    edges.sort_unstable();
    (0..n).find_map(|i| {
        let back = [next(i), corners[i]];
        let at = edges.partition_point(|&(edge, _)| edge < back);
        let &(edge, j) = edges.get(at)?;
        (edge == back && j > i + 1 && j + 1 < n + i).then_some((i, j))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bridge_splits_a_polygon() {
        let split = |corners: &[u32]| {
            let mut loops = split_at_bridges(corners.to_vec());
            for corners in &mut loops {
                let least = (0..corners.len()).min_by_key(|&i| corners[i]).unwrap();
                corners.rotate_left(least);
            }
            loops.sort();
            loops
        };
        assert_eq!(split(&[0, 1, 2, 3]), [vec![0, 1, 2, 3]]);
        assert_eq!(split(&[0, 1, 2, 3, 0, 4, 5, 6, 4]), [vec![0, 1, 2, 3], vec![4, 5, 6]]);
        // From any corner on.
        assert_eq!(split(&[5, 6, 4, 0, 1, 2, 3, 0, 4]), [vec![0, 1, 2, 3], vec![4, 5, 6]]);
        // Two holes, one behind the other.
        let two = [0, 1, 2, 3, 0, 4, 5, 7, 8, 9, 7, 5, 6, 4];
        assert_eq!(split(&two), [vec![0, 1, 2, 3], vec![4, 5, 6], vec![7, 8, 9]]);
        // A spike is not a hole.
        assert_eq!(split(&[0, 1, 2, 9, 2, 3]), [vec![0, 1, 2, 9, 2, 3]]);
    }
}
