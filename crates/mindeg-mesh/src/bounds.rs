//! The smallest box around some points.

use std::ops::{Add, Div, Sub};

use glam::{DVec2, DVec3};

/// The smallest axis-parallel box around a set of points, in the plane or, as `Bounds<DVec3>`, in
/// space.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_mesh::Bounds;
///
/// let bounds = Bounds::of([[4.0, 1.0], [0.0, 3.0]].map(DVec2::from)).unwrap();
/// assert_eq!(bounds.size().to_array(), [4.0, 2.0]);
/// assert_eq!(bounds.center().to_array(), [2.0, 2.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds<V = DVec2> {
    /// The least coordinates.
    pub min: V,
    /// The greatest coordinates.
    pub max: V,
}

impl<V: Copy + Add<Output = V> + Sub<Output = V> + Div<f64, Output = V>> Bounds<V> {
    /// The lengths of the box along the axes.
    pub fn size(&self) -> V {
        self.max - self.min
    }

    /// The middle of the box.
    pub fn center(&self) -> V {
        self.min + self.size() / 2.0
    }
}

impl Bounds<DVec2> {
    /// The box around some points; `None` if there are none. O(n).
    pub fn of(points: impl IntoIterator<Item = DVec2>) -> Option<Self> {
        points
            .into_iter()
            .map(|point| Self { min: point, max: point })
            .reduce(|a, b| Self { min: a.min.min(b.min), max: a.max.max(b.max) })
    }

    /// The same box in space, at z = 0.
    pub fn in_space(&self) -> Bounds<DVec3> {
        Bounds { min: self.min.extend(0.0), max: self.max.extend(0.0) }
    }
}

impl Bounds<DVec3> {
    /// The box around some points in space; `None` if there are none. O(n).
    pub fn of_space(points: impl IntoIterator<Item = DVec3>) -> Option<Self> {
        points.into_iter().map(|point| Self { min: point, max: point }).reduce(Self::union)
    }

    /// The smallest box around two boxes.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// The box seen along the z axis.
    pub fn in_plane(&self) -> Bounds<DVec2> {
        Bounds { min: self.min.truncate(), max: self.max.truncate() }
    }
}
