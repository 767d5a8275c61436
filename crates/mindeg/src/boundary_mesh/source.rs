//! The mesh as writers and measures see it: positions and triangles by range.

use std::borrow::Cow;

use glam::DVec3;
use mindeg_domain::{Domain, PeriodicSide};
use mindeg_mesh::{Bounds, Group, Line, LineKind, NamedVertex, PeriodicLine, Positions, Triangles};

use super::BoundaryMesh;

impl Positions for BoundaryMesh {
    fn vertex_count(&self) -> u32 {
        self.vertex_count()
    }

    fn fill_positions(&self, first: u32, out: &mut [DVec3]) {
        let (rings, inside, points) = self.divided(first, out);
        if !rings.is_empty() {
            self.placement().fill_positions(first, rings);
        }
        inside.iter_mut().zip(points).for_each(|(out, point)| *out = point.extend(0.0));
    }

    fn bounds(&self) -> Bounds<DVec3> {
        Positions::bounds(self.placement())
    }

    fn is_ring(&self) -> bool {
        self.rings().ring_count() == 1 && self.domain().inner_points().is_empty()
    }
}

/// The lines are the domain's sides, then the lines inside.
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
        let (mut lines, before) = (lines(self.domain()), self.rings().vertex_count());
        lines.extend(self.domain().inner_lines().into_iter().map(|(line, _)| {
            let segments = line.segments.start + before..line.segments.end + before;
            Line { segments, ..line }
        }));
        Cow::Owned(lines)
    }

    fn line_kind(&self, line: usize) -> Option<LineKind> {
        let sides = self.domain().sides();
        match line.checked_sub(sides.len()) {
            None => sides[line].kind,
            Some(inner) => self.domain().inner_lines().get(inner)?.1,
        }
    }

    fn named_vertices(&self) -> Cow<'_, [NamedVertex]> {
        Cow::Owned(self.domain().named_vertices())
    }

    fn periodic_lines(&self) -> Cow<'_, [PeriodicLine]> {
        Cow::Owned(periodic_lines(self.domain()))
    }

    fn groups(&self) -> &[Group] {
        &self.groups
    }

    fn fill_segments(&self, first: u32, out: &mut [[u32; 2]]) {
        let (rings, inner) = (self.rings(), self.domain().inner_segments());
        let count = rings.vertex_count();
        let mut ring = 0..0;
        for (start, segment) in (first..).zip(out) {
            if let Some(inside) = start.checked_sub(count) {
                *segment = inner[inside as usize];
                continue;
            }
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

/// The periodic sides of a domain as lines of a mesh whose first lines are the sides. A side that is several in a row has
/// the first of them for all.
pub(crate) fn periodic_lines(domain: &Domain) -> Vec<PeriodicLine> {
    let sides = domain.periodic().map_or(&[][..], |periodic| periodic.sides());
    let line = |side: &PeriodicSide| {
        let row = |[a, b, c]: [f64; 3]| [a, b, 0.0, c];
        let [x, y] = side.matrix.map(row);
        PeriodicLine {
            line: side.side as u32,
            of: side.of[0] as u32,
            matrix: [x, y, [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]],
            vertices: side.vertices.clone(),
        }
    };
    sides.iter().map(line).collect()
}
