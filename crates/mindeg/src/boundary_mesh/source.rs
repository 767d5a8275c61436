//! The mesh as writers and measures see it: positions and triangles by range.

use std::borrow::Cow;

use glam::DVec3;
use mindeg_domain::Domain;
use mindeg_mesh::{Bounds, Line, LineKind, Positions, Triangles};

use super::BoundaryMesh;

impl Positions for BoundaryMesh {
    fn vertex_count(&self) -> u32 {
        self.vertex_count()
    }

    fn fill_positions(&self, first: u32, out: &mut [DVec3]) {
        self.placement().fill_positions(first, out);
    }

    fn bounds(&self) -> Bounds<DVec3> {
        Positions::bounds(self.placement())
    }

    fn is_ring(&self) -> bool {
        self.rings().ring_count() == 1
    }
}

/// The lines are the domain's sides.
impl Triangles for BoundaryMesh {
    fn triangle_count(&self) -> u32 {
        self.triangle_count()
    }

    fn fill_triangles(&self, first: u32, out: &mut [[u32; 3]]) {
        self.triangulation.fill(first, out);
    }

    fn fill_degrees(&self, first: u32, out: &mut [u32]) {
        (first..).zip(out).for_each(|(vertex, degree)| *degree = self.degree(vertex));
    }

    fn max_degree(&self) -> u32 {
        self.max_degree()
    }

    fn normal(&self) -> Option<DVec3> {
        Some(DVec3::Z)
    }

    fn name(&self) -> Option<&str> {
        self.domain().name()
    }

    fn lines(&self) -> Cow<'_, [Line]> {
        Cow::Owned(lines(self.domain()))
    }

    fn line_kind(&self, line: usize) -> Option<LineKind> {
        self.domain().sides().get(line)?.kind
    }

    fn fill_segments(&self, first: u32, out: &mut [[u32; 2]]) {
        let (count, rings) = (self.vertex_count(), self.rings());
        let mut ring = 0..0;
        for (start, segment) in (first..).zip(out) {
            assert!(start < count, "the boundary has {count} edges");
            if !ring.contains(&start) {
                ring = rings.ring(rings.ring_of(start));
            }
            *segment = [start, if start + 1 == ring.end { ring.start } else { start + 1 }];
        }
    }
}

/// The sides of a domain as lines of a mesh.
pub(crate) fn lines(domain: &Domain) -> Vec<Line> {
    let rings = domain.rings();
    let line = |side| Line {
        name: domain.side_name(side),
        segments: rings.corner(side)..rings.corner(side) + rings.intervals(side),
        is_straight: domain.is_straight(side),
    };
    (0..rings.side_count()).map(line).collect()
}
