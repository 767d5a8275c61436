//! Rectangles, the most common outline, by their measures.
//!
//! Limits: measures are checked where the corners are asked for, that is, by [`Domain::new`].
//!
//! [`Domain::new`]: crate::Domain::new

use glam::DVec2;

use crate::domain_error::DomainError;

/// A rectangle, which may stand anywhere at any angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectangle {
    /// The length of bottom and top, above 0.
    pub width: f64,
    /// The length of left and right, above 0.
    pub height: f64,
    /// The corner where the bottom starts.
    pub origin: DVec2,
    /// The angle from the x axis to the bottom, in degrees counter-clockwise about the origin.
    /// Multiples of 90 are exact.
    pub rotation: f64,
}

impl Rectangle {
    /// A rectangle whose bottom starts at the origin along the x axis.
    #[must_use]
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
                return Err(DomainError::Rectangle { key, value });
            }
        }
        let along = direction(self.rotation);
        let (right, up) = (self.width * along, self.height * along.perp());
        let start = self.origin;
        Ok(vec![start, start + right, start + (right + up), start + up])
    }
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
    use crate::domain::{Domain, Outline, Side};

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
}
