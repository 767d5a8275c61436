//! The settings for the inside of a domain: sizes, degrees and angles.
//!
//! The fields of [`Interior`] are the one list of these options: JSON, the command line, Python and the
//! page of `mindeg explore` take their names, texts and types from it.

use std::ops::RangeInclusive;

use crate::error::{DomainError, Place};
use crate::sizes::{Size, SizeAt, is_size};

/// Wishes for a mesh with interior points; each has a default
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "json", derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "json", serde(deny_unknown_fields))]
pub struct Interior {
    /// How fast the size grows per distance [default: 0.15, beside longer edges 0.5]
    #[cfg_attr(feature = "json", schemars(extend("exclusiveMinimum" = 0)))]
    pub growth: Option<f64>,
    /// The size far from the boundary [default: a mean of the boundary's intervals]
    #[cfg_attr(feature = "json", schemars(extend("exclusiveMinimum" = 0)))]
    pub size_inside: Option<f64>,
    /// The least size that counts: sizes asked for below it are raised to it
    #[cfg_attr(feature = "json", schemars(extend("exclusiveMinimum" = 0)))]
    pub min_size: Option<f64>,
    /// The greatest size anywhere [default: none]
    #[cfg_attr(feature = "json", schemars(extend("exclusiveMinimum" = 0)))]
    pub max_size: Option<f64>,
    /// At least so many edges across channels and beside islands, as far as edges that stay allow
    #[cfg_attr(feature = "json", schemars(extend("exclusiveMinimum" = 0, "maximum" = 100)))]
    pub across: Option<f64>,
    /// Sizes somewhere: the least of all holds, and grows from there as from the boundary. Up to the default growth no
    /// edge at the vertex nearest to a place `[x, y, h]` is longer than h
    #[cfg_attr(
        feature = "json",
        serde(
            default,
            deserialize_with = "crate::json::or_default",
            skip_serializing_if = "Vec::is_empty"
        )
    )]
    pub sizes: Vec<Size>,
    /// The degrees of interior vertices, a range around 6 [default: 5 to 7]
    #[cfg_attr(feature = "json", serde(default, with = "crate::json::range"))]
    #[cfg_attr(feature = "json", schemars(
        with = "Option<[u32; 2]>",
        extend("prefixItems" = [{"type": "integer", "minimum": 3, "maximum": 6}, {"type": "integer", "minimum": 6}])
    ))]
    pub interior_degree: Option<RangeInclusive<u32>>,
    /// The most edges at the boundary; more at reflex corners, 2 + round(angle/60°) [default: 5]
    #[cfg_attr(feature = "json", schemars(range(min = 4)))]
    pub boundary_degree: Option<u32>,
    /// At most so many corners of a triangle at the boundary, 2 or 3 [default: 3]
    #[cfg_attr(feature = "json", schemars(range(min = 2, max = 3)))]
    pub boundary_corners: Option<u32>,
    /// The minimum angle in degrees [default: as much as the boundary allows, up to about 35]
    #[cfg_attr(feature = "json", schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = 60)))]
    pub target_angle: Option<f64>,
    /// Which aim wins where one costs the other [default: degree]
    pub prefer: Option<Prefer>,
    /// The most points of the mesh; one that would have more is refused [default: 20 million]
    pub max_points: Option<usize>,
}

/// Which aim wins where one costs the other
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "json", derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "json", serde(rename_all = "snake_case"))]
pub enum Prefer {
    /// Degrees within their limits
    #[default]
    Degree,
    /// The minimum angle: the limit is then the one for any degree, and corners may get more triangles
    /// than the boundary degree allows
    Angle,
}

impl Interior {
    /// The growth of the size per distance: 0.5 by default, which holds beside longer edges; elsewhere sizes that nobody asks
    /// for then grow by 0.15.
    pub fn growth(&self) -> f64 {
        self.growth.unwrap_or(0.5)
    }

    /// The sizes at points.
    pub fn sizes_at(&self) -> impl Iterator<Item = SizeAt> + '_ {
        self.sizes.iter().filter_map(|size| match size {
            Size::At(at) => Some(*at),
            _ => None,
        })
    }

    /// The degrees wanted inside: 5 to 7 unless they are given.
    pub fn interior_degree(&self) -> RangeInclusive<u32> {
        self.interior_degree.clone().unwrap_or(5..=7)
    }

    /// The greatest degree wanted at the boundary: 5 unless it is given.
    pub fn boundary_degree(&self) -> u32 {
        self.boundary_degree.unwrap_or(5)
    }

    /// Whether each triangle has a corner inside.
    pub fn has_corners_inside(&self) -> bool {
        self.boundary_corners == Some(2)
    }

    /// The least number of triangles at a boundary vertex: all corners of a single one are at the boundary.
    pub fn least_triangles(&self) -> u32 {
        if self.has_corners_inside() { 2 } else { 1 }
    }

    /// Which aim wins: degrees, unless it is given.
    pub fn prefer(&self) -> Prefer {
        self.prefer.unwrap_or_default()
    }

    /// The most points that the mesh may have: 20 million unless it is given.
    pub fn max_points(&self) -> usize {
        self.max_points.unwrap_or(20_000_000)
    }

    /// Checks all values that need no domain.
    ///
    /// # Errors
    ///
    /// The first value outside its range.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::Interior;
    ///
    /// let wanted = Interior { growth: Some(0.0), ..Interior::default() };
    /// assert_eq!(wanted.check().unwrap_err().place.to_string(), "growth");
    /// ```
    pub fn check(&self) -> Result<(), DomainError> {
        let error = |place: Place, message: String| Err(place.error(message));
        if let Some(growth) = self.growth.filter(|growth| !is_size(*growth)) {
            let usual = "it is a finite number above 0 (0.5 is usual, less grows slower)";
            return error(Place::key("growth"), format!("growth is {growth}; {usual}"));
        }
        if let Some(size) = self.size_inside.filter(|size| !is_size(*size)) {
            let message = format!("the size inside is {size}; a size is a finite number above 0");
            return error(Place::key("size_inside"), message);
        }
        for (key, size) in [("min_size", self.min_size), ("max_size", self.max_size)] {
            if let Some(size) = size.filter(|size| !is_size(*size)) {
                let message = format!("the size is {size}; a size is a finite number above 0");
                return error(Place::key(key), message);
            }
        }
        if let (Some(min), Some(max)) = (self.min_size, self.max_size)
            && min > max
        {
            let message = format!("the least size, {min}, is above the greatest, {max}");
            return error(Place::key("min_size"), message);
        }
        if let Some(across) = self.across.filter(|across| !(*across > 0.0 && *across <= 100.0)) {
            let message =
                format!("{across} edges across is out of range; give more than 0, up to 100");
            return error(Place::key("across"), message);
        }
        self.sizes.iter().enumerate().try_for_each(|(index, size)| size.check(index))?;
        if let Some(degrees) = &self.interior_degree
            && !((3..=6).contains(degrees.start()) && *degrees.end() >= 6)
        {
            let (least, greatest) = (degrees.start(), degrees.end());
            let message = format!(
                "interior degrees {least} to {greatest} are out of reach: the range must contain 6 \
                 and start at 3 or more"
            );
            return error(Place::key("interior_degree"), message);
        }
        if let Some(degree) = self.boundary_degree.filter(|degree| *degree < 4) {
            let message =
                format!("a boundary degree of {degree} is too low; use 4 or more (5 is usual)");
            return error(Place::key("boundary_degree"), message);
        }
        if let Some(corners) = self.boundary_corners.filter(|corners| !(2..=3).contains(corners)) {
            let message =
                format!("{corners} corners at the boundary are out of range; give 2 or 3");
            return error(Place::key("boundary_corners"), message);
        }
        if let Some(angle) = self.target_angle.filter(|angle| !(*angle > 0.0 && *angle < 60.0)) {
            let message =
                format!("target angle {angle} is out of range; give degrees above 0 and below 60");
            return error(Place::key("target_angle"), message);
        }
        Ok(())
    }
}
