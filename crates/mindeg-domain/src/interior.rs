//! What is wanted inside a domain: sizes, degrees, angles, and what is fixed there.

use std::ops::RangeInclusive;

use glam::DVec2;

/// What the mesh is to be like inside a domain; what is left out has a default.
///
/// It holds what was asked for, unchecked; meshing refuses what makes no sense.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Interior {
    /// How fast the size grows from the boundary: change of size per distance.
    pub growth: Option<f64>,
    /// The size far from the boundary.
    pub size_inside: Option<f64>,
    /// Places with a size of their own.
    pub sizes: Vec<SizeAt>,
    /// The degrees wanted inside.
    pub interior_degree: Option<RangeInclusive<u32>>,
    /// The greatest degree wanted at the boundary.
    pub boundary_degree: Option<u32>,
    /// The minimum angle wanted, in degrees.
    pub target_angle: Option<f64>,
    /// Which aim wins where one costs the other.
    pub prefer: Option<Prefer>,
    /// Points and lines that the mesh must have.
    pub fixed: FixedLines,
    /// The mesh is refused where it would have more points than this.
    pub max_points: Option<usize>,
}

/// A wanted edge length at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SizeAt {
    /// The place.
    pub at: DVec2,
    /// The greatest edge length there; it grows from here as from the boundary.
    pub size: f64,
}

/// Which aim wins where one costs the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Prefer {
    /// Degrees within their limits.
    #[default]
    Degree,
    /// The minimum angle: the limit is then the one for any degree, and corners may get more triangles
    /// than the boundary degree allows.
    Angle,
}

/// Points and lines inside a domain that the mesh must have.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FixedLines {
    /// Points inside the domain.
    pub points: Vec<DVec2>,
    /// Lines of straight segments, each from end to end.
    pub lines: Vec<Vec<LineEnd>>,
}

/// An end of a segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LineEnd {
    /// The fixed point with this index.
    Point(usize),
    /// The boundary vertex or fixed point at this place, or a new fixed point.
    At(DVec2),
}
