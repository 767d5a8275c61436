//! The demands on a mesh, and the positions where a mesh breaks them.

use crate::numbers::steady_angle;
use crate::preset::Preset;
use mindeg_mesh::quality::{TriangleQuality, WorstTriangles};
use mindeg_mesh::{TriMesh, Triangles};
use std::ops::Range;

/// The demands on a mesh. An absent value demands nothing.
///
/// # Example
///
/// ```
/// use mindeg_answers::demands::Demands;
/// use mindeg::{TriMesh, glam::DVec3};
///
/// let mesh = TriMesh::new(vec![DVec3::ZERO, DVec3::X, DVec3::Y], vec![[0, 1, 2]])?;
/// let demands = Demands { target_angle: Some(50.0), ..Demands::default() };
/// assert_eq!(
///     demands.unmet_by(&mesh, 45.0),
///     ["triangle 0 (vertices 0, 1, 2) has an angle of 45.000°, below the target angle of 50°"]
/// );
/// # Ok::<(), mindeg_mesh::TriMeshError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Demands {
    /// The most edges at a vertex.
    pub max_degree: Option<u32>,
    /// The minimum angle of all triangles, in degrees, or more.
    pub target_angle: Option<f64>,
    /// The rules of a program.
    pub preset: Option<Preset>,
}

/// The first vertex of maximum degree and the triangle of the minimum angle; a mesh without triangles has
/// neither.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WorstPlaces {
    /// The index of the vertex.
    pub vertex: Option<u32>,
    /// The index of the triangle and its vertices.
    pub triangle: Option<(u32, [u32; 3])>,
}

impl WorstPlaces {
    /// The worst places of a mesh given as a list. O(n).
    #[must_use]
    pub fn of(mesh: &TriMesh) -> Self {
        Self::among(mesh, 0..mesh.triangle_count())
    }

    /// The first vertex of maximum degree, and the worst of some triangles.
    #[must_use]
    pub fn among(mesh: &TriMesh, triangles: Range<u32>) -> Self {
        let highest = mesh.max_degree();
        let vertex = mesh.degrees().iter().position(|degree| *degree == highest);
        let mut worst = WorstTriangles::new(1);
        for index in triangles {
            let corners = mesh.triangles()[index as usize];
            let [a, b, c] = corners.map(|v| mesh.positions()[v as usize]);
            worst.add(index, TriangleQuality::in_space(a, b, c));
        }
        let triangle = worst.first().map(|worst| worst.triangle);
        Self {
            vertex: vertex.map(|index| index as u32),
            triangle: triangle.map(|index| (index, mesh.triangles()[index as usize])),
        }
    }
}

impl Demands {
    /// The demands that a mesh of this maximum degree and minimum angle, in degrees, breaks, in words. Its worst
    /// positions are searched only then; the preset is ignored.
    #[must_use]
    pub fn unmet(
        &self,
        max_degree: u32,
        min_angle: f64,
        worst: impl FnOnce() -> WorstPlaces,
    ) -> Vec<String> {
        let degree = self.max_degree.filter(|&limit| max_degree > limit);
        let angle = self.target_angle.filter(|&target| min_angle < target);
        if degree.is_none() && angle.is_none() {
            return Vec::new();
        }
        let WorstPlaces { vertex, triangle } = worst();
        let degree = degree.map(|limit| {
            let vertex = vertex.map_or("a vertex".to_owned(), |vertex| format!("vertex {vertex}"));
            format!("{vertex} has {max_degree} edges, more than the maximum degree of {limit}")
        });
        let angle = angle.map(|target| {
            let triangle = triangle.map_or("a triangle".to_owned(), |(index, [a, b, c])| {
                format!("triangle {index} (vertices {a}, {b}, {c})")
            });
            let angle = degrees_below(min_angle, target);
            format!("{triangle} has an angle of {angle}, below the target angle of {target}°")
        });
        degree.into_iter().chain(angle).collect()
    }

    /// The demands that a mesh of this minimum angle, in degrees, breaks, including the rules of the preset.
    #[must_use]
    pub fn unmet_by(&self, mesh: &TriMesh, min_angle: f64) -> Vec<String> {
        let mut unmet = self.unmet(mesh.max_degree(), min_angle, || WorstPlaces::of(mesh));
        unmet.extend(self.preset.and_then(|preset| preset.broken_by(mesh)));
        unmet
    }
}

/// The angle as [`steady_angle`] writes it, with all digits where rounding would hide that the angle is below `limit`.
fn degrees_below(angle: f64, limit: f64) -> String {
    let rounded = steady_angle(angle);
    let hides = rounded.trim_end_matches('°').parse().is_ok_and(|shown: f64| shown >= limit);
    if hides { format!("{angle}°") } else { rounded }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_angle_that_fails_does_not_read_as_one_that_passes() {
        for (angle, limit, shown) in [
            (0.47490800682170436, 10.0, "0.475°"),
            (29.9999, 30.0, "29.9999°"),
            (29.99, 30.0, "29.990°"),
            (0.0012, 0.002, "0.0012°"),
            (0.00195, 0.002, "0.00195°"),
        ] {
            assert_eq!(degrees_below(angle, limit), shown);
        }
    }

    #[test]
    fn a_mesh_without_triangles_has_no_triangle_to_name() {
        let demands = Demands { target_angle: Some(1.0), ..Demands::default() };
        assert_eq!(
            demands.unmet(0, 0.0, WorstPlaces::default),
            ["a triangle has an angle of 0°, below the target angle of 1°"]
        );
    }
}
