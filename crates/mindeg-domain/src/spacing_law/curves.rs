//! The curves of the spacing laws: the share of a side before point `i` of `m`.
//!
//! A factor that all points of a side share is computed once: a transcendental function takes
//! longer than everything else about a point.
//!
//! Limits: `0 < i < m`.

/// A geometric progression of intervals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Progression {
    log_ratio: f64,
    /// r^m - 1 for a ratio r below 1; for others the same of 1/r.
    whole: f64,
}

impl Progression {
    /// For `m` intervals and the logarithm of their ratio, which is not 0.
    pub(super) fn new(log_ratio: f64, m: u32) -> Self {
        Self { log_ratio, whole: libm::expm1(-f64::from(m) * log_ratio.abs()) }
    }

    /// (r^i - 1) / (r^m - 1)
    pub(super) fn share(&self, i: u32, m: u32) -> f64 {
        let Self { log_ratio, whole } = *self;
        let (i, m) = (f64::from(i), f64::from(m));
        if log_ratio < 0.0 {
            libm::expm1(i * log_ratio) / whole
        } else {
            // Numerator and denominator are divided by r^m, which may be too large for an f64.
            libm::exp((i - m) * log_ratio) * (libm::expm1(-i * log_ratio) / whole)
        }
    }
}

/// A hyperbolic tangent: beta, and bump with ratio below 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stretching {
    width: f64,
    /// exp(-2 w) - 1
    whole: f64,
}

impl Stretching {
    /// `width` is artanh(1/b) for beta and artanh √(1-c) for bump, above 0.
    pub(super) fn new(width: f64) -> Self {
        Self { width, whole: libm::expm1(-2.0 * width) }
    }

    /// Beta: 1 - tanh((1-u) w)/tanh w for u = i/m, as a product.
    pub(super) fn share(&self, i: u32, m: u32) -> f64 {
        let Self { width, whole } = *self;
        let from_start = 2.0 * width * (f64::from(i) / f64::from(m));
        let from_end = 2.0 * width * (f64::from(m - i) / f64::from(m));
        let decay = libm::exp(-from_end);
        2.0 * decay / (1.0 + decay) * (libm::expm1(-from_start) / whole)
    }

    /// Bump, up to the middle.
    pub(super) fn half_share(&self, i: u32, m: u32) -> f64 {
        let double = 2.0 * self.width;
        let from_end = f64::from(i) / f64::from(m) * double;
        // exp of minus the distance to the middle, in the units of the exponent.
        let decay = libm::exp(2.0 * from_end - double);
        decay / (1.0 + decay) * (libm::expm1(-2.0 * from_end) / self.whole)
    }
}

/// A tangent: bump with ratio above 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Crowding {
    angle: f64,
    /// pi/2 - angle, computed as atan(1/tangent) because the subtraction cancels for large
    /// tangents.
    complement: f64,
    /// 2 cos(complement)
    whole: f64,
}

impl Crowding {
    /// `tangent` is √(c-1), above 0.
    pub(super) fn new(tangent: f64) -> Self {
        let (angle, complement) = (libm::atan(tangent), libm::atan(1.0 / tangent));
        Self { angle, complement, whole: 2.0 * libm::cos(complement) }
    }

    /// Up to the middle.
    pub(super) fn half_share(&self, i: u32, m: u32) -> f64 {
        let from_end = 2.0 * self.angle * (f64::from(i) / f64::from(m));
        libm::sin(from_end) / (self.whole * libm::sin(self.complement + from_end))
    }
}
