//! How numbers and lists are written in sentences.

/// `value` with at most `digits >= 1` significant digits, and without trailing zeros.
///
/// ```
/// use mindeg_mesh::significant;
///
/// assert_eq!([6.340_19, 59.999_96, 1.234e-7].map(|v| significant(v, 3)), ["6.34", "60", "1.23e-7"]);
/// ```
#[must_use]
pub fn significant(value: f64, digits: usize) -> String {
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

/// The first `most` of some texts, and an ellipsis if there are more.
///
/// ```
/// use mindeg_mesh::listed;
///
/// let names = || ["a", "b", "c"].map(str::to_owned);
/// assert_eq!([listed(names(), 3, ", "), listed(names(), 2, ", ")], ["a, b, c", "a, b, …"]);
/// ```
#[must_use]
pub fn listed(texts: impl IntoIterator<Item = String>, most: usize, between: &str) -> String {
    let mut texts = texts.into_iter();
    let mut first: Vec<String> = texts.by_ref().take(most).collect();
    first.extend(texts.next().map(|_| "…".to_owned()));
    first.join(between)
}
