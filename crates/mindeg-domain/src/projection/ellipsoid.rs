//! The ellipsoid, and its conformal and authalic latitudes.

/// An ellipsoid of revolution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ellipsoid {
    /// The radius of the equator in metres.
    pub(super) radius: f64,
    pub(super) flattening: f64,
}

/// Newton's steps: each doubles the digits, and five give all of them.
const STEPS: usize = 5;

impl Ellipsoid {
    pub(super) const WGS84: Self = Self { radius: 6_378_137.0, flattening: 1.0 / 298.257_223_563 };
    pub(super) const GRS80: Self = Self { radius: 6_378_137.0, flattening: 1.0 / 298.257_222_101 };

    pub(super) fn squared_eccentricity(&self) -> f64 {
        self.flattening * (2.0 - self.flattening)
    }

    pub(super) fn eccentricity(&self) -> f64 {
        libm::sqrt(self.squared_eccentricity())
    }

    /// The radius of a parallel over that of the equator.
    pub(super) fn parallel(&self, latitude: f64) -> f64 {
        let sine = libm::sin(latitude);
        libm::cos(latitude) / libm::sqrt(1.0 - self.squared_eccentricity() * sine * sine)
    }

    /// The radius of curvature of the meridian, in metres.
    pub(super) fn meridian_radius(&self, latitude: f64) -> f64 {
        let sine = libm::sin(latitude);
        let squared = self.squared_eccentricity();
        let root = libm::sqrt(1.0 - squared * sine * sine);
        self.radius * (1.0 - squared) / (root * root * root)
    }

    /// The tangent of the conformal latitude, of the tangent of the latitude.
    pub(super) fn conformal(&self, tangent: f64) -> f64 {
        let eccentricity = self.eccentricity();
        let secant = libm::hypot(1.0, tangent);
        let sigma = libm::sinh(eccentricity * libm::atanh(eccentricity * tangent / secant));
        tangent * libm::hypot(1.0, sigma) - sigma * secant
    }

    /// The tangent of the latitude, of that of the conformal latitude (Karney 2011, equations 19 to 21).
    pub(super) fn of_conformal(&self, conformal: f64) -> f64 {
        let rest = 1.0 - self.squared_eccentricity();
        let mut tangent = conformal / rest;
        if !tangent.is_finite() || tangent.abs() > 1e15 {
            return tangent;
        }
        for _ in 0..STEPS {
            let own = self.conformal(tangent);
            tangent += (conformal - own) / libm::hypot(1.0, own) * (1.0 + rest * tangent * tangent)
                / (rest * libm::hypot(1.0, tangent));
        }
        tangent
    }

    /// Snyder's q, equation 3-12: the area from the equator on, of the sine of the latitude.
    fn zone(&self, sine: f64) -> f64 {
        let (squared, eccentricity) = (self.squared_eccentricity(), self.eccentricity());
        (1.0 - squared)
            * (sine / (1.0 - squared * sine * sine)
                + libm::atanh(eccentricity * sine) / eccentricity)
    }

    /// Snyder's q of a pole.
    pub(super) fn half_zone(&self) -> f64 {
        self.zone(1.0)
    }

    /// The sine of the authalic latitude, of that of the latitude.
    pub(super) fn authalic(&self, sine: f64) -> f64 {
        self.zone(sine) / self.half_zone()
    }

    /// The sine of the latitude, of that of the authalic latitude.
    pub(super) fn of_authalic(&self, authalic: f64) -> f64 {
        let squared = self.squared_eccentricity();
        let wanted = authalic * self.half_zone();
        let mut sine = authalic;
        for _ in 0..STEPS {
            let root = 1.0 - squared * sine * sine;
            sine += (wanted - self.zone(sine)) * root * root / (2.0 * (1.0 - squared));
            sine = sine.clamp(-1.0, 1.0);
        }
        sine
    }
}
