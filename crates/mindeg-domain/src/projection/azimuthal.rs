//! The stereographic and Lambert's azimuthal projection, about any centre.
//!
//! Both map the ellipsoid to a sphere, by the conformal and by the authalic latitude, and that to the plane.
//! Source: J. P. Snyder, Map projections, a working manual, USGS Professional Paper 1395 (1987), equations 3-1, 3-12,
//! 21-24 to 21-28 and 24-14 to 24-24.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::DVec2;

use super::ellipsoid::Ellipsoid;

pub(super) struct Azimuthal<'a> {
    ellipsoid: &'a Ellipsoid,
    is_equal_area: bool,
    /// The centre's longitude in radians.
    longitude: f64,
    /// The sine and cosine of its latitude on the sphere.
    center: [f64; 2],
    /// Metres for a unit of the sphere: of the plane that touches it, for Lambert's of its radius.
    scale: f64,
    /// Lambert's D: east by this, north by its inverse.
    stretch: f64,
}

impl<'a> Azimuthal<'a> {
    pub(super) fn stereographic(
        ellipsoid: &'a Ellipsoid,
        center: DVec2,
        true_latitude: Option<f64>,
    ) -> Self {
        let (longitude, latitude) = (center.x.to_radians(), center.y.to_radians());
        let is_pole = center.y.abs() == 90.0;
        let [sine, cosine] = match is_pole {
            true => [center.y.signum(), 0.0],
            false => on_sphere(ellipsoid.conformal(libm::tan(latitude))),
        };
        let scale = match true_latitude {
            _ if !is_pole => 2.0 * ellipsoid.radius * ellipsoid.parallel(latitude) / cosine,
            Some(of_truth) if of_truth.abs() < 90.0 => {
                let [own, across] =
                    on_sphere(ellipsoid.conformal(libm::tan(of_truth.to_radians().abs())));
                ellipsoid.radius * ellipsoid.parallel(of_truth.to_radians()) * (1.0 + own) / across
            }
            _ => {
                let e = ellipsoid.eccentricity();
                2.0 * ellipsoid.radius
                    / libm::sqrt(libm::pow(1.0 + e, 1.0 + e) * libm::pow(1.0 - e, 1.0 - e))
            }
        };
        let center = [sine, cosine];
        Self { ellipsoid, is_equal_area: false, longitude, center, scale, stretch: 1.0 }
    }

    pub(super) fn equal_area(ellipsoid: &'a Ellipsoid, center: DVec2) -> Self {
        let (longitude, latitude) = (center.x.to_radians(), center.y.to_radians());
        let scale = ellipsoid.radius * libm::sqrt(ellipsoid.half_zone() / 2.0);
        let is_pole = center.y.abs() == 90.0;
        let sine =
            if is_pole { center.y.signum() } else { ellipsoid.authalic(libm::sin(latitude)) };
        let cosine = libm::sqrt((1.0 - sine * sine).max(0.0));
        let stretch = match is_pole {
            true => 1.0,
            false => ellipsoid.radius * ellipsoid.parallel(latitude) / (scale * cosine),
        };
        let center = [sine, cosine];
        Self { ellipsoid, is_equal_area: true, longitude, center, scale, stretch }
    }

    pub(super) fn forward(&self, radians: DVec2) -> DVec2 {
        let longitude = turn(radians.x - self.longitude);
        let [sine, cosine] = if self.is_equal_area {
            let sine = self.ellipsoid.authalic(libm::sin(radians.y));
            [sine, libm::sqrt((1.0 - sine * sine).max(0.0))]
        } else if radians.y.abs() >= FRAC_PI_2 {
            [radians.y.signum(), 0.0]
        } else {
            on_sphere(self.ellipsoid.conformal(libm::tan(radians.y)))
        };
        let [own_sine, own_cosine] = self.center;
        let along = libm::cos(longitude);
        let towards = 1.0 + own_sine * sine + own_cosine * cosine * along;
        let factor = match self.is_equal_area {
            true => libm::sqrt(2.0 / towards),
            false => 1.0 / towards,
        };
        let east = cosine * libm::sin(longitude);
        let north = own_cosine * sine - own_sine * cosine * along;
        DVec2::new(east * self.stretch, north / self.stretch) * (factor * self.scale)
    }

    pub(super) fn inverse(&self, plane: DVec2) -> DVec2 {
        let [own_sine, own_cosine] = self.center;
        let at = DVec2::new(plane.x / self.stretch, plane.y * self.stretch) / self.scale;
        let distance = libm::hypot(at.x, at.y);
        if distance == 0.0 {
            return DVec2::new(self.longitude, self.latitude(own_sine, own_cosine));
        }
        // The angle from the centre.
        let angle = match self.is_equal_area {
            true => 2.0 * libm::asin((distance / 2.0).min(1.0)),
            false => 2.0 * libm::atan(distance),
        };
        let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
        let up = at / distance;
        let on_axis = cosine * own_sine + up.y * sine * own_cosine;
        let across = DVec2::new(up.x * sine, own_cosine * cosine - up.y * own_sine * sine);
        let longitude = libm::atan2(across.x, across.y) + self.longitude;
        DVec2::new(longitude, self.latitude(on_axis, libm::hypot(across.x, across.y)))
    }

    /// The latitude on the ellipsoid, of sine and cosine of that on the sphere.
    fn latitude(&self, sine: f64, cosine: f64) -> f64 {
        if self.is_equal_area {
            return libm::asin(self.ellipsoid.of_authalic(sine.clamp(-1.0, 1.0)));
        }
        libm::atan(self.ellipsoid.of_conformal(sine / cosine))
    }
}

/// Sine and cosine of an angle, of its tangent.
fn on_sphere(tangent: f64) -> [f64; 2] {
    let secant = libm::hypot(1.0, tangent);
    [tangent / secant, 1.0 / secant]
}

/// An angle from -π to π.
pub(super) fn turn(angle: f64) -> f64 {
    if angle.abs() <= PI { angle } else { angle - TAU * libm::round(angle / TAU) }
}
