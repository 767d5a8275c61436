//! Positions as glTF stores them: 32-bit floats, near the origin.

use crate::export::{ExportError, Plane};
use crate::{Bounds, Placement};
use glam::{DVec2, Vec3};
use mindeg_mesh::parallel::{first_of_blocks, try_blocks};
use std::ops::Range;

/// A coordinate range is far from the origin when it begins this many of its own lengths
/// away, or more: then 32-bit floats near the origin keep at least three bits more of it.
const FAR: f64 = 8.0;

/// How points become positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Positions {
    /// What is taken off every point: a point of 32-bit floats, so that a reader that adds
    /// it again adds what was taken off.
    offset: DVec2,
    plane: Plane,
}

/// The least and the greatest of each coordinate, of positions as stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Extent {
    pub(super) min: Vec3,
    pub(super) max: Vec3,
}

impl Positions {
    /// How points are stored, and what range that gives.
    ///
    /// Refuses what does not pass [`survey`](Self::survey), when the middle of the box as origin
    /// does not help either, and names the first of it.
    pub(super) fn new(placement: &Placement, plane: Plane) -> Result<(Self, Extent), ExportError> {
        let bounds = placement.bounds();
        let near = Self { offset: offset(bounds, FAR), plane };
        let centered = Self { offset: offset(bounds, f64::NEG_INFINITY), plane };
        for positions in [near, centered] {
            if let Some(extent) = positions.survey(placement) {
                return Ok((positions, extent));
            }
        }
        let refusal = first_of_blocks(placement.vertex_count(), |range| {
            near.survey_block(placement, range).err()
        });
        Err(refusal.expect("the survey met something to refuse"))
    }

    /// The position of a point, relative to the [`translation`](Self::translation).
    pub(super) fn of(&self, point: DVec2) -> Vec3 {
        // Rounding can make a zero negative; adding zero undoes it.
        self.plane.place(point - self.offset).as_vec3() + Vec3::ZERO
    }

    /// What moves the positions back to the points; nothing where they are near the origin.
    pub(super) fn translation(&self) -> Option<[f32; 3]> {
        let moved = self.offset != DVec2::ZERO;
        moved.then(|| self.plane.place(self.offset).as_vec3().to_array())
    }

    /// Looks at every position once, in O(n) time, or until there is something to refuse.
    ///
    /// That is a coordinate beyond the range of 32-bit floats, or a vertex in the same
    /// place as one of the two before it round the boundary. Two steps back suffice for
    /// uniform spacing: where neighbors differ, points meet across a sharp corner at most,
    /// and the first pair there is the closest.
    fn survey(&self, placement: &Placement) -> Option<Extent> {
        let of_block = |range| self.survey_block(placement, range);
        let extents = try_blocks(placement.vertex_count(), of_block).ok()?;
        extents.into_iter().reduce(|a, b| Extent { min: a.min.min(b.min), max: a.max.max(b.max) })
    }

    fn survey_block(
        &self,
        placement: &Placement,
        range: Range<u32>,
    ) -> Result<Extent, ExportError> {
        let n = placement.vertex_count();
        let back =
            |steps: u32| if range.start < steps { range.start + n } else { range.start } - steps;
        let mut before = [2, 1].map(|steps| (back(steps), self.of(placement.point(back(steps)))));
        let mut extent = Extent { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY };
        for (vertex, point) in range.clone().zip(placement.points_of(range)) {
            let position = self.of(point);
            if !position.is_finite() {
                return Err(ExportError::OutOfRange { vertex, point });
            }
            if let Some((other, _)) = before.iter().find(|(_, other)| *other == position) {
                let vertices = [*other, vertex];
                return Err(ExportError::Coincident { vertices, point });
            }
            extent.min = extent.min.min(position);
            extent.max = extent.max.max(position);
            before = [before[1], (vertex, position)];
        }
        Ok(extent)
    }
}

/// The middle of the box in each coordinate in which the box begins `far` of its own lengths
/// from the origin, or more, and 0 in the others; rounded to a 32-bit float.
fn offset(bounds: Bounds, far: f64) -> DVec2 {
    let (size, center) = (bounds.size(), bounds.center());
    let distance = bounds.min.max(-bounds.max);
    let offset = DVec2::select(distance.cmpge(far * size), center, DVec2::ZERO);
    offset.as_vec2().as_dvec2()
}
