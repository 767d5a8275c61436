//! A mesh as a file gets it.

use std::borrow::Cow;

use glam::DVec3;

use crate::bounds::Bounds;
use crate::mesh::{Group, Line, LineKind, Mesh, NamedVertex, PeriodicLine, Positions, Triangles};

/// Vertices looked at at a time.
const BLOCK: u32 = 1 << 12;

/// A mesh as a file gets it: it may say how it was [made](Triangles::made_by), and its vertices may be told in
/// degrees. All else is the mesh's own.
///
/// # Example
///
/// ```
/// use glam::DVec3;
/// use mindeg_mesh::{Mesh, Positions, Triangles, Written};
///
/// fn degrees_across(mesh: &dyn Mesh) -> f64 {
///     let degrees = |point: DVec3| point / 60.0;
///     let written = Written { mesh, made_by: Some("mindeg mesh sea.json"), place: Some(&degrees) };
///     assert_eq!(written.made_by(), Some("mindeg mesh sea.json"));
///     assert!(written.is_in_degrees());
///     written.bounds().size().x
/// }
/// ```
#[derive(Clone, Copy)]
pub struct Written<'a> {
    /// The mesh.
    pub mesh: &'a dyn Mesh,
    /// How it was made, where that is not what the mesh says itself.
    pub made_by: Option<&'a str>,
    /// The longitude and latitude in degrees of a vertex that the mesh has at a point of a plane. Bounds take O(n) with it.
    pub place: Option<&'a (dyn Fn(DVec3) -> DVec3 + Sync)>,
}

impl Positions for Written<'_> {
    fn vertex_count(&self) -> u32 {
        self.mesh.vertex_count()
    }

    fn fill_positions(&self, first: u32, out: &mut [DVec3]) {
        self.mesh.fill_positions(first, out);
        if let Some(place) = self.place {
            for point in out {
                *point = place(*point);
            }
        }
    }

    fn bounds(&self) -> Bounds<DVec3> {
        if self.place.is_none() {
            return self.mesh.bounds();
        }
        let mut points = Vec::new();
        let blocks = (0..self.vertex_count()).step_by(BLOCK as usize).filter_map(|first| {
            points.resize((self.vertex_count() - first).min(BLOCK) as usize, DVec3::ZERO);
            self.fill_positions(first, &mut points);
            Bounds::of_space(points.iter().copied())
        });
        blocks.reduce(Bounds::union).unwrap_or_else(|| self.mesh.bounds())
    }

    fn is_in_degrees(&self) -> bool {
        self.place.is_some() || self.mesh.is_in_degrees()
    }

    fn fill_depths(&self, first: u32, out: &mut [f64]) {
        self.mesh.fill_depths(first, out);
    }

    fn is_ring(&self) -> bool {
        self.mesh.is_ring()
    }
}

impl Triangles for Written<'_> {
    fn triangle_count(&self) -> u32 {
        self.mesh.triangle_count()
    }

    fn fill_triangles(&self, first: u32, out: &mut [[u32; 3]]) {
        self.mesh.fill_triangles(first, out);
    }

    fn fill_degrees(&self, first: u32, out: &mut [u32]) {
        self.mesh.fill_degrees(first, out);
    }

    fn max_degree(&self) -> u32 {
        self.mesh.max_degree()
    }

    fn normal(&self) -> Option<DVec3> {
        self.mesh.normal()
    }

    fn name(&self) -> Option<&str> {
        self.mesh.name()
    }

    fn made_by(&self) -> Option<&str> {
        self.made_by.or_else(|| self.mesh.made_by())
    }

    fn groups(&self) -> &[Group] {
        self.mesh.groups()
    }

    fn lines(&self) -> Cow<'_, [Line]> {
        self.mesh.lines()
    }

    fn line_kind(&self, line: usize) -> Option<LineKind> {
        self.mesh.line_kind(line)
    }

    fn named_vertices(&self) -> Cow<'_, [NamedVertex]> {
        self.mesh.named_vertices()
    }

    fn periodic_lines(&self) -> Cow<'_, [PeriodicLine]> {
        self.mesh.periodic_lines()
    }

    fn fill_segments(&self, first: u32, out: &mut [[u32; 2]]) {
        self.mesh.fill_segments(first, out);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TriMesh;

    #[test]
    fn only_what_is_given_differs() {
        let corners = [[1.0, 2.0, 3.0], [2.0, 2.0, 3.0], [1.0, 4.0, 3.0]].map(DVec3::from);
        let mesh = TriMesh::new(corners.to_vec(), vec![[0, 1, 2]]).unwrap();
        let same = Written { mesh: &mesh, made_by: None, place: None };
        assert_eq!((same.bounds(), same.made_by()), (mesh.bounds(), None));

        let mirrored = |point: DVec3| -point;
        let written = Written { mesh: &same, made_by: Some("a command"), place: Some(&mirrored) };
        let mut points = [DVec3::ZERO; 2];
        written.fill_positions(1, &mut points);
        assert_eq!(points, [-corners[1], -corners[2]]);
        let bounds = Bounds::of_space(corners.map(|point| -point)).unwrap();
        assert_eq!((written.bounds(), written.made_by()), (bounds, Some("a command")));
        assert_eq!(written.triangle_count(), 1);
    }
}
