//! How numbers are written for people.
//!
//! The rule for digits is that of [`number`], [`coordinate`], [`steady_angle`] and [`percent`]. The numbers of a
//! column share their number of decimals, so that their points stand below one another: see [`Column`].
//!
//! Limits: one language, and a point as the decimal mark.

/// More decimals than these do not fit a column; smaller numbers are written with an exponent.
const MAX_DECIMALS: i32 = 4;

pub use mindeg_mesh::{coordinate, number, percent, place, significant, steady_angle};

/// The numbers of a column: all with the same number of decimals.
///
/// ```
/// use mindeg_answers::numbers::Column;
///
/// let lengths = [0.1246, 2.01, 163.884];
/// let column = Column::new(lengths, 3);
/// assert_eq!(lengths.map(|value| column.number(value)), ["0.125", "2.010", "163.884"]);
/// assert_eq!(column.number(1.5e-9), "1.5e-9");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    decimals: usize,
}

impl Column {
    /// As many decimals, four at most, as the number nearest to zero needs for `digits >= 1`
    /// significant digits.
    #[must_use]
    pub fn new(values: impl IntoIterator<Item = f64>, digits: i32) -> Self {
        let needed = values
            .into_iter()
            .filter(|value| value.is_finite() && *value != 0.0)
            .map(|value| digits - 1 - libm::floor(libm::log10(value.abs())) as i32)
            .max();
        Self { decimals: needed.unwrap_or(0).clamp(0, MAX_DECIMALS) as usize }
    }

    /// A number of the column, with an exponent if it would keep fewer than two significant digits or is
    /// beyond 1e9.
    #[must_use]
    pub fn number(self, value: f64) -> String {
        let least = libm::pow(10.0, 1.0 - self.decimals as f64) / 2.0;
        let fits =
            value == 0.0 || (value.abs() < 1e9 && (self.decimals == 0 || value.abs() >= least));
        if value.is_finite() && fits {
            format!("{value:.*}", self.decimals)
        } else {
            significant(value, 3)
        }
    }
}

/// How many triangles, with the word for one or many.
///
/// ```
/// use mindeg_answers::numbers::triangles;
///
/// assert_eq!([1_u32, 2].map(triangles), ["1 triangle", "2 triangles"]);
/// ```
#[must_use]
pub fn triangles(count: impl Into<u64>) -> String {
    counted(count, "triangle")
}

/// How many of something, with the word for one or many.
///
/// ```
/// use mindeg_answers::numbers::counted;
///
/// assert_eq!([1_u32, 2].map(|count| counted(count, "region")), ["1 region", "2 regions"]);
/// ```
#[must_use]
pub fn counted(count: impl Into<u64>, noun: &str) -> String {
    match count.into() {
        1 => format!("1 {noun}"),
        count => format!("{count} {noun}s"),
    }
}

/// A whole number, with narrow spaces between groups of three digits from five digits up.
///
/// ```
/// assert_eq!(mindeg_answers::numbers::count(10_000_u32), "10\u{202f}000");
/// ```
#[must_use]
pub fn count(value: impl Into<u64>) -> String {
    let digits = value.into().to_string();
    if digits.len() < 5 {
        return digits;
    }
    let mut grouped = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            grouped.push('\u{202f}');
        }
        grouped.push(digit);
    }
    grouped
}

/// A duration in one unit, as those of a column are written; its unit stays beside it.
///
/// ```
/// use mindeg_answers::numbers::milliseconds;
///
/// assert_eq!([2.34e-6, 0.0123, 1.523].map(milliseconds), ["0.0023\u{a0}ms", "12\u{a0}ms", "1523\u{a0}ms"]);
/// ```
#[must_use]
pub fn milliseconds(seconds: f64) -> String {
    format!("{}\u{a0}ms", significant(seconds * 1e3, 2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keeps_significant_digits() {
        for (value, text) in [
            (0.0, "0"),
            (1.0, "1"),
            (6.340_19, "6.34"),
            (59.999_96, "60"),
            (0.001_234_56, "0.001235"),
            (1.234_56e-7, "1.235e-7"),
            (1000.0, "1000"),
            (123_456.0, "123456"),
            (-2.5, "-2.5"),
            (1e30, "1e30"),
            (f64::INFINITY, "∞"),
        ] {
            assert_eq!(significant(value, 4), text);
        }
    }

    #[test]
    fn the_numbers_of_a_column_share_their_decimals() {
        for (values, texts) in [
            (&[3.16, 4.312, 158.0][..], &["3.16", "4.31", "158.00"][..]),
            (&[26.565_05, 6.0], &["26.57", "6.00"]),
            (&[0.0, 12.0], &["0.0", "12.0"]),
            (&[0.012_34, 1.5], &["0.0123", "1.5000"]),
            (&[1.234e-7, 0.5], &["1.23e-7", "0.5000"]),
            (&[150.0, 2e12], &["150", "2e12"]),
            (&[1.5, f64::INFINITY], &["1.50", "∞"]),
            (&[], &[]),
        ] {
            let column = Column::new(values.iter().copied(), 3);
            let written: Vec<_> = values.iter().map(|&value| column.number(value)).collect();
            assert_eq!(written, texts);
        }
    }

    #[test]
    fn rounds_no_share_to_nothing_or_all() {
        for (share, text) in [
            (0.0, "0%"),
            (1e-9, "<0.1%"),
            (0.001, "0.1%"),
            (0.1234, "12.3%"),
            (0.9699, "97.0%"),
            (0.07, "7%"),
            (0.999, "99.9%"),
            (0.99999, ">99.9%"),
            (1.0, "100%"),
            (7.526, "752.6%"),
        ] {
            assert_eq!(percent(share), text);
        }
    }

    #[test]
    fn groups_digits() {
        assert_eq!(
            [1000_u32, 10_000, 1_234_567].map(count),
            ["1000", "10\u{202f}000", "1\u{202f}234\u{202f}567"]
        );
    }
}
