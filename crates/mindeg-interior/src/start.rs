//! The first mesh: points packed, triangulated and linked.

use crate::array_mesh::{ArrayMesh, Kind, NONE, Vertex};
use crate::breaklines::Breaklines;
use crate::edge_tree::{EdgeTree, Item};
use crate::goal::Goal;
use crate::options::{InteriorError, rounding};
use crate::order::along_hilbert_curve;
use crate::packing::Ground;
use crate::size::SizeField;
use crate::stage::Stage;
use crate::star::Stars;
use glam::DVec2;
use mindeg_mesh::planar::{PlanarBoundary, orientation};
use std::ops::Range;

/// The data that all seeds begin with.
pub(crate) struct Start<'a> {
    pub(crate) outline: &'a PlanarBoundary,
    pub(crate) stars: &'a Stars,
    pub(crate) goals: &'a [Goal],
    pub(crate) breaklines: &'a Breaklines,
    pub(crate) field: &'a SizeField,
    /// About how many points there will be; infinite where nobody asks for the share that is done.
    pub(crate) about: f64,
}

/// Packed points and what stays, with their triangles, before these are linked.
pub(crate) struct Packing {
    pub(crate) vertices: Vec<Vertex>,
    pub(crate) triangles: Vec<[u32; 3]>,
}

impl Start<'_> {
    /// The mesh of a packing.
    pub(crate) fn linked(&self, packing: Packing) -> Result<ArrayMesh, InteriorError> {
        let Packing { vertices, triangles } = packing;
        ArrayMesh::new(vertices, &triangles, self.goals.to_vec(), &self.breaklines.edges)
            .map_err(InteriorError::NotFilled)
    }

    /// Packs points and triangulates them.
    pub(crate) fn packing(
        &self,
        spacing: f64,
        floor: f64,
        max_points: usize,
        spokes: Option<(u32, u32)>,
        stage: &mut Stage<'_>,
    ) -> Result<Packing, InteriorError> {
        let pieces = self.breaklines.pieces(self.outline);
        let items = pieces.iter().enumerate().map(|(id, piece)| Item {
            id: id as u32,
            from: piece.from,
            to: piece.to,
            size: piece.from.distance(piece.to),
            reach: 0.0,
        });
        let bounds = self.outline.bounds();
        let ground = Ground {
            outline: self.outline,
            stars: self.stars,
            goals: self.goals,
            field: self.field,
            lines: self.breaklines,
            tree_of_pieces: EdgeTree::of_items(items.collect()),
            pieces: &pieces,
            about: self.about,
            spacing,
            fan_angle: floor + 3.0,
            spokes,
            rounding: rounding(self.outline),
            max_points,
        };
        let (packed, sizes) = ground.pack(stage)?;
        let given = self.outline.points().len() + self.breaklines.points.len();
        let mut vertices = Vec::with_capacity(given + packed.len());
        let vertex =
            |at, size, kind, goal| Vertex { at, size, anchor: NONE, goal, triangles: 0, kind };
        for (v, at) in (0..).zip(self.outline.points()) {
            let before = self.outline.length(self.outline.previous(v));
            let size = (self.outline.length(v) + before) / 2.0;
            vertices.push(vertex(*at, size, Kind::Boundary, v));
        }
        for (v, at) in (vertices.len() as u32..).zip(&self.breaklines.points) {
            vertices.push(vertex(*at, self.field.at(*at), Kind::Fixed, v));
        }
        let extent = bounds.size().max_element();
        for index in along_hilbert_curve(&packed) {
            let (at, size) = (clean(packed[index as usize], extent), sizes[index as usize]);
            vertices.push(vertex(at, size, Kind::Free, NONE));
        }
        let points: Vec<DVec2> = vertices.iter().map(|v| v.at).collect();
        let inner = &points[self.outline.points().len()..];
        let edges = &self.breaklines.edges;
        let mut triangles = stage.through(0.4, |progress| {
            mindeg_delaunay::triangles(self.outline, inner, edges, progress)
        })?;
        // Near each other in the plane, near each other in memory.
        triangles.sort_unstable_by_key(|t| (t[0].max(t[1]).max(t[2]), *t));
        let boundary = self.outline.points().len();
        // By Euler's formula, for each connected part.
        let parts = self.outline.rings().filter(|ring| self.is_outer(ring.clone())).count();
        let expected =
            (2 * points.len() + 2 * self.outline.ring_count()).saturating_sub(boundary + 4 * parts);
        if triangles.len() != expected {
            return Err(InteriorError::NotFilled(format!(
                "found {} triangles inside, expected {expected}",
                triangles.len()
            )));
        }
        let bad = triangles.iter().find(|t| {
            let [a, b, c] = t.map(|v| points[v as usize]);
            orientation(a, b, c) <= 0.0
        });
        if let Some([a, b, c]) = bad {
            return Err(InteriorError::NotFilled(format!(
                "triangle {a}-{b}-{c} is not counter-clockwise"
            )));
        }
        Ok(Packing { vertices, triangles })
    }

    /// Whether a ring runs counter-clockwise.
    fn is_outer(&self, ring: Range<u32>) -> bool {
        let at = |v: u32| self.outline.point(v) - self.outline.point(ring.start);
        let doubled = |v: u32| at(v).perp_dot(at(self.outline.next(v)));
        ring.clone().map(doubled).sum::<f64>() > 0.0
    }
}

/// The same point without coordinates that are nothing beside the domain: exact predicates have a least number.
fn clean(point: DVec2, extent: f64) -> DVec2 {
    DVec2::select(point.abs().cmplt(DVec2::splat(1e-25 * extent)), DVec2::ZERO, point)
}
