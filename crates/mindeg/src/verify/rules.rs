//! The rules for the mesh of a surface.

use std::ops::RangeInclusive;

/// The rules that a mesh keeps of a part.
///
/// # Example
///
/// ```
/// use mindeg::verify::SurfaceRules;
///
/// let rules = SurfaceRules::within(0.25);
/// assert_eq!((rules.inside, rules.boundary_degree), (5..=7, 5));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceRules {
    /// How far a point of one surface may be from the other, in units of length. Distances below a hundred-millionth of
    /// the part's diagonal count as none.
    pub tolerance: f64,
    /// The degrees of vertices off the boundary.
    pub inside: RangeInclusive<u32>,
    /// The most edges at a vertex on the boundary.
    pub boundary_degree: u32,
    /// The minimum angle, in degrees, that triangles at a corner of the part are to reach: where its sectors then allow no
    /// degree in the ranges above, those that they allow count instead.
    pub least_angle: f64,
    /// Edges of the part that turn by more than this angle, in degrees, must have edges of the mesh within the
    /// tolerance that turn by more than half of it; `None` demands nothing of sharp edges.
    pub feature_angle: Option<f64>,
    /// Whether the edges of the boundary must be those of the part, bit for bit.
    pub keep_boundary: bool,
    /// Whether the sharp edges of the part must be edges of the mesh, bit for bit. Takes a `feature_angle`.
    pub keep_features: bool,
}

impl SurfaceRules {
    /// Degrees 5 to 7, at most 5 on the boundary, 35° at corners, and a tolerance both ways.
    #[must_use]
    pub fn within(tolerance: f64) -> Self {
        Self {
            tolerance,
            inside: 5..=7,
            boundary_degree: 5,
            least_angle: 35.0,
            feature_angle: None,
            keep_boundary: false,
            keep_features: false,
        }
    }
}
