//! The space that a mesh lies in: the plane, or a surface.

use glam::{DVec2, DVec3};
use std::fmt::Debug;
use std::ops::{Add, Mul, Sub};

/// A vector of two or three coordinates.
pub(crate) trait Vector:
    Copy + Debug + PartialEq + Add<Output = Self> + Sub<Output = Self> + Mul<f64, Output = Self>
{
    const ZERO: Self;

    fn dot(self, other: Self) -> f64;

    /// Twice the area of the triangle of two sides: signed in the plane, never negative in space.
    fn doubled(self, other: Self) -> f64;

    fn distance_squared(self, other: Self) -> f64;

    fn length(self) -> f64;

    /// The same direction with length 1, or zero.
    fn normalize_or_zero(self) -> Self;
}

impl Vector for DVec2 {
    const ZERO: Self = Self::ZERO;

    fn dot(self, other: Self) -> f64 {
        self.dot(other)
    }

    fn doubled(self, other: Self) -> f64 {
        self.perp_dot(other)
    }

    fn distance_squared(self, other: Self) -> f64 {
        self.distance_squared(other)
    }

    fn length(self) -> f64 {
        self.length()
    }

    fn normalize_or_zero(self) -> Self {
        self.normalize_or_zero()
    }
}

impl Vector for DVec3 {
    const ZERO: Self = Self::ZERO;

    fn dot(self, other: Self) -> f64 {
        self.dot(other)
    }

    fn doubled(self, other: Self) -> f64 {
        self.cross(other).length()
    }

    fn distance_squared(self, other: Self) -> f64 {
        self.distance_squared(other)
    }

    fn length(self) -> f64 {
        self.length()
    }

    fn normalize_or_zero(self) -> Self {
        self.normalize_or_zero()
    }
}

/// The place of vertices, edges and triangles of a mesh, as each knows it.
pub(crate) trait Space: Copy + Debug + PartialEq {
    /// A position.
    type Vector: Vector;
    /// A position with what the space knows of it.
    type Site: Copy + Debug + PartialEq;
    /// The line or curve that an edge that stays is a part of; the default on other edges.
    type Label: Copy + Debug + PartialEq + Default;
    /// The part of the space that a triangle lies in, between edges that stay.
    type Patch: Copy + Debug + PartialEq + Default;

    /// True if geometry alone makes sure that operations keep the topology, and edges that stay keep their ends.
    const IS_PLANE: bool;

    fn position(site: &Self::Site) -> Self::Vector;
}

/// The space of planar meshes: sites are points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Plane;

impl Space for Plane {
    type Vector = DVec2;
    type Site = DVec2;
    /// True on a fixed edge.
    type Label = bool;
    type Patch = ();

    const IS_PLANE: bool = true;

    fn position(site: &DVec2) -> DVec2 {
        *site
    }
}
