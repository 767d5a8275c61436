//! How numbers are written for people.
//!
//! Limits: one language, and a point as the decimal mark.

/// `value` with at most `digits >= 1` significant digits, and without trailing zeros.
pub(crate) fn significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return if value > 0.0 { "∞".into() } else { "–".into() };
    }
    let scientific = format!("{value:.*e}", digits - 1);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let power: i32 = exponent.parse().unwrap_or(0);
    let trimmed = |text: &str| match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text.to_owned(),
    };
    if (-5..9).contains(&power) {
        let decimals = (digits as i32 - 1 - power).max(0) as usize;
        trimmed(&format!("{value:.decimals$}"))
    } else {
        format!("{}e{power}", trimmed(mantissa))
    }
}

/// An angle in degrees.
pub(crate) fn angle(degrees: f64) -> String {
    format!("{}°", significant(degrees, 4))
}

/// An angle in degrees among others of the same size, to three decimals; one too small for them
/// as [`angle`] has it.
pub(crate) fn steady_angle(degrees: f64) -> String {
    if degrees < 0.1 { angle(degrees) } else { format!("{degrees:.3}°") }
}

/// A share of 0 to 1 in percent; what is more than nothing and less than all stays so.
pub(crate) fn percent(share: f64) -> String {
    match share * 100.0 {
        0.0 => "0%".into(),
        percent if percent < 0.1 => "<0.1%".into(),
        percent if percent > 99.9 && percent < 100.0 => ">99.9%".into(),
        percent => format!("{}%", significant(percent, 3)),
    }
}

/// A whole number, with narrow spaces between groups of three digits from five digits up.
pub(crate) fn count(value: impl Into<u64>) -> String {
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

/// A duration.
pub(crate) fn seconds(seconds: f64) -> String {
    match seconds {
        s if s < 1e-3 => format!("{} µs", significant(s * 1e6, 2)),
        s if s < 1.0 => format!("{} ms", significant(s * 1e3, 2)),
        s => format!("{} s", significant(s, 3)),
    }
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
    fn angles_side_by_side_have_three_decimals() {
        assert_eq!([6.34, 26.565_05, 0.1].map(steady_angle), ["6.340°", "26.565°", "0.100°"]);
        assert_eq!([0.084_71, 1e-7].map(steady_angle), ["0.08471°", "1e-7°"]);
    }

    #[test]
    fn rounds_no_share_to_nothing_or_all() {
        for (share, text) in
            [(0.0, "0%"), (1e-9, "<0.1%"), (0.1234, "12.3%"), (0.99999, ">99.9%"), (1.0, "100%")]
        {
            assert_eq!(percent(share), text);
        }
    }

    #[test]
    fn groups_digits_and_scales_times() {
        assert_eq!(
            [1000_u32, 10_000, 1_234_567].map(count),
            ["1000", "10\u{202f}000", "1\u{202f}234\u{202f}567"]
        );
        assert_eq!([2.34e-6, 0.0123, 1.5, 60.0].map(seconds), ["2.3 µs", "12 ms", "1.5 s", "60 s"]);
    }
}
