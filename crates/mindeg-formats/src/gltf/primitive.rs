//! A primitive: positions, and how they are joined to triangles, lines or points.

use super::accessor::Arrays;
use super::schema::{Primitive, Whole, named};
use crate::ReadError;
use std::ops::Range;

/// The shapes of a primitive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mode {
    Points,
    Lines(Lines),
    Triangles(Layout),
}

/// How lines follow from indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Lines {
    List,
    Strip,
    Loop,
}

/// How triangles follow from indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Layout {
    List,
    Strip,
    Fan,
}

/// A primitive whose parts are there.
pub(super) struct Part {
    /// Where it is in the document.
    place: String,
    pub(super) mode: Mode,
    /// The accessor of the positions.
    pub(super) positions: usize,
    /// The accessor of the indices.
    indices: Option<usize>,
    /// The index of the material.
    pub(super) material: Option<usize>,
}

impl Part {
    pub(super) fn new(
        primitive: &Primitive,
        place: String,
        arrays: Arrays<'_>,
    ) -> Result<Self, ReadError> {
        let mode = match primitive.mode.unwrap_or(Whole(4)).0 {
            0 => Mode::Points,
            1 => Mode::Lines(Lines::List),
            2 => Mode::Lines(Lines::Loop),
            3 => Mode::Lines(Lines::Strip),
            4 => Mode::Triangles(Layout::List),
            5 => Mode::Triangles(Layout::Strip),
            6 => Mode::Triangles(Layout::Fan),
            mode => {
                let problem = format!("is {mode}; modes are 0 to 6");
                return Err(ReadError::place(format!("{place}.mode"), problem));
            }
        };
        let list = ("accessors", &arrays.document.accessors[..]);
        let Some(positions) = primitive.attributes.position else {
            return Err(ReadError::place(place, "has no positions"));
        };
        let positions = named(list, positions, || format!("{place}.attributes.POSITION"))?;
        let indices = primitive.indices;
        let indices = indices.map(|indices| named(list, indices, || format!("{place}.indices")));
        let indices = indices.transpose()?;
        let is_empty = [Some(positions), indices]
            .into_iter()
            .flatten()
            .any(|(_, accessor)| accessor.buffer_view.is_none() && accessor.sparse.is_none());
        if primitive.extensions.draco.is_some() && is_empty {
            let problem = "is compressed by Draco (KHR_draco_mesh_compression), which is not read; \
                           export the file without it";
            return Err(ReadError::place(place, problem));
        }
        let list = ("materials", &arrays.document.materials[..]);
        let material = primitive.material;
        let material = material.map(|index| named(list, index, || format!("{place}.material")));
        let material = material.transpose()?.map(|(index, _)| index);
        let indices = indices.map(|(index, _)| index);
        Ok(Self { mode, positions: positions.0, indices, material, place })
    }

    /// The accessor that counts its corners: of its indices, or without them of its positions.
    pub(super) fn corner_accessor(&self) -> usize {
        self.indices.unwrap_or(self.positions)
    }

    /// How many indices it has.
    pub(super) fn count(&self, arrays: Arrays<'_>) -> u64 {
        arrays.document.accessors[self.corner_accessor()].count.0
    }

    /// The vertices that it names, in order. Its positions are the vertices of the range, which is
    /// within 32 bits.
    fn vertices(&self, vertices: &Range<usize>, arrays: Arrays<'_>) -> Result<Vec<u32>, ReadError> {
        let (first, count) = (vertices.start as u32, vertices.len());
        let Some(indices) = self.indices else {
            let mut named = Vec::new();
            named.try_reserve_exact(count)?;
            named.extend(first..vertices.end as u32);
            return Ok(named);
        };
        let mut named = arrays.indices(indices)?;
        if let Some(index) = named.iter().find(|&&index| index as usize >= count) {
            let problem = format!("has the index {index}, and {count} vertices");
            return Err(ReadError::place(&*self.place, problem));
        }
        named.iter_mut().for_each(|index| *index += first);
        Ok(named)
    }

    /// Appends its triangles, if it has such a layout.
    pub(super) fn push_triangles(
        &self,
        layout: Layout,
        vertices: &Range<usize>,
        arrays: Arrays<'_>,
        triangles: &mut Vec<[u32; 3]>,
    ) -> Result<(), ReadError> {
        let named = self.vertices(vertices, arrays)?;
        match layout {
            Layout::List => {
                let (list, rest) = named.as_chunks();
                if !rest.is_empty() {
                    let count = named.len();
                    let problem =
                        format!("is a list of triangles with {count} indices, no multiple of 3");
                    return Err(ReadError::place(&*self.place, problem));
                }
                triangles.try_reserve(list.len())?;
                triangles.extend_from_slice(list);
            }
            Layout::Strip => {
                triangles.try_reserve(named.len())?;
                for (i, corners) in named.windows(3).enumerate() {
                    let [a, b, c] = [corners[0], corners[1], corners[2]];
                    // Triangles alternate in orientation; one with a repeated vertex joins strips.
                    if a != b && b != c && c != a {
                        triangles.push(if i % 2 == 0 { [a, b, c] } else { [a, c, b] });
                    }
                }
            }
            Layout::Fan => {
                triangles.try_reserve(named.len())?;
                if let [center, rim @ ..] = &named[..] {
                    triangles.extend(rim.windows(2).map(|edge| [edge[0], edge[1], *center]));
                }
            }
        }
        Ok(())
    }

    /// Appends its segments, if it has such lines.
    pub(super) fn push_segments(
        &self,
        lines: Lines,
        vertices: &Range<usize>,
        arrays: Arrays<'_>,
        segments: &mut Vec<[u32; 2]>,
    ) -> Result<(), ReadError> {
        let named = self.vertices(vertices, arrays)?;
        segments.try_reserve(named.len())?;
        if lines == Lines::List {
            segments.extend_from_slice(named.as_chunks().0);
            return Ok(());
        }
        segments.extend(named.windows(2).map(|ends| [ends[0], ends[1]]));
        if let (Lines::Loop, [first, .., last]) = (lines, &named[..]) {
            segments.push([*last, *first]);
        }
        Ok(())
    }
}
