//! The wishes for a remesh.

/// The wishes for a remesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Remesh {
    /// The edge length where neither curvature nor near features ask for less, in units of length. `None`: the lesser of
    /// the part's mean edge and a twentieth of its diagonal.
    pub size: Option<f64>,
    /// About this many vertices, instead of a size.
    pub vertices: Option<u32>,
    /// How far the surfaces may be apart, both ways, in units of length. `None`: as near as the size or the number of
    /// vertices allows; without them 0.3 % of the diagonal is tried, not demanded.
    pub tolerance: Option<f64>,
    /// Edges that turn by more than this angle, in degrees, are features; at 180 none is.
    pub feature_angle: f64,
    /// The minimum angle aimed at, in degrees, 0 to 60. `None`: 35.
    pub target_angle: Option<f64>,
    /// Whether the edges of the boundary stay bit for bit.
    pub keep_boundary: bool,
    /// The same for all other features.
    pub keep_features: bool,
    /// Whether edges become up to three times as long where the surface is flat.
    pub curvature: bool,
    /// Whether what is wrong with the part is mended first: see [`repaired`](crate::repair::repaired). Holes with a rim below five sizes are filled.
    pub repair: bool,
}

impl Default for Remesh {
    /// Features from 40°; all else as the part suggests.
    fn default() -> Self {
        Self {
            size: None,
            vertices: None,
            tolerance: None,
            feature_angle: 40.0,
            target_angle: None,
            keep_boundary: false,
            keep_features: false,
            curvature: false,
            repair: false,
        }
    }
}

/// An error in words if a wish has no meaning.
pub(super) fn check(wish: &Remesh) -> Result<(), String> {
    let Remesh { size, vertices, tolerance, feature_angle, target_angle, .. } = wish;
    let refused = |words: String| Err(words);
    match (size, vertices, tolerance, target_angle) {
        (Some(_), Some(_), ..) => {
            refused("give a size or a number of vertices, not both".to_owned())
        }
        (Some(size), ..) if !(*size > 0.0 && size.is_finite()) => {
            refused(format!("the size is {size}; give a length above 0"))
        }
        (_, Some(0..4), ..) => refused("a surface has 4 vertices at least".to_owned()),
        (_, _, Some(tolerance), _) if !(*tolerance >= 0.0 && tolerance.is_finite()) => {
            refused(format!("the tolerance is {tolerance}; give a length, 0 or more"))
        }
        (.., Some(angle)) if !(*angle > 0.0 && *angle < 60.0) => {
            refused(format!("the target angle is {angle}; give degrees between 0 and 60"))
        }
        _ if !(0.0..=180.0).contains(feature_angle) => {
            refused(format!("the feature angle is {feature_angle}; give degrees from 0 to 180"))
        }
        _ => Ok(()),
    }
}
