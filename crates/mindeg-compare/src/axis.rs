//! The axis of a histogram: which bar a value is in.

/// The number of bars of a histogram.
pub const BARS: usize = 30;

/// The axis of a measure, divided into [`BARS`] bars of equal width.
///
/// # Example
///
/// ```
/// use mindeg_compare::axis::{Axis, BARS};
///
/// let axis = Axis { range: [0.1, 60.0], is_logarithmic: true };
/// assert_eq!(axis.bar(0.1), 0);
/// assert_eq!(axis.bar(60.0), BARS - 1);
/// assert_eq!(axis.bar(6.0_f64.sqrt()), BARS / 2); // half of a logarithmic axis
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// The value at either end. The second is greater, and on a logarithmic axis both are above 0.
    pub range: [f64; 2],
    /// Whether equal factors, not equal differences, have equal widths.
    pub is_logarithmic: bool,
}

impl Axis {
    /// The bar of a value, from 0. A value beyond an end is in the last bar there; NaN is in the
    /// first. O(1).
    #[must_use]
    pub fn bar(&self, value: f64) -> usize {
        // The cast makes 0 of NaN.
        ((self.share(value) * BARS as f64) as usize).min(BARS - 1)
    }

    /// Where a value is on the axis, 0 to 1; no number is nowhere. O(1).
    #[must_use]
    pub fn share(&self, value: f64) -> f64 {
        let [low, high] = self.range;
        let share = if self.is_logarithmic {
            libm::log(value / low) / libm::log(high / low)
        } else {
            (value - low) / (high - low)
        };
        share.clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_have_a_bar_whatever_they_are() {
        for (value, is_logarithmic, expected) in [
            (1.0, false, 0),
            (5.5, false, 9),
            (4.0, true, 15),
            (16.0, true, 29),
            (17.0, false, 29),
            (0.0, true, 0),
            (f64::INFINITY, true, 29),
            (f64::INFINITY, false, 29),
            (-3.0, false, 0),
            (-3.0, true, 0),
            (f64::NAN, false, 0),
            (f64::NAN, true, 0),
        ] {
            let axis = Axis { range: [1.0, 16.0], is_logarithmic };
            assert_eq!(axis.bar(value), expected, "{value}");
        }
    }
}
