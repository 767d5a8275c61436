//! Positions as glTF stores them: 32-bit floats, near the origin.

use crate::{MeshPlane, WriteError};
use glam::{DVec3, Vec3};
use mindeg_mesh::parallel::{first_of_blocks, sort_all, try_blocks};
use mindeg_mesh::{Bounds, Positions, filled};
use std::ops::Range;

/// A coordinate range is far from the origin when it begins this many of its own lengths
/// away, or more: then 32-bit floats near the origin keep at least three bits more of it.
const FAR: f64 = 8.0;

/// How the positions of a mesh are stored in 32 bits, and their range; [`Stored::new`] finds it
/// before the mesh has triangles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stored {
    /// The offset taken off every point: a point of 32-bit floats, so that a reader that adds
    /// it again adds what was taken off.
    offset: DVec3,
    plane: MeshPlane,
    /// The range of the stored positions, which 32-bit floats hold exactly.
    pub(super) range: Bounds<DVec3>,
}

impl Stored {
    /// Looks at every position. O(n) time, shared by all threads; next to no memory.
    ///
    /// # Errors
    ///
    /// A coordinate beyond the range of 32-bit floats, and two vertices round a boundary that become one
    /// point, if the middle of the box as origin does not help either. The first vertex is named.
    pub fn new(positions: &dyn Positions, plane: MeshPlane) -> Result<Self, WriteError> {
        let bounds = positions.bounds();
        let no_range = Bounds { min: DVec3::ZERO, max: DVec3::ZERO };
        let near = Self { offset: offset(bounds, FAR), plane, range: no_range };
        let centered = Self { offset: offset(bounds, f64::NEG_INFINITY), ..near };
        let count = positions.vertex_count();
        for stored in [near, centered] {
            let of_block = |range| stored.survey(positions, range);
            if let Ok(ranges) = try_blocks(count, of_block) {
                let range = ranges.into_iter().flatten().reduce(Bounds::union);
                return Ok(Self { range: range.unwrap_or(no_range), ..stored });
            }
        }
        let refusal = first_of_blocks(count, |range| near.survey(positions, range).err());
        Err(refusal.expect("the survey met something to refuse"))
    }

    /// Looks at every position where it is, for a format that has no translation. O(n) time and next
    /// to no memory; for a boundary far from the origin O(n log n) and O(n), since there 32-bit floats
    /// may bring any two points together. Shared by all threads.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub(crate) fn in_place(
        positions: &dyn Positions,
        plane: MeshPlane,
    ) -> Result<Self, WriteError> {
        let range = Bounds { min: DVec3::ZERO, max: DVec3::ZERO };
        let stored = Self { offset: DVec3::ZERO, plane, range };
        let count = positions.vertex_count();
        match first_of_blocks(count, |range| stored.survey(positions, range).err()) {
            Some(refusal) => Err(refusal),
            None if positions.is_ring() && offset(positions.bounds(), FAR) != DVec3::ZERO => {
                stored.unless_any_coincide(positions)
            }
            None => Ok(stored),
        }
    }

    /// Refuses any two vertices in the same place.
    fn unless_any_coincide(self, positions: &dyn Positions) -> Result<Self, WriteError> {
        let vertices = 0..positions.vertex_count();
        let points = filled(vertices.clone(), DVec3::ZERO, |first, out| {
            positions.fill_positions(first, out);
        });
        let bits = |point: &DVec3| self.of(*point).to_array().map(f32::to_bits);
        let mut sorted: Vec<_> = points.iter().map(bits).zip(vertices).collect();
        sort_all(&mut sorted);
        let pairs = sorted.windows(2).filter(|pair| pair[0].0 == pair[1].0);
        let first = pairs.map(|pair| [pair[0].1, pair[1].1]).min_by_key(|&[_, second]| second);
        match first {
            None => Ok(self),
            Some(vertices) => {
                let point = points[vertices[1] as usize];
                Err(WriteError::coincident(vertices, point))
            }
        }
    }

    /// The stored position of a point, relative to the [`translation`](Self::translation).
    pub(super) fn of(&self, point: DVec3) -> Vec3 {
        // Rounding can make a zero negative; adding zero undoes it.
        self.plane.place(point - self.offset).as_vec3() + Vec3::ZERO
    }

    /// The translation from stored positions back to the points; `None` where they are near the origin.
    pub(super) fn translation(&self) -> Option<[f32; 3]> {
        let moved = self.offset != DVec3::ZERO;
        moved.then(|| self.plane.place(self.offset).as_vec3().to_array())
    }

    /// The range of the positions of some vertices, or the reason to refuse them.
    ///
    /// That is a coordinate beyond the range of 32-bit floats, or a vertex in the same
    /// place as one of the two before it round the boundary. Two steps back suffice for
    /// uniform spacing: where neighbors differ, points meet across a sharp corner at most,
    /// and the first pair there is the closest.
    fn survey(
        &self,
        positions: &dyn Positions,
        vertices: Range<u32>,
    ) -> Result<Option<Bounds<DVec3>>, WriteError> {
        let n = positions.vertex_count();
        let mut before = [None; 2];
        if positions.is_ring() {
            let start = vertices.start;
            before = [2, 1].map(|steps| {
                let vertex = if start < steps { start + n } else { start } - steps;
                let mut point = [DVec3::ZERO];
                positions.fill_positions(vertex, &mut point);
                Some((vertex, self.of(point[0])))
            });
        }
        let mut range: Option<Bounds<DVec3>> = None;
        let points = filled(vertices.clone(), DVec3::ZERO, |first, out| {
            positions.fill_positions(first, out);
        });
        for (vertex, point) in vertices.zip(points) {
            let stored = self.of(point);
            if !stored.is_finite() {
                return Err(WriteError::out_of_range(vertex, point));
            }
            if before[1].is_some() {
                let coincident = before.into_iter().flatten().find(|(_, other)| *other == stored);
                if let Some((other, _)) = coincident {
                    return Err(WriteError::coincident([other, vertex], point));
                }
                before = [before[1], Some((vertex, stored))];
            }
            let stored = stored.as_dvec3();
            let here = Bounds { min: stored, max: stored };
            range = Some(range.map_or(here, |range| range.union(here)));
        }
        Ok(range)
    }
}

/// The middle of the box in each coordinate in which the box begins `far` of its own lengths
/// from the origin, or more, and 0 in the others; rounded to a 32-bit float.
fn offset(bounds: Bounds<DVec3>, far: f64) -> DVec3 {
    let (size, center) = (bounds.size(), bounds.center());
    let distance = bounds.min.max(-bounds.max);
    let offset = DVec3::select(distance.cmpge(far * size), center, DVec3::ZERO);
    offset.as_vec3().as_dvec3()
}
