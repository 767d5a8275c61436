//! Rectangles, the most common outline, by their measures.
//!
//! Limits: measures are checked where the corners are asked for, that is, by [`Domain::new`].
//!
//! [`Domain::new`]: crate::Domain::new

use glam::DVec2;
use mindeg_mesh::number;

use crate::error::{DomainError, Place};
use crate::limits::{GREATEST_COORDINATE, LEAST_ROUNDINGS, LEAST_SIDE};

/// A rectangle, which may stand anywhere at any angle.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "json", derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "json", serde(deny_unknown_fields))]
pub struct Rectangle {
    /// The length of bottom and top, above 0.
    #[cfg_attr(feature = "json", schemars(extend("exclusiveMinimum" = 0)))]
    pub width: f64,
    /// The length of left and right, above 0.
    #[cfg_attr(feature = "json", schemars(extend("exclusiveMinimum" = 0)))]
    pub height: f64,
    /// The corner where the bottom starts.
    #[cfg_attr(
        feature = "json",
        serde(
            default,
            deserialize_with = "crate::json::or_default",
            skip_serializing_if = "crate::json::is_default"
        )
    )]
    #[cfg_attr(feature = "json", schemars(with = "Option<[f64; 2]>"))]
    pub origin: DVec2,
    /// The angle from the x axis to the bottom, in degrees counter-clockwise about the origin.
    /// Multiples of 90 are exact.
    #[cfg_attr(
        feature = "json",
        serde(
            default,
            deserialize_with = "crate::json::or_default",
            skip_serializing_if = "crate::json::is_default"
        )
    )]
    pub rotation: f64,
}

impl Rectangle {
    /// A rectangle whose bottom starts at the origin along the x axis.
    pub fn new(width: f64, height: f64) -> Self {
        Self { width, height, origin: DVec2::ZERO, rotation: 0.0 }
    }

    pub(crate) fn corners(&self) -> Result<Vec<DVec2>, DomainError> {
        for (key, value, is_allowed) in [
            ("width", self.width, self.width > 0.0),
            ("height", self.height, self.height > 0.0),
            ("rotation", self.rotation, true),
        ] {
            if !(is_allowed && value.is_finite()) {
                let above = if key == "rotation" { "" } else { " above 0" };
                return Err(error(key, format!("is {value:?}; it must be a finite number{above}")));
            }
        }
        let along = direction(self.rotation);
        let (right, up) = (self.width * along, self.height * along.perp());
        let start = self.origin;
        let corners = vec![start, start + right, start + (right + up), start + up];
        self.check_resolution(&corners)?;
        Ok(corners)
    }

    /// Checks that 64-bit floats tell the corners apart.
    fn check_resolution(&self, corners: &[DVec2]) -> Result<(), DomainError> {
        // Refuses NaN too: the greater of two numbers would ignore it.
        let is_within = |corner: &DVec2| {
            corner.x.abs() <= GREATEST_COORDINATE && corner.y.abs() <= GREATEST_COORDINATE
        };
        if let Some(&DVec2 { x, y }) = corners.iter().find(|corner| !is_within(corner)) {
            return Err(Place::key("rectangle").error(format!(
                "a corner of the rectangle is at ({x:?}, {y:?}); coordinates must be finite and \
                     at most {GREATEST_COORDINATE:e} in size; use another unit of length"
            )));
        }
        let coordinates = corners.iter().map(|corner| corner.abs().max_element());
        let coordinate = coordinates.fold(0.0, f64::max);
        for (key, value) in [("width", self.width), ("height", self.height)] {
            if value < LEAST_SIDE {
                return Err(error(
                    key,
                    format!(
                        "is {value:?}; the minimum is {LEAST_SIDE:e}; use another unit of length"
                    ),
                ));
            }
            if value < LEAST_ROUNDINGS * f64::EPSILON * coordinate {
                return Err(error(
                    key,
                    format!(
                        "is {value:?}, and its coordinates are up to {}: 64-bit floats cannot tell its corners apart; keep width and \
                         height within a factor of 1e14, and the rectangle near the origin",
                        number(coordinate)
                    ),
                ));
            }
        }
        Ok(())
    }
}

/// An error about a measure.
fn error(key: &str, is: String) -> DomainError {
    Place::key("rectangle").then(key).error(format!("the rectangle's {key} {is}"))
}

/// The unit vector at an angle in degrees, exact at multiples of 90.
fn direction(degrees: f64) -> DVec2 {
    let turn = degrees.rem_euclid(360.0);
    let quarters = (turn / 90.0).floor();
    let rest = (turn - 90.0 * quarters).to_radians();
    let first = DVec2::new(libm::cos(rest), libm::sin(rest));
    (0..quarters as u32 % 4).fold(first, |direction, _| direction.perp())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Domain, Outline, Side};

    #[test]
    fn a_rectangle_stands_where_it_is_put() {
        let at = |origin, rotation| {
            let rectangle = Rectangle { origin, rotation, ..Rectangle::new(4.0, 3.0) };
            let sides = vec![Side::count(1); 4];
            let domain = Domain::new(Outline::Rectangle(rectangle), sides).unwrap();
            domain.placement().corners().iter().map(DVec2::to_array).collect::<Vec<_>>()
        };
        let (zero, one) = (DVec2::ZERO, DVec2::ONE);
        assert_eq!(at(zero, 0.0), [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]]);
        assert_eq!(at(one, 90.0), [[1.0, 1.0], [1.0, 5.0], [-2.0, 5.0], [-2.0, 1.0]]);
        assert_eq!(at(zero, -180.0), [[0.0, 0.0], [-4.0, 0.0], [-4.0, -3.0], [0.0, -3.0]]);
        assert_eq!(at(zero, 630.0), [[0.0, 0.0], [0.0, -4.0], [3.0, -4.0], [3.0, 0.0]]);
        let [x, y] = at(zero, 30.0)[1];
        assert!((x - 12_f64.sqrt()).abs() < 1e-15 && (y - 2.0).abs() < 1e-15);
        assert_eq!(at(zero, -1e-20), at(zero, 0.0));
    }

    #[test]
    fn refuses_with_the_reason() {
        let at = |width, height, x, rotation| {
            let origin = DVec2::new(x, 0.0);
            Rectangle { width, height, origin, rotation }.corners()
        };
        #[rustfmt::skip]
        let table = [
            (at(-1.0, 1.0, 0.0, 0.0), "the rectangle's width is -1.0; it must be a finite number above 0"),
            (at(1.0, f64::INFINITY, 0.0, 0.0), "the rectangle's height is inf; it must be a finite number above 0"),
            (at(1.0, 1.0, 0.0, f64::NAN), "the rectangle's rotation is NaN; it must be a finite number"),
            (at(1e-101, 1e-101, 0.0, 0.0), "the rectangle's width is 1e-101; the minimum is 1e-100; use another unit of length"),
            (at(1.0, 1e101, 0.0, 0.0), "a corner of the rectangle is at (1.0, 1e101); coordinates must be finite and at most 1e100 in size; use another unit of length"),
            (at(1.0, 1.0, f64::NAN, 0.0), "a corner of the rectangle is at (NaN, 0.0); coordinates must be finite and at most 1e100 in size; use another unit of length"),
            (at(1e-17, 1.0, 0.0, 0.0), "the rectangle's width is 1e-17, and its coordinates are up to 1: 64-bit floats cannot tell its corners apart; keep width and height within a factor of 1e14, and the rectangle near the origin"),
            (at(1e17, 1.0, 0.0, 45.0), "the rectangle's height is 1.0, and its coordinates are up to 7.071e16: 64-bit floats cannot tell its corners apart; keep width and height within a factor of 1e14, and the rectangle near the origin"),
            (at(1.0, 1.0, 1e17, 0.0), "the rectangle's width is 1.0, and its coordinates are up to 1e17: 64-bit floats cannot tell its corners apart; keep width and height within a factor of 1e14, and the rectangle near the origin"),
        ];
        for (outcome, message) in table {
            assert_eq!(outcome.unwrap_err().to_string(), message);
        }
        assert!(at(1e14, 1.0, 0.0, 0.0).is_ok() && at(1.0, 1.0, 1e14, 30.0).is_ok());
    }
}
