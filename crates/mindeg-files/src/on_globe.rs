//! A mesh with the degrees that its plane was projected from.

use glam::DVec3;
use mindeg_domain::Projection;
use mindeg_mesh::{Bounds, Group, Line, LineKind, Mesh, NamedVertex, Positions, Triangles};
use std::borrow::Cow;

/// A mesh in degrees of longitude and latitude, to nine decimals: a tenth of a millimetre.
pub(crate) struct OnGlobe<'a> {
    pub(crate) mesh: &'a dyn Mesh,
    pub(crate) projection: Projection,
}

/// The decimals of degrees.
const DECIMALS: f64 = 1e9;
/// Vertices looked at at a time.
const BLOCK: u32 = 1 << 12;

impl Positions for OnGlobe<'_> {
    fn vertex_count(&self) -> u32 {
        self.mesh.vertex_count()
    }

    fn fill_positions(&self, first: u32, out: &mut [DVec3]) {
        self.mesh.fill_positions(first, out);
        for point in out {
            let degrees = self.projection.to_degrees(point.truncate());
            let rounded = (degrees * DECIMALS).map(libm::round) / DECIMALS;
            *point = rounded.extend(point.z);
        }
    }

    fn bounds(&self) -> Bounds<DVec3> {
        let mut bounds = Bounds { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };
        let mut points = Vec::new();
        for first in (0..self.vertex_count()).step_by(BLOCK as usize) {
            points.resize((self.vertex_count() - first).min(BLOCK) as usize, DVec3::ZERO);
            self.fill_positions(first, &mut points);
            for point in &points {
                bounds.min = bounds.min.min(*point);
                bounds.max = bounds.max.max(*point);
            }
        }
        bounds
    }

    fn fill_depths(&self, first: u32, out: &mut [f64]) {
        self.mesh.fill_depths(first, out);
    }

    fn is_ring(&self) -> bool {
        self.mesh.is_ring()
    }
}

impl Triangles for OnGlobe<'_> {
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
        self.mesh.made_by()
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

    fn fill_segments(&self, first: u32, out: &mut [[u32; 2]]) {
        self.mesh.fill_segments(first, out);
    }
}
