//! Transverse Mercator by Krüger's series to the sixth order, good to nanometres within 30° of the middle meridian.
//!
//! Source: C. F. F. Karney, Transverse Mercator with an accuracy of a few nanometers, J. Geodesy 85 (2011), 475-485,
//! equations 7 to 11, 35 and 36.

use glam::DVec2;

use super::ellipsoid::Ellipsoid;

/// The scale on UTM's middle meridian.
const SCALE: f64 = 0.9996;

/// The coefficients of n to its sixth power, of the series with sines of 2, 4, ... 12 times an angle.
type Series = [[f64; 6]; 6];

const FORWARD: Series = [
    [1.0 / 2.0, -2.0 / 3.0, 5.0 / 16.0, 41.0 / 180.0, -127.0 / 288.0, 7891.0 / 37800.0],
    [0.0, 13.0 / 48.0, -3.0 / 5.0, 557.0 / 1440.0, 281.0 / 630.0, -1_983_433.0 / 1_935_360.0],
    [0.0, 0.0, 61.0 / 240.0, -103.0 / 140.0, 15061.0 / 26880.0, 167_603.0 / 181_440.0],
    [0.0, 0.0, 0.0, 49561.0 / 161_280.0, -179.0 / 168.0, 6_601_661.0 / 7_257_600.0],
    [0.0, 0.0, 0.0, 0.0, 34729.0 / 80640.0, -3_418_889.0 / 1_995_840.0],
    [0.0, 0.0, 0.0, 0.0, 0.0, 212_378_941.0 / 319_334_400.0],
];

const INVERSE: Series = [
    [1.0 / 2.0, -2.0 / 3.0, 37.0 / 96.0, -1.0 / 360.0, -81.0 / 512.0, 96199.0 / 604_800.0],
    [0.0, 1.0 / 48.0, 1.0 / 15.0, -437.0 / 1440.0, 46.0 / 105.0, -1_118_711.0 / 3_870_720.0],
    [0.0, 0.0, 17.0 / 480.0, -37.0 / 840.0, -209.0 / 4480.0, 5569.0 / 90720.0],
    [0.0, 0.0, 0.0, 4397.0 / 161_280.0, -11.0 / 504.0, -830_251.0 / 7_257_600.0],
    [0.0, 0.0, 0.0, 0.0, 4583.0 / 161_280.0, -108_847.0 / 3_991_680.0],
    [0.0, 0.0, 0.0, 0.0, 0.0, 20_648_693.0 / 638_668_800.0],
];

pub(super) struct TransverseMercator<'a> {
    ellipsoid: &'a Ellipsoid,
    /// In radians.
    meridian: f64,
    third_flattening: f64,
    /// Metres for a unit of the sphere.
    scale: f64,
}

impl<'a> TransverseMercator<'a> {
    pub(super) fn new(ellipsoid: &'a Ellipsoid, meridian: f64) -> Self {
        let n = ellipsoid.flattening / (2.0 - ellipsoid.flattening);
        let squared = n * n;
        let rectifying = ellipsoid.radius / (1.0 + n)
            * (1.0
                + squared / 4.0
                + squared * squared / 64.0
                + squared * squared * squared / 256.0);
        let (meridian, scale) = (meridian.to_radians(), SCALE * rectifying);
        Self { ellipsoid, meridian, third_flattening: n, scale }
    }

    pub(super) fn forward(&self, radians: DVec2) -> DVec2 {
        let longitude = super::azimuthal::turn(radians.x - self.meridian);
        let conformal = self.ellipsoid.conformal(libm::tan(radians.y));
        let cosine = libm::cos(longitude);
        let northing = libm::atan2(conformal, cosine);
        let easting = libm::asinh(libm::sin(longitude) / libm::hypot(conformal, cosine));
        let at = DVec2::new(easting, northing);
        (at + self.sum(&FORWARD, at)) * self.scale
    }

    pub(super) fn inverse(&self, plane: DVec2) -> DVec2 {
        let at = plane / self.scale;
        let at = at - self.sum(&INVERSE, at);
        let (sinh, cosine) = (libm::sinh(at.x), libm::cos(at.y));
        let conformal = libm::sin(at.y) / libm::hypot(sinh, cosine);
        let latitude = libm::atan(self.ellipsoid.of_conformal(conformal));
        DVec2::new(libm::atan2(sinh, cosine) + self.meridian, latitude)
    }

    /// The sum of the series at (easting, northing) on the sphere.
    fn sum(&self, series: &Series, at: DVec2) -> DVec2 {
        let mut sum = DVec2::ZERO;
        // The small terms first.
        for (row, order) in series.iter().zip(1_u8..=6).rev() {
            let coefficient =
                row.iter().rev().fold(0.0, |sum, factor| (sum + factor) * self.third_flattening);
            let angle = at * (2.0 * f64::from(order));
            sum += coefficient
                * DVec2::new(
                    libm::cos(angle.y) * libm::sinh(angle.x),
                    libm::sin(angle.y) * libm::cosh(angle.x),
                );
        }
        sum
    }
}
