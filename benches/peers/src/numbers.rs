//! Numbers as they are printed, and the growth of times.

/// Three significant digits, thousands in groups.
pub(crate) fn significant(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    let rounded: f64 = format!("{value:.2e}").parse().unwrap_or(value);
    let decimals = (2 - rounded.abs().log10().floor() as i32).max(0) as usize;
    if decimals == 0 { grouped(rounded as u64) } else { format!("{rounded:.decimals$}") }
}

/// Thousands in groups.
pub(crate) fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let groups = digits.as_bytes().rchunks(3).rev();
    groups.map(String::from_utf8_lossy).collect::<Vec<_>>().join(",")
}

/// A time in the unit that suits it.
pub(crate) fn time(seconds: f64) -> String {
    let (scale, unit) = match seconds {
        _ if seconds < 1e-3 => (1e6, "µs"),
        _ if seconds < 1.0 => (1e3, "ms"),
        _ => (1.0, "s"),
    };
    format!("{} {unit}", significant(seconds * scale))
}

/// The least-squares p of y ∝ x^p; `None` for fewer than two points.
pub(crate) fn exponent(points: &[(f64, f64)]) -> Option<f64> {
    let count = points.len() as f64;
    let logs = || points.iter().map(|(x, y)| (x.ln(), y.ln()));
    let (x_mean, y_mean) = logs().fold((0.0, 0.0), |(a, b), (x, y)| (a + x / count, b + y / count));
    let covariance: f64 = logs().map(|(x, y)| (x - x_mean) * (y - y_mean)).sum();
    let variance: f64 = logs().map(|(x, _)| (x - x_mean) * (x - x_mean)).sum();
    (points.len() > 1).then(|| covariance / variance)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_rounded_and_grouped() {
        for (value, expected) in [
            (0.0, "0"),
            (0.000_012_345, "0.0000123"),
            (0.099_96, "0.100"),
            (1.0, "1.00"),
            (9.999, "10.0"),
            (99.96, "100"),
            (999.6, "1,000"),
            (1_234_567.0, "1,230,000"),
        ] {
            assert_eq!(significant(value), expected, "{value}");
        }
    }

    #[test]
    fn times_have_the_unit_that_suits_them() {
        for (seconds, expected) in
            [(5.18e-7, "0.518 µs"), (2.5e-5, "25.0 µs"), (0.0123, "12.3 ms"), (59.94, "59.9 s")]
        {
            assert_eq!(time(seconds), expected);
        }
    }

    #[test]
    fn exponents_of_powers_are_found() {
        for (points, expected) in [
            (&[(2.0, 12.0), (3.0, 27.0), (10.0, 300.0)][..], Some(2.0)),
            (&[(1.0, 5.0), (100.0, 5.0)], Some(0.0)),
            // The outer two make it 1; the middle one weighs nothing, wherever it lies.
            (&[(1.0, 1.0), (10.0, 100.0), (100.0, 100.0)], Some(1.0)),
            (&[(1.0, 1.0)], None),
            (&[], None),
        ] {
            let found = exponent(points);
            assert_eq!(found.map(|p| (p * 1e12).round() / 1e12), expected, "{points:?}");
        }
    }
}
