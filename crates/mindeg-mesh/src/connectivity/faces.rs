//! The faces of a mesh: its polygons, or its triangles if it has no other polygons.

use std::borrow::Cow;

use crate::polygons::Polygons;

/// The corners of each face.
///
/// A face that encloses nothing has no corners: a triangle that names a vertex twice, or a polygon
/// that runs along its edges there and back.
pub(crate) enum Faces<'a> {
    Triangles(Cow<'a, [[u32; 3]]>),
    Polygons {
        /// The index of each polygon's first corner, then the number of corners.
        starts: Vec<usize>,
        corners: Vec<u32>,
    },
}

impl<'a> Faces<'a> {
    /// The faces of a mesh. `merged` gives for each vertex the vertex that replaces it, if any are
    /// merged. O(n).
    pub(crate) fn new(
        triangles: &'a [[u32; 3]],
        polygons: Option<&Polygons>,
        merged: Option<&[u32]>,
    ) -> Self {
        let vertex = |vertex: u32| merged.map_or(vertex, |merged| merged[vertex as usize]);
        let Some(polygons) = polygons else {
            return Self::Triangles(match merged {
                None => Cow::Borrowed(triangles),
                Some(_) => triangles.iter().map(|corners| corners.map(vertex)).collect(),
            });
        };
        let mut starts = vec![0];
        let mut corners = Vec::with_capacity(polygons.corners.len());
        let mut polygon = Vec::new();
        for original in polygons.iter() {
            polygon.clear();
            polygon.extend(original.iter().map(|&corner| vertex(corner)));
            corners.extend_from_slice(without_spikes(&mut polygon));
            starts.push(corners.len());
        }
        Self::Polygons { starts, corners }
    }

    /// The number of faces, including faces without corners.
    pub(crate) fn count(&self) -> usize {
        match self {
            Self::Triangles(triangles) => triangles.len(),
            Self::Polygons { starts, .. } => starts.len() - 1,
        }
    }

    /// The corners of a face in order.
    pub(crate) fn corners(&self, face: u32) -> &[u32] {
        let face = face as usize;
        match self {
            Self::Triangles(triangles) => match &triangles[face] {
                [a, b, c] if a == b || b == c || c == a => &[],
                corners => corners,
            },
            Self::Polygons { starts, corners } => &corners[starts[face]..starts[face + 1]],
        }
    }

    /// The corners of all faces.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (u32, &[u32])> {
        // The faces are no more than the triangles, which have indices of 32 bits.
        (0..self.count() as u32).map(|face| (face, self.corners(face)))
    }
}

/// A polygon without repeated consecutive corners and without spikes, where it runs along an edge
/// and straight back. Empty if fewer than three corners remain. O(k).
fn without_spikes(polygon: &mut [u32]) -> &[u32] {
    let mut kept = 0;
    for i in 0..polygon.len() {
        let corner = polygon[i];
        if kept > 1 && polygon[kept - 2] == corner {
            kept -= 1;
        } else if kept == 0 || polygon[kept - 1] != corner {
            polygon[kept] = corner;
            kept += 1;
        }
    }
    // The same where the last corners meet the first.
    let mut rest = &polygon[..kept];
    loop {
        rest = match rest {
            [first, middle @ .., last] if first == last => &rest[..=middle.len()],
            [first, middle @ .., tip_before, _] if first == tip_before => &rest[..=middle.len()],
            [_, second, .., last] if second == last => &rest[1..rest.len() - 1],
            _ if rest.len() < 3 => return &[],
            _ => return rest,
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_runs_there_and_back_is_left_out() {
        for (polygon, expected) in [
            (&[0, 1, 2, 3][..], &[0, 1, 2, 3][..]),
            (&[0, 0, 1, 2, 2, 3, 0], &[0, 1, 2, 3]),
            (&[0, 1, 5, 1, 2, 3], &[0, 1, 2, 3]),
            (&[5, 0, 1, 2, 3, 0], &[0, 1, 2, 3]),
            (&[0, 1, 2, 3, 0, 5], &[0, 1, 2, 3]),
            (&[0, 6, 5, 6, 0, 1, 2], &[0, 1, 2]),
            (&[6, 0, 1, 2, 0, 6, 5], &[0, 1, 2]),
            (&[0, 1, 0, 2], &[]),
            (&[0, 1, 2, 1], &[]),
            (&[0, 1, 2, 3, 2, 1], &[]),
            (&[0, 0, 0], &[]),
            (&[0, 1], &[]),
            (&[], &[]),
            // A square with a square hole, and the bridge between them: all corners stay.
            (&[0, 1, 2, 3, 0, 4, 7, 6, 5, 4], &[0, 1, 2, 3, 0, 4, 7, 6, 5, 4]),
        ] {
            assert_eq!(without_spikes(&mut polygon.to_vec()), expected, "{polygon:?}");
        }
    }
}
